"""Interaction: a mobile manipulator opens every part of every articulated object in physics (SR_interact).

Each part is an episode of its own that starts with everything shut. The base is driven from the entrance to where it
can stand and touches nothing while the part moves; the arm takes hold of the handle and opens the part to 80 % of its
range, against friction. It fails when the base meets anything harder than a graze on its way, robot or part do
afterwards, or the grip slips. Parts are pulled by handles that fingers can close on, else by a suction cup; hinged
leaves may be pushed on from behind once they stand ajar. What the fingers hold is modelled by a ball joint that breaks
at the force at which they would slip. Once the robot is there, doors of rooms are shut behind it: their leaves are
left out, as are handles that are none (windows do not open).
"""

from collections.abc import Collection, Iterator
from dataclasses import replace

import numpy as np
import shapely

from apartgen.stages.embodied import world
from apartgen.stages.embodied.drive import Drive
from apartgen.stages.embodied.interact import parts
from apartgen.stages.embodied.interact.act import FRAMES, Actor, Result
from apartgen.stages.embodied.interact.chains import GOAL, OPEN
from apartgen.stages.embodied.interact.ground import Ground
from apartgen.stages.embodied.interact.near import Surroundings
from apartgen.stages.embodied.interact.parts import Hold, Part
from apartgen.stages.embodied.interact.probe import Probe
from apartgen.stages.embodied.interact.robot import NAMES, joint, mjcf, tucked
from apartgen.stages.embodied.interact.stand import Places, Tried, tried
from apartgen.stages.embodied.outcome import Course, Failure, Outcome, Trace
from apartgen.stages.embodied.world import World
from apartgen.stages.space import polygons
from apartgen.stages.space.boxes import Array

RETRIES = 2
"""How often a robot that finds nothing in its grip goes back and takes another hold."""
FAR = 100.0
"""Where the robot waits in a trace when it has no place to stand, m."""
ARRIVES = 3.0
"""How much of its drive a trace shows, s."""


def run(apartment: World, only: str | None = None) -> list[Outcome]:
    """An episode for every part that opens; `only` one object's, and then with their traces.

    The apartment may hold any robot or none: it is built again with the base, and for every object with the
    manipulator and what is near it.
    """
    return [_episode(*episode, only is not None) for episode in _asked(apartment, only)]


def planned(apartment: World) -> Iterator[tuple[Part, Array | None, str, str]]:
    """Of every part: where the base stands (x, y, heading), or without a plan None, the failure, and why."""
    for episode in _asked(apartment, None):
        found = tried(*episode)
        yield episode[1], None if found.plan is None else found.plan.base, found.failure or "", found.reason


def _asked(apartment: World, only: str | None) -> Iterator[tuple[Probe, Part, Places]]:
    """The episodes: a probe of the object's surroundings, the part, and the places."""
    leaves = room_doors(apartment)
    open_ = Ground(apartment)
    grounds = [open_, Ground(apartment, leaves, open_)] if leaves else [open_]
    inside = polygons.free_floor(apartment.home).buffer(0.02)
    shapely.prepare(inside)
    every = parts.listed(apartment)
    surroundings = Surroundings(apartment, leaves)
    own: dict[str, tuple[Probe, Places]] = {}
    for body, link in every:
        if only not in (None, body.id):
            continue
        if body.id not in own:
            mine = [moving for other, moving in every if other is body]
            probe = Probe(equipped(apartment, body.id, surroundings.far(body, mine)))
            own = {body.id: (probe, Places(grounds, inside))}
        probe, places = own[body.id]
        yield probe, parts.part(probe.world, body, link), places


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


def _episode(probe: Probe, part: Part, places: Places, trace: bool) -> Outcome:
    missed: list[Hold] = []
    while True:
        found = tried(probe, _without(part, missed), places)
        if found.plan is None:
            shown = _shown(part, found) if trace else None
            return _outcome(probe, part, found.failure, found.reason, found.numbers, shown)
        recorded = np.append(probe.joints, part.address) if trace else None
        result = Actor(probe, part, recorded).run(found.plan)
        hold = found.plan.phases[1].hold
        left = min(RETRIES, len(part.holds + part.others) - 1) - len(missed)
        if not result.missed or hold is None or not left:
            break
        missed.append(hold)
    failure: Failure | None = None
    if result.trouble or result.share < OPEN:
        failure = "blocked part" if result.blocked else "controller"
    shown = _acted(part, found, result) if trace else None
    numbers = found.numbers | _figures(result) | {"retries": float(len(missed))}
    return _outcome(probe, part, failure, result.trouble, numbers, shown, result.course)


def _without(part: Part, missed: list[Hold]) -> Part:
    """The part without the holds that turned out to hold nothing."""
    holds, others = ([h for h in some if not any(h is m for m in missed)] for some in (part.holds, part.others))
    return replace(part, holds=holds or others, others=others if holds else [])


def _names(part: Part) -> list[str]:
    """Joints of a trace: the robot's, then the part's."""
    return [*(joint(name) for name in NAMES), part.name]


def _shown(part: Part, found: Tried) -> Trace:
    """The drive that failed; or what would have happened: the part moves as far as it can, the robot waits where it
    would stand, or far away."""
    if found.came is not None:
        times, driven = _drive(found.came)
        moved = [[*tucked(pose, 0.5, 0.0), 0.0] for pose in driven]
        return Trace(joints=_names(part), times=times.tolist(), qpos=np.round(moved, 5).tolist())
    base = np.array([0.0, 0.0, 0.0]) + FAR if found.base is None else found.base
    waits = np.round(tucked(base, 0.5, 0.0), 5).tolist()
    shares = np.linspace(0, found.share, FRAMES)
    return Trace(joints=_names(part), times=(np.arange(FRAMES) / FRAMES).tolist(),
                 qpos=[[*waits, round(float(share) * part.travel, 5)] for share in shares])


def _acted(part: Part, found: Tried, result: Result) -> Trace:
    """The last of the drive, the arm as it is at first, and all that it does then."""
    assert found.plan is not None and found.came is not None
    times, driven = _drive(found.came)
    shown = np.arange(max(0.0, times[-1] - ARRIVES), times[-1], 1 / FRAMES)
    ready = found.plan.phases[0].stops[0].posture[3:]
    came = [[*(np.interp(t, times, column) for column in driven.T), *ready, 0.0] for t in shown]
    return Trace(joints=_names(part), times=[*np.round(shown - times[-1], 4).tolist(), *result.times],
                 qpos=np.round(came, 5).tolist() + result.qpos)


def _drive(came: Drive) -> tuple[Array, Array]:
    """Times (n,) and poses (n, 3) of a drive, headings going on from one another."""
    x, y, _, w, _, _, z = np.array(came.trace.qpos).T
    poses = np.vstack([np.stack([x, y, 2 * np.arctan2(z, w)], 1), came.pose])
    poses[:, 2] = np.unwrap(poses[:, 2])
    return np.array([*came.trace.times, came.seconds]), poses


def _figures(result: Result) -> dict[str, float]:
    return {"share": round(result.share, 3), "force": round(result.force, 1), "seconds": round(result.seconds, 2)}


def _outcome(
    probe: Probe, part: Part, failure: Failure | None, reason: str, numbers: dict[str, float],
    trace: Trace | None = None, course: Course | None = None,
) -> Outcome:
    return Outcome(
        apartment=probe.world.name, episode="interaction", room=part.room, object=part.object, category=part.category,
        joint=part.joint, success=failure is None, failure=failure, reason=reason, numbers=numbers, trace=trace,
        course=course,
    )


__all__ = ["FRAMES", "GOAL", "OPEN", "equipped", "mjcf", "planned", "room_doors", "run"]
