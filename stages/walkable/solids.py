"""What objects are made of, to tell whether their parts move freely: colliders at rest, and what each part sweeps."""

from typing import NamedTuple

import numpy as np
import shapely

from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages.robot.wedged import Shapes, prisms
from apartgen.stages.space import convex
from apartgen.stages.space.convex import Hulls
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset, Collider, Link
from apartgen.stages.walkable.site import Candidates


class Solid(NamedTuple):
    """An asset's colliders, parts shut, and by joint what its part sweeps; in the object's frame."""

    rest: Hulls
    parts: dict[str, Hulls]


class Solids:
    """Solids of objects, made when first asked for; BadInput for an object whose asset can't be had."""

    def __init__(self, library: Candidates) -> None:
        self._library = library
        self._known: dict[tuple[str, ...], Solid] = {}
        self._prisms: dict[tuple[str, ...], dict[tuple[float, ...], Shapes]] = {}

    def of(self, o: Furnishing) -> Solid:
        """The solid of an object's asset."""
        key = (o.asset.library, o.asset.id)
        if key not in self._known:
            self._known[key] = solid(self._library.load_asset(*key))
        return self._known[key]

    def rest(self, o: Furnishing) -> Hulls:
        """An object's colliders where it stands, parts shut."""
        return self.of(o).rest.placed(o.center, o.yaw)

    def prisms(self, o: Furnishing) -> Shapes:
        """An object's colliders where it stands, as upright prisms."""
        key = (o.asset.library, o.asset.id)
        place = (*o.center, o.yaw)
        if key not in self._prisms:
            self._prisms[key] = {(): prisms(list(self.of(o).rest.points))}
        own = self._prisms[key]
        if place not in own:
            shadows, heights = own[()]
            c, s = np.cos(o.yaw), np.sin(o.yaw)
            turn = np.array([[c, s], [-s, c]])
            own[place] = shapely.transform(shadows, lambda xy: xy @ turn + o.center[:2]), heights + o.center[2]
        return own[place]


def solid(asset: Asset) -> Solid:
    """The solid of an asset; what lies flat on the floor hinders nothing."""
    flat = asset.category in categories.TABLE and categories.TABLE[asset.category].place == "flat"
    links: list[Link] = [] if flat else asset.links
    rest: list[Collider] = [c for link in links for c in link.colliders]
    moving: list[tuple[Joint, list[Collider]]] = [(k.joint, k.colliders) for k in links if k.joint and k.colliders]
    return Solid(convex.of(rest), {joint.name: convex.swept(convex.of(own), joint) for joint, own in moving})
