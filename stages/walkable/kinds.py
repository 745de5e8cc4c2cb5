"""What does for an object that cannot stay as it is: a lower or smaller one, or another kind for the same use."""

from collections.abc import Iterator
from itertools import islice

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.carrying import carried
from apartgen.stages.walkable import importance, placing
from apartgen.stages.walkable.designs import look
from apartgen.stages.walkable.leaves import building
from apartgen.stages.walkable.parts import at_building
from apartgen.stages.walkable.places import kin
from apartgen.stages.walkable.site import Changes, Scene, Site
from apartgen.stages.walkable.smaller import BUILT_IN, LATENT
from apartgen.stages.walkable.solids import Solids

DESIGNS = 24
"""Designs of another kind looked at for one of the same style."""
BELOW_SILL = 0.01
"""How far below a windowsill a lower one ends, m."""


def stand_ins(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """The object where it stands as a lower or smaller one, then as other kinds; its company moves up to it.

    What the prompt asked for keeps its kind. Whether they fit is not looked at, but for doors that stand open, which
    nothing of another kind opens into.
    """
    if o.category in BUILT_IN or o.category not in categories.TABLE:
        return
    kinds = () if importance.asked([o], scene, site) else categories.TABLE[o.category].instead
    sills = [window.sill for window in site.world.plan.openings if window.kind == "window" and o.room in window.rooms]
    sill = min(sills, default=np.inf) - BELOW_SILL
    for category in (o.category, *kinds):
        kind = categories.TABLE[category]
        most = np.maximum(kind.min, np.minimum(o.size, kind.max))
        tall = [float(most[2]), *([sill] if kind.min[2] <= sill < most[2] else [])]
        for d, w in dict.fromkeys(tuple(side[:2]) for side in (most, np.minimum(most, kind.size), np.array(kind.min))):
            for height in tall:
                size = np.array([d, w, height])
                assets = [] if np.allclose(size, o.size, atol=2e-3) else _assets(site, o, category, size)
                found = (_stood_in(site, scene, o, asset) for asset in assets)
                to = next((to for to in found if to and (category == o.category or _opens(site, to[o.id]))), None)
                if to is not None:
                    yield to


def _assets(site: Site, o: Furnishing, category: str, size: Array) -> list[Asset]:
    """Assets of that kind and size, those most like the object first."""
    latent = np.asarray(o.latent, float) if len(o.latent) == LATENT else np.zeros(LATENT)
    if category == o.category:
        nearest = site.library.nearest(category, size, latent, size, o.asset.id)
        return [] if nearest is None else [nearest]
    designs = list(islice(site.library.alternatives(category, size, np.zeros(0)), DESIGNS))
    style, _ = look(site.library, o)
    if not designs and (nearest := site.library.nearest(category, size, np.zeros(0), size)) is not None:
        return [nearest]
    return sorted(designs, key=lambda asset: asset.style != style)


def _opens(site: Site, new: Furnishing | None) -> bool:
    """Whether all its parts open where walls and the doors of the room, shut or open, let them."""
    return new is not None and not at_building(building(site.world.plan), Solids(site.library), [new])


def _stood_in(site: Site, scene: Scene, o: Furnishing, asset: Asset) -> Changes | None:
    new = placing.furnished(o.model_copy(update={"category": asset.category}), asset, site)
    low = o.center[2] - o.size[2] / 2
    new = new.model_copy(update={"center": (*new.center[:2], low + new.size[2] / 2)})
    changes = placing.settled(o, new, asset, scene)
    if changes is None:
        return None
    base, lost = boxes.of([o]), (np.asarray(o.size) - new.size)[:2] / 2
    for p in kin(o, scene):
        at = boxes.local([p.center[:2]], base)[0, 0]
        moved = at - np.where(np.abs(at) > np.asarray(o.size[:2]) / 2, np.sign(at) * lost, 0.0)
        by = new.center[:2] + moved @ boxes.axes(base)[0] - p.center[:2]
        changes |= {q.id: placing.moved(q, by.tolist()) for q in (p, *carried(p, scene))}
    return changes
