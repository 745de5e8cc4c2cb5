"""Episodes of vision-and-language navigation for Habitat (VLN-CE): ways through the home, and how they are told.

From a place in every room to a thing in every other, each told in three styles. The frame is Habitat's: y up, so that
the world's (x, y, z) is (x, z, -y); rotations are x, y, z, w and turn -z to where the way sets out.
"""

import gzip
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.stages.export import _told_ways as words
from apartgen.stages.export import habitat
from apartgen.stages.export._legs import Leg, Passed, along, legs, length, passed
from apartgen.stages.export._readback import Refused
from apartgen.stages.export._rotation import y_up
from apartgen.stages.robot import reach
from apartgen.stages.robot.way import before, shortest, spread_places
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.looking import first
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import HomeWorld, world
from apartgen.stages.space import grid, polygons
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.things import names
from apartgen.stages.things.categories import TABLE

FILE = "vln/apartment.json.gz"
SCENE = f"{habitat.FOLDER}/scenes/{habitat.NAME}.scene_instance.json"
DATASET = f"{habitat.FOLDER}/{habitat.NAME}.scene_dataset_config.json"
"""Where `--format habitat` writes the scene, from the folder of the export."""
SPACING = 0.5
"""Points of a reference path are no further apart, m."""
NEAR = 1.0
"""One has come to a goal within so much of it, m."""
EYE, FIELD, PITCH, COLUMNS, ROWS = 1.25, np.radians(90.0), np.radians(-10.0), 48, 36
"""The camera by which it is asked what one sees, m and rad."""
SEEN = 0.01
"""Share of the picture from which a thing is seen."""
BEFORE = 1.2
"""A thing is looked for so long before one passes it, m."""
SHORTEST = 1.5
"""Ways that are shorter are not asked for, m."""


def write(scene: Scene, out: Path) -> list[Path]:
    """vln/apartment.json.gz."""
    episodes = list(_episodes(scene))
    if not episodes:
        raise BadInput("format vln: no way from one room to a thing in another that words could tell; leave it out, "
                       "or give a furnished home of several rooms (layout, then retrieve)")
    path = out / FILE
    path.parent.mkdir()
    held = {"episodes": episodes, "instruction_vocab": {"word_list": words.vocabulary()}}
    data = json.dumps(held, separators=(",", ":")).encode()
    path.write_bytes(gzip.compress(data, mtime=0))
    return [path]


def read_back(files: list[Path]) -> None:
    """By the parsers of gzip and JSON."""
    held = json.loads(gzip.decompress(files[0].read_bytes()))
    most = len(held["instruction_vocab"]["word_list"])
    if any(max(episode["instruction"]["instruction_tokens"]) >= most for episode in held["episodes"]):
        raise Refused("an instruction has a word that is not in the vocabulary")


def _episodes(scene: Scene) -> Iterator[dict[str, Any]]:
    home, number = scene.home, 0
    if not isinstance(home, Layout):
        return
    looked_at = world(scene)
    for trajectory, (way, parts, goal) in enumerate(_ways(home, looked_at)):
        seen = [_landmarks(home, looked_at, leg, goal) for leg in parts]
        rooms = [_called(home, leg, there) for leg, there in zip([parts[0], *parts], (leg.room for leg in parts))]
        rooms[0] = f"the {_types(home)[parts[0].room]}"
        things = {o.id: f"the {names.spoken(o.category)}" for o in home.objects}
        told = {"rooms": [leg.room for leg in parts], "goal": goal.id,
                "openings": [leg.way_out.id for leg in parts if leg.way_out], "passed": [p.id for s in seen for p in s]}
        for style in words.STYLES:
            text = words.told(style, parts, rooms, seen, things, goal.id)
            yield _episode(number, trajectory, way, text, told)
            number += 1


def _episode(number: int, trajectory: int, way: Array, text: str, told: dict[str, Any]) -> dict[str, Any]:
    path = [[round(v, 4) + 0.0 for v in y_up(np.array([*p, 0.0]))] for p in along(way, SPACING)]
    ahead = way[1] - way[0]
    half = float(np.arctan2(-ahead[0], ahead[1])) / 2  # from +y, which is Habitat's -z, about the vertical
    return {
        "episode_id": number, "trajectory_id": trajectory, "scene_id": SCENE, "scene_dataset_config": DATASET,
        "start_position": path[0], "start_rotation": [0.0, round(np.sin(half), 6), 0.0, round(np.cos(half), 6)],
        "goals": [{"position": path[-1], "radius": NEAR}], "reference_path": path,
        "instruction": {"instruction_text": text, "instruction_tokens": words.numbers(text)},
        "info": {"geodesic_distance": round(length(way), 4), **told},
    }  # fmt: skip


def _ways(home: Layout, looked_at: HomeWorld) -> Iterator[tuple[Array, list[Leg], Box]]:
    """Ways that can be told, from the middle of every room to things of every other in turn."""
    space = reach.space(home)
    free = reach.free(space, home.objects)
    cells = grid.from_seeds(free, space.entry & free)
    middles = [spread_places(space, cells, k, 1) for k in range(len(home.rooms))]
    starts = [k for k, middle in enumerate(middles) if len(middle)]
    for there, room in enumerate(home.rooms):
        inside = cells & (space.rooms == there)
        goals = [(o, place) for o in _goals(home, room.id) for place in _place(space, o, inside)]
        for k, here in enumerate([k for k in starts if k != there] if goals else ()):
            o, end = goals[k % len(goals)]
            way = shortest(space, cells, middles[here][0], end)
            if len(way) > 1 and length(way) >= SHORTEST and _shows(looked_at, end, np.array(o.center[:2]) - end, o.id):
                parts = legs(space, way)
                if _can_be_told(home, parts):
                    yield way, parts, o


def _goals(home: Layout, room: str) -> list[Box]:
    """Things of a room that only one can be meant by, that stand and that one stops before."""
    mine = [o for o in home.objects if o.room == room]
    return [o for o in _meant(mine) if TABLE[o.category].faces and "sleep" not in TABLE[o.category].uses]


def _meant(mine: Sequence[Box]) -> list[Box]:
    """Those of a room's things that can be spoken of in it."""
    meant = names.meanings(mine)
    return [o for o in mine if meant[o.category] == 1 and names.stands(o) and max(o.size) > names.LARGE
            and not names.hidden(o)]


def _place(space: reach.Space, o: Box, cells: Mask) -> list[Array]:
    """Where one stops in front of a thing: the place before it with most room about it; none where one gets to none."""
    from scipy import ndimage

    among = before(space, o, cells)
    if not among.any():
        return []
    clear = np.where(among, ndimage.distance_transform_edt(cells), -1.0)
    row, column = np.unravel_index(int(clear.argmax()), clear.shape)
    return [np.array([space.grid.x[column], space.grid.y[row]])]


def _types(home: Layout) -> dict[str, str]:
    return {room.id: names.type_of(room) for room in home.rooms}


def _can_be_told(home: Layout, parts: list[Leg]) -> bool:
    """Whether every way out lies on a side, and the room behind it has a name."""
    return all(words.side(leg.side) and _called(home, leg, there.room) for leg, there in zip(parts, parts[1:]))


def _called(home: Layout, leg: Leg, room: str) -> str:
    """What a room is called by somebody who goes there: by its type where no way leads to another of it, else by what
    only it has; nothing where neither tells it.
    """
    types = _types(home)
    ways = [o for o in home.openings if o.kind in polygons.PASSAGES and leg.room in o.rooms]
    near = {r for o in ways for r in o.rooms if r != leg.room} | {room}
    alone = sum(types[r] == types[room] for r in near) == 1
    return f"the {types[room]}" if alone else names.of_rooms(home).get(room, "")


def _landmarks(home: Layout, looked_at: HomeWorld, leg: Leg, goal: Box) -> list[Passed]:
    """What one passes closest by in a leg and sees before one does; one thing at most."""
    mine = [o for o in home.objects if o.room == leg.room]
    for one in passed(home, leg, [o.id for o in _meant(mine) if o.id != goal.id]):
        at = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(leg.points, axis=0), axis=1))])
        k = int(np.searchsorted(at, max(0.0, one.at - BEFORE)))
        ahead = leg.points[min(k + 8, len(leg.points) - 1)] - leg.points[k]
        if _shows(looked_at, leg.points[k], ahead, one.id):
            return [one]
    return []


def _shows(looked_at: HomeWorld, place: Array, ahead: Array, id: str) -> bool:
    """Whether one sees a thing from a place, looking that way."""
    yaw = float(np.arctan2(ahead[1], ahead[0]))
    eye = Camera.looking(np.array([*place, EYE]), yaw, PITCH, FIELD, COLUMNS, ROWS)
    triangles = first(looked_at, eye, np.arange(COLUMNS * ROWS), np.array([0.5, 0.5])).hits.triangle
    owners = looked_at.every.soup.owner[triangles[triangles >= 0]]
    return bool(sum(looked_at.bodies[k].id == id for k in owners.tolist()) > SEEN * COLUMNS * ROWS)
