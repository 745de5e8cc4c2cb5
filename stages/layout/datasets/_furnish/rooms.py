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
from apartgen.stages.layout.datasets._furnish.household import Household, one_of
from apartgen.stages.layout.datasets._furnish.space import Space


def living_room(space: Space, home: Household) -> None:
    """Seating first, then a bed where there is no bedroom, a table, cabinets, a desk, plants."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.5)
    dressing.curtains(space, 0.82)
    table = home.table if home.table is not None else area > 17 and space.wants("table", 0.88 if area > 21 else 0.6)
    if home.bed:
        sleeping.double(space, bench=False)
        space.need(storing.wardrobe(space, 2.0 if area > 26 else 1.5), 0.8)
    first = table and rng.random() < (0.2 if home.sleepers <= 4 else 0.4)
    if first:
        _table(space, home)
    if space.lost:
        return
    space.need(seating.furnish(space, table and not first and area < 36), 3)
    if space.lost:
        return
    if table and not first:
        _table(space, home)
    if space.lost:
        return
    seating.complete(space)
    dressing.ceiling_lamps(space)
    more = int(area > 22 and space.wants("one cabinet more", 0.55)) + int(area > 32)
    _cabinets(space, int(space.wants("cabinet", 0.7)) + more)
    if area > 18 and space.left > 4:
        space.wish("desk", 0.13, lambda: working.desk(space, small=True))
    if area > 21 and space.left > 1:
        space.wish("reading", 0.22, lambda: working.reading(space))
    if area > 20 and space.left > 3:
        space.wish("piano", 0.04, lambda: storing.piano(space))
    for k in range(2):
        if space.left > 1:
            space.wish(f"plant {k}", 0.36, lambda: storing.plant(space))
    if space.left > 1:
        space.wish("shelf", 0.2, lambda: dressing.shelf_above(space, one_of(rng, "sofa", "sideboard")))


def _table(space: Space, home: Household) -> None:
    space.need(dining.furnish(space, dining.seats_for(space, home.sleepers)), 1.2)


def _cabinets(space: Space, count: int) -> None:
    """So many, many of them alike; those for the table stand near it."""
    rng = space.rng
    eating = dining.TABLES if space.has(*dining.TABLES) else ()
    alike = one_of(rng, "sideboard", "bookshelf", "bookshelf", "display_cabinet")
    while count > 0 and space.left > 2:
        other = one_of(rng, "sideboard", "bookshelf", "display_cabinet", "console_table")
        name = alike if rng.random() < 0.65 else other
        two = count > 1 and name in ("bookshelf", "display_cabinet") and rng.random() < 0.6
        near = eating if name in ("sideboard", "display_cabinet") else ()
        storing.cabinet(space, name, 1 + int(two), near, 0.4 if name in ("sideboard", "console_table") else 0.0)
        count -= 1 + int(two)


def dining_room(space: Space, home: Household) -> None:
    """The table, a sideboard or display cabinet, little else."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.6)
    seats = dining.seats_for(space, home.sleepers)
    space.need(dining.furnish(space, max(4, seats) if area > 8 else seats, 0.85))
    for name, share in (("sideboard", 0.75), ("display_cabinet", 0.4)):
        space.wish(name, share, lambda name=name: storing.cabinet(space, name, lamp=0.4))  # type: ignore[misc]
    dressing.curtains(space, 0.6)
    dressing.ceiling_lamps(space)
    if area > 15:
        space.wish("armchair", 0.25, lambda: working.reading(space))
    space.wish("plant", 0.5, lambda: storing.plant(space))
    if area > 13:
        space.wish("one more", 0.35, lambda: storing.cabinet(space, one_of(rng, "sideboard", "display_cabinet")))


def bedroom(space: Space, home: Household) -> None:
    """For two or for one: beds, wardrobe, then what else finds floor."""
    area = space.shape.area
    dressing.radiators(space, 0.5)
    dressing.curtains(space, 0.86)
    two = area > 8.2 if home.main else area > 9 and space.wants("double bed", 0.75 if area > 10.5 else 0.5)
    if not (two and sleeping.double(space)):
        space.need(not two, 3)
        _young(space, two)
    pair = space.has("double_bed")
    if space.lost:
        return
    if pair:
        space.wish("tv", 0.3, lambda: sleeping.tv_before_bed(space))
    space.need(storing.wardrobe(space, 2.7 if area > 13 else 2.0 if area > 9.5 else 1.5), 2)
    if space.lost:
        return
    dressing.ceiling_lamps(space)
    space.wish("desk", 0.36 * (area > 11) if pair else 0.75, lambda: working.desk(space, small=area < 12))
    space.wish("chest", 0.42 if area > 9 else 0.2, lambda: storing.chest(space))
    if pair and area > 11 and not space.has("desk"):
        space.wish("dressing table", 0.22, lambda: working.dressing_table(space))
    space.wish("armchair", 0.42 if area > 13.5 else 0.0, lambda: working.reading(space))
    shelves = 0.45 if not pair else 0.22 if area > 13 else 0.05
    space.wish("bookshelf", shelves, lambda: storing.cabinet(space, "bookshelf"))
    space.wish("plant", 0.3, lambda: storing.plant(space))
    if not space.has("mirror"):
        space.wish("mirror", 0.25, lambda: dressing.on_wall(space, "mirror", ("wardrobe", "chest")))
    space.wish("basket", 0.1, lambda: storing.loose(space, "laundry_basket"))
    space.wish("shelf", 0.2, lambda: dressing.on_wall(space, "wall_shelf", ("desk", "single_bed"), -0.3))


def _young(space: Space, two: bool) -> None:
    """A room for one or for children."""
    area = space.shape.area
    count = 1 + int(space.wants("two beds", 0.65 if two or area > 13 else 0.2 if area > 11 else 0.0))
    if count == 2 and area < 12.5 and space.wants("bunk bed", 0.5) and sleeping.bunk(space):
        return
    placed = sleeping.single(space, count)
    space.need(placed == count, count - placed)
    if count == 1 and area > 8:
        space.wish("cot", 0.06, lambda: sleeping.cot(space))


def study(space: Space, home: Household) -> None:
    """A desk or two, shelves, somewhere to sit."""
    rng, area = space.rng, space.shape.area
    dressing.radiators(space, 0.5)
    working.desk(space, 0.85, 0.6)
    if area > 11:
        space.wish("second desk", 0.25, lambda: working.desk(space, 0.85, 0.3))
    space.need(storing.cabinet(space, "bookshelf", 1 + int(3 * rng.random() ** 1.5)))
    space.wish("cabinet", 0.4, lambda: storing.cabinet(space, one_of(rng, "filing_cabinet", "bookshelf")))
    if area > 9 and space.wants("guest", 0.25):
        sleeping.single(space, 1, 0.0)
    elif area > 8.5:
        space.wish("armchair", 0.5, lambda: working.reading(space))
    dressing.curtains(space, 0.55)
    dressing.ceiling_lamps(space)
    space.wish("bin", 0.5, lambda: storing.loose(space, "bin", -0.5, ("desk",)))
    space.wish("plant", 0.45, lambda: storing.plant(space))
    space.wish("shelf", 0.3, lambda: dressing.on_wall(space, "wall_shelf", ("desk",)))


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
    "bathroom": (frozenset({"toilet"}), frozenset({"vanity"})),
    "hallway": (), "utility": (), "storage": (), "closet": (), "balcony": (),
}
"""Sets of categories of each of which a room of a type has at least one."""
