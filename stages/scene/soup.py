"""All visible triangles of bodies in world coordinates, with what shading needs, ready for ray queries."""

import io
from collections.abc import Iterable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.pieces import image, pieces, shaded
from apartgen.stages.things.asset import Material
from apartgen.stages.things.body import Body

Array = NDArray[Any]
"""Floats of single precision, which is all that light needs."""
Index = NDArray[np.int64]


class Soup(NamedTuple):
    """`corners`, `normals` (n, 3, 3), `uv` (n, 3, 2), `material` (n,) into `materials`."""

    corners: Array
    normals: Array
    uv: Array
    material: Index
    materials: list[Material]


class Hits(NamedTuple):
    """Where rays first meet a triangle: index or -1, distance, weights of its corners (n, 3)."""

    triangle: Index
    distance: Array
    weights: Array


def soup(bodies: Iterable[Body]) -> Soup:
    """Triangles of all visuals, at rest."""
    index: dict[Material, int] = {}
    parts: list[tuple[Array, Array, Array, Index]] = []
    for body in bodies:
        turn, shift = body.pose()[:3, :3], body.position
        for piece in (piece for link in body.links for piece in pieces(link)):
            vertices, normals, uv, faces = shaded(piece)
            material = index.setdefault(piece.material, len(index))
            flat = np.zeros((*faces.shape, 2)) if uv is None else uv[faces]
            corners = (vertices @ turn.T + shift)[faces]
            parts.append((corners, (normals @ turn.T)[faces], flat, np.full(len(faces), material)))
    corners, normals, uv, which = (np.concatenate(column) for column in zip(*parts, strict=True))
    single = np.float32
    return Soup(corners.astype(single), normals.astype(single), uv.astype(single), which, list(index))


def split(all_: Soup, mask: NDArray[np.bool_]) -> tuple[Soup, Soup]:
    """The triangles that are masked, and the others."""
    one, other = (
        Soup(all_.corners[m], all_.normals[m], all_.uv[m], all_.material[m], all_.materials) for m in (mask, ~mask)
    )
    return one, other


class Tracer:
    """Ray queries against a soup, by Embree."""

    def __init__(self, triangles: Soup) -> None:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene

        self.soup = triangles
        self.empty = len(triangles.corners) == 0
        if not self.empty:
            self._scene = EmbreeScene()
            TriangleMesh(self._scene, np.ascontiguousarray(triangles.corners))

    def first(self, origin: Array, direction: Array) -> Hits:
        """What rays (n, 3) meet first."""
        if self.empty:
            n = len(direction)
            return Hits(np.full(n, -1), np.full(n, np.inf, np.float32), np.zeros((n, 3), np.float32))
        found = self._scene.run(np.ascontiguousarray(origin), np.ascontiguousarray(direction), output=True)
        u, v, hit = found["u"], found["v"], found["primID"].astype(np.int64)
        distance = np.where(hit >= 0, found["tfar"], np.float32(np.inf))
        return Hits(hit, distance, np.stack([1 - u - v, u, v], -1))

    def free(self, origin: Array, direction: Array) -> Array:
        """1 where a ray meets nothing, 0 where it does."""
        if self.empty:
            return np.ones(len(direction), np.float32)
        found = self._scene.run(np.ascontiguousarray(origin), np.ascontiguousarray(direction), query="OCCLUDED")
        return np.asarray(found != 0, np.float32)


def colors(hits: Hits, of: Soup) -> tuple[Array, Array]:
    """Linear colour (n, 3) and shading normal (n, 3) where rays hit; every ray must have hit."""
    triangle = hits.triangle
    normal = np.einsum("nk,nkd->nd", hits.weights, of.normals[triangle])
    normal /= length(normal)
    uv = np.einsum("nk,nkd->nd", hits.weights, of.uv[triangle])
    which = of.material[triangle]
    color = linear(np.array([m.color[:3] for m in of.materials], np.float32))[which]
    for k, material in enumerate(of.materials):
        if material.texture:
            rows = np.flatnonzero(which == k)
            color[rows] = _texels(material.texture)[_texel(uv[rows], len(_texels(material.texture)))]
    return color, normal


@lru_cache(maxsize=256)
def _texels(texture: str) -> Array:
    """A texture as linear light, square, (size, size, 3)."""
    from PIL import Image

    picture = Image.open(io.BytesIO(image(texture))).convert("RGB")
    size = min(picture.size)
    return linear(np.asarray(picture.resize((size, size)), np.float32) / 255)


def _texel(uv: Array, size: int) -> tuple[Index, Index]:
    """Row and column of the nearest texel, repeated, v up."""
    x = (uv[:, 0] % 1 * size).astype(np.int64).clip(0, size - 1)
    y = ((1 - uv[:, 1]) % 1 * size).astype(np.int64).clip(0, size - 1)
    return y, x


def length(vectors: Array) -> Array:
    """Lengths (n, 1), never zero."""
    return np.asarray(np.sqrt(np.einsum("nd,nd->n", vectors, vectors))[:, None].clip(1e-9))


def linear(srgb: Array) -> Array:
    """sRGB in [0, 1] to linear light."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def encoded(light: Array) -> Array:
    """Linear light to sRGB in [0, 1]."""
    light = light.clip(0, 1)
    return np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
