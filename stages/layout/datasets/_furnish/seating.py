"""Living: sofa, coffee table and television on one axis; armchairs, side tables, lamp and rug about them."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Poses, Zone, joined, turned
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.things.categories import CATEGORIES

LEAST_VIEW, MOST_VIEW, VIEW = 1.45, 3.6, 2.15
"""From the sofa's front to the television's stand, m: least, most, liked."""
FAR_VIEW = 2.7
"""Where all places at walls are further, a sofa now and then stands free."""
BEHIND = 0.62
"""Way behind a sofa that stands free, m."""
SOFAS = ("sofa", "corner_sofa")
ALL = frozenset(CATEGORIES)
IN_FRONT = ("coffee_table", "pouffe", "side_table")


def furnish(space: Space, aside: bool) -> bool:
    """A conversation group, rather at an end of the room (`aside`) than in its middle; whether one found a place."""
    rng, area = space.rng, space.shape.area
    tv = space.wants("tv", 0.87)
    if not space.wish("tv", 0.87, lambda: _with_tv(space, aside)):
        space.need(not tv)
        if not _without_tv(space, aside, not tv and rng.random() < 0.6):
            return False
    if space.has("coffee_table"):
        space.wish("armchair", 0.68 if area > 12 else 0.3, lambda: _armchairs(space, 1 + space.wants("two", 0.55)))
    return True


def complete(space: Space) -> None:
    """What stands about a conversation group: side tables, a lamp, a pouffe, something beside the television."""
    if not space.has(*SOFAS):
        return
    space.wish("side_table", 0.64, lambda: _side_tables(space))
    space.wish("floor_lamp", 0.34, lambda: _lamp(space))
    if space.has("coffee_table"):
        space.wish("pouffe", 0.28, lambda: _pouffe(space))
    if space.has("tv_stand"):
        space.wish("shelves", 0.24 if space.shape.area > 15 else 0.1, lambda: _flank(space))


def _sofa(space: Space, small: bool) -> tuple[str, Array]:
    rng, area = space.rng, space.shape.area
    if not small and area > 17 and space.wants("corner sofa", 0.5) and rng.random() < 0.6:
        return "corner_sofa", draw("corner_sofa", rng, -0.3)
    lean = -0.7 if small or area < 12 else -0.1 if area < 16 else 0.45
    return "sofa", draw("sofa", rng, lean + 0.2 * rng.normal())


def _table(space: Space, sofa: Array, small: bool) -> Array:
    size = draw("coffee_table", space.rng, -0.7 if small else float(space.rng.normal(0.15, 0.4)))
    size[1] = np.clip(sofa[1] * space.rng.uniform(0.48, 0.66), 0.6, 1.4 if not small else 0.9)
    return np.asarray(np.round(size, 3))


def _core(space: Space, small: bool) -> Group:
    """Sofa and coffee table, rug under them; the frame's x axis is where one looks."""
    rng = space.rng
    name, sofa = _sofa(space, small)
    table = _table(space, sofa, small)
    gap = round(float(np.clip(rng.normal(0.36, 0.05), 0.28, 0.5)), 3)
    aside = round(float(rng.normal(0, 0.05)), 3) if rng.random() < 0.5 else 0.0
    parts = [Part(name, sofa[0] / 2, 0.0, sofa),
             Part("coffee_table", sofa[0] + gap + table[0] / 2, aside, table, at=0)]
    if rng.random() < 0.62:
        parts.append(_rug(space, sofa, gap + table[0]))
    bed = Zone(sofa[0], sofa[0] + 1.3, -0.35 * sofa[1], 0.35 * sofa[1], ALL - {"double_bed", "single_bed"}, False)
    zone = Zone(sofa[0], sofa[0] + gap + table[0] + 0.25, -0.4 * sofa[1], 0.4 * sofa[1], ("pouffe",))
    return Group(tuple(parts), (zone, bed))


def _rug(space: Space, sofa: Array, beyond: float) -> Part:
    rng = space.rng
    under = min(0.3, sofa[0] / 3)
    depth = float(np.clip(under + beyond + rng.uniform(0.15, 0.4), 1.2, 2.6))
    size = np.array([depth, np.clip(sofa[1] + rng.uniform(-0.3, 0.5), 1.5, 3.4), rng.choice([0.006, 0.008])])
    return Part("rug", sofa[0] - under + depth / 2, 0.0, np.round(size, 3), at=1)


def _stand(space: Space, small: bool) -> tuple[Array, Array]:
    """A stand and the television on it."""
    rng = space.rng
    stand = draw("tv_stand", rng, -0.7 if small else 0.5)
    tv = draw("tv", rng, width=float(np.clip(stand[1] * rng.uniform(0.62, 0.85), 0.73, 1.6)))
    tv[2] = round(float(np.clip(tv[1] * 0.6, 0.45, 1.0)), 3)
    return stand, tv


def _with_tv(space: Space, to_end: bool) -> bool:
    for small in (False, False, False, True, True, True):
        core = _core(space, small)
        if small and space.rng.random() < 0.5:
            core = _bare(core)
        stand, tv = _stand(space, small)
        sofa = core.parts[0].size
        at = _looking(space, core, float(sofa[0]), float(stand[0]))
        if not len(at):
            continue
        far = anchors.facing(at, space) - anchors.OFF
        aside = np.clip(space.rng.laplace(0, 0.14, len(at)), -0.32, 0.32)
        aside = np.where(np.abs(aside) < 0.03, 0.0, aside)
        x, n = far - stand[0] / 2, len(core.parts)
        front = sofa[0] + 0.9
        view = Zone(front, far - stand[0] - 0.02, -0.35, 0.35, ("pouffe",))
        before = Zone(far - stand[0] - 0.6, far - stand[0], aside - stand[1] / 2, aside + stand[1] / 2)
        whole = Group((*core.parts, Part("tv_stand", x, aside, stand, np.pi, at=0),
                       Part("tv", x, aside, tv, np.pi, float(stand[2]), at=n)), (*core.zones, view, before))
        if space.put(whole, at, _liking(space, at, core, far, float(stand[0]), to_end), 0.35) >= 0:
            return True
    return False


def _looking(space: Space, core: Group, sofa: float, stand: float) -> Poses:
    """Places from which a wall across is seen from a fit distance: at walls, and free before a wall too far off."""
    at = anchors.walls(space, Group(core.parts[:1]), (0.02, 0.05, anchors.BESIDE))
    if not len(at):
        return at
    across = anchors.facing(at, space)
    view = across - sofa - stand
    straight = _square(space, at, across)
    near = at.take((view > LEAST_VIEW) & (view < MOST_VIEW) & straight)
    far = len(near) and float(view[(view > LEAST_VIEW) & (view < MOST_VIEW) & straight].min()) > FAR_VIEW
    if len(near) and space.rng.random() < (0.6 if far else 0.95):
        return near
    off = view - np.clip(space.rng.normal(2.15, 0.2, len(at)), 1.7, 2.6)
    keep = (off > BEHIND) & straight & (at.gap < 0.03)
    shift = np.where(keep, off, 0.0)[:, None] * np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1)
    floating = Poses(at.xy + shift, at.yaw, at.flip, np.full(len(at), -1), at.s, at.gap + off).take(keep)
    return joined(near, floating) if len(near) and space.rng.random() < 0.5 else floating if len(floating) else near


def _square(space: Space, at: Poses, across: Array) -> Mask:
    """Whether the wall across is parallel: as far off on both sides of the axis."""
    shape = space.shape
    hit = at.xy + across[:, None] * np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1)
    off = ((hit[:, None] - shape.start) * shape.normal).sum(-1)
    along = ((hit[:, None] - shape.start) * shape.along).sum(-1)
    heading = np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1) @ shape.normal.T
    good = (np.abs(off) < 0.01) & (along > -0.01) & (along < shape.length + 0.01) & (heading < -0.999)
    return np.asarray(good.any(1))


def _liking(space: Space, at: Poses, core: Group, far: Array, stand: float, to_end: bool) -> Array:
    sofa = core.parts[0].size
    view = far - sofa[0] - stand
    liking = -1.4 * np.abs(view - VIEW) - 0.7 * ((at.gap > 0.1) & (at.gap < 0.5)) - 0.6 * (at.gap > 0.5)
    liking -= 0.5 * anchors.seen_from_doors(at, 1.0, space)
    liking += 0.25 * np.minimum(anchors.to_doors(at.point(1.2, 0.0), space), 3.0)
    wall = at.side >= 0
    if wall.any():
        seated = Group(core.parts[:1])
        liking[wall] += (0.5 if to_end else -0.25) * np.minimum(anchors.off_middle(at.take(wall), seated, space), 1.5)
        liking[wall] -= 0.7 * anchors.windowed(at.take(wall), seated, space)
    if space.wants("tv", 0.87):
        across = at.point(far - 0.2, 0.0)
        for w in space.shape.windows:
            off = across - w[:2]
            ahead, aside = np.abs(off @ w[2:4]), np.abs(off @ np.array([-w[3], w[2]]))
            liking -= 0.7 * ((ahead < 0.5) & (aside < w[4] + 0.4))
    return np.asarray(liking)


def _bare(core: Group) -> Group:
    """Without the rug."""
    return Group(tuple(p for p in core.parts if p.name != "rug"), core.zones)


def _without_tv(space: Space, to_end: bool, opposite: bool) -> bool:
    """A group that talks: sofa and table, across from it another sofa or two armchairs where asked for."""
    for small in (False, False, True, True):
        core = _core(space, small)
        sofa, table = core.parts[0].size, core.parts[1]
        for across in ((True, False) if opposite and not small else (False,)):
            group = _bare(core) if small else core
            if across:
                group = group.with_part(*_across(space, sofa, table))
            zone = Zone(sofa[0], sofa[0] + 1.2, -0.42 * sofa[1], 0.42 * sofa[1], (*IN_FRONT, "armchair"))
            group = Group(group.parts, (*group.zones, zone)) if not across else group
            at = anchors.walls(space, Group(group.parts[:1]), (0.02, 0.05, anchors.BESIDE))
            if not len(at):
                continue
            far = anchors.facing(at, space)
            at, far = at.take(far > 2.0), far[far > 2.0]
            if len(at) and space.put(group, at, _liking(space, at, core, np.minimum(far, 3.0), 0.4, to_end)) >= 0:
                return True
    sofa = draw("sofa", space.rng, -0.9)
    alone = Group((Part("sofa", sofa[0] / 2, 0.0, sofa),), (Zone(sofa[0], sofa[0] + 0.7, -sofa[1] / 2, sofa[1] / 2),))
    at = anchors.walls(space, alone, (0.02, anchors.BESIDE))
    return len(at) > 0 and space.put(alone, at, 0.2 * anchors.facing(at, space)) >= 0


def _across(space: Space, sofa: Array, table: Part) -> list[Part]:
    rng = space.rng
    edge = float(table.x) + table.size[0] / 2 + rng.uniform(0.32, 0.42)
    if rng.random() < 0.45:
        return [Part("sofa", edge + sofa[0] / 2, 0.0, sofa if sofa[0] < 1.3 else draw("sofa", rng, 0.0), np.pi, at=1)]
    chair = space.model("armchair")
    off = chair[1] / 2 + rng.uniform(0.08, 0.3)
    return [Part("armchair", edge + chair[0] / 2, side * off, chair, np.pi, at=1) for side in (1.0, -1.0)]


def _side_tables(space: Space) -> bool:
    """At the ends of the sofa, alike, or at one; lamps on them."""
    rng = space.rng
    k = space.find(*SOFAS)[0]
    size, at = space.placed.row[k][3:6], anchors.of_object(space, k)
    side, small = space.model("side_table"), draw("table_lamp", rng, -0.3)
    with_lamp = space.wants("table lamp", 0.5)
    small[:2] = np.minimum(small[:2], side[:2].min() - 0.04)
    x = -size[0] / 2 + max(side[0] / 2, min(size[0], 0.9) * rng.uniform(0.35, 0.55))
    for both in ((1.0, -1.0), (1.0,)) if space.wants("two side tables", 0.5) else ((1.0,),):
        parts: list[Part] = []
        for sign in both:
            y = sign * (size[1] / 2 + 0.05 + side[1] / 2)
            parts.append(Part("side_table", x, y, side))
            if with_lamp:
                parts.append(Part("table_lamp", x, y, small, z=float(side[2]), at=len(parts) - 1))
        if _beside(space, Group(tuple(parts)), at, k) >= 0:
            return True
    return False


def _lamp(space: Space) -> bool:
    """A floor lamp at the sofa's end or beside an armchair."""
    rng, lamp = space.rng, draw("floor_lamp", space.rng)
    for k in (space.find(*SOFAS)[0], *space.find("armchair")):
        size, at = space.placed.row[k][3:6], anchors.of_object(space, k)
        x = -size[0] / 2 + lamp[0] / 2 + rng.uniform(0.0, 0.15)
        part = Part("floor_lamp", x, size[1] / 2 + rng.uniform(0.05, 0.12) + lamp[1] / 2, lamp)
        if _beside(space, Group((part,)), at, k) >= 0:
            return True
    return False


def _flank(space: Space) -> bool:
    """On both sides of the television two shelves, cabinets or plants, alike."""
    rng, k = space.rng, space.find("tv_stand")[0]
    stand = space.placed.row[k][3:6]
    for name in rng.permutation(["bookshelf", "bookshelf", "display_cabinet", "plant"]):
        size = draw(str(name), rng, -0.5)
        size[2] = min(size[2], space.shape.height - 0.05)
        x = (size[0] - stand[0]) / 2 + (0.04 if name == "plant" else 0.0)
        y = (stand[1] + size[1]) / 2 + (0.1 if name == "plant" else rng.choice([0.01, 0.01, 0.12]))
        before = [Zone(x + size[0] / 2, x + size[0] / 2 + 0.5, s * y - size[1] / 2, s * y + size[1] / 2)
                  for s in (1.0, -1.0) if name != "plant"]
        group = Group(tuple(Part(str(name), x, s * y, size) for s in (1.0, -1.0)), tuple(before))
        if _beside(space, group, anchors.of_object(space, k).take(np.array([0])), k) >= 0:
            return True
    return False


def _beside(space: Space, group: Group, at: Poses, k: int) -> int:
    """Put a group in the frame of object `k`, which is what it stands at."""
    i = space.put(group, at, np.zeros(len(at)))
    for j in range(i, space.n) if i >= 0 else ():
        if space.placed.at[j] == "free":
            space.placed.at[j] = k
    return i


def _armchairs(space: Space, count: int) -> bool:
    """Beside the coffee table, turned to it: two face each other, or one alone."""
    rng = space.rng
    table, sofa = space.find("coffee_table")[0], space.find(*SOFAS)[0]
    size, chair = space.placed.row[table][3:6], space.model("armchair")
    at = anchors.of_object(space, table)
    seat = 0.4 * space.placed.row[sofa][4] + 0.02
    for turn in (rng.choice([0.0, 0.0, 0.35, 0.5]), 0.0):
        for n in range(count, 0, -1):
            for ahead in (rng.uniform(0.0, 0.2), 0.35):
                half, wide = turned(chair, turn)
                y = max(size[1] / 2 + rng.uniform(0.28, 0.42), seat) + half
                parts = [Part("armchair", ahead, sign * y, chair, -sign * (np.pi / 2 + turn)) for sign in (1.0, -1.0)]
                inner = y - half
                zones = [Zone(ahead - wide, ahead + wide, low, high, ("coffee_table", "pouffe", *SOFAS))
                         for low, high in ((inner - 0.22, inner), (-inner, 0.22 - inner))]
                if _beside(space, Group(tuple(parts[:n]), tuple(zones[:n])), at, table) >= 0:
                    return True
    return False


def _pouffe(space: Space) -> bool:
    rng = space.rng
    table = space.find("coffee_table")[0]
    size, pouffe = space.placed.row[table][3:6], draw("pouffe", rng)
    at = anchors.of_object(space, table)
    x = size[0] / 2 + rng.uniform(0.12, 0.3) + pouffe[0] / 2
    for y in (rng.uniform(0, size[1] / 2), 0.0):
        if _beside(space, Group((Part("pouffe", x, y, pouffe),)), at, table) >= 0:
            return True
    return False
