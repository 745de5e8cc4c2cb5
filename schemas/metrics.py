"""Measured figures."""

from pydantic import Field

from schemas.base import Record


class Value(Record):
    """One figure; `of` is "apartment" or a room id. None where it is undefined (nothing to measure).

    `n` is how many things a share is of; None where it is no share.
    """

    name: str
    value: float | None
    unit: str = ""
    version: str = "ours"
    of: str = "apartment"
    n: int | None = None


class Metrics(Record):
    """Body of a `metrics` artifact."""

    values: list[Value] = Field(default_factory=list)
