"""The apartment after walkable-area optimisation."""

from pydantic import Field

from schemas.base import Record
from schemas.retrieve import Retrieve


class Replaced(Record):
    """One step of Algorithm 2: `object` changed from one asset to a smaller one."""

    object: str
    from_: str = Field(alias="from")
    to: str | None

    model_config = Record.model_config | {"populate_by_name": True}


class Report(Record):
    """Walkable ratio wanted, before, after and by room; `unreached` names what a robot cannot get to."""

    target: float
    before: float
    after: float
    rooms: dict[str, float] = Field(default_factory=dict)
    replaced: list[Replaced] = Field(default_factory=list)
    moved: list[str] = Field(default_factory=list)
    dropped: list[str] = Field(default_factory=list)
    unreached: list[str] = Field(default_factory=list)


class Walkable(Retrieve):
    """Body of a `walkable` artifact."""

    walkable: Report
