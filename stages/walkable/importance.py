"""Which objects a home misses least."""

from collections import Counter
from collections.abc import Sequence

from schemas.plan import Program
from schemas.retrieve import Furnishing
from stages import categories, footprints
from stages.walkable.site import Scene

ESSENTIAL = frozenset({
    "double_bed", "single_bed", "bunk_bed", "cot", "wardrobe", "sliding_wardrobe", "desk", "sofa", "corner_sofa",
    "dining_table", "round_table", "kitchen_base", "kitchen_sink", "kitchen_corner", "hob", "oven", "fridge", "toilet",
    "vanity", "bath", "shower", "washing_machine",
})
"""Without the only one of these a room does not do what it is for."""
VITAL = frozenset({"double_bed", "single_bed", "bunk_bed", "cot", "toilet", "kitchen_sink", "hob"})
"""Without the only one of these it is not that room any more."""
DECORATION = frozenset({
    "plant", "pouffe", "floor_lamp", "side_table", "bench", "coat_rack", "console_table", "planter", "stool", "bin",
    "laundry_basket", "ironing_board", "clothes_rail", "wall_shelf", "wall_lamp", "table_lamp",
})

STANDARD = frozenset({
    "fridge", "oven", "hob", "hood", "dishwasher", "washing_machine", "dryer", "water_heater", "toilet", "vanity",
    "bath", "shower", "radiator", "curtain",
})
"""Comes in few sizes, or in those of what it belongs to: changed last."""
SERVES = {
    "corner_sofa": "sofa", "single_bed": "double_bed", "bunk_bed": "double_bed", "round_table": "dining_table",
    "sliding_wardrobe": "wardrobe", "shower": "bath",
}
"""What does for another: where a room has both, it does not lose its use with one of them."""


def easily_smaller(o: Furnishing) -> bool:
    """Whether people would readily have a smaller one: what stands on the floor and has no standard size."""
    upright = o.category not in categories.TABLE or categories.TABLE[o.category].place == "floor"
    return upright and o.category not in STANDARD


def rank(o: Furnishing, scene: Scene) -> int:
    """0 decoration, 1 comfort, 2 essential, 3 vital; of several alike, each is comfort at most."""
    return _rank(o, _alike(scene))


def _alike(scene: Scene) -> Counter[tuple[str, str]]:
    """How many of each category stand in each room, with what does for it."""
    return Counter((o.room, _serves(o)) for o in scene)


def _serves(o: Furnishing) -> str:
    return SERVES.get(o.category, o.category)


def _rank(o: Furnishing, alike: Counter[tuple[str, str]]) -> int:
    if o.category in DECORATION:
        return 0
    if o.category not in ESSENTIAL:
        return int(alike[o.room, _serves(o)] <= 1)
    return 1 if alike[o.room, _serves(o)] > 1 else 2 + (o.category in VITAL)


def _spared(o: Furnishing, scene: Scene, program: Program) -> bool:
    """Whether the prompt asked for it: its room's number of objects, or this many of its category."""
    asked = [wish for wish in program.objects if (wish.room, wish.category) == (o.room, o.category)]
    same = sum((p.room, p.category) == (o.room, o.category) for p in scene) if asked else 0
    return o.room in program.counts or any(same <= wish.count for wish in asked)


def droppable(scene: Scene, program: Program, essential: bool = False) -> list[Furnishing]:
    """Obstacles that may be left out, the least important first, large before small.

    What the prompt asked for never is; what a room does not do without only where `essential` says so.
    """
    alike, most = _alike(scene), 3 if essential else 1
    loose = [o for o in scene if footprints.is_obstacle(o) and _rank(o, alike) <= most
             and not _spared(o, scene, program)]
    return sorted(loose, key=lambda o: (_rank(o, alike), -footprints.area(o), o.id))


def sparable(some: Sequence[Furnishing], scene: Scene, program: Program) -> list[Furnishing]:
    """Of some objects those that a room does without and nobody asked for, the least important first.

    A seat goes before the table that it belongs to, but after anything else that matters as little.
    """
    alike, pair = _alike(scene), len(some) == 2 and categories.tucks(*(o.category for o in some))
    loose = [o for o in some if _rank(o, alike) <= 1 and not _spared(o, scene, program)]
    return sorted(loose, key=lambda o: (
        0 if pair else _rank(o, alike), (o.category in categories.SEATS) != pair, footprints.area(o), o.id))
