"""What opens: parts of furniture, room doors, and the ways through walls; all of it must have room."""

from collections.abc import Iterator

import numpy as np
import shapely
from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.check.building import Site
from apartgen.stages.check.fault import Fault
from apartgen.stages.check.furniture import BACK, USE, gives_way, is_seat
from apartgen.stages.check.shapes import TOUCH, Array, Boxes, boxes, common, depth, joined, turned
from apartgen.stages.things.categories import TABLE

Solids = tuple[list[str], Boxes, Array]
OPEN = np.linspace(0, np.pi / 2, 19)
"""Angles at which a leaf is looked at; other parts are at as many positions."""
FAR = 10.0
"""No part is larger or opens further, m or rad."""
HEADROOM, WAY = 1.8, 0.2
"""One walks under what hangs higher; and before and behind a door so much must be free, m."""
PAN = (-0.4, -0.4, -0.5), 0.5
"""What one sits on begins at this corner in shares of the seat's size, and is solid to this height, m."""
INSIDE, HOLLOW = 0.02, 0.05
"""How far parts may go into the box of a cabinet, and at most of what does not fill its box, m."""


def faults(home: Layout, site: Site) -> Iterator[Fault]:
    """Everything that can't open all the way."""
    solids, things = _solids(home, site), {o.id for o in home.objects}
    for o, it in site.doors:
        yield from _met("door-blocked", (o.id,), it.leaf(o, OPEN), solids, home, site)
        way = Boxes(shapely.get_coordinates(it.cut(WAY))[None, :4], OPEN[:1], OPEN[:1] + HEADROOM)
        met = [fault for fault in _into("way-blocked", (o.id,), way, solids) if fault.of[-1] in things]
        yield from met
    for piece in home.objects:
        for joint in piece.joints if isinstance(piece, Furnishing) else []:
            if not _sound(joint):
                yield Fault("joint", (piece.id, joint.name), piece.center)
            elif joint.extent is not None:
                yield from _met("part-blocked", (piece.id, joint.name), _positions(piece, joint), solids, home, site)


def _sound(joint: Joint) -> bool:
    """Whether it opens at all, and what it moves is no larger than anything can be."""
    lo, hi = np.array(joint.extent or ((0, 0, 0), (0, 0, 0)), float)
    far = np.abs([*lo, *hi, *joint.origin, *joint.range, *joint.axis]).max() > FAR
    return bool(joint.range[1] - joint.range[0] > USE and (lo <= hi).all() and not far)


def _solids(home: Layout, site: Site) -> Solids:
    """What is surely solid, whose it is, and how far into it parts may go: boxes, but of a seat what one sits on and
    its back; and the open leaves of doors.
    """
    hard = [o for o in home.objects if not gives_way(o)]
    seats, rest = [o for o in hard if is_seat(o)], [o for o in hard if not is_seat(o)]
    pans = [boxes([o], PAN[0], (0.4, 0.4, min(0.5, PAN[1] / o.size[2] - 0.5))) for o in seats]
    doors = [(o.id, it.leaf(o, OPEN[-1:])) for o, it in site.doors if o.kind == "door"]
    full = [o.category in TABLE and TABLE[o.category].opens != "" for o in rest]
    give = [INSIDE if it else min(HOLLOW, min(o.size) / 2) for o, it in zip(rest, full)]
    names = [*(o.id for o in (*rest, *seats, *seats)), *(name for name, _ in doors)]
    found = joined([boxes(rest), *pans, boxes(seats, hi=BACK), *(leaf for _, leaf in doors)])
    return names, found, np.array([*give, *([HOLLOW] * 2 * len(seats)), *([INSIDE] * len(doors))])


def _met(code: str, of: tuple[str, ...], part: Boxes, solids: Solids, home: Layout, site: Site) -> Iterator[Fault]:
    """What a moving part meets on its way: other things, walls, the ceiling or the floor."""
    yield from _into(code, of, part, solids)
    out = [Polygon(ring).difference(site.open) for ring in part.corners[~shapely.covers(site.open, part.marks())]]
    worst = max(out, key=lambda wall: wall.area, default=Polygon())
    if worst.area > TOUCH**2:
        yield Fault(code, (*of, "wall"), (worst.centroid.x, worst.centroid.y))
    if (beyond := max(float(part.high.max()) - home.height, -float(part.low.min()))) > TOUCH:
        yield Fault(code, (*of, "storey"), tuple(part.corners.mean((0, 1)).tolist()), beyond)


def _into(code: str, of: tuple[str, ...], part: Boxes, solids: Solids) -> Iterator[Fault]:
    """Which solids but its own a part goes into, at any of its positions."""
    names, every, give = solids
    ends = part.corners.min((0, 1)), part.corners.max((0, 1))
    near = np.flatnonzero(((every.corners.max(1) > ends[0]) & (every.corners.min(1) < ends[1])).all(1))
    deep = depth(part, Boxes(*(field[near] for field in every)))
    for k, j in enumerate(near.tolist()):
        if names[j] != of[0] and deep[:, k].max() > give[j]:
            at = common(part, int(deep[:, k].argmax()), every, j)
            yield Fault(code, (*of, names[j]), at, float(deep[:, k].max()))


def _positions(o: Box, joint: Joint) -> Boxes:
    """Where a part is on its way, as upright boxes in the world; what turns about another axis than z lies in them."""
    lo, hi = np.array(joint.extent, float)
    values = np.linspace(*joint.range, len(OPEN))[:, None, None]
    axis, origin = np.array(joint.axis) / np.linalg.norm(joint.axis), np.array(joint.origin)
    arm = np.where(np.indices((2, 2, 2)).reshape(3, -1).T == 0, lo, hi) - origin
    along = (arm @ axis)[:, None] * axis
    moved = (arm + values[[0, -1]] * axis).reshape(1, 16, 3)  # all the way at once
    if joint.type == "hinge":  # Rodrigues' formula
        moved = along + np.cos(values) * (arm - along) + np.sin(values) * np.cross(axis, arm)
    if joint.type == "hinge" and abs(axis[2]) > 0.999:
        ring = moved[:, [0, 4, 6, 2], :2]
    else:
        (x0, y0, _), (x1, y1, _) = moved.min(1).T, moved.max(1).T
        ring = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]).transpose(2, 0, 1)
    heights = moved[..., 2] + origin[2] + o.center[2]
    corners = turned(ring + origin[:2], np.full(len(ring), o.yaw)) + o.center[:2]
    return Boxes(corners, heights.min(1), heights.max(1))
