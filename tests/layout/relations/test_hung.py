"""Hoods hang over what cooks and mirrors over basins: such places are among the candidates, and are kept for them."""

import numpy as np
import pytest

from apartgen.stages.layout.relations import hung
from apartgen.stages.layout.relations.tokens import upright


def row(x: float, y: float, yaw: float, *rest: float) -> np.ndarray:
    return np.array([x, y, yaw, *rest], np.float32)


@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, 2.0])
def test_a_mirror_may_hang_over_the_basin_and_no_towel_rail(yaw: float) -> None:
    ahead, left = np.array([np.cos(yaw), np.sin(yaw)]), np.array([-np.sin(yaw), np.cos(yaw)])
    basin = row(1.0, 2.0, yaw, 0.5, 0.8, 0.0, 0.85)
    toilet = row(*(np.array([1.0, 2.0]) + 1.2 * left), yaw, 0.65, 0.38, 0, 0.8)
    names, there = ["vanity", "toilet"], np.stack([basin, toilet])
    (place,) = hung.over("mirror", row(9, 9, 0, 0.04, 1.0, 0.7, 1.5)[None], names, there)
    back = np.array([1.0, 2.0]) - 0.25 * ahead
    assert place[:2] == pytest.approx(back + 0.02 * ahead, abs=1e-5)
    assert place[2:] == pytest.approx([yaw, 0.04, 0.8, 0.95, 1.75], abs=1e-5)
    rail = np.stack([row(*(back + 0.05 * ahead + s * left), yaw, 0.1, 0.5, 0.9, 1.2) for s in (0.0, 0.6, 0.7, 1.2)])
    assert hung.spoils("towel_rail", upright(rail), names, upright(there)).tolist() == [True, True, False, False]
    assert not hung.spoils("mirror", upright(place[None]), names, upright(there)).any()


def test_the_hood_hangs_over_what_cooks_and_wall_units_over_low_units_beside_it() -> None:
    names = ["kitchen_base", "hob", "fridge"]
    there = np.stack([row(0.3, y, 0.0, 0.6, 0.6, 0.0, top) for y, top in ((0.0, 0.9), (0.6, 0.9), (1.2, 1.85))])
    hood = hung.over("hood", row(0, 0, 0, 0.4, 0.6, 1.5, 2.1)[None], names, there)
    unit = hung.over("wall_unit", row(0, 0, 0, 0.35, 0.9, 1.45, 2.1)[None], names, there)
    assert hood[:, :2].tolist() == [pytest.approx([0.2, 0.6])] and unit[:, :2].tolist() == [pytest.approx([0.175, 0.0])]
    assert unit[0, 4] == pytest.approx(0.6)  # as wide as what is below
    moved = unit.copy()
    moved[0, 1] = 0.6
    assert not hung.spoils("wall_unit", upright(unit), names, upright(there)).any()
    assert hung.spoils("wall_unit", upright(moved), names, upright(there)).all()
    assert not hung.spoils("hood", upright(hood), names, upright(there)).any()
    low, tall = 0.9, 2.1
    cook = np.stack([row(0.3, y, 0.0, 0.6, 0.6, 0.0, top) for y, top in ((0, low), (0.5, low), (0.6, low), (0, tall))])
    assert hung.spoils("hob", upright(cook), ["wall_unit"], upright(unit)).tolist() == [True, True, False, False]
    assert not hung.spoils("kitchen_base", upright(cook), ["wall_unit"], upright(unit)).any()
    assert not hung.spoils("hob", upright(cook), ["hood"], upright(hood)).any()
    assert not len(hung.over("plant", unit, names, there))


def test_one_gets_at_a_mirror_over_its_basin() -> None:
    """Though it is out of reach of who walks on the floor, as a bin behind the basin would be."""
    from apartgen.stages.layout.datasets import furnisher, single_rooms
    from apartgen.stages.layout.projection.space import space_of
    from apartgen.stages.layout.relations.standing import Furniture
    from apartgen.stages.layout.rooms import of_plan

    seen = 0
    for seed in range(8):
        plan = single_rooms.draw(np.random.default_rng(seed), "bathroom")
        origin = of_plan(plan).origin[0]
        there = Furniture(space_of(of_plan(plan), 0))
        mirrors = []
        for o in furnisher.furnish(plan, np.random.default_rng(seed)):
            low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
            box = row(o.center[0] - origin[0], o.center[1] - origin[1], o.yaw, *o.size[:2], low, high)
            if o.category == "mirror":
                mirrors.append(box)
            elif low < 0.02:
                there.add(o.category, box)
        for box in mirrors:
            seen += 1
            assert there.shuts("mirror", box) == 0
            box[5:] = 0.0, 0.4
            assert there.shuts("bin", box) > 0
    assert seen > 4


@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, 2.0])
@pytest.mark.parametrize("name, size, ahead, turn, barred", [
    ("nightstand", (0.42, 0.48, 0.52), 0.22, 0.0, True), ("single_bed", (2.0, 0.9, 0.5), 0.5, np.pi / 2, True),
    ("floor_lamp", (0.3, 0.3, 1.6), 0.2, 0.0, True), ("wardrobe", (0.6, 1.5, 2.1), 0.9, 0.0, True),
    ("chest", (0.45, 0.8, 0.8), 0.25, 0.0, False), ("chest", (0.45, 0.8, 0.8), 0.5, np.pi / 2, True),
    ("dressing_table", (0.45, 0.9, 0.75), 0.25, 0.0, False), ("stool", (0.4, 0.4, 0.45), 0.3, 0.0, False),
    ("rug", (1.4, 1.4, 0.01), 0.5, 0.0, False), ("nightstand", (0.42, 0.48, 0.52), 1.2, 0.0, False),
])
def test_one_stands_before_a_mirror(name: str, size: tuple[float, ...], ahead: float, turn: float, barred: bool,
                                    yaw: float) -> None:
    """Or before the low cabinet below it that looks the same way, whichever of the two comes first."""
    front = np.array([np.cos(yaw), np.sin(yaw)])
    depth, width, height = size
    there = row(*(np.array([1.0, 2.0]) + ahead * front), yaw + turn, depth, width, 0.0, height)
    mirror = row(*(np.array([1.0, 2.0]) + 0.02 * front), yaw, 0.04, 0.6, 1.05, 1.85)
    assert hung.spoils("mirror", upright(mirror[None]), [name], upright(there[None])).tolist() == [barred]
    assert not hung.spoils("wall_lamp", upright(mirror[None]), [name], upright(there[None])).any()
    aside = there.copy()
    aside[:2] += 3.0 * np.array([-np.sin(yaw), np.cos(yaw)])
    later = hung.spoils(name, upright(np.stack([there, aside])), ["mirror"], upright(mirror[None]))
    assert later.tolist() == [barred, False]
    assert not hung.spoils(name, upright(there[None]), ["wall_lamp"], upright(mirror[None])).any()
