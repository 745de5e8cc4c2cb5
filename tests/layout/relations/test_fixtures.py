"""Fixtures of bathrooms keep floor before them: what people's rooms have costs nothing, what takes it does."""

import numpy as np
import pytest
from rooms_for_tests import one_room

from apartgen.schemas.layout import Box, Layout
from apartgen.stages.layout.datasets import single_rooms
from apartgen.stages.layout.datasets.furnisher import furnish
from apartgen.stages.layout.projection.space import Space, space_of
from apartgen.stages.layout.relations import fixtures
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import upright
from apartgen.stages.layout.rooms import KINDS, of_plan
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kinds import FIXTURES


def bath(seed: int) -> tuple[list[Box], Space, np.ndarray]:
    plan = single_rooms.draw(np.random.default_rng([5, seed]), "bathroom")
    arrays = of_plan(plan)
    home = Layout(**dict(plan), objects=furnish(plan, np.random.default_rng([6, seed])))
    return home.objects, space_of(arrays, 0), np.append(arrays.origin[0], 0.0)


def price(o: Box, others: list[Box], space: Space, origin: np.ndarray, strict: bool = True) -> float:
    def shifted(some: list[Box]) -> Boxes:
        found = boxes.of(some)
        return Boxes(found.center - origin, found.size, found.yaw)

    return float(fixtures.prices(o.category, shifted([o]), [p.category for p in others], shifted(others), space,
                                 strict)[0])


@pytest.mark.parametrize("seed", range(8))
def test_what_keeps_clear_costs_nothing_and_what_stands_before_a_fixture_is_not_taken(seed: int) -> None:
    objects, space, origin = bath(seed)
    floor = [o for o in objects if TABLE[o.category].place == "floor"]
    for o in floor:
        others = [p for p in floor if p is not o]
        elbows = {"vanity": fixtures.SQUEEZED, "bin": fixtures.FAR}.get(o.category, 0.0)  # in the narrowest rooms
        assert price(o, others, space, origin, strict=False) in (0.0, elbows), o.id
        if o.category not in FIXTURES:
            continue
        heading = np.array([np.cos(o.yaw), np.sin(o.yaw), 0.0])
        bin = o.model_copy(update={"category": "bin", "size": (0.25, 0.25, 0.4)})
        bin.center = tuple((np.array(o.center) * (1, 1, 0) + heading * (o.size[0] / 2 + 0.3) + (0, 0, 0.2)).tolist())
        assert price(bin, [o], space, origin) >= fixtures.BROKEN
        turned = o.model_copy(update={"yaw": o.yaw + np.pi})
        assert price(turned, [], space, origin) >= fixtures.BROKEN  # its back is to the room


def test_a_fixture_may_take_floor_where_no_place_keeps_it() -> None:
    objects, space, origin = bath(1)
    toilet = next(o for o in objects if o.category == "toilet")
    heading = np.array([np.cos(toilet.yaw), np.sin(toilet.yaw), 0.0])
    basin = toilet.model_copy(update={"category": "vanity", "size": (0.4, 0.5, 0.85)})
    basin.center = tuple((np.array(toilet.center) + heading * 0.8).tolist())
    assert price(toilet, [basin], space, origin) >= fixtures.BROKEN
    assert price(toilet, [basin], space, origin, strict=False) == fixtures.TAKEN


def test_a_toilet_keeps_elbow_room_as_well() -> None:
    objects, space, origin = bath(2)
    toilet = next(o for o in objects if o.category == "toilet")
    left = np.array([-np.sin(toilet.yaw), np.cos(toilet.yaw), 0.0])
    basket = toilet.model_copy(update={"category": "laundry_basket", "size": (0.3, 0.3, 0.5)})
    for off, kept in ((0.38 + 0.15 + 0.02, True), (0.30 + 0.15, False)):
        basket.center = tuple((np.array(toilet.center) + left * off).tolist())
        assert (price(toilet, [basket], space, origin) == 0) == kept


@pytest.mark.parametrize("gap, kept", [(0.05, False), (0.12, False), (0.15, True), (0.4, True)])
def test_a_basin_keeps_elbow_room_if_there_is_any(gap: float, kept: bool) -> None:
    """One of .5 m, something `gap` beside it: .38 m from its axis; a basket is pushed aside with the foot."""
    objects, space, origin = bath(2)
    basin = next(o for o in objects if o.category == "vanity")
    basin = basin.model_copy(update={"size": (0.45, 0.5, 0.85)})
    left = np.array([-np.sin(basin.yaw), np.cos(basin.yaw), 0.0])
    beside = basin.model_copy(update={"category": "bath", "size": (0.45, 0.7, 0.6), "id": "beside"})
    beside.center = tuple((np.array(basin.center) + left * (0.25 + gap + 0.35)).tolist())
    basket = beside.model_copy(update={"category": "laundry_basket"})
    alone = price(basin, [], space, origin, strict=False)
    assert price(basin, [beside], space, origin, strict=False) == alone + (0 if kept else fixtures.SQUEEZED)
    assert price(basin, [basket], space, origin, strict=False) == alone


@pytest.mark.parametrize("name, barred", [("bath", True), ("toilet", True), ("bin", True), ("vanity", False)])
def test_towels_hang_where_one_gets_at_them(name: str, barred: bool) -> None:
    """Not over a tub, a toilet or a bin, nor behind a tub; and no bin is put under them."""
    objects, space, origin = bath(2)
    toilet = next(o for o in objects if o.category == "toilet")
    below = toilet.model_copy(update={"category": name, "id": "below"})
    rail = toilet.model_copy(update={"category": "towel_rail", "size": (0.1, 0.5, 0.8), "id": "rail"})
    ahead = np.array([np.cos(toilet.yaw), np.sin(toilet.yaw), 0.0])
    aside = np.array([-np.sin(toilet.yaw), np.cos(toilet.yaw), 0.0])
    for off, met in ((0.0, barred), (0.2, barred), (0.6, False)):
        rail.center = tuple((np.array(toilet.center) + off * aside + (0, 0, 1.0)).tolist())
        for strict in (True, False):
            assert price(rail, [below], space, origin, strict=strict) == (fixtures.BROKEN if met else 0.0)
    rail.center = tuple((np.array(toilet.center) - (toilet.size[0] / 2 + 0.1) * ahead + (0, 0, 1.0)).tolist())
    assert price(rail, [below], space, origin) == (fixtures.BROKEN if name == "bath" else 0.0)
    bin_ = toilet.model_copy(update={"category": "bin", "size": (0.25, 0.25, 0.4), "id": "bin"})
    for off, met in ((0.0, True), (0.45, False)):
        bin_.center = tuple((np.array(rail.center) + off * aside - (0, 0, 1.0)).tolist())
        assert (price(bin_, [rail], space, origin, strict=False) >= fixtures.BROKEN) == met


@pytest.mark.parametrize("name, far, near", [("toilet", 0.3, True), ("toilet", 0.6, False), ("kitchen_sink", 0.8, True),
                                             ("sofa", 0.6, True)])
def test_a_bin_stands_by_where_one_throws_something_away(name: str, far: float, near: bool) -> None:
    """If there is such a place; else anywhere."""
    objects, space, origin = bath(2)
    toilet = next(o for o in objects if o.category == "toilet")
    aside = np.array([-np.sin(toilet.yaw), np.cos(toilet.yaw), 0.0])
    other = toilet.model_copy(update={"category": name, "id": "other"})
    bin_ = toilet.model_copy(update={"category": "bin", "size": (0.2, 0.2, 0.4), "id": "bin"})
    bin_.center = tuple((np.array(toilet.center) + (toilet.size[1] / 2 + far + 0.1) * aside).tolist())
    alone = [price(bin_, [], space, origin, strict=strict) for strict in (True, False)]
    with_it = [price(bin_, [other], space, origin, strict=strict) for strict in (True, False)]
    if far > 0.4:
        added = np.array(with_it) - alone
        assert (added == ([0.0, 0.0] if near else [fixtures.BROKEN, fixtures.FAR])).all()


def doored() -> Space:
    """A room of 4 by 4 m about the origin with a door of .9 m in its south wall beside the west wall, which opens
    inwards, its leaf along that wall."""
    rooms = one_room()
    rooms.openings[0, 0] = [-1.9, -2.0, -1.0, -2.0, KINDS["door"], 1, 0]
    return space_of(rooms, 0)


@pytest.mark.parametrize("x, y, yaw, basin, seen", [
    (-1.98, -1.5, 0.0, False, False),       # on the west wall, behind the leaf
    (-1.98, -1.5, 0.0, True, True),         # there, over a basin
    (-1.98, 0.5, 0.0, False, True),         # past its end
    (1.98, -1.5, np.pi, False, True),       # across the room
])
def test_no_mirror_hangs_behind_a_door_that_stands_open(x: float, y: float, yaw: float, basin: bool,
                                                        seen: bool) -> None:
    mirror = upright(np.array([[x, y, yaw, 0.04, 0.5, 1.1, 1.9]], np.float32))
    vanity = upright(np.array([[-1.75, y, 0.0, 0.5, 0.6, 0.0, 0.85]][: int(basin)], np.float32).reshape(-1, 7))
    found = fixtures.prices("mirror", mirror, ["vanity"] * basin, vanity, doored(), strict=True)
    assert (found[0] == 0) == seen
    if not seen:
        assert fixtures.prices("mirror", mirror, [], vanity, doored(), strict=False)[0] < BROKEN, "better than none"


@pytest.mark.parametrize("x, lies", [(-1.5, False), (0.9, True)])
def test_no_rug_lies_under_a_door_that_stands_open(x: float, lies: bool) -> None:
    rug = np.array([[x, -0.9, 0.0, 1.6, 0.9, 0.0, 0.006]], np.float32)
    assert (Furniture(doored()).prices("rug", rug)[0] < BROKEN) == lies
