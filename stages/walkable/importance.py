"""Which objects a home misses least."""

from collections import Counter

from schemas.plan import Program
from schemas.retrieve import Furnishing
from stages import footprints
from stages.walkable.site import Scene

ESSENTIAL = frozenset({
    "double_bed", "single_bed", "bunk_bed", "cot", "wardrobe", "sliding_wardrobe", "desk", "sofa", "corner_sofa",
    "dining_table", "round_table", "kitchen_base", "kitchen_sink", "kitchen_corner", "hob", "oven", "fridge", "toilet",
    "vanity", "bath", "shower", "washing_machine",
})
"""Without the only one of these a room does not do what it is for."""
DECORATION = frozenset({
    "plant", "pouffe", "floor_lamp", "side_table", "bench", "coat_rack", "console_table", "planter", "stool", "bin",
    "laundry_basket", "ironing_board", "clothes_rail", "wall_shelf", "wall_lamp", "table_lamp",
})


def rank(o: Furnishing, scene: Scene) -> int:
    """0 decoration, 1 comfort, 2 essential; one of several alike counts one less."""
    return _rank(o, _alike(scene))


def _alike(scene: Scene) -> Counter[tuple[str, str]]:
    """How many of each category stand in each room."""
    return Counter((o.room, o.category) for o in scene)


def _rank(o: Furnishing, alike: Counter[tuple[str, str]]) -> int:
    level = 2 if o.category in ESSENTIAL else 0 if o.category in DECORATION else 1
    return max(level - (alike[o.room, o.category] > 1), 0)


def _spared(o: Furnishing, alike: Counter[tuple[str, str]], program: Program) -> bool:
    """Whether the prompt asked for it: its room's number of objects, or this many of its category."""
    asked = [wish for wish in program.objects if (wish.room, wish.category) == (o.room, o.category)]
    return o.room in program.counts or any(alike[o.room, o.category] <= wish.count for wish in asked)


def droppable(scene: Scene, program: Program) -> list[Furnishing]:
    """Obstacles that may be left out, the least important first, large before small."""
    alike = _alike(scene)
    loose = [o for o in scene if footprints.is_obstacle(o) and _rank(o, alike) < 2 and not _spared(o, alike, program)]
    return sorted(loose, key=lambda o: (_rank(o, alike), -footprints.area(o), o.id))
