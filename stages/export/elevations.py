"""The walls of all rooms seen from within, with sections of kitchens, to scale, with dimensions, elevations.svg."""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Plan
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.export._labels import title
from apartgen.stages.export._layers import grouped
from apartgen.stages.export._pen import FAINT, INK, PAPER, STEEL, WATER, WOOD, Pen
from apartgen.stages.export._readback import read_xml
from apartgen.stages.export._seen_walls import Placed, Seen, walls_seen
from apartgen.stages.scene.scene import Scene

NEEDS_ASSETS = False

INCH = 0.8
"""Inches of paper to a metre."""
GAP, MARGIN = 1.5, 0.9
"""Between walls and about them, m."""
ABOVE, BELOW = 0.55, 0.75
"""Of a row of walls, m, for its title and its dimensions."""
POCHE, SLAB = "#2f2d2b", 0.12
LEAST = 0.1
"""What is shorter has no dimension of its own, m."""
STEP = 0.02
"""Heights nearer to one another are one, m."""
LAYERS = 10.0
"""Of a drawing; the next one is drawn above them."""
LOW = 0.2
"""What begins lower stands on the floor, m."""
HUNG = 1.2
"""What begins higher hangs, m."""
DEEPEST = 0.75
"""Of a section, m."""


@dataclass(frozen=True)
class _Spot:
    """Where on the sheet something is drawn: its lower left corner on the floor, and what it lies above."""

    axes: Axes
    left: float
    floor: float
    order: float

    def pen(self, order: float, name: str) -> Pen:
        """From that corner."""
        return Pen(self.axes, self.left, self.floor, 0.0, self.order + order, name)


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, elevations.svg, a row for each room; kitchens come first."""
    path, drawn = out / "elevations.svg", io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "apartgen", "svg.fonttype": "none"}):
        sheet(scene.home).savefig(drawn, format="svg", metadata={"Date": None, "Creator": "apartgen"})
    path.write_text(grouped(drawn.getvalue()), encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """By the parser of XML."""
    read_xml(files[0])


def rows(home: Plan) -> list[list[Seen]]:
    """The furnished walls of each room that has some, kitchens first."""
    rooms = sorted(home.rooms, key=lambda room: room.base != "kitchen")
    found = [list(walls_seen(home, [room])) for room in rooms] if isinstance(home, Layout) else []
    return [row for row in found if row]


def sheet(home: Plan) -> Figure:
    """All rows below one another."""
    found = rows(home)
    wide = max((sum(_width(wall) + GAP for wall in row) for row in found), default=3.0) + 2 * MARGIN
    high = len(found) * (home.height + ABOVE + BELOW) + 2 * MARGIN
    paper = Figure(figsize=(wide * INCH, high * INCH), facecolor=PAPER)
    axes = paper.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_xlim(0, wide)
    axes.set_ylim(0, high)
    axes.axis("off")
    floor, order = high - MARGIN, 0.0
    for row in found:
        floor, left = floor - home.height - ABOVE, MARGIN
        for wall in row:
            _elevation(_Spot(axes, left, floor, order), wall, home.height)
            if _cut(wall):
                _section(_Spot(axes, left + wall.length + GAP, floor, order + LAYERS), wall, home.height)
            left, order = left + _width(wall) + GAP, order + 2 * LAYERS
        floor -= BELOW
    if not found:
        axes.text(MARGIN, high / 2, "no furnished walls", fontsize=8, color=INK)
    return paper


def _width(wall: Seen) -> float:
    return wall.length + (GAP + DEEPEST if _cut(wall) else 0.0)


def _cut(wall: Seen) -> bool:
    """Whether it has a section, too: a kitchen's run of units."""
    return wall.room.base == "kitchen" and sum(put.low < LOW for _, put in wall.things) > 1


def _name(wall: Seen) -> str:
    return f"{wall.room.id}_{wall.number}"


def _elevation(at: _Spot, wall: Seen, height: float) -> None:
    """One wall with all before it, its dimensions below and to the right of it."""
    name, length = _name(wall), wall.length
    at.axes.text(at.left, at.floor + height + 0.22, f"{title(wall.room)}, wall {wall.number}", fontsize=8, color=INK,
                 zorder=at.order + 8, gid=f"{name}/title")
    at.pen(1.0, f"{name}/wall").rect(0, length, 0, height, "#fbfaf8", ink=INK, width=1.1)
    for opening, put in wall.openings:
        _opening(at.pen(2.0, f"{name}/{opening.id}"), opening, put)
    for k, (thing, put) in enumerate(wall.things):
        _front(at.pen(3.0 + 0.01 * k, f"{name}/{thing.id}"), thing, put)
    at.pen(5.0, f"{name}/floor").line((-0.15, 0), (length + 0.15, 0), ink=POCHE, width=1.8)
    stops = [0.0, *_ends([put for _, put in wall.things if put.low < LOW], length), length]
    heights = [0.0, *(z for _, put in wall.things for z in (put.low, put.high)), height]
    _chain(at, name, [(x, -0.22) for x in _merged(stops)])
    _chain(at, name, [(0.0, -0.5), (length, -0.5)])
    _chain(at, name, [(length + 0.28, z) for z in _merged(heights)])


def _ends(some: Sequence[Placed], length: float) -> list[float]:
    return [min(max(x, 0.0), length) for put in some for x in (put.left, put.right)]


def _merged(values: Sequence[float]) -> list[float]:
    """In order, those that all but meet as one; the first and the last stay."""
    found = [min(values)]
    for value in sorted(values):
        if value - found[-1] > STEP:
            found.append(value)
    found[-1] = max(values)
    return found


def _opening(pen: Pen, o: Opening, put: Placed) -> None:
    pen.rect(put.left, put.right, put.low, put.high, WATER if o.kind == "window" else PAPER, width=0.8)
    if o.kind == "window":
        pen.rect(put.left + 0.05, put.right - 0.05, put.low + 0.05, put.high - 0.05, None, ink=FAINT)
    elif o.kind != "opening":
        pen.line((put.left, put.high), (put.right, put.low), ink=FAINT, dashed=True)


def _front(pen: Pen, o: Box, put: Placed) -> None:
    """Its outline, the fronts of what opens, and how it opens: dashes meet where hinges are, a dash is a drawer's."""
    fill = WOOD if o.on in (None, "floor", "wall") else STEEL
    pen.rect(put.left, put.right, put.low, put.high, fill, width=0.8)
    middle, level = (put.left + put.right) / 2, (put.low + put.high) / 2
    for joint in o.joints if isinstance(o, Furnishing) else []:
        if joint.extent:
            (_, y0, z0), (_, y1, z1) = joint.extent
            _leaf(pen, joint, (middle + y0, middle + y1, level + z0, level + z1), middle, level)


def _leaf(pen: Pen, joint: Joint, edges: tuple[float, float, float, float], middle: float, level: float) -> None:
    x0, x1, z0, z1 = edges
    pen.rect(x0, x1, z0, z1, None, ink=INK, width=0.45)
    if joint.type == "slide":
        if abs(joint.axis[0]) > 0.5:
            pen.line(((x0 + x1) / 2 - 0.06, z1 - 0.05), ((x0 + x1) / 2 + 0.06, z1 - 0.05), width=0.9)
    elif abs(joint.axis[2]) > 0.5:
        tip, other = (x0, x1) if abs(middle + joint.origin[1] - x0) < abs(middle + joint.origin[1] - x1) else (x1, x0)
        pen.line((other, z0), (tip, (z0 + z1) / 2), (other, z1), ink=FAINT, width=0.4, dashed=True)
    else:
        tip, other = (z0, z1) if abs(level + joint.origin[2] - z0) < abs(level + joint.origin[2] - z1) else (z1, z0)
        pen.line((x0, other), ((x0 + x1) / 2, tip), (x1, other), ink=FAINT, width=0.4, dashed=True)


def _section(at: _Spot, wall: Seen, height: float) -> None:
    """A cut square to the wall, which is on the left: how deep and how high what stands and hangs there is."""
    name = f"{_name(wall)}_section"
    pen = at.pen(3.0, f"{name}/cut")
    pen.rect(-SLAB, 0, -SLAB, height + SLAB, POCHE)
    pen.rect(0, DEEPEST, -SLAB, 0, POCHE)
    pen.rect(0, DEEPEST, height, height + SLAB, POCHE)
    kept = sorted(((o, put) for o, put in wall.things if o.size[0] <= DEEPEST), key=lambda one: -one[0].size[0])
    for k, (o, put) in enumerate(kept):
        at.pen(4.0 + 0.01 * k, f"{name}/{o.id}").rect(0, o.size[0], put.low, put.high, None, width=0.7)
    for deep, z in ((_deepest(kept, 0.0, LOW), -0.32), (_deepest(kept, HUNG, height), height - 0.25)):
        if deep > LEAST:
            _chain(at, name, [(0.0, z), (deep, z)])


def _deepest(some: Sequence[tuple[Box, Placed]], low: float, high: float) -> float:
    """Depth of the deepest that begins between two heights."""
    return max((o.size[0] for o, put in some if low <= round(put.low, 3) < high), default=0.0)


def _chain(at: _Spot, name: str, points: Sequence[tuple[float, float]]) -> None:
    """Dimensions from point to point along one line, in centimetres."""
    pen = at.pen(6.0, f"{name}/dimensions")
    pen.line(points[0], points[-1], ink=FAINT)
    for x, y in points:
        pen.line((x - 0.04, y - 0.04), (x + 0.04, y + 0.04), ink=INK, width=0.7)
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        length = abs(bx - ax) + abs(by - ay)
        if length >= LEAST:
            up = abs(by - ay) > abs(bx - ax)
            x, y = at.left + (ax + bx) / 2 + (0.07 if up else 0), at.floor + (ay + by) / 2 + (0 if up else 0.07)
            at.axes.text(x, y, f"{100 * length:.0f}", fontsize=4.5, color=INK, ha="center", va="center",
                         zorder=at.order + 6, rotation=90 if up else 0, gid=f"{name}/dimensions")
