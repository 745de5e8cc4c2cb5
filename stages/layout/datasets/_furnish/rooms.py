"""What rooms of each type hold: groups in order of importance, extras by chance, after what people have.

Frequencies follow rooms that people arranged (Robot@VirtualHome, VirtualHome, iTHOR, RoboCasa; see NOTICE).
"""

from collections.abc import Callable

from apartgen.schemas.base import RoomType
from apartgen.stages.layout.datasets._furnish import (
    cooking,
    dining,
    dressing,
    entering,
    seating,
    sleeping,
    storing,
    washing,
    working,
)
from apartgen.stages.layout.datasets._furnish.household import Household, chance, one_of
from apartgen.stages.layout.datasets._furnish.space import Space

SEATING = {"tv": 0.82, "side_table": 0.62, "floor_lamp": 0.45, "armchair": 0.66, "pouffe": 0.14}
BEDDING = {"two_nightstands": 0.84, "table_lamp": 0.6, "bed_rug": 0.35, "bench": 0.12, "single_nightstand": 0.75}


def living_room(space: Space, home: Household) -> None:
    """Seating first, then a bed where there is no bedroom, a table, cabinets, a desk, plants."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.5)
    table = home.table if home.table is not None else area > 19 and chance(rng, 0.85 if area > 23 else 0.6)
    if home.bed:
        sleeping.double(space, BEDDING | {"bench": 0.0})
    first = table and chance(rng, 0.25)
    if first:
        dining.furnish(space, dining.seats_for(space, home.sleepers))
    seating.furnish(space, SEATING)
    if table and not first:
        dining.furnish(space, dining.seats_for(space, home.sleepers))
    dressing.curtains(space, 0.72)
    dressing.ceiling_lamps(space)
    eating = dining.TABLES if space.has(*dining.TABLES) else ()
    wanted = 1 + int(area > 20) + int(area > 30) + int(chance(rng, 0.4))
    for _ in range(wanted):
        name = one_of(rng, "sideboard", "bookshelf", "bookshelf", "display_cabinet", "console_table", "sideboard")
        if not space.has(name) and space.left > 2:
            near = eating if name in ("sideboard", "display_cabinet") else ()
            two = name == "bookshelf" and chance(rng, 0.35)
            storing.cabinet(space, name, 1 + int(two), near, 0.4 if name != "bookshelf" else 0.0)
    if area > 18 and chance(rng, 0.14) and space.left > 4:
        working.desk(space, small=True)
    if area > 20 and chance(rng, 0.04) and space.left > 3:
        storing.piano(space)
    for _ in range(int(rng.integers(0, 3))):
        if space.left > 1:
            storing.plant(space)
    if chance(rng, 0.2) and space.left > 1:
        dressing.shelf_above(space, one_of(rng, "sofa", "sideboard"))


def dining_room(space: Space, home: Household) -> None:
    """The table, a sideboard or display cabinet, little else."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.6)
    seats = dining.seats_for(space, home.sleepers)
    dining.furnish(space, max(4, seats) if area > 8 else seats, 0.85)
    for name in ("sideboard", "display_cabinet"):
        if chance(rng, 0.75 if name == "sideboard" else 0.4):
            storing.cabinet(space, name, lamp=0.4)
    dressing.curtains(space, 0.6)
    dressing.ceiling_lamps(space)
    if area > 15 and chance(rng, 0.25):
        working.reading(space)
    if chance(rng, 0.5):
        storing.plant(space)
    if area > 13 and chance(rng, 0.3):
        storing.cabinet(space, one_of(rng, "sideboard", "display_cabinet"))


def bedroom(space: Space, home: Household) -> None:
    """For two or for one: beds, wardrobe, then what else finds floor."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.5)
    two = area > 7.5 and (home.main or area >= 9.6) and (home.main or area > 10.5 or chance(rng, 0.7))
    if two and not home.main and area > 9 and chance(rng, 0.3):
        two = False
    if not (two and sleeping.double(space, BEDDING)):
        _young(space, two)
    storing.wardrobe(space, 2.7 if area > 13 else 2.0 if area > 9 else 1.5)
    dressing.curtains(space, 0.78)
    dressing.ceiling_lamps(space)
    if not two and not space.has("desk") and chance(rng, 0.75) or area > 12 and chance(rng, 0.26):
        working.desk(space, small=area < 12)
    if area > 9 and chance(rng, 0.45):
        storing.chest(space)
    if space.has("double_bed") and chance(rng, 0.22):
        seating.tv_before_bed(space)
    if space.has("double_bed") and area > 11 and chance(rng, 0.2) and not space.has("desk"):
        working.dressing_table(space)
    if area > 14 and chance(rng, 0.3):
        working.reading(space)
    if not two and chance(rng, 0.45):
        storing.cabinet(space, "bookshelf")
    elif area > 15 and chance(rng, 0.25):
        storing.cabinet(space, "bookshelf")
    if chance(rng, 0.35):
        storing.plant(space)
    if chance(rng, 0.1):
        storing.loose(space, "laundry_basket")
    if chance(rng, 0.2):
        dressing.on_wall(space, "wall_shelf", ("desk", "single_bed"), -0.3)


def _young(space: Space, two: bool) -> None:
    """A room for one or for children."""
    rng, area = space.rng, space.shape.area
    count = 2 if (two or area > 13) and chance(rng, 0.7) or area > 11 and chance(rng, 0.2) else 1
    if count == 2 and area < 12 and chance(rng, 0.5) and sleeping.bunk(space):
        return
    sleeping.single(space, count, BEDDING)
    if count == 1 and area > 8 and chance(rng, 0.06):
        sleeping.cot(space)


def study(space: Space, home: Household) -> None:
    """A desk or two, shelves, somewhere to sit."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.5)
    working.desk(space, 0.85, 0.6)
    if area > 11 and chance(rng, 0.25):
        working.desk(space, 0.85, 0.3)
    storing.cabinet(space, "bookshelf", int(rng.integers(1, 4)))
    if chance(rng, 0.4):
        storing.cabinet(space, one_of(rng, "filing_cabinet", "bookshelf"))
    if area > 9 and chance(rng, 0.25):
        sleeping.single(space, 1, BEDDING | {"single_nightstand": 0.0})
    elif area > 8.5 and chance(rng, 0.5):
        working.reading(space)
    dressing.curtains(space, 0.55)
    dressing.ceiling_lamps(space)
    if chance(rng, 0.5):
        storing.loose(space, "bin", -0.5, ("desk",))
    if chance(rng, 0.45):
        storing.plant(space)
    if chance(rng, 0.3):
        dressing.on_wall(space, "wall_shelf", ("desk",))


FURNISH: dict[RoomType, Callable[[Space, Household], None]] = {
    "living_room": living_room, "dining_room": dining_room, "bedroom": bedroom, "study": study,
    "kitchen": cooking.furnish, "bathroom": washing.bathroom, "utility": washing.utility,
    "hallway": entering.hallway, "closet": entering.closet, "storage": entering.storage, "balcony": entering.balcony,
}

ESSENTIAL: dict[RoomType, tuple[frozenset[str], ...]] = {
    "living_room": (frozenset({"sofa", "corner_sofa"}),),
    "dining_room": (frozenset({"dining_table", "round_table"}), frozenset({"chair"})),
    "bedroom": (frozenset({"double_bed", "single_bed", "bunk_bed"}),),
    "study": (frozenset({"desk"}), frozenset({"office_chair", "chair"})),
    "kitchen": (frozenset({"kitchen_sink"}), frozenset({"hob", "oven"})),
    "bathroom": (frozenset({"toilet", "shower", "bath"}), frozenset({"vanity"})),
    "hallway": (), "utility": (), "storage": (), "closet": (), "balcony": (),
}
"""Sets of categories of each of which a room of a type has at least one."""
