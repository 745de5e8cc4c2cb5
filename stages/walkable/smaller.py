"""RetrieveSmallerCandidate and ReplaceObject of Algorithm 2."""

from collections.abc import Iterator

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space.boxes import Array
from apartgen.stages.things import categories
from apartgen.stages.walkable import placing
from apartgen.stages.walkable.site import Changes, Scene, Site, fits

GAIN = 0.98
"""A smaller candidate's footprint is at most this share of the old one."""
BUILT_IN = categories.those(lambda kind: kind.run in ("unit", "fitted"))
"""Parts of a run: a gap between them helps nobody, and their sizes are standard."""
LATENT = 32


def smaller(site: Site, scene: Scene, o: Furnishing, share: float) -> Changes | None:
    """The object with the nearest smaller asset that fits in its place, with what it carries; None if there is none."""
    for limit in limits(o, share, site.least(o)):
        changes = candidate(site, scene, o, limit)
        if changes is not None and fits(site, scene, changes):
            return changes
    return None


def limits(o: Furnishing, share: float, least: Array) -> Iterator[Array]:
    """Greatest sizes (3,) to look for: `share` of both sides of the footprint, of the width, of the depth.

    The height stays, and no side goes below `least`.
    """
    if o.category in BUILT_IN:
        return
    size = np.asarray(o.size)
    for d, w in ((share, share), (1.0, share), (share, 1.0)):
        limit = np.minimum(size, np.maximum(size * [d, w, 1.0], least))
        if limit[0] * limit[1] <= GAIN * size[0] * size[1]:
            yield limit


def candidate(site: Site, scene: Scene, o: Furnishing, limit: Array, gain: float = GAIN) -> Changes | None:
    """The object with the library's nearest asset under a limit, with what it carries; None if there is none."""
    latent = np.asarray(o.latent, float) if len(o.latent) == LATENT else np.zeros(LATENT)
    asset = site.library.nearest(o.category, limit, latent, limit, o.asset.id)
    if asset is None or asset.size[0] * asset.size[1] > gain * o.size[0] * o.size[1]:
        return None
    return placing.settled(o, placing.furnished(o, asset, site), asset, scene)
