"""What became of one episode."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Record
from apartgen.stages.space.boxes import Array

RATE = 20
"""Moments of a course a second."""

Failure = Literal["blocked part", "no standing room", "planner", "controller"]
"""Why an episode failed.

blocked part: the part meets something on its way · no standing room: nowhere to stand in front of the object ·
planner: no way from the entrance to there · controller: a way was known, but was not driven or the part not opened.
"""


class Trace(Record):
    """What moved: `qpos[k]` holds at `times[k]` (s) the positions of the named joints, one after another."""

    joints: list[str]
    times: list[float] = Field(default_factory=list)
    qpos: list[list[float]] = Field(default_factory=list)


class Course(Record):
    """What a policy would have been shown and have done, `RATE` times a second: `state[k]` of the robot, `around[k]` of
    what its task is about, and the `action[k]` that was commanded then.
    """

    state: list[list[float]] = Field(default_factory=list)
    around: list[list[float]] = Field(default_factory=list)
    action: list[list[float]] = Field(default_factory=list)

    def add(self, state: Array, around: Array, action: Array) -> None:
        """A moment more."""
        for held, values in ((self.state, state), (self.around, around), (self.action, action)):
            held.append([round(float(v), 5) for v in values])


class Outcome(Record):
    """One episode: in which apartment, for which object, how it ended and why, its figures and how to show it."""

    apartment: str = ""
    episode: Literal["navigation", "interaction"]
    room: str
    object: str
    category: str
    joint: str = ""
    success: bool
    failure: Failure | None = None
    reason: str = Field("", description="the failure in a few words")
    numbers: dict[str, float] = Field(default_factory=dict)
    trace: Trace | None = None
    course: Course | None = None

    @property
    def id(self) -> str:
        """Names the episode among all, as in guided-12:navigation:kitchen_1_oven_1."""
        return ":".join(part for part in (self.apartment, self.episode, self.object, self.joint) if part)
