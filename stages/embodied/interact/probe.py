"""What would touch what: the simulator's own collision test, used to plan with."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from stages.boxes import Array, Mask
from stages.embodied.interact.parts import Hold, Part
from stages.embodied.interact.robot import NAMES, joint
from stages.embodied.world import ROBOT, World

CLEARANCE, CLOSE = 0.006, 0.001
"""The robot is planned to keep this far from everything, its fingers only so far, m."""
PRESSED = 0.003
"""How far fingers may be planned into what they hold, m: handles are rounder than their collision pieces."""
JAMMED = 0.005
"""A part that would go deeper than this into something is blocked by it, m."""

Index = NDArray[np.int64]


@dataclass(frozen=True)
class Probe:
    """A model, a scratch state, and which geoms are the robot's, its fingers' and each part's."""

    world: World
    data: Any

    @classmethod
    def of(cls, world: World) -> "Probe":
        """A probe of the apartment with everything shut."""
        probe = cls(world, mujoco.MjData(world.model))
        mujoco.mj_kinematics(world.model, probe.data)
        return probe

    @cached_property
    def robot(self) -> Mask:
        """Which geoms are the robot's, (ngeom,)."""
        model = self.world.model
        own = [model.body(k).name.startswith(ROBOT) for k in range(model.nbody)]
        return np.array(own, bool)[model.geom_bodyid]

    @cached_property
    def fingers(self) -> Mask:
        """Which geoms are fingers, (ngeom,)."""
        model = self.world.model
        ids = [model.body(joint(name)).id for name in NAMES[-2:]]
        return np.isin(model.geom_bodyid, ids)

    @cached_property
    def joints(self) -> Index:
        """Addresses of the robot's joint positions, (13,)."""
        return np.array([self.world.model.joint(joint(name)).qposadr[0] for name in NAMES])

    def part(self, part: Part) -> Mask:
        """Which geoms are the part's, (ngeom,)."""
        return np.asarray(self.world.model.geom_bodyid == part.body)

    def own(self, part: Part) -> Mask:
        """Which geoms are the object's whose part it is, (ngeom,)."""
        ids = [k for k, id in self.world.object_of.items() if id == part.object]
        return np.isin(self.world.model.geom_bodyid, ids)

    def reset(self) -> None:
        """Everything shut again."""
        mujoco.mj_resetData(self.world.model, self.data)

    def _contacts(self, posture: Array | None, part: Part, value: float, margin: float) -> tuple[Index, Array]:
        """Pairs of geoms (n, 2) that are closer than the margin, and how far apart."""
        model, data = self.world.model, self.data
        if posture is not None:
            data.qpos[self.joints] = posture
        data.qpos[part.address] = value
        model.geom_margin[self.robot] = margin
        mujoco.mj_kinematics(model, data)
        mujoco.mj_collision(model, data)
        model.geom_margin[self.robot] = 0.0
        found = np.array(data.contact.geom, np.int64).reshape(-1, 2)
        return found, np.array(data.contact.dist)

    def hit(self, posture: Array, part: Part, value: float, held: Hold | None = None) -> int:
        """A geom that the robot would meet in a posture with the part at a position, -1 for none.

        The fingers may touch what is held.
        """
        pairs, apart = self._contacts(posture, part, value, CLEARANCE)
        mine = self.robot[pairs]
        room = np.where(mine.all(1), 0.0, np.where(self.fingers[pairs].any(1), CLOSE, CLEARANCE))
        touching = mine.any(1) & (apart < room)
        if held is not None:
            grasped = self.fingers[pairs].any(1) & np.isin(pairs, held.geoms).any(1)
            touching &= ~(grasped & (apart > -PRESSED))
        if not touching.any():
            return -1
        first = pairs[touching][0]
        return int(first[1] if self.robot[first[0]] else first[0])

    def blocked(self, part: Part, value: float) -> int:
        """A geom of something else that the part would run into at a position, -1 for none."""
        pairs, apart = self._contacts(None, part, value, 0.0)
        own, moving = self.own(part), self.part(part)
        foreign = ~own & ~self.robot
        mine = moving[pairs]
        deep = mine.any(1) & foreign[pairs].any(1) & (apart < -JAMMED)
        if not deep.any():
            return -1
        first = pairs[deep][0]
        return int(first[1] if moving[first[0]] else first[0])

    def name(self, geom: int) -> str:
        """What a geom belongs to: the artifact's id of an object or opening, else its body's name."""
        body = int(self.world.model.geom_bodyid[geom])
        return self.world.object_of.get(body, self.world.model.body(body).name)
