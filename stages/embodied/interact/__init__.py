"""Interaction: a mobile manipulator opens every part of every articulated object in physics (SR_interact).

Each part is an episode of its own that starts with everything shut. The base stands where it can be driven to from the
entrance and touches nothing while the part moves; the arm takes hold of the handle and opens the part to 80 % of its
range. It fails when robot or part meet anything else harder than a graze, or the grip slips. Parts are pulled by
handles that fingers can close on, else by a suction cup; hinged leaves may be pushed on from behind once they stand
ajar. What the fingers hold is modelled by a ball joint that breaks at the force at which they would slip. Doors of
rooms are shut behind the robot: their leaves are left out, as are handles that are none (windows do not open).
"""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import chain, islice, tee

import numpy as np
import shapely
from shapely import Geometry

from stages import grid, polygons
from stages.boxes import Array
from stages.embodied import floor, world
from stages.embodied.interact import parts
from stages.embodied.interact.act import FRAMES, Actor, Result
from stages.embodied.interact.chains import GOAL, OPEN
from stages.embodied.interact.near import Surroundings
from stages.embodied.interact.parts import Hold, Part
from stages.embodied.interact.plan import Plan, Planner, spots, spread
from stages.embodied.interact.probe import Probe
from stages.embodied.interact.robot import NAMES, RADIUS, joint, mjcf, tucked
from stages.embodied.outcome import Failure, Outcome, Trace
from stages.embodied.world import World

SPOTS, TOGETHER = 60, 6
"""Places tried at most for a part, and how many with its usual holds before others are tried there."""
RETRIES = 2
"""How often a robot that finds nothing in its grip goes back and takes another hold."""
FAR = 100.0
"""Where the robot waits in a trace when it has no place to stand, m."""
ASTRAY = (0.01, 0.03)
"""Standard deviation of where the base comes to rest, m and rad."""


@dataclass(frozen=True)
class _Ground:
    """Points (n, 2) that the base gets to, those where it could only stand, both in the order of y; and the floor
    between the walls."""

    cells: Array
    others: Array
    inside: Geometry


@dataclass
class _Tried:
    """What was found before anything moved: a plan, or why there is none.

    `base` is where the robot stood when it found no way, `share` how far the part would have come.
    """

    plan: Plan | None = None
    failure: Failure | None = None
    reason: str = ""
    numbers: dict[str, float] = field(default_factory=dict)
    base: Array | None = None
    share: float = OPEN


def run(apartment: World, rng: np.random.Generator, only: str | None = None) -> list[Outcome]:
    """An episode for every part that opens; `only` one object's, and then with their traces.

    The apartment may hold any robot or none: it is built again with the manipulator, for every object with what is
    near it.
    """
    return [_episode(*episode, only is not None) for episode in _asked(apartment, rng, only)]


def planned(apartment: World, rng: np.random.Generator) -> Iterator[tuple[Part, Array | None, str, str]]:
    """Of every part: where the base first stands (x, y, heading), or without a plan None, the failure, and why."""
    for episode in _asked(apartment, rng, None):
        tried = _tried(*episode)
        base = None if tried.plan is None else tried.plan.base
        yield episode[1], base, tried.failure or "", tried.reason


def _asked(
    apartment: World, rng: np.random.Generator, only: str | None
) -> Iterator[tuple[Probe, Part, _Ground, np.random.Generator]]:
    """The episodes: a probe of the object's surroundings, the part, the floor, and the chance of each."""
    leaves = room_doors(apartment)
    ground = floor.survey(apartment, RADIUS, without=leaves)
    reached = grid.from_seeds(ground.free, ground.space.entry)
    points = ground.grid.centers()
    places = _Ground(points[reached], points[ground.free & ~reached], polygons.free_floor(apartment.home).buffer(0.02))
    shapely.prepare(places.inside)
    every = parts.listed(apartment)
    surroundings = Surroundings(apartment, leaves)
    own: dict[str, Probe] = {}
    for (body, link), lane in zip(every, rng.spawn(len(every)), strict=True):
        if only not in (None, body.id):
            continue
        if body.id not in own:
            mine = [moving for other, moving in every if other is body]
            own = {body.id: Probe(equipped(apartment, body.id, surroundings.far(body, mine)))}
        probe = own[body.id]
        yield probe, parts.part(probe.world, body, link), places, lane


def equipped(apartment: World, object: str, without: Collection[str]) -> World:
    """The apartment with the manipulator in it, nothing but one object's parts moving, some colliders left out."""
    return world.build(apartment.scene, apartment.mjcf, mjcf(), moving=[object], without=without, fused=True,
                       name=apartment.name, source=apartment.source)


def room_doors(apartment: World) -> frozenset[str]:
    """Names of the colliders of room doors' leaves."""
    return frozenset(
        f"{body.link_name(link)}__c{k}" for body in apartment.bodies.values() if body.category == "door"
        for link in body.links if body.kind == "door" and link.joint is not None for k in range(len(link.colliders))
    )


def _episode(
    probe: Probe, part: Part, ground: _Ground, rng: np.random.Generator, trace: bool
) -> Outcome:
    missed: list[Hold] = []
    while True:
        tried = _tried(probe, _without(part, missed), ground, rng)
        if tried.plan is None:
            shown = _shown(part, tried) if trace else None
            return _outcome(probe, part, tried.failure, tried.reason, tried.numbers, shown)
        recorded = np.append(probe.joints, part.address) if trace else None
        result = Actor(probe, part, recorded).run(tried.plan)
        hold = tried.plan.phases[1].hold
        left = min(RETRIES, len(part.holds + part.others) - 1) - len(missed)
        if not result.missed or hold is None or not left:
            break
        missed.append(hold)
    failure: Failure | None = None
    if result.trouble or result.share < OPEN:
        failure = "blocked part" if result.blocked else "controller"
    shown = Trace(joints=_names(part), times=result.times, qpos=result.qpos) if trace else None
    numbers = tried.numbers | _figures(result) | {"retries": float(len(missed))}
    return _outcome(probe, part, failure, result.trouble, numbers, shown)


def _without(part: Part, missed: list[Hold]) -> Part:
    """The part without the holds that turned out to hold nothing."""
    holds, others = ([h for h in some if not any(h is m for m in missed)] for some in (part.holds, part.others))
    return replace(part, holds=holds or others, others=others if holds else [])


def _names(part: Part) -> list[str]:
    """Joints of a trace: the robot's, then the part's."""
    return [*(joint(name) for name in NAMES), part.name]


def _shown(part: Part, tried: _Tried) -> Trace:
    """What would have happened: the part moves as far as it can, the robot waits where it would stand, or far away."""
    base = np.array([0.0, 0.0, 0.0]) + FAR if tried.base is None else tried.base
    waits = np.round(tucked(base, 0.5, 0.0), 5).tolist()
    shares = np.linspace(0, tried.share, FRAMES)
    return Trace(joints=_names(part), times=(np.arange(FRAMES) / FRAMES).tolist(),
                 qpos=[[*waits, round(float(share) * part.travel, 5)] for share in shares])


def _figures(result: Result) -> dict[str, float]:
    return {"share": round(result.share, 3), "force": round(result.force, 1), "seconds": round(result.seconds, 2)}


def _outcome(
    probe: Probe, part: Part, failure: Failure | None, reason: str, numbers: dict[str, float],
    trace: Trace | None = None,
) -> Outcome:
    return Outcome(
        apartment=probe.world.name, episode="interaction", room=part.room, object=part.object, category=part.category,
        joint=part.joint, success=failure is None, failure=failure, reason=reason, numbers=numbers, trace=trace,
    )


def _tried(probe: Probe, part: Part, ground: _Ground, rng: np.random.Generator) -> _Tried:
    """Looks for a place and a plan; says what is in the way if there is none."""
    probe.reset(part.body)
    for value in np.linspace(0, OPEN * part.travel, 17):
        met = probe.blocked(part, float(value))
        if met >= 0:
            share = float(value / part.travel)
            reason = f"meets {probe.name(met)} at {share:.0%} of its range"
            return _Tried(None, "blocked part", reason, share=share)
    probe.limit(probe.model)
    planner = Planner(probe, part)
    stands = _stands(planner, islice(spots(part, ground.cells, ground.inside), SPOTS), rng)
    places, first = 0, None
    for base in stands:
        some = chain([base], islice(stands, TOGETHER - 1))
        first, k = base if first is None else first, 0
        ways = ((part.holds, False), (part.others, False), (part.holds, True))
        # Places are looked for only once those before them have failed.
        for (holds, push), bases in zip(ways, tee(some, len(ways)), strict=True):
            for k, base in enumerate(bases, 1):
                found = planner.plan(base, holds, push)
                if found is not None:
                    return _Tried(found, numbers={"places": float(places + k), "pushed": float(push)})
        places += k
    if planner.chains.reached:
        return _Tried(None, "planner", planner.chains.complaint(), {"places": float(places)}, first)
    if any(True for _ in _stands(planner, islice(spots(part, ground.others, ground.inside), SPOTS), rng)):
        return _Tried(None, "planner", "no way from the entrance")
    return _Tried(None, "no standing room", "the robot fits nowhere from where it reaches it")


def _stands(planner: Planner, places: Iterable[Array], rng: np.random.Generator) -> Iterator[Array]:
    """Poses (x, y, heading) near the places where nothing touches the base and mast while the part moves."""
    probe, part = planner.probe, planner.part
    target = part.at(part.holds[0].point, 0.0)[:2]
    values = [float(planner.values[k]) for k in spread(len(planner.values))]
    for place in places:
        for scale in (1.0, 0.0):
            x, y = place + scale * rng.normal(0, ASTRAY[0], 2)
            heading = np.arctan2(target[1] - y, target[0] - x) + scale * rng.normal(0, ASTRAY[1])
            stands = tucked([x, y, heading], 0.5, 0)
            if all(probe.hit(stands, part, value) < 0 for value in values):
                yield stands[:3]
                break


__all__ = ["FRAMES", "GOAL", "OPEN", "equipped", "mjcf", "planned", "room_doors", "run"]
