"""The stage: a layout in, real assets out."""

import logging
from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import NamedTuple

import numpy as np
import shapely
from shapely import Polygon

from apartgen.schemas.carrying import BUILDING, FLOOR, WALL
from apartgen.schemas.errors import BadInput, Unknown
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.retrieve import AssetKey, Furnishing, Retrieve
from apartgen.stages.retrieve.matching import cloth, hands, outdoors, placing, seats, sets, supports
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.embedded import NAME
from apartgen.stages.retrieve.matching.libraries import LibrarySet, shared_libraries
from apartgen.stages.retrieve.matching.placing import Site
from apartgen.stages.space import anchors, boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things import carrying
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.categories import TABLE, carriers, groups, unknown

LOG = logging.getLogger("apartgen")

ON_A_WALL = 0.5
"""What has its middle above this, m, may hang on the wall."""
TO_THE_WALL = 0.5
"""The wall that it is hung on then is no farther behind it, m."""
CARRIED = 0.8
"""Another top than the one that something stood on is at least so wide, as a share of that."""
_NONE = boxes.of([])


def run(
    previous: Layout, config: RetrieveConfig, rng: np.random.Generator, libraries: LibrarySet | None = None
) -> Retrieve:
    """Gives every object the nearest asset, its real box and its own latent.

    The result depends on the layout and the libraries alone: nothing is drawn, `rng` is left untouched.
    """
    libraries = libraries or shared_libraries(config)
    sites = placing.sites(previous)
    _check(previous, set(sites))
    wanted = _wanted(previous, libraries)
    own = [_nearest(want, libraries, 1 + config.overshoot, previous.height) for want in wanted]
    placed: list[Boxes | None] = [None] * len(own)
    on = [_carrier(box) for box in previous.objects]
    within = [partial(_nearest, want, libraries, 1.0, previous.height) for want in wanted]
    _stand(previous, own, on, placed, sites, within)
    _put_on_top(previous, own, on, placed, sites)
    own = hands.hung(previous.objects, own, libraries.embedded.load_asset)
    rows = zip(previous.objects, own, on, placed, strict=True)
    objects = [_furnishing(box, asset, below, at) for box, asset, below, at in rows if at is not None]
    objects = seats.cleared(objects, previous)
    assets = {box.id: asset for box, asset in zip(previous.objects, own, strict=True)}
    objects = cloth.clear(outdoors.hung(objects, previous), previous, assets, libraries.embedded)
    return Retrieve(**{name: getattr(previous, name) for name in Layout.model_fields} | {"objects": objects})


def _check(layout: Layout, rooms: set[str]) -> None:
    for i, box in enumerate(layout.objects):
        if box.category not in TABLE:
            raise Unknown(f"objects[{i}].category: {unknown(box.category)}")
        if box.room not in rooms:
            raise BadInput(f"objects[{i}].room: {box.room!r} is no room of the plan: {', '.join(sorted(rooms))}")


class Wanted(NamedTuple):
    """What is looked for: a category at a size and latent, and the style and seed it is made in."""

    category: str
    wish: sets.Wish
    design: sets.Design


def _wanted(layout: Layout, libraries: LibrarySet) -> list[Wanted]:
    wishes = sets.wishes(layout.objects, layout.height)
    designs = sets.designs(layout.objects, wishes, libraries.embedded)
    return [Wanted(box.category, w, d) for box, w, d in zip(layout.objects, wishes, designs, strict=True)]


def _nearest(want: Wanted, libraries: LibrarySet, over: float, height: float) -> Asset:
    """The nearest asset, one that was not made to measure up to `over` times as large as its box."""
    size, latent = want.wish
    limit = np.minimum(np.asarray(size) * over, (np.inf, np.inf, height))
    return libraries.owned(want.category, size, latent, limit) or _measured(want, libraries)


def _measured(want: Wanted, libraries: LibrarySet) -> Asset:
    """Made to the box; where that is below the category's least size, of that size."""
    (size, latent), made = want.wish, libraries.embedded
    asset = made.nearest(want.category, size, latent, size, want.design)
    asset = asset or made.nearest(want.category, size, latent, None, want.design)
    assert asset is not None
    return asset


def _carrier(box: Box) -> str:
    """The floor, a wall or the ceiling; empty for what is to stand on another object."""
    kind = TABLE[box.category]
    if kind.hangs and box.on == WALL:
        return WALL
    if carrying.by_another(box) or kind.place == "top":
        return ""
    return kind.place if kind.place in BUILDING else FLOOR


def _stand(
    layout: Layout, own: list[Asset], on: list[str], placed: list[Boxes | None], sites: dict[str, Site],
    within: Sequence[Callable[[], Asset]],
) -> None:  # fmt: skip
    """Places all that does not stand on something else; what finds no room gives way to one `within` its box."""
    rows = [i for i, below in enumerate(on) if below]
    for i in rows:
        placed[i] = _resized(layout.objects[i], own[i], on[i], sites[layout.objects[i].room].floor, layout.height)
    for i in rows:
        box, site = layout.objects[i], sites[layout.objects[i].room]
        if _outgrew(own[i], box):
            placed[i] = _fitted(i, layout, placed, site)
        if placed[i] is None and own[i].library != NAME:
            own[i] = within[i]()
            placed[i] = _resized(box, own[i], on[i], site.floor, layout.height)
            placed[i] = _fitted(i, layout, placed, site) if _outgrew(own[i], box) else placed[i]
        if placed[i] is None:
            LOG.warning("%s: smaller than any real %s, and there is no room for one; left out", box.id, box.category)


def _resized(box: Box, asset: Asset, on: str, room: Polygon, height: float) -> Boxes:
    new = anchors.resized(placing.one(box), asset.size, room)
    return placing.at_height(new, placing.bottom(on, new, height))


def _outgrew(asset: Asset, box: Box) -> bool:
    return any(side > room + 1e-6 for side, room in zip(asset.size, box.size, strict=True))


def _fitted(i: int, layout: Layout, placed: Sequence[Boxes | None], site: Site) -> Boxes | None:
    """A thing larger than its box, moved to where there is room for it; None where there is none."""
    before, now = placing.one(layout.objects[i]), placed[i]
    assert now is not None
    rest = [j for j, other in enumerate(placed) if other is not None and j != i]
    names = [layout.objects[j].category for j in rest]
    return placing.grown(
        now, before, site, placing.others(before, layout.objects[i].category, _stacked(placed, rest), names)
    )


def _stacked(placed: Sequence[Boxes | None], rows: Sequence[int]) -> Boxes:
    some = [box for j in rows if (box := placed[j]) is not None]
    return Boxes(*(np.concatenate([getattr(box, name) for box in some]) for name in Boxes._fields)) if some else _NONE


def _put_on_top(
    layout: Layout, own: list[Asset], on: list[str], placed: list[Boxes | None], sites: dict[str, Site]
) -> None:
    """Puts each thing that stands on another exactly on its top, clear of all the rest where that can be."""
    top_of = cache(lambda j: _top(own[j], placed[j]))
    for i, box in enumerate(layout.objects):
        if on[i]:
            continue
        floor = sites[box.room].floor
        item = anchors.resized(placing.one(box), own[i].size, floor)
        below = _below(i, layout, placed)
        for small in (False, True):
            taken = ((j, _stacked(placed, _near(i, j, layout, on, small))) for j in below)
            spots = ((j, supports.stand(item, top_of(j), others, floor)) for j, others in taken)
            under, placed[i] = next(((j, spot) for j, spot in spots if spot is not None), (i, None))
            if placed[i] is not None:
                on[i] = layout.objects[under].id
                break
        else:
            on[i], placed[i] = WALL, _unsupported(box, item, floor)


def _near(i: int, under: int, layout: Layout, on: Sequence[str], small: bool) -> list[int]:
    """What a thing on top of another must keep clear of: all in its room, or only what stands on something too and what
    fills its box, as what opens does.
    """
    room = layout.objects[i].room
    rest = [j for j, other in enumerate(layout.objects) if other.room == room and j not in (i, under)]
    return [j for j in rest if not small or on[j] not in BUILDING or TABLE[layout.objects[j].category].articulated]


def _top(asset: Asset, box: Boxes | None) -> supports.Top:
    assert box is not None
    return supports.top(asset, box)


def _below(i: int, layout: Layout, placed: Sequence[Boxes | None]) -> list[int]:
    """What the object may stand on in its room: where it stood, then what it belongs on, then other tops; the nearest
    first."""
    box = layout.objects[i]
    able = [
        j
        for j, other in enumerate(layout.objects)
        if other.room == box.room and placed[j] is not None
        and (other.id == box.on or other.category in carriers() and other.size[1] >= CARRIED * box.size[1])
    ]

    def order(j: int) -> tuple[bool, bool, float, int]:
        apart = np.hypot(*np.subtract(layout.objects[j].center, box.center)[:2])
        beside = (box.category, layout.objects[j].category) not in groups()
        return layout.objects[j].id != box.on, beside, round(float(apart), 6), j

    return sorted(able, key=order)


def _unsupported(box: Box, item: Boxes, floor: Polygon) -> Boxes | None:
    """A television, say, may hang on the wall behind it; anything else without a top to stand on is left out."""
    back = -boxes.axes(item)[0, 0]
    middle, half = item.center[0, :2], item.size[0, 0] / 2
    behind = shapely.LineString([middle, middle + (half + TO_THE_WALL) * back]).intersection(floor.exterior)
    if TABLE[box.category].hangs and box.center[2] > ON_A_WALL and not behind.is_empty:
        gap = behind.distance(shapely.Point(middle)) - half
        return item._replace(center=item.center + [*(gap * back), 0.0])
    LOG.warning("%s (%s): nothing in its room to stand on; left out", box.id, box.category)
    return None


def _furnishing(box: Box, asset: Asset, on: str, at: Boxes) -> Furnishing:
    x, y, z = (round(float(v), 6) for v in at.center[0])
    return Furnishing(
        **box.model_dump(include={"id", "room", "category", "yaw"}),
        center=(x, y, z),
        size=asset.size,
        latent=np.round(asset.latent, 4).tolist(),
        on=on,
        asset=AssetKey(library=asset.library, id=asset.id),
        joints=asset.joints,
    )
