"""ReSpace's scene format (SSR): one JSON object or line a room, y up, objects told by descriptions.

`bounds_bottom` is the floor's outline; an object's `pos` is the middle of its underside, `size` is [x, y, z] before
turning, `rot` a quaternion [x, y, z, w]; its front is +z.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages.layout.datasets import _frames, _json, _words


def homes(root: Path | None) -> Iterator[Layout]:
    """Every room below `root` (a file or folder of .json, .jsonl, .jsonl.gz) of a type that we have."""
    for path in _json.files(root, "ssr", "rooms in ReSpace's format"):
        for number, row in enumerate(_json.rows(path), 1):
            try:
                found = layout(row.get("scene", row))
            except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
                raise BadInput(f"{path}, row {number}: not an SSR room ({_json.fault(error)})") from error
            if found is not None:
                yield found


def layout(scene: dict[str, Any]) -> Layout | None:
    """One room; None for a type of room that we do not have. Objects that are no furniture are left out."""
    type = _words.room_type(str(scene.get("room_id", "")).split("-")[0]) or _words.room_type(scene["room_type"])
    if type is None:
        return None
    room = _frames.room(type, 1, [(x, -z) for x, _, z in scene["bounds_bottom"]])
    height = scene["bounds_top"][0][1] - scene["bounds_bottom"][0][1]
    base = scene["bounds_bottom"][0][1]
    objects = []
    for k, thing in enumerate(scene["objects"], 1):
        (x, y, z), (w, h, d) = thing["pos"], thing["size"]
        name = _words.category(thing["desc"])
        if name is None or min(w, h, d) <= 0.002:
            continue
        name = _words.by_size(name, (d, w, h))
        center = (x, -z, y - base + h / 2)
        objects.append(_frames.box(f"{room.id}.{name}_{k}", room.id, name, center, (d, w, h), _yaw(thing["rot"])))
    return _frames.home([room], [], objects, height)


def _yaw(quaternion: list[float]) -> float:
    """Where +z points after a turn about y, in our plan."""
    _, y, _, w = quaternion
    return float(2 * np.arctan2(y, w) - np.pi / 2)
