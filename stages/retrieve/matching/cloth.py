"""Curtains clear of what stands under and beside their windows: they end above it, or their rail ends before it.

A layout lets all things stand in a curtain, since cloth gives way; it does not go through a headboard all the same.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from shapely.geometry import LineString, Point

from apartgen.schemas.plan import Opening, Plan
from apartgen.schemas.retrieve import AssetKey, Furnishing
from apartgen.stages.retrieve.matching.embedded import Embedded, millimetres
from apartgen.stages.things.asset import Array, Asset
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.solids import corners

CURTAIN = "curtain"
APART = 0.02
"""Between cloth and what it ends at, m."""
MET = 0.004
"""Cloth is in what it enters deeper than this, m."""
BELOW = 0.10
"""So far below the sill a curtain ends that does not reach to the floor, m."""
COVERED = 0.75
"""A window keeps so much of its width behind its curtain."""
FRINGE = 0.15
"""Leaves and fronds give way by this share of what is seen, on each side."""
SHORTER, GLASS, NARROWER, UNCOVERED = 0.1, 2.0, 0.5, 3.0
"""What it costs that a curtain ends above the floor, and by the m above the sill, at a side, within its window."""


class Cut(NamedTuple):
    """Where the cloth ends in its curtain's frame, m: below, on its right and on its left."""

    low: float
    right: float
    left: float


class Window(NamedTuple):
    """What a curtain hangs before, in its frame: the sill, and where the window begins and ends."""

    sill: float
    right: float
    left: float


def clear(
    objects: Sequence[Furnishing], plan: Plan, assets: Mapping[str, Asset], made: Embedded
) -> list[Furnishing]:
    """The objects, with curtains shorter or narrower where something stands in them; those of one length in a room stay
    of one length. What can be neither, and what is of another library, stays as it is.
    """
    cuts = {o.id: cut for o in objects if o.category == CURTAIN and (cut := _cut(o, objects, plan, assets, made))}
    cuts |= _alike([o for o in objects if o.category == CURTAIN], cuts)
    return [_remade(o, cuts[o.id], assets[o.id], made) if o.id in cuts else o for o in objects]


def _cut(o: Furnishing, objects: Sequence[Furnishing], plan: Plan, assets: Mapping[str, Asset], made: Embedded,
         ) -> Cut | None:
    """Where the cloth ends that costs least and is clear; None for where it ends already, and where it has to stay."""
    window = _window(o, plan)
    if window is None or made.design(CURTAIN, o.asset.id) is None:
        return None
    whole = _whole(o, window)
    solid = _solid(o, whole, [other for other in objects if other.room == o.room], assets)
    panels = _panels(assets[o.id])
    if whole == _own(o) and not _enters(o, panels, whole, solid):
        return None
    fits = [cut for cut in _cuts(o, whole, window, solid) if not _enters(o, panels, cut, solid)]
    return min(fits, key=lambda cut: (round(_cost(cut, whole, window), 6), cut), default=None)


def _own(o: Furnishing) -> Cut:
    return Cut(-o.size[2] / 2, -o.size[1] / 2, o.size[1] / 2)


def _whole(o: Furnishing, window: Window) -> Cut:
    """Where the cloth ends if nothing is in its way: no curtain leaves the lower end of its window bare."""
    own, tallest = _own(o), o.size[2] / 2 - TABLE[CURTAIN].max[2]
    return own._replace(low=max(window.sill - BELOW, tallest)) if own.low > window.sill + MET else own


def _window(o: Furnishing, plan: Plan) -> Window | None:
    """The nearest window of the room."""
    def off(opening: Opening) -> float:
        return float(LineString(opening.segment).distance(Point(o.center[:2])))

    own = [opening for opening in plan.openings if opening.kind == "window" and o.room in opening.rooms]
    if not own:
        return None
    nearest = min(own, key=off)
    across = np.array([-np.sin(o.yaw), np.cos(o.yaw)])
    ends = sorted(((np.asarray(nearest.segment, float) - o.center[:2]) @ across).tolist())
    return Window(nearest.sill - o.center[2], *ends)


def _panels(asset: Asset) -> Array:
    """Bounds (n, 2, 3) of the cloth in shares of the box, from its middle."""
    tall = [mesh.vertices for link in asset.links for mesh in link.visuals
            if np.ptp(mesh.vertices[:, 2]) > asset.size[2] / 2]
    return np.array([[p.min(0), p.max(0)] for p in tall]).reshape(-1, 2, 3) / asset.size


def _solid(o: Furnishing, whole: Cut, others: Sequence[Furnishing], assets: Mapping[str, Asset]) -> Array:
    """Bounds (n, 2, 3) in the curtain's frame of all that is in its box, were it `whole`."""
    seen = [_seen_from(o, other, _pieces(assets[other.id])) for other in others
            if other is not o and not TABLE[other.category].soft and _near(o, other)]
    every = np.concatenate([np.zeros((0, 2, 3)), *seen])
    half = np.asarray(o.size) / 2
    least = np.array([-half[0], whole.right, whole.low])
    return np.asarray(every[(every[:, 0] < half - MET).all(1) & (every[:, 1] > least + MET).all(1)])


def _near(a: Furnishing, b: Furnishing) -> bool:
    reach = (np.hypot(*a.size[:2]) + np.hypot(*b.size[:2])) / 2
    return bool(np.hypot(a.center[0] - b.center[0], a.center[1] - b.center[1]) < reach)


def _pieces(asset: Asset) -> Array:
    """Bounds (n, 2, 3) of what an asset is solid with, and of leaves, which have no such pieces, but for their tips."""
    felt = [corners(c) for link in asset.links for c in link.colliders]
    seen = np.concatenate([mesh.vertices for link in asset.links for mesh in link.visuals])
    lo, hi = seen.min(0), seen.max(0)
    inner = FRINGE * (hi - lo) * [1, 1, 0]
    solid = [[p.min(0), p.max(0)] for p in felt]
    leafy = not solid or (np.max([p[1] for p in solid], 0) < hi - inner - MET)[:2].any()
    return np.array([*solid, *([[lo + inner, hi - inner]] if leafy else [])])


def _seen_from(o: Furnishing, other: Furnishing, bounds: Array) -> Array:
    """Another object's bounds in the frame of this one."""
    c, s = np.cos(other.yaw - o.yaw), np.sin(other.yaw - o.yaw)
    x, y, z = np.subtract(other.center, o.center)
    shift = np.array([np.cos(o.yaw) * x + np.sin(o.yaw) * y, np.cos(o.yaw) * y - np.sin(o.yaw) * x, z])
    turn, half = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), np.ptp(bounds, axis=1) / 2
    middle, reach = bounds.mean(1) @ turn.T + shift, half @ np.abs(turn).T
    return np.stack([middle - reach, middle + reach], 1)


def _cuts(o: Furnishing, whole: Cut, window: Window, solid: Array) -> Iterator[Cut]:
    """All that cloth could be cut to, within what curtains measure and windows need."""
    lows = {whole.low, *(max(z + APART, window.sill - BELOW, whole.low) for z in solid[:, 1, 2])}
    rights = {whole.right, *(y + APART for y in solid[:, 1, 1] if whole.right < y < 0)}
    lefts = {whole.left, *(y - APART for y in solid[:, 0, 1] if 0 < y < whole.left)}
    least = TABLE[CURTAIN].min
    for cut in map(Cut, *zip(*product(sorted(lows), sorted(rights), sorted(lefts)))):
        covered = min(cut.left, window.left) - max(cut.right, window.right)
        wide = cut.left - cut.right >= least[1] and covered >= COVERED * (window.left - window.right)
        if wide and o.size[2] / 2 - cut.low >= least[2]:
            yield cut


def _enters(o: Furnishing, panels: Array, cut: Cut, solid: Array) -> bool:
    """Whether any panel, cut so, is in something."""
    size = np.array([o.size[0], cut.left - cut.right, o.size[2] / 2 - cut.low])
    middle = np.array([0.0, (cut.left + cut.right) / 2, (o.size[2] / 2 + cut.low) / 2])
    cloth = panels * size + middle
    deep = np.minimum(cloth[:, None, 1], solid[None, :, 1]) - np.maximum(cloth[:, None, 0], solid[None, :, 0])
    return bool((deep > MET).all(-1).any())


def _cost(cut: Cut, whole: Cut, window: Window) -> float:
    short = SHORTER * (cut.low > whole.low) + GLASS * max(cut.low - max(window.sill, whole.low), 0.0)
    trimmed = (cut.right - whole.right) + (whole.left - cut.left)
    bare = max(cut.right - window.right, 0.0) + max(window.left - cut.left, 0.0)
    return float(short + NARROWER * trimmed + UNCOVERED * bare)


def _alike(curtains: Sequence[Furnishing], cuts: Mapping[str, Cut]) -> dict[str, Cut]:
    """Curtains of a room that were as long as one that is shorter now, as short."""
    found: dict[str, Cut] = {}
    for o in curtains:
        own = cuts.get(o.id, _own(o))
        like = [cuts[p.id].low for p in curtains if p.id in cuts and p.room == o.room
                and abs(p.size[2] - o.size[2]) < APART and abs(p.center[2] - o.center[2]) < APART]
        if max(like, default=own.low) > own.low + 1e-6:
            found[o.id] = own._replace(low=max(like))
    return found


def _remade(o: Furnishing, cut: Cut, asset: Asset, made: Embedded) -> Furnishing:
    """The curtain at its new size, its rail as high as before."""
    wanted = millimetres((o.size[0], cut.left - cut.right, o.size[2] / 2 - cut.low))
    anew = made.nearest(CURTAIN, wanted, asset.latent, wanted, made.design(CURTAIN, o.asset.id))
    if anew is None:
        return o
    aside, top = (cut.left + cut.right) / 2, o.center[2] + o.size[2] / 2
    x, y = o.center[0] - aside * np.sin(o.yaw), o.center[1] + aside * np.cos(o.yaw)
    center = (round(float(x), 6), round(float(y), 6), round(top - anew.size[2] / 2, 6))
    return o.model_copy(update={"center": center, "size": anew.size, "latent": np.round(anew.latent, 4).tolist(),
                                "asset": AssetKey(library=anew.library, id=anew.id)})
