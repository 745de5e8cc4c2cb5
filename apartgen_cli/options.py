"""A stage's configuration as command-line options: every plain field of its pydantic type is one option."""

import inspect
import tomllib
from collections.abc import Callable, Mapping
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

import typer
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from apartgen import settings
from apartgen.requests import LARGEST_SEED
from apartgen.schemas.errors import BadInput

Config = TypeVar("Config", bound=BaseModel)
Names = Mapping[str, str]
TABLES = ("plan", "layout", "retrieve", "walkable", "populate", "export", "metrics", "render", "qa", "train-layout",
          "train-shape")
"""What a settings file may hold: one for every command that has settings."""


def checked_seed(value: int | None) -> int | None:
    """A seed that every reader of JSON and of tables takes."""
    if value is not None and value > LARGEST_SEED:
        raise BadInput(f"--seed: at most {LARGEST_SEED}, which is 2^63 - 1")
    return value


OUT = Annotated[str | None, typer.Option("--out", "-o", help="A file, or with a slash at its end a folder.")]
SEED = Annotated[int | None, typer.Option(
    "--seed", min=0, callback=checked_seed, help="Fixes everything drawn; the input's seed by default.")]
CONFIG = Annotated[Path | None, typer.Option("--config", help="A TOML file with a table of settings for every stage.")]
TRUST = Annotated[bool, typer.Option("--trust", help="Take inputs that the judge refuses, too.")]
FAILURES = Annotated[Path | None, typer.Option(
    "--failures", metavar="FILE", help="Write a list of what could not be done.")]
RETRY = Annotated[Path | None, typer.Option(
    "--retry", metavar="FILE", help="Do what such a list holds; it then holds what is still left.")]
SPLIT = Annotated[str | None, typer.Option("--split", help="Only rooms of this part of a split data set (boxes).")]
SPLITS = Annotated[Path | None, typer.Option(
    "--splits", metavar="FILE", help="The CSV of ROOM,PART that says which rooms --split means.")]
INPUTS = Annotated[list[str] | None, typer.Argument(metavar="FILE", help="Artifacts; - or a pipe is standard input.")]


def with_options(
    function: Callable[..., Any], config: type[BaseModel], names: Names | None = None
) -> Callable[..., Any]:
    """`function(**own, given)` as a command that also has an option for every plain field of `config`.

    `names` gives fields another name on the command line. `given` gets the fields that were set.
    """
    fields = {field: (names or {}).get(field, field) for field, info in config.model_fields.items()
              if _plain(info.annotation) is not None}

    def run(**arguments: Any) -> Any:
        given = {field: arguments.pop(option) for field, option in fields.items()}
        return function(**arguments, given={field: value for field, value in given.items() if value not in (None, [])})

    own = [p for p in inspect.signature(function).parameters.values() if p.name != "given"]
    extra = [_parameter(option, config.model_fields[field]) for field, option in fields.items()]
    run.__signature__ = inspect.Signature([*own, *extra])  # type: ignore[attr-defined]
    run.__annotations__ = {p.name: p.annotation for p in (*own, *extra)}
    run.__doc__ = function.__doc__
    return run


def _parameter(option: str, info: FieldInfo) -> inspect.Parameter:
    kind = _plain(info.annotation)
    name = "--" + option.replace("_", "-")
    origin = get_origin(kind)
    if kind is bool:
        name = f"{name}/--no-{name[2:]}"
    help_ = _sentence(info.description or option.replace("_", " "))
    if origin is list and get_origin(get_args(kind)[0]) is Literal:
        help_, kind = f"{help_} Of {', '.join(get_args(get_args(kind)[0]))}.", list[str]
    if origin is dict:
        help_, kind = f"{help_} As NAME=VALUE, any number of times.", list[str]
    default = info.get_default(call_default_factory=True, validated_data={})
    shown = _shown(default)
    declared = typer.Option(name, help=f"{help_} [default: {shown}]" if shown else help_, show_default=False)
    return inspect.Parameter(option, inspect.Parameter.KEYWORD_ONLY, default=None,
                             annotation=Annotated[kind | None, declared])


def _shown(default: Any) -> str:
    """A default as one would write it on the command line."""
    if isinstance(default, dict):
        return ", ".join(f"{k}={v:g}" for k, v in default.items())
    if isinstance(default, bool):
        return "yes" if default else "no"
    return ", ".join(map(str, default)) if isinstance(default, list) else "" if default is None else str(default)


def _sentence(text: str) -> str:
    first = text[0].upper() if text[0].isascii() else text[0]
    return first + text[1:].rstrip(".") + "."


def _plain(annotation: Any) -> Any:
    """A field's type as the command line takes it, without None and constraints; None for what it cannot take."""
    if get_origin(annotation) is Annotated:
        return _plain(get_args(annotation)[0])
    if get_origin(annotation) in (Union, UnionType):
        return _plain(next(arg for arg in get_args(annotation) if arg is not NoneType))
    origin, parts = get_origin(annotation), get_args(annotation)
    if origin in (dict, Literal) or annotation in (int, float, bool, str):
        return annotation
    if origin is list and _plain(parts[0]) is not None and get_origin(parts[0]) is not list:
        return annotation
    return None


def configured(config: type[Config], given: Mapping[str, Any], table: Mapping[str, Any] | None = None,
               names: Names | None = None) -> Config:
    """The configuration from its defaults, a file's table and the options given; the later wins.

    Of a field that maps names to values, what is given changes those names and leaves the others.
    """
    values: dict[str, Any] = dict(table or {})
    settings.known(config, values)
    for field, value in given.items():
        start = values.get(field)
        named = settings.maps(config, field)
        values[field] = _pairs(field, value, start if isinstance(start, dict) else {}) if named else value
    return settings.configured(config, values, lambda field: "--" + (names or {}).get(field, field).replace("_", "-"))


def _pairs(field: str, rows: list[str], start: Mapping[str, Any]) -> dict[str, Any]:
    values = dict(start)
    for row in rows:
        name, sign, value = row.partition("=")
        try:
            values[name] = float(value)
        except ValueError:
            raise BadInput(f"--{field.replace('_', '-')} {row}: give NAME=VALUE, VALUE a number") from None
    return values


def tables(file: Path | None) -> dict[str, Any]:
    """The tables of a settings file, by stage; empty without one. BadInput for a table that no command reads."""
    if file is None:
        return {}
    try:
        found = tomllib.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise BadInput(f"{file}: cannot be read ({error.strerror}); check the path") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise BadInput(f"{file}: not TOML: {error}") from None
    for name, table in found.items():
        if name not in TABLES:
            raise BadInput(f"{file}: table [{name}] is unknown; there are: {', '.join(TABLES)}")
        if not isinstance(table, dict):
            raise BadInput(f"{file}: {name} is no table; settings of {name} stand below [{name}]")
    return found
