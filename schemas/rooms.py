"""Types of room: those that always exist, and those that packages bring, each like one of the former.

The data is `rooms.toml`, to which packages add by the entry points `apartgen.rooms`.
"""

import logging
import re
import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from apartgen.schemas import plugins
from apartgen.schemas.base import ROOM_TYPES, RoomType
from apartgen.schemas.errors import BadInput

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
    objects: dict[str, int] = Field(default_factory=dict)
    keeps: dict[str, int] = Field(default_factory=dict)


_CHECKED = TypeAdapter(RoomKind)


@cache
def kinds() -> dict[str, RoomKind]:
    """Every type by name, those that always exist first; a package's faulty ones are left out with a warning."""
    own = tomllib.loads((Path(__file__).parent / "rooms.toml").read_text(encoding="utf-8"))
    found: dict[str, RoomKind] = {}
    for name in ROOM_TYPES:
        found[name] = _kind(name, own.pop(name), found)
    found |= {name: _kind(name, row, found) for name, row in own.items()}
    for plugin, rows in plugins.facts(GROUP):
        try:
            found |= {name: _kind(name, row, found) for name, row in rows.items()}
        except BadInput as error:
            log.warning("%s", plugin.told(f"{error}; its types of room are left out"))
    return found


def _kind(name: str, row: Any, known: dict[str, RoomKind]) -> RoomKind:
    if name in known or not _NAME.fullmatch(name):
        raise BadInput(f"[{name}] is {'there already' if name in known else 'no name of small letters'}; change it")
    like = str(row.get("like", "")) if isinstance(row, dict) else ""
    if name not in ROOM_TYPES and like not in known:
        raise BadInput(f"[{name}] needs like = \"…\", a type of room that is there; there are: {', '.join(known)}")
    model = known.get(like)
    taken = {"keeps": model.keeps, "objects": model.objects, "free": model.free} if model else {}
    try:
        return _CHECKED.validate_python(taken | row | {"name": name, "base": model.base if model else name})
    except ValidationError as error:
        fault = error.errors(include_url=False)[0]
        raise BadInput(f"[{name}] {'.'.join(map(str, fault['loc']))}: {fault['msg'].lower()}") from None


def base_of(type: str) -> RoomType | None:
    """The type that always exists behind a type; None for one that nobody knows."""
    known = kinds().get(type)
    return known.base if known else None
