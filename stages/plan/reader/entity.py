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

OTHERS = {Trait.KIDS, Trait.GUEST, Trait.RELATIVE, Trait.STAFF}
"""Labels of bedrooms that are not those of whom the home is for."""

MOST = 40
"""Rooms of one home."""


@dataclass(eq=False)
class Entity:
    """One room of the home being described."""

    type: str
    exact: bool = field(default=False, kw_only=True)
    labels: set[Trait] = field(default_factory=set)
    area: float | None = None
    share: float | None = None
    factor: float = 1.0
    owner: "Entity | None" = None
    objects: list[tuple[str, int]] = field(default_factory=list)
    alike: set[str] = field(default_factory=set)
    object_count: int | None = None
    counted: bool = False
    picked: bool = False
    vague: bool = False
    spoken: bool = False
    placed: bool = False
    rank: str = ""
    name: str = ""


def whose(bedroom: Entity) -> int:
    """Rank of a bedroom: the main one, others, those of children, guests and staff."""
    return 0 if Trait.MASTER in bedroom.labels else 2 if OTHERS & bedroom.labels else 1
