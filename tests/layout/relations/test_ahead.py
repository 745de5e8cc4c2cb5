"""A run of units leaves room for those that it cannot do without."""

import numpy as np
import pytest

from apartgen.schemas.layout import Box, Layout
from apartgen.stages.layout.datasets import single_rooms
from apartgen.stages.layout.datasets.furnisher import furnish
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import ahead, order, runs
from apartgen.stages.layout.relations.ahead import Ahead
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import Shell, shell
from apartgen.stages.layout.rooms import of_plan


def kitchen(seed: int) -> tuple[list[tuple[str, np.ndarray]], Furniture, Shell]:
    """Units of a furnished kitchen as the sampler has them, the empty room and its walls."""
    plan = single_rooms.draw(np.random.default_rng([5, seed]), "kitchen")
    arrays = of_plan(plan)
    origin = arrays.origin[0]
    home = Layout(**dict(plan), objects=furnish(plan, np.random.default_rng([6, seed])))

    def row(o: Box) -> np.ndarray:
        low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
        return np.array([o.center[0] - origin[0], o.center[1] - origin[1], o.yaw, *o.size[:2], low, high], np.float32)

    units = [(o.category, row(o)) for o in home.objects if o.category in order.runs()]
    return units, Furniture(space_of(arrays, 0)), shell(arrays, 0)


@pytest.mark.parametrize("seed", range(10))
def test_what_stood_in_a_run_finds_its_place_again(seed: int) -> None:
    units, empty, walls = kitchen(seed)
    wide = [k for k, (name, box) in enumerate(units) if name in ("fridge", "hob") and box[4] >= 0.6]
    for gone in (k for k in wide if empty.prices(units[k][0], units[k][1][None])[0] < BROKEN):
        rest, there = [unit for k, unit in enumerate(units) if k != gone], empty
        for name, box in rest[:-1]:
            there = there.besides(name, box)
        assert Ahead(there, [units[gone][0]], walls).leaves_room(*rest[-1])


@pytest.mark.parametrize("seed", range(6))
def test_a_cupboard_does_not_take_the_last_place_of_the_fridge(seed: int) -> None:
    _, empty, walls = kitchen(seed)
    space = empty.space
    k = int(space.length.argmax())
    yaw = float(np.arctan2(space.normal[k, 1], space.normal[k, 0]))

    def at(s: float, size: tuple[float, float, float]) -> np.ndarray:
        xy = space.start[k] + space.along[k] * s + space.normal[k] * (size[0] / 2 + 0.003)
        return np.array([*xy, yaw, *size[:2], 0.0, size[2]], np.float32)

    middle = float(space.length[k]) / 2
    there = empty.besides("hob", at(middle, (0.6, 0.6, 0.9)))
    for s in (middle - 0.66, middle + 1.36):  # 0.7 m are left at the hob's left, between it and a table
        there = there.besides("coffee_table", at(s, (0.6, 0.6, 0.4)))
    beside, elsewhere = at(middle + 0.605, (0.6, 0.6, 0.9)), at(middle + 0.605, (0.6, 0.3, 0.9))
    elsewhere[:2] += space.normal[k] * 1.3
    with_hob = empty.besides("hob", at(middle, (0.6, 0.6, 0.9)))
    assert Ahead(with_hob, ["fridge"], walls).leaves_room("coffee_table", beside)
    fits = there.prices("fridge", at(middle + 0.605, (0.65, 0.6, 1.75))[None])[0] < 10
    assert Ahead(there, ["fridge"], walls).leaves_room("kitchen_base", beside) != fits


def test_one_that_cooks_is_enough_and_cupboards_are_not_needed() -> None:
    left = ["kitchen_base", "oven", "fridge", "hob", "chair", "dishwasher"]
    assert ahead.needed(left, ["kitchen_sink"]) in (["fridge", "hob"], ["oven", "fridge"])
    assert ahead.needed(left, ["hob"]) == ["fridge"]
    assert ahead.needed(["chair", "kitchen_sink"], []) == ["kitchen_sink"]


@pytest.mark.parametrize("seed", range(12))
def test_a_run_finds_its_way_round_the_corner_by_the_unit_that_fills_it(seed: int) -> None:
    units, empty, walls = kitchen(seed)
    names = [name for name, _ in units]
    if "kitchen_corner" not in names:
        return
    corner = units[names.index("kitchen_corner")]
    others = [unit for unit in units if unit is not corner]
    assert empty.besides(*others[0]).prices(corner[0], corner[1][None], loose=True)[0] < 2 * BROKEN
    moved = corner[1].copy()
    moved[:2] *= 0.3  # out of its corner
    assert empty.prices(corner[0], moved[None])[0] >= 2 * BROKEN
    there = empty
    for name, box in others:
        there = there.besides(name, box)
    places = runs.further("kitchen_corner", corner[1][None], there.names, there.boxes, walls)
    assert np.abs(places[:, :2] - corner[1][:2]).max(1).min() < 0.03
