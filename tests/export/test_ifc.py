"""The IFC model as ifcopenshell reads it: bodies have the home's volumes, doors its hinges."""

import numpy as np
import pytest
from export import sample
from shapely.geometry import Polygon

from apartgen.stages.space import polygons

ifcopenshell = pytest.importorskip("ifcopenshell")


@pytest.fixture(scope="module")
def model(exported):
    return ifcopenshell.open(str(exported("ifc") / "apartment.ifc"))


def body(part, cut: bool = True) -> tuple[np.ndarray, float]:
    """Corners in the world and the volume of an element's body."""
    import ifcopenshell.geom

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    settings.set("disable-opening-subtractions", not cut)
    geometry = ifcopenshell.geom.create_shape(settings, part).geometry
    corners = np.array(geometry.verts).reshape(-1, 3)
    a, b, c = corners[np.array(geometry.faces).reshape(-1, 3)].transpose(1, 0, 2)
    return corners, float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def test_it_is_valid_ifc4(model):
    import ifcopenshell.validate

    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log)
    assert model.schema == "IFC4" and log.statements == []
    ids = [part.GlobalId for part in model.by_type("IfcRoot")]
    assert len(set(ids)) == len(ids)


def test_spaces_are_the_rooms(model):
    plan = sample.plan()
    spaces = {space.Name: space for space in model.by_type("IfcSpace")}
    assert set(spaces) == {room.id for room in plan.rooms}
    for room in plan.rooms:
        assert spaces[room.id].ObjectType == room.type
        assert body(spaces[room.id])[1] == pytest.approx(Polygon(room.polygon).area * plan.height, rel=1e-4)


def test_walls_fill_what_is_between_and_are_cut_by_openings(model):
    plan = sample.plan()
    floors = sum(Polygon(room.polygon).area for room in plan.rooms)
    whole = (polygons.shell(plan).area - floors) * plan.height
    walls = model.by_type("IfcWall")
    assert sum(body(wall, cut=False)[1] for wall in walls) == pytest.approx(whole, rel=1e-3)
    thick = {1: plan.walls.outer, 2: plan.walls.inner}
    holes = sum(polygons.width(o) * (o.head - o.sill) * thick[len(o.rooms)] for o in plan.openings)
    assert sum(body(wall)[1] for wall in walls) == pytest.approx(whole - holes, rel=2e-3)
    assert len(model.by_type("IfcRelVoidsElement")) == len(plan.openings)


def test_doors_turn_as_the_plan_says(model):
    import ifcopenshell.util.placement

    plan = sample.plan()
    parts = {part.Name: part for part in (*model.by_type("IfcDoor"), *model.by_type("IfcWindow"))}
    assert set(parts) == {o.id for o in plan.openings if o.kind != "opening"}
    for o in plan.openings:
        part = parts[o.id]
        assert part.OverallWidth == pytest.approx(polygons.width(o))
        assert part.OverallHeight == pytest.approx(o.head - o.sill)
        frame = ifcopenshell.util.placement.get_local_placement(part.ObjectPlacement)
        if part.is_a("IfcDoor"):  # y is where it opens to, and a left one is hinged at the origin
            left = part.OperationType == "SINGLE_SWING_LEFT"
            at = frame[:2, 3] + (0 if left else part.OverallWidth) * frame[:2, 0]
            assert at.tolist() == pytest.approx(o.segment[o.hinge], abs=1e-4)
            ahead = polygons.Point(np.mean(o.segment, axis=0) + 0.4 * frame[:2, 1])
            assert Polygon(next(r for r in plan.rooms if r.id == o.into).polygon).contains(ahead)


def test_furniture_is_boxes_in_its_space(model):
    home = sample.home()
    things = {part.Name: part for part in model.by_type("IfcFurniture")}
    assert set(things) == {o.id for o in home.objects}
    for o in home.objects:
        corners, volume = body(things[o.id])
        assert volume == pytest.approx(float(np.prod(o.size)), rel=1e-4)
        assert (corners.min(0) + corners.max(0)) / 2 == pytest.approx(np.array(o.center), abs=1e-4)
        (held,) = things[o.id].ContainedInStructure
        assert held.RelatingStructure.Name == o.room and things[o.id].ObjectType == o.category


def test_what_is_in_a_railing_is_no_hole_in_a_wall(tmp_path):
    """A window of a room becomes a passage through the rail once the room is a balcony; the door stays in its wall."""
    import handmade as h

    from apartgen.stages import export

    names = {}
    for kind in ("bedroom", "balcony"):
        home = h.home()
        rooms = [room.model_copy(update={"type": kind}) if room.id == h.BEDROOM else room for room in home.rooms]
        export.run(home.model_copy(update={"rooms": rooms}), ["ifc"], tmp_path / kind, sample.load)
        found = ifcopenshell.open(str(next((tmp_path / kind).rglob("*.ifc"))))
        names[kind] = {part.Name for part in found.by_type("IfcOpeningElement")}
    assert names == {"bedroom": {"entrance_1", "door_1", "window_1"}, "balcony": {"entrance_1", "door_1"}}
