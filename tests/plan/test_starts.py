"""Runs of a flat with a busy hallway start from rows of rooms along a corridor that ends where one comes in."""

import numpy as np
import pytest
from plan.flats import within

from apartgen.schemas.plan import Envelope, Program, Side
from apartgen.stages.plan.corridors import along, hub
from apartgen.stages.plan.starts import start
from apartgen.stages.plan.study import archetypes

Boxes = dict[int, tuple[float, float, float, float]]


def boxes(program: Program, rng: np.random.Generator) -> Boxes:
    """The unit square cut as the tree of a start says, every room being one leaf."""
    tree = start(program, (1,) * len(program.rooms), (1.0, 1.0), rng)
    leaves, out = len(program.rooms), {}

    def area(node: int) -> float:
        return tree.share[node] if node < leaves else area(tree.nodes[node, 0]) + area(tree.nodes[node, 1])

    def cut(node: int, x0: float, y0: float, x1: float, y1: float) -> None:
        if node < leaves:
            out[int(tree.nodes[node, 0])] = x0, y0, x1, y1
            return
        left, right, upright = tree.nodes[node]
        part = area(left) / area(node)
        x, y = x0 + part * (x1 - x0), y0 + part * (y1 - y0)
        cut(left, x0, y0, x if upright else x1, y1 if upright else y)
        cut(right, x if upright else x0, y0 if upright else y, x1, y1)

    cut(int(tree.nodes[-1, 0]), 0.0, 0.0, 1.0, 1.0)
    return out


def share_at_the_door(program: Program, side: Side) -> float:
    """Share of 200 starts whose hallway touches a side."""
    hall = hub(program)
    assert hall is not None
    axis, at = {"west": (0, 0.0), "south": (1, 0.0), "east": (2, 1.0), "north": (3, 1.0)}[side]
    halls = [boxes(program, np.random.default_rng(seed))[hall] for seed in range(200)]
    return float(np.mean([abs(box[axis] - at) < 1e-9 for box in halls]))


@pytest.mark.parametrize("side", ["south", "east", "north", "west"])
def test_most_corridors_end_where_one_comes_in(side: Side) -> None:
    """Of the four sides a corridor laid at random touches a given one in half of all cases."""
    program = within(archetypes()["four_bedroom"], party_walls=[side], facades=3)
    assert share_at_the_door(program, side) > 0.7


def test_a_corridor_runs_between_neighbours_along_the_windows() -> None:
    assert along(Envelope(party_walls=["east", "west"], facades=2)) == 0
    assert along(Envelope(party_walls=["north", "south"], facades=2)) == 1
    assert along(Envelope()) is None


def test_a_studio_has_no_corridor() -> None:
    assert hub(archetypes()["studio"]) is None
    assert hub(archetypes()["four_bedroom"]) == 0
