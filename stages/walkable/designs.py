"""Other designs of an object, those that look like it first."""

from collections import defaultdict
from collections.abc import Iterator
from itertools import islice

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.things.asset import Asset
from apartgen.stages.walkable import placing
from apartgen.stages.walkable.site import Candidates, Changes, Scene, Site
from apartgen.stages.walkable.smaller import LATENT

DESIGNS = 12
"""Other designs tried of an object whose parts are blocked."""


def redesigned(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """The object in other designs of its size: those that open first, of these the ones of its style and material."""
    latent = np.asarray(o.latent, float) if len(o.latent) == LATENT else np.zeros(LATENT)
    found = islice(site.library.alternatives(o.category, o.size, latent, o.asset.id), DESIGNS)
    style, material = look(site.library, o)
    ordered = sorted(found, key=lambda asset: (
        not asset.joints, (asset.style != style) + (main_material(asset) != material)))
    for asset in ordered:
        if (asset.library, asset.id) == (o.asset.library, o.asset.id):
            continue
        to = placing.settled(o, placing.furnished(o, asset, site), asset, scene)
        if to is not None:
            yield to


def look(library: Candidates, o: Furnishing) -> tuple[str, str]:
    """Style and main material of an object's asset."""
    asset = library.load_asset(o.asset.library, o.asset.id)
    return asset.style, main_material(asset)


def main_material(asset: Asset) -> str:
    """Name of the material that most of an asset's surface is of."""
    areas: dict[str, float] = defaultdict(float)
    for mesh in (mesh for link in asset.links for mesh in link.visuals):
        a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
        areas[mesh.material.name] += float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
    return max(sorted(areas), key=lambda name: areas[name], default="")
