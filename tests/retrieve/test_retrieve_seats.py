"""Loose things leave the way of moving parts, and nothing else moves."""

import logging

import numpy as np
import pytest
from shapely import Polygon

from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching import seats
from apartgen.stages.space import boxes, polygons

DESK = (0.65, 1.40, 0.75)


def thing(id: str, category: str, center, size, yaw: float = 0.0, joints=()) -> Furnishing:
    where = {"room": "bedroom_1", "center": center, "size": size, "yaw": yaw}
    return Furnishing(id=id, category=category, **where, asset=AssetKey(library="x", id="x"), joints=list(joints))


def drawer(size, lo: float, hi: float, low: float = -1.0) -> Joint:
    """A drawer behind the front between two places across the width; `low` is its underside from the centre."""
    d, _, h = size
    extent = ((-d / 2 + 0.05, lo, max(low, -h / 2 + 0.05)), (d / 2, hi, h / 2 - 0.03))
    return Joint(name="drawer", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, 0.75 * d),
                 part="slider_drawer", extent=extent)  # fmt: skip


def desk(
    at=(1.0, 2.5), yaw: float = 0.0, pedestal: tuple[float, float] = (0.05, 0.65), size=DESK, **joint
) -> Furnishing:
    return thing("desk", "desk", (*at, size[2] / 2), size, yaw, [drawer(size, *pedestal, **joint)])


def chair(at, yaw: float = np.pi, id: str = "chair", side: float = 0.5) -> Furnishing:
    return thing(id, "chair", (*at, 0.45), (side, side, 0.9), yaw)


def met(objects) -> float:
    """Deepest entry of any object into another's moving parts."""
    swept, every = seats.parts(objects), boxes.of(objects)
    depth = boxes.penetration(every, swept.boxes)
    depth[swept.owner, np.arange(len(swept.owner))] = -np.inf
    return float(depth.max(initial=-np.inf))


def shift(before: Furnishing, after: Furnishing) -> np.ndarray:
    return np.subtract(after.center, before.center)


@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, 2.0])
def test_a_chair_before_the_pedestal_moves_into_the_kneehole(yaw, flat):
    front, left = np.array([np.cos(yaw), np.sin(yaw)]), np.array([-np.sin(yaw), np.cos(yaw)])
    table, seat = desk((2.0, 2.5), yaw), chair(np.array([2.0, 2.5]) + 0.35 * front, yaw + np.pi)
    assert met([table, seat]) > seats.MET
    after = seats.cleared([table, seat], flat())
    moved = shift(seat, after[1])[:2]
    assert met(after) <= seats.MET and after[0] is table
    assert np.isclose(moved @ front, 0, atol=1e-5) and -0.45 <= moved @ left <= -0.2


def test_a_chair_at_a_desk_too_narrow_to_pass_moves_outwards(flat):
    size = (0.6, 0.9, 0.75)
    table, seat = desk(pedestal=(-0.4, 0.4), size=size, low=0.2), chair((1.0 + 0.3 + 0.1, 2.5))
    after = seats.cleared([table, seat], flat())
    moved = shift(seat, after[1])
    assert met(after) <= seats.MET
    # The drawer comes out by 0.45, the chair stood 0.15 under the top, and steps are 0.05.
    assert np.allclose(moved, [0.6, 0, 0], atol=1e-6)


def test_a_chair_goes_aside_by_a_hand_rather_than_far_off_for_the_sake_of_a_panel(flat):
    """Beside a pedestal of a third of a metre a chair of .6 m is .0115 m clear at .16 m aside, and never .02 m."""
    size = (0.6, 1.0, 0.72)
    table, seat = desk(pedestal=(-0.4885, -0.1515), size=size), chair((1.48, 2.5), side=0.6)
    after = seats.cleared([table, seat], flat())
    moved = shift(seat, after[1])
    assert met(after) <= seats.MET
    assert abs(moved[0]) < 1e-6 and 0.15 <= moved[1] <= 0.2
    wide = seats.cleared([table, chair((1.48, 2.5), side=0.66)], flat())
    moved = shift(chair((1.48, 2.5)), wide[1])
    assert met(wide) <= seats.MET and abs(moved[0]) < 1e-6 and 0.17 <= moved[1] <= 0.27


def test_a_stool_leaves_an_island_that_has_no_kneehole(flat):
    size = (0.9, 1.6, 0.9)
    island = thing("island", "island", (1.0, 2.5, 0.45), size, 0.0, [drawer(size, -0.15, 0.15)])
    stool = thing("stool", "stool", (1.4, 2.5, 0.35), (0.4, 0.4, 0.7), np.pi)
    after = seats.cleared([island, stool], flat())
    assert met([island, stool]) > seats.MET >= met(after)
    assert boxes.penetration(boxes.of(after))[0, 1] <= seats.CONTACT + 1e-6


def test_a_seat_is_never_tucked_deeper_nor_into_a_neighbour(flat):
    table, seat = desk(), chair((1.35, 2.5))
    bed = thing("bed", "single_bed", (1.5, 1.8, 0.45), (2.0, 0.5, 0.9))  # fills what lies before the kneehole
    after = seats.cleared([table, seat, bed], flat())
    assert met(after) <= seats.MET
    depth = boxes.penetration(boxes.of([after[1]]), boxes.of([table, bed]))[0]
    was = boxes.penetration(boxes.of([seat]), boxes.of([table]))[0, 0]
    assert depth[0] <= was + 1e-6 and depth[1] <= seats.CONTACT + 1e-6


def test_what_is_in_nobodys_way_stays_to_the_byte(flat):
    table = desk()
    lamp = thing("lamp", "ceiling_lamp", (2, 2.5, 2.4), (0.4, 0.4, 0.4))
    objects = [table, chair((1.35, 2.2), side=0.45), chair((2.5, 4.0), 0.3, "other"), lamp]
    assert met(objects) <= seats.MET
    before = [o.model_dump_json() for o in objects]
    assert [o.model_dump_json() for o in seats.cleared(objects, flat())] == before


def test_where_there_is_no_room_it_stays_and_is_named(flat, caplog):
    size = (0.6, 0.9, 0.75)
    # The desk faces a wall 0.55 m away, and its drawer is as wide as the desk.
    table, seat = desk((4 - 0.55 - 0.3, 2.5), pedestal=(-0.45, 0.45), size=size, low=0.2), chair((3.6, 2.5))
    with caplog.at_level(logging.INFO, "apartgen"):
        assert seats.cleared([table, seat], flat()) == [table, seat]
    assert "chair" in caplog.text and "desk" in caplog.text


def test_loose_things_move_with_what_they_carry_and_heavy_ones_stay(flat):
    size = (0.6, 0.9, 2.1)
    leaf = Joint(name="leaf", type="hinge", axis=(0, 0, 1), origin=(0.3, 0.45, 0), range=(0, 1.57), part="hinge_door",
                 extent=((0.28, -0.45, -1.0), (0.3, 0.45, 1.0)))  # fmt: skip
    wardrobe = thing("wardrobe", "wardrobe", (0.3, 2.5, 1.05), size, 0.0, [leaf])
    table = thing("table", "side_table", (1.2, 2.5, 0.275), (0.45, 0.45, 0.55))
    lamp = thing("lamp", "table_lamp", (1.2, 2.5, 0.75), (0.2, 0.2, 0.4)).model_copy(update={"on": "table"})
    heavy = thing("heavy", "sofa", (1.2, 1.5, 0.4), (0.8, 1.3, 0.8))
    after = seats.cleared([wardrobe, table, lamp, heavy], flat())
    assert met([wardrobe, table]) > seats.MET >= met(after[:3])
    assert np.allclose(shift(table, after[1]), shift(lamp, after[2])) and np.hypot(*shift(table, after[1])[:2]) > 0.05
    assert after[0] is wardrobe and after[3] is heavy


def test_a_lamp_leaves_the_swing_of_a_door_as_high_as_it_hangs(flat):
    home = flat()
    door = home.openings[0].model_copy(update={"into": "bedroom_1", "head": 2.1})
    plan = home.model_copy(update={"openings": [door]})
    swing = polygons.swing(door, plan)
    x, y = swing.centroid.coords[0]
    low, high = (thing("lamp", "ceiling_lamp", (x, y, z), (0.3, 0.3, 0.4)) for z in (2.2, 2.4))
    assert seats.cleared([high], plan) == [high]
    moved = seats.cleared([low], plan)[0]
    area: Polygon = boxes.footprints(boxes.of([moved]))[0]
    assert area.intersection(swing).area <= 1e-4 and moved.center[2] == low.center[2]
    assert polygons.floor(plan.rooms[0]).buffer(1e-3).covers(area)


def test_random_rooms_only_ever_lose_entries(flat):
    rng = np.random.default_rng(3)
    freed = 0
    for _ in range(30):
        table = desk((2.0, 2.5), rng.uniform(0, 2 * np.pi), (0.1, 0.65))
        objects = [table, *(chair(rng.uniform([1, 1.5], [3, 3.5]), rng.uniform(0, 6), f"c{k}") for k in range(3))]
        after = seats.cleared(objects, flat())
        depth = [boxes.penetration(boxes.of(home)) for home in (objects, after)]
        assert (depth[1] <= np.maximum(depth[0], seats.CONTACT) + 1e-5).all()
        assert met(after) <= max(met(objects), seats.MET) + 1e-5
        assert after == seats.cleared(objects, flat())
        freed += met(objects) > seats.MET >= met(after)
    assert freed > 10


@pytest.mark.parametrize("style", ["modern", "scandi", "industrial", "classic", "midcentury"])
@pytest.mark.parametrize("width", [0.9, 1.0, 1.2, 1.4, 1.6])
def test_a_chair_drawn_up_to_a_desk_finds_a_place_beside_its_drawers(style, width):
    """Within a tenth of a metre beyond its ends, and without going back from it."""
    for variant in range(4):
        found = furniture.load_asset(f"desk/{style}/600x{round(1000 * width)}x720/{variant}")
        table = thing("desk", "desk", (0.0, 0.0, 0.36), (0.6, width, 0.72), 0.0, found.joints)
        spots = [chair((0.42, y), side=0.6) for y in np.arange(-30, 31) * 0.02 if abs(y) <= width / 2 - 0.2]
        assert any(met([table, spot]) <= seats.MET for spot in spots), (style, width, variant)
