"""What would touch what: the simulator's own collision test, used to plan with."""

from copy import copy
from functools import cached_property
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from apartgen.stages.embodied.interact.parts import Hold, Part
from apartgen.stages.embodied.interact.robot import NAMES, joint
from apartgen.stages.embodied.world import ROBOT, World
from apartgen.stages.space.boxes import Array, Mask

CLEARANCE, CLOSE = 0.006, 0.003
"""The robot is planned to keep this far from everything; its fingers only so far while they take hold, m."""
PRESSED = 0.003
"""How far fingers may be planned into what they hold, m: handles are rounder than their collision pieces."""
JAMMED = 0.005
"""A part that would go deeper than this into something is blocked by it, m."""
_PART, ALL = 8, 15  # collision bits where only robot and part look for contacts

Index = NDArray[np.int64]
_APART = np.array([[-np.inf, -np.inf, CLEARANCE, CLEARANCE]] * 2 + [[CLEARANCE, CLEARANCE, 0.0, 0.0]] * 2)
"""How far apart things must be, by what they are (`Probe._role`); where fingers take hold, _HOLDING, m."""
_HOLDING = _APART.copy()
_HOLDING[3, :2] = _HOLDING[:2, 3] = [CLOSE, -PRESSED]
_NONE: tuple[Index, Array] = (np.empty((0, 2), np.int64), np.empty(0))


class Probe:
    """A copy of the world's model in which only the robot and one part meet things, and its scratch state."""

    def __init__(self, world: World) -> None:
        self.world, self.model = world, copy(world.model)
        own = [world.model.body(k).name.startswith(ROBOT) for k in range(world.model.nbody)]
        self.robot: Mask = np.array(own, bool)[world.model.geom_bodyid]
        """Which geoms are the robot's, (ngeom,)."""
        self.solid: Mask = np.asarray(self.model.geom_contype != 0) & ~self.robot
        self.model.geom_margin[self.robot] = CLEARANCE
        self.model.body_margin[self.model.geom_bodyid[self.robot]] = CLEARANCE
        self.data = mujoco.MjData(self.model)
        self._owned: dict[str, Mask] = {}
        self._roles: dict[tuple[int, ...], NDArray[np.int8]] = {}
        self.reset(-1)

    @cached_property
    def fingers(self) -> Mask:
        """Which geoms are fingers, (ngeom,)."""
        ids = [self.model.body(joint(name)).id for name in NAMES[-2:]]
        return np.isin(self.model.geom_bodyid, ids)

    @cached_property
    def joints(self) -> Index:
        """Addresses of the robot's joint positions, (13,)."""
        return np.array([self.model.joint(joint(name)).qposadr[0] for name in NAMES])

    def part(self, part: Part) -> Mask:
        """Which geoms are the part's, (ngeom,)."""
        return np.asarray(self.model.geom_bodyid == part.body)

    def own(self, part: Part) -> Mask:
        """Which geoms are the object's whose part it is, (ngeom,)."""
        if part.object not in self._owned:
            found = np.zeros(self.model.ngeom, bool)
            found[[k for k, id in self.world.owner.items() if id == part.object]] = True
            self._owned[part.object] = found
        return self._owned[part.object]

    def loose(self, part: Part) -> bool:
        """Whether the object stands on something and may move."""
        return bool(self.model.body_weldid[self.model.body_parentid[part.body]])

    def reset(self, body: int) -> None:
        """Everything shut again; the part that `blocked` is asked about is this body."""
        mujoco.mj_resetData(self.model, self.data)
        self.limit(self.model, body)
        mujoco.mj_kinematics(self.model, self.data)

    def limit(self, model: Any, *bodies: int) -> None:
        """Have only the robot and some bodies meet things, in the world's model or its copy."""
        model.geom_contype[self.solid] = np.where(np.isin(model.geom_bodyid[self.solid], bodies), _PART, 0)
        model.geom_conaffinity[self.solid] = ALL
        model.body_contype[:] = model.body_conaffinity[:] = 0
        np.bitwise_or.at(model.body_contype, model.geom_bodyid, model.geom_contype)
        np.bitwise_or.at(model.body_conaffinity, model.geom_bodyid, model.geom_conaffinity)

    def _contacts(self, part: Part, value: float) -> tuple[Index, Array]:
        """Pairs of geoms (n, 2) that are close, and how far apart."""
        self.data.qpos[part.address] = value
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_collision(self.model, self.data)
        if not self.data.ncon:
            return _NONE
        contact = self.data.contact
        return contact.geom.reshape(-1, 2), contact.dist

    def hit(self, posture: Array, part: Part, value: float, held: Hold | None = None) -> int:
        """A geom that the robot would meet in a posture with the part at a position, -1 for none.

        The fingers may touch what is held.
        """
        self.data.qpos[self.joints] = posture
        pairs, apart = self._contacts(part, value)
        if not len(pairs):
            return -1
        first, second = self._role(held.geoms if held else ())[pairs].T
        least = _HOLDING if held else _APART
        touching = apart < least[first, second]
        if not touching.any():
            return -1
        a, b = pairs[touching.argmax()].tolist()
        return int(b if self.robot[a] else a)

    def _role(self, grasped: tuple[int, ...]) -> NDArray[np.int8]:
        """What the geoms are (ngeom,): 0 things, 1 what the fingers grasp, 2 the robot, 3 its fingers."""
        if grasped not in self._roles:
            role = self.robot * np.int8(2) + self.fingers
            role[list(grasped)] = 1
            self._roles[grasped] = role.astype(np.int8)
        return self._roles[grasped]

    def blocked(self, part: Part, value: float) -> int:
        """A geom of something else that the part would run into at a position, -1 for none."""
        pairs, apart = self._contacts(part, value)
        if not len(pairs):
            return -1
        moving = self.part(part)
        foreign = ~self.own(part) & ~self.robot
        deep = moving[pairs].any(1) & foreign[pairs].any(1) & (apart < -JAMMED)
        if not deep.any():
            return -1
        first = pairs[deep][0]
        return int(first[1] if moving[first[0]] else first[0])

    def name(self, geom: int) -> str:
        """What a geom belongs to: the artifact's id of an object or opening, else its body's name before fusing."""
        body = str(self.model.body(self.model.geom_bodyid[geom]).name)
        return self.world.owner.get(geom) or str(self.model.geom(geom).name).rpartition("__c")[0] or body
