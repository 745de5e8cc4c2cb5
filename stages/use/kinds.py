"""Kinds of furniture by what people do at them: the one place where rules of use name categories."""

DOUBLE = frozenset({"double_bed"})
BEDS = frozenset({"double_bed", "single_bed", "bunk_bed", "cot"})
SOFAS = frozenset({"sofa", "corner_sofa"})
EASY = SOFAS | {"armchair"}
"""What one sits in to talk or to watch."""
TABLES = frozenset({"dining_table", "round_table"})
COUNTERS = frozenset({"island", "kitchen_base", "kitchen_drawers"})
DESKS = frozenset({"desk", "dressing_table", "workbench"})
CHAIRS = frozenset({"chair", "office_chair", "balcony_chair"})
DINERS = frozenset({"chair", "office_chair", "balcony_chair", "stool", "bench", "armchair"})
"""What one may sit on at a table."""
SMALL_SEATS = frozenset({"stool", "pouffe", "bench"})
SCREENS = frozenset({"tv_stand", "tv"})
CASES = frozenset({
    "wardrobe", "sliding_wardrobe", "chest", "bookshelf", "shelving", "filing_cabinet", "sideboard", "display_cabinet",
    "shoe_cabinet", "console_table",
})
"""What stands at a wall and is used from its front."""
CLOTHES = frozenset({"wardrobe", "sliding_wardrobe", "chest", "clothes_rail"})
BEFORE_A_SEAT = frozenset({"coffee_table", "side_table", "pouffe", "floor_lamp", "plant", "rug", "bench"})
"""What does not wall a sofa in, though it stands before it."""
WORKTOPS = frozenset({"kitchen_base", "kitchen_drawers", "kitchen_corner", "dishwasher", "washing_machine"})
WET, HOT, COLD = frozenset({"kitchen_sink"}), frozenset({"hob", "oven"}), frozenset({"fridge"})
RUN = WORKTOPS | WET | HOT | COLD
HUNG = frozenset({"wall_unit", "hood"})
FIXTURES = {"toilet": 0.53, "vanity": 0.53, "bath": 0.53, "shower": 0.61}
"""Least free depth before fixtures of a bathroom, m (NKBA bathroom guideline 4)."""
