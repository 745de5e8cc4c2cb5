"""Where an object stands after it changed size, and what stands on it."""

from collections.abc import Sequence

import numpy as np

from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint
from apartgen.stages.space import anchors, boxes
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.carrying import carried
from apartgen.stages.things.tops import heights
from apartgen.stages.walkable.site import Changes, Scene, Site

LEVEL = 0.004
"""Heights within this are one level, m."""


def resized(o: Furnishing, size: Sequence[float], site: Site) -> Furnishing:
    """The object in another size: anchored ends, and its underside, stay where they were."""
    box = anchors.resized(boxes.of([o]), size, site.floors[o.room])
    x, y, z = box.center[0].tolist()
    return o.model_copy(update={"center": (x, y, z), "size": tuple(float(s) for s in size)})


def scaled(o: Furnishing, size: Sequence[float], site: Site) -> Furnishing:
    """The object in another size with its parts scaled along, for a guess at what an asset of that size would do."""
    ratio = np.asarray(size) / o.size
    joints = [_scaled(joint, ratio) for joint in o.joints]
    return resized(o, size, site).model_copy(update={"joints": joints})


def _scaled(joint: Joint, ratio: Array) -> Joint:
    lo, hi = joint.range
    by = float(np.abs(np.asarray(joint.axis)) @ ratio / np.abs(joint.axis).sum()) if joint.type == "slide" else 1.0
    extent = None if joint.extent is None else tuple(tuple((np.asarray(end) * ratio).tolist()) for end in joint.extent)
    origin = tuple((np.asarray(joint.origin) * ratio).tolist())
    return joint.model_copy(update={"range": (lo * by, hi * by), "extent": extent, "origin": origin})


def furnished(o: Furnishing, asset: Asset, site: Site) -> Furnishing:
    """The object with another asset and its latent, placed as `resized` does."""
    key = AssetKey(library=asset.library, id=asset.id)
    latent = np.round(asset.latent, 4).tolist()
    return resized(o, asset.size, site).model_copy(update={"joints": asset.joints, "asset": key, "latent": latent})


def moved(o: Furnishing, by: Sequence[float]) -> Furnishing:
    """The object shifted by (x, y) or (x, y, z) metres."""
    x, y, z = (c + d for c, d in zip(o.center, [*by, 0.0][:3]))
    return o.model_copy(update={"center": (float(x), float(y), float(z))})


def settled(old: Furnishing, new: Furnishing, asset: Asset, scene: Scene) -> Changes | None:
    """The changed object and, by id, what it carries on the new asset's top; None if that no longer holds it."""
    changes: Changes = {new.id: new}
    for item in (p for p in scene if p.on == old.id):
        placed = _on(new, item, asset)
        if placed is None:
            return None
        by = np.subtract(placed.center, item.center).tolist()
        changes |= {item.id: placed, **{p.id: moved(p, by) for p in carried(item, scene)}}
    return changes


def _on(under: Furnishing, item: Furnishing, asset: Asset) -> Furnishing | None:
    """The item inside the top's outline and on its surface; None where the surface is not level below it."""
    base, own = boxes.of([under]), boxes.of([item])
    spans = np.ptp(boxes.local(boxes.corners(own)[0], base)[0], axis=0)
    room = (base.size[0, :2] - spans) / 2
    if (room < 0).any():
        return None
    spot = np.clip(boxes.local(own.center[:, :2], base)[0, 0], -room, room)
    at = base.center[0, :2] + spot @ boxes.axes(base)[0]
    shifted = Boxes(np.array([[*at, 0.0]]), own.size * [0.7, 0.7, 1], own.yaw)
    points = np.concatenate([at[None], boxes.corners(shifted)[0]])
    z = heights(asset, boxes.local(points, base)[0])
    if not np.isfinite(z).all() or np.ptp(z) > LEVEL:
        return None
    bottom = under.center[2] + float(z.max())
    return moved(item, [*(at - item.center[:2]), bottom + item.size[2] / 2 - item.center[2]])
