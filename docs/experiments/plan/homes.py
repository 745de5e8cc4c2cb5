"""Plans beside real flats: `python homes.py 1000 FOLDER [GRAMMAR]` draws so many, then prints a table of figures.

Prompts are of households.toml, sizes and households alone, or of another grammar (`default`: that of the data sets).
FOLDER keeps a line of figures a plan, so that an interrupted run goes on. Real figures: 289 flats of RPLAN with two and
three bedrooms, 503 of Polish developers (kitchenettes), homes of Robot@VirtualHome (shapes of rooms).
"""

import json
import logging
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from apartgen import planning
from apartgen.dataset.grammar import Grammar
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan
from apartgen.stages.plan import faces, seen, validate, warm
from apartgen.stages.plan.blocks import SIDES
from apartgen.stages.space import polygons

SEED, NARROW, TOUCH = 2026, 2.6, 0.5
"""Seed of prompts and plans, width of a narrow bedroom, wall from which rooms touch, m."""
Figures = dict[str, Any]


def figures(plan: Plan) -> Figures:
    """What is compared, of one plan; None where the plan has nothing to say."""
    floors = {r.id: polygons.floor(r) for r in plan.rooms}
    inside = {r.id: floors[r.id] for r in plan.rooms if r.base != "balcony"}
    of = {kind: [r.id for r in plan.rooms if r.base == kind] for kind in {r.base for r in plan.rooms}}
    ways, _ = seen.walked(plan)
    whole = shapely.union_all(list(inside.values())).buffer(0.1, join_style="mitre")
    living, beds, baths, halls = (of.get(k, []) for k in ("living_room", "bedroom", "bathroom", "hallway"))
    return {
        "bedrooms": len(beds), "area": sum(f.area for f in inside.values()), "faults": len(validate(plan)),
        "relaxed": len(plan.relaxed), "facades": len(SIDES) - len(set(plan.program.envelope.party_walls)),
        "fills": whole.area / whole.envelope.area,
        "kitchen": [any(touch(floors, k, v) for v in living) for k in of.get("kitchen", []) if living],
        "open": [any({k, v} == set(o.rooms) and o.kind == "opening" for o in plan.openings for v in living)
                 for k in of.get("kitchen", [])],
        "balconies": len(of.get("balcony", [])), "storage": bool({"storage", "closet", "utility"} & set(of)),
        "baths": len(baths), "blind_baths": [not faces.outside(floors[b], others(inside, b)) for b in baths],
        "rectangular": [rectangular(f) for r, f in inside.items() if r not in halls],
        "rectangular_living": [rectangular(floors[r]) for r in living],
        "rectangular_beds": [rectangular(floors[r]) for r in beds],
        "living": sum(floors[r].area for r in living), "with_ways": sum(floors[r].area for r in (*living, *halls)),
        "aspect": [aspect(floors[r]) for r in living], "widths": [width(floors[r]) for r in beds],
        "private": [ways[b] >= min(ways[v] for v in living) - 0.01 for b in beds if living and b in ways],
        "together": together(floors, beds) if len(beds) > 1 else None,
        "wet": together(floors, [*baths, *of.get("kitchen", []), *of.get("utility", [])]),
        "hall": max([max(extents(floors[h])) for h in halls] or [0.0]), "farthest": max(ways.values()),
    }  # fmt: skip


def touch(floors: dict[str, shapely.Polygon], a: str, b: str) -> bool:
    """Whether two rooms share half a metre of wall."""
    return any(face.length >= TOUCH for face in faces.between(floors[a], floors[b]))


def others(inside: dict[str, shapely.Polygon], room: str) -> list[shapely.Polygon]:
    """All floors but one."""
    return [floor for id, floor in inside.items() if id != room]


def extents(floor: shapely.Polygon) -> tuple[float, float]:
    """Sides of the box about a floor, m."""
    x0, y0, x1, y1 = floor.bounds
    return x1 - x0, y1 - y0


def aspect(floor: shapely.Polygon) -> float:
    """The longer side of the box over the shorter."""
    return max(extents(floor)) / min(extents(floor))


def rectangular(floor: shapely.Polygon) -> bool:
    """Whether a floor fills its box."""
    return floor.area > 0.999 * floor.envelope.area


def width(floor: shapely.Polygon) -> float:
    """Side of the widest square that fits, m."""
    return 2 * float(shapely.maximum_inscribed_circle(floor, 0.02).length)


def together(floors: dict[str, shapely.Polygon], rooms: list[str]) -> bool:
    """Whether rooms hang together by shared walls."""
    known, todo = set[str](), rooms[:1]
    while todo:
        here = todo.pop()
        known.add(here)
        todo += [r for r in rooms if r not in known and touch(floors, here, r)]
    return known == set(rooms)


def drawn(count: int, kept: Path, name: str) -> Iterator[Figures]:
    """Figures of every plan, of those kept first."""
    done = kept.read_text().splitlines() if kept.exists() else []
    yield from map(json.loads, done)
    grammar = Grammar.read(name)
    with kept.open("a") as log:
        for i in range(len(done), count):
            prompt = grammar.sentence(SEED, i)
            try:
                plan, _ = planning.draw(prompt, planning.PlanSettings(processes=1), SEED, f"{i:07d}")
                row = {"prompt": prompt, **figures(plan)}
            except ApartgenError as error:
                row = {"prompt": prompt, "error": str(error)}
            log.write(json.dumps(row, default=bool) + "\n")
            log.flush()
            yield row


def pooled(rows: list[Figures], name: str) -> float:
    """Mean over rooms of all plans, or over plans."""
    values = [value for row in rows for value in (row[name] if isinstance(row[name], list) else [row[name]])]
    return float(np.mean([float(value) for value in values if value is not None] or [np.nan]))


def table(rows: list[Figures]) -> Iterator[str]:
    """Lines: flats of two, of three bedrooms, and all."""
    good = [row for row in rows if "error" not in row]
    groups = [[r for r in good if r["bedrooms"] == 2], [r for r in good if r["bedrooms"] == 3], good]
    yield f"{len(rows)} prompts, {len(good)} planned, {sum(r['faults'] > 0 for r in good)} with a fault"
    yield f"| | two bedrooms, n={len(groups[0])} | three, n={len(groups[1])} | all, n={len(good)} |\n|---|---|---|---|"
    names = [name for name in good[0] if name not in ("prompt", "widths", "facades", "bedrooms")]
    for name in names:
        yield f"| {name} | " + " | ".join(f"{pooled(g, name):.3f}" for g in groups) + " |"
    for n in range(1, 5):
        yield f"| {n} facades | " + " | ".join(f"{np.mean([r['facades'] == n for r in g]):.3f}" for g in groups) + " |"
    narrow = [[w < NARROW - 0.01 for r in g for w in r["widths"]] for g in groups]
    yield "| narrow bedrooms | " + " | ".join(f"{np.mean(found):.3f}" for found in narrow) + " |"
    for low, high in ((0, 45), (45, 60), (60, 80), (80, 110), (110, 150), (150, 400)):
        of = [r for r in good if low <= r["area"] < high]
        yield f"{low}-{high} m²: n={len(of)}" + "".join(
            f", {name} {pooled(of, name):.2f}" for name in ("living", "baths", "storage", "balconies") if of)


if __name__ == "__main__":
    logging.getLogger("apartgen").setLevel(logging.ERROR)
    warm()
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    grammar = sys.argv[3] if len(sys.argv) > 3 else str(Path(__file__).parent / "households.toml")
    print("\n".join(table(list(drawn(int(sys.argv[1]), folder / "plans.jsonl", grammar)))))
