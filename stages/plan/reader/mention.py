"""What a prompt mentions: room phrases, and the items a sentence is made of."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.vocabulary import Det, Trait

OPEN_TYPES = ("living_room", "kitchen", "dining_room")

PARTITIVE = (Det.ALL, Det.EACH, Det.BOTH, Det.ONE_OF, Det.OTHER, Det.NONE)


@dataclass(eq=False)
class RoomPhrase:
    """A mention of rooms. `type` is "" for an elliptical one ("one of them") until it is resolved.

    `among` are the rooms an elliptical phrase speaks of where the sentence says so, `excluded` those it leaves out.
    `quantifier` is the determiner's value; `area` has one value, or one per room, in m², `sides` length and width in m,
    `bounds` limits of the area; `rank` is `largest` or `smallest` where a size tells which of several is meant.
    """

    type: str = ""
    labels: set[Trait] = field(default_factory=set)
    count: float | None = None
    quantifier: Det = Det.BARE
    ordinals: tuple[int, ...] = ()
    plural: bool = False
    areas: tuple[float, ...] = ()
    sides: tuple[float, ...] = ()
    bounds: tuple[tuple[str, float], ...] = ()
    share: float | None = None
    factor: float = 1.0
    rank: str = ""
    negated: bool = False
    headline: bool = False
    whole: int | None = None
    together: bool = False
    exact: bool = False
    another: bool = False
    subset: bool = False
    among: list["RoomPhrase"] = field(default_factory=list)
    excluded: list["RoomPhrase"] = field(default_factory=list)
    owned: list["RoomPhrase"] = field(default_factory=list)
    objects: list[tuple[str, int]] = field(default_factory=list)
    object_count: int | None = None
    text: str = ""

    @property
    def definite(self) -> bool:
        """Whether it speaks of rooms known already."""
        return self.quantifier in (Det.THE, *PARTITIVE)


@dataclass(frozen=True, eq=False)
class Item:
    """One element of a sentence; `kind` is room, object, objects, area, share, or the kind of a lexeme."""

    kind: str
    value: str = ""
    text: str = ""
    room: RoomPhrase | None = None
    number: float = 1.0
    values: tuple[float, ...] = ()
    joined: bool = False
    form: str = ""
    sides: tuple[float, ...] = ()
    bounds: tuple[tuple[str, float], ...] = ()


def is_mark(item: Item, marks: str) -> bool:
    """Whether the item is one of these punctuation marks."""
    return item.kind == "mark" and item.value in marks


def rooms_of(items: list[Item]) -> list[RoomPhrase]:
    """The room phrases among items."""
    return [i.room for i in items if i.room is not None]
