"""DXF drawings: rooms, walls, doors, windows and furniture, told by their layers and blocks. Takes `apartgen[cad]`.

Layers and blocks are known by words of several languages in their names: A-WALL, Wände, murs. Rooms are closed outlines
with their names written in them, or what the lines of walls enclose.
"""

import io
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import LineString, Point, Polygon

from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.drawing import Drawing, Hole, Label, Space, Thing
from apartgen.stages.plan.drawing import names as room_names
from apartgen.stages.plan.imports import _lines
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.words import OTHER, category

Array = NDArray[np.float64]
Entity = Any
WORDS = {
    "passage": r"passage|opening|durchgang|doorway",
    "door": r"door|t(ü|ue)r(?!k)|porte(?!u)|puerta|\bporta|drzwi|deur|门",
    "window": r"glaz|window|wind\b|fenster|fen(ê|e)tre|ventana|finestra|okno|raam|窗",
    "label": r"iden|text|anno|beschrift|texte|label|dim|bema(ß|ss)",
    "furniture": r"furn|m(ö|oe)bel|mobil|meuble|mueble|arred|meubel|equip|eqpm|sanit|appl|fixt|家具",
    "wall": r"wall|w(ä|ae)nde?|wand|mauer|\bmurs?\b|muro|pared|cloison|parete|sciana|墙",
    "room": r"area|room|raum|r(ä|ae)ume|space|zone|pi(è|e)ce|habitaci|stanza|kamer|flaeche|fläche|房间",
}
"""What is on a layer, by its name; the first that fits."""
UNITS = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0, 10: 0.9144, 14: 0.1}
"""Metres of DXF's units."""
CURVES = ("LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE")
USUAL = 14.0
"""Width of a drawing, by which its unit is guessed, m."""
FLAT = 0.01
"""Curves are followed to this, m."""
DEEPEST = 4
"""Blocks in blocks that are opened."""


class Part(NamedTuple):
    """An entity, and what kind of thing its layer or block is of; empty where nobody knows."""

    entity: Entity
    kind: str


def holds(name: str, data: bytes) -> bool:
    """A DXF file, as text or binary."""
    head = data[:4000].replace(b"\r", b"")
    return head.startswith(b"AutoCAD Binary DXF") or bool(re.match(rb"(\s*999\n.*\n)*\s*0\nSECTION\n", head))


def read(name: str, data: bytes) -> Drawing:
    """What is in the model space."""
    said: list[str] = []
    doc = _opened(data)
    parts = [part for entity in doc.modelspace() for part in _parts(entity, DEEPEST)]
    scale = _scale(doc, parts, said)
    sheet = _Sheet(parts, scale, any(value == "apartgen" for _, value in doc.header.custom_vars))
    spaces, labels = sheet.spaces(), sheet.labels()
    stand = _lines.walls(sheet.lines("wall"))
    holes = [*sheet.doors([space.floor for space in spaces], stand), *sheet.windows()]
    filled = stand if spaces else [*stand, *_fillers(holes, stand)]
    return Drawing(
        spaces=spaces, labels=labels, walls=filled, holes=holes, things=sheet.things(), said=said, height=sheet.height()
    )


def _opened(data: bytes) -> Any:
    try:
        import ezdxf
        from ezdxf import recover
    except ImportError:
        raise BadInput("DXF needs the package ezdxf: pip install 'apartgen[cad]'") from None
    try:
        return recover.read(io.BytesIO(data))[0]
    except (ezdxf.DXFError, OSError, ValueError, IndexError, TypeError, KeyError) as error:
        raise BadInput(f"no DXF that can be read: {error}") from None


def _kind(name: str) -> str:
    lower = name.lower().replace("_", " ")
    return next((kind for kind, words in WORDS.items() if re.search(words, lower)), "")


def _parts(entity: Entity, deep: int) -> Iterator[Part]:
    """An entity by its layer; a block that is no door, window or piece of furniture by what is in it."""
    layer = _kind(str(entity.dxf.get("layer", "")))
    if entity.dxftype() != "INSERT":
        yield Part(entity, layer)
        return
    block = str(entity.dxf.get("name", ""))
    known = next((kind for kind in (_kind(block), layer) if kind in ("passage", "door", "window", "furniture")), "")
    if known or block in TABLE or category(block) != OTHER:
        yield Part(entity, known or "furniture")
    elif deep:
        for inner in entity.virtual_entities():
            for part in _parts(inner, deep - 1):
                yield part if part.kind else part._replace(kind=layer)


def _scale(doc: Any, parts: list[Part], said: list[str]) -> float:
    """Metres of a unit; guessed from the size of the drawing where the file does not say."""
    told = UNITS.get(int(doc.header.get("$INSUNITS", 0)))
    points = [
        np.asarray(curve) for part in parts if part.entity.dxftype() in CURVES and (curve := _curve(part.entity, 1.0))
    ]
    if not points:
        raise BadInput("no lines in the model space; draw the plan there")
    wide = float(np.ptp(np.concatenate(points)[:, :2], axis=0).max())
    if told is not None and 2 <= wide * told <= 300:
        return told
    guess = min((1.0, 0.01, 0.001), key=lambda unit: abs(np.log(max(wide * unit, 1e-9) / USUAL)))
    said.append(
        f"{'no unit' if told is None else 'a unit that makes it ' + format(wide * told, '.4g') + ' m wide'}: "
        f"{ {1.0: 'metres', 0.01: 'centimetres', 0.001: 'millimetres'}[guess] } taken"
    )
    return guess


def _curve(entity: Entity, scale: float) -> list[tuple[float, float]]:
    """Corners along a curve; none of what is no curve."""
    from ezdxf.path import make_path

    try:
        path = make_path(entity)
        return [(p.x * scale, p.y * scale) for p in path.flattening(FLAT / scale)]
    except (TypeError, ValueError, ZeroDivisionError):
        return []


class _Sheet:
    """The parts of a drawing; `ours` says that x of blocks of furniture is their front."""

    def __init__(self, parts: list[Part], scale: float, ours: bool) -> None:
        self._parts, self._scale, self._ours = parts, scale, ours

    def _of(self, *kinds: str) -> list[Entity]:
        return [part.entity for part in self._parts if part.kind in kinds]

    def _rings(self, entities: list[Entity]) -> Iterator[tuple[Entity, Polygon]]:
        for entity in entities:
            if entity.dxftype() in ("LWPOLYLINE", "POLYLINE"):
                points = _curve(entity, self._scale)
                shut = len(points) > 3 and np.hypot(*np.subtract(points[0], points[-1])) < 0.02
                if shut:
                    yield entity, Polygon(points)

    def lines(self, *kinds: str) -> list[LineString]:
        found = [_curve(entity, self._scale) for entity in self._of(*kinds) if entity.dxftype() in CURVES]
        return [LineString(points) for points in found if len(points) > 1]

    def labels(self) -> list[Label]:
        """Texts that may be names of rooms, by their first line."""
        out = []
        for part in self._parts:
            if part.entity.dxftype() in ("TEXT", "MTEXT", "ATTRIB"):
                text = part.entity.plain_text() if hasattr(part.entity, "plain_text") else part.entity.dxf.text
                at = part.entity.dxf.insert
                if text.strip():
                    out.append(Label(text.strip().splitlines()[0], (at.x * self._scale, at.y * self._scale)))
        return out

    def spaces(self) -> list[Space]:
        """Closed outlines on layers of rooms; without any, those on layers of no kind that a room's name is in."""
        rings = [ring for _, ring in self._rings(self._of("room"))]
        if not rings:
            named = [Point(label.at) for label in self.labels() if room_names.read(label.text)]
            found = [ring for _, ring in self._rings(self._of("", "label"))]
            rings = [ring for ring in found if ring.is_valid and sum(ring.contains(at) for at in named) == 1]
        return [Space("", ring) for ring in rings]

    def doors(self, floors: list[Polygon], stand: list[Polygon]) -> Iterator[Hole]:
        for kind in ("door", "passage"):
            loose = []
            for entity in self._of(kind):
                if entity.dxftype() == "INSERT":
                    yield from self._door(list(entity.virtual_entities()), entity, kind, floors, stand)
                elif entity.dxftype() == "ARC":
                    yield from self._door([entity], None, kind, floors, stand)
                elif entity.dxftype() in CURVES:
                    loose.append(entity)
            if not any(entity.dxftype() in ("INSERT", "ARC") for entity in self._of(kind)):
                curves = [LineString(points) for entity in loose if len(points := _curve(entity, self._scale)) > 1]
                yield from (self._hole(None, "door", a, b) for a, b in _lines.spans(curves))

    def _door(
        self,
        drawn: list[Entity],
        put: Entity | None,
        kind: str,
        floors: list[Polygon],
        stand: list[Polygon],
    ) -> Iterator[Hole]:
        """By its arcs: a leaf turns about the middle of one; else along what is drawn."""
        arcs = [np.array(_curve(entity, self._scale)) for entity in drawn if entity.dxftype() == "ARC"]
        centers = [arc.ocs().to_wcs(arc.dxf.center) for arc in drawn if arc.dxftype() == "ARC"]
        hubs = [np.array([center.x, center.y]) * self._scale for center in centers]
        if len(arcs) == 1 and np.hypot(*(arcs[0][0] - hubs[0])) > 0.3:
            ends = [arcs[0][0], arcs[0][-1]]
            k = _lines.shut(hubs[0], ends, floors, stand)
            yield self._hole(put, "door", hubs[0], ends[k], hubs[0], ends[1 - k])
        elif len(arcs) == 2 and np.hypot(*(hubs[1] - hubs[0])) > 0.3:
            yield self._hole(put, "door", *hubs)
        else:
            curves = [LineString(points) for entity in drawn if len(points := _curve(entity, self._scale)) > 1]
            bare = (
                "opening" if kind == "passage" and put is not None and "doorway" not in put.dxf.name.lower() else "door"
            )
            yield from (self._hole(put, bare, a, b) for a, b in _lines.spans(curves)[:1])

    def windows(self) -> Iterator[Hole]:
        put = [entity for entity in self._of("window") if entity.dxftype() == "INSERT"]
        for entity in put:
            along = np.array([np.cos(turn := np.radians(entity.dxf.rotation)), np.sin(turn)])
            lo, hi, _ = self._extent(entity, along)
            middle = 0.5 * (lo[1] + hi[1]) * np.array([-along[1], along[0]])
            ends = [lo[0] * along + middle, hi[0] * along + middle]
            yield self._hole(entity, "window", *ends)
        yield from (self._hole(None, "window", a, b) for a, b in _lines.spans(self.lines("window")))

    def _extent(self, put: Entity, along: Array) -> tuple[Array, Array, float]:
        """Least and greatest corner of a block along a direction and to its left, and the height of its lines."""
        drawn = [entity for entity in put.virtual_entities() if entity.dxftype() in CURVES]
        points = np.array([p for entity in drawn for p in _curve(entity, self._scale)] or [(0.0, 0.0)])
        local = points @ np.array([along, [-along[1], along[0]]]).T
        tall = max((abs(float(entity.dxf.get("thickness", 0.0))) for entity in drawn), default=0.0)
        return local.min(0), local.max(0), tall * self._scale

    def _hole(
        self, put: Entity | None, kind: Any, a: Array, b: Array, hinge: Array | None = None, swung: Array | None = None
    ) -> Hole:
        attached = [attrib for attrib in put.attribs if hasattr(attrib, "dxf")] if put is not None else []
        told = {attrib.dxf.tag: attrib.dxf.text for attrib in attached}

        def number(tag: str) -> float | None:
            return float(told[tag]) if re.fullmatch(r"-?\d+(\.\d+)?", told.get(tag, "")) else None

        pairs = [None if p is None else (float(p[0]), float(p[1])) for p in (a, b, hinge, swung)]
        name = told.get("ID") or (put.dxf.name if put is not None else "")
        return Hole(name, kind, (pairs[0], pairs[1]), number("SILL"), number("HEAD"), pairs[2], pairs[3])  # type: ignore[arg-type]

    def things(self) -> list[Thing]:
        """Blocks of furniture along their own axes."""
        out = []
        for entity in self._of("furniture"):
            if entity.dxftype() == "INSERT":
                yaw = float(np.radians(entity.dxf.rotation))
                along = np.array([np.cos(yaw), np.sin(yaw)])
                lo, hi, tall = self._extent(entity, along)
                name = str(entity.dxf.name)
                kind = next((kind for kind in (re.sub(r"_[\dx]+$", "", name), category(name)) if kind in TABLE), None)
                height = tall or (TABLE[kind].size[2] if kind else 1.0)
                low = float(entity.dxf.insert.z) * self._scale if tall else TABLE[kind].z if kind else 0.0
                x, y = 0.5 * (lo + hi) @ np.array([along, [-along[1], along[0]]])
                d, w = (max(float(v), 0.01) for v in hi - lo)
                out.append(Thing(kind or name, (float(x), float(y), low + height / 2), (d, w, height), yaw, self._ours))
        return out

    def height(self) -> float | None:
        """Of the walls, where their lines have any."""
        tall = [abs(float(entity.dxf.get("thickness", 0.0))) * self._scale for entity in self._of("wall")]
        return max(tall, default=0.0) or None


def _fillers(holes: list[Hole], stand: list[Polygon]) -> list[Polygon]:
    """Walls in the gaps that doors leave, each as thick as the wall beside it."""
    out = []
    for hole in holes:
        line = LineString(hole.ends)
        beside = min(stand, key=lambda wall: (round(wall.distance(line), 2), wall.area), default=None)
        thick = 0.1 if beside is None else _lines.thickness(beside)
        out.append(line.buffer(0.5 * thick, cap_style="square"))
    return out
