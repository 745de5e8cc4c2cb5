"""What pictures show beyond doubt: where they were taken, fronts, counts, how the camera turned."""

from collections.abc import Iterable, Sequence
from itertools import combinations
from math import dist

import numpy as np
import shapely
from shapely.geometry import LineString, Point

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.render import View
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.whole import BEFORE
from apartgen.stages.space import polygons
from apartgen.stages.things.carrying import by_another
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import alike

INSIDE = 0.65
"""Share of a picture that is of the room it was taken in, where nobody takes it for one of another."""
TOLD = 0.01
"""Share of a picture from which a thing tells what a room is for."""
COUNTED = 0.002
"""Share of a panorama that a thing covers that nobody overlooks."""
TURNED = 0.08
"""Share of the picture's width by which what stays in sight moves at least when the camera turns."""
ODD = 1
"""Things that a room may have although they are seldom in such rooms."""
LEVEL = 0.5
"""Upward part of a hinge's axis below which it is level."""
COMPANY = 2
"""How many things tell how a camera turned, or where it is, at least."""
BESIDE = 0.02
"""Things on others that are no further apart look like one, m."""
BLANK = ("midcentury",)
"""Styles of the embedded furniture whose fronts are fluted and without handles: nobody sees how many there are."""
DOORWAY = 0.6
"""Who is no farther from a door or a passage may be said to be in either room, m."""
SEEN = 0.95
"""Share of a room's floor that is in sight of where its panorama was taken, at least."""
SPOT = 0.1
"""Floor is looked at in squares of so much, m."""
MAY_OPEN = {"mirror", "radiator", "speaker", "tv"}
"""What on walls and floors does not open and might."""
MORE = {"shower", "dryer", "washing_machine"}
"""What may open otherwise than it does, or in more places: panes without rails or hinges, machines with a flap."""
LYING, BEDDED = 0.5, 0.1
"""How high one lies, m, and share of a bed's length behind its middle beyond which pillows may be."""
UNTOLD = {"bookshelf", "towel_rail", "kitchen_corner", "sliding_wardrobe"}
"""What shows books or a towel of its own, which one may mean instead, what looks like a cabinet that opens, its end
behind the next line of units, and what may show nothing but a mirror."""
EDGE = 0.02
"""What reaches so far over a rug stands on it, m."""
COMMON = 0.004
"""Share of both pictures that a thing covers by which one can tell."""


def in_its_room(facts: Facts, view: View) -> bool:
    """Whether nearly all that a view shows is of the room that it was taken in, and not of one behind a door."""
    rooms = {thing.number: thing.room for thing in facts.render.instances}
    own = sum(part.pixels for part in view.visible if rooms[part.number] == view.room)
    return own > INSIDE * sum(part.pixels for part in view.visible if rooms[part.number])


def could_be(facts: Facts, view: View) -> set[str]:
    """Types of the home's rooms in which all that a view shows well, or all but one thing, is at home, so that it may
    be of one of them; a living room has a bed only where there is no bedroom.
    """
    shown = [TABLE[facts.objects[id].category] for id, share in facts.shares[view.name].items()
             if id in facts.objects and share > TOLD and facts.objects[id].category in TABLE]
    bedrooms = any(room.base == "bedroom" for room in facts.rooms.values())
    slept = bedrooms and any("sleep" in kind.uses for kind in shown)
    return {facts.type_of(id) for id, room in facts.rooms.items() if (not slept or room.base == "bedroom")
            and sum(bool(kind.rooms) and room.base not in kind.rooms for kind in shown) <= ODD}


def tells_its_place(facts: Facts, view: View) -> bool:
    """Whether one finds on a plan where a view was taken: most of it is of its room, it shows some things there, and it
    was not taken in a doorway.
    """
    eye = Point(view.eye[:2])
    ways = [LineString(o.segment) for o in facts.home.openings if o.kind in polygons.PASSAGES]
    between = any(way.distance(eye) < DOORWAY for way in ways)
    return in_its_room(facts, view) and len(facts.known(view.name)) >= COMPANY and not between


def overhead(o: Box) -> bool:
    """Whether it hangs from the ceiling, where a picture hardly tells how far away it is."""
    return o.category in TABLE and TABLE[o.category].place == "ceiling"


def flat(o: Box) -> bool:
    """Whether it lies flat on the floor, perhaps on under what stands there."""
    return o.category in TABLE and TABLE[o.category].place == "flat"


def bounded(facts: Facts, id: str) -> bool:
    """Whether one sees where a thing ends: not a rug that goes on under others, nor a unit of a kitchen among others,
    nor leaves over a pot.
    """
    kind = TABLE.get(facts.objects[id].category)
    lined = kind is not None and kind.run in ("fitted", "hung", "unit")
    return kind is None or not (kind.place == "flat" or lined or "leaves" in kind.symbol)


def rests_on(facts: Facts, ids: Iterable[str]) -> bool:
    """Whether one of these stands or lies on another, as a throw on a bed."""
    some = set(ids)
    return any(facts.objects[id].on in some for id in some)


def in_sight(facts: Facts, room: str, view: View) -> float:
    """Share of a room's floor that a camera has straight before it or behind, with no corner of the room between."""
    floor = polygons.floor(facts.rooms[room])
    low_x, low_y, high_x, high_y = floor.bounds
    x, y = np.meshgrid(np.arange(low_x, high_x, SPOT) + SPOT / 2, np.arange(low_y, high_y, SPOT) + SPOT / 2)
    spots = np.column_stack([x.ravel(), y.ravel()])
    spots = spots[shapely.contains_xy(floor, *spots.T)]
    eye = np.broadcast_to(np.array(view.eye[:2]), spots.shape)
    ways = shapely.linestrings(np.stack([eye, spots], axis=1))
    return float(shapely.covers(floor.buffer(EDGE), ways).mean()) if len(spots) else 0.0


def edgewise(o: Box, view: View) -> bool:
    """Whether a view shows what hangs on a wall from so far aside that one hardly knows it."""
    if o.on != "wall":
        return False
    way = np.array(view.eye[:2]) - o.center[:2]
    return float(way @ [np.cos(o.yaw), np.sin(o.yaw)]) < BEFORE * float(np.linalg.norm(way))


def side_by_side(facts: Facts, ids: Iterable[str]) -> bool:
    """Whether two of these stand so close that they may be taken for one."""
    return any(facts.print(a).distance(facts.print(b)) < BESIDE for a, b in combinations(list(ids), 2))


def may_open(o: Furnishing) -> bool:
    """Whether one may think that something of a thing opens that does not: machines on tops have lids, mirrors may be
    doors, fronts below a sink or on a wall are seamless but for a handle that one hardly sees.
    """
    kind = TABLE.get(o.category)
    if o.category in MORE or kind is not None and (kind.run in ("fitted", "hung") or kind.run and kind.is_for("rinse")):
        return True
    return not o.joints and (kind is None or kind.place == "top" or o.category in MAY_OPEN)


def on_pillow(o: Box, view: View, pixel: Sequence[int]) -> bool:
    """Whether a pixel, column and row, of a bed may show its pillows or its head."""
    kind = TABLE.get(o.category)
    if kind is None or "sleep" not in kind.uses or "bed" not in kind.symbol or view.intrinsics is None:
        return False
    fx, fy, cx, cy = view.intrinsics
    pose = np.array(view.pose)
    ray = pose[:3, :3] @ [(pixel[0] + 0.5 - cx) / fx, (pixel[1] + 0.5 - cy) / fy, 1.0]
    lying = o.center[2] - o.size[2] / 2 + LYING
    far = (lying - pose[2, 3]) / ray[2] if ray[2] < 0 else 0.0
    ahead = float(((pose[:3, 3] + far * ray)[:2] - o.center[:2]) @ [np.cos(o.yaw), np.sin(o.yaw)])
    return ray[2] >= 0 or ahead < -BEDDED * o.size[0]


def told_apart(home: Layout) -> list[str]:
    """Ids of what a number in a picture means beyond doubt: not one half of a pair of curtains, nor one of several
    alike that stand on something side by side, nor a shelf of whose books one may mean one.
    """
    carried = [o for o in home.objects if by_another(o)]
    apart = [o for o in home.objects if not (o.category in TABLE and TABLE[o.category].symbol == "folds")
             and o.category not in UNTOLD]
    twins = {one.id for one in carried for other in carried if one.id != other.id and one.category == other.category
             and dist(one.center, other.center) < (max(one.size) + max(other.size)) / 2 + BESIDE}
    return [o.id for o in apart if o.id not in twins]


def on_a_rug(facts: Facts, id: str) -> bool:
    """Whether it stands on the floor and on a rug that lies there."""
    flat = [o.id for o in facts.home.objects if o.category in TABLE and TABLE[o.category].place == "flat"]
    return facts.stands(id) and any(facts.print(id).buffer(-EDGE).intersects(facts.print(rug)) for rug in flat)


def at_edge(facts: Facts, id: str, view: str) -> bool:
    """Whether the picture ends where a thing may go on."""
    number, shown = next(thing.number for thing in facts.render.instances if thing.id == id), facts.views[view]
    x, y, wide, high = next(part.rectangle for part in shown.visible if part.number == number)
    return x <= 0 or y <= 0 or x + wide >= shown.width or y + high >= shown.height


def fronted(facts: Facts, id: str) -> bool:
    """Whether everybody sees where its front is: what stands on the floor and is no table for people all round,
    nor leaves."""
    kind = TABLE.get(facts.objects[id].category)
    return kind is not None and kind.place == "floor" and facts.faces(id) \
        and "table" not in kind.symbol and "leaves" not in kind.symbol


def countable(facts: Facts, view: str, ids: Iterable[str]) -> bool:
    """Whether a panorama shows each of these well and none in two parts, at its left and its right end, in a room of
    which nothing is round a corner.
    """
    shown = facts.views[view]
    if shown.room in facts.rooms and in_sight(facts, shown.room, shown) < SEEN:
        return False
    numbers = {thing.id: thing.number for thing in facts.render.instances}
    wide = facts.views[view].width
    across = {part.number: part.rectangle[0] == 0 and part.rectangle[2] == wide for part in facts.views[view].visible}
    return all(facts.shares[view].get(id, 0) > COUNTED and not across[numbers[id]] for id in ids)


def shifted(facts: Facts, a: View, b: View) -> float | None:
    """How far to the right, as a share of the width, what two views show moves from the one to the other; None where
    too little is in both, or not all of it moves one way.
    """
    things = {thing.number for thing in facts.render.instances if thing.box}
    middle = [{part.number: part.rectangle[0] + part.rectangle[2] / 2 for part in view.visible
               if part.number in things and part.pixels > COMMON * view.width * view.height} for view in (a, b)]
    moves = [(middle[1][k] - middle[0][k]) / a.width for k in middle[0].keys() & middle[1].keys()]
    if len(moves) < COMPANY or min(map(abs, moves)) < TURNED or len({move > 0 for move in moves}) > 1:
        return None
    return sum(moves) / len(moves)


def blank(o: Furnishing) -> bool:
    """Whether what opens has fronts that show neither seams nor handles."""
    return bool(o.joints) and o.asset.library == "parametric" and any(f"/{style}/" in o.asset.id for style in BLANK)


def fronted_like_units(o: Furnishing) -> bool:
    """Whether a kitchen's front hides what appliance it is, as it does dishwashers."""
    kind = TABLE.get(o.category)
    return kind is not None and kind.run == "fitted" and "bake" not in kind.uses


def usual(facts: Facts, view: str) -> set[str]:
    """Categories that rooms such as a view shows have in this home, of which one may think where little is seen."""
    types = {facts.type_of(room) for room in {facts.objects[id].room for id in facts.shares[view]
                                              if id in facts.objects} | {facts.views[view].room} if room in facts.rooms}
    return {o.category for o in facts.home.objects if o.room in facts.rooms and facts.type_of(o.room) in types}


def hides_how(o: Furnishing) -> bool:
    """Whether things that look much alike open in another way: wardrobes with sliding doors, flaps one above another
    that may be drawers, dishwashers behind a kitchen's fronts; or one does not see what opens.
    """
    if blank(o) or fronted_like_units(o):
        return True
    if sum(joint.type == "hinge" and abs(joint.axis[2]) < LEVEL for joint in o.joints) > 1:
        return True
    category = o.category
    sliding = {name for name, kind in TABLE.items() if kind.opens == "sliding"}
    return any(category in (name, other) for name in sliding for other in TABLE
               if other != name and TABLE[other].opens and alike(name, other))
