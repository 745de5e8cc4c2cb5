"""R_acoll: articulated objects whose moving parts meet something (Eq. 11)."""

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._pairs import Rule, standing_in
from apartgen.stages.metrics._shares import shares, solid
from apartgen.stages.space import boxes, polygons, sweeps
from apartgen.stages.space.boxes import TOLERANCE, Boxes, Mask

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
    rules = {"ours": Rule(TOLERANCE, False), "published": Rule(TOLERANCE, True), "strict": Rule(STRICT, True)}
    hits = standing_in(things, swept, rules)
    hits |= standing_in(things, sweeps.published(things), {"physcene": Rule(TOLERANCE, True)})
    hits["with_walls"] = hits["ours"] | _meets_shell(home, things, swept)
    chosen = [o for o, moves in zip(things, moving, strict=True) if moves]
    return [v for version, hit in hits.items() for v in shares(home, "R_acoll", version, hit[moving], chosen)]


def _meets_shell(home: Plan, things: list[Box], swept: Boxes) -> Mask:
    """Which swept volumes leave their room's floor or meet the sweep of a room door by more than 1 cm, (n,)."""
    floors = polygons.floors(home)
    doors = [area.buffer(-TOLERANCE) for area in sweeps.door_swings(home).values()]
    met = []
    for o, area in zip(things, boxes.footprints(swept), strict=True):
        kept = floors[o.room].buffer(TOLERANCE, join_style="mitre").covers(area)
        met.append(not kept or any(door.intersects(area) for door in doors))
    return np.array(met, bool)
