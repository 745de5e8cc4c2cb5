"""Which objects a home misses least."""

from schemas.plan import Program
from schemas.retrieve import Furnishing
from stages import footprints
from stages.walkable.site import Scene, in_room

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
    alike = sum(p.category == o.category for p in in_room(scene, o.room))
    level = 2 if o.category in ESSENTIAL else 0 if o.category in DECORATION else 1
    return max(level - (alike > 1), 0)


def spared(o: Furnishing, scene: Scene, program: Program) -> bool:
    """Whether the prompt asked for it: its room's number of objects, or this many of its category."""
    if o.room in program.counts:
        return True
    alike = sum(p.category == o.category for p in in_room(scene, o.room))
    asked = [wish for wish in program.objects if (wish.room, wish.category) == (o.room, o.category)]
    return any(alike <= wish.count for wish in asked)


def droppable(scene: Scene, program: Program) -> list[Furnishing]:
    """Obstacles that may be left out, the least important first, large before small."""
    loose = [o for o in scene if footprints.is_obstacle(o) and rank(o, scene) < 2 and not spared(o, scene, program)]
    return sorted(loose, key=lambda o: (rank(o, scene), -footprints.area(o), o.id))
