"""Places at what an object belongs with: a chair at its table, a nightstand at its bed, a hood over the hob."""

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.projection.habits import Habit, across, habits
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE, parents, those

Array = NDArray[np.float64]
Spots = list[tuple[float, float, float, Array]]
"""Places in a companion's frame: ahead, left, turn, size."""
TUCK = 0.16
"""How far a seat goes under its table, m."""
GAP = 0.01
"""Between a seat and a table with drawers, m."""
SEAT = 0.58
"""Width of a place at a table, m."""
FLUSH = 2.0
"""A place flush beside the next unit of a run is worth a way of this many metres."""
WATCH = 6.0
"""A television across from the sofa is worth a way of this many metres."""
OFF_AXIS = 1.5
"""So much less a metre that it stands aside of where the sofa looks."""
SOFAS, SCREENS = across("of"), across("at")
BEDSIDE = those(lambda kind: bool(kind.belongs) and all(TABLE[name].is_for("sleep") for name in kind.belongs))
"""What belongs at a bed and nowhere else."""
BEDS = parents(BEDSIDE)
HUNG = those(lambda kind: kind.run == "hung")
UNITS = those(lambda kind: kind.run in ("unit", "fitted"))
LOW_RUN = UNITS | those(lambda kind: kind.run == "beside")
RUN = LOW_RUN | HUNG
"""What stands side by side without a gap."""


def beside(category: str, center: Array, size: Array, others: Boxes, names: list[str]) -> tuple[Boxes, Array]:
    """Candidate places of an object at every companion it has among `others`, and what each is worth, m."""
    at, yaw, sizes, worth = [], [], [], []
    for habit in habits().get(category, ()):
        for k, name in enumerate(names):
            if name not in habit.at:
                continue
            turn = float(others.yaw[k])
            c, s = np.cos(turn), np.sin(turn)
            for ahead, left, turned, extent in _spots(habit, category, name, size, others.size[k]):
                at.append(others.center[k, :2] + (ahead * c - left * s, ahead * s + left * c))
                yaw.append(turn + turned)
                sizes.append(extent)
                worth.append(habit.worth)
    if not at:
        return Boxes(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0)), np.zeros(0)
    found = Boxes(np.column_stack([at, np.full(len(at), center[2])]), np.array(sizes), np.array(yaw))
    return found, np.array(worth)


def bedsides(stand: str, size: Array, beds: Boxes) -> tuple[Boxes, Boxes]:
    """Where a nightstand would stand at either side of each bed's head."""
    gap = habits()[stand][0].gap
    left = np.stack([-np.sin(beds.yaw), np.cos(beds.yaw)], -1)
    back = np.stack([np.cos(beds.yaw), np.sin(beds.yaw)], -1) * (size[0] - beds.size[:, :1]) / 2
    aside = left * ((beds.size[:, 1:2] + size[1]) / 2 + gap)
    low = np.full(beds.n, size[2] / 2)
    sizes = np.broadcast_to(size, (beds.n, 3))
    one, two = (
        Boxes(np.column_stack([beds.center[:, :2] + back + sign * aside, low]), sizes, beds.yaw) for sign in (1, -1)
    )
    return one, two


def around(size: Array, tables: Boxes) -> list[Boxes]:
    """Seats about each table, (n,) boxes a seat, as many as fit the first one."""
    spots = _seats(size, tables.size[0], TUCK, all_round=True)
    c, s = np.cos(tables.yaw), np.sin(tables.yaw)
    return [
        Boxes(
            np.column_stack([
                tables.center[:, 0] + ahead * c - left * s,
                tables.center[:, 1] + ahead * s + left * c,
                np.full(tables.n, size[2] / 2),
            ]),
            np.broadcast_to(extent, (tables.n, 3)),
            tables.yaw + turn,
        )
        for ahead, left, turn, extent in spots
    ]


def long_enough(table: str, size: Array, seats: int) -> Array:
    """A table's size, as wide as so many seats need, where there are such tables of that width."""
    widest, width = TABLE[table].max[1], float(size[1])
    ends = 2 * max(1, int(size[0] / SEAT))
    needed = SEAT * np.ceil((seats - ends) / 2) + GAP
    return np.array([size[0], min(max(width, needed), max(width, widest)), size[2]])


def in_run(category: str, found: Boxes, others: Boxes, names: list[str]) -> NDArray[np.bool_]:
    """Which candidate places (n,) stand flush beside a unit of the same run, backs in line."""
    units = np.array([name in RUN and (name in HUNG) == (category in HUNG) for name in names], bool)
    if category not in RUN or not units.any():
        return np.zeros(found.n, bool)
    row = others.take(units)
    heading = np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)[:, None]
    offset = row.center[None, :, :2] - found.center[:, None, :2]
    ahead = (offset * heading).sum(-1) - (row.size[:, 0] - found.size[:, None, 0]) / 2
    aside = np.abs(offset[..., 1] * heading[..., 0] - offset[..., 0] * heading[..., 1])
    gap = aside - (row.size[:, 1] + found.size[:, None, 1]) / 2
    aligned = np.cos(row.yaw[None] - found.yaw[:, None]) > 0.999
    return np.asarray((aligned & (np.abs(ahead) < 0.03) & (np.abs(gap) < 0.02)).any(1))


def watched(found: Boxes, others: Boxes, names: list[str]) -> Array:
    """What each place (n,) of a television is worth to those who sit on the sofas, m."""
    sofas = others.take(np.array([name in SOFAS for name in names], bool))
    if not sofas.n:
        return np.zeros(found.n)
    offset = sofas.center[None, :, :2] - found.center[:, None, :2]
    away = np.linalg.norm(offset, axis=-1)
    toward = offset / np.maximum(away, 1e-6)[..., None]
    ahead = (toward * np.stack([np.cos(found.yaw), np.sin(found.yaw)], -1)[:, None]).sum(-1)
    met = -(toward * np.stack([np.cos(sofas.yaw), np.sin(sofas.yaw)], -1)[None]).sum(-1)
    seen = (ahead > np.cos(np.deg2rad(40))) & (away > 1.4)
    # Straight ahead is best, from the side better than not at all; nobody turns round for it.
    least = np.cos(np.deg2rad(50))
    aside = np.abs(away * np.sqrt(np.maximum(1 - met**2, 0)))
    view = np.where(met > least, 0.5 + 0.5 * (met - least) / (1 - least), np.where(met > 0, 0.3, 0.0))
    return np.asarray((seen * (WATCH * view - OFF_AXIS * np.minimum(aside, 1.0))).max(1).clip(0))


def _spots(habit: Habit, category: str, partner: str, size: Array, extent: Array) -> Spots:
    match habit.how:
        case "seat" if TABLE[partner].stands.round:
            far = extent[:2].max() / 2 + size[0] / 2 - TUCK
            angles = np.arange(12) * np.pi / 6
            return [(far * float(np.cos(a)), far * float(np.sin(a)), float(a) + np.pi, size) for a in angles]
        case "seat":
            table = TABLE[partner]
            return _seats(size, extent, -GAP if table.opens else TUCK, all_round=table.stands.all_round)
        case "before":
            return [((extent[0] + size[0]) / 2 + habit.gap, 0.0, 0.0, size)]
        case "facing":
            far = (extent[1] + size[0]) / 2 + habit.gap
            return [(0.0, far, -np.pi / 2, size), (0.0, -far, np.pi / 2, size)]
        case "opposite":
            middle = (extent[0] + size[0]) / 2 + habit.gap
            return [(middle + d, aside, np.pi, size) for d in (0.0, -0.5, 0.5, -1.0, 1.0) for aside in (0.0, 0.4, -0.4)]
        case "beside":
            back, far = (size[0] - extent[0]) / 2, (extent[1] + size[1]) / 2 + habit.gap
            return [(back, far, 0.0, size), (back, -far, 0.0, size)]
        case "above":
            if habit.fit:
                width = float(np.clip(extent[1], TABLE[category].min[1], TABLE[category].max[1]))
                size = np.array([size[0], width, size[2]])
            return [((size[0] - extent[0]) / 2, 0.0, 0.0, size)]
        case "flanks":
            back, far = (size[0] - extent[0]) / 2, extent[1] / 2 + habit.gap
            return [(back, far, 0.0, size), (back, -far, 0.0, size)]
        case "under":
            return _under(category, size, extent, habit.gap, partner in BEDS)
        case _:
            return [(0.0, 0.0, 0.0, size)]


def _under(category: str, size: Array, extent: Array, gap: float, bed: bool) -> Spots:
    """Beneath the whole of a table, beneath the foot of a bed, or along its side; smaller where there is less room."""
    low, high = np.array(TABLE[category].min), np.array(TABLE[category].max)
    spots: Spots = []
    for share in (1.0, 0.8, 0.6, 0.35)[: 3 if bed else 4]:
        around = np.clip(np.array([*(extent[:2] + 2 * gap * share), size[2]]), low, high)
        if not bed:
            spots.append((0.0, 0.0, 0.0, around))
            continue
        across = np.maximum(np.array([size[0] * share, around[1], size[2]]), low)
        ahead, slide = (extent[0] - across[0]) / 2 + gap * share, (across[1] - extent[1]) / 2
        spots += [(ahead, side * slide, 0.0, across) for side in (0.0, 1.0, -1.0)]
        along = np.maximum(np.array([*(size[:2] * share), size[2]]), low)
        far = (extent[1] + along[0]) / 2 - 0.1
        spots += [(0.0, side * far, np.pi / 2, along) for side in (1.0, -1.0)]
    return spots


def _seats(size: Array, extent: Array, tuck: float, all_round: bool) -> Spots:
    """Seats along the front of a table, and along its other sides where people sit all round; facing it."""
    spots: Spots = []
    for angle in np.arange(4 if all_round else 1) * np.pi / 2:
        far, wide = (extent[0], extent[1]) if angle % np.pi < 0.1 else (extent[1], extent[0])
        seats = max(1, int(wide / SEAT))
        out = far / 2 + size[0] / 2 - tuck
        c, s = float(np.cos(angle)), float(np.sin(angle))
        for aside in (np.arange(seats) - (seats - 1) / 2) * wide / seats:
            spots.append((out * c - aside * s, out * s + aside * c, float(angle) + np.pi, size))
    return spots
