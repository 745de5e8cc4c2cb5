"""A rigid thing of the world with its links: what furniture and the building's shell look like to an exporter.

World frame: metres, z up, yaw counter-clockwise. Links' geometry is given in the body's frame, all joints at zero.
"""

from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.retrieve import Joint
from apartgen.stages.things import mechanisms
from apartgen.stages.things.asset import UNTURNED, Collider, Link
from apartgen.stages.things.mechanisms import Motion

Array = NDArray[np.float64]
Ranges = tuple[tuple[float, float], ...]
Kind = Literal["object", "wall", "lining", "floor", "ceiling", "trim", "door", "window"]

LEAST_MASS = 0.01
"""Engines reject links lighter than this, kg."""


@dataclass(frozen=True, slots=True)
class Body:
    """Links at a pose. `name` is unique and an identifier in every format; the first link is the base.

    A `free` body may be pushed about, any other is fixed to the world by its base. `room` is empty for what
    belongs to no single room. `id` is the artifact's id of the object, opening or room; `model` names the asset;
    `within` names bodies that it stands partly in, with which it must not collide; `motions` are of those of its links
    that move otherwise than is usual. `says` is what the artifact says of it: affordances, state, switches.
    """

    name: str
    kind: Kind
    category: str
    room: str
    position: Array
    yaw: float
    links: list[Link]
    free: bool = False
    id: str = ""
    model: str = ""
    within: tuple[str, ...] = ()
    motions: dict[str, Motion] = field(default_factory=dict)
    says: dict[str, Any] = field(default_factory=dict)

    def link_name(self, link: Link) -> str:
        """Unique name of one of its links; the base carries the body's own."""
        return self.name if link is self.links[0] else f"{self.name}__{link.name}"

    def joint_name(self, joint: Joint) -> str:
        """Unique name of one of its joints."""
        return f"{self.name}__{joint.name}__joint"

    def motion(self, link: Link) -> Motion:
        """How one of its moving links moves."""
        return self.motions.get(link.name) or mechanisms.motion(self.category, link)

    def opened(self, joint: Joint) -> float:
        """Where one of its joints stands at first: as its state says, else shut."""
        share = float(self.says.get("state", {}).get(f"open.{joint.name}", 0.0))
        shut, wide = sorted(joint.range, key=abs)
        return shut + share * (wide - shut)

    @property
    def ranges(self) -> Ranges:
        """How far each part opens; things of one model may differ in it."""
        return tuple(link.joint.range for link in self.links if link.joint is not None)

    @property
    def physics(self) -> tuple[Any, ...]:
        """What its links weigh, how they rub and move; things of one model may differ in it, where it was drawn."""
        return tuple((link.mass, link.friction, self.motions.get(link.name)) for link in self.links)

    def pose(self) -> Array:
        """Body frame to world, (4, 4)."""
        c, s = np.cos(self.yaw), np.sin(self.yaw)
        return np.array(
            [[c, -s, 0, self.position[0]], [s, c, 0, self.position[1]], [0, 0, 1, self.position[2]], [0, 0, 0, 1]]
        )


@dataclass(frozen=True, slots=True)
class Light:
    """A lamp's light: where it is (world) and how much it gives, lumens."""

    name: str
    room: str
    position: Array
    lumens: float = 800.0


class Inertia(NamedTuple):
    """Mass in kg, centre of mass (3,), and inertia about it (3, 3), along the body's axes."""

    mass: float
    center: Array
    tensor: Array


def mass(link: Link) -> float:
    """Mass of a link, kg."""
    return max(link.mass, LEAST_MASS)


def inertia(link: Link) -> Inertia:
    """Mass properties of a link of even density over its colliders (overlaps count twice)."""
    parts = [_solid(c) for c in link.colliders] or [_visual_solid(link)]
    volumes, centers, units = (np.array([part[k] for part in parts]) for k in range(3))
    shares = volumes / volumes.sum()
    whole = mass(link)
    center = (shares[:, None] * centers).sum(0)
    arms = centers - center
    squares = np.array([arm @ arm for arm in arms])[:, None, None]
    moved = units + squares * np.eye(3) - arms[:, :, None] * arms[:, None]
    tensor = ((whole * shares)[:, None, None] * moved).sum(0)
    # A sheet has next to none about some axis, which solvers can't divide by.
    return Inertia(whole, center, tensor + whole * 1e-5 * np.eye(3))


def counterbalanced(link: Link, found: Inertia | None = None) -> bool:
    """Whether a spring must carry the part's weight, as in an oven door, because gravity alone would open it.

    `found` is its inertia where that is known already.
    A flap whose weight lies behind its hinge falls open only once it stands ajar, so half way is looked at, too.
    """
    joint = link.joint
    if joint is None:
        return False
    axis = np.asarray(joint.axis, float) / np.linalg.norm(joint.axis)
    if joint.type == "slide":
        return bool(axis[2] < -0.01)
    arm = (found or inertia(link)).center - np.asarray(joint.origin, float)
    half = max(joint.range, key=abs) / 2
    ajar = arm * np.cos(half) + np.cross(axis, arm) * np.sin(half)
    return any(bool(np.cross(lever, [0.0, 0.0, -1.0]) @ axis > 1e-6) for lever in (arm, ajar))


def _visual_solid(link: Link) -> tuple[float, Array, Array]:
    points = np.concatenate([mesh.vertices for mesh in link.visuals])
    lo, hi = points.min(0), points.max(0)
    return _solid(Collider("box", (lo + hi) / 2, np.maximum(hi - lo, 1e-3)))


def _solid(c: Collider) -> tuple[float, Array, Array]:
    """Volume, centroid in the body's frame, inertia per kg about the centroid along the body's axes."""
    x, y, z = (float(v) for v in c.size)
    if c.kind == "hull":
        return _hull(c)
    if c.kind == "box":
        volume, unit = x * y * z, np.array([y * y + z * z, x * x + z * z, x * x + y * y]) / 12
    elif c.kind == "cylinder":
        volume, across = np.pi * x * x * z, (3 * x * x + z * z) / 12
        unit = np.array([across, across, x * x / 2])
    else:
        volume, unit = 4 / 3 * np.pi * x**3, np.full(3, 0.4 * x * x)
    tensor = np.diag(unit) if c.rotation is UNTURNED else c.rotation @ np.diag(unit) @ c.rotation.T
    return float(volume), np.asarray(c.center, float), tensor


def _hull(c: Collider) -> tuple[float, Array, Array]:
    """Exact for the convex hull: signed tetrahedra from its middle."""
    from scipy.spatial import ConvexHull

    assert c.vertices is not None
    points = (c.vertices if c.rotation is UNTURNED else c.vertices @ c.rotation.T) + c.center
    hull = ConvexHull(points)
    middle = np.add.reduce(points) / len(points)
    corners = points[hull.simplices] - middle
    volumes = np.abs(np.linalg.det(corners)) / 6
    total, summed = float(volumes.sum()), corners.sum(1)
    shift = np.einsum("t,tk->k", volumes, summed) / (4 * total)
    # Second moments of a tetrahedron with one corner at the origin: (Σ p)(Σ p)ᵀ + Σ p pᵀ over 20.
    moment = np.einsum("t,ti,tj->ij", volumes, summed, summed) + np.einsum("t,tki,tkj->ij", volumes, corners, corners)
    moment = moment / (20 * total) - np.outer(shift, shift)
    return total, middle + shift, np.trace(moment) * UNTURNED - moment
