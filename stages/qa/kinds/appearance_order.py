"""In which order a robot on its way first sees four things."""

from itertools import permutations

import numpy as np

from apartgen.stages.qa.drafts import Draft, some
from apartgen.stages.qa.facts import Facts

SEEN = 0.006
"""Share of a picture from which a thing counts as seen; below a fifth of it it counts as not seen."""
TEXT = "These pictures were taken one after another. In which order do these things first appear?"
FRAMES = 12
TRIES = 60


def ask(facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
    """The only ones of their names, whose first pictures are all different and before which they were not seen at all.
    """
    frames = [view.name for view in facts.render.views if view.kind == "route"]
    frames = frames[:: max(1, -(-len(frames) // FRAMES))]
    alone = [id for id in facts.names if facts.meanings[facts.objects[id].category] == 1]
    firsts = {id: k for id in alone if (k := _first(facts, frames, id)) is not None}
    drafts = []
    for _ in range(TRIES if len(firsts) >= 4 else 0):
        ids = sorted(firsts)
        four = sorted((ids[k] for k in rng.permutation(len(ids))[:4]), key=lambda id: firsts[id])
        if len({firsts[id] for id in four}) == 4:
            names = [facts.names[id] for id in four]
            orders = [", ".join(order) for order in permutations(names)]
            wrong = tuple(orders[k] for k in 1 + rng.permutation(len(orders) - 1)[:3])
            drafts.append(Draft(TEXT, orders[0], frames[: firsts[four[3]] + 1], {"order": four}, wrong, hard=1))
    return some(drafts, rng, most)


def _first(facts: Facts, frames: list[str], id: str) -> int | None:
    """The first frame that shows a thing; None where it was faintly seen before, or is cut there."""
    shares = [facts.shares[name].get(id, 0.0) for name in frames]
    first = next((k for k, share in enumerate(shares) if share > SEEN), None)
    known = first is not None and id in facts.known(frames[first])
    return first if known and max(shares[:first], default=0.0) < SEEN / 5 else None
