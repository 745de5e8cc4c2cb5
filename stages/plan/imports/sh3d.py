"""Sweet Home 3D homes (`.sh3d`): walls, rooms, doors, windows and furniture of one level.

A zip with `Home.xml`, in centimetres, y down the screen; angles turn clockwise there, a piece's front looks down it.
"""

import io
import zipfile
from collections.abc import Iterator
from xml.etree import ElementTree

import numpy as np
from shapely.geometry import Polygon

from apartgen.schemas.base import Point
from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.drawing import Drawing, Hole, Space, Thing
from apartgen.stages.plan.imports._walls import Axis, bodies
from apartgen.stages.things.words import OTHER, category

ENTRY = "Home.xml"
LARGEST = 64 * 2**20
"""Bytes of the XML above which a file is refused."""
PIECES = ("pieceOfFurniture", "light", "shelfUnit")
RAISED, LOW = 0.2, 1.8
"""Windows stand so high above the floor, or are lower than doors, m."""
ARC = 12
"""Straight parts of a round wall."""
Element = ElementTree.Element


def holds(name: str, data: bytes) -> bool:
    """A zip that is named so, or has a home in it."""
    return data.startswith(b"PK") and (name.lower().endswith(".sh3d") or ENTRY.encode() in data)


def read(name: str, data: bytes) -> Drawing:
    """The level with the most rooms and walls."""
    home = _home(data)
    said: list[str] = []
    level = _level(home, said)
    found = [element for element in home if element.get("level") == level or level is None]
    axes = [_axis(element) for element in found if element.tag == "wall"]
    heights = [_number(element, "height") for element in found if element.tag == "wall" and "height" in element.attrib]
    height = max(heights, default=_number(home, "wallHeight", 0.0)) / 100
    pieces = [piece for piece in _pieces(found) if piece.get("visible") != "false"]
    return Drawing(
        spaces=[_space(element) for element in found if element.tag == "room"],
        walls=bodies(axes), height=height or None, said=said,
        holes=[_hole(piece) for piece in pieces if piece.tag == "doorOrWindow"],
        things=[_thing(piece) for piece in pieces if piece.tag in PIECES],
    )  # fmt: skip


def _home(data: bytes) -> Element:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            if ENTRY not in archive.namelist():
                raise BadInput(f"holds no {ENTRY}; save it again with Sweet Home 3D 5.3 or newer")
            with archive.open(ENTRY) as entry:
                text = entry.read(LARGEST + 1)
        if len(text) > LARGEST:
            raise BadInput(f"{ENTRY} is larger than {LARGEST // 2**20} MB")
        return ElementTree.fromstring(text)
    except (zipfile.BadZipFile, OSError, EOFError, NotImplementedError, RuntimeError) as error:
        raise BadInput(f"no Sweet Home 3D file: {error}; save it again") from None
    except ElementTree.ParseError as error:
        raise BadInput(f"{ENTRY} is no XML: {error}") from None


def _level(home: Element, said: list[str]) -> str | None:
    """The id of the fullest level; None where there is one only."""
    levels = {element.get("id"): element.get("name", "") for element in home.iter("level")}
    counts = {id: sum(e.get("level") == id for e in home if e.tag in ("room", "wall")) for id in levels}
    if len([id for id in counts if counts[id]]) > 1:
        taken = max(counts, key=lambda id: counts[id])
        left = ", ".join(repr(levels[id]) for id in levels if id != taken and counts[id])
        said.append(f"a plan is one storey: level {levels[taken]!r} taken, {left} left out")
        return taken
    return max(counts, key=lambda id: counts[id]) if counts else None


def _number(element: Element, name: str, default: float | None = None) -> float:
    text = element.get(name)
    try:
        value = float(text) if text is not None else default
    except ValueError:
        value = None
    if value is None or not np.isfinite(value):
        raise BadInput(f"{element.tag} {element.get('id') or element.get('name') or ''}: {name} is {text!r}, no number")
    return value


def _point(x: float, y: float) -> Point:
    return x / 100, -y / 100


def _space(room: Element) -> Space:
    points = [_point(_number(point, "x"), _number(point, "y")) for point in room.iter("point")]
    if len(points) < 3:
        raise BadInput(f"room {room.get('id') or room.get('name') or ''}: {len(points)} points are no outline")
    return Space(room.get("name") or "", Polygon(points))


def _axis(wall: Element) -> Axis:
    ends = np.array(
        [[_number(wall, "xStart"), -_number(wall, "yStart")], [_number(wall, "xEnd"), -_number(wall, "yEnd")]]
    )
    thickness = _number(wall, "thickness", 7.5) / 100
    if thickness <= 0 or np.hypot(*(ends[1] - ends[0])) < 0.1:
        raise BadInput(f"wall {wall.get('id') or ''} at ({ends[0, 0] / 100:.2f}, {ends[0, 1] / 100:.2f}): has no size")
    return Axis(_round(ends / 100, _number(wall, "arcExtent", 0.0)), thickness)


def _round(ends: np.ndarray, extent: float) -> np.ndarray:
    """The corners of an arc over a chord, `extent` radians about its centre; the chord itself for none."""
    if abs(extent) < 1e-3:
        return ends
    chord = ends[1] - ends[0]
    half = 0.5 * extent
    beside = np.array([chord[1], -chord[0]])
    center = ends.mean(0) + beside / (2 * np.tan(half))
    turns = np.linspace(0.0, -extent, ARC + 1)
    c, s = np.cos(turns), np.sin(turns)
    arm = ends[0] - center
    return np.asarray(center + np.stack([c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]], axis=-1))


def _pieces(found: list[Element]) -> Iterator[Element]:
    """Pieces by themselves and in groups."""
    for element in found:
        if element.tag == "furnitureGroup" and element.get("visible") != "false":
            yield from _pieces(list(element))
        elif element.tag in (*PIECES, "doorOrWindow"):
            yield element


def _called(piece: Element) -> str:
    """Its name, or that of the catalogue where the name, in whatever language, says nothing."""
    own, listed = piece.get("name") or "", (piece.get("catalogId") or "").rpartition("#")[2]
    return next((word for word in (listed, own) if category(word) != OTHER), own or listed)


def _placed(piece: Element) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The middle of a piece in plan, and the unit directions of its width and, to the back, its depth."""
    angle = _number(piece, "angle", 0.0)
    across = np.array([np.cos(angle), -np.sin(angle)])
    return np.array(_point(_number(piece, "x"), _number(piece, "y"))), across, np.array([-across[1], across[0]])


def _hole(piece: Element) -> Hole:
    middle, across, back = _placed(piece)
    width, depth, height = (
        _number(piece, key, 20.0 if key == "depth" else None) / 100 for key in ("width", "depth", "height")
    )
    sill = _number(piece, "elevation", 0.0) / 100
    told = f"{piece.get('catalogId') or ''} {piece.get('name') or ''}".lower()
    sashes = piece.findall("sash")
    raised = sill >= RAISED or height < LOW
    kind = "window" if raised else "opening" if not sashes and ("frame" in told or "opening" in told) else "door"
    ends = middle - 0.5 * width * across, middle + 0.5 * width * across
    hinge = swung = None
    if kind == "door" and len(sashes) == 1:
        mirrored = -1.0 if piece.get("modelMirrored") == "true" else 1.0
        turn, reach = _number(sashes[0], "endAngle"), _number(sashes[0], "width") * width
        x = mirrored * (_number(sashes[0], "xAxis") - 0.5) * width
        y = (0.5 - _number(sashes[0], "yAxis")) * depth
        pivot = middle + x * across + y * back
        free = pivot + reach * (mirrored * np.cos(turn) * across + np.sin(turn) * back)
        hinge, swung = _pair(pivot), _pair(free)
    return Hole(piece.get("name") or "", kind, (_pair(ends[0]), _pair(ends[1])), sill, sill + height, hinge, swung)  # type: ignore[arg-type]


def _pair(p: np.ndarray) -> Point:
    return float(p[0]), float(p[1])


def _thing(piece: Element) -> Thing:
    middle, _, back = _placed(piece)
    depth, width, height = (_number(piece, key) / 100 for key in ("depth", "width", "height"))
    if min(depth, width, height) <= 0:
        raise BadInput(f"{piece.tag} {piece.get('name') or ''} at ({middle[0]:.2f}, {middle[1]:.2f}): has no size")
    z = _number(piece, "elevation", 0.0) / 100 + height / 2
    yaw = float(np.arctan2(-back[1], -back[0]))
    return Thing(_called(piece), (float(middle[0]), float(middle[1]), z), (depth, width, height), yaw)
