"""The furnished plan as an architect draws it: walls filled, doors with their swing, windows, symbols, names, scale."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from shapely import Geometry, affinity
from shapely.ops import unary_union

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.schemas.populate import without_things
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.export import _symbols
from apartgen.stages.export._labels import LEADING, Label, extent, labels, measures, radius, size_of, title
from apartgen.stages.export._pen import FAINT, INK, PAPER, Pen
from apartgen.stages.scene import shell
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import polygons
from apartgen.stages.things.categories import TABLE, fitted_ovens

INCH = 0.72
"""Inches of paper to a metre, before the sheet is fitted."""
LARGEST = 13.0  # inches, longer side of the plan
MARGIN = 1.1  # m about the outer walls, for dimensions and the scale bar
ARROW = 0.42  # m about the walls of a bare plan, for the mark before the entrance
LIST = 2.35  # inches beside the plan for the list of rooms
COLUMNS = ((0.22, "right"), (0.32, "left"), (1.6, "right"), (1.68, "left"))
"""Where its numbers, names, areas and measures begin or end, inches."""
ROW = 11.0  # points from row to row of it
CHARACTER = 0.06  # m of the plan that a character of the sentence takes
POCHE, PARAPET = "#2f2d2b", "#d5d1ca"
TINTS = {
    "living_room": "#fbf6ec", "dining_room": "#fbf6ec", "kitchen": "#f6f4f0", "bedroom": "#f7f3ee", "study": "#f7f3ee",
    "bathroom": "#eef4f6", "utility": "#f1f4f4", "hallway": "#faf8f4", "storage": "#f3f2f0", "closet": "#f5f1ec",
    "balcony": "#eef2ea",
}  # fmt: skip
TILED = {"bathroom": 0.3, "kitchen": 0.6, "utility": 0.3, "balcony": 0.15}
"""Rooms with tiles or boards, and their pitch in metres."""
SWEPT = "#c0683c"


@lru_cache(1)
def sheet(scene: Scene) -> Figure:
    """The scene's drawing, made once for all formats that show it."""
    return figure(scene.home)


def figure(home: Plan) -> Figure:
    """One sheet with the whole apartment, to scale, north up; small things are left out."""
    home = without_things(home)
    x0, y0, x1, y1 = polygons.shell(home).bounds
    x0, y0, x1, y1 = x0 - MARGIN, y0 - MARGIN, x1 + 0.4 * MARGIN, y1 + 0.9 * MARGIN
    inch = min(INCH * 1.4, LARGEST / max(x1 - x0, y1 - y0))
    y0 = min(y0, y1 - (len(home.rooms) + 2) * ROW / 72 / inch)
    edge, x1 = x1, x1 + LIST / inch
    sheet, axes = _paper((x0, y0, x1, y1), inch)
    objects = home.objects if isinstance(home, Layout) else []
    moving = _building(axes, home, objects)
    _frame(axes, home)
    _names(axes, home, labels(home, objects, moving, inch), inch)
    _list(axes, home, edge, polygons.shell(home).bounds[3], inch)
    return sheet


def bare(home: Plan) -> Figure:
    """The same without words and dimensions, cut at the outer walls."""
    home = without_things(home)
    sheet, axes = _paper(polygons.shell(home).buffer(ARROW).bounds, INCH)
    _building(axes, home, home.objects if isinstance(home, Layout) else [])
    return sheet


def _paper(edges: tuple[float, float, float, float], inch: float) -> tuple[Figure, Axes]:
    """Empty axes from edge to edge of a sheet, in metres."""
    x0, y0, x1, y1 = edges
    sheet = Figure(figsize=((x1 - x0) * inch, (y1 - y0) * inch), facecolor=PAPER)
    axes = sheet.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_xlim(x0, x1)
    axes.set_ylim(y0, y1)
    axes.axis("off")
    return sheet, axes


def _building(axes: Axes, home: Plan, objects: Sequence[Box]) -> Geometry:
    """Rooms, furniture, walls and openings; returns the floor that open parts take."""
    _rooms(axes, home)
    moving = _furniture(axes, objects)
    _fill(axes, polygons.walls(home), POCHE, 5.0, name="walls/wall")
    _fill(axes, polygons.walls(home).intersection(shell.low(home)), PARAPET, 5.1, INK, 0.5, "walls/parapet")
    for opening in (o for o in home.openings if not shell.in_parapet(o, home)):
        _opening(axes, home, opening)
    return moving


def _fill(
    axes: Axes, area: Geometry, color: str, order: float, ink: str = "none", width: float = 0.0, name: str = ""
) -> PathPatch | None:
    rings = [shapely.get_coordinates(ring) for ring in shapely.get_rings(shapely.get_parts(area))]
    if not rings:
        return None
    path = Path.make_compound_path(*(Path(ring, closed=True) for ring in rings))
    patch = PathPatch(path, facecolor=color, edgecolor=ink, linewidth=width, zorder=order, gid=name or None)
    axes.add_artist(patch)
    return patch


def _rooms(axes: Axes, home: Plan) -> None:
    _fill(axes, polygons.free_floor(home), "#faf8f4", 0.5, name="rooms/floor")
    for room in home.rooms:
        patch = _fill(axes, polygons.floor(room), TINTS[room.base], 0.6, name=f"rooms/{room.id}")
        if patch is not None and room.base in TILED:
            _tiles(axes, room, patch, TILED[room.base])


def _tiles(axes: Axes, room: Room, clip: PathPatch, pitch: float) -> None:
    x0, y0, x1, y1 = polygons.floor(room).bounds
    lines = [((x, x), (y0, y1)) for x in np.arange(x0 + pitch, x1, pitch)]
    if room.base != "balcony":
        lines += [((x0, x1), (y, y)) for y in np.arange(y0 + pitch, y1, pitch)]
    for xs, ys in lines:
        (line,) = axes.plot(xs, ys, color="#dcdfdf", linewidth=0.35, zorder=0.7, gid=f"rooms/tiles_{room.id}")
        line.set_clip_path(clip)


def _layer(o: Box) -> float:
    """Rugs lie lowest, then what stands by its height, then what hangs."""
    if o.category in TABLE and TABLE[o.category].place == "flat":
        return 1.0
    top = min(o.center[2] + o.size[2] / 2, 2.6)
    above = o.category in TABLE and TABLE[o.category].place == "ceiling"
    return 4.6 if above else 2.0 + top / 1.2


def _furniture(axes: Axes, objects: Sequence[Box]) -> Geometry:
    """Symbols of all objects; returns the floor that their open parts take."""
    fitted, swept = fitted_ovens(objects), []
    for o in objects:
        pen = Pen(axes, o.center[0], o.center[1], o.yaw, _layer(o), f"furniture/{o.id}")
        _symbols.draw(pen, o.category, o.size[0], o.size[1], fitted=o.id in fitted)
        for joint in o.joints if isinstance(o, Furnishing) else []:
            area = _swept(Pen(axes, o.center[0], o.center[1], o.yaw, 4.8, f"sweeps/{o.id}_{joint.name}"), joint)
            swept.append(affinity.translate(affinity.rotate(area, o.yaw, (0, 0), use_radians=True), *o.center[:2]))
    return unary_union(swept)


def _swept(pen: Pen, joint: Joint) -> Geometry:
    """What a leaf turns through, or how far a drawer or flap comes out, dashed."""
    outline = _swept_area(joint) if joint.extent is not None else shapely.Polygon()
    if outline.geom_type == "Polygon" and outline.area > 0.01:
        pen.shape(shapely.get_coordinates(outline.exterior), None, SWEPT, 0.45, True)
    return outline


def _swept_area(joint: Joint) -> Geometry:
    lo, hi = (np.array(v) for v in joint.extent or ((0, 0, 0), (0, 0, 0)))
    corners = np.array([[x, y, z] for x in (lo[0], hi[0]) for y in (lo[1], hi[1]) for z in (lo[2], hi[2])])
    axis, origin = np.array(joint.axis), np.array(joint.origin)
    steps = np.linspace(*joint.range, 2 if joint.type == "slide" else 13)
    shapes = []
    for value in steps:
        arm = corners - origin
        if joint.type == "slide":
            moved = corners + value * axis
        else:
            moved = origin + arm * np.cos(value) + np.cross(axis, arm) * np.sin(value)
            moved += np.outer(arm @ axis, axis) * (1 - np.cos(value))
        shapes.append(shapely.MultiPoint(moved[:, :2]).convex_hull)
    hulls = [a.union(b).convex_hull for a, b in zip(shapes, shapes[1:], strict=False)]
    return unary_union(hulls or shapes)


def _opening(axes: Axes, home: Plan, opening: Opening) -> None:
    if opening.kind == "window":
        _window(axes, home, opening)
        return
    turn = polygons.hinge(opening, home)
    if turn is not None:
        _fill(axes, polygons.leaf(opening, home), PAPER, 5.6, INK, 0.7, f"openings/{opening.id}")
        angle = np.degrees(np.arctan2(turn.shut[1], turn.shut[0]))
        other = np.degrees(np.arctan2(turn.opened[1], turn.opened[0]))
        start, end = (angle, other) if (other - angle) % 360 < 180 else (other, angle)
        pen = Pen(axes, float(turn.pivot[0]), float(turn.pivot[1]), 0.0, 5.6, f"openings/{opening.id}")
        pen.arc(0, 0, turn.width, start, end, INK, 0.5)
    if opening.kind == "entrance":
        _entrance(axes, home, opening)


def _window(axes: Axes, home: Plan, opening: Opening) -> None:
    normal, reach = polygons.face(opening, home, opening.rooms[0])
    a, b = np.asarray(opening.segment, float)
    for lo, hi in ((-reach, reach), (-0.2 * reach, 0.2 * reach)):
        corners = np.array([a + lo * normal, b + lo * normal, b + hi * normal, a + hi * normal])
        Pen(axes, order=5.2, name=f"windows/{opening.id}").shape(corners, PAPER, INK, 0.7 if hi == reach else 0.5)
    Pen(axes, order=5.2, name=f"windows/{opening.id}").line(tuple(a), tuple(b), ink=INK, width=0.4)


def _entrance(axes: Axes, home: Plan, opening: Opening) -> None:
    normal, reach = polygons.face(opening, home, opening.rooms[0])
    middle = np.mean(np.asarray(opening.segment, float), axis=0)
    tip = middle - (reach + 0.06) * normal
    side = np.array([-normal[1], normal[0]])
    corners = [tip, tip - 0.26 * normal + 0.15 * side, tip - 0.26 * normal - 0.15 * side]
    Pen(axes, order=5.6, name=f"openings/{opening.id}").shape(corners, POCHE, POCHE)


def _names(axes: Axes, home: Plan, found: Sequence[Label], inch: float) -> None:
    """Each room's number, name and area on free floor; a number alone where they do not fit."""
    kinds = {room.id: room.base for room in home.rooms}
    for label in found:
        name = f"labels/label_{label.room}"
        if label.alone:
            Pen(axes, order=8.0, name=name).oval(label.x, label.y, radius(inch), radius(inch), PAPER, INK, width=0.5)
        _, height = extent(label.lines, inch)
        at = height / 2
        for text, size in label.lines:
            at -= LEADING * size / 72 / inch / 2
            x, y = (label.x - at, label.y) if label.turned else (label.x, label.y + at)
            ink = "#222222" if text != label.lines[-1][0] or label.alone else "#555555"
            halo = {"boxstyle": "square,pad=0.02", "facecolor": TINTS[kinds[label.room]], "edgecolor": "none"}
            axes.text(x, y, text, fontsize=size, color=ink, ha="center", va="center", zorder=8, gid=name,
                      rotation=90 if label.turned else 0, bbox=None if label.alone else halo)
            at -= LEADING * size / 72 / inch / 2


def _list(axes: Axes, home: Plan, left: float, top: float, inch: float) -> None:
    """Numbers, names, areas and measures of all rooms beside the plan."""
    step = ROW / 72 / inch
    for k, room in enumerate(home.rooms):
        y, name = top - k * step, f"list/list_{room.id}"
        told = str(k + 1), title(room), size_of(room), measures(room)
        for (x, side), text in zip(COLUMNS, told):
            axes.text(left + x / inch, y, text, fontsize=6.5, color=INK, ha=side, va="center", zorder=8, gid=name)


def dimensions(home: Plan) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Ends of the dimension lines beside the outer walls, above and on the left."""
    x0, y0, x1, y1 = polygons.shell(home).bounds
    return [((x0, y1 + 0.45), (x1, y1 + 0.45)), ((x0 - 0.45, y0), (x0 - 0.45, y1))]


def _frame(axes: Axes, home: Plan) -> None:
    """Overall dimensions, scale bar, north, area, and the sentence asked for."""
    x0, y0, x1, y1 = polygons.shell(home).bounds
    for a, b in dimensions(home):
        _dimension(axes, a, b)
    pen = Pen(axes, x0, y0 - 0.75, 0.0, 6, "frame/scale")
    for k in range(4):
        pen.rect(k, k + 1, 0, 0.07, POCHE if k % 2 == 0 else PAPER, width=0.5)
    for k in range(5):
        pen.word(k, -0.13, f"{k}" if k < 4 else "4 m", 6, INK)
    north = Pen(axes, x1 - 0.2, y0 - 0.68, 0.0, 6, "frame/north")
    north.shape([(0, 0.28), (0.11, -0.22), (0, -0.12)], POCHE, POCHE)
    north.shape([(0, 0.28), (-0.11, -0.22), (0, -0.12)], PAPER, POCHE)
    north.word(0, 0.4, "N", 6.5, INK)
    area = sum(polygons.floor(room).area for room in home.rooms)
    # The sentence ends before it meets the scale bar.
    room = int((x1 - x0 - 5.0) / CHARACTER) - 10
    note = f"{_shortened(home.prompt, room)}  ·  {area:.0f} m²" if home.prompt and room > 8 else f"{area:.0f} m²"
    axes.text(x1 - 0.55, y0 - 0.72, note, fontsize=7, color="#555555", ha="right", va="center", zorder=6,
              gid="frame/note")


def _shortened(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 1].rstrip() + "…"


def _dimension(axes: Axes, a: tuple[float, float], b: tuple[float, float]) -> None:
    """A dimension line with ticks and its length in metres."""
    pen = Pen(axes, order=6, name="frame/dimensions")
    pen.line(a, b, ink=FAINT)
    for x, y in (a, b):
        pen.line((x - 0.07, y - 0.07), (x + 0.07, y + 0.07), ink=INK, width=0.9)
    along = abs(b[0] - a[0]) > abs(b[1] - a[1])
    length = max(abs(b[0] - a[0]), abs(b[1] - a[1]))
    at = ((a[0] + b[0]) / 2, a[1] + 0.14) if along else (a[0] - 0.14, (a[1] + b[1]) / 2)
    turn = 0 if along else 90
    axes.text(*at, f"{length:.2f}", fontsize=6.5, color=INK, ha="center", va="center", rotation=turn, zorder=6,
              gid="frame/dimensions")
