"""What a file of another program lacks is completed and said; what is wrong is an error with its place."""

import io
import json
import logging
import re
import zipfile
from pathlib import Path

import numpy as np
import pytest
from plan.imports import homes, writers
from shapely.geometry import Polygon, box

from apartgen.schemas import consistency
from apartgen.schemas.errors import ApartgenError, BadInput, Unmet
from apartgen.schemas.layout import Layout
from apartgen.stages import check, registry
from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.plan.drawing import Drawing, Space, Thing, completed, floors, furniture
from apartgen.stages.plan.imports import roomplan


def zipped(xml: str) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("Home.xml", f"<home wallHeight='250'>{xml}</home>")
    return out.getvalue()


def room(x0: float, y0: float, x1: float, y1: float, name: str = "") -> str:
    corners = "".join(f"<point x='{x}' y='{y}'/>" for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))
    return f"<room name='{name}'>{corners}</room>"


def wall(x0: float, y0: float, x1: float, y1: float, thick: float = 10) -> str:
    return f"<wall xStart='{x0}' yStart='{y0}' xEnd='{x1}' yEnd='{y1}' thickness='{thick}'/>"


def read(xml: str, caplog: pytest.LogCaptureFixture):
    caplog.clear()
    with caplog.at_level(logging.WARNING, "apartgen"):
        plan = imports.read("home.sh3d", zipped(xml), PlanConfig())
    assert plan is not None and check.quick(plan) == []
    return plan, " | ".join(caplog.messages)


PAIR = room(5, 5, 395, 395, "Living room") + room(405, 5, 695, 395, "Bedroom")


def test_doors_an_entrance_and_windows_are_put_in(caplog: pytest.LogCaptureFixture) -> None:
    plan, said = read(PAIR, caplog)
    assert sorted(o.kind for o in plan.openings if o.kind != "window") == ["door", "entrance"]
    assert {o.rooms[0] for o in plan.openings if o.kind == "window"} == {"living_room_1", "bedroom_1"}
    for words in ("no door leads to bedroom_1", "no entrance", "no window"):
        assert words in said


def test_rooms_without_a_wall_between_are_open_to_each_other(caplog: pytest.LogCaptureFixture) -> None:
    around = wall(0, 0, 700, 0) + wall(700, 0, 700, 400) + wall(700, 400, 0, 400) + wall(0, 400, 0, 0)
    both = room(5, 5, 400, 395, "Living room") + room(400, 5, 695, 395, "Kitchen")
    plan, _ = read(around + both, caplog)
    (wide,) = [o for o in plan.openings if o.kind == "opening"]
    assert np.hypot(*np.subtract(*wide.segment)) > 3.6 and plan.program.open_links
    plan, _ = read(around + wall(400, 0, 400, 400) + both, caplog)
    assert [o.kind for o in plan.openings if len(o.rooms) == 2] == ["door"]


def test_thick_walls_keep_their_openings(caplog: pytest.LogCaptureFixture) -> None:
    door = "<doorOrWindow name='Door' x='420' y='200' angle='1.5707963' width='90' depth='10' height='205'/>"
    plan, _ = read(room(0, 0, 400, 400, "Living room") + room(440, 0, 700, 400, "Bedroom") + door, caplog)
    (found,) = [o for o in plan.openings if o.kind == "door"]
    assert [x for x, _ in found.segment] == [4.2, 4.2] and plan.walls.inner == 0.4


def test_one_thick_wall_among_thin_ones_keeps_its_door(caplog: pytest.LogCaptureFixture) -> None:
    """Readers look for the rooms of a door as far from it as the thickest walls of the plan go."""
    rooms = room(0, 0, 400, 400, "Living room") + room(460, 0, 700, 400, "Bedroom")
    rooms += room(0, 410, 340, 700, "Kitchen") + room(350, 410, 700, 700, "Study")
    around = wall(-5, -5, 705, -5) + wall(705, -5, 705, 705) + wall(705, 705, -5, 705) + wall(-5, 705, -5, -5)
    door = "<doorOrWindow name='Door' x='430' y='200' angle='1.5707963' width='90' depth='10' height='205'/>"
    plan, _ = read(rooms + around + wall(430, 0, 430, 400, 60) + door, caplog)
    found = [o for o in plan.openings if o.kind == "door" and [x for x, _ in o.segment] == [4.3, 4.3]]
    assert len(found) == 1 and plan.walls.inner == 0.1


def test_what_cannot_be_taken_is_said(caplog: pytest.LogCaptureFixture) -> None:
    lost = "<doorOrWindow name='Garden gate' x='1500' y='200' width='90' depth='10' height='205'/>"
    odd = "<pieceOfFurniture name='Harp' x='200' y='200' width='90' depth='90' height='180'/>"
    shed = room(3000, 0, 3300, 300, "Storage")
    plan, said = read(PAIR + lost + odd + shed, caplog)
    assert len(plan.rooms) == 2 and not isinstance(plan, Layout)
    for words in ("Garden gate at (14.55, -2.00) is in no wall", "no furniture known here: Harp", "stands apart"):
        assert words in said, said


def test_gardens_are_no_rooms(caplog: pytest.LogCaptureFixture) -> None:
    plan, said = read(PAIR + room(-400, 405, 1100, 900, "Back garden"), caplog)
    assert [r.id for r in plan.rooms] == ["living_room_1", "bedroom_1"] and "out of doors: 'Back garden'" in said


@pytest.mark.parametrize("x, y, far", [(300000, 200000, True), (60000, 0, True), (0, -90000, True), (10000, 0, False)])
def test_drawings_far_from_their_origin_are_moved(x: int, y: int, far: bool, caplog: pytest.LogCaptureFixture) -> None:
    """Surveyed ones, kilometres or half of one away; not one that is drawn on a wide sheet."""
    drawn = room(x + 5, y + 5, x + 395, y + 395, "Living room") + room(x + 405, y + 5, x + 695, y + 395, "Bedroom")
    plan, said = read(drawn, caplog)
    off = max(float(np.abs(r.polygon).max()) for r in plan.rooms)
    assert ("moved to the origin" in said, off < 20) == (far, far)


def test_furniture_in_a_wall_is_moved_out_of_it(caplog: pytest.LogCaptureFixture) -> None:
    sofa = "<pieceOfFurniture name='Sofa' x='200' y='45' width='200' depth='90' height='80'/>"
    plan, _ = read(PAIR + sofa, caplog)
    (found,) = plan.objects
    assert found.center[1] == pytest.approx(-0.5) and found.yaw == pytest.approx(-np.pi / 2, abs=1e-4)


BROKEN = {
    "no Sweet Home 3D file": b"PK\x03\x04 not a zip",
    "Home.xml is no XML": zipped("<room>"),
    "room Attic: its outline is no polygon .*Self-intersection.2 -2": zipped(
        "<room name='Attic'><point x='0' y='0'/><point x='400' y='400'/><point x='400' y='0'/>"
        "<point x='0' y='400'/></room>"),
    "wall w7: xStart is 'left', no number": zipped("<wall id='w7' xStart='left' yStart='0' xEnd='1' yEnd='0'/>"),
    "rooms Hall and Bath lie over each other by 1.00 m²": zipped(
        room(0, 0, 400, 400, "Hall") + room(300, 300, 700, 700, "Bath")),
    "no room": zipped(wall(0, 0, 400, 0)),
}  # fmt: skip


@pytest.mark.parametrize("fault", BROKEN)
def test_what_is_wrong_is_an_error_with_its_place(fault: str) -> None:
    with pytest.raises(BadInput, match=f"home.sh3d: .*{fault}"):
        imports.read("home.sh3d", BROKEN[fault], PlanConfig())


def test_a_room_that_no_door_can_lead_to_is_told() -> None:
    apart = room(0, 0, 400, 400, "Hall") + room(400, 400, 700, 700, "Bath")  # they meet in a corner
    with pytest.raises(Unmet, match="no door leads to bathroom_1 at"):
        imports.read("home.sh3d", zipped(apart), PlanConfig())


@pytest.mark.parametrize("key", ["walls", "objects", "doors"])
def test_a_scan_with_a_broken_part_names_it(key: str) -> None:
    raw = json.loads(writers.roomplan(homes.furnished("studio", 0)))
    raw[key][1]["transform"] = raw[key][1]["transform"][:7]
    with pytest.raises(BadInput, match=rf"scan.json: {key}\[1\]"):
        imports.read("scan.json", json.dumps(raw).encode(), PlanConfig())


def test_a_scan_without_floors_has_the_rooms_that_its_walls_enclose() -> None:
    home = homes.furnished("one_bedroom", 1)
    raw = json.loads(writers.roomplan(home))
    raw["floors"] = []
    plan = imports.read("scan.json", json.dumps(raw).encode(), PlanConfig())
    assert plan is not None and len(plan.rooms) == len(home.rooms) and check.quick(plan) == []
    given, found = (sum(Polygon(r.polygon).area for r in p.rooms) for p in (home, plan))
    assert found == pytest.approx(given, rel=0.02)


@pytest.mark.parametrize(("height", "name"), [
    (0.8, "sideboard"), (1.55, "sideboard"), (1.65, "wardrobe"), (2.4, "wardrobe")])
def test_storage_that_is_tall_is_a_wardrobe(height: float, name: str) -> None:
    """A scan tells storage of any kind by one word."""
    raw = json.loads(writers.roomplan(homes.furnished("studio", 0)))
    one = dict(raw["objects"][0])
    raw["objects"] = [one | {"category": {"storage": {}}, "dimensions": [1.0, height, 0.5]}]
    (thing,) = roomplan.read("scan.json", json.dumps(raw).encode()).things
    assert (thing.name, thing.size) == (name, (0.5, 1.0, height))


def spoilt(data: bytes, rng: np.random.Generator) -> bytes:
    """The file cut off, with letters changed, or with other numbers in it."""
    kind = int(rng.integers(3))
    if kind == 0:
        return data[: int(rng.integers(len(data)))]
    text = bytearray(data)
    if kind == 1:
        for at in rng.integers(len(text), size=3):
            text[at] = int(rng.integers(32, 126))
        return bytes(text)
    numbers = list(re.finditer(rb"-?\d+\.?\d*", data))
    for k in rng.integers(len(numbers), size=4):
        lo, hi = numbers[k].span()
        text[lo:hi] = bytes(rng.choice([b"0", b"-1", b"1e9", b"nan", b"3"]))[: hi - lo].ljust(hi - lo)
    return bytes(text)


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("format", ["sh3d", "roomplan", "procthor", "dxf", "ifc"])
def test_broken_files_are_errors_and_nothing_else(format: str, seed: int, tmp_path: Path) -> None:
    home, rng = homes.furnished("studio", 0), np.random.default_rng([5, seed])
    if format in ("dxf", "ifc"):
        pytest.importorskip({"dxf": "ezdxf", "ifc": "ifcopenshell"}[format])
        from apartgen.stages.scene.scene import Scene

        (path,) = registry.load("apartgen.stages.export", format).write(Scene(home, lambda *_: None), tmp_path)
        name, data = path.name, spoilt(path.read_bytes(), rng)
    elif format == "sh3d":
        with zipfile.ZipFile(io.BytesIO(writers.sh3d(home))) as archive:
            xml = archive.read("Home.xml")
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w") as archive:
            archive.writestr("Home.xml", spoilt(xml, rng))
        name, data = "home.sh3d", out.getvalue()
    else:
        name, data = (
            "home.json",
            spoilt({"roomplan": writers.roomplan, "procthor": writers.procthor}[format](home), rng),
        )
    try:
        plan = imports.read(name, data, PlanConfig())
    except ApartgenError as error:
        assert str(error).startswith(f"{name}: ")
    else:
        assert plan is None or not list(consistency.faults(plan))


def test_other_files_are_left_to_others() -> None:
    for data in (b'{"rooms": []}', b"", b"[]", b"PK\x05\x06" + 18 * b"\0"):
        assert imports.read("x.json", data, PlanConfig()) is None


def test_what_has_no_body_is_left_out(caplog: pytest.LogCaptureFixture) -> None:
    piece = "<pieceOfFurniture name='sofa' x='200' y='200' width='180' depth='{}' height='80'/>"
    plan, said = read(PAIR + piece.format(90), caplog)
    assert [o.category for o in plan.objects] == ["sofa"] and "without a body" not in said
    plan, said = read(PAIR + piece.format("0.001"), caplog)
    assert not getattr(plan, "objects", []) and "left out, without a body: sofa" in said


def test_what_is_nested_without_end_is_told() -> None:
    deep = b'{"floorPolygon": ' + b"[" * 100_000
    with pytest.raises(BadInput, match="house.json: broken where procthor does not allow it"):
        imports.read("house.json", deep, PlanConfig())


@pytest.mark.parametrize("x, y", [(2e8, 0.0), (0.0, 2e8), (-2e8, 3.0)])
def test_what_lies_off_the_earth_is_refused_along_either_axis(x: float, y: float) -> None:
    far = Polygon([(x, y), (x + 4, y), (x + 4, y + 3), (x, y + 3)])
    near = Polygon([(9e7, 0), (9e7 + 4, 0), (9e7 + 4, 3), (9e7, 3)])
    assert completed._measured(Drawing(spaces=[Space("", near)]), []).spaces
    for drawing in (Drawing(spaces=[Space("", near), Space("", far)]), Drawing(walls=[far])):
        with pytest.raises(BadInput, match="no place on earth"):
            completed._measured(drawing, [])


@pytest.mark.parametrize("at, wall", [((0.3, 2.0), 0.0), ((4.7, 2.0), np.pi), ((2.5, 0.3), np.pi / 2),
                                      ((2.5, 3.7), -np.pi / 2)])
@pytest.mark.parametrize("turned", [False, True])
def test_what_has_a_back_turns_it_to_the_wall_that_it_stands_at(
        at: tuple[float, float], wall: float, turned: bool) -> None:
    """A wardrobe in a room of 5 m by 4, drawn the right way round or with its doors to the wall."""
    size, yaw = furniture._faced(Thing("", (*at, 1.0), (0.6, 1.2, 2.0), wall + np.pi * turned), "wardrobe",
                                 Polygon([(0, 0), (5, 0), (5, 4), (0, 4)]))
    assert size == (0.6, 1.2) and np.cos(yaw - wall) == pytest.approx(1)


@pytest.mark.parametrize("deep, kept", [(0.8, True), (0.5, False)])
def test_a_room_of_less_than_six_tenths_of_a_square_metre_is_left_out_and_told_of(deep: float, kept: bool) -> None:
    said: list[str] = []
    floor = floors._clear(Space("closet", box(0, 0, 1, deep)), Polygon(), said)
    assert (floor is not None) == kept and [entry.split(" at ")[0] for entry in said] == ["closet"] * (not kept)
