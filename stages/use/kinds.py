"""Kinds of furniture by what people do at them: the one place where rules of use name sets of categories."""

from functools import cache

from apartgen.stages.things.categories import TABLE, those, used_for

DOUBLE = frozenset({"double_bed"})
BEDS = used_for("sleep")
EASY = used_for("lounge")
"""What one sits in to talk or to watch."""
SOFAS = frozenset({"sofa", "corner_sofa"})
TABLES = used_for("dine")
COUNTERS = TABLES | {"island"}
"""What one sits at on a stool."""
TABLE_TOPS = COUNTERS | {"balcony_table"}
DESKS = used_for("work")
CHAIRS = frozenset({"chair", "office_chair", "balcony_chair"})
SMALL_SEATS = frozenset({"stool", "pouffe", "bench"})
DINERS = CHAIRS | {"stool", "bench", "armchair"}
"""What one may sit on at a table."""
MOVED = those(lambda kind: kind.loose) | those(lambda kind: kind.place == "flat")
"""What one pushes aside, or steps on."""
CLOTHES = used_for("dress")
WARDROBES = frozenset({"wardrobe", "sliding_wardrobe"})
HANGING = WARDROBES | {"clothes_rail"}
"""What clothes hang in."""
COATS = HANGING | {"coat_rack"}
CASES = CLOTHES | {
    "bookshelf", "shelving", "filing_cabinet", "sideboard", "display_cabinet", "shoe_cabinet", "console_table",
}
"""What stands at a wall and is used from its front."""
BEDSIDE = frozenset({"nightstand", "side_table"})
BESIDE_A_BED = BEDSIDE | {"floor_lamp", "rug", "pouffe"}
BEFORE_A_SEAT = frozenset({"coffee_table", "side_table", "pouffe", "floor_lamp", "plant", "rug", "bench"})
"""What does not wall a sofa in, though it stands before it."""
WET, HOT, COLD = used_for("rinse"), used_for("cook"), used_for("cool")
WORKTOPS = frozenset({"kitchen_base", "kitchen_drawers", "kitchen_corner", "dishwasher", "washing_machine"})
RUN = WORKTOPS | WET | HOT | COLD
CLOSED = those(lambda kind: kind.run == "unit" and not kind.articulated)
"""Units that nobody stands before: they fill a corner."""
MACHINES = used_for("launder")
FIXTURES = {"toilet": 0.53, "vanity": 0.53, "bath": 0.53, "shower": 0.61}
"""Least free depth before fixtures of a bathroom, m (NKBA bathroom guideline 4)."""
ON_THE_FLOOR = those(lambda kind: kind.place == "floor")
SLENDER = frozenset({"plant", "floor_lamp", "coat_rack"})
"""Light passes by it."""


@cache
def basic(category: str) -> str:
    """The category that a newcomer is like, by whose rules it is used; its own name where it is like none."""
    return TABLE[category].lineage[-1] if category in TABLE else category
