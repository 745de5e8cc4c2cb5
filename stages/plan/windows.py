"""Windows: on façades only, sized from the floor area, clear of doors and of what stands in them."""

import numpy as np
from shapely.geometry import LineString, Polygon

from schemas.plan import Opening, Program, Side, Walls
from stages.plan import faces
from stages.plan.faces import Face
from stages.plan.outline import facing
from stages.plan.standards import STANDARDS, Standard

JAMB = 0.35
"""Wall left on both sides of a window, m."""
NARROWEST = 0.6
WIDEST = 2.4


def place(program: Program, floors: dict[str, Polygon], doors: list[Opening], walls: Walls) -> list[Opening] | None:
    """Windows of all rooms, or None where one that must have daylight gets none."""
    out: list[Opening] = []
    joined = {r for pair in program.open_links for r in pair}
    for room in program.rooms:
        norm = STANDARDS[room.type]
        if room.type != "balcony" and norm.glass == 0:
            continue
        others = [floor for r, floor in floors.items() if r != room.id]
        free = _facades(faces.outside(floors[room.id], others), program.envelope.party_walls, doors)
        found = _glazed(room.id, norm, floors[room.id].area, free, walls, balcony=room.type == "balcony")
        if not found and norm.lit and not (room.type == "kitchen" and room.id in joined):
            return None
        out += found
    return [window.model_copy(update={"id": f"window_{i + 1}"}) for i, window in enumerate(out)]


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
    return len(door.rooms) == 1 and float(LineString(door.segment).distance(line)) < 0.4


def _glazed(name: str, norm: Standard, area: float, free: list[Face], walls: Walls, balcony: bool) -> list[Opening]:
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
        most = face.length - 2 * JAMB
        clear = most if balcony else float(np.clip(lack / (norm.head - sill), NARROWEST if not norm.lit else 0.9, WIDEST))
        clear = round(min(clear, most, 0.9 if not norm.lit else most), 2)
        lo = 0.5 * (face.length - clear)
        segment = face.segment(lo, lo + clear, walls.outer / 2)
        out.append(Opening(id="window", kind="window", rooms=[name], segment=segment, sill=sill, head=norm.head))
        lack -= clear * (norm.head - sill)
    return out
