"""A run that lacks worktop and finds no more along its wall goes round a corner of the room: a corner unit takes the
place of the last unit, which stands beside it at the other wall then."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import company, exchange, order, runs
from apartgen.stages.layout.relations.exchange import filled
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import Array, Shell
from apartgen.stages.use import kinds
from apartgen.stages.use.rules.cook import JOINED

CORNER, ON_TOP = "kitchen_corner", 0.02
"""What is as high as the top of a unit stands on it or hangs above it, m."""
Empty = Callable[[], Furniture]


def round_corner(there: Furniture, shell: Shell, fixed: int, empty: Empty) -> Furniture:
    """The furniture with its run round a corner, if that is better for who cooks there and breaks nothing; the first
    `fixed` are given and stay."""
    if not kinds.CLOSED.isdisjoint(there.names):
        return there
    now = exchange.cost(there.names, there.boxes, there.space) - exchange.LEAST
    tries = [new for some in _last(there, fixed) for new in _with_corner(there, some, shell, empty)]
    costs = [exchange.cost(new.names, new.boxes, new.space) for new in tries]
    return tries[int(np.argmin(costs))] if costs and min(costs) < now else there


def _last(there: Furniture, fixed: int) -> Iterator[list[int]]:
    """One unit that moves, or that and one beside it without which a run can do, nothing being above it."""
    units = [k for k in range(fixed, len(there.names)) if there.names[k] in order.runs()]
    spare = [k for k in units if there.names[k] == exchange.BASE and not _above(there.boxes, k).any()]
    gap = company.Seen(there.boxes, there.boxes).gap
    for k in units:
        yield [k]
        yield from ([k, i] for i in spare if i != k and gap[k, i] <= JOINED)


def _above(boxes: Array, k: int) -> NDArray[np.bool_]:
    """What stands on a unit or hangs above its middle part."""
    x, y = runs.local(boxes[:, :2], boxes[k, :2], float(boxes[k, 2]))
    over = (np.abs(x) < boxes[k, 3] / 2) & (np.abs(y) < boxes[k, 4] / 4)
    return np.asarray(over & (boxes[:, 5] > boxes[k, 6] - ON_TOP))


def _with(box: Array, place: Array, things: Array) -> Array:
    """Things (n, 7) about a unit where that stands elsewhere, as they were to it."""
    out, turn = things.copy(), place[2] - box[2]
    x, y = runs.local(things[:, :2], box[:2], float(box[2]))
    c, s = np.cos(place[2]), np.sin(place[2])
    out[:, 0], out[:, 1], out[:, 2] = place[0] + x * c - y * s, place[1] + x * s + y * c, things[:, 2] + turn
    return out


def _with_corner(there: Furniture, some: list[int], shell: Shell, empty: Empty) -> Iterator[Furniture]:
    """The furniture without `some` units, with a corner unit and the first of them in all places that break nothing,
    and what is above that."""
    name, box = there.names[some[0]], there.boxes[some[0]]
    above = np.flatnonzero(_above(there.boxes, some[0])).tolist()
    others = [k for k in range(len(there.names)) if k not in some and k not in above]
    names, boxes = [there.names[k] for k in others], there.boxes[others]
    corners = runs.further(CORNER, runs.usual(CORNER)[None], names, boxes, shell)
    if not len(corners):
        return
    rest = filled(empty(), names, boxes)
    for corner in _good(rest, CORNER, corners):
        new = rest.fork()
        new.add(CORNER, corner)
        for place in _good(new, name, runs.further(name, box[None], [CORNER], corner[None], shell)):
            done = new.fork()
            done.add(name, place)
            hung = list(zip(above, _with(box, place, there.boxes[above]), strict=True))
            if all(done.prices(there.names[k], thing[None])[0] < BROKEN for k, thing in hung):
                yield filled(done, [there.names[k] for k, _ in hung], np.array([thing for _, thing in hung]))


def _good(there: Furniture, name: str, places: Array) -> list[Array]:
    good = places[there.prices(name, places, strict=True) < BROKEN]
    return [np.asarray(place) for place in good if there.shuts(name, place) < CUT]
