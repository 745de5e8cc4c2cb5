"""R_acoll: articulated objects whose moving parts meet something (Eq. 11)."""

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._shares import shares, solid
from apartgen.stages.space import boxes, polygons, sweeps
from apartgen.stages.space.boxes import TOLERANCE, Boxes, Mask
from apartgen.stages.things import categories

NEEDS = Layout
STRICT = 1e-6
"""Depth above which boxes that merely touch do not count, m."""


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions, each the share of articulated objects whose b' meets another's b':

    published: by the assets' joints, all pairs, deeper than 1 cm · strict: the same, deeper than 0 ·
    physcene: boxes grown by a third of their depth, 1 cm · ours: 1 cm, without pairs that belong together ·
    with_walls: ours, and b' must also clear walls and the sweep of room doors.
    """
    things = solid(home)
    moving = sweeps.articulated(things)
    swept = sweeps.extended(things)
    depth, apart = boxes.penetration(swept), ~_together(things)
    ours = (depth > TOLERANCE) & apart
    versions = {
        "ours": ours,
        "published": depth > TOLERANCE,
        "strict": depth > STRICT,
        "physcene": boxes.penetration(sweeps.published(things)) > TOLERANCE,
    }
    hits: dict[str, Mask] = {version: np.asarray(pairs.any(-1)) for version, pairs in versions.items()}
    hits["with_walls"] = hits["ours"] | _meets_shell(home, things, swept)
    chosen = [o for o, moves in zip(things, moving, strict=True) if moves]
    return [v for version, hit in hits.items() for v in shares(home, "R_acoll", version, hit[moving], chosen)]


def _together(things: list[Box]) -> Mask:
    """Pairs whose contact is part of their use, (n, n)."""
    pairs = [[categories.belong_together(a.category, b.category) for b in things] for a in things]
    return np.array(pairs, bool).reshape(len(things), len(things))


def _meets_shell(home: Plan, things: list[Box], swept: Boxes) -> Mask:
    """Which swept volumes leave their room's floor or meet the sweep of a room door by more than 1 cm, (n,)."""
    floors = polygons.floors(home)
    doors = [area.buffer(-TOLERANCE) for area in sweeps.door_swings(home).values()]
    met = []
    for o, area in zip(things, boxes.footprints(swept), strict=True):
        kept = floors[o.room].buffer(TOLERANCE, join_style="mitre").covers(area)
        met.append(not kept or any(door.intersects(area) for door in doors))
    return np.array(met, bool)
