"""What a round robot gets to: from the entrance, through every door, to in front of all that opens.

The robot is a disc. It can be where its disc meets neither wall nor furniture; it uses an object from in front of
it, its centre within `reach` of the face that opens, first with the parts closed and then with them open, and opens
each part from where its arm gets to the handle.
"""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from shapely import unary_union

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.robot import handling
from apartgen.stages.space import boxes, footprints, grid, polygons, sweeps
from apartgen.stages.space.boxes import Boxes, Mask
from apartgen.stages.space.grid import Grid

RADIUS = 0.25
"""Default radius of the robot, m."""
REACH = 0.80
"""Default greatest distance from the robot's centre to the front of what it uses, m."""
HEIGHT = 1.5
"""The robot passes under what hangs above this, m."""
POCKET = 0.8
"""A room is reached when no more than this of where the robot's centre could be in it is cut off, m²."""
LEVER = 0.05
"""How far the levers of doors stand out, m."""
_AROUND = 6  # cells about shut ones within which another way round is looked for
_STEP_IN = 0.15  # how far inside a room the robot's centre must get for the door to count as passed, m


@dataclass(frozen=True)
class Space:
    """An empty plan as a robot sees it, on a raster.

    `open` holds where the robot's centre may be without furniture, `rooms` the index of the room (-1 in walls),
    `entry` where it comes in, `doors` by opening id the cells of (threshold, first side, second side), of an entrance
    those inside.
    """

    plan: Plan
    radius: float
    grid: Grid
    open: Mask
    rooms: NDArray[np.int16]
    entry: Mask
    doors: dict[str, list[Mask]]


@dataclass(frozen=True)
class Reached:
    """What was got to: the cells, and by id what was not (a door, a room, an object closed, an object open)."""

    cells: Mask
    doors: list[str] = field(default_factory=list)
    rooms: list[str] = field(default_factory=list)
    closed: list[str] = field(default_factory=list)
    opened: list[str] = field(default_factory=list)

    @property
    def missed(self) -> list[str]:
        """Ids of all that was not reached, each once, in plan order."""
        return list(dict.fromkeys([*self.doors, *self.rooms, *self.closed, *self.opened]))


def space(
    plan: Plan, radius: float = RADIUS, resolution: float = grid.RESOLUTION, cells: Grid | None = None
) -> Space:
    """Rasterise a plan for a robot of that radius; doors stand open at a right angle, the entrance is shut.

    `cells` may be given in place of a resolution.
    """
    floor = polygons.free_floor(plan)
    leaves = [polygons.leaf(o, plan).buffer(LEVER) for o in plan.openings if o.kind == "door"]
    floor = floor.difference(unary_union(leaves))
    cells = grid.over(floor, resolution) if cells is None else cells
    rooms = np.full(cells.shape, -1, np.int16)
    for i, room in enumerate(plan.rooms):
        rooms[grid.raster(polygons.floor(room), cells)] = i
    free = grid.open_to(floor, cells, radius)
    doors = {o.id: _door(o, plan, cells, radius) for o in plan.openings if o.kind in polygons.PASSAGES}
    return Space(plan, radius, cells, free, rooms, _entry(plan, free, cells, radius), doors)


def part(world: Space, rooms: Collection[str], cells: Mask, margin: float = 0.6) -> Space:
    """The space about some rooms alone, for questions about them while nothing outside them changes.

    The robot comes in where it gets to the rim without passing through these rooms; `cells` are those of `free`.
    """
    shapes = [polygons.floor(room).bounds for room in world.plan.rooms if room.id in rooms]
    lo, hi = np.min(shapes, axis=0)[:2] - margin, np.max(shapes, axis=0)[2:] + margin
    window = world.grid.around(lo, hi)
    inside = np.isin(world.rooms, [i for i, room in enumerate(world.plan.rooms) if room.id in rooms])
    rim = np.ones(world.grid.shape, bool)[window]
    rim[1:-1, 1:-1] = False
    entry = world.entry[window] | (rim & grid.from_seeds(cells & ~inside, world.entry)[window])
    doors = {name: [side[window] for side in sides] for name, sides in world.doors.items()
             if all(side[window].sum() == side.sum() for side in sides)}
    here = world.grid.part(window)
    return Space(world.plan, world.radius, here, world.open[window], world.rooms[window], entry, doors)


def _door(opening: Opening, plan: Plan, cells: Grid, radius: float) -> list[Mask]:
    if len(opening.rooms) == 1:
        return [grid.raster(polygons.before(opening, plan, opening.rooms[0], 2 * radius + _STEP_IN, True), cells)]
    sides = [grid.raster(polygons.before(opening, plan, room, _STEP_IN, True), cells) for room in opening.rooms]
    return [grid.raster(polygons.threshold(opening, plan), cells), *sides]


def _entry(plan: Plan, free: Mask, cells: Grid, radius: float) -> Mask:
    """Cells just inside the entrance; without one, those inside any door; without any, the largest part."""
    deep = 2 * radius + _STEP_IN
    strips = [polygons.before(o, plan, o.rooms[0], deep, from_face=True) for o in polygons.ways_in(plan)]
    return grid.raster(strips, cells) & free if strips else grid.largest(free)


def count(world: Space, objects: Sequence[Box]) -> NDArray[np.int16]:
    """How many obstacles keep the robot's centre off each cell."""
    return grid.near(boxes.of([o for o in objects if in_the_way(o)]), world.grid, world.radius)


def recounted(
    world: Space, before: NDArray[np.int16], old: Iterable[Box], new: Iterable[Box]
) -> NDArray[np.int16]:
    """The result of `count` when some objects go and others come."""
    now = before.copy()
    for objects, by in ((old, -1), (new, 1)):
        grid.change(now, boxes.of([o for o in objects if in_the_way(o)]), world.grid, world.radius, by)
    return now


def in_the_way(o: Box) -> bool:
    """Whether the robot has to go around an object."""
    return footprints.is_obstacle(o) and o.center[2] - o.size[2] / 2 < HEIGHT


def free(world: Space, objects: Sequence[Box]) -> Mask:
    """Where the robot's centre may be among the objects."""
    cells: Mask = world.open & (count(world, objects) == 0)
    return cells


def survey(
    world: Space, objects: Sequence[Box], reach: float = REACH, cells: Mask | None = None,
    only: Collection[str] | None = None,
) -> Reached:
    """Everything the robot gets to from the entrance, and what it does not.

    `cells` may be given from `free`; `only` limits the question to some ids of doors, rooms and objects.
    """
    open_cells = free(world, objects) if cells is None else cells
    got = grid.from_seeds(open_cells, world.entry)
    doors = [name for name, parts in world.doors.items()
             if _asked(name, only) and not all((got & part).any() for part in parts)]
    rooms = [room.id for i, room in enumerate(world.plan.rooms)
             if _asked(room.id, only) and _is_cut(got, open_cells, world.rooms == i, world.grid)]
    closed, opened = _objects(world, [o for o in objects if _asked(o.id, only)], reach, open_cells, got)
    return Reached(got, doors, rooms, closed, opened)


def _is_cut(got: Mask, open_cells: Mask, room: Mask, cells: Grid) -> bool:
    """Whether a room is not reached, or more than `POCKET` of where the robot could stand in it is not."""
    return not (got & room).any() or float((open_cells & ~got & room).sum()) * cells.cell > POCKET


def _asked(name: str, only: Collection[str] | None) -> bool:
    return only is None or name in only


def _objects(
    world: Space, objects: Sequence[Box], reach: float, open_cells: Mask, got: Mask
) -> tuple[list[str], list[str]]:
    """Ids of articulated objects not reached with their parts closed, and with them open."""
    moving = [o for o, moves in zip(objects, sweeps.articulated(objects)) if moves and footprints.is_obstacle(o)]
    parts, owner = sweeps.opened(moving)
    index = {room.id: i for i, room in enumerate(world.plan.rooms)}
    inside = {room: got & (world.rooms == index[room]) for room in {o.room for o in moving}}
    closed, opened = [], []
    for i, o in enumerate(moving):
        window, zone = standing(o, world.grid, reach, world.radius)
        if not (inside[o.room][window] & zone).any():
            closed.append(o.id)
        elif not (_still(world, o, parts.take(owner == i), reach, open_cells, got, index[o.room])
                  and _handled(world, o, inside[o.room])):
            opened.append(o.id)
    return closed, opened


def _handled(world: Space, o: Box, got: Mask) -> bool:
    """Whether each part can be opened, the others shut, by an arm from somewhere that the robot gets to."""
    return all(handling.standing(o, joint, world.grid, world.radius, got) for joint in handling.joints(o))


def _still(world: Space, o: Box, parts: Boxes, reach: float, open_cells: Mask, got: Mask, room: int) -> bool:
    """Whether the robot can come and stand in front of an object whose parts are open."""
    window, zone = standing(o, world.grid, reach, world.radius, parts)
    shades = list(grid.shades(parts, world.grid, world.radius))
    around = _about([window, *(shade for shade, _ in shades)], got.shape)
    shut_out, place = np.zeros((2, *got[around].shape), bool)
    for shade, hit in shades:
        shut_out[_within(shade, around)] |= hit > 0
    place[_within(window, around)] = zone & (world.rooms[window] == room)
    place &= ~shut_out
    if not (got[around] & place).any():
        return False
    if not (got[around] & shut_out).any():
        return True
    nearby = _locally(got[around], world.entry[around], shut_out, place)
    if nearby is not None:
        return nearby
    left = open_cells.copy()
    left[around] &= ~shut_out
    return bool((grid.from_seeds(left, world.entry)[around] & place).any())


def _about(windows: Sequence[grid.Window], shape: tuple[int, ...]) -> grid.Window:
    """The window about some windows, `_AROUND` cells larger."""
    rows, columns = ([w[k].indices(shape[k]) for w in windows] for k in (0, 1))
    (low, high), (left, right) = ((min(w[0] for w in some), max(w[1] for w in some)) for some in (rows, columns))
    return (slice(max(low - _AROUND, 0), min(high + _AROUND, shape[0])),
            slice(max(left - _AROUND, 0), min(right + _AROUND, shape[1])))


def _within(window: grid.Window, around: grid.Window) -> grid.Window:
    """A window as seen from another about it."""
    rows, columns = (slice(w.start - a.start, w.stop - a.start) for w, a in zip(window, around))
    return rows, columns


def _locally(got: Mask, entry: Mask, shut_out: Mask, place: Mask) -> bool | None:
    """Whether a place is still got to with some cells shut, where a look at the surroundings decides it.

    Where all ways out of the surroundings stay joined within them, nothing beyond is cut off either.
    """
    every = shut_out | place
    rows, columns = (np.flatnonzero(every.any(axis)) for axis in (1, 0))
    here = (slice(max(rows[0] - _AROUND, 0), rows[-1] + _AROUND + 1),
            slice(max(columns[0] - _AROUND, 0), columns[-1] + _AROUND + 1))
    if entry[here].any():
        return None
    labels = grid.connected((got & ~shut_out)[here])[0]
    rim = np.concatenate([labels[0], labels[-1], labels[:, 0], labels[:, -1]])
    ways = np.unique(rim[rim > 0])
    return bool((labels[place[here]] == ways[0]).any()) if len(ways) == 1 else None


def standing(
    o: Box, cells: Grid, reach: float, radius: float, parts: Boxes | None = None
) -> tuple[grid.Window, Mask]:
    """Cells in front of an object from which it is used: within `reach` of its face, or of its open parts.

    To the sides the zone is wider than the object by the robot's radius, beside open parts by its width. Returns a
    window of the raster and the cells in it.
    """
    face, half = o.size[0] / 2, o.size[1] / 2 + radius
    ahead = face
    if parts is not None and parts.n:
        heading = np.array([np.cos(o.yaw), np.sin(o.yaw)])
        corners = boxes.corners(parts).reshape(-1, 2) - o.center[:2]
        ahead = max(ahead, float((corners @ heading).max()))
        half += radius
    return _before(o.center[0], o.center[1], o.yaw, face, ahead + reach, half, cells)


@lru_cache(maxsize=8192)
def _before(
    x: float, y: float, yaw: float, face: float, far: float, half: float, cells: Grid
) -> tuple[grid.Window, Mask]:
    """Cells between `face` and `far` before a place; kept, because repairs ask for the same again and again."""
    c, s = np.cos(yaw), np.sin(yaw)
    heading, center = np.array([c, s]), np.array([x, y])
    middle = center + heading * (face + far) / 2
    spread = np.abs(heading) * (far - face) / 2 + np.abs(heading[::-1]) * half
    window = cells.around(middle - spread, middle + spread)
    across, up = cells.x[window[1]][None, :] - x, cells.y[window[0]][:, None] - y
    front, side = across * c + up * s, up * c - across * s
    return window, (front > face) & (front <= far) & (np.abs(side) <= half)
