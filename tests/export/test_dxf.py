"""The DXF drawing as ezdxf reads it: areas, places and sizes are the home's."""

import re
import sys
from xml.etree import ElementTree

import numpy as np
import pytest
from export import sample
from shapely.geometry import Polygon

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.space import polygons

ezdxf = pytest.importorskip("ezdxf")


SYMBOLS, SVG = "A-FURN-SYMB", "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def drawing(exported):
    return ezdxf.readfile(exported("dxf") / "plan.dxf")


def on(drawing, layer: str, kind: str) -> list:
    return [e for e in drawing.modelspace().query(kind) if e.dxf.layer == layer]


def outline(line) -> Polygon:
    return Polygon([(x, y) for x, y, *_ in line.get_points()])


def test_it_is_a_sound_drawing_in_metres(drawing):
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 6


def test_rooms_are_outlines_with_their_names_in_them(drawing):
    rings = [outline(line) for line in on(drawing, "A-AREA", "LWPOLYLINE")]
    assert sorted(ring.area for ring in rings) == pytest.approx(sorted(
        Polygon(room.polygon).area for room in sample.plan().rooms))
    texts = {text.plain_text().splitlines()[0]: text.dxf.insert for text in on(drawing, "A-AREA-IDEN", "MTEXT")}
    assert set(texts) == {"Living room 1", "Bedroom 1", "Hallway 1", "Bathroom 1"}
    for room in sample.plan().rooms:
        at = texts[room.id.replace("_", " ").capitalize()]
        assert Polygon(room.polygon).contains(polygons.Point(at.x, at.y))


def test_walls_are_those_of_the_plan_and_as_high(drawing):
    lines = on(drawing, "A-WALL", "LWPOLYLINE")
    rings = [outline(line) for line in lines]
    inside = [ring.representative_point() for ring in rings]
    around = [sum(other is not ring and other.contains(at) for other in rings) for ring, at in zip(rings, inside)]
    whole = sum(ring.area * (-1) ** depth for ring, depth in zip(rings, around))
    assert whole == pytest.approx(polygons.walls(sample.plan()).area, abs=1e-3)
    assert {line.dxf.thickness for line in lines} == {sample.plan().height}


def test_doors_are_arcs_about_their_hinges(drawing):
    plan = sample.plan()
    doors = {put.get_attrib_text("ID"): put for put in on(drawing, "A-DOOR", "INSERT")}
    windows = {put.get_attrib_text("ID"): put for put in on(drawing, "A-GLAZ", "INSERT")}
    assert set(doors) | set(windows) == {o.id for o in plan.openings}
    for o in plan.openings:
        if o.into is None:
            continue
        (arc,) = [e for e in doors[o.id].virtual_entities() if e.dxftype() == "ARC"]
        middle = arc.ocs().to_wcs(arc.dxf.center)
        assert (middle.x, middle.y) == pytest.approx(o.segment[o.hinge], abs=1e-4)
        ends = [np.array(p)[:2] for p in (arc.start_point, arc.end_point)]
        assert min(np.hypot(*(end - np.array(o.segment[1 - o.hinge]))) for end in ends) < 1e-4
        leaf = Polygon(next(r for r in plan.rooms if r.id == o.into).polygon)
        assert min(leaf.distance(polygons.Point(end)) for end in ends) == 0
    for window in windows.values():
        assert float(window.get_attrib_text("SILL")) == 0.9 and window.dxf.yscale == pytest.approx(plan.walls.outer)


def test_furniture_is_blocks_of_its_size(drawing):
    home = sample.home()
    put = {insert.get_attrib_text("ID"): insert for insert in on(drawing, "A-FURN", "INSERT")}
    assert set(put) == {o.id for o in home.objects}
    for o in home.objects:
        (box,) = [e for e in put[o.id].virtual_entities() if e.dxftype() == "LWPOLYLINE" and e.dxf.layer != SYMBOLS]
        ring = outline(box)
        assert ring.area == pytest.approx(o.size[0] * o.size[1], rel=1e-4)
        assert (ring.centroid.x, ring.centroid.y) == pytest.approx(o.center[:2], abs=1e-4)
        assert box.dxf.thickness == pytest.approx(o.size[2]) and put[o.id].dxf.insert.z == pytest.approx(
            o.center[2] - o.size[2] / 2)
        (front,) = [e for e in put[o.id].virtual_entities() if e.dxftype() == "LINE"]
        way = np.array(front.dxf.end - front.dxf.start)[:2]
        assert np.cos(np.arctan2(way[1], way[0]) - o.yaw) == pytest.approx(1)


def test_symbols_are_those_of_the_plan_as_text(drawing, exported):
    """Every symbol has its edges at the same places in both, but for the scale and place of the sheet."""
    root = ElementTree.parse(exported("svg") / "plan.svg").getroot()
    groups = {one.get("id"): one for one in root.iter(f"{SVG}g")}
    put = {insert.get_attrib_text("ID"): insert for insert in on(drawing, "A-FURN", "INSERT")}
    there, here = [], []
    for o in sample.home().objects:
        lines = [e for e in put[o.id].virtual_entities() if e.dxf.layer == SYMBOLS]
        paths = [path.get("d") for path in groups[o.id].iter(f"{SVG}path")]
        assert len(lines) == len(paths) > 0
        points = np.array([(x, y) for line in lines for x, y, *_ in line.get_points()])
        sheet = np.array(re.findall(r"(-?[\d.]+) (-?[\d.]+)", " ".join(paths)), float) * (1, -1)
        here.append([points.min(0), points.max(0)])
        there.append([sheet.min(0), sheet.max(0)])
    here, there = (np.array(a).reshape(-1, 2) for a in (here, there))
    scale = (here - here.mean(0)).std() / (there - there.mean(0)).std()
    assert np.abs(here - here.mean(0) - scale * (there - there.mean(0))).max() < 0.005


def test_dimensions_are_of_the_whole_plan(drawing):
    x0, y0, x1, y1 = polygons.shell(sample.plan()).bounds
    found = [one.get_measurement() for one in drawing.modelspace().query("DIMENSION")]
    assert sorted(found) == pytest.approx(sorted([x1 - x0, y1 - y0]))


def test_what_parts_sweep_is_dashed_before_their_fronts(drawing):
    lines = on(drawing, "A-FURN-SWEP", "LWPOLYLINE")
    assert len(lines) >= 5 and {line.dxf.linetype for line in lines} == {"DASHED"}
    opens = [Polygon(boxed(o)) for o in sample.home().objects if o.joints]
    assert all(min(outline(line).distance(box) for box in opens) < 0.02 for line in lines)


def boxed(o):
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    d, w = o.size[0] / 2, o.size[1] / 2
    return [(o.center[0] + c * x - s * y, o.center[1] + s * x + c * y) for x, y in ((d, w), (-d, w), (-d, -w), (d, -w))]


@pytest.mark.parametrize("format", ["dxf", "ifc"])
def test_the_same_home_gives_the_same_bytes(format, exported, tmp_path):
    pytest.importorskip({"dxf": "ezdxf", "ifc": "ifcopenshell"}[format])
    export.run(sample.home(), [format], tmp_path / "again", sample.load)
    (first,) = exported(format).glob(f"*.{format}")
    assert first.read_bytes() == (tmp_path / "again" / first.name).read_bytes()


@pytest.mark.parametrize("format, package", [("dxf", "ezdxf"), ("ifc", "ifcopenshell")])
def test_the_extra_is_named_where_it_is_missing(format, package, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(BadInput, match=rf"{package}: pip install 'apartgen\[cad\]'"):
        export.run(sample.home(), [format], tmp_path / "out", sample.load)
    assert not (tmp_path / "out").exists()
