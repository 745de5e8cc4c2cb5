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
    """`corners`, `normals` (n, 3, 3), `uv` (n, 3, 2), `material` (n,) into `materials`, `owner` (n,) into bodies."""

    corners: Array
    normals: Array
    uv: Array
    material: Index
    materials: list[Material]
    owner: Index


class Hits(NamedTuple):
    """Where rays first meet a triangle: index or -1, distance, weights of its corners (n, 3)."""

    triangle: Index
    distance: Array
    weights: Array


def soup(bodies: Iterable[Body]) -> Soup:
    """Triangles of all visuals, at rest."""
    index: dict[Material, int] = {}
    parts: list[tuple[Array, Array, Array, Index, Index]] = []
    for k, body in enumerate(bodies):
        turn, shift = body.pose()[:3, :3], body.position
        for piece in (piece for link in body.links for piece in pieces(link)):
            vertices, normals, uv, faces = shaded(piece)
            material = index.setdefault(piece.material, len(index))
            flat = np.zeros((*faces.shape, 2)) if uv is None else uv[faces]
            corners = (vertices @ turn.T + shift)[faces]
            n = len(faces)
            parts.append((corners, (normals @ turn.T)[faces], flat, np.full(n, material), np.full(n, k)))
    corners, normals, uv, which, owner = (np.concatenate(column) for column in zip(*parts, strict=True))
    single = np.float32
    return Soup(corners.astype(single), normals.astype(single), uv.astype(single), which, list(index), owner)


def split(all_: Soup, mask: NDArray[np.bool_]) -> tuple[Soup, Soup]:
    """The triangles that are masked, and the others."""
    one, other = (
        Soup(all_.corners[m], all_.normals[m], all_.uv[m], all_.material[m], all_.materials, all_.owner[m])
        for m in (mask, ~mask)
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

    def free(self, origin: Array, direction: Array, far: float | None = None) -> Array:
        """1 where a ray meets nothing, 0 where it does; up to `far` times its direction if given."""
        if self.empty:
            return np.ones(len(direction), np.float32)
        ends = None if far is None else np.full(len(direction), far, np.float32)
        ray = np.ascontiguousarray(origin), np.ascontiguousarray(direction)
        found = self._scene.run(*ray, dists=ends, query="OCCLUDED")
        return np.asarray(found != 0, np.float32)


def colors(hits: Hits, of: Soup, width: Array | None = None) -> tuple[Array, Array]:
    """Linear colour (n, 3) and shading normal (n, 3) where rays hit; every ray must have hit.

    Textures are averaged over the `width` (n,) that a ray stands for, m.
    """
    triangle = hits.triangle
    normal = np.einsum("nk,nkd->nd", hits.weights, of.normals[triangle])
    normal /= length(normal)
    uv = np.einsum("nk,nkd->nd", hits.weights, of.uv[triangle])
    which = of.material[triangle]
    color = linear(np.array([m.color[:3] for m in of.materials], np.float32))[which]
    for k, material in enumerate(of.materials):
        if material.texture:
            rows = np.flatnonzero(which == k)
            levels = _levels(material.texture)
            texels = None if width is None else width[rows] * _repeats(of, triangle[rows]) * len(levels[0])
            color[rows] = _looked_up(levels, uv[rows], texels)
    return color, normal


def _repeats(of: Soup, triangle: Index) -> Array:
    """Repeats of the texture along a metre of triangles."""
    corners, uv = of.corners[triangle], of.uv[triangle]
    sides, turns = corners[:, 1:] - corners[:, :1], uv[:, 1:] - uv[:, :1]
    area = length(np.cross(sides[:, 0], sides[:, 1]))[:, 0]
    covered = np.abs(turns[:, 0, 0] * turns[:, 1, 1] - turns[:, 0, 1] * turns[:, 1, 0])
    return np.asarray(np.sqrt(covered / area))


def _looked_up(levels: list[Array], uv: Array, texels: Array | None) -> Array:
    """Colours (n, 3) at places of a texture, from the level whose texels are as wide as so many of the finest."""
    if texels is None:
        return np.asarray(levels[0][_texel(uv, len(levels[0]))])
    level = np.log2(texels.clip(1)).round().astype(np.int64).clip(0, len(levels) - 1)
    found = np.empty((len(uv), 3), np.float32)
    for k in np.unique(level):
        rows = np.flatnonzero(level == k)
        found[rows] = levels[k][_texel(uv[rows], len(levels[k]))]
    return found


@lru_cache(maxsize=256)
def _levels(texture: str) -> list[Array]:
    """A texture, and the same at half its size again and again."""
    found = [_texels(texture)]
    while len(found[-1]) > 1 and len(found[-1]) % 2 == 0:
        n = len(found[-1]) // 2
        found.append(found[-1].reshape(n, 2, n, 2, 3).mean((1, 3)).astype(np.float32))
    return found


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
