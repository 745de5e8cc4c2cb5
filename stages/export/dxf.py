"""DXF drawing for CAD programs: rooms, walls, doors, windows and furniture, in metres, on layers by AIA's names.

Symbols, swept floor, tiles, dimensions and places of names are those of `plan.svg`, by the same pen. Heights are the
thickness of lines; sills and heads are attributes of blocks. It takes the extra `apartgen[cad]`.
"""

import io
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from matplotlib.figure import Figure

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.stages.export._drawing import dimensions, sheet
from apartgen.stages.export._readback import Refused
from apartgen.stages.export._strokes import Stroke, strokes, words
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import polygons

NEEDS_ASSETS = False

SYMBOLS, SWEPT, TILES, DIMENSIONS = "A-FURN-SYMB", "A-FURN-SWEP", "A-FLOR-PATT", "A-ANNO-DIMS"
LAYERS = {"A-WALL": 7, "A-AREA": 8, "A-AREA-IDEN": 2, "A-DOOR": 3, "A-GLAZ": 4, "A-FURN": 6,
          SYMBOLS: 6, SWEPT: 30, TILES: 9, DIMENSIONS: 8}
"""Layers and their colours."""
METRES = 6
TEXT = 0.18
"""Height of text, m."""
DASH = 0.1
"""Length of dashes, of those of drawings in inches."""


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, plan.dxf."""
    try:
        import ezdxf
    except ImportError:
        raise BadInput("DXF needs the package ezdxf: pip install 'apartgen[cad]'") from None
    path = out / "plan.dxf"
    fixed = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True  # no dates and no identifiers drawn by chance
    try:
        text = io.StringIO()
        _drawing(ezdxf.new("R2010", setup=["linetypes"]), scene.home, sheet(scene)).write(text)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed
    path.write_text(text.getvalue(), encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """By ezdxf and its audit."""
    import ezdxf

    if found := ezdxf.readfile(files[0]).audit().errors:
        raise Refused(found[0].message)


def _drawing(doc: Any, home: Plan, drawn: Figure) -> Any:
    doc.header["$INSUNITS"] = METRES
    doc.header["$MEASUREMENT"] = 1
    doc.header.custom_vars.append("program", "apartgen")
    for name, colour in LAYERS.items():
        doc.layers.add(name, color=colour)
    _symbols(doc)
    space = doc.modelspace()
    for body in shapely.get_parts(polygons.walls(home)):
        for ring in (body.exterior, *body.interiors):
            _outline(space, ring.coords[:-1], "A-WALL", home.height)
    places = {word.thing.removeprefix("label_"): word.at for word in reversed(words(drawn)) if word.layer == "labels"}
    for room in home.rooms:
        _room(space, room, places[room.id])
    for o in home.openings:
        _opening(space, o, home)
    lines = strokes(drawn)
    for thing in home.objects if isinstance(home, Layout) else []:
        _thing(doc, space, thing, [line for line in lines if (line.layer, line.thing) == ("furniture", thing.id)])
    for line in lines:
        if line.layer == "sweeps" or line.thing.startswith("tiles_"):
            _stroke(space, line, SWEPT if line.layer == "sweeps" else TILES)
    for a, b in dimensions(home):
        _dimension(doc, space, a, b)
    return doc


def _stroke(space: Any, line: Stroke, layer: str) -> None:
    kind = "DASHED" if line.dashed else "BYLAYER"
    attributes = {"layer": layer, "linetype": kind, "ltscale": DASH}
    space.add_lwpolyline([(float(x), float(y)) for x, y in line.points], close=line.closed, dxfattribs=attributes)


def _dimension(doc: Any, space: Any, a: tuple[float, float], b: tuple[float, float]) -> None:
    """A dimension of the program that reads it, along the line that the plan draws."""
    angle = 0.0 if a[1] == b[1] else 90.0
    told = {"dimtxt": TEXT, "dimasz": 0.1, "dimexe": 0.05, "dimexo": 0.05, "dimtsz": 0.07, "dimdec": 2, "dimtad": 1,
            "dimgap": 0.05, "dimlfac": 1.0, "dimrnd": 0.0, "dimzin": 0}
    dimension = space.add_linear_dim(base=a, p1=a, p2=b, angle=angle, dimstyle="Standard", override=told,
                                     dxfattribs={"layer": DIMENSIONS})
    dimension.render()


def _outline(space: Any, points: Any, layer: str, height: float = 0.0) -> None:
    line = space.add_lwpolyline([(float(x), float(y)) for x, y in points], close=True, dxfattribs={"layer": layer})
    line.dxf.thickness = height


def _room(space: Any, room: Room, at: tuple[float, float]) -> None:
    """Its clear floor, with its name and area where the plan has them."""
    floor = polygons.floor(room)
    _outline(space, room.polygon, "A-AREA")
    name = room.id.replace("_", " ").capitalize()
    attributes = {"layer": "A-AREA-IDEN", "char_height": TEXT, "insert": at, "attachment_point": 5}
    space.add_mtext(f"{name}\\P{floor.area:.1f} m²", dxfattribs=attributes)


def _symbols(doc: Any) -> None:
    """Blocks of unit width along x from 0: a door that opens to +y, a passage, a window as thick as a unit."""
    door = doc.blocks.new("DOOR")
    door.add_line((0, 0), (0, 1))
    door.add_arc((0, 0), 1, 0, 90)
    doc.blocks.new("PASSAGE").add_line((0, 0), (1, 0))
    bare = doc.blocks.new("DOORWAY")
    bare.add_line((0, 0), (1, 0))
    window = doc.blocks.new("WINDOW")
    window.add_lwpolyline([(0, -0.5), (1, -0.5), (1, 0.5), (0, 0.5)], close=True)
    window.add_line((0, 0), (1, 0))
    for name in ("DOOR", "PASSAGE", "DOORWAY", "WINDOW"):
        for tag in ("ID", "SILL", "HEAD"):
            doc.blocks.get(name).add_attdef(tag, (0, 0), dxfattribs={"height": 0.05, "invisible": 1})


def _opening(space: Any, o: Opening, home: Plan) -> None:
    """A block on the wall's centre line; that of a door begins at its hinge."""
    start, end = np.asarray(o.segment, float)
    width, deep = polygons.width(o), 1.0
    name, layer = {"window": ("WINDOW", "A-GLAZ"), "opening": ("PASSAGE", "A-DOOR")}.get(o.kind, ("DOORWAY", "A-DOOR"))
    if name == "DOORWAY" and o.into is not None:
        start, end = (start, end) if o.hinge == 0 else (end, start)
        normal, _ = polygons.face(o, home, o.into)
        left = np.array([start[1] - end[1], end[0] - start[0]])
        name, deep = "DOOR", width if float(normal @ left) > 0 else -width
    if name == "WINDOW":
        deep = 2 * polygons.face(o, home, o.rooms[0])[1]
    turn = float(np.degrees(np.arctan2(end[1] - start[1], end[0] - start[0])))
    put = space.add_blockref(
        name,
        start.tolist(),
        dxfattribs={"layer": layer, "xscale": width, "yscale": deep, "zscale": 1.0, "rotation": turn},
    )
    put.add_auto_attribs({"ID": o.id, "SILL": f"{o.sill:.4f}", "HEAD": f"{o.head:.4f}"})


def _thing(doc: Any, space: Any, o: Box, lines: list[Stroke]) -> None:
    """A box with a mark in the middle of its front, which is x of the block, and the symbol of the plan."""
    d, w, h = o.size
    # Things alike that are drawn otherwise, as an oven that is built in, have a block each.
    name = f"{o.category}_{1000 * d:.0f}x{1000 * w:.0f}x{1000 * h:.0f}x{len(lines)}"
    if name not in doc.blocks:
        block = doc.blocks.new(name)
        _outline(block, [(-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, w / 2), (-d / 2, w / 2)], "0", h)
        block.add_line((d / 4, 0), (d / 2, 0))
        block.add_attdef("ID", (0, 0), dxfattribs={"height": 0.05, "invisible": 1})
        for line in lines:
            _stroke(block, line.seen_from(o.center[:2], o.yaw), SYMBOLS)
    x, y, z = o.center
    put = space.add_blockref(
        name, (x, y, z - h / 2), dxfattribs={"layer": "A-FURN", "rotation": float(np.degrees(o.yaw))}
    )
    put.add_auto_attribs({"ID": o.id})
