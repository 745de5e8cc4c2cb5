"""What the page tells beside its scene: floors, a robot's way, what parts sweep, what is known of things."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Populate, Thing
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.export._reasons import about, numbers, reasons, steps
from apartgen.stages.robot import reach, way
from apartgen.stages.space import grid, polygons, sweeps

CELL = 0.1
"""Of the raster that says where floor is, m."""
FINEST = 0.03
"""How far the drawn way may be off the true one, m."""

Facts = dict[str, Any]


def told(home: Plan) -> Facts:
    """What JSON holds of a home for the viewer; all in the plan's axes, metres."""
    objects = home.objects if isinstance(home, Layout) else []
    space = reach.space(home)
    cells = grid.from_seeds(reach.free(space, objects), space.entry)
    why = reasons(home)
    return {
        "floor": _floor(home),
        "free": _free(cells, space.grid),
        "way": _way(space, cells),
        "leaves": [_rounded(swing.exterior.coords[:-1]) for o in home.openings if (swing := polygons.swing(o, home))],
        "things": [_thing(home, o) | {"about": about(home, o), "why": why.get(o.id, [])} for o in objects],
        "steps": steps(home),
        "numbers": numbers(home),
    }


def _thing(home: Plan, o: Box) -> Facts:
    found: Facts = {"id": o.id, "center": o.center, "size": o.size, "yaw": o.yaw}
    if isinstance(o, Thing):
        found["small"] = True
    joints = o.joints if isinstance(o, Furnishing) else []
    swept = [_rounded(sweeps.swept(joint)) for joint in joints if joint.extent is not None]
    if swept:
        found["sweeps"] = swept
    if isinstance(home, Populate) and o.id in home.receptacles:
        found["receptacles"] = [{"polygon": r.polygon, "z": r.z} for r in home.receptacles[o.id]]
    return found


def _rounded(points: Any) -> list[list[float]]:
    rows: list[list[float]] = np.round(np.asarray(points, float), 3).tolist()
    return rows


def _floor(home: Plan) -> Facts:
    """Runs [room or -1, length] of the raster of rooms, row by row from the lowest y."""
    cells = grid.over(polygons.shell(home), CELL)
    rooms = np.full(cells.shape, -1, np.int64)
    for i, room in enumerate(home.rooms):
        rooms[grid.raster(polygons.floor(room), cells)] = i
    flat = rooms.ravel()
    starts = np.concatenate([[0], np.flatnonzero(np.diff(flat)) + 1, [len(flat)]])
    runs = [[int(flat[a]), int(b - a)] for a, b in zip(starts[:-1], starts[1:])]
    rows, columns = cells.shape
    return _frame(cells) | {"columns": columns, "rows": rows, "rooms": [room.id for room in home.rooms], "runs": runs}


def _free(cells: NDArray[np.bool_], raster: grid.Grid) -> Facts:
    """Runs [row, from, to) of where the robot's centre gets to."""
    edges = np.diff(np.pad(cells, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    (rows, begins), (_, ends) = np.nonzero(edges == 1), np.nonzero(edges == -1)
    return _frame(raster) | {"runs": np.stack([rows, begins, ends], -1).tolist()}


def _frame(raster: grid.Grid) -> Facts:
    x, y = (float(v) for v in raster.origin)
    return {"x": x, "y": y, "cell": raster.resolution}


def _way(space: reach.Space, cells: NDArray[np.bool_]) -> list[list[float]]:
    from shapely.geometry import LineString

    points = way.through_rooms(space, cells)
    return _rounded(LineString(points).simplify(FINEST).coords) if len(points) > 1 else []
