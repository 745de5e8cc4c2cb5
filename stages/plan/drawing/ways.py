"""Openings of a drawn plan: those drawn, in their walls, and those that it takes to get into every room and to see."""

from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from shapely.geometry import Point, Polygon

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.plan import drawn, faces, windows
from apartgen.stages.plan.doors import HEAD, OPEN_HEAD
from apartgen.stages.plan.drawing import Hole, leaves
from apartgen.stages.plan.drawing.floors import at
from apartgen.stages.plan.drawing.leaves import Way
from apartgen.stages.plan.drawing.openings import Cut, cut
from apartgen.stages.space import polygons

SILL, WINDOW_HEAD = 0.9, 2.2
"""Of windows whose heights a drawing does not tell, m."""
END = 0.05
"""Wall left at both ends of what is open between two rooms, m."""
SAME = 0.5
"""Holes that share more than this of their width are one."""
CUT_SHORT = 0.05
"""Holes that lose more than this are told, m."""
EASE = 0.01
APART = 0.02
"""Wall between two holes, m."""
LEAST = 0.3
"""What is left of a hole is at least this wide, m."""


def opened(
    plan: Plan, holes: list[Hole], open_: list[tuple[str, str]], standing: list[Polygon], said: list[str]
) -> Plan:
    """The plan with openings; `open_` are pairs of rooms without a wall between. Unmet where none leads to a room."""
    plan, cuts = _cut(plan, holes, said)
    cuts += [_parting(plan, pair) for pair in open_ if not any({*pair} == {*c.rooms} for c in cuts)]
    ordered = sorted(cuts, key=lambda c: c.hole.kind == "door")
    for found in ordered:
        opening = _opening(found, plan, said)
        plan = _with(plan, opening)
        if opening.kind in ("door", "entrance"):
            leaf = leaves.hung(opening, plan, _drawn_way(found, opening, plan), standing)
            plan = plan.model_copy(update={"openings": [*plan.openings[:-1], leaf]})
    return _entered(_joined(plan, standing, said), standing, said)


def _cut(plan: Plan, holes: list[Hole], said: list[str]) -> tuple[Plan, list[Cut]]:
    """The holes in their walls. Outside walls are at least as thick as half of any inner wall with a hole in it, as
    readers look for the rooms of an opening so far from it.
    """
    floors, remarks = polygons.floors(plan), list[str]()
    cuts = _cuts(plan, holes, remarks)
    deep = max(
        (floors[room].distance(Point(c.ends.mean(0))) for c in cuts if len(c.rooms) == 2 for room in c.rooms),
        default=0.0,
    )
    if deep > max(plan.walls.inner, plan.walls.outer) - EASE:
        plan = plan.model_copy(update={"walls": plan.walls.model_copy(update={"outer": round(deep + EASE, 3)})})
        remarks = []
        cuts = _cuts(plan, holes, remarks)
    said += remarks
    return plan, cuts


def _cuts(plan: Plan, holes: list[Hole], said: list[str]) -> list[Cut]:
    floors = polygons.floors(plan)
    out: list[Cut] = []
    for hole in holes:
        found = cut(hole, floors, plan.walls.outer)
        told = f"{hole.kind} {hole.name}".strip() + f" at ({hole.ends[0][0]:.2f}, {hole.ends[0][1]:.2f})"
        if isinstance(found, str):
            said.append(f"{told} {found}: left out")
            continue
        if hole.kind == "window" and len(found.rooms) == 2:
            inside = [room for room in found.rooms if _base(plan, room) != "balcony"]
            if len(inside) != 1:
                said.append(f"{told} is between {found.rooms[0]} and {found.rooms[1]}: left out, windows lead outside")
                continue
            found = found._replace(rooms=tuple(inside))
        if hole.kind == "opening" and len(found.rooms) == 1:
            found = found._replace(hole=Hole(hole.name, "door", hole.ends, hole.sill, hole.head))
        if any(_doubles(found, other) for other in out):
            continue
        found = _beside(found, out)
        left = float(np.hypot(*(found.ends[1] - found.ends[0])))
        lost = np.hypot(*np.subtract(*hole.ends)) - left
        if left < LEAST:
            said.append(f"{told} lies over another one: left out")
            continue
        if lost > CUT_SHORT:
            said.append(f"{told} is {lost:.2f} m wider than its wall is straight: made narrower")
        out.append(found)
    return out


def _doubles(one: Cut, other: Cut) -> bool:
    """Whether two holes are the same one, drawn twice."""
    if set(one.rooms) != set(other.rooms) or (one.hole.kind == "window") != (other.hole.kind == "window"):
        return False
    along = other.ends[1] - other.ends[0]
    width = float(np.hypot(*along))
    spans = (one.ends - other.ends[0]) @ along / width
    off = abs(float((one.ends[0] - other.ends[0]) @ _left(along) / width))
    return bool(off < 0.1 and min(spans.max(), width) - max(spans.min(), 0.0) > SAME * width)


def _left(along: NDArray[np.float64]) -> NDArray[np.float64]:
    """A vector turned to its left by a right angle."""
    return np.array([-along[1], along[0]])


def _beside(found: Cut, others: list[Cut]) -> Cut:
    """The cut without what others have taken of its wall already."""
    for other in others:
        if not set(found.rooms) & set(other.rooms):
            continue
        start, along = found.ends[0], found.ends[1] - found.ends[0]
        width = float(np.hypot(*along))
        spans, off = (other.ends - start) @ along / width, (other.ends - start) @ _left(along) / width
        lo, hi = float(spans.min()) - APART, float(spans.max()) + APART
        if np.abs(off).max() < 0.1 and lo < width and hi > 0:
            keep = (0.0, lo) if lo > width - hi else (hi, width)
            found = found._replace(ends=start + np.clip(keep, 0.0, width)[:, None] / width * along)
    return found


def _parting(plan: Plan, pair: tuple[str, str]) -> Cut:
    """What is open between two rooms: the longest straight stretch that they share."""
    floors = polygons.floors(plan)
    face = faces.between(floors[pair[0]], floors[pair[1]])[0]
    end = END if face.length > 4 * END else 0.0
    ends = face.segment(end, face.length - end, 0.5 * (face.gap or 0.0))
    return Cut(Hole("", "opening", ends, 0.0, None), np.array(ends), pair)


def _base(plan: Plan, id: str) -> str:
    return next(room.base for room in plan.rooms if room.id == id)


def _opening(found: Cut, plan: Plan, said: list[str]) -> Opening:
    """With heights; doors of a balcony or of another room outside alone lead out."""
    hole = found.hole
    kind = "entrance" if hole.kind == "door" and len(found.rooms) == 1 else hole.kind
    usual = {"window": WINDOW_HEAD, "opening": OPEN_HEAD}.get(hole.kind, HEAD)
    sill = 0.0 if kind != "window" else SILL if hole.sill is None else max(0.0, hole.sill)
    head = min(usual if hole.head is None else hole.head, plan.height)
    if head < sill + 0.1 or (kind != "window" and head < 1.9):
        head = min(max(usual, sill + 0.6), plan.height)
        sill = min(sill, head - 0.1)
        said.append(
            f"{hole.kind} {hole.name}".strip() + f" at ({hole.ends[0][0]:.2f}, {hole.ends[0][1]:.2f}) "
            f"is too low: from {sill:g} to {head:g} m taken"
        )
    number = 1 + sum(o.kind == kind for o in plan.openings)
    a, b = ((round(float(x), 4), round(float(y), 4)) for x, y in found.ends)
    return Opening(
        id=f"{kind}_{number}",
        kind=kind,
        rooms=list(found.rooms),
        segment=(a, b),
        sill=round(sill, 4),
        head=round(head, 4),
    )


def _drawn_way(found: Cut, door: Opening, plan: Plan) -> Way | None:
    """How the leaf turns as drawn; where only its free end is drawn, into the room that it is in."""
    hole = found.hole
    if hole.swung is None:
        return None
    ends = np.asarray(door.segment, float)
    hinge = 0 if hole.hinge is None else int(np.argmin(np.hypot(*(ends - np.array(hole.hinge)).T)))
    out = np.array(hole.swung) - ends.mean(0)
    ahead = [room for room in door.rooms if float(polygons.face(door, plan, room)[0] @ out) > 0]
    return Way(1 if hinge else 0, ahead[0]) if ahead else None


def _with(plan: Plan, opening: Opening) -> Plan:
    return plan.model_copy(update={"openings": [*plan.openings, opening]})


def _named(plan: Plan, door: Opening) -> Plan:
    number = 1 + sum(o.kind == door.kind for o in plan.openings)
    return _with(plan, door.model_copy(update={"id": f"{door.kind}_{number}"}))


def _joined(plan: Plan, standing: list[Polygon], said: list[str]) -> Plan:
    """The plan with doors into the rooms that none leads to, from corridors first."""
    types = {room.id: room.base for room in plan.rooms}
    floors = polygons.floors(plan)
    start = next((o.rooms[0] for o in plan.openings if o.kind == "entrance"), None)
    start = start or min(types, key=lambda r: (drawn.LEADS.get(types[r], drawn.LAST), r))
    near = [pair for a, b in combinations(types, 2) for pair in ((a, b), (b, a)) if faces.between(floors[a], floors[b])]
    tried: set[tuple[str, str]] = set()
    while lost := set(types) - (reached := _reached(plan, start)):
        ways = [(a, b) for a, b in near if a in reached and b in lost and (a, b) not in tried]
        if not ways:
            name = sorted(lost)[0]
            raise Unmet(f"no door leads to {name} at {at(floors[name])}, and none finds room in its walls: draw one")
        pair = min(ways, key=lambda p: (drawn.cost(types, *p), floors[p[0]].distance(floors[p[1]]) > 0.3, p))
        tried.add(pair)
        door = leaves.between(plan, pair, standing)
        if door is not None:
            said.append(f"no door leads to {pair[1]}: one put in from {pair[0]}")
            plan = _named(plan, door)
    return plan


def _reached(plan: Plan, start: str) -> set[str]:
    found = {start}
    pairs = [set(o.rooms) for o in plan.openings if o.kind in ("door", "opening")]
    while more := [pair for pair in pairs if len(pair & found) == 1]:
        found = found.union(*more)
    return found


def _entered(plan: Plan, standing: list[Polygon], said: list[str]) -> Plan:
    if any(o.kind == "entrance" for o in plan.openings):
        return plan
    indoors = [room for room in plan.rooms if room.base != "balcony"] or plan.rooms
    for room in sorted(indoors, key=lambda room: (drawn.LEADS.get(room.base, drawn.LAST), room.id)):
        if (door := leaves.entrance(plan, room.id, standing)) is not None:
            x, y = door.segment[0]
            said.append(f"no entrance: one put into {room.id} at ({x:.2f}, {y:.2f})")
            return _named(plan, door)
    raise Unmet("no entrance, and no outside wall has room for one: draw one")


def lit(plan: Plan, said: list[str]) -> Plan:
    """The plan with windows where the drawing has none at all, and with a word on rooms that lack one."""
    floors = polygons.floors(plan)
    glass = [o for o in plan.openings if o.kind == "window"]
    if not glass:
        joined = [(o.rooms[0], o.rooms[1]) for o in plan.openings if o.kind == "opening"]
        program = plan.program.model_copy(update={"open_links": joined})
        glass = windows.place(program, floors, [o for o in plan.openings if o.kind != "opening"], plan.walls)
        said.append(f"no window: {len(glass)} put in" if glass else "no window, and no outside wall for one")
        plan = plan.model_copy(update={"openings": [*plan.openings, *glass]})
    return plan
