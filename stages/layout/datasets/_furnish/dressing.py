"""What rooms wear: radiators below windows, curtains before them, lamps at the ceiling, things on walls."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Poses, Zone
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import TABLE

LOW = tuple(name for name, kind in TABLE.items() if kind.place == "floor" and kind.size[2] < 1.0 and name != "island")
"""What may stand below what hangs on walls."""


def radiators(space: Space, chance: float) -> None:
    """Below the windows that have a sill; one at another wall where none has, now and then."""
    if not space.wants("radiators", chance):
        return
    size = draw("radiator", space.rng)
    for w in space.shape.windows:
        if w[5] < 0.55 or space.left < 4:
            continue
        low = size.copy()
        low[2] = round(float(min(low[2], w[5] - 0.2)), 3)
        low[1] = round(float(np.clip(2 * w[4] * 0.85, 0.4, 1.6)), 3)
        if low[2] >= 0.4:
            z = 0.17 if w[5] > 0.75 else 0.05
            _at_window(space, w, Part("radiator", low[0] / 2 + 0.02, 0.0, low, z=z))


def curtains(space: Space, chance: float) -> None:
    """All windows of a room alike: down to the floor, or short where something stands below."""
    rng, shape = space.rng, space.shape
    if not space.wants("curtains", chance):
        return
    depth, over = round(float(rng.uniform(0.08, 0.12)), 3), float(rng.choice([0.1, 0.15, 0.2]))
    top = round(min(2.58, shape.height - 0.05, max([2.3, *(w[6] + 0.15 for w in shape.windows)])), 3)
    for w in shape.windows:
        for low in (0.03, max(0.5, w[5] - 0.15), w[5] + 0.02):
            height = round(min(top - low, 2.6), 3)
            for beyond in (over, 0.05, 0.0):
                size = np.array([depth, np.clip(2 * (w[4] + beyond), 0.6, 3.6), height])
                part = Part("curtain", depth / 2 + 0.005, 0.0, np.round(size, 3), z=low)
                if height >= 1.2 and _at_window(space, w, part):
                    break
            else:
                continue
            break


def _at_window(space: Space, w: Array, part: Part) -> bool:
    yaw = np.arctan2(w[3], w[2])
    at = anchors.free(w[None, :2], np.array([yaw]))
    at = Poses(at.xy, at.yaw, at.flip, np.array([int(w[7])]), at.s, at.gap)
    return space.put(Group((part,)), at, np.zeros(1)) >= 0


def ceiling_lamps(space: Space, chance: float = 0.92) -> None:
    """One above the middle of what the room is for, none where a table has its own and the room is small."""
    rng, shape = space.rng, space.shape
    if not space.wants("ceiling lamp", chance):
        return
    over = space.find("coffee_table", "double_bed")
    if space.has("ceiling_lamp") and not over:
        return
    size = draw("ceiling_lamp", rng, -0.3 if shape.area < 8 else None)
    size[2] = round(float(np.clip(size[2], 0.08, max(0.1, shape.height - 2.1))), 3)
    points = [space.placed.row[i][:2] for i in over[:1] if rng.random() < 0.5]
    best = np.unravel_index(int(np.argmax(np.minimum(shape.clear, 2.5))), shape.clear.shape)
    inside = shape.grid[shape.clear > 0.3]
    middle = inside.mean(0) if len(inside) else shape.grid[best]
    points += [middle, shape.grid[best]]
    z = round(shape.height - float(size[2]), 4)
    k = int(shape.length.argmax())
    yaw = float(np.arctan2(shape.along[k, 1], shape.along[k, 0]))
    lamp = Group((Part("ceiling_lamp", 0.0, 0.0, size, z=z),))
    any(space.put(lamp, anchors.free(point, np.array([yaw])), np.zeros(1)) >= 0 for point in points)


def shelf_above(space: Space, name: str) -> bool:
    """A shelf on the wall above something low that stands at one."""
    some = [i for i in space.find(name) if str(space.placed.at[i]).startswith("wall")]
    if not some:
        return False
    i = some[0]
    row = space.placed.row[i]
    size = draw("wall_shelf", space.rng, -0.2)
    size[1] = round(float(min(size[1], row[4] * 0.9)), 3) if row[4] > 0.5 else size[1]
    z = round(max(1.45, float(row[2] + row[5] / 2) + 0.45), 3)
    at = anchors.of_object(space, i).take(np.array([0]))
    gap = _gap(space, at, float(row[3]))
    part = Part("wall_shelf", -row[3] / 2 - gap + size[0] / 2 + 0.003, 0.0, size, z=z)
    return gap < 0.3 and z + size[2] < space.shape.height and _hung(space, Group((part,)), at, i)


def _gap(space: Space, at: Poses, depth: float) -> float:
    behind = Poses(at.xy, at.yaw + np.pi, at.flip, at.side, at.s, at.gap)
    return float(anchors.facing(behind, space)[0]) - depth / 2


def _hung(space: Space, group: Group, at: Poses, i: int) -> bool:
    k = space.put(group, at, np.zeros(len(at)))
    if k >= 0:
        space.placed.at[k] = i
    return k >= 0


def on_wall(
    space: Space, name: str, near: tuple[str, ...] = (), lean: float | None = None, corner: float = 0.0
) -> bool:
    """Something on a free stretch of wall, near what it is for."""
    size = draw(name, space.rng, lean)
    z = min(TABLE[name].z, space.shape.height - float(size[2]) - 0.1)
    before = Zone(0.02, size[0] + 0.4, -size[1] / 2, size[1] / 2, LOW)
    group = Group((Part(name, size[0] / 2 + 0.003, 0.0, size, z=round(z, 3)),), (before,))
    at = anchors.walls(space, group, (0.0,))
    if not len(at):
        return False
    liking = corner * anchors.cornered(at, group, space) - 3.0 * anchors.windowed(at, group, space)
    if near:
        liking -= 0.8 * np.minimum(anchors.to_things(at.xy, space, *near), 3.0)
    return space.put(group, at, liking, 0.3) >= 0
