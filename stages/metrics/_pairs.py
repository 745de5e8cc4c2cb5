"""Which things of an apartment stand in others, however many there are."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes, Mask
from apartgen.stages.things import categories


class Rule(NamedTuple):
    """Which pairs count: those deeper than `above`, m; of those that belong together none, unless `together`."""

    above: float
    together: bool


def standing_in(things: Sequence[Box], stand: Boxes, rules: Mapping[str, Rule]) -> dict[str, Mask]:
    """For every rule, which of the things (n,) have another in theirs; `stand` is what each takes up."""
    names = sorted({o.category for o in things})
    belong = np.array([[categories.belong_together(a, b) for b in names] for a in names], bool)
    kind = np.array([names.index(o.category) for o in things], np.int64)
    hit = {name: np.zeros(len(things), bool) for name in rules}
    for i, j, depth in boxes.meeting(stand):
        apart = ~belong[kind[i], kind[j]]
        for name, rule in rules.items():
            met = (depth > rule.above) & (apart | rule.together)
            hit[name][i[met]] = hit[name][j[met]] = True
    return hit
