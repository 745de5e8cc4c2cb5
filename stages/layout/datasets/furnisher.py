"""Floor plans furnished by rule and search, the way people do.

`homes(root)` furnishes every plan artifact (`*.json`) below a folder.
"""

import json
import os
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np
from numpy.random import Generator

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.stages import use
from apartgen.stages.layout.batch import spreading
from apartgen.stages.layout.datasets import _json
from apartgen.stages.layout.datasets._furnish import build, household, shape
from apartgen.stages.layout.datasets._furnish.household import Household
from apartgen.stages.layout.datasets._furnish.shape import Hole, Shape
from apartgen.stages.space import polygons
from apartgen.stages.space.boxes import Array

MANY = 16
"""Plans that are worth processes of their own."""
TRIES, MINDED = 4, 0.3
"""How often a room is furnished at most, and what its faults may weigh."""


def homes(root: Path | None, seed: int = 0, times: int = 1) -> Iterator[Layout]:
    """Every plan below `root` in name order, furnished `times` times, on all cores; BadInput for what is no plan."""
    yield from each(root, "furnisher", partial(_furnished, seed=seed, times=times))


def each(root: Path | None, source: str, furnished: Callable[[Path], list[Layout]]) -> Iterator[Layout]:
    """What becomes of every plan below `root`, in name order, on all cores; BadInput where there is none."""
    paths = sorted(root.rglob("*.json")) if root is not None else []
    if not paths:
        raise BadInput(f"{source}: {root} holds no plan artifact (*.json); make some with `apartgen plan`")
    with spreading((os.cpu_count() or 1) if len(paths) > MANY else 1) as spread:
        for some in spread(furnished, paths):
            yield from some


def _furnished(path: Path, seed: int, times: int) -> list[Layout]:
    """One plan, furnished so many times."""
    plan = read(path)
    return [Layout(**dict(plan), objects=furnish(plan, rng))
            for rng in np.random.default_rng([seed, *path.name.encode()]).spawn(times)]


def read(path: Path) -> Plan:
    """A plan artifact, or its body; BadInput for anything else."""
    try:
        whole = json.loads(path.read_text())
        return Plan.model_validate(whole.get("body", whole))
    except (OSError, ValueError, AttributeError) as error:
        raise BadInput(f"{path}: not a plan ({_json.fault(error)})") from error


def furnish(plan: Plan, rng: Generator) -> list[Box]:
    """Objects for every room of a plan, at most as many as `program.counts` says; somewhere a table."""
    return [box for room, _ in furnished(plan, rng) for box in room]


def furnished(plan: Plan, rng: Generator) -> Iterator[tuple[list[Box], list[str]]]:
    """Every room's objects, and for each by what it was placed: `wall k` (side k of the polygon, after collinear
    corners are left out), `free`, or an object's id."""
    for room, lane in zip(plan.rooms, rng.spawn(len(plan.rooms)), strict=True):
        home = household.of_room(plan, room, lane)
        yield _tried(plan, room, lane, home)


def _tried(plan: Plan, room: Room, rng: Generator, home: Household) -> tuple[list[Box], list[str]]:
    """A room as `furnish_room` has it, begun anew while people would mind what became of it: the least minded."""
    shape, count = shape_of(plan, room), plan.program.counts.get(room.id)
    best: tuple[list[Box], list[str]] = ([], [])
    least = np.inf
    for _ in range(TRIES):
        found = furnish_room(shape, room.id, rng, home, count)
        minded = sum(use.weights()[fault.name] for fault in use.faults(use.of_plan(plan, room.id, found[0])))
        if minded < least:
            best, least = found, minded
        if minded < MINDED:
            break
    return best


def furnish_room(
    room: Shape, id: str, rng: Generator, home: Household, count: int | None = None
) -> tuple[list[Box], list[str]]:
    """Objects for one room, at most `count` where it is given, and by what each was placed."""
    placed, seen, objects = build.furnish(room, rng, home, count).placed, dict[str, int](), []
    for name, row in zip(placed.name, placed.row, strict=True):
        seen[name] = seen.get(name, 0) + 1
        x, y, z, d, w, h = (round(float(v), 4) for v in row[:6])
        yaw = round(float(np.arctan2(row[7], row[6])), 4)
        objects.append(
            Box(id=f"{id}.{name}_{seen[name]}", room=id, category=name, center=(x, y, z), size=(d, w, h), yaw=yaw)
        )
    return objects, [objects[at].id if isinstance(at, int) else at for at in placed.at]


def shape_of(plan: Plan, room: Room) -> Shape:
    """The room's shape with its openings moved onto its own walls."""
    corners = np.array(room.polygon)
    holes = [_hole(o, plan, room, corners) for o in plan.openings if room.id in o.rooms]
    return shape.of(room.base, corners, holes, plan.height)


def _hole(opening: Opening, plan: Plan, room: Room, corners: Array) -> Hole:
    normal, reach = polygons.face(opening, plan, room.id)
    (ax, ay), (bx, by) = (tuple(np.asarray(p) + reach * normal) for p in opening.segment)
    return Hole((ax, ay), (bx, by), opening.kind, opening.into == room.id, opening.hinge, opening.sill, opening.head)
