"""One room of the home being described."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.vocabulary import Det, Trait

DISTINCT = (
    Trait.MASTER,
    Trait.GUEST,
    Trait.KIDS,
    Trait.RELATIVE,
    Trait.STAFF,
    Trait.SMALL,
    Trait.DOUBLE,
    Trait.ENSUITE,
    Trait.HALF,
    Trait.SHOWER,
    Trait.FAMILY,
    Trait.SHARED_PAIR,
    Trait.ENTRANCE,
    Trait.INNER,
    Trait.EAT_IN,
    Trait.SIZED,
)
"""Labels that tell one room from another of its type."""

PAIRED = (Det.ALL, Det.EACH, Det.BOTH)

MOST = 40
"""Rooms of one home."""


@dataclass(eq=False)
class Entity:
    """One room of the home being described."""

    type: str
    labels: set[Trait] = field(default_factory=set)
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
