"""What an episode can touch: colliders near where the robot may stand and where the parts move."""

from collections.abc import Collection, Sequence

import mujoco
import numpy as np

from apartgen.stages.embodied.interact.robot import REACH
from apartgen.stages.embodied.world import World
from apartgen.stages.space import polygons
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.space.turns import rotation
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body
from apartgen.stages.things.solids import corners

ROBOT = REACH + 0.45
"""Nothing of the robot gets further than this from where a handle is while shut: it stands within reach, and what is
not stretched out to the handle stays this much nearer its mast, m."""
PASSED = 0.8
"""From another room the robot touches what is no further than this from a passage between the two, m."""
_SPARE = 0.05
_STEPS = 9


class Surroundings:
    """Bounds of an apartment's colliders, but for some, and which of them are far from an object."""

    def __init__(self, apartment: World, without: Collection[str]) -> None:
        model = apartment.model
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        turned = data.geom_xmat.reshape(-1, 3, 3)
        middle = data.geom_xpos + np.einsum("nij,nj->ni", turned, model.geom_aabb[:, :3])
        half = np.einsum("nij,nj->ni", np.abs(turned), model.geom_aabb[:, 3:])
        self.names = [model.geom(k).name for k in range(model.ngeom)]
        self.lo, self.hi = middle - half, middle + half
        self.gone = np.isin(self.names, list(without))
        self.ground = model.geom_type == mujoco.mjtGeom.mjGEOM_PLANE
        rooms = {o.id: o.room for o in apartment.home.objects}
        self.rooms = np.array([rooms.get(apartment.owner.get(k, ""), "") for k in range(model.ngeom)])
        self.passages = [(o.rooms, np.array(o.segment, float)) for o in apartment.home.openings
                         if o.kind in polygons.PASSAGES]

    def far(self, body: Body, links: Sequence[Link]) -> list[str]:
        """Names of the colliders that no episode with these parts of an object can touch."""
        spans = [_span(body, link) for link in links]
        lo, hi = np.min([low for low, _ in spans], axis=0)[:2], np.max([high for _, high in spans], axis=0)[:2]
        near = (self._between(lo, hi) & self._beside(body.room)) | self.ground
        return [name for name, kept in zip(self.names, near & ~self.gone, strict=True) if not kept]


    def _between(self, lo: Array, hi: Array) -> Mask:
        found: Mask = ((self.lo[:, :2] <= hi) & (self.hi[:, :2] >= lo)).all(1)
        return found

    def _beside(self, room: str) -> Mask:
        """Which colliders are in a room, belong to none, or stand near a passage to it."""
        near: Mask = np.isin(self.rooms, ["", room])
        for rooms, segment in self.passages:
            if room in rooms:
                near |= self._between(segment.min(0) - PASSED, segment.max(0) + PASSED)
        return near


def _span(body: Body, link: Link) -> tuple[Array, Array]:
    """Least and greatest corner of what a part and the robot that opens it may pass through."""
    joint = link.joint
    assert joint is not None
    pieces = [corners(c) for c in link.colliders] or [mesh.vertices for mesh in link.visuals]
    shut = np.concatenate(pieces)
    handle = shut.mean(0) if link.handle is None else np.asarray(link.handle, float)
    axis, origin = np.asarray(joint.axis, float), np.asarray(joint.origin, float)
    axis = axis / np.linalg.norm(axis)
    pose = body.pose()
    points = []
    for value in np.linspace(*joint.range, _STEPS):
        turn, shift = (np.eye(3), axis * value) if joint.type == "slide" else (rotation(axis, value), np.zeros(3))
        points.append((shut - origin) @ turn.T + origin + shift)
    swept = np.concatenate(points) @ pose[:3, :3].T + pose[:3, 3]
    at = pose[:3, :3] @ handle + pose[:3, 3]
    return (np.minimum(swept.min(0) - _SPARE, at - ROBOT), np.maximum(swept.max(0) + _SPARE, at + ROBOT))
