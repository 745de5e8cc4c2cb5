"""Units of a run change places where that leaves worktop between sink and hob."""

import numpy as np
import pytest
from rooms_for_tests import room

from apartgen.stages.layout.relations import exchange
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.use.kinds import COLD, HOT, WET

DEPTH, GAP = 0.6, 0.003
WIDTHS = {"kitchen_sink": 0.6, "oven": 0.6, "fridge": 0.6, "kitchen_base": 0.4, "kitchen_drawers": 0.8,
          "dishwasher": 0.6}


def along(names: list[str], wide: float = 6.0, start: float = 0.4) -> Furniture:
    """Units side by side at the north wall, from its west end on."""
    there, x = room(wide, 4.0), start - wide / 2
    for name in names:
        width, top = WIDTHS[name], 1.8 if name == "fridge" else 0.9
        there.add(name, np.array([x + width / 2, 2 - 0.005 - DEPTH / 2, -np.pi / 2, DEPTH, width, 0, top], np.float32))
        x += width + GAP
    return there


def settled(there: Furniture, fixed: int = 0) -> Furniture:
    return exchange.settled(there, fixed, room(6.0, 4.0).fork)


def order(there: Furniture) -> list[str]:
    """Names from west to east."""
    return [there.names[k] for k in np.argsort(there.boxes[:, 0])]


def between(names: list[str], one: frozenset[str], two: frozenset[str]) -> list[str]:
    a, b = sorted(next(k for k, name in enumerate(names) if name in group) for group in (one, two))
    return names[a + 1 : b]


RUNS = [
    ["fridge", "dishwasher", "oven", "kitchen_sink"],
    ["kitchen_sink", "oven", "kitchen_drawers", "dishwasher", "fridge"],
    ["kitchen_sink", "fridge", "oven", "kitchen_drawers", "kitchen_base"],
    ["kitchen_base", "oven", "kitchen_sink", "kitchen_drawers", "fridge"],
]


@pytest.mark.parametrize("names", RUNS)
def test_worktop_comes_between_sink_and_hob_and_nothing_tall(names: list[str]) -> None:
    before = along(names)
    after = settled(before)
    found = order(after)
    middle = between(found, WET, HOT)
    assert sorted(found) == sorted(names) and middle and not set(middle) & COLD
    assert abs(found.index("oven") - found.index("fridge")) > 1 if "fridge" in found else True


@pytest.mark.parametrize("names", RUNS)
def test_the_run_stays_where_it_is_flush_and_at_its_wall(names: list[str]) -> None:
    """Its ends, the gaps between units, their sizes and their line are those from before."""
    before, after = along(names), settled(along(names))
    ends = [(b[:, 0] + s * b[:, 4] / 2) for b in (before.boxes, after.boxes) for s in (-1, 1)]
    assert ends[0].min() == pytest.approx(ends[2].min(), abs=1e-4)
    assert ends[1].max() == pytest.approx(ends[3].max(), abs=1e-4)
    assert np.allclose(np.sort(ends[2])[1:] - np.sort(ends[3])[:-1], GAP, atol=1e-4)
    assert np.allclose(before.boxes[:, 1:], after.boxes[:, 1:], atol=1e-5) and before.names == after.names


def test_a_good_order_is_left_alone_and_so_is_what_is_given() -> None:
    good = along(["fridge", "kitchen_base", "kitchen_sink", "kitchen_drawers", "kitchen_base", "oven", "kitchen_base"])
    assert settled(good) is good
    bad = along(["kitchen_sink", "oven", "kitchen_drawers"])
    kept = settled(bad, fixed=2)
    assert np.array_equal(kept.boxes[:2], bad.boxes[:2])


def test_at_another_wall_each_takes_the_width_of_the_others_place() -> None:
    """Sink and hob alone at one wall, a dishwasher of .5 m and a cupboard at another."""
    there = along(["kitchen_sink", "oven"], start=2.0)
    west = np.array([-3 + 0.005 + DEPTH / 2, -0.6, 0.0, DEPTH, 0.5, 0.0, 0.9], np.float32)
    there.add("dishwasher", west)
    there.add("kitchen_base", west - np.array([0, 0.453, 0, 0, 0.1, 0, 0], np.float32))
    after = settled(there)
    place = dict(zip(after.names, after.boxes, strict=True))
    assert exchange.cost(after.names, after.boxes, after.space) < exchange.cost(there.names, there.boxes, there.space)
    assert len({round(float(place[name][2]), 2) for name in ("kitchen_sink", "oven")}) == 2
    assert sorted(after.boxes[:, 4].round(3)) == sorted(there.boxes[:, 4].round(3))
    for k, name in enumerate(after.names):
        rest = room(6.0, 4.0)
        for j in set(range(len(after.names))) - {k}:
            rest.add(after.names[j], after.boxes[j])
        assert rest.prices(name, after.boxes[[k]])[0] < BROKEN


def test_what_cooks_mind_by_hand() -> None:
    """Worktop of .8 m lacks a third of 1.2 m; a tall fridge stands beside the hob and between it and the sink, amid the
    run and away from all worktop; the hob is the last unit of all."""
    far = along(["kitchen_sink", "kitchen_drawers", "oven"])
    assert exchange.cost(far.names, far.boxes, far.space) == pytest.approx(
        exchange.LITTLE / 3 + exchange.AT_END, abs=1e-3)
    tall = along(["kitchen_drawers", "kitchen_base", "kitchen_sink", "fridge", "oven"])
    assert exchange.cost(tall.names, tall.boxes, tall.space) == pytest.approx(
        exchange.PARTED + exchange.BESIDE + exchange.AT_END + exchange.LANDING + exchange.AMID, abs=1e-3)
    touching = along(["kitchen_drawers", "kitchen_base", "kitchen_sink", "oven"])
    assert exchange.cost(touching.names, touching.boxes, touching.space) == pytest.approx(
        exchange.BETWEEN + exchange.AT_END, abs=1e-3)
    assert exchange.cost(["chair"], far.boxes[:1], far.space) == 0


@pytest.mark.parametrize("names, beside", [
    (["fridge", "kitchen_sink", "kitchen_drawers", "dishwasher", "oven", "kitchen_base", "kitchen_base"], True),
    (["kitchen_base", "kitchen_base", "oven", "kitchen_drawers", "dishwasher", "kitchen_sink", "fridge"], True),
    (["fridge", "kitchen_sink", "kitchen_drawers", "dishwasher", "oven", "kitchen_base"], False),
])
def test_a_fridge_has_worktop_beside_it_that_is_missed_nowhere_else(names: list[str], beside: bool) -> None:
    """Of two units beyond the hob one may go between fridge and sink; the last one keeps the hob from the end, and the
    fridge the sink from the corner."""
    found = order(settled(along(names, start=0.01)))
    at = found.index("fridge")
    assert at in (0, len(found) - 1)
    assert ({*found[max(0, at - 1) : at], *found[at + 1 : at + 2]} == {"kitchen_sink"}) != beside
    assert 0 < found.index("oven") < len(found) - 1 and len(between(found, WET, HOT)) == 2


@pytest.mark.parametrize("turned, width, name", [
    (False, 0.9, "kitchen_base"), (True, 0.9, "kitchen_corner"), (False, 1.4, "kitchen_corner")])
def test_a_corner_unit_round_which_no_run_goes_is_a_base_unit(turned: bool, width: float, name: str) -> None:
    """It stands at the west end of the north wall; the other unit goes on along that wall, or along the west wall."""
    there = room(6.0, 4.0)
    there.add("kitchen_corner", np.array([-2.99 + width / 2, 1.69, -np.pi / 2, 0.6, width, 0, 0.9], np.float32))
    beside = (-2.69, 1.08, 0.0) if turned else (-2.98 + width + 0.3, 1.69, -np.pi / 2)
    there.add("kitchen_base", np.array([*beside, 0.6, 0.6, 0, 0.9], np.float32))
    after = exchange.settled(there, 0, room(6.0, 4.0).fork)
    assert after.names == [name, "kitchen_base"] and np.allclose(after.boxes, there.boxes)
    assert exchange.settled(there, 1, room(6.0, 4.0).fork).names[0] == "kitchen_corner", "what is given stays"


def test_the_hob_does_not_stay_at_the_end_of_its_run() -> None:
    names = ["oven", "kitchen_drawers", "kitchen_sink", "kitchen_base", "fridge"]
    found = order(settled(along(names)))
    assert sorted(found) == sorted(names) and 0 < found.index("oven") < 4
    assert between(found, WET, HOT) and abs(found.index("oven") - found.index("fridge")) > 1


def test_the_sink_does_not_stay_in_the_corner() -> None:
    names = ["kitchen_sink", "kitchen_drawers", "kitchen_base", "oven", "kitchen_base", "fridge"]
    found = order(settled(along(names, start=0.01)))
    assert found.index("kitchen_sink") > 0 and 0 < found.index("oven") < 5 and between(found, WET, HOT)
    assert order(settled(along(names, start=0.5))) == names, "the end of the run is no corner"


def test_the_wider_unit_comes_between_sink_and_hob() -> None:
    names = ["kitchen_base", "kitchen_drawers", "kitchen_sink", "kitchen_base", "oven", "kitchen_drawers"]
    found = order(settled(along(names)))
    assert "kitchen_drawers" in between(found, WET, HOT) and 0 < found.index("oven") < 5


def test_the_dishwasher_comes_near_the_sink() -> None:
    """Behind the hob it is 2.2 m from it, and .4 m of base unit take its place."""
    before = along(["kitchen_sink", "kitchen_base", "kitchen_drawers", "oven", "dishwasher", "kitchen_base"])
    after = settled(before)
    names, at, wide = after.names, after.boxes[:, 0], after.boxes[:, 4]
    sink, dishes = names.index("kitchen_sink"), names.index("dishwasher")
    assert abs(float(at[sink] - at[dishes])) - float(wide[sink] + wide[dishes]) / 2 < exchange.DISHES
    assert exchange.cost(names, after.boxes, after.space) < exchange.cost(before.names, before.boxes, before.space)
