"""One room of the home being described."""

from dataclasses import dataclass, field

DISTINCT = (
    "master",
    "guest",
    "kids",
    "relative",
    "staff",
    "small",
    "double",
    "ensuite",
    "half",
    "shower",
    "family",
    "shared_pair",
    "entrance",
    "inner",
    "eat_in",
    "size",
)
"""Labels that tell one room from another of its type."""

PAIRED = ("all", "each", "both")

MOST = 40
"""Rooms of one home."""


@dataclass(eq=False)
class Entity:
    """One room of the home being described."""

    type: str
    labels: set[str] = field(default_factory=set)
    area: float | None = None
    share: float | None = None
    factor: float = 1.0
    owner: "Entity | None" = None
    objects: list[tuple[str, int]] = field(default_factory=list)
    object_count: int | None = None
    counted: bool = False
    picked: bool = False
    vague: bool = False
    name: str = ""
