"""Where a round robot can be in the simulated apartment: from the model's own colliders, not from the artifact's boxes.

Cells are those of `stages/grid.py`; distances are in metres.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import product
from typing import Any, NamedTuple

import mujoco
import numpy as np
import shapely
from shapely import Geometry

from apartgen.stages.compiling import compiled
from apartgen.stages.embodied.world import World
from apartgen.stages.robot import reach
from apartgen.stages.space import grid, polygons
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.space.grid import Grid
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Collider

HEIGHT = 1.4
"""Of the robot, m: what is higher is passed under."""
LOW = 0.015
"""What is no higher is driven over, m."""
FAR = 1.0
"""Clearance beyond this is not told apart, m."""
_STEP = 0.01  # m between points of outlines that distances are measured to; too great by s² / 8 d = 0.05 mm at contact
FINER = 2
"""Cells are so much smaller than those of the walkable stage, and than Nav2's default of 5 cm.

Gaps little wider than the robot have cells in them then.
"""


@dataclass(frozen=True)
class Floor:
    """A raster of the apartment: `space` without furniture, `parts` the colliders in the robot's height from above."""

    space: reach.Space
    parts: dict[str, Geometry]
    radius: float

    @property
    def grid(self) -> Grid:
        """The cells."""
        return self.space.grid

    @cached_property
    def open(self) -> Mask:
        """Cells whose centre is on the floor and not in anything that stands in the robot's height."""
        inside = grid.raster(polygons.free_floor(self.space.plan), self.grid)
        return inside & ~grid.raster(list(self.parts.values()), self.grid)

    @cached_property
    def free(self) -> Mask:
        """Cells where the robot's centre can be, its disc touching nothing."""
        found: Mask = self.clearance >= self.radius - 1e-6
        return found

    @cached_property
    def clearance(self) -> Array:
        """Distance from every cell's centre to what is solid, m, up to `FAR`; 0 where that is or there is no floor."""
        from scipy.spatial import cKDTree

        found = self.open.astype(float) * FAR
        outlines = shapely.segmentize(shapely.boundary(list(self.parts.values())), _STEP)
        if len(outlines):
            tree = cKDTree(shapely.get_coordinates(outlines), balanced_tree=False, compact_nodes=False)
            nearest, _ = tree.query(self.grid.centers()[self.open], distance_upper_bound=FAR)
            found[self.open] = np.minimum(nearest, FAR)
        return found

    @cached_property
    def near(self) -> Callable[[float, float], float]:
        """Clearance of a point x, y as in `beside`, m; numbers by themselves are faster than arrays of one."""
        return partial(clearance_at, self.field)

    @cached_property
    def field(self) -> "Field":
        """The clearance as compiled code takes it."""
        left, below = self.grid.origin
        return Field(np.ascontiguousarray(self.clearance), float(left), float(below), float(self.grid.resolution))

    def beside(self, points: Array) -> Array:
        """Clearance of points (..., 2), m, between that of the cells' centres; beyond the raster that of its edge."""
        at = ((points - self.grid.origin) / self.grid.resolution - 0.5)[..., ::-1]
        at = np.clip(at, 0.0, np.array(self.grid.shape) - 1.001)
        row, column = np.moveaxis(at.astype(np.int64), -1, 0)
        v, u = np.moveaxis(at, -1, 0) - (row, column)
        low = self.clearance[row, column] * (1 - u) + self.clearance[row, column + 1] * u
        high = self.clearance[row + 1, column] * (1 - u) + self.clearance[row + 1, column + 1] * u
        return np.asarray(low * (1 - v) + high * v)


class Field(NamedTuple):
    """Clearance of cells (rows, columns), m, the corner (left, below) that they begin at, and their size, m."""

    cells: Array
    left: float
    below: float
    size: float


@compiled()
def clearance_at(field: Field, x: float, y: float) -> float:
    """Clearance of a point between that of cells' centres, as `Floor.beside` has it, m."""
    cells = field.cells
    rows, columns = cells.shape
    u = min(max((x - field.left) / field.size - 0.5, 0.0), columns - 1.001)
    v = min(max((y - field.below) / field.size - 0.5, 0.0), rows - 1.001)
    i, j = int(v), int(u)
    u, v = u - j, v - i
    low = cells[i, j] * (1 - u) + cells[i, j + 1] * u
    return float(low * (1 - v) + (cells[i + 1, j] * (1 - u) + cells[i + 1, j + 1] * u) * v)


def survey(
    world: World, radius: float = reach.RADIUS, height: float = HEIGHT, without: Collection[str] = ()
) -> Floor:
    """The floor of a world, everything at rest as it is built (room doors open); `without` names colliders left out.

    Among the cells' centres are those that `stages/reach.py` looks at, so that no way found there is missed.
    """
    parts = {name: shape for name, shape in standing(world, height).items() if name not in without}
    floor = polygons.free_floor(world.home)
    coarse = grid.over(floor)
    cells = grid.finer(coarse, FINER, floor.buffer(coarse.resolution))
    return Floor(reach.space(world.home, radius, cells=cells), parts, radius)


def standing(world: World, height: float = HEIGHT) -> dict[str, Geometry]:
    """Outline from above of every collider in the robot's height but for the robot's own, by its name."""
    found = {name: points[:, :2] for name, points in _corners(world).items()
             if points[:, 2].max() > LOW and points[:, 2].min() < height}
    if not found:
        return {}
    whose = np.repeat(np.arange(len(found)), [len(points) for points in found.values()])
    hulls = shapely.convex_hull(shapely.multipoints(np.concatenate(list(found.values())), indices=whose))
    return dict(zip(found, hulls, strict=True))


def above_ground(world: World) -> list[str]:
    """Names of all colliders but the robot's and those that are driven over."""
    return [name for name, points in _corners(world).items() if points[:, 2].max() > LOW]


_SIGNS = np.array(list(product((-1.0, 1.0), repeat=3)))


def _corners(world: World) -> dict[str, Array]:
    """Points (n, 3) whose hull is the collider, for every one but the robot's, by its name."""
    model = world.model
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    robot = np.isin(model.geom_bodyid, list(world.robot_bodies))
    geoms = np.flatnonzero((model.geom_contype != 0) & ~robot)
    at, turned = data.geom_xpos[geoms], data.geom_xmat[geoms].reshape(-1, 3, 3)
    boxes = np.einsum("sk,gk,gjk->gsj", _SIGNS, model.geom_size[geoms], turned) + at[:, None]
    kinds = model.geom_type[geoms]
    return {
        model.geom(k).name: boxes[i] if kinds[i] == mujoco.mjtGeom.mjGEOM_BOX else _points(model, k, at[i], turned[i])
        for i, k in enumerate(geoms.tolist())
    }


def _points(model: Any, k: int, at: Array, turned: Array) -> Array:
    """The same for one that is no box."""
    kind, size = model.geom_type[k], model.geom_size[k]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = model.geom_dataid[k]
        first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        return np.asarray(model.mesh_vert[first : first + count] @ turned.T + at)
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        shape = Collider("cylinder", at, np.array([size[0], size[0], 2 * size[1]]), turned)
    elif kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        shape = Collider("sphere", at, np.repeat(size[:1], 3), turned)
    else:
        raise ValueError(f"collider of unknown type {kind}")
    return solids.corners(shape)
