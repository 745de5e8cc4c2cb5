"""What follows a leader of a group: no table or desk is put where its chairs, no bed where its nightstands or the
wardrobe of those who sleep there, no sofa where its low table or the television before it would find no place, or would
shut a way."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

CHAIR, STAND, SEAT, LOW = "chair", "nightstand", "office_chair", "coffee_table"
ELBOW = 0.62
"""Of a table's edge each diner has, m."""
IN = 0.12
"""How far a chair is drawn under its table, m."""
OFF, ASIDE = 0.01, 0.05
"""From the wall to a nightstand's back, and from it to its bed, m."""
BEFORE = 0.36
"""From a sofa's front to its low table, m."""
MOST = 0.3
"""What a group may cut off of the floor, in metres of way."""

LEADERS = ((kinds.TABLES, CHAIR), (kinds.DOUBLE, STAND), ({"desk"}, SEAT), ({"sofa"}, LOW))
BOTH = 2
"""Two who share a bed get out at either side, which leaves places of nightstands even where none is to come."""
LATER = (
    (kinds.DOUBLE, kinds.WARDROBES, (0.6, 1.2, 2.1)),
    (kinds.BEDS - kinds.DOUBLE, kinds.WARDROBES, (0.6, 0.8, 2.1)),
    (kinds.SOFAS, {"tv_stand"}, (0.4, 1.2, 0.5)),
)
"""What comes to some wall later on: a place for one of such a size, m, is left."""
STEP, TRIED = 0.3, 3
"""From one place along a wall to the next, m; so many of the good ones are tried for the ways they leave."""


def fit(there: Furniture, name: str, box: Array, left: Sequence[str]) -> bool:
    """Whether as many followers as are `left` to come find places about a leader (7,), as far as it has places, and
    what comes to a wall later on finds one."""
    kind, group = kinds.basic(name), [(name, box)]
    follower = next((name for leaders, name in LEADERS if kind in leaders), "")
    if due := max(left.count(follower), BOTH if follower == STAND else 0):
        places = {CHAIR: _chairs, STAND: _stands, SEAT: _seat, LOW: _low_table}[follower](kind, box)
        open_ = places[there.besides(name, box).prices(follower, places, strict=follower == CHAIR) < BROKEN]
        due = min(due, len(places))
        if len(open_) < due:
            return False
        group += [(follower, place) for place in open_[:due]]
    later = _later(there, kind, group, left)
    if later is None:
        return len(group) == 1 or there.shut_by(group) < MOST
    return any(there.shut_by([*group, one]) < MOST for one in later)


def _later(there: Furniture, kind: str, group: list[tuple[str, Array]],
           left: Sequence[str]) -> list[tuple[str, Array]] | None:
    """Some places at walls of what comes there later on beside a group; None where nothing does."""
    due = ((name, size) for leaders, names, size in LATER if kind in leaders for name in left
           if kinds.basic(name) in names and not names & set(map(kinds.basic, there.names)))
    name, size = next(due, ("", (0.0, 0.0, 0.0)))
    if not name:
        return None
    for o, box in group:
        there = there.besides(o, box)
    places = _along(there.space, size)
    good = places[there.prices(name, places, strict=True) < BROKEN] if len(places) else places
    return [(name, place) for place in good[:: max(1, len(good) // TRIED)]]


def _along(space: Space, size: tuple[float, float, float]) -> Array:
    """Boxes (n, 7) of a size along all walls."""
    out = [np.zeros((0, 7))]
    for start, along, normal, length in zip(space.start, space.along, space.normal, space.length, strict=True):
        if (room := length - size[1] - 2 * OFF) >= 0:
            t = OFF + size[1] / 2 + np.linspace(0.0, room, int(np.ceil(room / STEP)) + 1)
            middle = start + t[:, None] * along + (OFF + size[0] / 2) * normal
            rest = np.broadcast_to([np.arctan2(normal[1], normal[0]), *size[:2], 0.0, size[2]], (len(t), 5))
            out.append(np.column_stack([middle, rest]))
    return np.concatenate(out).astype(np.float32)


def _chairs(kind: str, table: Array) -> Array:
    """Places of chairs, those across from one another in turn: at the long sides first."""
    depth, width, height = TABLE[CHAIR].size
    d, w = float(table[3]), float(table[4])
    many = 1 if kind == "round_table" else max(1, int(w / ELBOW))
    along = (np.arange(many) - (many - 1) / 2) * w / many
    out = [(s * (d / 2 + depth / 2 - IN), y, (s > 0) * np.pi) for y in along for s in (1.0, -1.0)]
    out += [(0.0, s * (w / 2 + depth / 2 - IN), -s * np.pi / 2) for s in (1.0, -1.0)]
    return _about(table, out, (depth, width, height))


def _stands(kind: str, bed: Array) -> Array:
    depth, width, height = TABLE[STAND].size
    back, aside = OFF + depth / 2 - float(bed[3]) / 2, float(bed[4]) / 2 + ASIDE + width / 2
    return _about(bed, [(back, s * aside, 0.0) for s in (1.0, -1.0)], (depth, width, height))


def _seat(kind: str, desk: Array) -> Array:
    size = TABLE[SEAT].size
    return _about(desk, [(float(desk[3]) / 2 + size[0] / 2 - IN, 0.0, np.pi)], size)


def _low_table(kind: str, sofa: Array) -> Array:
    size = TABLE[LOW].size
    return _about(sofa, [(float(sofa[3]) / 2 + BEFORE + size[0] / 2, 0.0, 0.0)], size)


def _about(leader: Array, places: Sequence[tuple[float, float, float]], size: tuple[float, float, float]) -> Array:
    """Boxes (n, 7) at places (x, y, yaw) in a leader's frame."""
    x, y, turn = np.array(places).T
    c, s = np.cos(leader[2]), np.sin(leader[2])
    low, n = float(leader[5]), len(x)
    rest = np.broadcast_to([*size[:2], low, low + size[2]], (n, 4))
    return np.column_stack([leader[0] + c * x - s * y, leader[1] + s * x + c * y, leader[2] + turn, rest]).astype(
        np.float32)
