"""The corpus file that training reads: one row a room, padded arrays in the room's own frame."""

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Room
from apartgen.stages.layout.datasets._furnish.rooms import ESSENTIAL
from apartgen.stages.layout.rooms import MAX_CORNERS, of_plan
from apartgen.stages.things.categories import CATEGORIES, TABLE, stand_in
from apartgen.stages.use.household import duties, sleepers

SLOTS = 24
STYLES = 8
FORMAT = {
    "category": np.int16, "center": np.float32, "size": np.float32, "yaw": np.float32, "polygon": np.float32,
    "room_type": np.int8, "height": np.float32, "openings": np.float32, "style": np.int16, "source": np.int8,
    "sleepers": np.int8, "duties": np.int8,
}
KEEP = {"floor": 0, "wall": 1, "top": 2, "flat": 3, "ceiling": 3}
"""What goes first, the highest number, where a room holds more than its slots."""


def rows(home: Layout, rng: np.random.Generator, source: int = 0) -> dict[str, NDArray[np.generic]]:
    """One row for every furnished room of a home: category (n, 24) -1 where empty, center, size (n, 24, 3), yaw
    (n, 24), polygon (n, 32, 2), openings (n, 20, 7), room_type, height, style, source, sleepers in the home or -1 (n,),
    duties (n, 4) of the room. Order of objects random."""
    rooms = of_plan(home)
    n = len(rooms)
    category = np.full((n, SLOTS), -1)
    pose = np.zeros((n, SLOTS, 7))
    for i, room in enumerate(home.rooms):
        objects = _kept([o for o in home.objects if o.room == room.id], rng)
        for k, o in enumerate(objects):
            x, y = rooms.origin[i]
            category[i, k] = CATEGORIES.index(stand_in(o.category) or o.category)
            pose[i, k] = [o.center[0] - x, o.center[1] - y, o.center[2], *o.size, (o.yaw + np.pi) % (2 * np.pi) - np.pi]
    data = {
        "category": category, "center": pose[..., :3], "size": pose[..., 3:6], "yaw": pose[..., 6],
        "polygon": rooms.polygon, "room_type": rooms.type, "height": rooms.height, "openings": rooms.openings,
        "style": rng.integers(0, STYLES, n), "source": np.full(n, source),
        "sleepers": np.full(n, -1 if (people := sleepers(home)) is None else people),
        "duties": np.array([duties(home, room) for room in home.rooms]).reshape(n, 4),
    }
    some = np.array([_worth(room, home.objects) for room in home.rooms], bool)
    return {name: np.asarray(data[name], kind)[some] for name, kind in FORMAT.items()}


def _worth(room: Room, objects: list[Box]) -> bool:
    """Whether a room is furnished and has what a room of its type cannot do without."""
    have = {o.category for o in objects if o.room == room.id}
    return bool(have) and len(room.polygon) <= MAX_CORNERS and all(have & names for names in ESSENTIAL[room.base])


def _kept(objects: list[Box], rng: np.random.Generator) -> list[Box]:
    """At most `SLOTS` objects in random order, the smallest and least needed dropped."""
    known = [o for o in objects if o.category in TABLE]
    ranked = sorted(known, key=lambda o: (KEEP[TABLE[o.category].place], -float(np.prod(o.size))))[:SLOTS]
    return [ranked[k] for k in rng.permutation(len(ranked))]


def write_corpus(path: Path, homes: Iterable[tuple[Layout, int]], seed: int = 0) -> int:
    """Write homes, each with the number of its source, as one compressed `.npz`; how many rooms it holds.

    BadInput where no room is worth it, or where the file cannot be written.
    """
    rng = np.random.default_rng(seed)
    parts = [rows(home, rng, source) for home, source in homes]
    if not any(len(part["category"]) for part in parts):
        raise BadInput(f"none of the {len(parts)} homes read has a room to train on, one that holds what a room of its "
                       "type cannot do without, such as a bedroom's bed; give other sources")
    whole = {name: np.concatenate([part[name] for part in parts]) for name in FORMAT}
    temporary = path.with_suffix(".part.npz")
    try:
        np.savez_compressed(temporary, categories=np.array(CATEGORIES), **whole)  # type: ignore[arg-type]
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise BadInput(f"{path}: cannot be written ({error.strerror or error}); give another path with -o") from None
    return len(whole["category"])
