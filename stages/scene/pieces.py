"""Visual pieces as formats need them: one mesh per link and material, shaded normals, names, texture images."""

import hashlib
import io
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache, lru_cache

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput
from apartgen.stages.things import materials, relief
from apartgen.stages.things.asset import Array, Link, Material, Mesh
from apartgen.stages.things.shading import corner_normals, distinct

LATELY = 1000
"""Meshes that are kept shaded, a home's and some more: about 10 kB each."""
QUICK = 4
"""How hard a texture is packed: a third of the time of the hardest worth having, and 8 % more bytes."""


def pieces(link: Link) -> list[Mesh]:
    """The link's visuals joined by material, in order of first use."""
    groups: dict[Material, list[Mesh]] = {}
    for mesh in link.visuals:
        groups.setdefault(mesh.material, []).append(mesh)
    return [joined(meshes) for meshes in groups.values()]


def joined(meshes: list[Mesh]) -> Mesh:
    """Meshes of one material as one; uv only where all have it."""
    if len(meshes) == 1 and (meshes[0].uv is None or meshes[0].material.texture is not None):
        return meshes[0]
    starts = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    faces = np.concatenate([m.faces + start for m, start in zip(meshes, starts, strict=False)])
    uv = [m.uv for m in meshes if m.uv is not None]
    textured = meshes[0].material.texture is not None and len(uv) == len(meshes)
    vertices = np.concatenate([m.vertices for m in meshes])
    return Mesh(vertices, faces, meshes[0].material, np.concatenate(uv) if textured else None)


def digest(*arrays: Array | None, extra: str = "") -> str:
    """Name of some content: equal to the micrometre, equal name."""
    found = hashlib.sha256(extra.encode())
    for array in arrays:
        found.update(b"-" if array is None else np.round(array * 1e6).astype(np.int64).tobytes() + b"|")
    return found.hexdigest()


def mesh_digest(mesh: Mesh) -> str:
    """Name of a mesh's shape, whatever its material."""
    return digest(mesh.vertices, mesh.faces.astype(float), mesh.uv)


Shaded = tuple[Array, Array, Array | None, NDArray[np.int64]]


@dataclass(frozen=True)
class _Known:
    """A mesh, known again by its very bytes."""

    content: str
    mesh: Mesh = field(compare=False)


def shaded(mesh: Mesh) -> Shaded:
    """Vertices (k, 3), unit normals (k, 3), uv (k, 2) or None, and faces, split where an edge is sharp; not to be
    written into, for several formats ask for the same.
    """
    found = hashlib.sha256(mesh.vertices.tobytes())
    found.update(mesh.faces.tobytes() + (b"" if mesh.uv is None else mesh.uv.tobytes()))
    return _shaded(_Known(found.hexdigest(), mesh))


@lru_cache(LATELY)
def _shaded(known: _Known) -> Shaded:
    mesh = known.mesh
    corners = mesh.faces.ravel()
    normals = corner_normals(mesh).round(4)
    columns = [mesh.vertices[corners].round(6), normals]
    if mesh.uv is not None:
        columns.append(mesh.uv[corners].round(6))
    rows, faces = distinct(np.concatenate(columns, 1))
    unit = rows[:, 3:6] / np.maximum(np.linalg.norm(rows[:, 3:6], axis=1, keepdims=True), 1e-12)
    return rows[:, :3], unit, rows[:, 6:] if mesh.uv is not None else None, faces.reshape(-1, 3)


def names(used: Iterable[Material]) -> dict[Material, str]:
    """A name for each material, its own unless a different one has taken it."""
    found: dict[Material, str] = {}
    taken: set[str] = set()
    for material in used:
        if material not in found:
            k = 1
            name = material.name
            while name in taken:
                k += 1
                name = f"{material.name}_{k}"
            taken.add(name)
            found[material] = name
    return found


@cache
def image(texture: str) -> bytes:
    """A texture as PNG: a procedural one by name, or a library's image file by path."""
    from PIL import Image

    try:
        known = texture in materials.textures()
        picture = Image.fromarray(np.array(materials.texture(texture))) if known else Image.open(texture)
        picture = picture if picture.mode in ("RGB", "RGBA") else picture.convert("RGB")
    except OSError:
        raise BadInput(
            f"texture {texture!r} is neither a known pattern nor an image file; check the asset library's folder"
        ) from None
    buffer = io.BytesIO()
    picture.save(buffer, "PNG", compress_level=QUICK)
    return buffer.getvalue()


@cache
def relief_image(pattern: str) -> bytes:
    """The normal map of a pattern that stands up, as PNG."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.array(relief.normals(pattern))).save(buffer, "PNG", compress_level=QUICK)
    return buffer.getvalue()


def image_name(texture: str) -> str:
    """A file name for a texture, the same for the same content."""
    if texture in materials.textures():
        return f"{texture}.png"
    return f"texture_{hashlib.sha256(image(texture)).hexdigest()[:12]}.png"


def cut_out(texture: str) -> bool:
    """Whether the texture's alpha cuts the surface out: its PNG is of colour type 6."""
    return image(texture)[25] == 6
