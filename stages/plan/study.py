"""How good the solver is: programmes of common flats from studio to four bedrooms, and figures of a plan."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from apartgen.schemas.plan import AskedRoom, Plan, Program
from apartgen.stages.plan.judge import faults
from apartgen.stages.plan.standards import STANDARDS
from apartgen.stages.space import graphs, polygons


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


def measured(plan: Plan) -> dict[str, float]:
    """Figures of one plan."""
    shapes = polygons.floors(plan)
    lived = [shapes[r.id] for r in plan.rooms if STANDARDS[r.base].functional]
    total = sum(s.area for s in shapes.values())
    spans = [np.subtract(s.bounds[2:], s.bounds[:2]) for s in lived]
    rooms = [shapes[r.id] for r in plan.rooms if r.base != "hallway"]
    built, asked = graphs.of_plan(plan), graphs.of_program(plan.program)
    fidelity = graphs.constraint_satisfaction(built, asked)
    return {
        "faults": float(len(faults(plan))),
        "relaxed": float(len(plan.relaxed)),
        "S_edge": graphs.edge_similarity(built, asked),
        "S_constraint": float("nan") if fidelity is None else fidelity,
        "aspect": max(float(s.max() / s.min()) for s in spans) if spans else 1.0,
        "corridor": sum(shapes[r.id].area for r in plan.rooms if r.base == "hallway") / total,
        "rectangular": float(np.mean([s.area > 0.999 * shapely.box(*s.bounds).area for s in rooms])),
    }
