"""Where the judge draws its lines: each on its right and on its wrong side."""

import math

import handmade as h
import pytest

from apartgen.schemas.plan import Opening, Plan
from apartgen.schemas.retrieve import Joint
from apartgen.schemas.walkable import Report, Walkable
from apartgen.stages import check

ONE, TWO = "living_room_1", "hallway_1"


def plan(width=8.0, depth=8.0, height=2.6, second=1.5, openings=(), kind="hallway") -> Plan:
    """Two rooms side by side, 10 cm between them; the entrance in the west, a way between them in the south."""
    rooms = [{"id": ONE, "type": "living_room", "polygon": h.rectangle(0, 0, width, depth)},
             {"id": TWO, "type": kind, "polygon": h.rectangle(width + 0.1, 0, second, depth)}]
    rows = [{"id": "in", "kind": "entrance", "rooms": [ONE], "segment": [[-0.15, 0.1], [-0.15, 1.0]], "sill": 0,
             "head": 2.0, "into": ONE},
            {"id": "way", "kind": "opening", "rooms": [ONE, TWO], "segment": [[width + 0.05, 0.1], [width + 0.05, 0.8]],
             "sill": 0, "head": 2.0}]
    every = {row["id"]: row for row in (*rows, *openings)}
    asked = {"rooms": [{"id": ONE, "type": "living_room"}, {"id": TWO, "type": kind}]}
    return Plan.model_validate({"program": asked, "rooms": rooms, "height": height,
                                "openings": [Opening.model_validate(row) for row in every.values()]})


def codes(home) -> list[str]:
    return sorted(fault.code for fault in check.run(home, strict=True))


def way(kind, wide, at=1.5, sill=0.0, head=2.0, depth=20.0):
    """A plan with one more opening so wide, a window in the east, anything else between the rooms."""
    x = 8.05 if kind != "window" else 8 + 0.1 + 1.5 + 0.15
    row = {"id": "it", "kind": kind, "rooms": [ONE, TWO] if kind != "window" else [TWO],
           "segment": [[x, at], [x, at + wide]], "sill": sill, "head": head}
    if kind == "entrance":
        row |= {"rooms": [ONE], "segment": [[-0.15, at], [-0.15, at + wide]], "into": ONE}
    return plan(depth=depth, openings=[row])


@pytest.mark.parametrize("kind, least, most", [
    ("door", 0.6, 2.5), ("entrance", 0.7, 3.0), ("opening", 0.6, 15.0), ("window", 0.15, 15.0)])
def test_openings_are_neither_too_narrow_nor_too_wide(kind, least, most):
    sill, head = (0.9, 2.1) if kind == "window" else (0.0, 2.0)
    for wide, found in ((least - 0.01, True), (least + 0.01, False), (most - 0.01, False), (most + 0.01, True)):
        assert codes(way(kind, wide, sill=sill, head=head)) == ["opening-width"] * found, wide


def test_one_walks_through_upright_and_windows_end_below_the_ceiling():
    for head, found in ((1.89, True), (1.91, False), (2.6, False), (2.62, True)):
        assert codes(way("opening", 1.0, head=head)) == ["opening-height"] * found
        assert codes(way("window", 1.0, sill=0.9, head=head)) == ["opening-height"] * (head > 2.61)
    assert codes(way("window", 1.0, sill=1.0, head=1.005)) == ["opening-height"]
    for sill, found in ((0.005, False), (0.015, True)):
        assert codes(way("opening", 1.0, sill=sill, head=2.2)) == ["opening-height"] * found
    assert codes(way("window", 1.0, sill=-0.02)) == ["opening-height"]


def test_rooms_and_storeys_have_possible_sizes():
    for height, found in ((1.9, True), (1.89, True), (10.0, False), (10.1, True)):
        assert ("ceiling" in codes(plan(height=height))) == (found and height != 1.9), height
    for depth, found in ((24.9, False), (25.1, True)):
        assert codes(plan(width=20.0, depth=depth)) == ["area"] * found
    for second, found in ((0.49, True), (0.51, False)):
        assert ("area" in codes(plan(depth=1.0, second=second, openings=[{
            "id": "way", "kind": "opening", "rooms": [ONE, TWO], "segment": [[8.05, 0.1], [8.05, 0.8]], "sill": 0,
            "head": 2.0}]))) == found


def test_openings_do_not_cross():
    """Two windows of one wall, side by side, over one another, or across."""
    def two(at, sill, head):
        x = 8 + 0.1 + 1.5 + 0.15
        rows = [{"id": id, "kind": "window", "rooms": [TWO], "segment": [[x, y], [x, y + 1]], "sill": a, "head": b}
                for id, y, a, b in (("a", 2.0, 0.9, 1.5), ("b", at, sill, head))]
        return codes(plan(openings=rows))

    assert two(3.0, 0.9, 1.5) == two(2.5, 1.5, 2.1) == [] and two(2.98, 0.9, 1.5) == ["openings-cross"]
    assert two(2.5, 1.4, 2.1) == ["openings-cross"]


def test_windows_look_outside():
    """A window of the living room in the wall of the hall: there is a room behind it; of a balcony there may be."""
    row = {"id": "it", "kind": "window", "rooms": [ONE], "segment": [[8.05, 3.0], [8.05, 4.0]], "sill": 0.9, "head": 2}
    assert codes(plan(openings=[row])) == ["not-outside"] and codes(plan(openings=[row], kind="balcony")) == []


def test_rooms_are_reached_and_linked_as_asked():
    home = plan()
    shut = home.model_copy(update={"openings": home.openings[:1]})
    assert codes(shut) == ["cut-off"]
    asked = home.program.model_copy(update={"links": [(ONE, TWO)]})
    assert codes(home.model_copy(update={"program": asked})) == []
    assert codes(shut.model_copy(update={"program": asked})) == ["cut-off", "no-link"]
    assert "no-entrance" in codes(home.model_copy(update={"openings": home.openings[1:]}))
    assert {"no-entrance", "cut-off"} <= set(codes(home.model_copy(update={"openings": []})))


def furnished(*objects):
    return sorted(f.code for f in check.run(h.home(*objects)) if f.refuses)


@pytest.mark.parametrize("share, found", [(0.34, []), (0.32, ["size"]), (2.9, []), (3.1, ["size"])])
def test_things_are_up_to_three_times_beyond_what_is_sold(share, found):
    """A mirror is sold .02 to .08 m deep, .3 to 1.2 wide, .4 to 2 high; three times beyond is a mistake."""
    from apartgen.stages.things.categories import TABLE

    kind = TABLE["mirror"]
    deep = (kind.min if share < 1 else kind.max)[0] * share
    mirror = h.thing("mirror", deep / 2, 2.4, size=(deep, 0.4, 0.6), bottom=1.0)
    assert furnished(mirror) == found


def test_things_stay_within_floor_ceiling_and_room():
    tall = [h.thing("bookshelf", 0.2, 2.5, size=(0.3, 0.8, high)) for high in (2.0, h.plan().height + 0.02)]
    assert [furnished(o) for o in tall] == [[], ["storey"]]
    assert furnished(h.thing("bookshelf", 0.2, 2.5, bottom=-0.02)) == ["storey"]
    for x, found in ((0.145, []), (0.135, ["outside"])):
        assert furnished(h.thing("bookshelf", x, 2.5, size=(0.3, 0.8, 1.8))) == found


def test_contact_is_a_centimetre_and_use_five():
    first = h.chest(1.0, 0.9, id="a")
    for gap, found in ((-0.009, []), (-0.011, ["overlap"]), (0.0, [])):
        assert furnished(first, h.chest(1.0, 1.9 + gap, id="b")) == found
    bed = h.thing("double_bed", 1.5, 1, id="bed", size=(2.0, 1.6, 0.9))
    for gap, found in ((-0.049, []), (-0.051, ["overlap"])):
        assert furnished(bed, h.thing("nightstand", 0.7, 2.05 + gap, id="s", size=(0.4, 0.5, 0.5))) == found


def test_what_is_three_centimetres_high_is_part_of_the_floor():
    chest = h.chest(2, 1.5, id="chest")
    for high, found in ((0.029, []), (0.031, ["overlap"])):
        plate = h.thing("bin", 2, 1.5, size=(0.15, 0.15, high), id="plate")
        assert [code for code in furnished(chest, plate) if code == "overlap"] == found


def test_a_third_of_it_must_stand_on_something():
    """A lamp of 20 cm that reaches over the edge of a chest: .3 of it hold it."""
    low = h.chest(2, 1.5, id="low")
    for share, found in ((0.31, []), (0.29, ["unsupported"])):
        lamp = h.thing("table_lamp", 2 + 0.25 + 0.1 - 0.2 * share, 1.5, size=(0.2, 0.2, 0.4), bottom=0.8, id="lamp")
        assert furnished(low, lamp) == found
    for gap, found in ((0.014, []), (0.016, ["unsupported"])):
        lamp = h.thing("table_lamp", 2, 1.5, size=(0.2, 0.2, 0.4), bottom=0.8 + gap, id="lamp")
        assert furnished(low, lamp) == found


def test_what_is_said_to_carry_may_have_an_edge_of_five_centimetres():
    """A lamp on a shelf whose frame is higher than its top; what nothing is said of must touch."""
    low = h.chest(2, 1.5, id="low").model_copy(update={"on": "floor"})
    for sunk, on, found in ((0.04, "low", []), (0.04, None, ["unsupported"]),
                            (0.06, "low", ["not-on", "overlap", "unsupported"])):
        lamp = h.thing("table_lamp", 2, 1.5, size=(0.2, 0.2, 0.4), bottom=0.8 - sunk, id="lamp")
        assert furnished(low, lamp.model_copy(update={"on": on})) == found


def test_pictures_hang_no_further_than_three_centimetres_from_a_wall():
    for gap, found in ((0.029, []), (0.031, ["unsupported"])):
        assert furnished(h.thing("mirror", gap + 0.02, 2.4, size=(0.04, 0.5, 0.6), bottom=1.0)) == found
    lamp = h.thing("ceiling_lamp", 2, 1.5, bottom=0)
    high = h.plan().height - lamp.size[2]
    for down, found in ((0.019, []), (0.021, ["unsupported"])):
        assert furnished(h.thing("ceiling_lamp", 2, 1.5, bottom=high - down)) == found


def strictly(*objects):
    home = Walkable(**dict(h.home(*objects)), walkable=Report(target=0.7, before=1, after=1))
    return [f.of for f in check.run(home) if f.refuses and f.code.endswith("blocked")]


def test_parts_go_two_centimetres_into_cabinets_and_five_into_others():
    """A drawer comes out by 40 cm: to x = 2.45."""
    chest = h.chest(1.8, 2.45, id="chest")
    for gap, met in ((-0.019, False), (-0.021, True)):
        assert bool(strictly(chest, h.chest(2.45 + gap + 0.25, 2.45, math.pi, id="other", travel=0.06))) == met
    for gap, met in ((-0.049, False), (-0.051, True)):
        assert bool(strictly(chest, h.thing("bench", 2.45 + gap + 0.2, 2.45, id="b", size=(0.4, 1.0, 0.45)))) == met
    for gap, met in ((-0.029, False), (-0.031, True)):  # half of what is 6 cm thick
        assert bool(strictly(chest, h.thing("plant", 2.45 + gap + 0.03, 2.45, id="b", size=(0.06, 1.0, 0.45)))) == met


def test_before_and_behind_doors_is_a_way():
    """The door from 1.0 to 1.9 at x = 4.05 in walls of 10 cm: 20 cm before it and 1.8 m up, but for 2 or 5 cm."""
    for x, met in ((3.83, True), (3.81, False)):
        found = strictly(h.thing("bin", x - 0.1, 1.5, id="bin", size=(0.2, 0.2, 0.5)))
        assert found == ([("door_1", "bin")] if met else []), x
    for bottom, met in ((1.74, True), (1.76, False)):
        shelf = h.thing("wall_shelf", 3.9, 1.5, id="shelf", size=(0.2, 0.6, 0.1), bottom=bottom)
        assert (("door_1", "shelf") in strictly(shelf)) == met


def test_joints_open_by_more_than_five_centimetres_and_less_than_ten_metres():
    def told(reach, axis=(1.0, 0.0, 0.0)):
        joint = Joint(name="drawer", type="slide", axis=axis, origin=(0, 0, 0), range=reach, part="slider_drawer",
                      extent=((-0.2, -0.4, -0.3), (0.2, 0.4, 0.3)))
        piece = h.thing("chest", 0.5, 1.5, size=(0.5, 1.0, 0.8), joints=(joint,))
        return "joint" in [f.code for f in check.run(h.home(piece))]

    assert [told((0.0, far)) for far in (0.049, 0.051, 9.9, 10.1)] == [True, False, False, True]
    assert told((0.3, 0.34)) and not told((-0.3, 0.2))


def test_what_stands_on_the_floor_and_goes_through_the_ceiling_is_marked_at_its_top():
    """And what lies below the floor at its bottom."""
    for bottom, at in ((0.0, 2.8), (-0.05, -0.05)):
        tall = h.thing("wardrobe", 2.0, 2.5, bottom=bottom, size=(0.6, 1.5, 2.8))
        (fault,) = (fault for fault in check.run(h.home(tall)) if fault.code == "storey")
        assert fault.at[2] == pytest.approx(at)
