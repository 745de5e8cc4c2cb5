"""How good the solver is: programmes of common flats from studio to four bedrooms, and figures of a plan."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from apartgen.schemas.plan import AskedRoom, Plan, Program
from apartgen.stages.plan import validate
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.space import polygons


def archetypes() -> dict[str, Program]:
    """Complete programmes of eight common flats, 40 to 180 m²."""
    table = json.loads((Path(__file__).parent / "archetypes.json").read_text())
    return {name: _program(row) for name, row in table.items()}


def _program(row: dict[str, Any]) -> Program:
    private = row.get("private", {})
    rooms = [
        AskedRoom(id=name, type=name.rsplit("_", 1)[0], area=area, private_to=private.get(name))
        for name, area in row["rooms"]
    ]
    return Program(rooms=rooms, links=row["links"], open_links=row["open_links"], complete=True)


def constraint_score(plan: Plan) -> float:
    """S_constraint (Eq. 7): one minus half the L1 distance of built and asked area shares by room type."""
    built: dict[str, float] = {}
    asked: dict[str, float] = {}
    for room in plan.rooms:
        built[room.type] = built.get(room.type, 0.0) + polygons.floor(room).area
    for want in plan.program.rooms:
        asked[want.type] = asked.get(want.type, 0.0) + (want.area or 0.0)
    b, a = sum(built.values()), sum(asked.values())
    return 1 - 0.5 * sum(abs(built.get(t, 0) / b - asked.get(t, 0) / a) for t in sorted({*built, *asked}))


def edge_score(plan: Plan) -> float:
    """S_edge (Eq. 9) of doors and openings against the links asked for."""
    built = {frozenset(o.rooms) for o in plan.openings if o.kind in ("door", "opening")}
    asked = {frozenset(p) for p in [*plan.program.links, *plan.program.open_links]}
    return len(built & asked) / max(len(built), len(asked), 1)


def measured(plan: Plan) -> dict[str, float]:
    """Figures of one plan."""
    shapes = polygons.floors(plan)
    lived = [shapes[r.id] for r in plan.rooms if STANDARDS[r.type].functional]
    total = sum(s.area for s in shapes.values())
    spans = [np.subtract(s.bounds[2:], s.bounds[:2]) for s in lived]
    rooms = [shapes[r.id] for r in plan.rooms if r.type != "hallway"]
    return {
        "faults": float(len(validate(plan))),
        "relaxed": float(len(plan.relaxed)),
        "S_edge": edge_score(plan),
        "S_constraint": constraint_score(plan),
        "aspect": max(float(s.max() / s.min()) for s in spans) if spans else 1.0,
        "corridor": sum(shapes[r.id].area for r in plan.rooms if r.type == "hallway") / total,
        "rectangular": float(np.mean([s.area > 0.999 * shapely.box(*s.bounds).area for s in rooms])),
    }
