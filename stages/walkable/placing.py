"""Where an object stands after it changed size, and what stands on it."""

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Boxes
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset
from apartgen.stages.walkable.site import Changes, Scene, Site

NEAR = 0.12
"""A side this close to a wall stays at its distance from it, m."""
LEVEL = 0.004
"""Heights within this are one level, m."""
ON = 0.02
"""What is this little above or below a top stands on it, m."""


def anchors(o: Furnishing, site: Site) -> tuple[int, int]:
    """Which end keeps its place, along depth and width: -1 back or right, 1 front or left, 0 the middle.

    The end at a wall does; the back comes before the front, and between two walls the middle stays.
    """
    front, left = boxes.axes(boxes.of([o]))[0]
    d, w = o.size[0] / 2 + NEAR, o.size[1] / 2 + NEAR
    points = np.asarray(o.center[:2]) + np.array([-d * front, d * front, -w * left, w * left])
    at = ~shapely.contains_xy(site.floors[o.room], points)
    back, ahead, right, beside = (int(hit) for hit in at)
    return (-1 if back else ahead), beside - right


def resized(o: Furnishing, size: Sequence[float], site: Site) -> Furnishing:
    """The object in another size: anchored ends, and its underside, stay where they were."""
    lost = (np.asarray(o.size) - size) / 2
    shift = np.array(anchors(o, site)) * lost[:2] @ boxes.axes(boxes.of([o]))[0]
    x, y, z = np.asarray(o.center) + [*shift, -lost[2]]
    return o.model_copy(update={"center": (float(x), float(y), float(z)), "size": tuple(float(s) for s in size)})


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


def carried(o: Furnishing, scene: Scene) -> list[Furnishing]:
    """What stands on top of an object."""
    tops = [p for p in scene if p.room == o.room and p.id != o.id and _is_top(p) and _may_be_on(p, o)]
    return [p for p in tops if _below(p, scene) == o.id]


def _may_be_on(p: Furnishing, o: Furnishing) -> bool:
    """Whether a thing's centre is over the circle about an object, which rules most others out."""
    x, y = p.center[0] - o.center[0], p.center[1] - o.center[1]
    return x * x + y * y <= (o.size[0] ** 2 + o.size[1] ** 2) / 4 + LEVEL


def _is_top(o: Furnishing) -> bool:
    return o.category in categories.TABLE and categories.TABLE[o.category].place == "top"


def _below(o: Furnishing, scene: Scene) -> str | None:
    """Id of the object that a thing stands on: the highest of those under its centre."""
    bottom = o.center[2] - o.size[2] / 2
    under = [p for p in scene if p.room == o.room and p.id != o.id and not _is_top(p)
             and p.center[2] - p.size[2] / 2 < bottom <= p.center[2] + p.size[2] / 2 + ON]
    if not under:
        return None
    inside = boxes.distance([o.center[:2]], boxes.of(under))[0] <= 0
    held = [p for p, hit in zip(under, inside) if hit]
    return max(held, key=lambda p: p.center[2] + p.size[2] / 2).id if held else None


def settled(old: Furnishing, new: Furnishing, asset: Asset, scene: Scene) -> Changes | None:
    """The changed object and, by id, what it carries on the new asset's top; None if that no longer holds it."""
    changes: Changes = {new.id: new}
    for item in carried(old, scene):
        placed = _on(new, item, asset)
        if placed is None:
            return None
        changes[item.id] = placed
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
    z = surface(asset, boxes.local(points, base)[0])
    if not np.isfinite(z).all() or np.ptp(z) > LEVEL:
        return None
    bottom = under.center[2] + float(z.max())
    return moved(item, [*(at - item.center[:2]), bottom + item.size[2] / 2 - item.center[2]])


def surface(asset: Asset, points: Array) -> NDArray[np.float64]:
    """Height of the highest visible surface over each point (p, 2), asset's frame, (p,); -inf where there is none."""
    meshes = [mesh for link in asset.links for mesh in link.visuals]
    if not meshes:
        return np.full(len(points), asset.size[2] / 2)
    a, b, c = np.concatenate([mesh.vertices[mesh.faces] for mesh in meshes]).transpose(1, 0, 2)
    u, v = (b - a)[:, :2], (c - a)[:, :2]
    det = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    flat = np.abs(det) > 1e-9
    a, b, c, u, v, det = a[flat], b[flat], c[flat], u[flat], v[flat], det[flat]
    offset = points[:, None] - a[None, :, :2]
    s = (offset[..., 0] * v[:, 1] - offset[..., 1] * v[:, 0]) / det
    t = (u[:, 0] * offset[..., 1] - u[:, 1] * offset[..., 0]) / det
    over = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
    z = a[:, 2] + s * (b - a)[:, 2] + t * (c - a)[:, 2]
    return np.asarray(np.where(over, z, -np.inf).max(1, initial=-np.inf))
