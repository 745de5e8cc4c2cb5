"""Measured figures."""

from typing import Self

from pydantic import Field

from apartgen.schemas.base import Record
from apartgen.schemas.errors import near


class Value(Record):
    """One figure; `of` is "apartment" or a room id. None where it is undefined (nothing to measure).

    `n` is how many things a share, or scenes a comparison, is of; None where it is neither. `low` and `high` are the
    ends of a 95 % interval, where there is one.
    """

    name: str
    value: float | None
    unit: str = ""
    version: str = "ours"
    of: str = "apartment"
    n: int | None = None
    low: float | None = None
    high: float | None = None

    def __new__(cls, *_: object, **given: object) -> Self:
        """TypeError for a field that there is not, where one is written in code; in files those are read over."""
        if strange := [name for name in given if name not in cls.model_fields]:
            raise TypeError(f"Value has no field {strange[0]!r}; {near(strange[0], cls.model_fields)}")
        return super().__new__(cls)


class Metrics(Record):
    """Body of a `metrics` artifact."""

    values: list[Value] = Field(default_factory=list)
    notes: list[str] = Field(default_factory=list, description="how figures came about")
