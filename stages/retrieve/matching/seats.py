"""Loose things out of the way of moving parts, now that the assets' joints say where those reach.

A layout may tuck a chair under its desk without knowing on which side the drawers will be.
"""

import logging
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.schemas.plan import Plan
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.retrieve.matching import placing
from apartgen.stages.retrieve.matching.placing import Site
from apartgen.stages.space import boxes, polygons, sweeps
from apartgen.stages.space.boxes import Array, Boxes, Mask
from apartgen.stages.things import carrying
from apartgen.stages.things.categories import TABLE, belong_together

LOG = logging.getLogger("apartgen")

MET = 0.002
"""A part that is entered deeper than this does not move freely, m."""
CONTACT = 0.005
"""Nothing may be entered deeper than this, or than it was, m."""
PANEL = 0.02
"""Kept free beside a moving part where that is no further than `WORTH`, for the panel that carries it, m."""
WORTH = 0.1
BEYOND = 0.1
"""How far a seat may stand beyond the end of its table, m."""
ASIDE = np.arange(-40, 41) * 0.02
"""Shifts along a piece's front, m."""
OUT = np.arange(17) * 0.05
"""Shifts away from it, m."""
RINGS = np.arange(1, 31) * 0.05
"""How far lamps, and things that belong to no piece, are shifted in any direction, m."""
BEARINGS = np.arange(16) * np.pi / 8
_EDGE = 0.001
_AREA = 1e-4  # floor that a shift may take from a doorway, m²


class Parts(NamedTuple):
    """The space each moving part passes through (k boxes), and the index of the object it is part of, (k,)."""

    boxes: Boxes
    owner: NDArray[np.int64]


def parts(objects: Sequence[Furnishing]) -> Parts:
    """Swept bounds of every joint whose part has an extent."""
    found = [(i, sweeps.swept(j)) for i, o in enumerate(objects) for j in o.joints if j.extent is not None]
    owner = np.array([i for i, _ in found], np.int64)
    lo, hi = (np.array([bounds[k] for _, bounds in found], float).reshape(-1, 3) for k in (0, 1))
    return Parts(boxes.spread(boxes.of(objects).take(owner), lo, hi), owner)


def cleared(objects: Sequence[Furnishing], plan: Plan) -> list[Furnishing]:
    """The objects, with loose things and lamps shifted as little as frees the parts that they stood in.

    They stay in their room and out of its doorways, and enter nothing deeper than before; what stands on them goes
    along. What finds no such place stays where it is.
    """
    result = list(objects)
    for room, site in placing.sites(plan).items():
        rows = [i for i, o in enumerate(result) if o.room == room]
        things = [result[i] for i in rows]
        for k, o in enumerate(things):
            if _hangs(o) or _loose(o):
                shift = _shift(k, things, _overhead(o, site, plan) if _hangs(o) else site)
                things = _shifted(k, things, shift) if shift.any() else things
        for i, o in zip(rows, things, strict=True):
            result[i] = o
    return result


def _hangs(o: Furnishing) -> bool:
    return TABLE[o.category].place == "ceiling"


def _loose(o: Furnishing) -> bool:
    return TABLE[o.category].loose and TABLE[o.category].place == "floor"


def _overhead(lamp: Furnishing, site: Site, plan: Plan) -> Site:
    """A lamp's site: only leaves as high as its lower end need it out of the way."""
    low = lamp.center[2] - lamp.size[2] / 2
    swings = [polygons.swing(o, plan) for o in plan.openings if o.head > low and o.into == lamp.room]
    return Site(site.floor, unary_union(swings))


def _shift(i: int, things: list[Furnishing], site: Site) -> Array:
    """The least shift in plan (2,) that frees all parts the thing stands in; zero where it meets none or has none."""
    thing, moving = things[i], parts(things)
    own, swept = placing.one(thing), moving.boxes.take(moving.owner != i)
    depth = boxes.penetration(own, swept)[0]
    met = moving.owner[moving.owner != i][depth > MET]
    if not len(met) and not (_hangs(thing) and _taken(own, site.doorways)[0] > _AREA):
        return np.zeros(2)
    shifts = _around()
    if not _hangs(thing):
        near = _beside(own, thing, [things[j] for j in sorted(set(met.tolist()))])
        shifts = near if TABLE[thing.category].belongs else np.concatenate([near, shifts])
    fits = shifts[_fits(i, things, site, shifts)]
    ways = [way for wide in (PANEL, 0.0) if (way := _free(own, fits, swept, wide)) is not None]
    if not ways:
        LOG.info("%s stands in the way of %s; no free place near by", thing.id, _named(things, met))
        return np.zeros(2)
    return ways[0] if np.hypot(*ways[0]) <= np.hypot(*ways[-1]) + WORTH else ways[-1]


def _free(own: Boxes, shifts: Array, swept: Boxes, wide: float) -> Array | None:
    """The first shift (2,) that is clear of all parts and of so much beside them."""
    grown = swept._replace(size=swept.size + np.array([0.0, 2 * wide, 0.0]))
    free = shifts[(boxes.penetration(_at(own, shifts), grown) <= MET).all(-1)]
    return np.asarray(free[0]) if len(free) else None


def _named(things: list[Furnishing], met: NDArray[np.int64]) -> str:
    return ", ".join(things[j].id for j in sorted(set(met.tolist()))) or "a door"


def _around() -> Array:
    """Shifts in every direction, the shortest first, (k, 2)."""
    turned = np.stack([np.cos(BEARINGS), np.sin(BEARINGS)], -1)
    return np.asarray((RINGS[:, None, None] * turned).reshape(-1, 2))


def _beside(own: Boxes, thing: Furnishing, met: Sequence[Furnishing]) -> Array:
    """Shifts along and away from the piece whose parts are met, its own before others; the shortest first, (k, 2)."""
    kin = [o for o in met if belong_together(thing.category, o.category)]
    main = (kin or met)[0]
    piece = placing.one(main)
    at, seen = boxes.local(own.center[:, :2], piece)[0, 0], boxes.local(boxes.corners(own)[0], piece)[0]
    half, reach = piece.size[0, :2] / 2, np.ptp(seen, axis=0) / 2
    away = int(np.argmax(np.abs(at) - half))  # the side it stands at: 0 front or back, 1 left or right
    out, aside = (grid.ravel() for grid in np.meshgrid(OUT, ASIDE, indexing="ij"))
    if kin:  # A seat stays at its table.
        far = max(half[1 - away] + BEYOND - reach[1 - away], abs(at[1 - away]))
        kept = np.abs(at[1 - away] + aside) <= far + 1e-9
        out, aside = out[kept], aside[kept]
    steps = np.stack([out * (1 if at[away] >= 0 else -1), aside], -1)[:, :: 1 if away == 0 else -1]
    order = np.argsort(np.round(np.hypot(out, aside), 6), kind="stable")
    shifts = np.asarray(steps[order] @ boxes.axes(piece)[0])
    if TABLE[main.category].kneehole:  # others are solid where they have moving parts
        return shifts
    return np.asarray(shifts[boxes.penetration(_at(own, shifts), piece)[:, 0] <= CONTACT])


def _at(box: Boxes, shifts: Array) -> Boxes:
    """One box (1) shifted in plan by each of (k, 2), as k boxes."""
    center = box.center + np.concatenate([shifts, np.zeros((len(shifts), 1))], -1)
    return Boxes(center, np.repeat(box.size, len(shifts), 0), np.repeat(box.yaw, len(shifts)))


def _fits(i: int, things: list[Furnishing], site: Site, shifts: Array) -> Mask:
    """Where a thing, its own open parts included, is in its room, clear of doorways and of all other things, (k,)."""
    own, wide = placing.one(things[i]), sweeps.extended([things[i]])
    riding = {o.id for o in carrying.carried(things[i], things)}
    solid = [o for o in things if o is not things[i] and TABLE[o.category].place != "flat" and o.id not in riding]
    others, spots = boxes.of(solid), _at(own, shifts)
    allowed = np.maximum(boxes.penetration(wide, others), CONTACT) + 1e-9
    blocked = 0.0 if _hangs(things[i]) else _taken(own, site.doorways)[0]
    floor = site.floor.buffer(_EDGE, join_style="mitre")
    return np.asarray(
        (boxes.penetration(_at(wide, shifts), others) <= allowed).all(-1)
        & shapely.covers(floor, boxes.footprints(spots))
        & (_taken(spots, site.doorways) <= blocked + _AREA)
    )


def _taken(spots: Boxes, area: Geometry) -> Array:
    """How much of an area each footprint covers, m², (k,)."""
    return np.asarray(shapely.area(shapely.intersection(boxes.footprints(spots), area)))


def _shifted(i: int, things: list[Furnishing], shift: Array) -> list[Furnishing]:
    """The things with one shifted, and what stands on it."""

    def moved(o: Furnishing) -> Furnishing:
        x, y = (round(float(v), 6) for v in np.add(o.center[:2], shift))
        return o.model_copy(update={"center": (x, y, o.center[2])})

    along = {o.id for o in (things[i], *carrying.carried(things[i], things))}
    return [moved(o) if o.id in along else o for o in things]
