"""From where a part is opened: places are tried by planning, driven to, and planned from anew where the base rests."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice, tee

import numpy as np
from shapely import Geometry

from apartgen.stages.embodied.drive import Drive
from apartgen.stages.embodied.interact.chains import OPEN
from apartgen.stages.embodied.interact.ground import Ground
from apartgen.stages.embodied.interact.parts import Part
from apartgen.stages.embodied.interact.plan import Plan, Planner, spots, spread
from apartgen.stages.embodied.interact.probe import Probe
from apartgen.stages.embodied.interact.robot import tucked
from apartgen.stages.embodied.outcome import Failure
from apartgen.stages.space.boxes import Array

SPOTS, TOGETHER = 60, 6
"""Places tried at most for a part, and how many with its usual holds before others are tried there."""
DRIVES = 4
"""Places driven to at most for a part: where the base rests, some centimetres astray, the arm may find no way."""


@dataclass(frozen=True)
class Stand:
    """A pose of the base (x, y, heading): where a drive has ended, or that can be driven to on a ground."""

    pose: Array
    ground: Ground | None = None
    came: Drive | None = None


@dataclass
class Places:
    """All places in an apartment: `grounds` to drive on, the best first, the floor between the walls (`inside`), and
    where the robot has stood before the present object."""

    grounds: Sequence[Ground]
    inside: Geometry
    stood: list[Stand] = field(default_factory=list)


@dataclass
class Tried:
    """What was found before anything moved: a plan, or why there is none.

    `base` is where the robot stood when it found no way, `share` how far the part would have come, `came` the drive.
    """

    plan: Plan | None = None
    failure: Failure | None = None
    reason: str = ""
    numbers: dict[str, float] = field(default_factory=dict)
    base: Array | None = None
    share: float = OPEN
    came: Drive | None = None


def tried(probe: Probe, part: Part, places: Places) -> Tried:
    """Looks for a place to open a part from, drives there and plans; says what is in the way if there is none.

    A robot that already stands before the object stays where it is if it can.
    """
    probe.reset(part.body)
    for value in np.linspace(0, OPEN * part.travel, 17):
        met = probe.blocked(part, float(value))
        if met >= 0:
            share = float(value / part.travel)
            reason = f"meets {probe.name(met)} at {share:.0%} of its range"
            return Tried(None, "blocked part", reason, share=share)
    probe.limit(probe.model)
    return _Search(Planner(probe, part), places).run()


class _Search:
    """For one part: `tested` counts places, `drives` those driven to."""

    def __init__(self, planner: Planner, places: Places) -> None:
        self.planner, self.part, self.places = planner, planner.part, places
        self.ways = ((self.part.holds, False), (self.part.others, False), (self.part.holds, True))
        self.tested = self.drives = 0
        self.first: Array | None = None

    def run(self) -> Tried:
        new = (self._near(ground, ground.cells) for ground in self.places.grounds)  # each when it is asked for
        stands = self._fitting(chain(self.places.stood[::-1], chain.from_iterable(new)))
        for stand in stands:
            found = self._among(chain([stand], islice(stands, TOGETHER - 1)))
            if found is not None:
                return found
        return self._nowhere()

    def _among(self, some: Iterable[Stand]) -> Tried | None:
        """The usual holds at all of some places, then others; places are looked for only once those before failed."""
        k = 0
        for (holds, push), stands in zip(self.ways, tee(some, len(self.ways)), strict=True):
            for k, stand in enumerate(stands, 1):
                self.first = stand.pose if self.first is None else self.first
                plan = self.planner.plan(stand.pose, holds, push)
                if plan is None:
                    continue
                ended = self._at(stand, plan, self.tested + k, push)
                if ended is not None:
                    return ended
        self.tested += k
        return None

    def _at(self, stand: Stand, plan: Plan, tested: int, push: bool) -> Tried | None:
        """What comes of a place with a plan: as it is where the robot stands there, else once it has been driven to."""
        numbers = {"places": float(tested), "drives": float(self.drives), "pushed": float(push)}
        if stand.came is not None:
            return Tried(plan, numbers=numbers | _driven(stand.came), came=stand.came)
        assert stand.ground is not None
        came = stand.ground.drive(stand.pose)
        self.drives += 1
        numbers |= {"drives": float(self.drives)} | _driven(came)
        if came.reason:
            return Tried(None, "controller", f"{came.reason} on its way there", numbers, stand.pose, came=came)
        x, y, yaw = came.pose
        rests = Stand(np.array([x, y, (yaw + np.pi) % (2 * np.pi) - np.pi]), came=came)
        self.places.stood.append(rests)
        for holds, push in self.ways if any(self._fitting([rests])) else ():
            found = self.planner.plan(rests.pose, holds, push)
            if found is not None:
                return Tried(found, numbers=numbers | {"pushed": float(push)}, came=came)
        if self.drives == DRIVES:
            return Tried(None, "planner", "the arm finds no motion from where the base rests", numbers, rests.pose)
        return None

    def _nowhere(self) -> Tried:
        chains, last = self.planner.chains, self.places.grounds[-1]
        if chains.reached:
            return Tried(None, "planner", chains.complaint(), {"places": float(self.tested)}, self.first)
        if any(True for _ in self._fitting(self._near(last, last.others))):
            return Tried(None, "planner", "no way from the entrance")
        return Tried(None, "no standing room", "the robot fits nowhere from where it reaches it")

    def _near(self, ground: Ground, cells: Array) -> Iterator[Stand]:
        """Places from which the arm might do, the best first, looking at the part."""
        target = self.part.at(self.part.holds[0].point, 0.0)[:2]
        for x, y in islice(spots(self.part, cells, self.places.inside), SPOTS):
            yield Stand(np.array([x, y, np.arctan2(target[1] - y, target[0] - x)]), ground)

    def _fitting(self, stands: Iterable[Stand]) -> Iterator[Stand]:
        """Those where nothing touches the base and mast while the part moves."""
        probe, part = self.planner.probe, self.part
        values = [float(self.planner.values[k]) for k in spread(len(self.planner.values))]
        for stand in stands:
            posture = tucked(stand.pose, 0.5, 0)
            if all(probe.hit(posture, part, value) < 0 for value in values):
                yield stand


def _driven(came: Drive) -> dict[str, float]:
    """Figures of the drive."""
    return {"metres": round(came.metres, 3), "driving": round(came.seconds, 2), "touches": float(came.touches),
            "push": round(came.push, 2)}
