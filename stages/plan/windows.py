"""Windows: on façades only, sized from the floor area, clear of doors and of what stands in them."""

import numpy as np
from shapely.geometry import LineString, Polygon

from apartgen.schemas.plan import Opening, Program, Side, Walls
from apartgen.stages.plan import balconies, faces
from apartgen.stages.plan.blocks import facing
from apartgen.stages.plan.faces import Face
from apartgen.stages.plan.standards import STANDARDS, Standard

JAMB, HALL_JAMB = 0.35, 0.2
"""Wall left on both sides of a window, m; less where a corridor ends."""
NARROWEST = 0.6
WIDEST = 2.4
BROAD = 4.2
"""Length of a face from which two windows stand on it side by side, m."""
END = 2.2
"""Length of a face up to which it is the end of a corridor, m."""
LONG = 8.0
"""Floor of a hallway from which it may have two windows, m²."""
NEED: dict[Side, float] = {"south": 0.85, "east": 1.0, "west": 1.0, "north": 1.1}
"""Glass wanted by the side it faces: the north is lit by the sky alone."""


def place(program: Program, floors: dict[str, Polygon], doors: list[Opening], walls: Walls) -> list[Opening]:
    """Windows of all rooms that can have one."""
    out: list[Opening] = []
    hung = balconies.hung(program)
    ways = [door for door in doors if len(door.rooms) == 1 or set(door.rooms) & set(hung)]
    for room in program.rooms:
        norm = STANDARDS[room.base]
        if norm.glass == 0 and room.base != "hallway":
            continue
        before = balconies.outside(floors, program, room.id)
        free = _facades(faces.outside(floors[room.id], before), program.envelope.party_walls, ways)
        if room.base == "hallway":
            out += _ends(room.id, norm, free, walls, 2 if floors[room.id].area >= LONG else 1)
        else:
            out += _glazed(room.id, norm, floors[room.id].area, free, walls)
    return [window.model_copy(update={"id": f"window_{i + 1}"}) for i, window in enumerate(out)]


def dark(program: Program, windows: list[Opening]) -> list[str]:
    """Rooms that must have daylight and get none; a kitchen open to another room borrows its light."""
    lit = {room for window in windows for room in window.rooms} | set(balconies.hung(program).values())
    lit |= {r.id for r in program.rooms if r.base == "kitchen" and any(r.id in pair for pair in program.open_links)}
    return [room.id for room in program.rooms if STANDARDS[room.base].lit and room.id not in lit]


def _facades(found: list[Face], party_walls: list[Side], doors: list[Opening]) -> list[Face]:
    """Stretches of façade between doors, longest first."""
    out = []
    for face in found:
        if facing(*face.along) in party_walls:
            continue
        lo = 0.0
        line = LineString([face.start, face.start + face.length * face.along])
        on = [np.dot(np.array(d.segment) - face.start, face.along) for d in doors if _cuts(d, line)]
        for cut in sorted(on, key=min):
            out.append(face.part(lo, max(lo, float(cut.min()))))
            lo = float(cut.max())
        out.append(face.part(lo, face.length))
    return sorted(out, key=lambda face: (-face.length, *face.start))


def _cuts(door: Opening, line: LineString) -> bool:
    return float(LineString(door.segment).distance(line)) < 0.4


def _ends(name: str, norm: Standard, free: list[Face], walls: Walls, most: int) -> list[Opening]:
    """At most `most` narrow windows where a corridor ends at a façade; else one on its longest face."""
    usable = [face for face in free if face.length >= NARROWEST + 2 * HALL_JAMB]
    ends = [face for face in usable if face.length <= END]
    return [
        _window(name, norm, norm.sill, face, 0.5, min(face.length - 2 * HALL_JAMB, 0.9), walls)
        for face in (ends[:most] or usable[:1])
    ]


def _glazed(name: str, norm: Standard, area: float, free: list[Face], walls: Walls) -> list[Opening]:
    """Windows on at most three faces, until the glass suffices; wide demand lowers the sill."""
    out: list[Opening] = []
    usable = [face for face in free if face.length >= NARROWEST + 2 * JAMB]
    sill = norm.sill
    room = sum(min(face.length - 2 * JAMB, WIDEST) for face in usable[:2])
    if norm.lit and room * (norm.head - sill) < norm.glass * area:
        sill = 0.3
    lack = norm.glass * area
    for face in usable[:3]:
        if (lack <= 0.2 and out) or (not norm.lit and out):
            break
        need = NEED[facing(*face.along)] if norm.lit else 1.0
        least, widest = (0.9, WIDEST) if norm.lit else (NARROWEST, 0.9)
        wanted = need * lack / (norm.head - sill)
        pair = norm.lit and face.length >= BROAD and wanted >= 2 * least
        many = 2 if pair else 1
        most = face.length / many - 2 * JAMB
        clear = min(float(np.clip(wanted / many, least, widest)), most)
        out += [_window(name, norm, sill, face, (i + 0.5) / many, clear, walls) for i in range(many)]
        lack -= many * clear * (norm.head - sill) / need
    return out


def _window(
    name: str, norm: Standard, sill: float, face: Face, middle: float, clear: float, walls: Walls
) -> Opening:
    """A window about a share of the face's length."""
    clear = round(clear, 2)
    lo = middle * face.length - 0.5 * clear
    segment = face.segment(lo, lo + clear, walls.outer / 2)
    return Opening(id="window", kind="window", rooms=[name], segment=segment, sill=sill, head=norm.head)
