"""Floor plans furnished by the layout model's own weights: what constraints and the choice among its samples left.

Weights that learn from these rooms have seen where a thing stands that leaves a place to what comes after it: expert
iteration (Anthony et al. 2017, arXiv:1705.08439). `homes(root)` furnishes every plan artifact (`*.json`) below a
folder.
"""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

from apartgen.schemas.layout import Layout
from apartgen.stages import seeds
from apartgen.stages.layout import choice
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.datasets import furnisher
from apartgen.stages.layout.relations import home

MINDED = 1.0
"""Energy of a room from which nothing is to be learned."""


def homes(root: Path | None, seed: int = 0, times: int = 1) -> Iterator[Layout]:
    """Every plan below `root` in name order, furnished `times` times, on all cores; BadInput for what is no plan."""
    yield from furnisher.each(root, "sampled", partial(_furnished, seed=seed, times=times))


def _furnished(path: Path, seed: int, times: int) -> list[Layout]:
    """One plan, furnished so many times; rooms that came out badly are empty."""
    plan = furnisher.read(path)
    made = [home.furnished(plan, LayoutConfig(threads=1), seeds.drawn(seed + k, "layout", seeds.plan_digest(plan)))[0]
            for k in range(times)]
    return [_good(one) for one in made]


def _good(layout: Layout) -> Layout:
    """The home with nothing in its rooms of too much energy."""
    bad = {room.id for room in layout.rooms if choice.cost(layout, room.id, layout.objects) > MINDED}
    return layout.model_copy(update={"objects": [o for o in layout.objects if o.room not in bad]})
