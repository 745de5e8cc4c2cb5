"""What can be opened: one part of an object, where it is held, how it moves."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.embodied.interact.robot import OPENING
from apartgen.stages.embodied.world import World
from apartgen.stages.space.boxes import Array
from apartgen.stages.space.turns import rotation
from apartgen.stages.things.asset import Collider, Link
from apartgen.stages.things.body import Body
from apartgen.stages.things.solids import corners

Kind = Literal["pinch", "cup", "push"]
OF_HANDLE = 0.02
"""Pieces no further than this from where the handle is said to be belong to it, m."""
PLAY = 0.012
"""How much wider than what they take the fingers open, on each side, m."""
DEEP = 0.004
"""How far behind a handle's foremost point the fingers' middle takes hold, m."""
LIP = 0.035
"""How far from a lid's front edge the cup sits on it, m."""
RIM, BOARD = 0.03, 0.05
"""How far below the upper edge of a drawer's front its back is pushed; boards are thinner than this, m."""
SHARES, APART = (0.5, 0.25, 0.75), 0.04
"""Where else a long handle or front is held, as shares of its length, if no nearer than this to the handle's middle."""
EDGE = 0.05
"""How far from a leaf's free edge it is pushed, m."""


@dataclass(frozen=True)
class Hold:
    """A way to act on a part: at a world point while the part is shut.

    pinch: the fingers close across `across` (unit) on `width` metres · cup: the suction cup
    before the closed fingers sits on a face ·
    push: closed fingers against the back of the leaf. `out` is the way that the part's front faces, `geoms` are what
    the fingers touch.
    """

    kind: Kind
    point: Array
    across: Array
    out: Array
    geoms: tuple[int, ...]
    width: float = 0.0

    @property
    def opening(self) -> float:
        """Where each finger stands while the part is moved, m from the middle."""
        return self.width / 2


@dataclass(frozen=True)
class Part:
    """A moving link of an object where it stands; `front` and `up` are the object's (world, unit).

    `joint` is its joint's name in the artifact, `name` that in the model; `others` are holds that are tried where
    `holds` do nowhere, `pushes` those that a part standing ajar is pushed on by.
    """

    object: str
    category: str
    room: str
    joint: str
    name: str
    body: int
    address: int
    slides: bool
    axis: Array
    anchor: Array
    travel: float
    front: Array
    up: Array
    holds: list[Hold]
    others: list[Hold]
    pushes: list[Hold]

    @property
    def lever(self) -> float:
        """Of a force at the handle about a hinge, m; 1 where the part slides."""
        apart = self.holds[0].point - self.anchor
        return 1.0 if self.slides else float(np.linalg.norm(np.cross(self.axis, apart)))

    def moved(self, value: float) -> tuple[Array, Array]:
        """Rotation (3, 3) and shift (3,) of the part from shut to a joint position: p → R p + t."""
        if self.slides:
            return np.eye(3), self.axis * value
        turn = rotation(self.axis, value)
        return turn, self.anchor - turn @ self.anchor

    def moves(self, values: Array) -> tuple[Array, Array]:
        """The same for many positions (n,): rotations (n, 3, 3) and shifts (n, 3)."""
        if self.slides:
            return np.broadcast_to(np.eye(3), (len(values), 3, 3)), values[:, None] * self.axis
        x, y, z = self.axis
        skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        c, s = np.cos(values)[:, None, None], np.sin(values)[:, None, None]
        turns = c * np.eye(3) + s * skew + (1 - c) * np.outer(self.axis, self.axis)
        return turns, self.anchor - turns @ self.anchor

    def at(self, point: Array, value: float) -> Array:
        """Where a point of the shut part is at a joint position."""
        turn, shift = self.moved(value)
        return np.asarray(turn @ point + shift)


def listed(world: World) -> list[tuple[Body, Link]]:
    """Everything that opens in an apartment: the link, and the object that it belongs to."""
    assert world.source is not None
    known = {joint.get("name") for joint in world.source.root.iter("joint")}
    return [(body, link) for body in world.bodies.values() if body.kind == "object"
            for link in body.links if link.joint is not None and body.joint_name(link.joint) in known]


def part(world: World, body: Body, link: Link) -> Part:
    """A link as it stands in a world in which it may move."""
    joint = link.joint
    assert joint is not None
    k = world.model.joint(body.joint_name(joint)).id
    pose = body.pose()
    turn = pose[:3, :3]
    axis = turn @ (np.asarray(joint.axis, float) / np.linalg.norm(joint.axis))
    travel = max(joint.range, key=abs)
    boxes = _boxes(link)
    handle = _handle(link, boxes)
    geoms = np.array([world.model.geom(f"{body.link_name(link)}__c{i}").id for i in range(len(link.colliders))], int)
    holds = [*_pinches(boxes, handle, pose, geoms), *_cups(link, boxes, handle, pose, geoms)]
    others = _aside(holds, link, boxes, pose)
    pushes = (_inside if joint.type == "slide" else _pushes)(link, boxes, handle, pose, geoms)
    return Part(
        body.id, body.category, body.room, joint.name, str(world.model.joint(k).name), int(world.model.jnt_bodyid[k]),
        int(world.model.jnt_qposadr[k]), joint.type == "slide", axis, turn @ np.asarray(joint.origin) + pose[:3, 3],
        float(travel), turn[:, 0], turn[:, 2], holds, others, pushes,
    )


Corners = NDArray[np.float64]
Index = NDArray[np.int64]


def _boxes(link: Link) -> Corners:
    """Least and greatest corners of the link's pieces in the object's frame, (k, 2, 3)."""
    pieces: list[Collider] = link.colliders
    points = [corners(c) for c in pieces] or [np.concatenate([mesh.vertices for mesh in link.visuals])]
    return np.array([[p.min(0), p.max(0)] for p in points])


def _handle(link: Link, boxes: Corners) -> Array:
    """Where the hand takes hold, object's frame: the handle, else the front's far edge."""
    if link.handle is not None:
        return np.asarray(link.handle, float)
    lo, hi = boxes[:, 0].min(0), boxes[:, 1].max(0)
    middle = np.array([hi[0], (lo[1] + hi[1]) / 2, (lo[2] + hi[2]) / 2])
    joint = link.joint
    if joint is None or joint.type == "slide":
        return middle
    across = int(np.argmin(np.abs(joint.axis[1:]))) + 1
    ends = np.array([lo[across] + EDGE, hi[across] - EDGE])
    middle[across] = ends[np.abs(ends - joint.origin[across]).argmax()]
    return middle


def _pinches(boxes: Corners, handle: Array, pose: Array, geoms: Index) -> list[Hold]:
    """Grasps with both fingers about the piece that the handle is on, narrowest first."""
    apart = np.linalg.norm(np.maximum(np.maximum(boxes[:, 0] - handle, handle - boxes[:, 1]), 0), axis=1)
    near = np.flatnonzero(apart <= OF_HANDLE)
    if not len(near):
        return []
    sizes = boxes[:, 1] - boxes[:, 0]
    small = [k for k in near if sizes[k].prod() < sizes.prod(1).max() / 4] or list(near)
    piece = np.array([boxes[small, 0].min(0), boxes[small, 1].max(0)])
    found = []
    for side in (1, 2):
        width = float(piece[1, side] - piece[0, side])
        if width / 2 + PLAY > OPENING:
            continue
        point = handle - [DEEP, 0, 0]
        point[side] = piece[:, side].mean()
        at, touched = pose[:3, :3] @ point + pose[:3, 3], tuple(geoms[small].tolist())
        found.append(Hold("pinch", at, pose[:3, side], pose[:3, 0], touched, width))
    return sorted(found, key=lambda hold: hold.width)


def _touch(kind: Kind, point: Array, pose: Array, geoms: Index, out: int = 0) -> Hold:
    """A hold on the face that looks along the object's axis `out`."""
    return Hold(kind, pose[:3, :3] @ point + pose[:3, 3], pose[:3, 1], pose[:3, out], tuple(geoms.tolist()))


def _cups(link: Link, boxes: Corners, handle: Array, pose: Array, geoms: Index) -> list[Hold]:
    """The cup on the front, before that on the top of what is lifted, some way in from its edge."""
    front = _touch("cup", handle, pose, geoms)
    assert link.joint is not None
    lift = np.cross(link.joint.axis, handle - np.asarray(link.joint.origin))
    if link.joint.type == "slide" or lift[2] < 0.7 * np.linalg.norm(lift):
        return [front]
    point = handle - [LIP, 0, 0]
    inside = ((boxes[:, 0, :2] <= point[:2]) & (point[:2] <= boxes[:, 1, :2])).all(1)
    if not inside.any():
        return [front]
    point[2] = boxes[inside, 1, 2].max()
    return [_touch("cup", point, pose, geoms, out=2), front]


def _pushes(link: Link, boxes: Corners, handle: Array, pose: Array, geoms: Index) -> list[Hold]:
    """Where the back of a hinged leaf is pushed: near its free edge, at the handle's place along the axis."""
    assert link.joint is not None
    axis = np.asarray(link.joint.axis, float)
    panel = boxes[int((boxes[:, 1] - boxes[:, 0]).prod(1).argmax())]
    across = int(np.argmin(np.abs(axis[1:]))) + 1
    outward = np.sign(handle[across] - link.joint.origin[across])
    if abs(axis[0]) > 0.5 or abs(axis[across]) > 0.5 or outward == 0:
        return []
    point = np.clip(handle, panel[0] + EDGE, np.maximum(panel[1] - EDGE, panel[0] + EDGE))
    edge = panel[1, across] if outward > 0 else panel[0, across]
    point[across] = edge - outward * EDGE
    inside = ((boxes[:, 0, 1:] <= point[1:]) & (point[1:] <= boxes[:, 1, 1:])).all(1)
    point[0] = boxes[inside, 0, 0].min() if inside.any() else panel[0, 0]
    return [_touch("push", point, pose, geoms)]


def _inside(link: Link, boxes: Corners, handle: Array, pose: Array, geoms: Index) -> list[Hold]:
    """Where the back of a drawer's front is pushed, from above into the open drawer: below its upper edge."""
    assert link.joint is not None
    if link.joint.axis[0] < 0.9:
        return []
    sizes = boxes[:, 1] - boxes[:, 0]
    panel = boxes[int(sizes[:, 1:].prod(1).argmax())]
    # Fronts are screwed to the box: what lies flat behind the panel belongs to it.
    flat = (sizes[:, 0] < BOARD) & (sizes[:, 1:] > BOARD).all(1) & (boxes[:, 0, 0] <= panel[0, 0])
    boards = boxes[flat & (boxes[:, 1, 0] >= panel[0, 0] - OF_HANDLE)]
    if not len(boards):
        return []
    point = np.array([boards[:, 0, 0].min(), panel[:, 1].mean(), boards[:, 1, 2].min() - RIM])
    return [_touch("push", point, pose, geoms)]


def _aside(holds: list[Hold], link: Link, boxes: Corners, pose: Array) -> list[Hold]:
    """The same holds elsewhere: along a long bar, and across a front that slides and has nothing to grip."""
    assert link.joint is not None
    found = []
    up, across = pose[:3, 2], pose[:3, 1]
    lo, hi = boxes[:, 0].min(0), boxes[:, 1].max(0)
    for hold in holds:
        local = pose[:3, :3].T @ (hold.point - pose[:3, 3])
        side, way = (2, up) if abs(float(hold.across @ across)) > 0.5 and hold.kind == "pinch" else (1, across)
        if hold.kind == "cup" and link.joint.type != "slide":
            continue
        ends = np.array([lo[side], hi[side]])
        if hold.kind == "pinch":
            near = (np.abs(np.clip(local, boxes[:, 0], boxes[:, 1]) - local) <= OF_HANDLE).all(1)
            bar = boxes[near][(boxes[near, 1] - boxes[near, 0]).prod(1).argmin()] if near.any() else boxes[0]
            ends = bar[:, side]
        for share in SHARES:
            at = ends[0] + share * (ends[1] - ends[0])
            if abs(at - local[side]) > APART:
                found.append(replace(hold, point=hold.point + (at - local[side]) * way))
    return found
