"""Units of a run change places: what is drawn one after another cannot know what comes later, so that the last one may
find only a place where it is in the way of another, as a sink beside the hob.

In one line two change places, or one is put elsewhere, each as wide as it is, what is between moving up; round a corner
each takes the width of the other's place.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, pairwise

import numpy as np

from apartgen.stages.layout.projection.space import Space
from apartgen.stages.layout.relations import company, order, views
from apartgen.stages.layout.relations.hung import cornered, lit
from apartgen.stages.layout.relations.runs import local
from apartgen.stages.layout.relations.standing import BROKEN, CUT, WIDE, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use import kinds
from apartgen.stages.use.rules.cook import JOINED, PUT_DOWN, TALL, TOP

BETWEEN, NARROW, PARTED, BESIDE, ILL, SINK, LITTLE, AT_END, APART = 1.0, 0.25, 0.5, 0.5, 0.5, 0.2, 0.8, 0.3, 0.2
LANDING, LANDED, AMID = 0.18, 0.3, 0.2
"""Costs: no worktop between sink and hob, a narrow piece of it, something tall between them, a tall unit beside the
hob, a hob in a corner or before a window, a sink in a corner, no worktop of full length beside either, a hob at the
end of its run, each metre of too many from the dishwasher to the sink; and no worktop right beside the fridge, so wide
at least, m, to put down what is taken out (NKBA kitchen guideline 16 asks for .38 at its handle), or units at both its
sides."""
DISHES = 0.91
"""The dishwasher is no farther from the sink, m (NKBA kitchen guideline 13)."""
ROUNDS = 3
"""How often units change places, at most."""
IN_LINE, SAME = 0.1, 0.01
"""Backs in one line are no farther apart, m, and look the same way within, rad."""
BASE, TURNED = "kitchen_base", 0.5
"""What a corner unit is where it is in no corner, and the sine from which on units look another way."""
LEAST, TINY = 0.01, 1e-4
"""What is no gain, and no move, m."""


def settled(there: Furniture, fixed: int, empty: Callable[[], Furniture], counted: bool = False) -> Furniture:
    """The furniture with units of its run in a better order, if there is one that breaks nothing; the first `fixed` are
    given and stay. A corner unit round which no run goes is a base unit, unless the number of these is `counted`."""
    there = there if counted else _straight(there, fixed, empty)
    for _ in range(ROUNDS):
        now = cost(there.names, there.boxes, there.space)
        if now < LEAST:
            break
        tries = list(_moved(there, fixed))
        costs = np.array([cost(there.names, boxes, there.space) for boxes in tries])
        better = (tries[k] for k in np.argsort(costs, kind="stable").tolist() if costs[k] < now - LEAST)
        found = next((new for boxes in better if (new := valid(there, boxes, empty)) is not None), None)
        if found is None:
            break
        there = found
    return there


def _straight(there: Furniture, fixed: int, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with base units where corner units have no unit beside them that looks another way."""
    names, boxes = list(there.names), there.boxes
    gap, yaw = company.Seen(boxes, boxes).gap, boxes[:, 2]
    units = np.array([name in order.runs() for name in names])
    turned = np.abs(np.sin(yaw[:, None] - yaw)) > TURNED
    for k in range(fixed, len(names)):
        fits = TABLE[BASE].min[1] <= boxes[k, 4] <= TABLE[BASE].max[1]
        if names[k] in kinds.CLOSED and fits and not (units & turned[k] & (gap[k] <= JOINED)).any():
            names[k] = BASE
    return there if names == there.names else filled(empty(), names, boxes)


def at_best(there: Furniture, fixed: int) -> float:
    """The least cost with two units in one another's place, or one put elsewhere in its line."""
    now = cost(there.names, there.boxes, there.space)
    return min((cost(there.names, boxes, there.space) for boxes in _moved(there, fixed)), default=now)


def cost(names: Sequence[str], boxes: Array, space: Space) -> float:
    """What cooks would mind in the order of units."""
    basic = [kinds.basic(name) for name in names]
    wet = [k for k, o in enumerate(basic) if o in kinds.WET]
    hot = [k for k, o in enumerate(basic) if o in kinds.HOT and boxes[k, 6] < TALL]
    cold = [k for k, o in enumerate(basic) if o in kinds.COLD and boxes[k, 6] > TALL]
    if not wet or not hot:
        return 0.0
    gap: list[list[float]] = company.Seen(boxes, boxes).gap.tolist()
    total = LITTLE * max(0.0, TOP - _worktop(basic, gap, boxes, [*wet, *hot])) / TOP
    apart = [gap[i][k] for i in wet for k in hot]
    total += (BETWEEN - NARROW) * sum(far < PUT_DOWN for far in apart) + NARROW * sum(far < WIDE for far in apart)
    total += BESIDE * sum(gap[i][k] <= JOINED for i in cold for k in hot)
    tops = [k for k, o in enumerate(basic) if o in kinds.WORKTOPS and boxes[k, 4] > LANDED - TINY]
    total += LANDING * sum(all(gap[i][k] > JOINED for k in tops) for i in cold)
    units = [k for k, name in enumerate(names) if name in order.runs()]
    beside = {i: sum(k != i and gap[i][k] <= JOINED for k in units) for i in (*hot, *cold)}
    total += AT_END * sum(beside[i] < 2 for i in hot) + AMID * sum(beside[i] > 1 for i in cold)
    for wash in (k for k, name in enumerate(names) if name == "dishwasher"):
        total += APART * max(0.0, min(gap[i][wash] for i in wet) - DISHES)
    if cold:
        total += PARTED * sum(int(views.crossed(boxes[[i]], boxes[[k]], boxes[cold]).sum()) for i in wet for k in hot)
    corner = cornered(boxes[[*wet, *hot]], space)
    total += SINK * int(corner[: len(wet)].sum())
    return float(total) + ILL * int((corner[len(wet) :] | lit(boxes[hot], space)).sum())


def lacks_worktop(names: Sequence[str], boxes: Array) -> bool:
    """Whether one cooks there and has too little of it in one piece beside sink and hob."""
    basic = [kinds.basic(name) for name in names]
    wet = [k for k, o in enumerate(basic) if o in kinds.WET]
    hot = [k for k, o in enumerate(basic) if o in kinds.HOT and boxes[k, 6] < TALL]
    gap: list[list[float]] = company.Seen(boxes, boxes).gap.tolist()
    return bool(wet and hot) and _worktop(basic, gap, boxes, [*wet, *hot]) < TOP - LEAST


def _worktop(basic: list[str], gap: list[list[float]], boxes: Array, ends: list[int]) -> float:
    """The longest piece of worktop beside one of `ends`, m."""
    tops, most = [k for k, o in enumerate(basic) if o in kinds.WORKTOPS], 0.0
    while tops:
        piece = [tops.pop()]
        for k in piece:  # which grows
            near = [j for j in tops if gap[k][j] <= JOINED]
            piece += near
            tops = [j for j in tops if j not in near]
        if any(gap[k][i] <= JOINED for k in piece for i in ends):
            most = max(most, float(boxes[piece, 4].sum()))
    return most


def _moved(there: Furniture, fixed: int) -> Iterator[Array]:
    """All boxes (n, 7), with two units in one another's place, or one put in before or behind another of its line."""
    names, boxes = there.names, there.boxes
    some = [k for k in range(fixed, len(names)) if names[k] in order.runs() - kinds.CLOSED]
    for i, k in combinations(some, 2):
        if _line(boxes[i], boxes[k]):
            yield from _in_line(boxes, i, k, some)
        elif all(TABLE[names[a]].min[1] <= boxes[b, 4] <= TABLE[names[a]].max[1] for a, b in ((i, k), (k, i))):
            out = boxes.copy()
            out[i], out[k] = _at(boxes[i], boxes[k]), _at(boxes[k], boxes[i])
            yield out


def _line(one: Array, two: Array) -> bool:
    x, _ = local(two[None, :2], one[:2], float(one[2]))
    turn = (one[2] - two[2] + np.pi) % (2 * np.pi) - np.pi
    return bool(abs(turn) < SAME and abs(float(x[0]) - (two[3] - one[3]) / 2) < IN_LINE)


def _at(box: Array, place: Array) -> Array:
    """A unit in the place of another one: its back where that one's was, as wide as that one."""
    out = place.copy()
    ahead = (box[3] - place[3]) / 2
    out[:2] += ahead * np.array([np.cos(place[2]), np.sin(place[2])])
    out[3], out[5:] = box[3], box[5:]
    return out


def _in_line(boxes: Array, i: int, k: int, some: list[int]) -> Iterator[Array]:
    """Of one line, two that change places, and either one moved to the other's, what is between them moving up."""
    yaw = float(boxes[i, 2])
    along = np.array([-np.sin(yaw), np.cos(yaw)])
    at, half = boxes[:, :2] @ along, boxes[:, 4] / 2
    low, high = sorted((i, k), key=lambda n: at[n])
    row = sorted((n for n in some if at[low] <= at[n] <= at[high] and _line(boxes[i], boxes[n])), key=lambda n: at[n])
    gaps = [at[b] - half[b] - at[a] - half[a] for a, b in pairwise(row)]
    for new in ([row[-1], *row[1:-1], row[0]], *([[*row[1:], row[0]], [row[-1], *row[:-1]]] if len(row) > 2 else [])):
        edge, out = at[low] - half[low], boxes.copy()
        for n, space in zip(new, [*gaps, 0.0], strict=True):
            out[n, :2] += (edge + half[n] - at[n]) * along
            edge += boxes[n, 4] + space
        yield out


def valid(there: Furniture, boxes: Array, empty: Callable[[], Furniture]) -> Furniture | None:
    """The furniture with those units moved that stand elsewhere now; None where one breaks something there."""
    moved = (np.abs(boxes - there.boxes) > TINY).any(1)
    rest = empty()
    for k in np.flatnonzero(~moved):
        rest.add(there.names[k], there.boxes[k])
    for k in np.flatnonzero(moved):
        name, box = there.names[k], boxes[k]
        if rest.prices(name, box[None], loose=True)[0] >= BROKEN or rest.shuts(name, box) >= CUT:
            return None
        rest.add(name, box)
    return filled(empty(), there.names, boxes)


def filled(room: Furniture, names: Sequence[str], boxes: Array) -> Furniture:
    """A room with all of this in it."""
    for name, box in zip(names, boxes, strict=True):
        room.add(name, box)
    return room
