"""Carries a plan out in physics: servos with limited force, contacts, a grip that slips."""

from dataclasses import dataclass, field
from math import sqrt

import mujoco
import numpy as np

from apartgen.stages.embodied.interact.chains import OPEN
from apartgen.stages.embodied.interact.parts import Hold, Part
from apartgen.stages.embodied.interact.plan import Phase, Plan
from apartgen.stages.embodied.interact.probe import ALL, Probe
from apartgen.stages.embodied.interact.robot import CUP, FINGERS, HAND, LEAD, NAMES, SPEED, TIP, joint, posture
from apartgen.stages.embodied.interact.timing import smoothed, timed
from apartgen.stages.embodied.outcome import RATE, Course
from apartgen.stages.space.boxes import Array

SLIP = {"pinch": 60.0, "cup": 48.0}
"""Force at which the hold is lost, N: two rubber pads (μ 0.5) at 60 N; half of what a cup of 4.5 cm bears (-60 kPa)."""
SEATED = 0.01
"""The cup takes hold of what its mouth is no further from, m."""
FRICTION, LEAST_FRICTION = 0.05, 0.5
"""Dry friction of a part in its joint, as felt at the handle: a share of its weight, and so many N besides.

It takes the place of what exported joints have.
"""
SHUT = 0.02
"""Share of its range to which a part still counts as shut."""
SLIPPING = 0.02
"""Forces are averaged over about this time: a shorter peak does not move the pads, s."""
_PASSED = 11
"""Collision bits of what the fingers hold: all but the hand's, so that friction does not hold beside the joint."""
GRAZE = 5.0
"""A harder contact with anything but the part held is a collision, N."""
PACE, LOOSE_PACE = {"hinge": 0.7, "slide": 0.25}, 0.3
"""Speed of a part in hand, rad/s and m/s; at most so much of that where the object stands loose."""
RAMP, HELD_RAMP, EFFORT = 0.3, 0.6, 10.0
"""Seconds to gather speed, the hand free or holding (or about to); longer where sliding parts would take more N."""
FRAMES = 20
"""Recorded a second."""
TIMESTEP = 0.004
"""Of the simulation while the hand takes hold or pushes, and while anything touches, s."""
STRIDE = 2
"""Steps of the simulation between commands to the servos; elsewhere one step is as long."""
_SMOOTH = 0.12  # s over which the targets of a held motion are averaged
_CLOSE = 1.2  # s at most for the fingers to close
_REST = 0.2  # s at most at the end of each phase, for the arm to catch up
_HARM = np.array([[0, 0, 1, 1], [0, 0, 0, 1], [1, 0, 0, 0], [1, 1, 0, 1]], bool)
"""Whether a contact does harm, by `Actor.role` of what meets: other things, the part's object, the part, the robot."""
_CAUGHT_UP, _STILL = 5e-4, 5e-3  # m or rad off the target, m/s or rad/s of every joint, when it has


@dataclass
class Result:
    """How far the part came (share of its range), what went wrong, and what was recorded."""

    share: float = 0.0
    trouble: str = ""
    blocked: bool = False
    missed: bool = False
    """The hand found nothing to hold, and nothing moved."""
    force: float = 0.0
    seconds: float = 0.0
    course: Course = field(default_factory=Course)
    times: list[float] = field(default_factory=list)
    qpos: list[list[float]] = field(default_factory=list)


class Actor:
    """One episode under way."""

    def __init__(self, probe: Probe, part: Part, recorded: Array | None) -> None:
        self.probe, self.part, self.recorded = probe, part, recorded
        self.model = probe.world.model
        # Only what stands loose on something needs that; other parts rest at their joints' limits.
        base, loose = int(self.model.body_parentid[part.body]), probe.loose(part)
        probe.limit(self.model, part.body, *([base] if loose else []))
        mass = float(self.model.body_subtreemass[part.body])
        self.pace = PACE["slide" if part.slides else "hinge"] * (LOOSE_PACE if loose else 1.0)
        self.ramp = max(HELD_RAMP, part.slides * mass * self.pace / EFFORT)
        friction = LEAST_FRICTION - FRICTION * mass * self.model.opt.gravity[2]
        self.model.dof_frictionloss[:] = 0.0
        self.model.dof_frictionloss[self.model.body_dofadr[part.body]] = friction * part.lever
        self.data = mujoco.MjData(self.model)
        self.contact = self.data.contact
        self.servos = np.array([self.model.actuator(joint(name)).id for name in NAMES])
        self.mine = probe.robot
        self.grasping = probe.fingers
        self.moving = probe.part(part)
        self.role = np.where(self.mine, 3, np.where(self.moving, 2, probe.own(part).astype(int)))
        self.eq = self.model.equality("robot__hold").id
        self.result = Result()
        self.model.opt.timestep = TIMESTEP
        self.period = STRIDE * TIMESTEP

    def run(self, plan: Plan) -> Result:
        """Carry out every phase, or as far as it goes."""
        self._place(plan.phases[0].stops[0].posture)
        for phase in plan.phases:
            done = self._hold(phase) if phase.kind == "hold" else self._travel(phase)
            if not done:
                break
        self._release()
        result = self.result
        result.share = float(self.data.qpos[self.part.address] / self.part.travel)
        result.seconds = float(self.data.time)
        if not result.trouble and result.share < OPEN:
            result.trouble = f"opened to {result.share:.0%} only"
        return result

    def _place(self, posture: Array) -> None:
        self.data.qpos[self.probe.joints] = posture
        self.data.ctrl[self.servos] = posture
        mujoco.mj_forward(self.model, self.data)

    def _travel(self, phase: Phase) -> bool:
        """From stop to stop, halting at each, so that no corner is cut."""
        first, *far, last = phase.stops
        self.careful = False
        if not self._along([first.posture]):
            return False
        self._grasp(())
        if not all(self._along([stop.posture]) for stop in far):
            return False
        self.careful = True
        return self._along([last.posture]) and self._wait(_REST)

    def _along(self, postures: list[Array], values: Array | None = None) -> bool:
        """Servo through postures, each joint within its speed and a held part within its own."""
        path = np.array([self.data.ctrl[self.servos], *postures])
        spans = (np.abs(np.diff(path, axis=0)) / SPEED).max(1)
        if values is not None:
            spans = np.maximum(2 * spans, np.abs(np.diff(values, prepend=values[0])) / self.pace)
        step = self.period
        targets = timed(path, spans, step, RAMP if values is None and not self.careful else self.ramp)
        if values is not None:
            targets = smoothed(targets, int(_SMOOTH / step))
        for target in targets + np.gradient(targets, step, axis=0) * LEAD:
            self.data.ctrl[self.servos] = target
            if not self._step():
                return False
        self.data.ctrl[self.servos] = path[-1]
        return True

    def _wait(self, seconds: float) -> bool:
        """Until the arm has caught up, or for so long."""
        for _ in range(int(seconds / self.period)):
            off = self.data.qpos[self.probe.joints] - self.data.ctrl[self.servos]
            if (np.abs(off[:11]) < _CAUGHT_UP).all() and (np.abs(self.data.qvel) < _STILL).all():
                return True
            if not self._step():
                return False
        return True

    def _hold(self, phase: Phase) -> bool:
        hold = phase.hold
        assert hold is not None
        if hold.kind == "pinch" and not self._close():
            return False
        if hold.kind != "push" and not self._fasten(hold):
            return False
        path = self._held(phase)
        values = np.array([stop.value for stop in phase.stops])
        if not (self._along(path[:1]) and self._along(path, values) and self._wait(_REST)):
            return False
        self._release()
        return True

    def _close(self) -> bool:
        """Close the fingers until both touch the part."""
        self.data.ctrl[self.servos[FINGERS]] = 0.0
        for _ in range(int(_CLOSE / self.period) * STRIDE):
            self._commanded()
            mujoco.mj_step(self.model, self.data)
            self._record()
            if self._touching() == 2:
                return self._unharmed()
            if not self._unharmed():
                return False
        return self._missed("the fingers did not find the handle")

    def _missed(self, trouble: str) -> bool:
        self.result.trouble = trouble
        self.result.missed = abs(self.data.qpos[self.part.address]) < SHUT * abs(self.part.travel)
        return False

    def _touching(self) -> int:
        """How many fingers touch the part."""
        pairs = self.contact.geom.reshape(-1, 2)
        on = self.grasping[pairs].any(1) & self.moving[pairs].any(1) & (self.contact.dist < 5e-4)
        return len({int(pair[0] if self.grasping[pair[0]] else pair[1]) for pair in pairs[on]})

    def _fasten(self, hold: Hold) -> bool:
        """Let the hold take hold: a ball joint between hand and part, between the fingers or where the cup sits."""
        ahead = HAND if hold.kind == "pinch" else HAND + TIP + CUP
        point = self._point(ahead)
        value = float(self.data.qpos[self.part.address])
        if hold.kind == "cup" and np.linalg.norm(point - self.part.at(hold.point, value)) > SEATED:
            return self._missed("the cup did not reach the part")
        body = self.part.body
        turn = self.data.xmat[body].reshape(3, 3)
        self.model.eq_obj2id[self.eq] = body
        self.model.eq_data[self.eq, :6] = [ahead, 0, 0, *(turn.T @ (point - self.data.xpos[body]))]
        self.data.eq_active[self.eq] = 1
        self.ahead, self.limit, self.pull, self.careful = ahead, SLIP[hold.kind], 0.0, False
        if hold.kind == "pinch":
            self._grasp(hold.geoms)
            self.data.ctrl[self.servos[FINGERS]] = self.data.qpos[self.probe.joints[FINGERS]]
        return True

    def _grasp(self, geoms: tuple[int, ...]) -> None:
        """Have the hand pass through these geoms of the part while the joint holds them, and through no others."""
        self.model.geom_conaffinity[self.moving] = ALL
        self.model.geom_conaffinity[list(geoms)] = _PASSED

    def _point(self, ahead: float) -> Array:
        """A point so far before the wrist, along the hand."""
        palm = self.model.body("robot__palm").id
        return np.asarray(self.data.xpos[palm] + self.data.xmat[palm].reshape(3, 3) @ [ahead, 0, 0])

    def _held(self, phase: Phase) -> list[Array]:
        """The phase's postures, corrected for where the hand really took hold."""
        if not self.data.eq_active[self.eq]:
            return [stop.posture for stop in phase.stops]
        turn, shift = self.part.moved(float(self.data.qpos[self.part.address]))
        point = turn.T @ (self._point(self.ahead) - shift)
        fingers = self.data.ctrl[self.servos[FINGERS]]
        found: list[Array] = []
        for stop in phase.stops:
            assert stop.turn is not None
            at = self.part.at(point, stop.value) - (self.ahead - HAND) * stop.turn[:, 0]
            right = posture(stop.posture[:3], at, stop.turn, 0.0, stop.posture)
            found.append(np.concatenate([(stop.posture if right is None else right)[:11], fingers]))
        return found

    def _release(self) -> None:
        self.data.eq_active[self.eq] = 0

    def _step(self) -> bool:
        """One period of the simulation; False when the episode is over."""
        self._commanded()
        if self.careful or self.data.ncon:
            mujoco.mj_step(self.model, self.data, STRIDE)
        else:
            self.model.opt.timestep = self.period
            mujoco.mj_step(self.model, self.data)
            self.model.opt.timestep = TIMESTEP
        self._record()
        return self._holding() and self._unharmed()

    def _commanded(self) -> None:
        """Keep what the servos are told now for the course, `RATE` times a second."""
        if self.data.time * RATE >= len(self.result.course.action):
            value = float(self.data.qpos[self.part.address])
            around = np.array([value, *self.part.at(self.part.holds[0].point, value)])
            self.result.course.add(self.data.qpos[self.probe.joints], around, self.data.ctrl[self.servos])

    def _record(self) -> None:
        if self.recorded is not None and self.data.time * FRAMES >= len(self.result.times) + 1:
            self.result.times.append(round(float(self.data.time), 4))
            self.result.qpos.append([round(float(v), 5) for v in self.data.qpos[self.recorded]])

    def _holding(self) -> bool:
        """Whether the hold bears what it has to; it is the model's only equality, and equalities come first."""
        if not self.data.ne:
            return True
        x, y, z = self.data.efc_force[:3].tolist()
        self.pull += (sqrt(x * x + y * y + z * z) - self.pull) * self.period / SLIPPING
        self.result.force = max(self.result.force, self.pull)
        if self.pull <= self.limit:
            return True
        self.result.trouble = f"the grip slipped at {self.pull:.0f} N"
        return False

    def _unharmed(self) -> bool:
        """Whether neither robot nor part presses against anything that they should not."""
        if not self.data.ncon:
            return True
        pairs = self.contact.geom.reshape(-1, 2)
        bad = _HARM[self.role[pairs[:, 0]], self.role[pairs[:, 1]]]
        if not bad.any():
            return True
        rows = self.contact.efc_address[bad]
        force = np.where(rows >= 0, self.data.efc_force[rows], 0.0)
        if force.max() <= GRAZE:
            return True
        worst = pairs[bad][int(force.argmax())]
        hand = self.mine[worst].any()
        own = self.mine[worst] if hand else self.moving[worst]
        other = self.probe.name(int(worst[1] if own[0] else worst[0]))
        self.result.trouble = f"{'the robot' if hand else 'the part'} met {other} with {force.max():.0f} N"
        self.result.blocked = not hand
        return False
