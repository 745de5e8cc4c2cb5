"""The apartment after walkable-area optimisation."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Number, Record, Vector
from apartgen.schemas.retrieve import AssetKey, Retrieve


class Replaced(Record):
    """One step of Algorithm 2: `object` changed from one asset to a smaller one."""

    object: str
    from_: str = Field(alias="from")
    to: str | None

    model_config = Record.model_config | {"populate_by_name": True}


class Placement(Record):
    """Where an object stands, how large it is, and what it is; earlier files have no asset here."""

    center: Vector
    size: Vector
    yaw: Number
    asset: AssetKey | None = None


class Shift(Record):
    """What becomes of an object by a change of another; `after` is None where it was dropped."""

    object: str
    before: Placement
    after: Placement | None


class Step(Record):
    """One change and its reason: the target ratio ("ratio"), or the id of what could not be reached or opened.

    `after` is None where the object was dropped. `along` has what changes with it: what stands on it, or belongs to it.
    """

    action: Literal["replace", "nudge", "drop"]
    object: str
    reason: str
    before: Placement
    after: Placement | None
    along: list[Shift] = Field(default_factory=list)


class Blocked(Record):
    """A part that does not move through its whole range: a joint of an object, the `leaf` of a room door, or the `way`
    through an opening; `by` is the object or door met, `wall` or `ceiling`.
    """

    owner: str
    part: str
    by: str


class Report(Record):
    """Walkable ratio wanted, before, after and by room; `unreached` names what a robot cannot get to, `blocked` what
    does not open.
    """

    target: float
    before: float
    after: float
    rooms: dict[str, float] = Field(default_factory=dict)
    replaced: list[Replaced] = Field(default_factory=list)
    moved: list[str] = Field(default_factory=list)
    dropped: list[str] = Field(default_factory=list)
    unreached: list[str] = Field(default_factory=list)
    blocked: list[Blocked] = Field(default_factory=list)
    steps: list[Step] = Field(default_factory=list, description="every change in order")


class Walkable(Retrieve):
    """Body of a `walkable` artifact."""

    walkable: Report
