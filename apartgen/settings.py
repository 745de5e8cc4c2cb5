"""Settings of stages from plain values, and artifacts as the functions of the library hand them on."""

from collections.abc import Callable, Mapping
from os import PathLike
from pathlib import Path
from time import perf_counter
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from apartgen.planning import PlanSettings, checked, draw
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen.steps import Step, lane, made

Config = TypeVar("Config", bound=BaseModel)
Home = Artifact[Any] | str | PathLike[str]
"""An apartment: what an earlier function gave, or the path of its file."""


def configured(config: type[Config], values: Mapping[str, Any], shown: Callable[[str], str] = str) -> Config:
    """The configuration from its defaults and these values; BadInput names an unknown or unfit one by `shown(field)`.

    Of a field that maps names to values, what is given changes those names and leaves the others.
    """
    known(config, values)
    merged = {field: default(config, field) | value if isinstance(value, dict) and maps(config, field) else value
              for field, value in values.items()}
    try:
        return config.model_validate(merged)
    except ValidationError as error:
        raise BadInput(_first_fault(error, merged, shown)) from None


def maps(config: type[BaseModel], field: str) -> bool:
    """Whether a field gives values to names."""
    return isinstance(default(config, field), dict)


def default(config: type[BaseModel], field: str) -> Any:
    """What a field is when it is not set."""
    return config.model_fields[field].get_default(call_default_factory=True, validated_data={})


def known(config: type[BaseModel], values: Mapping[str, Any]) -> None:
    """BadInput for the first setting that there is none of."""
    for field, value in values.items():
        if field not in config.model_fields:
            raise BadInput(f"setting {field!r} is unknown; there are: {', '.join(config.model_fields)}")
        inner = config.model_fields[field].annotation
        if isinstance(value, dict) and isinstance(inner, type) and issubclass(inner, BaseModel):
            known(inner, value)


def _first_fault(error: ValidationError, values: Mapping[str, Any], shown: Callable[[str], str]) -> str:
    """The setting, its value and what is wrong with it; of settings that don't go together, what they say."""
    first = error.errors(include_url=False)[0]
    if not first["loc"]:
        return str(first["ctx"]["error"])
    field, *keys = map(str, first["loc"])
    value = values.get(field)
    given = f"{keys[0]}={value[keys[0]]}" if keys and isinstance(value, dict) and keys[0] in value else value
    return f"{shown(field)} {given}: {first['msg'][0].lower()}{first['msg'][1:]}"


def by_stage(settings: Mapping[str, Mapping[str, Any]], formats: list[str]) -> dict[str, Record]:
    """The settings of every stage of a whole run; later stages look up assets where retrieve took them."""
    from apartgen.whole import KINDS

    for word in settings:
        if word not in KINDS:
            raise BadInput(f"settings of {word!r} are unknown; there are: {', '.join(KINDS)}")
    libraries = {"libraries": settings.get("retrieve", {}).get("libraries", [])}
    given: dict[str, dict[str, Any]] = {"walkable": libraries, "populate": libraries,
                                        "export": libraries | {"format": formats}}
    return {word: configured(kind, given.get(word, {}) | dict(settings.get(word, {}))) for word, kind in KINDS.items()}


def opened(home: Home) -> Artifact[Any]:
    """An artifact itself, or the one in a file."""
    return home if isinstance(home, Artifact) else artifact.read(Path(home), Record, whole=True)


def planned(text: str, seed: int, settings: Mapping[str, Any]) -> Artifact[Plan]:
    """The plan for a sentence."""
    config, began = configured(PlanSettings, settings), perf_counter()
    drawn, used = draw(checked(text), config, seed)
    record = made("plan", seed, config, seconds=perf_counter() - began).model_copy(update={"model": used})
    return artifact.settled(drawn, record)


def advanced(step: Step, home: Home, seed: int | None, settings: Mapping[str, Any]) -> Artifact[Any]:
    """The next artifact of one apartment."""
    config, began = configured(step.config, settings), perf_counter()
    read = opened(home)
    used, body = read.made.seed if seed is None else seed, step.taken(read).body
    outcome = next(iter(step.advance([body], config, [lane(used, step.word, read.body)])))
    if isinstance(outcome, ApartgenError):
        raise outcome
    if short := step.missed(outcome, config):
        raise short
    return artifact.settled(outcome, made(step.word, used, config, read, perf_counter() - began, step.data(config)))
