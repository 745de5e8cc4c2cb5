"""What a replay shows beside the apartment: ways, goals, the floor that a robot gets to, things in plain colours."""

from collections.abc import Collection, Iterator, Sequence
from typing import Any, NamedTuple

import mujoco
import numpy as np

from apartgen.stages.embodied.outcome import Outcome
from apartgen.stages.embodied.world import World
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.space.grid import Grid

Colour = tuple[float, float, float, float]
MEANT, MET = (0.1, 0.4, 0.95, 1.0), (0.9, 0.1, 0.1, 0.45)
"""What an episode is about, and what is met there: seen through, as the part may be in it."""
GOAL, TRAIL = (0.1, 0.75, 0.2, 0.9), (0.95, 0.35, 0.1, 1.0)
REACHED, CUT_OFF = (0.1, 0.8, 0.3, 0.4), (1.0, 0.6, 0.0, 0.5)
"""Floor where the robot's middle gets to, and where it could only stand."""
_EVERY = 2  # rows of the floor's cells that are drawn as one
_THICK = 0.025  # m of lines, half


class Mark(NamedTuple):
    """A line, arrow, disc or box: from one point to another, `size` across (m)."""

    kind: Any
    a: Array
    b: Array
    size: float
    colour: Colour


def line(points: Sequence[Array], colour: Colour, height: float = 0.03) -> list[Mark]:
    """Along points (x, y), so high above the floor, m."""
    at = [np.array([*point[:2], height]) for point in points]
    return [Mark(mujoco.mjtGeom.mjGEOM_CAPSULE, a, b, _THICK, colour)
            for a, b in zip(at[:-1], at[1:]) if np.hypot(*(b - a)[:2]) > 1e-3]


def goal(outcome: Outcome) -> list[Mark]:
    """The pose to drive to: a disc, and an arrow the way to look. Nothing where there was none."""
    if "goal_x" not in outcome.numbers:
        return []
    x, y, yaw = (outcome.numbers[f"goal_{name}"] for name in ("x", "y", "yaw"))
    at, ahead = np.array([x, y, 0.01]), 0.6 * np.array([np.cos(yaw), np.sin(yaw), 0.0])
    disc = Mark(mujoco.mjtGeom.mjGEOM_CYLINDER, at, at + [0, 0, 0.02], 0.3, GOAL)
    return [disc, Mark(mujoco.mjtGeom.mjGEOM_ARROW, at + [0, 0, 0.05], at + ahead + [0, 0, 0.05], 0.04, GOAL)]


def floor(cells: Grid, where: Mask, colour: Colour) -> Iterator[Mark]:
    """Strips along the rows (rows, columns) of cells."""
    for row in range(0, len(where), _EVERY):
        ends = np.flatnonzero(np.diff(np.concatenate([[0], where[row].astype(int), [0]])))
        for first, last in ends.reshape(-1, 2):
            a, b = (np.array([cells.origin[0] + k * cells.resolution, cells.y[row], 0.012]) for k in (first, last))
            yield Mark(mujoco.mjtGeom.mjGEOM_BOX, a, b, _EVERY * cells.resolution, colour)


def put(scene: Any, marks: Collection[Mark]) -> None:
    """Add marks to a scene (`mujoco.MjvScene`), as many as there is room for."""
    for mark in list(marks)[: scene.maxgeom - scene.ngeom]:
        geom, box = scene.geoms[scene.ngeom], mark.kind == mujoco.mjtGeom.mjGEOM_BOX
        size = np.array([np.hypot(*(mark.b - mark.a)[:2]) / 2, mark.size / 2, 0.002]) if box else np.zeros(3)
        mujoco.mjv_initGeom(geom, mark.kind, size, (mark.a + mark.b) / 2, np.eye(3).ravel(),
                            np.array(mark.colour, np.float32))
        if not box:
            mujoco.mjv_connector(geom, mark.kind, mark.size, mark.a, mark.b)
        scene.ngeom += 1


def paint(shown: World, names: Collection[str], colour: Colour) -> None:
    """Give things one colour: objects and openings by id, all else by its body's name; walls with their linings."""
    model, every = shown.model, [shown.bodies[name] for name in names if name in shown.bodies]
    bodies = {*names, *(body.name for body in every), *(body.link_name(link) for body in every for link in body.links)}
    bodies |= {body.name for body in shown.scene.bodies if body.kind == "lining" and "walls" in names}
    for k in range(model.ngeom):
        if model.body(int(model.geom_bodyid[k])).name in bodies:
            model.geom_matid[k], model.geom_rgba[k] = -1, colour
