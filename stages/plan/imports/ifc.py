"""IFC models (`.ifc`): spaces, walls, doors, windows and furniture of one storey. Takes the extra `apartgen[cad]`."""

import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import Polygon

from apartgen.schemas.base import Point
from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.drawing import Drawing, Hole, Space, Thing
from apartgen.stages.plan.drawing import names as room_names
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.words import OTHER, category

Array = NDArray[np.float64]
Entity = Any
WALLS = ("IfcWall", "IfcColumn", "IfcCurtainWall")
FURNITURE = ("IfcFurnishingElement", "IfcSanitaryTerminal", "IfcElectricAppliance", "IfcLightFixture", "IfcLamp")
OURS = "apartgen"
"""The program that says which side of a thing is its front."""
THROUGH = 1.8
"""Holes as high as this that nothing fills are walked through, m."""
LOW = 0.3
FLAT = 1e-6


class Solid(NamedTuple):
    """Corners of a body, (n, 3), its triangles, and the frame it was placed in: m, the world's axes."""

    corners: Array
    faces: NDArray[np.int64]
    frame: Array

    def floor(self) -> Polygon:
        """What it covers seen from above, its largest part."""
        rings = self.corners[self.faces][:, :, :2]
        flat = [triangle for triangle in shapely.polygons(rings) if triangle.area > FLAT]
        whole = shapely.union_all(flat, grid_size=1e-5) if flat else Polygon()
        return max(shapely.get_parts(whole), key=lambda part: part.area, default=Polygon())

    def box(self) -> tuple[Array, Array]:
        """Least and greatest corner along the axes of its frame, upright."""
        x, y = self.frame[:2, 0] / np.hypot(*self.frame[:2, 0])
        turned = (self.corners[:, :2] - self.frame[:2, 3]) @ np.array([[x, -y], [y, x]])
        local = np.column_stack([turned, self.corners[:, 2]])
        return local.min(0), local.max(0)

    def world(self, x: float, y: float) -> Point:
        """A point given along the axes of the frame."""
        across = self.frame[:2, 0] / np.hypot(*self.frame[:2, 0])
        p = self.frame[:2, 3] + x * across + y * np.array([-across[1], across[0]])
        return float(p[0]), float(p[1])


def holds(name: str, data: bytes) -> bool:
    """A STEP file of an IFC schema."""
    return data.lstrip()[:12] == b"ISO-10303-21" and b"IFC" in data[:20_000].upper()


def read(name: str, data: bytes) -> Drawing:
    """The storey with the most spaces, else with the most walls."""
    model, said = _Model(data), list[str]()
    storey = model.storey(said)
    solids = [
        (space, solid) for space in model.on(storey, "IfcSpace") if (solid := model.solid(space, said)) is not None
    ]
    low = float(np.median([solid.corners[:, 2].min() for _, solid in solids])) if solids else model.elevation(storey)
    walls = [
        solid for kind in WALLS for wall in model.on(storey, kind) if (solid := model.solid(wall, said)) is not None
    ]
    tall = [float(np.ptp(solid.corners[:, 2])) for solid in ([s for _, s in solids] or walls)]
    stand = [floor for solid in walls if not (floor := solid.floor()).is_empty]
    things = [
        model.thing(part, solid, low)
        for kind in FURNITURE
        for part in model.on(storey, kind)
        if (solid := model.solid(part, said)) is not None
    ]
    return Drawing(
        spaces=[Space(_called(space), solid.floor()) for space, solid in solids], walls=stand, things=things, said=said,
        holes=list(model.holes(storey, low, said)), height=float(np.median(tall)) if tall else None,
    )  # fmt: skip


def _called(space: Entity) -> str:
    """The space's name that speaks of a type of room, else any."""
    given = [str(text) for text in (space.Name, space.LongName, space.ObjectType) if text]
    return next((text for text in given if room_names.read(text)), given[-1] if given else "")


class _Model:
    """An open file."""

    def __init__(self, data: bytes) -> None:
        try:
            import ifcopenshell
            import ifcopenshell.geom
            import ifcopenshell.util.element
            import ifcopenshell.util.placement
            import ifcopenshell.util.unit
        except ImportError:
            raise BadInput("IFC needs the package ifcopenshell: pip install 'apartgen[cad]'") from None
        self._ifc = ifcopenshell
        try:
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder, "model.ifc")
                path.write_bytes(data)
                self.file = ifcopenshell.open(str(path))
            self.scale = float(ifcopenshell.util.unit.calculate_unit_scale(self.file))
        except Exception as error:  # the library raises whatever its parser meets
            raise BadInput(f"no IFC that can be read: {error}") from None
        self._settings = ifcopenshell.geom.settings()
        self._settings.set("use-world-coords", True)
        self._settings.set("disable-opening-subtractions", True)
        made = [str(self.file.header.file_name.originating_system or "")]
        self.ours = any(OURS in text for text in made)

    def storey(self, said: list[str]) -> Entity | None:
        """The fullest storey; None where the file has none."""
        counts: Counter[int] = Counter()
        for kind, weight in (("IfcSpace", 1000), ("IfcWall", 1)):
            for part in self.file.by_type(kind):
                if (found := self._storey_of(part)) is not None:
                    counts[found.id()] += weight
        storeys = [storey for storey in self.file.by_type("IfcBuildingStorey") if counts[storey.id()]]
        if not storeys:
            return None
        taken = max(storeys, key=lambda storey: counts[storey.id()])
        if len(storeys) > 1:
            left = ", ".join(repr(storey.Name or "") for storey in storeys if storey != taken)
            said.append(f"a plan is one storey: {taken.Name or ''!r} taken, {left} left out")
        return taken

    def _storey_of(self, part: Entity) -> Entity | None:
        """What an element stands on, through spaces and assemblies."""
        seen = part
        for _ in range(8):
            if seen is None or seen.is_a("IfcBuildingStorey"):
                return seen
            seen = self._ifc.util.element.get_container(seen) or self._ifc.util.element.get_aggregate(seen)
        return None

    def on(self, storey: Entity | None, kind: str) -> list[Entity]:
        """The storey's elements of a kind, in the order of the file."""
        try:
            parts = self.file.by_type(kind)
        except RuntimeError:  # a kind that the file's schema does not have
            return []
        return [part for part in parts if storey is None or self._storey_of(part) == storey]

    def elevation(self, storey: Entity | None) -> float:
        return float(getattr(storey, "Elevation", 0.0) or 0.0) * self.scale

    def solid(self, part: Entity, said: list[str]) -> Solid | None:
        """The body of an element; None where it has none that can be made."""
        if part is None or part.Representation is None:
            return None
        try:
            shape = self._ifc.geom.create_shape(self._settings, part)
        except RuntimeError:
            said.append(f"{part.is_a()} {part.Name or part.GlobalId}: its shape cannot be made: left out")
            return None
        corners = np.array(shape.geometry.verts, float).reshape(-1, 3)
        faces = np.array(shape.geometry.faces, np.int64).reshape(-1, 3)
        frame = np.array(self._ifc.util.placement.get_local_placement(part.ObjectPlacement), float)
        frame[:3, 3] *= self.scale
        return Solid(corners, faces, frame) if len(faces) and np.isfinite(corners).all() else None

    def holes(self, storey: Entity | None, low: float, said: list[str]) -> Iterator[Hole]:
        """Doors and windows, and high holes that nothing fills."""
        for kind, ours in (("IfcDoor", "door"), ("IfcWindow", "window")):
            for part in self.on(storey, kind):
                voids = [rel.RelatingOpeningElement for rel in part.FillsVoids or ()]
                if (solid := self.solid(voids[0] if voids else part, said)) is not None:
                    frame = np.array(self._ifc.util.placement.get_local_placement(part.ObjectPlacement), float)
                    frame[:3, 3] *= self.scale
                    yield _hole(part, ours, solid._replace(frame=frame), low)
        for wall in self.on(storey, "IfcWall"):
            for rel in wall.HasOpenings or ():
                void = rel.RelatedOpeningElement
                if not void.HasFillings and (solid := self.solid(void, said)) is not None:
                    bottom, top = solid.corners[:, 2].min() - low, solid.corners[:, 2].max() - low
                    if bottom < LOW and top > THROUGH:
                        yield _hole(void, "opening", solid, low)

    def thing(self, part: Entity, solid: Solid, low: float) -> Thing:
        """The box of a piece along its own axes; only our own files say that x is its front."""
        lo, hi = solid.box()
        size = np.maximum(hi - lo, 0.01)
        x, y = solid.world(*(float(v) for v in 0.5 * (lo + hi)[:2]))
        given = [str(text) for text in (part.ObjectType, part.Name, getattr(part, "PredefinedType", "")) if text]
        called = next((text for text in given if text in TABLE or category(text) != OTHER), given[0] if given else "")
        yaw = float(np.arctan2(solid.frame[1, 0], solid.frame[0, 0]))
        middle = (x, y, float(0.5 * (lo + hi)[2]) - low)
        return Thing(called, middle, (float(size[0]), float(size[1]), float(size[2])), yaw, turned=self.ours)


def _hole(part: Entity, kind: Any, solid: Solid, low: float) -> Hole:
    """Along x of the frame of the door, or of whichever axis is longer where it is told wrong."""
    lo, hi = solid.box()
    middle = 0.5 * (lo + hi)
    along = hi[0] - lo[0] >= min(0.3, 0.9 * (hi[1] - lo[1]))
    ends = [(lo[0], middle[1]), (hi[0], middle[1])] if along else [(middle[0], lo[1]), (middle[0], hi[1])]
    turn = str(getattr(part, "OperationType", None) or "")
    hinge = swung = None
    if along and turn in ("SINGLE_SWING_LEFT", "SINGLE_SWING_RIGHT"):
        side = float(ends[turn.endswith("RIGHT")][0])
        hinge, swung = solid.world(side, float(middle[1])), solid.world(side, float(middle[1] + hi[0] - lo[0]))
    a, b = (solid.world(float(x), float(y)) for x, y in ends)
    return Hole(str(part.Name or ""), kind, (a, b), float(lo[2]) - low, float(hi[2]) - low, hinge, swung)
