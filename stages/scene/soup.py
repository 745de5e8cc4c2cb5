"""All visible triangles of bodies in world coordinates, with what shading needs, ready for ray queries."""

import io
from collections.abc import Iterable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.scene.pieces import image, pieces, shaded
from apartgen.stages.things import materials
from apartgen.stages.things.asset import Material
from apartgen.stages.things.body import Body

Array = NDArray[Any]
"""Floats of single precision, which is all that light needs."""
Index = NDArray[np.int64]


class Soup(NamedTuple):
    """`corners`, `normals` (n, 3, 3), `uv` (n, 3, 2), `material` (n,) into `materials`, `owner` (n,) into bodies,
    `repeats` (n,) of a triangle's texture along a metre.
    """

    corners: Array
    normals: Array
    uv: Array
    material: Index
    materials: list[Material]
    owner: Index
    repeats: Array


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
    return Soup(corners.astype(single), normals.astype(single), uv.astype(single), which, list(index), owner,
                _repeats(corners, uv))


def split(all_: Soup, mask: NDArray[np.bool_]) -> tuple[Soup, Soup]:
    """The triangles that are masked, and the others."""
    one, other = (
        Soup(all_.corners[m], all_.normals[m], all_.uv[m], all_.material[m], all_.materials, all_.owner[m],
             all_.repeats[m])
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
        found = self._scene.run(origin, np.ascontiguousarray(direction), output=True)
        u, v, hit = found["u"], found["v"], found["primID"].astype(np.int64)
        distance = np.where(hit >= 0, found["tfar"], np.float32(np.inf))
        return Hits(hit, distance, np.stack([1 - u - v, u, v], -1))

    def free(self, origin: Array, direction: Array, far: float | None = None) -> Array:
        """1 where a ray meets nothing, 0 where it does; up to `far` times its direction if given."""
        if self.empty:
            return np.ones(len(direction), np.float32)
        ends = None if far is None else np.full(len(direction), far, np.float32)
        found = self._scene.run(origin, np.ascontiguousarray(direction), dists=ends, query="OCCLUDED")
        return np.asarray(found != 0, np.float32)


def colors(hits: Hits, of: Soup, angle: float = 0.0) -> tuple[Array, Array]:
    """Linear colour (n, 3) and shading normal (n, 3) where rays hit, zeros where they did not.

    Textures are averaged over the `angle` that a ray stands for, rad.
    """
    from apartgen.stages.scene.kernels import painted

    flat = linear(np.array([m.color[:3] for m in of.materials], np.float32).reshape(-1, 3)).astype(np.float32)
    textures, texels = _painting(tuple(m.texture for m in of.materials))
    color, normal = painted(hits.triangle, np.ascontiguousarray(hits.weights, np.float32), hits.distance, angle,
                            of.normals, of.uv, of.material, flat, textures, texels, of.repeats)
    return color, normal


def _repeats(corners: Array, uv: Array) -> Array:
    """Repeats of the texture along a metre of triangles."""
    sides, turns = corners[:, 1:] - corners[:, :1], uv[:, 1:] - uv[:, :1]
    area = length(np.cross(sides[:, 0], sides[:, 1]))[:, 0]
    covered = np.abs(turns[:, 0, 0] * turns[:, 1, 1] - turns[:, 0, 1] * turns[:, 1, 0])
    return np.asarray(np.sqrt(covered / area), np.float32)


@lru_cache(maxsize=4)
def _painting(names: tuple[str | None, ...]) -> tuple[Index, Array]:
    """For each texture where its texels begin and how wide it is, and the texels of all at all their levels."""
    places, parts, start = np.zeros((len(names), 2), np.int64), [np.zeros((0, 3), np.uint16)], 0
    for k, texture in enumerate(names):
        if texture:
            levels = _levels(texture)
            places[k] = start, len(levels[0])
            parts += [level.reshape(-1, 3) for level in levels]
            start += sum(len(level) ** 2 for level in levels)
    return places, np.concatenate(parts)


@lru_cache(maxsize=256)
def _levels(texture: str) -> list[Array]:
    """A texture, and the same at half its size again and again, in 65535ths of linear light."""
    image = _image(texture)
    found, fine = [_whole_bytes()[image]], _linear_bytes()[image]
    while len(fine) > 1 and len(fine) % 2 == 0:
        four = fine[::2, ::2] + fine[::2, 1::2]
        four += fine[1::2, ::2]
        four += fine[1::2, 1::2]
        fine = np.divide(four, np.float32(4), out=four)
        found.append(np.rint(fine * 65535).astype(np.uint16))
    return found


def _image(texture: str) -> NDArray[np.uint8]:
    """A texture, square, (size, size, 3)."""
    if texture in materials.textures():
        return materials.texture(texture)
    from PIL import Image

    picture = Image.open(io.BytesIO(image(texture))).convert("RGB")
    size = min(picture.size)
    return np.asarray(picture.resize((size, size)))


def length(vectors: Array) -> Array:
    """Lengths (n, 1), never zero."""
    return np.asarray(np.sqrt(np.einsum("nd,nd->n", vectors, vectors))[:, None].clip(1e-9))


def linear(srgb: Array) -> Array:
    """sRGB in [0, 1] to linear light."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def byted(light: Array) -> NDArray[np.uint8]:
    """Linear light to sRGB bytes."""
    found: NDArray[np.uint8] = _bytes()[(light.clip(0, 1) * np.float32(65535) + np.float32(0.5)).astype(np.uint16)]
    return found


@lru_cache(maxsize=1)
def _linear_bytes() -> Array:
    """Linear light of every byte of sRGB."""
    return linear(np.arange(256, dtype=np.float32) / 255).astype(np.float32)


@lru_cache(maxsize=1)
def _whole_bytes() -> NDArray[np.uint16]:
    """The same in 65535ths."""
    return np.asarray(np.rint(_linear_bytes() * 65535), np.uint16)


@lru_cache(maxsize=1)
def _bytes() -> NDArray[np.uint8]:
    return np.asarray(np.rint(encoded(np.arange(65536) / 65535) * 255), np.uint8)


def encoded(light: Array) -> Array:
    """Linear light to sRGB in [0, 1]."""
    light = light.clip(0, 1)
    return np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
