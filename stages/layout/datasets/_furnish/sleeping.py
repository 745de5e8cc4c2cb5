"""Sleeping: beds with their nightstands, lamps, rug and bench; beds of children along walls."""

import numpy as np

from apartgen.stages.layout.datasets._furnish import anchors
from apartgen.stages.layout.datasets._furnish.group import Group, Part, Zone
from apartgen.stages.layout.datasets._furnish.sizes import draw
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.space.boxes import Array

BEDS = ("double_bed", "single_bed", "bunk_bed", "cot")
SIDE, FOOT = 0.56, 0.6
"""Floor beside a bed (HUD 1973) and before it, m."""
STANDS = ("nightstand", "table_lamp", "pouffe", "laundry_basket", "bench")


def double(space: Space, bench: bool = True) -> bool:
    """A double bed with two nightstands, one or none, at a wall with floor on both sides."""
    rng, area = space.rng, space.shape.area
    wide = [1.66, 1.7, 1.86, 1.86, 1.86, 2.06] if area > 11.5 else [1.66, 1.66, 1.7, 1.86]
    wanted = 2 if space.wants("nightstands", 0.88) else int(space.wants("nightstands", 0.95))
    first = float(rng.choice(wide))
    small = [1.66, *([1.46] if area < 11 else [])]
    less = [(w, k) for w in small for k in (2, 1, 0) if k <= wanted]
    tries = [(first, wanted), (first, wanted), (1.66, wanted), *less]
    for width, stands in tries:
        if _double(space, width, stands, bench):
            space.missed += 0.7 * (wanted - stands) + 0.3 * (width < 1.6)
            return True
    return False


def _double(space: Space, width: float, stands: int, bench: bool) -> bool:
    rng = space.rng
    bed = draw("double_bed", rng, width=width, height=float(np.clip(rng.normal(1.0, 0.12), 0.75, 1.3)))
    bed[0] = rng.choice([2.08, 2.12, 2.16, 2.2])
    parts, gap = [Part("double_bed", bed[0] / 2, 0.0, bed)], round(float(rng.uniform(0.02, 0.07)), 3)
    stand = _nightstand(space, bed)
    lamp = draw("table_lamp", rng, -0.3)
    lamp[:2] = np.minimum(lamp[:2], stand[:2].min() - 0.04)
    with_lamp = space.wants("bedside lamps", 0.6)
    for side in (1.0, -1.0)[:stands]:
        at = len(parts)
        y = side * (bed[1] / 2 + gap + stand[1] / 2)
        parts.append(Part("nightstand", stand[0] / 2 + 0.01, y, stand, at=0))
        if with_lamp:
            parts.append(Part("table_lamp", stand[0] / 2 + 0.01, y, lamp, z=float(stand[2]), at=at))
    if space.wants("rug", 0.35):
        parts.append(_rug(space, bed))
    out = bed[1] / 2
    sides = [Zone(stand[0] * 0.9, bed[0], low, high, STANDS) for low, high in ((out, out + SIDE), (-out - SIDE, -out))]
    foot = Zone(bed[0], bed[0] + FOOT, -out, out, (*STANDS, "tv_stand"))
    if bench and space.shape.area > 11 and space.wants("bench", 0.14):
        parts, foot = _benched(space, parts, bed)
    return _put(space, Group(tuple(parts), (*sides, foot)), 0.32)


def _benched(space: Space, parts: list[Part], bed: Array) -> tuple[list[Part], Zone]:
    bench = draw("bench", space.rng, -0.3, height=0.46)
    bench[1] = np.clip(bed[1] * space.rng.uniform(0.6, 0.85), 0.8, 1.6)
    bench = np.round(bench, 3)
    x = bed[0] + 0.03 + bench[0] / 2
    end = x + bench[0] / 2
    return [*parts, Part("bench", x, 0.0, bench, at=0)], Zone(bed[0], end + FOOT, -bed[1] / 2, bed[1] / 2, STANDS)


def _nightstand(space: Space, bed: Array) -> Array:
    stand = space.model("nightstand")
    stand[2] = np.clip(stand[2], 0.4, 0.6)
    return np.asarray(np.round(stand, 3))


def _rug(space: Space, bed: Array) -> Part:
    rng = space.rng
    size = np.array([rng.choice([1.2, 1.4, 1.6, 1.7]), np.clip(bed[1] + rng.choice([0.6, 0.8, 1.0]), 1.6, 3.4), 0.008])
    return Part("rug", bed[0] + rng.uniform(0.1, 0.4) - size[0] / 2, 0.0, np.round(size, 3), at=0)


def _put(space: Space, group: Group, middle: float) -> bool:
    """At a wall: rather in its middle, away from the window, where the door does not open on it."""
    at = anchors.walls(space, group, (0.02, anchors.BESIDE), 0.15)
    if not len(at):
        return False
    bed = Group(group.parts[:1])
    liking = -middle * np.minimum(anchors.off_middle(at, bed, space), 2.0)
    liking -= 1.6 * anchors.windowed(at, bed, space) + 1.0 * (at.gap > 0.1)
    liking -= 0.5 * anchors.seen_from_doors(at, 1.0, space)
    liking += 0.3 * np.minimum(anchors.to_doors(at.xy, space), 3.0)
    return space.put(group, at, liking, 0.25) >= 0


def single(space: Space, count: int, stands: float = 0.75) -> int:
    """Single beds, alike: heads at a wall or lengthwise along it; how many found a place."""
    rng = space.rng
    wide = float(rng.choice([0.96, 0.98, 1.06, 1.26] if count == 1 else [0.86, 0.96]))
    bed = draw("single_bed", rng, width=wide, height=float(rng.uniform(0.6, 1.1)))
    bed[0] = rng.choice([2.0, 2.06])
    stand = _nightstand(space, bed)
    some = 0
    for _ in range(count):
        if _single(space, "single_bed", bed, stand if rng.random() < stands else None):
            some += 1
    return some


def bunk(space: Space) -> bool:
    """A bunk bed along a wall."""
    return _single(space, "bunk_bed", draw("bunk_bed", space.rng), None)


def cot(space: Space) -> bool:
    """A cot along a wall."""
    return _single(space, "cot", draw("cot", space.rng), None)


def _single(space: Space, name: str, bed: Array, stand: Array | None) -> bool:
    rng = space.rng
    forms = ["head", "along", "along"] if rng.random() < 0.6 else ["along", "head", "along"]
    for nth, form in enumerate(forms):
        parts = [Part(name, bed[0] / 2, 0.0, bed)]
        if stand is not None and nth < 2:
            y = bed[1] / 2 + 0.04 + stand[1] / 2
            parts.append(Part("nightstand", stand[0] / 2 + 0.01, y, stand, at=0))
        far = bed[1] / 2 + 0.55
        zones: tuple[Zone, ...] = (Zone(0.6, bed[0], bed[1] / 2, far, STANDS),)
        group = Group(tuple(parts), zones)
        if form == "along":
            group = _lengthwise(group, bed)
        at = anchors.walls(space, group, (0.02, anchors.BESIDE))
        if form == "along" and len(parts) > 1:  # its nightstand stands at the wall behind the head
            at = at.take(np.where(at.flip > 0, at.s, space.shape.length[at.side] - at.s) < 0.06)
        if not len(at):
            continue
        liking = 0.9 * anchors.cornered(at, group, space) - 0.5 * anchors.windowed(at, group, space)
        liking += 0.25 * np.minimum(anchors.to_doors(at.xy, space), 3.0) - 0.6 * (at.gap > 0.1)
        if space.put(group, at, liking, 0.3) >= 0:
            return True
    return False


def _lengthwise(group: Group, bed: Array) -> Group:
    """Turned so that the bed's right side is at the wall; its left is where one gets in."""
    off = bed[1] / 2
    parts = tuple(Part(p.name, p.y + off, -p.x, p.size, p.yaw - np.pi / 2, p.z, p.at) for p in group.parts)
    zones = tuple(Zone(z.y0 + off, z.y1 + off, -z.x1, -z.x0, z.friends) for z in group.zones)
    return Group(parts, zones)


def tv_before_bed(space: Space) -> bool:
    """A television across from the bed, on a stand or a chest, as near to the bed's axis as the wall allows."""
    rng = space.rng
    bed = space.placed.row[space.find("double_bed")[0]]
    for name in ("tv_stand", "chest") if rng.random() < 0.7 else ("chest", "tv_stand"):
        stand = draw(name, rng, -0.6)
        tv = draw("tv", rng, width=float(np.clip(stand[1] * 0.75, 0.72, 1.25)))
        tv[2] = round(float(np.clip(tv[1] * 0.6, 0.43, 0.8)), 3)
        if tv[1] > stand[1] - 0.02:
            continue
        screen = Part("tv", stand[0] / 2, 0.0, tv, z=float(stand[2]), at=0)
        group = Group((Part(name, stand[0] / 2, 0.0, stand), screen),
                      (Zone(stand[0], stand[0] + 0.55, -stand[1] / 2, stand[1] / 2, ("bench",)),))
        at = anchors.walls(space, group, (0.006, anchors.BESIDE), 0.1)
        off = at.point(stand[0] / 2, 0.0) - bed[:2]
        ahead, aside = off @ bed[6:8], np.abs(off @ np.array([-bed[7], bed[6]]))
        faces = np.stack([np.cos(at.yaw), np.sin(at.yaw)], -1) @ bed[6:8]
        at, aside = at.take(good := (ahead > 1.0) & (faces < -0.9) & (aside < 0.5 * ahead)), aside[good]
        if len(at) and space.put(group, at, -aside, 0.1) >= 0:
            return True
    return False
