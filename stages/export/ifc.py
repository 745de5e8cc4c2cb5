"""IFC4 for programs that plan buildings: spaces, walls with openings, doors, windows, furniture as boxes.

In metres; ids are those of the artifact, in `Name`, and GlobalIds follow from them. It takes the extra `apartgen[cad]`.
"""

import hashlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import Polygon

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.stages.export import _walls
from apartgen.stages.export._readback import Refused
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import polygons

NEEDS_ASSETS = False

KINDS = {"chair": "CHAIR", "table": "TABLE", "desk": "DESK", "bed": "BED", "sofa": "SOFA", "shelf": "SHELF"}
"""IFC's own types of furniture, by the end of our categories."""
TIME = "2000-01-01T00:00:00"
LEAF = 0.05
"""Thickness of the bodies of doors and windows, m."""
MORE = 0.01
"""How far an opening reaches beyond the faces of its wall, m."""
Entity = Any
Array = NDArray[np.float64]


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, apartment.ifc."""
    try:
        import ifcopenshell
    except ImportError:
        raise BadInput("IFC needs the package ifcopenshell: pip install 'apartgen[cad]'") from None
    path = out / "apartment.ifc"
    model = _Model(ifcopenshell.file(schema="IFC4"), ifcopenshell.guid.compress)
    model.fill(scene.home)
    path.write_text(model.text(), encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """By IfcOpenShell, which lets pass a file that breaks off."""
    import ifcopenshell

    if not files[0].read_text(encoding="utf-8").rstrip().endswith("END-ISO-10303-21;"):
        raise Refused(f"{files[0].name} breaks off")
    if not ifcopenshell.open(str(files[0])).by_type("IfcSpace"):
        raise Refused(f"{files[0].name} has no spaces")


class _Model:
    """A file being written; what every element needs of it."""

    def __init__(self, file: Any, compress: Any) -> None:
        self.file, self._compress = file, compress
        self.make = file.create_entity
        self._upright = self.make("IfcDirection", (0.0, 0.0, 1.0))
        body = self.make("IfcGeometricRepresentationContext", None, "Model", 3, 1e-5, self.axes((0, 0, 0), 0.0), None)
        self.context = self.make("IfcGeometricRepresentationSubContext", "Body", "Model")
        self.context.ParentContext, self.context.TargetView = body, "MODEL_VIEW"
        self._body = body

    def text(self) -> str:
        """The file, the same for the same home."""
        head = self.file.header
        head.file_name.name, head.file_name.time_stamp = "apartment.ifc", TIME
        head.file_name.originating_system = head.file_name.preprocessor_version = "apartgen"
        head.file_description.description = ("ViewDefinition [ReferenceView_V1.2]",)
        return str(self.file.to_string())

    def guid(self, name: str) -> str:
        """A GlobalId that follows from a name."""
        return str(self._compress(hashlib.sha256(name.encode()).hexdigest()[:32]))

    def axes(self, at: tuple[float, float, float], yaw: float) -> Entity:
        point = self.make("IfcCartesianPoint", tuple(float(v) for v in at))
        along = self.make("IfcDirection", (float(np.cos(yaw)), float(np.sin(yaw)), 0.0))
        return self.make("IfcAxis2Placement3D", point, self._upright, along)

    def placed(self, parent: Entity, at: tuple[float, float, float] = (0, 0, 0), yaw: float = 0.0) -> Entity:
        return self.make("IfcLocalPlacement", parent and parent.ObjectPlacement, self.axes(at, yaw))

    def solid(self, ring: list[tuple[float, float]], low: float, high: float) -> Entity:
        """A prism over a polygon, as the shape of a product."""
        points = [self.make("IfcCartesianPoint", (float(x), float(y))) for x, y in [*ring, ring[0]]]
        profile = self.make("IfcArbitraryClosedProfileDef", "AREA", None, self.make("IfcPolyline", points))
        prism = self.make(
            "IfcExtrudedAreaSolid", profile, self.axes((0, 0, low), 0.0), self._upright, float(high - low)
        )
        shape = self.make("IfcShapeRepresentation", self.context, "Body", "SweptSolid", [prism])
        return self.make("IfcProductDefinitionShape", None, None, [shape])

    def box(self, depth: float, width: float, height: float) -> Entity:
        """A box about the local z axis, from 0 up; depth along x."""
        x, y = depth / 2, width / 2
        return self.solid([(-x, -y), (x, -y), (x, y), (-x, y)], 0.0, height)

    def part(self, kind: str, name: str, **fields: Any) -> Entity:
        """A rooted element."""
        return self.make(kind, GlobalId=self.guid(f"{kind} {name}"), Name=name, **fields)

    def relate(self, kind: str, one: str, whole: Entity, other: str, parts: Any) -> None:
        """A relation, if there is anything to relate."""
        if parts:
            self.make(
                kind,
                GlobalId=self.guid(f"{kind} {whole.Name} {parts[0].Name if isinstance(parts, list) else parts.Name}"),
                **{one: whole, other: parts},
            )

    def fill(self, home: Plan) -> None:
        """The whole apartment."""
        storey = self._building(home)
        spaces = {room.id: self._space(room, storey, home) for room in home.rooms}
        self.relate("IfcRelAggregates", "RelatingObject", storey, "RelatedObjects", list(spaces.values()))
        bodies = _walls.pieces(home)
        walls = [
            self.part(
                "IfcWall",
                f"wall_{k}",
                ObjectPlacement=self.placed(storey),
                PredefinedType="SOLIDWALL",
                Representation=self.solid(list(body.exterior.coords)[:-1], 0.0, home.height),
            )
            for k, body in enumerate(bodies, 1)
        ]
        filled = [self._opening(o, home, storey, bodies, walls) for o in home.openings]
        within = [*walls, *(part for part in filled if part is not None)]
        self.relate("IfcRelContainedInSpatialStructure", "RelatingStructure", storey, "RelatedElements", within)
        objects = home.objects if isinstance(home, Layout) else []
        for room in home.rooms:
            things = [self._furniture(o, spaces[room.id]) for o in objects if o.room == room.id]
            self.relate(
                "IfcRelContainedInSpatialStructure", "RelatingStructure", spaces[room.id], "RelatedElements", things
            )

    def _building(self, home: Plan) -> Entity:
        units = [
            self.make("IfcSIUnit", None, kind, None, name)
            for kind, name in (
                ("LENGTHUNIT", "METRE"),
                ("AREAUNIT", "SQUARE_METRE"),
                ("VOLUMEUNIT", "CUBIC_METRE"),
                ("PLANEANGLEUNIT", "RADIAN"),
            )
        ]
        project = self.part(
            "IfcProject",
            home.prompt[:200] or "apartment",
            RepresentationContexts=[self._body],
            UnitsInContext=self.make("IfcUnitAssignment", units),
        )
        before = project
        for kind in ("IfcSite", "IfcBuilding", "IfcBuildingStorey"):
            parent = before if kind != "IfcSite" else None
            next_ = self.part(kind, kind[3:].lower(), ObjectPlacement=self.placed(parent), CompositionType="ELEMENT")
            self.relate("IfcRelAggregates", "RelatingObject", before, "RelatedObjects", [next_])
            before = next_
        before.Elevation = 0.0
        return before

    def _space(self, room: Room, storey: Entity, home: Plan) -> Entity:
        return self.part(
            "IfcSpace",
            room.id,
            LongName=room.type.replace("_", " ").capitalize(),
            ObjectType=room.type,
            ObjectPlacement=self.placed(storey),
            CompositionType="ELEMENT",
            PredefinedType="EXTERNAL" if room.base == "balcony" else "INTERNAL",
            Representation=self.solid(list(room.polygon), 0.0, home.height),
        )

    def _opening(
        self, o: Opening, home: Plan, storey: Entity, bodies: list[Polygon], walls: list[Entity]
    ) -> Entity | None:
        """The hole in its wall, and what fills it; None for a passage, and for what is in a railing."""
        cut = _walls.hole(o, home)
        shares = [cut.intersection(body).area for body in bodies]
        if not shares or max(shares) < 0.2 * cut.area:
            return None
        at, yaw, width, ahead, back = _frame(o, home)
        void = self.part(
            "IfcOpeningElement",
            o.id,
            ObjectPlacement=self.placed(storey, (*at, o.sill), yaw),
            PredefinedType="OPENING",
            Representation=self.solid(
                [(0, -back - MORE), (width, -back - MORE), (width, ahead + MORE), (0, ahead + MORE)],
                0.0,
                o.head - o.sill,
            ),
        )
        for wall in [walls[int(np.argmax(shares))]]:
            self.relate("IfcRelVoidsElement", "RelatingBuildingElement", wall, "RelatedOpeningElement", void)
        if o.kind == "opening":
            return None
        kind = "IfcWindow" if o.kind == "window" else "IfcDoor"
        turn = (
            {}
            if o.into is None or kind == "IfcWindow"
            else {"OperationType": "SINGLE_SWING_LEFT" if _hinged_left(o, home) else "SINGLE_SWING_RIGHT"}
        )
        leaf = [(0, -LEAF / 2), (width, -LEAF / 2), (width, LEAF / 2), (0, LEAF / 2)]
        filler = self.part(
            kind,
            o.id,
            ObjectPlacement=self.placed(void),
            OverallHeight=o.head - o.sill,
            OverallWidth=width,
            PredefinedType=kind[3:].upper(),
            Representation=self.solid(leaf, 0.0, o.head - o.sill),
            **turn,
        )
        self.relate("IfcRelFillsElement", "RelatingOpeningElement", void, "RelatedBuildingElement", filler)
        return filler

    def _furniture(self, o: Box, space: Entity) -> Entity:
        """A box whose x is its front; the space's own frame is the storey's."""
        d, w, h = o.size
        x, y, z = o.center
        kind = next((own for end, own in KINDS.items() if o.category.endswith(end)), "USERDEFINED")
        return self.part(
            "IfcFurniture",
            o.id,
            ObjectType=o.category,
            PredefinedType=kind,
            Representation=self.box(d, w, h),
            ObjectPlacement=self.placed(space, (x, y, z - h / 2), o.yaw),
        )


def _frame(o: Opening, home: Plan) -> tuple[tuple[float, float], float, float, float, float]:
    """Where an opening's frame begins, its yaw and width, and how far its wall's faces are before and behind it.

    y points into the room that the leaf opens into, as IFC has it for doors.
    """
    room = o.into or o.rooms[0]
    normal, ahead = polygons.face(o, home, room)
    others = [name for name in o.rooms if name != room]
    back = polygons.face(o, home, others[0])[1] if others else home.walls.outer - ahead
    along: Array = np.array([normal[1], -normal[0]])
    start = min(np.asarray(o.segment, float), key=lambda end: float(end @ along))
    return (float(start[0]), float(start[1])), float(np.arctan2(along[1], along[0])), polygons.width(o), ahead, back


def _hinged_left(o: Opening, home: Plan) -> bool:
    (x, y), *_ = _frame(o, home)
    return bool(np.hypot(*np.subtract(o.segment[o.hinge], (x, y))) < 1e-6)
