"""The episodes of an apartment as data, for other simulators and robots: what is asked, not how it was done here.

World frame: metres, radians, seconds; z up; yaw counter-clockwise about z, 0 looks along +x. They are those that
`navigate` and `interact` run with the same chance, in the same order; names are those of the exported USD and MJCF.
"""

from collections.abc import Iterable

import numpy as np
from pydantic import Field

from apartgen.schemas.base import Record
from apartgen.stages.embodied import base, interact, navigate
from apartgen.stages.embodied.drive import GRAZE
from apartgen.stages.embodied.goals import Goal
from apartgen.stages.embodied.instructions import instruction
from apartgen.stages.embodied.interact.act import GRAZE as TOUCH
from apartgen.stages.embodied.interact.parts import Part
from apartgen.stages.embodied.outcome import Failure, Outcome
from apartgen.stages.embodied.planner import Roadmap
from apartgen.stages.embodied.pursuit import XY_TOLERANCE, YAW_TOLERANCE
from apartgen.stages.embodied.world import World
from apartgen.stages.scene.scene import identifier
from apartgen.stages.space.boxes import Array

FURNITURE = "/Apartment/Furniture"
"""Where the exported USD stage has the objects."""
DECIMALS = 5
Axis = tuple[float, float, float]


class Pose(Record):
    """Where a base stands, m, and how it is turned, rad."""

    x: float
    y: float
    yaw: float


class Navigation(Record):
    """Drive from the start to the goal. Without a goal the episode has failed already, as `failure` says."""

    id: str
    room: str
    object: str
    category: str
    start: Pose | None = None
    goal: Pose | None = None
    within: float = Field(XY_TOLERANCE, description="of the goal, m")
    facing: float = Field(YAW_TOLERANCE, description="of the goal's yaw, rad")
    seconds: float | None = Field(None, description="time limit")
    shortest: float | None = Field(None, description="length of the shortest way, m")
    push: float = Field(GRAZE, description="hardest push allowed, N, mean over 50 ms")
    failure: Failure | None = None
    reason: str = ""


class Handle(Record):
    """Where a hand takes hold while the part is shut, which way its front faces, and across what fingers close."""

    point: Axis
    normal: Axis
    across: Axis
    hold: str = Field(description="the hold tried first: pinch (fingers) or cup (suction)")


class Interaction(Record):
    """Open a part, all of the apartment shut, to `share` of its range: the joint at `open_at` (m or rad) or beyond.

    `axis` and `origin` are the joint's (world). `base` is where the mobile manipulator first stands here; without
    one it found no place or no motion, as `failure` says.
    """

    id: str
    room: str
    object: str
    category: str
    joint: str
    type: str
    range: tuple[float, float]
    share: float = interact.OPEN
    open_at: float
    axis: Axis
    origin: Axis
    handle: Handle
    base: Pose | None = None
    push: float = Field(TOUCH, description="hardest push allowed on anything else, N, mean over 20 ms")
    instruction: str
    usd_object: str
    usd_joint: str
    mjcf_body: str
    mjcf_joint: str
    failure: Failure | None = None
    reason: str = ""


class Episodes(Record):
    """All of one apartment. `radius` and `height` are the base's, m; `speed` m/s, `turn` rad/s and so on its limits."""

    apartment: str
    frame: str = "metres, radians, seconds; z up; yaw counter-clockwise about z from +x"
    radius: float = base.RADIUS
    height: float = base.HEIGHT
    speed: float = base.SPEED
    turn: float = base.TURN
    acceleration: float = base.ACCELERATION
    turn_acceleration: float = base.TURN_ACCELERATION
    navigation: list[Navigation]
    interaction: list[Interaction]


def listed(apartment: World, rng: np.random.Generator) -> Episodes:
    """Every episode of a world with the base in it; places to stand are looked for, which takes most of the time."""
    ways, yaw, goals = navigate.asked(apartment, rng)
    return Episodes(
        apartment=apartment.name,
        navigation=[_navigation(apartment.name, ways, yaw, goal) for goal in goals],
        interaction=[_interaction(apartment, *found) for found in interact.planned(apartment)],
    )


def _navigation(name: str, ways: Roadmap | None, yaw: float, goal: Goal) -> Navigation:
    id = _id(name, "navigation", goal.room, goal.object, goal.category)
    known = {"id": id, "room": goal.room, "object": goal.object, "category": goal.category}
    if ways is None or goal.cell is None:
        failure = "planner" if ways is None else goal.missing
        reason = "the entrance is blocked" if ways is None else navigate.WHY[goal.missing]
        return Navigation.model_validate({**known, "failure": failure, "reason": reason})
    path = ways.path(goal.cell)
    return Navigation.model_validate({
        **known, "start": _pose([*path[0], yaw]), "goal": _pose([*path[-1], goal.yaw]),
        "seconds": round(navigate.limit(path), 2), "shortest": round(ways.shortest(goal.cell), DECIMALS),
    })


def _interaction(apartment: World, part: Part, base: Array | None, failure: str, reason: str) -> Interaction:
    body = apartment.bodies[part.object]
    link = next(link for link in body.links if link.joint is not None and link.joint.name == part.joint)
    assert link.joint is not None
    room = next(room for room in apartment.home.rooms if room.id == part.room)
    usd, first = f"{FURNITURE}/{body.name}", part.holds[0]
    return Interaction.model_validate({
        "id": _id(apartment.name, "interaction", part.room, part.object, part.category, part.joint),
        "room": part.room, "object": part.object, "category": part.category, "joint": part.joint,
        "type": link.joint.type, "range": link.joint.range, "open_at": round(interact.OPEN * part.travel, DECIMALS),
        "axis": _rounded(part.axis), "origin": _rounded(part.anchor),
        "handle": {"point": _rounded(first.point), "normal": _rounded(first.out), "across": _rounded(first.across),
                   "hold": first.kind},
        "base": None if base is None else _pose(base), "instruction": instruction(body, link, room),
        "usd_object": usd, "usd_joint": f"{usd}/Joints/{identifier(part.joint)}",
        "mjcf_body": body.name, "mjcf_joint": part.name, "failure": failure or None, "reason": reason,
    })


def _id(apartment: str, episode: str, room: str, object: str, category: str, joint: str = "") -> str:
    """The id of the record that the benchmark would make of it."""
    about = {"episode": episode, "room": room, "object": object, "category": category, "joint": joint}
    return Outcome.model_validate({"apartment": apartment, "success": False, **about}).id


def _pose(values: Iterable[float]) -> dict[str, float]:
    return {key: round(float(v), DECIMALS) for key, v in zip(("x", "y", "yaw"), values, strict=True)}


def _rounded(v: Array) -> list[float]:
    return [round(float(c), DECIMALS) + 0.0 for c in v]
