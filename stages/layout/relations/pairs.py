"""Two who share a bed have the same at both sides of it: two small tables where only one nightstand finds a place."""

from collections.abc import Callable

import numpy as np

from apartgen.stages.layout.relations.company import Seen
from apartgen.stages.layout.relations.exchange import filled
from apartgen.stages.layout.relations.runs import local
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.use import kinds

STAND, TABLE = "nightstand", "side_table"


def matched(there: Furniture, fixed: int, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with a small table like the last thing, if that is one, for the nightstand across the bed of two,
    where it breaks nothing; the first `fixed` are given and stay."""
    names, boxes = there.names, there.boxes
    if names[-1] != TABLE:
        return there
    for bed in (box for name, box in zip(names, boxes, strict=True) if kinds.basic(name) in kinds.DOUBLE):
        one = _across(bed, boxes[-1])
        near = Seen(one[None], boxes).gap[0] == 0
        k = next((k for k in range(fixed, len(names)) if names[k] == STAND and near[k]
                  and Seen(boxes[[k]], bed[None]).at_head()[0, 0]), None)
        if k is not None:
            return _with(there, k, one, empty)
    return there


def _across(bed: Array, box: Array) -> Array:
    """A box (7,) mirrored about the axis of a bed (7,), looking the same way."""
    _, y = local(box[None, :2], bed[:2], float(bed[2]))
    out = box.copy()
    out[:2] -= 2 * float(y[0]) * np.array([-np.sin(bed[2]), np.cos(bed[2])])
    return out


def _with(there: Furniture, k: int, one: Array, empty: Callable[[], Furniture]) -> Furniture:
    """The furniture with a small table in the place of the object of that index, if it can stand there."""
    rest = filled(empty(), there.names[:k] + there.names[k + 1 :], np.delete(there.boxes, k, 0))
    if rest.prices(TABLE, one[None], strict=True)[0] >= BROKEN or rest.shuts(TABLE, one) >= CUT:
        return there
    names, boxes = list(there.names), there.boxes.copy()
    names[k], boxes[k] = TABLE, one
    return filled(empty(), names, boxes)
