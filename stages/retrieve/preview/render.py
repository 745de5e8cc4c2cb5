"""Pictures of assets by a small software renderer: depth buffer, one shadow, textures, smooth shading."""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.asset import Array, Asset, Link, Material
from apartgen.stages.things.materials import pixels
from apartgen.stages.things.shading import corner_normals

_SUN = np.array([0.72, -0.1, 0.9]) / np.linalg.norm([0.72, -0.1, 0.9])
_GROUND = 0.93


class Soup(NamedTuple):
    """Triangles of a scene: corners, corner normals and texture coordinates (t, 3, …); `material` (t,) numbers them."""

    points: Array
    normals: Array
    uv: Array
    material: NDArray[np.int64]
    materials: list[Material]


def opened(asset: Asset, share: float) -> Soup:
    """The asset's triangles with every joint at this share of its range, standing on z = 0."""
    parts = []
    used: dict[Material, int] = {}
    for link in asset.links:
        for mesh in link.visuals:
            points, normals = mesh.vertices[mesh.faces], corner_normals(mesh).reshape(-1, 3, 3)
            points, normals = _moved(link, points, normals, share)
            uv = np.zeros((*mesh.faces.shape, 2)) if mesh.uv is None else mesh.uv[mesh.faces]
            which = np.full(len(mesh.faces), used.setdefault(mesh.material, len(used)))
            parts.append((points + [0, 0, asset.size[2] / 2], normals, uv, which))
    points, normals, uvs, which = (np.concatenate(group) for group in zip(*parts, strict=True))
    return Soup(points, normals, uvs, which, list(used))


def _moved(link: Link, points: Array, normals: Array, share: float) -> tuple[Array, Array]:
    joint = link.joint
    if joint is None or share == 0:
        return points, normals
    value = joint.range[0] + share * (joint.range[1] - joint.range[0])
    if joint.type == "slide":
        return points + value * np.asarray(joint.axis), normals
    turn = rotation(joint, value)
    origin = np.asarray(joint.origin)
    return (points - origin) @ turn.T + origin, normals @ turn.T


def rotation(joint: Joint, angle: float) -> Array:
    """Rodrigues' matrix about the joint's axis (3, 3)."""
    x, y, z = np.asarray(joint.axis) / np.linalg.norm(joint.axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k)


@njit(cache=True)
def _raster(screen, depth, owner, weight):  # type: ignore[no-untyped-def]  # pragma: no cover
    """Nearest triangle of every pixel and the pixel's barycentric weights in it; screen is (t, 3, 3) in pixels."""
    height, width = depth.shape
    for t in range(screen.shape[0]):
        (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = screen[t]
        area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if abs(area) < 1e-12:
            continue
        for row in range(max(0, int(min(y0, y1, y2))), min(height - 1, int(max(y0, y1, y2)) + 1) + 1):
            for col in range(max(0, int(min(x0, x1, x2))), min(width - 1, int(max(x0, x1, x2)) + 1) + 1):
                x, y = col + 0.5, row + 0.5
                b = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area
                c = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area
                if b < 0 or c < 0 or b + c > 1:
                    continue
                z = z0 + b * (z1 - z0) + c * (z2 - z0)
                if z < depth[row, col]:
                    depth[row, col], owner[row, col] = z, t
                    weight[row, col, 0], weight[row, col, 1], weight[row, col, 2] = 1 - b - c, b, c


def _view(toward: Array) -> Array:
    """Camera axes (3, 3) as rows: right, up, away from the eye, for an eye that looks from `toward`."""
    away = -toward / np.linalg.norm(toward)
    right = np.cross(away, [0, 0, 1.0])
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(right, away), away])


class _Frame(NamedTuple):
    depth: Array
    owner: NDArray[np.int64]
    weight: Array


def _drawn(points: Array, size: tuple[int, int]) -> _Frame:
    h, w = size
    frame = _Frame(np.full((h, w), np.inf), np.full((h, w), -1), np.zeros((h, w, 3)))
    _raster(np.ascontiguousarray(points), *frame)
    return frame


def picture(
    soup: Soup, size: int = 160, toward: tuple[float, float, float] = (1.0, -0.62, 0.62), fit: Array | None = None
) -> NDArray[np.uint8]:
    """A square picture (size, size, 3) seen from `toward` without perspective; `fit` (n, 3) is what must be in view."""
    axes, fine = _view(np.array(toward)), 2 * size
    flat = (soup.points.reshape(-1, 3) if fit is None else fit) @ axes.T
    lo, hi = flat.min(0), flat.max(0)
    scale = 0.9 * fine / max(hi[0] - lo[0], hi[1] - lo[1])
    middle = (lo + hi) / 2

    def project(points: Array) -> Array:
        p = points @ axes.T
        return np.stack(
            [fine / 2 + (p[..., 0] - middle[0]) * scale, fine / 2 - (p[..., 1] - middle[1]) * scale, p[..., 2]], -1
        )

    floor = _floor(soup)
    alpha = np.array([material.color[3] for material in soup.materials])[soup.material]
    clear = alpha < 0.7
    light = _Light(soup.points[~clear])
    back = _drawn(project(np.concatenate([soup.points[~clear], floor])), (fine, fine))
    solid = Soup(
        np.concatenate([soup.points[~clear], floor]),
        np.concatenate([soup.normals[~clear], np.full_like(floor, [0, 0, 1])]),
        np.concatenate([soup.uv[~clear], floor[..., :2]]),
        np.append(soup.material[~clear], [-1, -1]),
        soup.materials,
    )
    image = _shaded(solid, back, light, axes, scale)
    if clear.any():
        panes = Soup(soup.points[clear], soup.normals[clear], soup.uv[clear], soup.material[clear], soup.materials)
        front = _drawn(project(panes.points), (fine, fine))
        seen = (front.owner >= 0) & (front.depth < back.depth)
        glass = _shaded(panes, front, light, axes, scale)
        image = np.where(seen[..., None], image + (glass - image) * alpha[clear][front.owner][..., None], image)
    small = image.reshape(size, 2, size, 2, 3).mean((1, 3))
    return np.asarray(np.clip(small, 0, 1) ** (1 / 2.2) * 255 + 0.5, np.uint8)


def _floor(soup: Soup) -> Array:
    reach = 20 * max(1.0, float(np.ptp(soup.points.reshape(-1, 3), axis=0).max()))
    low = min(0.0, float(soup.points[..., 2].min())) - 1e-4
    a, b, c, d = (np.array([x * reach, y * reach, low]) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    return np.array([[a, b, c], [a, c, d]])


class _Light:
    """A shadow map of the sun."""

    def __init__(self, points: Array, size: int = 512) -> None:
        self.axes = _view(_SUN)
        flat = points.reshape(-1, 3) @ self.axes.T
        self.lo, hi = flat.min(0), flat.max(0)
        self.scale, self.size = (size - 8) / max(hi[0] - self.lo[0], hi[1] - self.lo[1]), size
        p = points @ self.axes.T
        screen = np.stack(
            [4 + (p[..., 0] - self.lo[0]) * self.scale, 4 + (p[..., 1] - self.lo[1]) * self.scale, p[..., 2]], -1
        )
        self.depth = _drawn(screen, (size, size)).depth

    def falls_on(self, points: Array) -> Array:
        """Share of sunlight at points (…, 3), softened over a few texels."""
        p = points @ self.axes.T
        lit = np.zeros(points.shape[:-1])
        for dx in (-2, -0.7, 0.7, 2):
            for dy in (-2, -0.7, 0.7, 2):
                col = np.clip(4 + (p[..., 0] - self.lo[0]) * self.scale + dx, 0, self.size - 1).astype(int)
                row = np.clip(4 + (p[..., 1] - self.lo[1]) * self.scale + dy, 0, self.size - 1).astype(int)
                lit += p[..., 2] < self.depth[row, col] + 4.0 / self.scale
        return lit / 16


def _shaded(soup: Soup, frame: _Frame, light: _Light, axes: Array, scale: float) -> Array:
    """Linear colours of every pixel (h, w, 3)."""
    owner, w = frame.owner, frame.weight[..., None]
    normal = (soup.normals[owner] * w).sum(2)
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-9)
    a, b, c = np.moveaxis(soup.points, 1, 0)
    # A sheet seen from behind is lit as from its front.
    normal *= np.where(np.cross(b - a, c - a) @ axes[2] > 1e-15, -1.0, 1.0)[owner][..., None]
    point, uv = (soup.points[owner] * w).sum(2), (soup.uv[owner] * w).sum(2)
    color, rough, metal = _surface(soup, soup.material[owner], uv)
    sun = np.clip(normal @ _SUN, 0, 1) * light.falls_on(point + 0.004 * normal)
    sky = 0.62 + 0.38 * normal[..., 2]
    half = _SUN - axes[2]
    half /= np.linalg.norm(half)
    gloss = np.clip(normal @ half, 0, 1) ** (4 + 80 * (1 - rough) ** 2) * (1 - rough) * (0.35 + 0.5 * metal)
    lit = (
        color * (0.55 * sky * _occlusion(frame.depth, scale, soup.material[owner] < 0) + 0.62 * sun)[..., None]
        + (gloss * (0.3 + sun))[..., None]
    )
    return np.where((owner < 0)[..., None], _GROUND, lit)


def _occlusion(depth: Array, scale: float, floor: NDArray[np.bool_]) -> Array:
    """Darkening of what lies behind its surroundings in the picture, less so on the floor around an object."""
    known = np.where(np.isfinite(depth), depth, np.nanmax(np.where(np.isfinite(depth), depth, np.nan)))
    out = np.ones_like(known)
    for sigma in (4, 14):
        behind = known - gaussian_filter(known, sigma)
        out *= 1 - np.where(floor, 0.08, 0.35) * np.clip(behind * scale / (3.0 * sigma), 0, 1)
    return out


def _surface(soup: Soup, material: NDArray[np.int64], uv: Array) -> tuple[Array, Array, Array]:
    color = np.full((*material.shape, 3), _GROUND)
    rough, metal = np.ones(material.shape), np.zeros(material.shape)
    for i, m in enumerate(soup.materials):
        own = material == i
        rough[own], metal[own] = m.roughness, m.metalness
        color[own] = _texels(m.texture, uv[own]) if m.texture else np.array(m.color[:3]) ** 2.2
    return color, rough, metal


def _texels(texture: str, uv: Array) -> Array:
    """Linear colour (n, 3) of the texel nearest to each uv (n, 2), repeated, v up."""
    image = pixels(texture)
    rows, columns = image.shape[:2]
    row = np.floor(-uv[:, 1] * rows).astype(int) % rows
    return np.asarray((image[row, np.floor(uv[:, 0] * columns).astype(int) % columns] / 255.0) ** 2.2)


def pair(
    asset: Asset, size: int = 160, toward: tuple[float, float, float] = (1.0, -0.62, 0.62)
) -> list[NDArray[np.uint8]]:
    """The asset closed and, when it moves, fully open, at the same scale."""
    states = [opened(asset, 0.0)] + ([opened(asset, 1.0)] if asset.joints else [])
    fit = np.concatenate([s.points.reshape(-1, 3) for s in states])
    return [picture(s, size, toward, fit) for s in states]
