"""Cooking: one connected run of units along a wall or round corners, a table or an island where there is floor."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors, dining, dressing, runs, storing
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.household import Household
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space

AISLE = 1.1
"""Between a run and an island, m."""


def furnish(space: Space, home: Household) -> None:
    """The run with what hangs above it, then a table or an island, small things."""
    area = space.shape.area
    table = bool(home.table) or area > 8.5 and space.wants("table", 0.55 if area > 10 else 0.4)
    run = runs.furnish(space, 5 if table else 0, bool(home.laundry))
    dressing.radiators(space, 0.3)
    if run and area > 12.5:
        space.wish("island", 0.2 if table else 0.65, lambda: _island(space, run))
    if table:
        seats = dining.seats_for(space, home.sleepers) if area > 9.5 and (home.table or area > 13) else 2
        space.need(dining.furnish(space, seats, 0.5))
    dressing.ceiling_lamps(space)
    space.wish("bin", 0.35, lambda: storing.loose(space, "bin", -0.2, ("kitchen_sink", "kitchen_base")))
    if area > 11:
        space.wish("plant", 0.12, lambda: storing.plant(space, small=True))


def _island(space: Space, run: list[int]) -> bool:
    """Across the aisle from the longest leg, its drawers to the cook, stools on the other side."""
    rng = space.rng
    walls = [space.placed.at[i] for i in run]
    leg = [i for i in run if space.placed.at[i] == max(set(walls), key=walls.count)]
    rows = [space.placed.row[i] for i in leg]
    size, stool = draw("island", rng, -0.2), draw("stool", rng, height=float(rng.choice([0.65, 0.68, 0.75])))
    at = anchors.of_object(space, leg[0]).take(rng.permutation(2)[:1])
    for width, count in ((size[1], 3), (1.4, 2), (1.1, 2), (1.1, 0)):
        size[1] = min(size[1], width)
        x = rows[0][3] / 2 + AISLE + size[0] / 2
        out = size[0] / 2 + stool[0] / 2 - 0.12
        pitch = size[1] / max(count, 1)
        seats = tuple(Part("stool", out, (k - (count - 1) / 2) * pitch, stool, np.pi, at=0)
                      for k in range(count if pitch > stool[1] + 0.08 else 2 * (count > 0)))
        behind = Zone(size[0] / 2, size[0] / 2 + 0.8 * (count > 0) + 0.1, -size[1] / 2, size[1] / 2, ("stool",))
        side = Zone(-size[0] / 2, size[0] / 2, -size[1] / 2 - 0.6, size[1] / 2 + 0.6, ("stool",))
        group = Group((Part("island", 0.0, 0.0, size, np.pi), *seats), (behind, side))
        span = sum(r[4] for r in rows)
        poses = [at.point(x, y) for y in (0.0, span / 4, -span / 4, span / 2, -span / 2)]
        for xy in poses:
            there = anchors.free(xy, at.yaw)
            if space.left >= len(group.parts) and space.put(group, there, np.zeros(1)) >= 0:
                return True
    return False
