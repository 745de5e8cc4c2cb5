"""A drawing as an office hands it out: millimetres, German layers, walls as strokes with gaps, nothing said twice."""

import io
import logging

import pytest

from apartgen.schemas.layout import Layout
from apartgen.stages import check
from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.space import polygons

ezdxf = pytest.importorskip("ezdxf")


def rectangle(space, x0: float, y0: float, x1: float, y1: float, layer: str) -> None:
    space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": layer})


def flat(unit: int = 4, swings: bool = True) -> bytes:
    """Two rooms of 4 × 4 m and 3 × 4 m: outer walls of 300, one of 100 between with a door 900 wide at y = 1000.

    Without their swings doors are lines from jamb to jamb.
    """
    doc = ezdxf.new("R2010")
    doc.header["$INSUNITS"] = unit
    space = doc.modelspace()
    for x0, y0, x1, y1 in (
        (-300, -300, 5000, 0), (6200, -300, 7400, 0), (-300, 4000, 7400, 4300), (7100, 0, 7400, 4000),
        (-300, 0, 0, 500), (-300, 1500, 0, 4000), (4000, 0, 4100, 1000), (4000, 1900, 4100, 4000),
    ):  # fmt: skip
        rectangle(space, x0, y0, x1, y1, "Wände")
    door = {"layer": "Türen"}
    if swings:
        space.add_line((4050, 1000), (4950, 1000), dxfattribs=door)  # hinged at the bottom, opened into the right room
        space.add_arc((4050, 1000), 900, 0, 90, dxfattribs=door)
        space.add_arc((-150, 500), 1000, 0, 90, dxfattribs=door)  # the entrance, hinged at the bottom, opened inwards
    else:
        space.add_line((4050, 1000), (4050, 1900), dxfattribs=door)
        space.add_line((-150, 500), (-150, 1500), dxfattribs=door)
    for y in (-300, -150, 0):
        space.add_line((5000, y), (6200, y), {"layer": "Fenster"})
    for x in (5000, 6200):
        space.add_line((x, -300), (x, 0), {"layer": "Fenster"})
    for text, x in (("Wohnen", 2000), ("16,0 m²", 2000), ("Schlafen", 5500)):
        space.add_text(text, height=200, dxfattribs={"layer": "Texte"}).set_placement((x, 2500 - 300 * text.count(",")))
    block = doc.blocks.new("BED_DOUBLE")
    rectangle(block, 0, 0, 2000, 1600, "0")
    space.add_blockref("BED_DOUBLE", (5090, 2300), dxfattribs={"layer": "Möbel"})
    space.add_lwpolyline([(-900, -900), (8000, -900)], dxfattribs={"layer": "Bemaßung"})
    out = io.StringIO()
    doc.write(out)
    return out.getvalue().encode()


@pytest.fixture(scope="module")
def read():
    plan = imports.read("grundriss.dxf", flat(), PlanConfig())
    assert isinstance(plan, Layout) and check.quick(plan) == []
    return plan


def test_walls_enclose_the_rooms_and_texts_name_them(read):
    floors = {room.type: polygons.floor(room) for room in read.rooms}
    assert set(floors) == {"living_room", "bedroom"}
    assert floors["living_room"].bounds == pytest.approx((0, 0, 4, 4), abs=0.01)
    assert floors["bedroom"].bounds == pytest.approx((4.1, 0, 7.1, 4), abs=0.01)
    assert floors["living_room"].area + floors["bedroom"].area == pytest.approx(28, abs=0.05)
    assert (read.walls.inner, read.walls.outer) == pytest.approx((0.1, 0.3), abs=0.01)


def test_arcs_are_doors(read):
    by_kind = {o.kind: o for o in read.openings}
    assert sorted(by_kind) == ["door", "entrance", "window"] and len(read.openings) == 3
    door, entrance, window = by_kind["door"], by_kind["entrance"], by_kind["window"]
    assert sorted(door.segment) == [pytest.approx((4.05, 1.0), abs=0.02), pytest.approx((4.05, 1.9), abs=0.02)]
    assert door.segment[door.hinge][1] == pytest.approx(1.0, abs=0.02) and door.into.startswith("bedroom")
    assert sorted(y for _, y in entrance.segment) == pytest.approx([0.5, 1.5], abs=0.02)
    assert entrance.segment[entrance.hinge][1] == pytest.approx(0.5, abs=0.02)
    assert sorted(x for x, _ in window.segment) == pytest.approx([5.0, 6.2], abs=0.03)


def test_a_block_of_furniture_stands_with_its_back_to_the_wall(read):
    (bed,) = read.objects
    assert bed.category == "double_bed" and bed.size[:2] == pytest.approx((2.0, 1.6), abs=0.01)
    assert bed.center[:2] == pytest.approx((6.09, 3.1), abs=0.02)
    assert abs(abs(bed.yaw) - 3.1416) < 0.01  # the nearest wall behind one of its short sides is the right one


def test_the_unit_is_guessed_where_the_file_says_none(caplog):
    with caplog.at_level(logging.WARNING, "apartgen"):
        plan = imports.read("grundriss.dxf", flat(unit=0), PlanConfig())
    assert any("no unit: millimetres taken" in message for message in caplog.messages)
    assert plan is not None and sum(polygons.floor(room).area for room in plan.rooms) == pytest.approx(28, abs=0.05)


def test_doors_may_be_lines_from_jamb_to_jamb():
    plan = imports.read("grundriss.dxf", flat(swings=False), PlanConfig())
    found = {o.kind: sorted(o.segment) for o in plan.openings if o.kind in ("door", "entrance")}
    assert set(found) == {"door", "entrance"}
    assert [y for _, y in found["door"]] == pytest.approx([1.0, 1.9], abs=0.06)
    assert [y for _, y in found["entrance"]] == pytest.approx([0.5, 1.5], abs=0.06)
