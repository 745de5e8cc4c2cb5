"""Places at what an object belongs with: a chair at its table, a nightstand at its bed, a coffee table at its sofa."""

import numpy as np
from numpy.typing import NDArray

from stages.boxes import Boxes
from stages.categories import TABLE

Array = NDArray[np.float64]
PULL = 0.8
"""A place at the partner is worth a way of this many metres, and more to what is of no use elsewhere."""
STRONG = {"chair": 5.0, "office_chair": 5.0, "stool": 5.0, "balcony_chair": 5.0, "nightstand": 3.0, "coffee_table": 1.6}
TUCK = 0.16
"""How far a seat goes under its table, m."""
GAP = 0.01
"""Between a seat and a table with drawers, m."""
SEAT = 0.58
"""Width of a place at a table, m."""
AHEAD = {"coffee_table": 0.42, "bench": 0.03}
"""Gap to the front of what it stands before, m."""
BEDSIDE = 0.01
FLUSH = 0.5
"""A place flush beside the next unit of a run is worth a way of this many metres."""
TABLES = ("dining_table", "island", "balcony_table")
PARTNERS = {
    "chair": ("dining_table", "round_table", "desk", "dressing_table"),
    "office_chair": ("desk",),
    "stool": ("island", "dressing_table", "dining_table"),
    "balcony_chair": ("balcony_table",),
    "coffee_table": ("sofa", "corner_sofa"),
    "nightstand": ("double_bed", "single_bed"),
    "bench": ("double_bed",),
}
RUN = frozenset(
    {
        "kitchen_base",
        "kitchen_drawers",
        "kitchen_sink",
        "kitchen_corner",
        "hob",
        "oven",
        "dishwasher",
        "fridge",
        "washing_machine",
        "dryer",
        "wall_unit",
        "hood",
    }
)
"""What stands side by side without a gap."""
HUNG = frozenset({"wall_unit", "hood"})


def beside(category: str, center: Array, size: Array, others: Boxes, names: list[str]) -> Boxes:
    """Candidate places of an object at every partner it has among `others`; none gives an empty set."""
    found = [
        _at(category, name, size, others.center[k, :2], others.size[k], float(others.yaw[k]))
        for k, name in enumerate(names)
        if belongs_to(category, name)
    ]
    if not found:
        return Boxes(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))
    at, yaw = np.concatenate([f[0] for f in found]), np.concatenate([f[1] for f in found])
    return Boxes(np.column_stack([at, np.full(len(at), center[2])]), np.broadcast_to(size, (len(at), 3)), yaw)


def bedsides(size: Array, beds: Boxes) -> tuple[Boxes, Boxes]:
    """Where a nightstand would stand at either side of each bed's head."""
    left = np.stack([-np.sin(beds.yaw), np.cos(beds.yaw)], -1)
    back = np.stack([np.cos(beds.yaw), np.sin(beds.yaw)], -1) * (size[0] - beds.size[:, :1]) / 2
    aside = left * ((beds.size[:, 1:2] + size[1]) / 2 + BEDSIDE)
    low = np.full(beds.n, size[2] / 2)
    sizes = np.broadcast_to(size, (beds.n, 3))
    one, two = (
        Boxes(np.column_stack([beds.center[:, :2] + back + sign * aside, low]), sizes, beds.yaw) for sign in (1, -1)
    )
    return one, two


def belongs_to(category: str, other: str) -> bool:
    """Whether an object of a category takes its place from one of another."""
    return other in PARTNERS.get(category, ())


def pull(category: str) -> float:
    """What a place at the partner is worth, m."""
    return STRONG.get(category, PULL)


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


def _at(category: str, partner: str, size: Array, at: Array, extent: Array, turn: float) -> tuple[Array, Array]:
    if category in AHEAD:
        local, yaw = np.array([[(extent[0] + size[0]) / 2 + AHEAD[category], 0.0]]), np.zeros(1)
    elif category == "nightstand":
        aside = (extent[1] + size[1]) / 2 + BEDSIDE
        back = (size[0] - extent[0]) / 2
        local, yaw = np.array([[back, aside], [back, -aside]]), np.zeros(2)
    elif partner == "round_table":
        angle = np.arange(12) * np.pi / 6
        far = extent[:2].max() / 2 + size[0] / 2 - TUCK
        local, yaw = far * np.stack([np.cos(angle), np.sin(angle)], -1), angle + np.pi
    else:
        tuck = -GAP if TABLE[partner].opens else TUCK
        local, yaw = _seats(size, extent, tuck, all_round=partner in TABLES)
    c, s = np.cos(turn), np.sin(turn)
    return at + local @ np.array([[c, s], [-s, c]]), yaw + turn


def _seats(size: Array, extent: Array, tuck: float, all_round: bool) -> tuple[Array, Array]:
    """Seats along the front of a table, and along its other sides where people sit all round; facing it."""
    local, yaw = [], []
    for angle in np.arange(4 if all_round else 1) * np.pi / 2:
        far, wide = (extent[0], extent[1]) if angle % np.pi < 0.1 else (extent[1], extent[0])
        seats = max(1, int(wide / SEAT))
        aside = (np.arange(seats) - (seats - 1) / 2) * wide / seats
        out = far / 2 + size[0] / 2 - tuck
        direction, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        local.append(out * direction + aside[:, None] * across)
        yaw.append(np.full(seats, angle + np.pi))
    return np.concatenate(local), np.concatenate(yaw)
