"""Whether a programme can be read as a flat at all, and what contradicts what."""

from collections import deque
from collections.abc import Mapping
from itertools import pairwise
from math import dist

from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from apartgen.schemas.consistency import too_wide
from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import AskedRoom, Program
from apartgen.stages.plan.blocks import facing
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.plan.weights import WEIGHTS

LEAST, LARGEST = 0.5, 2000.0
"""m² of a room, and of a flat."""

THROUGH = ("hallway", "living_room", "dining_room", "kitchen")
"""Rooms that lead to other rooms; bedrooms and bathrooms lead to what belongs to them only."""
BELONGING = ("bathroom", "closet", "balcony", "storage", "utility", "study")
"""Rooms that may be part of a suite, entered through a bedroom or bathroom alone."""


def neighbours(program: Program) -> dict[str, list[str]]:
    """Rooms joined to each room by a link, open or not, in the order asked."""
    near: dict[str, list[str]] = {room.id: [] for room in program.rooms}
    for a, b in links(program):
        near[a].append(b)
        near[b].append(a)
    return near


def links(program: Program) -> list[tuple[str, str]]:
    """All links once, the open ones too."""
    seen: dict[frozenset[str], tuple[str, str]] = {}
    for a, b in [*program.links, *program.open_links]:
        seen.setdefault(frozenset((a, b)), (a, b))
    return list(seen.values())


def entrance_room(program: Program) -> AskedRoom:
    """The room one enters from outside: a hallway where there is one, else the living room, else the best linked."""
    near = neighbours(program)
    rank = {"hallway": 0, "living_room": 1, "dining_room": 2, "kitchen": 3, "study": 4, "bedroom": 5}
    return min(program.rooms, key=lambda r: (rank.get(r.type, 6), -len(near[r.id]), r.id))


def check(program: Program) -> None:
    """Raise BadInput for a programme that names rooms wrongly, Unmet for one that contradicts itself."""
    ids = [room.id for room in program.rooms]
    if len(set(ids)) < len(ids):
        raise BadInput(f"program.rooms: the id {next(i for i in ids if ids.count(i) > 1)} is given twice")
    for a, b in [*program.links, *program.open_links]:
        if a == b or a not in ids or b not in ids:
            raise BadInput(f"program.links: [{a}, {b}] must name two different rooms of program.rooms")
    for name, factor in program.weights.items():
        if name not in WEIGHTS or factor < 0:
            raise BadInput(f"program.weights: {name}: {factor:g}; give a factor of at least 0 of {', '.join(WEIGHTS)}")
    _check_areas(program)
    _check_envelope(program)
    _check_ways(program)


def _check_areas(program: Program) -> None:
    asked = sum(room.area or STANDARDS[room.base].area for room in program.rooms)
    least = sum(STANDARDS[room.base].area for room in program.rooms)
    total = program.total_area
    for name, area in [*((room.id, room.area) for room in program.rooms), ("the flat", total)]:
        if area is not None and not LEAST <= area <= LARGEST:
            raise BadInput(f"program: {area:g} m² for {name} is out of range; give {LEAST:g} to {LARGEST:g} m²")
    if total is None:
        return
    if all(room.area for room in program.rooms) and asked > total * 1.15:
        raise Unmet(
            f"the rooms add up to {asked:.0f} m² ({_largest(program)}), but the flat has {total:g} m²: "
            "ask for smaller or fewer rooms or more area"
        )
    if least > total * 1.02:
        raise Unmet(
            f"{len(program.rooms)} rooms need at least {least:.0f} m² by the least areas of their types, "
            f"but the flat has {total:g} m²: ask for fewer rooms or more area"
        )


def _largest(program: Program) -> str:
    """`4 bedrooms alone 60 m²`: the type that takes most."""
    areas: dict[str, list[float]] = {}
    for room in program.rooms:
        areas.setdefault(room.type, []).append(room.area or 0.0)
    kind, found = max(areas.items(), key=lambda pair: sum(pair[1]))
    many = f"{len(found)} {kind}s" if len(found) > 1 else kind
    return f"{many.replace('_', ' ')} alone {sum(found):.0f} m²"


def _check_envelope(program: Program) -> None:
    """Whether the outline can hold the rooms, and light those that need a window."""
    lit = [room.id for room in program.rooms if STANDARDS[room.base].lit]
    if lit and len(set(program.envelope.party_walls)) == 4:
        raise Unmet(f"{lit[0]} needs a window, but all four sides are party walls: leave one side free")
    if program.envelope.outline is None:
        return
    if wrong := too_wide(program.envelope.outline):
        raise BadInput(f"program.envelope.outline: {wrong}")
    outline = Polygon(program.envelope.outline)
    if outline.area > LARGEST:
        raise BadInput(f"program.envelope.outline: has {outline.area:.0f} m²; a flat has at most {LARGEST:.0f}")
    if not outline.is_valid:
        raise BadInput("program.envelope.outline: it crosses itself; give its corners in order around the flat")
    least = sum(STANDARDS[room.base].area for room in program.rooms)
    if least > outline.area:
        raise Unmet(
            f"{len(program.rooms)} rooms need at least {least:.0f} m² by the least areas of their types, but the "
            f"outline holds {outline.area:.1f} m²: ask for fewer rooms or a larger outline"
        )
    _check_daylight(program, outline)
    for room in program.rooms:
        if outline.buffer(-0.5 * min(STANDARDS[room.base].width, 0.9 * STANDARDS[room.base].area ** 0.5)).is_empty:
            raise Unmet(
                f"the outline is nowhere wide enough for {room.id}, which needs {STANDARDS[room.base].width:g} m: "
                "ask for a wider outline"
            )


def _check_daylight(program: Program, outline: Polygon) -> None:
    """Whether the façades are long enough for the windows of all rooms that need one."""
    joined = {room for pair in program.open_links for room in pair}
    lit = [r for r in program.rooms if STANDARDS[r.base].lit and not (r.base == "kitchen" and r.id in joined)]
    needed = sum(STANDARDS[room.base].face for room in lit)
    ring = list(orient(outline).exterior.coords)
    walls = [(dist(a, b), facing(b[0] - a[0], b[1] - a[1])) for a, b in pairwise(ring)]
    light = sum(length for length, side in walls if side not in program.envelope.party_walls)
    if needed > light:
        raise Unmet(
            f"{len(lit)} rooms need {needed:.1f} m of outside wall for their windows, but the outline has "
            f"{light:.1f} m beside its party walls: ask for fewer rooms, an open kitchen or another side with windows"
        )


def _check_ways(program: Program) -> None:
    types = {room.id: room.base for room in program.rooms}
    near = neighbours(program)
    start = entrance_room(program).id
    before: dict[str, str] = {start: ""}
    queue = deque([start])
    while queue:
        here = queue.popleft()
        for there in near[here]:
            if there not in before:
                before[there] = here
                queue.append(there)
    for room in program.rooms:
        if room.id not in before:
            raise Unmet(f"no link leads from the entrance ({start}) to {room.id}: add one to program.links")
    _check_through(program, types, near, start)


def _check_through(program: Program, types: Mapping[str, str], near: dict[str, list[str]], start: str) -> None:
    """Every room must be reachable without crossing a bedroom or bathroom that it does not belong to."""
    open_to = {start}
    queue = deque([start])
    while queue:
        here = queue.popleft()
        if here != start and types[here] in ("bedroom", "bathroom"):
            continue
        for there in near[here]:
            if there not in open_to:
                open_to.add(there)
                queue.append(there)
    # A suite's own rooms lead to one another: bedroom, dressing room, bathroom.
    own = {room.id for room in program.rooms if room.type in BELONGING or room.private_to}
    queue = deque(room for room in types if room in open_to and types[room] in ("bedroom", "bathroom"))
    while queue:
        for there in near[queue.popleft()]:
            if there in own and there not in open_to:
                open_to.add(there)
                queue.append(there)
    for room in program.rooms:
        if room.id not in open_to:
            through = near[room.id][0]
            raise Unmet(f"{room.id} can only be reached through {through}: link it to a hallway or living room")
