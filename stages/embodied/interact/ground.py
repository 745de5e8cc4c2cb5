"""How the robot gets to where it works: driven from the entrance in physics as in navigation, then parked.

Leaves of room doors stand open, as in navigation. Places that an open leaf takes up or cuts off are driven to with all
leaves out of the way, as if the robot had shut that door behind it.
"""

from collections.abc import Collection
from functools import cached_property

import numpy as np

from apartgen.stages.embodied import base, floor, goals, navigate, planner, world
from apartgen.stages.embodied.drive import Drive, drive
from apartgen.stages.embodied.floor import Floor
from apartgen.stages.embodied.goals import Cell
from apartgen.stages.embodied.interact.robot import MASS, RADIUS
from apartgen.stages.embodied.planner import Roadmap
from apartgen.stages.embodied.pursuit import Pursuit
from apartgen.stages.embodied.world import World
from apartgen.stages.space.boxes import Array, Mask

WITHIN, FACING = 0.015, 0.02
"""How near to a place and a heading the robot parks, m and rad; the arm's motion is planned from where it then is."""


class Ground:
    """The floor that the base drives on, some colliders left out, and where it gets to from the entrance.

    Of what it gets to, `cells` are those places that it does not get to on a `stricter` ground.
    """

    def __init__(self, apartment: World, without: Collection[str] = (), stricter: "Ground | None" = None) -> None:
        self.apartment, self.without, self.stricter = apartment, frozenset(without), stricter

    @cached_property
    def floor(self) -> Floor:
        """Where its disc can be."""
        return floor.survey(self.apartment, RADIUS, without=self.without)

    @cached_property
    def began(self) -> tuple[Cell, float] | None:
        """Cell and heading inside the entrance; None where that is blocked."""
        return goals.start(self.floor)

    @cached_property
    def ways(self) -> Roadmap | None:
        """From there to everywhere."""
        return None if self.began is None else planner.roadmap(self.floor, self.began[0])

    @cached_property
    def reached(self) -> Mask:
        """Cells that the base gets to."""
        return np.zeros(self.floor.grid.shape, bool) if self.ways is None else self.ways.reached

    @cached_property
    def cells(self) -> Array:
        """Points (n, 2) that the base gets to, in the order of y."""
        new = self.reached if self.stricter is None else self.reached & ~self.stricter.reached
        return self.floor.grid.centers()[new]

    @cached_property
    def others(self) -> Array:
        """Points (n, 2) where the base could only stand, in the order of y."""
        return self.floor.grid.centers()[self.floor.free & ~self.reached]

    @cached_property
    def _worlds(self) -> tuple[World, World]:
        """What is driven in, and the same with nothing but robot and ground."""
        home, robot = self.apartment, base.mjcf(MASS)
        near, alone = (
            world.build(home.scene, home.mjcf, robot, moving=(), fused=True, without=those, source=home.source)
            for those in (self.without, floor.above_ground(home))
        )
        return near, alone

    def drive(self, pose: Array) -> Drive:
        """From the entrance to a pose (x, y, heading) at one of the `cells`."""
        assert self.ways is not None and self.began is not None
        row, column = planner.cell(self.floor, pose[None, :2])[0].tolist()
        path = self.ways.path((row, column))
        pursuit = Pursuit(self.floor, path, float(pose[2]), within=WITHIN, facing=FACING)
        return drive(*self._worlds, pursuit, self.began[1], navigate.limit(path))
