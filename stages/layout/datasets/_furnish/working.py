"""Working: desk, chair, monitor and lamp as one; dressing tables; corners to read in."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone, turned
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array

ROOM = 0.95
"""Before a desk, its chair included, m."""


def desk(space: Space, monitor: float = 0.6, lamp: float = 0.5, small: bool = False) -> bool:
    """A desk at a wall or window, rather beside the window than far from it, with its chair drawn up."""
    rng = space.rng
    name = "office_chair" if rng.random() < 0.85 and not space.has("chair") else "chair"
    chair = space.model(name)
    for lean in (-0.8 if small else 0.0, -0.8, -1.0):
        top = draw("desk", rng, lean)
        group = _desk(space, top, name, chair, monitor, lamp)
        at = anchors.walls(space, group, (0.01, anchors.BESIDE))
        if not len(at):
            continue
        liking = -0.5 * np.minimum(anchors.to_windows(at.xy, space), 3.0) - 0.4 * (at.gap > 0.1)
        liking += 0.25 * np.minimum(anchors.to_doors(at.xy, space), 2.5) + 0.4 * anchors.cornered(at, group, space)
        if space.put(group, at, liking, 0.35) >= 0:
            return True
    return False


def _desk(space: Space, top: Array, name: str, chair: Array, monitor: float, lamp: float) -> Group:
    rng = space.rng
    aside = round(float(rng.uniform(-0.12, 0.12)), 3) * (top[1] > 1.1)
    turn = np.pi + rng.normal(0, 0.06) * (rng.random() < 0.3)
    seat = Part(name, top[0] + chair[0] * rng.uniform(0.15, 0.35), aside, chair, turn, at=0)
    parts = [Part("desk", top[0] / 2, 0.0, top), seat]
    if rng.random() < monitor and space.left > 4:
        screen = draw("monitor", rng)
        parts.append(Part("monitor", screen[0] / 2 + 0.06, aside, screen, z=float(top[2]), at=0))
    if rng.random() < lamp and space.left > 4:
        light = draw("table_lamp", rng, -0.5)
        y = rng.choice([-1.0, 1.0]) * (top[1] / 2 - light[1] / 2 - 0.04)
        wide = max((p.size[1] / 2 + abs(p.y) for p in parts if p.name == "monitor"), default=0.0)
        if abs(y) - light[1] / 2 > wide + 0.02:
            parts.append(Part("table_lamp", light[0] / 2 + 0.06, y, light, z=float(top[2]), at=0))
    front = Zone(top[0], top[0] + ROOM, -0.4, 0.4, ("bin",))
    return Group(tuple(parts), (front,))


def dressing_table(space: Space) -> bool:
    """A dressing table, a stool before it, a mirror above."""
    rng = space.rng
    table = draw("dressing_table", rng, -0.4)
    table[2] = round(float(rng.uniform(0.72, 0.8)), 3)
    stool = draw("stool", rng, height=float(rng.uniform(0.43, 0.5)))
    mirror = draw("mirror", rng, -0.2)
    mirror[1] = min(mirror[1], table[1])
    group = Group((Part("dressing_table", table[0] / 2, 0.0, table),
                   Part("stool", table[0] + stool[0] * 0.15, 0.0, stool, np.pi, at=0),
                   Part("mirror", mirror[0] / 2 + 0.002, 0.0, mirror, z=float(table[2]) + 0.1, at=0)),
                  (Zone(table[0], table[0] + 0.7, -table[1] / 2, table[1] / 2),))
    at = anchors.walls(space, group, (0.006,))
    return len(at) > 0 and space.put(group, at, -0.3 * anchors.to_windows(at.xy, space)) >= 0


def reading(space: Space) -> bool:
    """An armchair by the window, a lamp or a small table beside it."""
    rng = space.rng
    chair, turn = space.model("armchair"), float(rng.choice([0.0, 0.0, 0.4, -0.4]))
    deep, half = turned(chair, turn)
    parts = [Part("armchair", deep + 0.05, 0.0, chair, turn)]
    edge = half + 0.06
    if rng.random() < 0.75:
        lamp = draw("floor_lamp", rng)
        parts.append(Part("floor_lamp", lamp[0] / 2 + 0.03, edge + lamp[1] / 2, lamp, at=0))
    if rng.random() < 0.6 or len(parts) == 1:
        side = draw("side_table", rng)
        parts.append(Part("side_table", side[0] / 2 + 0.15, -edge - side[1] / 2, side, at=0))
    group = Group(tuple(parts), (Zone(2 * deep + 0.05, 2 * deep + 0.6, -half, half),))
    at = anchors.walls(space, group, (0.03, anchors.BESIDE))
    if not len(at):
        return False
    liking = -0.5 * np.minimum(anchors.to_windows(at.xy, space), 3.0) + 0.3 * anchors.cornered(at, group, space)
    return space.put(group, at, liking, 0.3) >= 0
