"""Older artifacts brought up to date: one small function a version, in order, never edited after release.

Each takes a file's whole JSON of one version and returns it as the next version has it. Files of every old
version are kept among the tests.
"""

from collections.abc import Callable
from typing import Any

from apartgen.schemas.carrying import Body, carriers
from apartgen.schemas.errors import BadInput

Migration = Callable[[dict[str, Any]], dict[str, Any]]

_PLACES = {
    "ceiling_lamp": "ceiling", "curtain": "wall", "hood": "wall", "microwave": "top", "mirror": "wall",
    "monitor": "top", "radiator": "wall", "rug": "flat", "table_lamp": "top", "towel_rail": "wall", "tv": "top",
    "wall_lamp": "wall", "wall_shelf": "wall", "wall_unit": "wall", "water_heater": "wall",
}
"""Where the categories of version 1 belong that do not belong on the floor."""


def _carried(raw: dict[str, Any]) -> dict[str, Any]:
    """To 2: what carries each object is said. What is no object is left for the types to complain of."""
    body: Any = raw.get("body")
    try:
        objects = body["objects"]
        bodies = [Body(o["id"], o["room"], _PLACES.get(o["category"], "floor"), o["center"], o["size"], o["yaw"])
                  for o in objects]
        found = carriers(bodies, body.get("height", 2.6))
    except (LookupError, TypeError, AttributeError, ValueError, ArithmeticError):
        return raw
    return raw | {"body": body | {"objects": [o | {"on": on} for o, on in zip(objects, found, strict=True)]}}


MIGRATIONS: tuple[Migration, ...] = (_carried,)
"""`MIGRATIONS[n - 1]` leads from version n to version n + 1."""
VERSION = 1 + len(MIGRATIONS)
"""The version that is written."""


def migrate(raw: dict[str, Any], name: str, steps: tuple[Migration, ...] = MIGRATIONS) -> dict[str, Any]:
    """An artifact's JSON in the newest version; `name` is where it came from.

    Raises BadInput for a version newer than the newest known, naming both.
    """
    version, newest = raw.get("version"), 1 + len(steps)
    if not isinstance(version, int) or isinstance(version, bool) or version < 1:
        raise BadInput(f"{name}: version: a whole number from 1 to {newest} is needed, found {str(version)[:40]!r}")
    if version > newest:
        raise BadInput(f"{name}: version {version} is newer than version {newest}, the newest that this apartgen "
                       "reads; install a newer apartgen")
    for step in steps[version - 1 :]:
        raw = step(raw) | {"version": raw["version"] + 1}
    return raw
