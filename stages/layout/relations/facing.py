"""Two at a table sit across from one another, else side by side, and round its corner only where nothing else goes; an
armchair may be turned from the low table towards the screen, or the sofa."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.layout.relations.company import AT, Seen
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds

CHAIR, TWO = "chair", 2
ACROSS, ABREAST = 0.2, 0.75
"""So far from its mirror image one sits who sits across, and from the other who sits beside, m."""
FACING, BESIDE, CORNER = 1.0, 0.75, 0.5
"""How good it is for two."""
TURNED, TURNS, LEAST = 0.65, (1.0, 0.6), np.radians(8)
"""Share of armchairs that stand askew where there is floor (9 of 13 in homes furnished after real ones), by shares of
the whole turn; less than so much is no turn."""
ASIDE, FARTHEST = np.radians(75), np.radians(35)
"""What lies farther aside counts as lying there; an armchair is turned no farther."""
GRAIN = 0.05
"""By so much what is cut off of the floor differs with how a thing lies over its cells, m of way."""
GROUP = (frozenset({"coffee_table"}), frozenset({"tv_stand"}), kinds.SOFAS)
"""Between the first two of these that are there it looks."""


def best_two(table: Array, chairs: Array) -> tuple[Array, float]:
    """Places of chairs (n, 7) about a table, two that go together best first, and how good these are."""
    at = _seen(table, chairs)
    pairs = [(_good(table, at[i], at[k]), -i, -k) for i in range(len(at)) for k in range(i + 1, len(at))]
    if not pairs:
        return chairs, FACING
    good, i, k = max(pairs)
    rest = [n for n in range(len(chairs)) if n not in (-i, -k)]
    return chairs[[-i, -k, *rest]], good


def company(there: Furniture, name: str, box: Array, left: Sequence[str]) -> float:
    """How good a chair's place (7,) is for two at a table: where the other one is, or will find its place; 1 for any
    other number."""
    tables = there.boxes[[kinds.basic(o) in kinds.TABLES for o in there.names]] if there.names else there.boxes
    gap = Seen(box[None], tables).gap[0] if len(tables) else np.full(1, np.inf)
    if gap.min() > AT:
        return FACING
    table = tables[gap.argmin()]
    chairs = there.boxes[[kinds.basic(o) == CHAIR for o in there.names]]
    chairs = chairs[Seen(chairs, table[None]).gap[:, 0] <= AT] if len(chairs) else chairs
    if len(chairs) + 1 + list(left).count(name) != TWO:
        return FACING
    if len(chairs):
        return _good(table, *_seen(table, np.stack([box, chairs[0]])))
    images = _images(table, box)
    return FACING if (there.prices(name, images, strict=True) < BROKEN).any() else BESIDE


def _seen(table: Array, chairs: Array) -> Array:
    """Middles of chairs in the table's frame, (n, 2)."""
    return np.asarray(Seen(chairs, table[None]).to[:, 0])


def _good(table: Array, one: Array, two: Array) -> float:
    mirrored = [np.abs(one * flip - two).max() < ACROSS for flip in ((-1, 1), (1, -1), (-1, -1))]
    if any(mirrored) and np.hypot(*(one - two)) > ABREAST:
        return FACING
    side = [np.argmax(np.abs(at) - table[3:5] / 2) for at in (one, two)]
    same = side[0] == side[1] and one[side[0]] * two[side[0]] > 0
    return BESIDE if same and np.hypot(*(one - two)) <= ABREAST + ACROSS else CORNER


def _images(table: Array, box: Array) -> Array:
    """Where one would sit across from a chair, (1, 7)."""
    out = box.copy()
    along = int(np.argmax(np.abs(_seen(table, box[None])[0]) - table[3:5] / 2))
    way = table[2] + along * np.pi / 2
    axis = np.array([np.cos(way), np.sin(way)])
    out[:2] = box[:2] - 2 * ((box[:2] - table[:2]) @ axis) * axis
    out[2] = 2 * way + np.pi - box[2]
    return np.asarray(out[None])


def askew(there: Furniture, name: str, box: Array, rng: np.random.Generator) -> Array:
    """Most armchairs (7,) turned to their group, what is then behind as near to the wall as the back was, a second as
    the first is; all else, and what would be in the way, as it is."""
    if kinds.basic(name) != "armchair" or not TABLE[name].stands.askew:
        return box
    pair = there.boxes[[kinds.basic(o) == "armchair" for o in there.names]][:1] if there.names else there.boxes
    among = abs(np.sin(2 * (pair[0, 2] - box[2]))) > np.sin(2 * LEAST) if len(pair) else rng.random() < TURNED
    if not among:
        return box
    aims = [there.boxes[[kinds.basic(o) in some for o in there.names]][:1] for some in GROUP] if there.names else []
    seen = [Seen(box[None], aim) for aim in aims if len(aim)][:2]
    off = [np.clip(np.arctan2(one.y[0, 0], one.x[0, 0]), -ASIDE, ASIDE) for one in seen]
    whole = float(np.clip(np.mean(off), -FARTHEST, FARTHEST)) if off else 0.0
    most = max(CUT, there.shuts(name, box) + GRAIN)
    for turn in (share * whole for share in TURNS):
        found = box.copy()
        behind = (box[3] * np.cos(turn) + box[4] * np.sin(abs(turn)) - box[3]) / 2
        found[:2] += behind * np.array([np.cos(box[2]), np.sin(box[2])])
        found[2] += turn
        fits = abs(turn) > LEAST and there.prices(name, found[None], strict=True)[0] < BROKEN
        if fits and there.shuts(name, found) <= most:
            return np.asarray(found)
    return box
