"""The words that phrases are marked with: traits of rooms, determiners, relations between rooms."""

from enum import StrEnum


class Trait(StrEnum):
    """What a phrase says of its rooms, beside areas and numbers."""

    MASTER = "master"
    GUEST = "guest"
    KIDS = "kids"
    RELATIVE = "relative"
    STAFF = "staff"
    SMALL = "small"
    DOUBLE = "double"
    SUITE = "suite"
    ENSUITE = "ensuite"
    MAYBE_ENSUITE = "ensuite?"
    """Of `one of them ensuite`: a bathroom, or a bedroom with one."""
    OWN = "own"
    HALF = "half"
    SHOWER = "shower"
    FAMILY = "family"
    SHARED = "shared"
    SHARED_PAIR = "shared_pair"
    ENTRANCE = "entrance"
    INNER = "inner"
    CENTRAL = "central"
    EAT_IN = "eat_in"
    OPEN = "open"
    SEPARATE = "separate"
    ADJOINING = "adjoining"
    EQUAL = "equal"
    SIZED = "size"
    """Of `the largest`: told from others by its size alone."""
    HALLS = "halls"
    """Chinese counts of halls."""
    PLACED = "placed"
    """Of `no bathroom off the hallway`: denied there only."""
    LOFT = "loft"


class Det(StrEnum):
    """Determiners, by what they say of which rooms are meant."""

    BARE = ""
    THE = "the"
    A = "a"
    ALL = "all"
    EACH = "each"
    BOTH = "both"
    NONE = "none"
    ONE_OF = "one_of"
    OTHER = "other"
    ANOTHER = "another"
    OWN = "own"
    SEVERAL = "several"


class Relation(StrEnum):
    """What one room is to another."""

    DOOR = "door"
    ONLY = "only"
    """A door, and no other one."""
    OPEN = "open"
    """One space, without a wall."""
    NEAR = "near"
    SHARE = "share"
    SERVE = "serve"
    USES = "uses"
    OWN = "own"
    HAS = "has"
    NOT = "not"
    """No door."""
    APART = "apart"
    BETWEEN = "between"
    TO = "to"
    IN = "in"
    GAP = "gap"
    """A verb left out: `…, the dining room from the living room`."""
    SAME = "same"
    """As was said before: `…, as is the bathroom`."""
    CHAIN = "chain"
    COMPARE = "compare"
    EQUAL = "equal"


OPPOSITE = ("opposite", "across from", "gegenuber", "en face", "enfrente", "frente")
"""How words begin that say of neighbours that they face one another, and nothing of a common wall."""


EACH_OTHER = "connected to each other"
"""What is said of rooms of one phrase, of which the first has a door to the second."""
