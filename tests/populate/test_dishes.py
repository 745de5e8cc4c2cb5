"""Bread lies on a board and fruit on a tray: beside each other, within its rim, on what it is solid with."""

import numpy as np
import pytest
import shapely
from inhabited import corners, furnished, library, lived_in, things

from apartgen.stages.populate import arrange, rules
from apartgen.stages.populate.boards import Board
from apartgen.stages.things import small
from apartgen.stages.things.receptacles import Receptacle
from apartgen.stages.things.solids import bounds

SERVED = {(name, rule.dish) for lines in rules.table().values() for rule in lines if rule.dish for name in rule.put}


def board(deep=0.6, wide=0.8, room=3.0):
    owner = next(o for o in furnished().objects if o.category == "sideboard")
    return Board(owner, Receptacle("top_0", "top", (-deep / 2, -wide / 2), (deep / 2, wide / 2), 0.45, room),
                 np.zeros((0, 5)))


def dished(name, dish, n, seed, on):
    rng = np.random.default_rng(seed)
    below = small.drawn(small.TABLE[dish], rng)
    designs = [small.drawn(small.TABLE[name], rng) for _ in range(n)]
    return arrange.dished(below, designs, on, "any", 0.3, rng)


def outline(put):
    d, w, _ = put.design.size
    c, s = np.cos(put.spot.yaw), np.sin(put.spot.yaw)
    sides = np.array([[-d, -w], [d, -w], [d, w], [-d, w]]) / 2
    return shapely.Polygon(sides @ [[c, s], [-s, c]] + [put.spot.x, put.spot.y])


@pytest.mark.parametrize("name, dish", sorted(SERVED))
def test_what_lies_on_a_dish_lies_within_it_side_by_side(name, dish):
    for seed in range(30):
        below, *rest = dished(name, dish, 1 + seed % 5, seed, board())
        assert rest and all(put.under == 0 for put in rest) and below.under == -1
        # A loaf may be as long as its board, and then lies across its edge by a finger's breadth.
        assert all(outline(put).difference(outline(below).buffer(0.005)).is_empty for put in rest), seed
        for k, put in enumerate(rest):
            assert all(outline(put).distance(outline(other)) > 0.01 for other in rest[:k])


@pytest.mark.parametrize("dish", sorted({dish for _, dish in SERVED}))
def test_what_lies_on_a_dish_lies_on_what_it_is_solid_with(dish):
    rng = np.random.default_rng(3)
    for _ in range(10):
        design = small.drawn(small.TABLE[dish], rng)
        (link,) = library().load_asset("parametric", design.id()).links
        middle = [top for (x0, y0, _), (x1, y1, top) in bounds(link.colliders) if x0 < 0 < x1 and y0 < 0 < y1]
        assert max(middle) + design.size[2] / 2 == pytest.approx(design.kind.bears * design.size[2], abs=1e-6)


def test_nothing_is_put_where_the_dish_or_what_is_on_it_has_no_room():
    assert dished("apple", "tray", 4, 0, board(0.2, 0.3)) == [] == dished("apple", "tray", 4, 0, board(room=0.05))


@pytest.mark.parametrize("seed", range(3))
def test_in_a_home_bread_and_fruit_lie_on_dishes_or_in_the_fridge(seed):
    home = lived_in(seed)
    by_id = {o.id: o for o in home.objects}
    for o in things(home):
        if any(o.category == name for name, _ in SERVED) and by_id[o.in_.object].category != "fridge":
            below = by_id[o.on]
            assert (o.category, below.category) in SERVED
            assert shapely.Polygon(corners(below)).buffer(0.005).contains(shapely.Polygon(corners(o)))
