"""The neutral description of a 3D asset that libraries make, and exporters, metrics and the walkable stage read.

An asset's frame has its origin at the centre of its box, +x to its front, +y to its left, +z up; metres.
Links form a flat tree: the first is the fixed base, every other moves against it by one joint. Geometry of
every link is given in the asset's frame with all joints at zero.
"""

from dataclasses import dataclass, field, replace
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.retrieve import Joint

Array = NDArray[np.float64]
UNTURNED: Array = np.eye(3)
"""The rotation of what is not turned, one for all, so that it is known at a glance."""
UNTURNED.setflags(write=False)


@dataclass(frozen=True, slots=True)
class Material:
    """Physically based surface; `texture` names a procedural texture or an image file of the library.

    What has `emission` gives off so much of its colour.
    """

    name: str
    color: tuple[float, float, float, float] = (0.8, 0.8, 0.8, 1.0)
    roughness: float = 0.7
    metalness: float = 0.0
    texture: str | None = None
    emission: float = 0.0


@dataclass(frozen=True, slots=True)
class Mesh:
    """A watertight visual piece of one material: `vertices` (n, 3), `faces` (m, 3) outward, `uv` (n, 2)."""

    vertices: Array
    faces: NDArray[np.int64]
    material: Material
    uv: Array | None = None


@dataclass(frozen=True, slots=True)
class Collider:
    """A convex collision piece.

    box: `size` full extents · cylinder: [radius, radius, length], axis local z · sphere: [radius] × 3 ·
    hull: the convex hull of `vertices` (n, 3), relative to `center`. `rotation` is 3 × 3, local to asset.
    """

    kind: Literal["box", "cylinder", "sphere", "hull"]
    center: Array
    size: Array
    rotation: Array = field(default_factory=lambda: UNTURNED)
    vertices: Array | None = None


@dataclass(frozen=True, slots=True)
class Link:
    """One rigid part. `joint` is None for the base; `handle` is where a gripper takes hold, asset frame.

    `grip` is the handle's GAPartNet class (line_fixed_handle, round_fixed_handle), empty for a bare edge.
    """

    name: str
    visuals: list[Mesh]
    colliders: list[Collider]
    mass: float
    joint: Joint | None = None
    handle: Array | None = None
    friction: float = 0.6
    grip: str = ""


@dataclass(frozen=True, slots=True)
class Asset:
    """A model with everything needed to place, simulate and credit it; `size` is [depth, width, height].

    `roles` are the materials of a kitchen unit's fronts, worktop and handles, which all units of a kitchen share.
    """

    library: str
    id: str
    category: str
    style: str
    size: tuple[float, float, float]
    links: list[Link]
    latent: Array = field(default_factory=lambda: np.zeros(32))
    credit: str = ""
    roles: tuple[str, ...] = ()

    @property
    def joints(self) -> list[Joint]:
        """The joints of all moving links, in link order."""
        return [link.joint for link in self.links if link.joint is not None]

    def named(self, library: str, id: str) -> "Asset":
        """The same model under another key."""
        return replace(self, library=library, id=id)


class Library(Protocol):
    """A collection of assets addressed by id."""

    def load_asset(self, id: str) -> Asset:
        """The asset of that id; BadInput when there is none."""

    def nearest(
        self, category: str, size: Array, latent: Array, limit: Array | None = None
    ) -> Asset | None:
        """The asset closest in size (m) and shape latent (32), none of its sides above `limit`; None if none fits."""
