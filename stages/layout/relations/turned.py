"""A run that lacks worktop and finds no more along its wall goes round a corner of the room: a corner unit takes the
place of the last unit, which stands beside it at the other wall then."""

from collections.abc import Callable, Iterator

import numpy as np

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
    """One unit that moves and has nothing above it, or that and one beside it without which a run can do."""
    boxes, gap = there.boxes, company.Seen(there.boxes, there.boxes).gap
    bare = [not ((gap[k] <= 0) & (boxes[:, 5] > box[6] - ON_TOP)).any() for k, box in enumerate(boxes)]
    units = [k for k in range(fixed, len(bare)) if there.names[k] in order.runs() and bare[k]]
    for k in units:
        yield [k]
        yield from ([k, i] for i in units if i != k and there.names[i] == exchange.BASE and gap[k, i] <= JOINED)


def _with_corner(there: Furniture, some: list[int], shell: Shell, empty: Empty) -> Iterator[Furniture]:
    """The furniture without `some` units, with a corner unit and the first of them in all places that break nothing."""
    name, box = there.names[some[0]], there.boxes[some[0]]
    others = [k for k in range(len(there.names)) if k not in some]
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
            yield done


def _good(there: Furniture, name: str, places: Array) -> list[Array]:
    good = places[there.prices(name, places, strict=True) < BROKEN]
    return [np.asarray(place) for place in good if there.shuts(name, place) < CUT]
