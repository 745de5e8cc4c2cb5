"""What became of one episode."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Record

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

    @property
    def id(self) -> str:
        """Names the episode among all, as in guided-12:navigation:kitchen_1_oven_1."""
        return ":".join(part for part in (self.apartment, self.episode, self.object, self.joint) if part)
