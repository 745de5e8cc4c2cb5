"""What a registry's members must offer: the protocols in the folder's file `_protocol.py`, and whether a module has it.

A member keeps at least one protocol of its folder, and every one of which it has a function.
"""

import importlib
import importlib.util
import inspect
import traceback
from collections.abc import Callable, Iterator
from functools import cache, wraps
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Annotated, Any, get_args, get_origin, get_type_hints

from apartgen.schemas.errors import ApartgenError, BadInput

ANYTHING = (Exception, SystemExit)
"""What a stranger's code may raise; who presses Ctrl-C still ends the command."""
Told = Callable[[str], str]
"""A fault in words that say whose it is."""


@cache
def protocols(package: str) -> tuple[type, ...]:
    """The protocols of a folder, none where it has no `_protocol.py`."""
    name = f"{package}._protocol"
    if importlib.util.find_spec(name) is None:
        return ()
    module = importlib.import_module(name)
    return tuple(value for value in vars(module).values()
                 if getattr(value, "_is_protocol", False) and value.__module__ == name)


def functions(protocol: type) -> dict[str, FunctionType]:
    """The functions that a protocol asks for."""
    return {name: value for name, value in vars(protocol).items()
            if isinstance(value, FunctionType) and not name.startswith("_")}


def fault(member: ModuleType, asked: tuple[type, ...]) -> str:
    """What a member lacks, in words; empty where it keeps its contract."""
    begun = [protocol for protocol in asked if any(hasattr(member, name) for name in functions(protocol))]
    if asked and not begun:
        calls = [_written(function) for protocol in asked for function in functions(protocol).values()]
        return f"has no {' or '.join(calls)}"
    return next((lack for protocol in begun for lack in _lacks(member, protocol)), "")


def _written(function: FunctionType) -> str:
    return f"{function.__name__}({', '.join(_arguments(function, skip=1))})"


def _arguments(function: Callable[..., Any], skip: int = 0) -> list[str]:
    return list(inspect.signature(function).parameters)[skip:]


def _lacks(member: ModuleType, protocol: type) -> Iterator[str]:
    for name, hint in get_type_hints(protocol, include_extras=True).items():
        kind, *advice = get_args(hint) if get_origin(hint) is Annotated else (hint,)
        value = getattr(member, name, None)
        if value is None or (get_origin(kind) is type and not _is_one(value, get_args(kind)[0])):
            yield "; ".join([f"has no {name} that will do" if value is not None else f"has no {name}", *advice])
    for name, wanted in functions(protocol).items():
        found = getattr(member, name, None)
        if not callable(found):
            yield f"has no {_written(wanted)}"
        elif (arguments := _arguments(wanted, skip=1)) != _arguments(found)[: len(arguments)]:
            yield f"has {name}({', '.join(_arguments(found))}) where {_written(wanted)} is called"


def _is_one(value: Any, of: type) -> bool:
    return isinstance(value, type) and issubclass(value, of)


def guarded(member: ModuleType, kept: tuple[type, ...], told: Told) -> ModuleType:
    """The member of another package; whatever goes wrong in its functions is a BadInput that says whose it is."""
    guard, home = ModuleType(member.__name__, member.__doc__), str(Path(getattr(member, "__file__", None) or "").parent)
    vars(guard).update(vars(member))
    for protocol in kept:
        for name, wanted in functions(protocol).items():
            if hasattr(member, name):
                setattr(guard, name, _guarded(getattr(member, name), get_type_hints(wanted).get("return"), told, home))
    return guard


class _Gave(Exception):
    """What a function gave in place of what it is to give, in words."""


def _guarded(function: Callable[..., Any], hint: Any, told: Told, home: str) -> Callable[..., Any]:
    def failed(error: BaseException) -> BadInput:
        fault = str(error) if isinstance(error, _Gave) else f"failed, {at(error, home)}"
        return BadInput(told(f"{function.__name__} {fault}"))

    def items(result: Iterator[Any]) -> Iterator[Any]:
        try:
            for item in result:
                _expected(item, get_args(hint)[0])
                yield item
        except ApartgenError:
            raise
        except ANYTHING as error:
            raise failed(error) from error

    @wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        try:
            result = function(*args, **options)
            if get_origin(hint) is Iterator:
                return items(iter(result))
            _expected(result, hint)
            return result
        except ApartgenError:
            raise
        except ANYTHING as error:  # a stranger's function may do anything
            raise failed(error) from error

    return call


def unfit(value: Any, hint: Any) -> str:
    """What a value is in place of a type, or of a list of one, in words; empty for one that is of it."""
    many = get_origin(hint) is list
    of = get_args(hint)[0] if many else get_origin(hint) or hint
    if of is float and type(value) is int:
        return ""  # a number is a number
    if not isinstance(value, list if many else of):
        gave = "nothing" if value is None else f"a {type(value).__name__}"
        return f"gave {gave}, not a {'list of ' * many}{of.__name__}"
    strange = [type(item).__name__ for item in value if not isinstance(item, of)] if many else []
    return f"gave a list with a {strange[0]}, not of {of.__name__}" if strange else ""


def _expected(value: Any, hint: Any) -> None:
    """_Gave for a value that is not of a type, or of a list of one."""
    if said := unfit(value, hint):
        raise _Gave(said)


def told(error: BaseException) -> str:
    """An exception in one line."""
    from pydantic import ValidationError  # no part of what lists a registry

    from apartgen.schemas import facts

    if isinstance(error, ValidationError):
        return f"{error.title}.{facts.fault(error, ())}"
    return f"{type(error).__name__}: {' '.join(str(error).split()) or 'no reason given'}"


def at(error: BaseException, home: str = "") -> str:
    """The same with the line that raised it, the last below the folder `home` where any is."""
    frames = traceback.extract_tb(error.__traceback__)
    last = ([frame for frame in frames if home not in ("", ".") and frame.filename.startswith(home)] or frames)[-1]
    return f"{told(error)} ({last.filename}:{last.lineno})"
