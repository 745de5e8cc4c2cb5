"""Types of room: those that always exist, and those that packages bring, each like one of the former.

The data is `rooms.toml`, to which packages add by the entry points `apartgen.rooms`.
"""

import logging
import re
import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Annotated, Any

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from apartgen.schemas import facts, plugins
from apartgen.schemas.base import ROOM_TYPES, RoomType
from apartgen.schemas.errors import BadInput, near

log = logging.getLogger("apartgen")
GROUP = "apartgen.rooms"
_NAME = re.compile(r"[a-z][a-z_]*")


@dataclass(frozen=True, kw_only=True)
class RoomKind:
    """One type of room; `rooms.toml` says what each fact is. `base` is the type that always exists behind it."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    name: str
    base: RoomType
    like: str = ""
    words: tuple[str, ...] = ()
    area: float | None = Field(None, gt=0, le=1000)
    free: float = Field(0.65, ge=0, le=1)
    objects: dict[str, Annotated[int, Field(ge=0)]] = Field(default_factory=dict)
    keeps: dict[str, Annotated[int, Field(ge=0)]] = Field(default_factory=dict)


_CHECKED = TypeAdapter(RoomKind)


def kinds() -> dict[str, RoomKind]:
    """Every type by name, those that always exist first; a package's faulty ones are left out with a warning."""
    return _all()[0]


def told(type: str, fault: str) -> str:
    """A fault of a type's facts in words that say whose they are."""
    plugin = _all()[1].get(type)
    return plugin.told(f"[{type}] {fault}") if plugin else f"rooms.toml: [{type}] {fault}"


@cache
def _all() -> tuple[dict[str, RoomKind], dict[str, plugins.Plugin]]:
    """Every type by name, and who brings those that don't always exist."""
    brought: dict[str, plugins.Plugin] = {}
    own = tomllib.loads((Path(__file__).parent / "rooms.toml").read_text(encoding="utf-8"))
    found: dict[str, RoomKind] = {}
    for name in ROOM_TYPES:
        found[name] = _kind(name, own.pop(name), found)
    found |= _kinds(own, found)
    for plugin, rows in plugins.facts(GROUP):
        try:
            found |= _kinds(rows, found)
            brought |= dict.fromkeys(rows, plugin)
        except BadInput as error:
            log.warning("%s", plugin.told(f"{error}; its types of room are left out"))
    return found, brought


def _kinds(rows: dict[str, Any], known: dict[str, RoomKind]) -> dict[str, RoomKind]:
    """Types of room by name, each after the one that it is like, in whatever order they are written."""
    found: dict[str, RoomKind] = {}
    waiting = dict(rows)
    while waiting:
        name = next((name for name, row in waiting.items() if _model(row) not in waiting), next(iter(waiting)))
        found[name] = _kind(name, waiting.pop(name), known | found)
    return {name: found[name] for name in rows}


def _model(row: Any) -> str:
    return str(row.get("like", "")) if isinstance(row, dict) else ""


def _kind(name: str, row: Any, known: dict[str, RoomKind]) -> RoomKind:
    if name in known or not _NAME.fullmatch(name):
        raise BadInput(f"[{name}] is {'there already' if name in known else 'no name of small letters'}; change it")
    like = _model(row)
    if name not in ROOM_TYPES and like not in known:
        asked = f"like: {like!r} is no type of room" if like else 'needs like = "…", a type of room that is there'
        raise BadInput(f"[{name}] {asked}; {near(like, known)}")
    model = known.get(like)
    taken = {"keeps": model.keeps, "objects": model.objects, "free": model.free} if model else {}
    try:
        return _CHECKED.validate_python(taken | row | {"name": name, "base": model.base if model else name})
    except ValidationError as error:
        known_facts = [fact for fact in RoomKind.__dataclass_fields__ if fact not in ("name", "base")]
        raise BadInput(f"[{name}] {facts.fault(error, known_facts)}") from None


def base_of(type: str) -> RoomType | None:
    """The type that always exists behind a type; None for one that nobody knows."""
    known = kinds().get(type)
    return known.base if known else None
