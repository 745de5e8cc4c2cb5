"""A small IFC 2x3 model in millimetres as other programs write them: two storeys, walls without spaces, one door."""

import logging

import pytest
from shapely.geometry import box

from apartgen.stages.plan import PlanConfig, imports
from apartgen.stages.space import polygons

ifcopenshell = pytest.importorskip("ifcopenshell")


def model(spaces: bool) -> bytes:
    """Rooms of 4 × 4 m and 3 × 4 m on the ground floor, which lies at 1 m; a wall alone above."""
    file = ifcopenshell.file(schema="IFC2X3")
    make, count = file.create_entity, iter(range(1000))

    def rooted(kind, name, **fields):
        return make(kind, GlobalId=ifcopenshell.guid.compress(f"{next(count):032x}"), Name=name, **fields)

    def placed(parent, x=0.0, y=0.0, z=0.0):
        axes = make("IfcAxis2Placement3D", make("IfcCartesianPoint", (float(x), float(y), float(z))))
        return make("IfcLocalPlacement", parent and parent.ObjectPlacement, axes)

    context = make(
        "IfcGeometricRepresentationContext",
        None,
        "Model",
        3,
        1e-5,
        make("IfcAxis2Placement3D", make("IfcCartesianPoint", (0.0, 0.0, 0.0))),
        None,
    )

    def prism(x0, y0, x1, y1, height):
        points = [
            make("IfcCartesianPoint", (float(x), float(y)))
            for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))
        ]
        profile = make("IfcArbitraryClosedProfileDef", "AREA", None, make("IfcPolyline", points))
        base = make("IfcAxis2Placement3D", make("IfcCartesianPoint", (0.0, 0.0, 0.0)))
        solid = make("IfcExtrudedAreaSolid", profile, base, make("IfcDirection", (0.0, 0.0, 1.0)), float(height))
        return make(
            "IfcProductDefinitionShape",
            None,
            None,
            [make("IfcShapeRepresentation", context, "Body", "SweptSolid", [solid])],
        )

    milli = make("IfcSIUnit", None, "LENGTHUNIT", "MILLI", "METRE")
    project = rooted(
        "IfcProject", "p", RepresentationContexts=[context], UnitsInContext=make("IfcUnitAssignment", [milli])
    )
    building = rooted("IfcBuilding", "b", ObjectPlacement=placed(None), CompositionType="ELEMENT")
    storeys = [
        rooted("IfcBuildingStorey", name, ObjectPlacement=placed(building, z=z), Elevation=z, CompositionType="ELEMENT")
        for name, z in (("Ground", 1000.0), ("Attic", 3800.0))
    ]
    rooted("IfcRelAggregates", "", RelatingObject=project, RelatedObjects=[building])
    rooted("IfcRelAggregates", "", RelatingObject=building, RelatedObjects=storeys)
    ground, attic = storeys
    rings = [
        (-300, -300, 7400, 0),
        (-300, 4000, 7400, 4300),
        (-300, 0, 0, 4000),
        (7100, 0, 7400, 4000),
        (4000, 0, 4100, 4000),
    ]
    walls = [
        rooted("IfcWallStandardCase", f"w{k}", ObjectPlacement=placed(ground), Representation=prism(*ring, 2500))
        for k, ring in enumerate(rings)
    ]
    void = rooted(
        "IfcOpeningElement",
        "o",
        ObjectPlacement=placed(ground, 4000, 1900),
        Representation=prism(0, -900, 100, 0, 2100),
    )
    door = rooted("IfcDoor", "d", ObjectPlacement=placed(void), OverallWidth=900.0, OverallHeight=2100.0)
    rooted("IfcRelVoidsElement", "", RelatingBuildingElement=walls[4], RelatedOpeningElement=void)
    rooted("IfcRelFillsElement", "", RelatingOpeningElement=void, RelatedBuildingElement=door)
    above = rooted(
        "IfcWallStandardCase", "above", ObjectPlacement=placed(attic), Representation=prism(0, 0, 300, 4000, 2000)
    )
    for storey, parts in ((ground, [*walls, door]), (attic, [above])):
        rooted("IfcRelContainedInSpatialStructure", "", RelatingStructure=storey, RelatedElements=parts)
    if spaces:
        rooms = [
            rooted(
                "IfcSpace",
                str(k),
                LongName=name,
                ObjectPlacement=placed(ground),
                CompositionType="ELEMENT",
                InteriorOrExteriorSpace="INTERNAL",
                Representation=prism(x0, 0, x1, 4000, 2500),
            )
            for k, (name, x0, x1) in enumerate((("Wohnzimmer", 0, 4000), ("Schlafzimmer", 4100, 7100)))
        ]
        rooted("IfcRelAggregates", "", RelatingObject=ground, RelatedObjects=rooms)
    return file.to_string().encode()


@pytest.mark.parametrize("spaces", [True, False])
def test_storeys_units_and_walls_of_the_older_schema(spaces: bool, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.WARNING, "apartgen"):
        plan = imports.read("haus.ifc", model(spaces), PlanConfig())
    assert plan is not None and plan.height == 2.5
    assert any("level" not in m and "storey: 'Ground' taken, 'Attic' left out" in m for m in caplog.messages)
    floors = sorted((polygons.floor(room) for room in plan.rooms), key=lambda floor: floor.bounds)
    assert len(floors) == 2
    for floor, wanted in zip(floors, (box(0, 0, 4, 4), box(4.1, 0, 7.1, 4))):
        assert floor.symmetric_difference(wanted).area < 0.01
    if spaces:
        assert {room.type for room in plan.rooms} == {"living_room", "bedroom"}
    (door,) = [o for o in plan.openings if o.kind == "door"]
    assert sorted(door.segment) == [pytest.approx((4.05, 1.0), abs=1e-3), pytest.approx((4.05, 1.9), abs=1e-3)]
    assert (door.sill, door.head) == (0, 2.1)
    assert (plan.walls.inner, plan.walls.outer) == pytest.approx((0.1, 0.3), abs=1e-3)
