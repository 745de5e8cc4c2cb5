"""RetrieveSmallerCandidate and ReplaceObject of Algorithm 2."""

import numpy as np

from schemas.retrieve import Furnishing
from stages import categories
from stages.walkable import placing
from stages.walkable.site import Scene, Site, fits

GAIN = 0.98
"""A smaller candidate's footprint is at most this share of the old one."""
BUILT_IN = frozenset({
    "kitchen_base", "kitchen_drawers", "kitchen_sink", "hob", "oven", "dishwasher", "kitchen_corner",
})
"""Parts of a run: a gap between them helps nobody, and their sizes are standard."""
LATENT = 32


def smaller(site: Site, scene: Scene, o: Furnishing, share: float) -> dict[str, Furnishing | None] | None:
    """The object with the nearest smaller asset that fits in its place, with what it carries; None if there is none.

    `share` bounds both sides of the footprint, else only the width, else only the depth; the height stays.
    """
    if o.category in BUILT_IN:
        return None
    for d, w in ((share, share), (1.0, share), (share, 1.0)):
        changes = _tried(site, scene, o, np.array([d, w, 1.0]))
        if changes is not None and fits(site, scene, changes):
            return changes
    return None


def _tried(site: Site, scene: Scene, o: Furnishing, share: np.ndarray) -> dict[str, Furnishing | None] | None:
    size = np.asarray(o.size)
    least = np.asarray(categories.TABLE[o.category].min) if o.category in categories.TABLE else np.zeros(3)
    limit = np.minimum(size, np.maximum(size * share, least))
    if limit[0] * limit[1] > GAIN * size[0] * size[1]:
        return None
    latent = np.asarray(o.latent, float) if len(o.latent) == LATENT else np.zeros(LATENT)
    asset = site.library.nearest(o.category, limit, latent, limit)
    if asset is None or asset.size[0] * asset.size[1] > GAIN * size[0] * size[1]:
        return None
    return placing.settled(o, placing.resized(o, asset, site), asset, scene)
