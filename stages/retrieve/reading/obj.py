"""Wavefront OBJ and its materials."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from stages.asset import Material
from stages.retrieve.reading.limits import Broken
from stages.retrieve.reading.pieces import Piece, count

Open = Callable[[str], bytes | None]
"""Gives the bytes of a file named beside the model, None where there is none."""
Corner = tuple[int, int]


def parse(data: bytes, name: str, beside: Open, texture: Callable[[str], str | None] = lambda _: None) -> list[Piece]:
    """One piece per material; `texture` says where an image named by the material is found."""
    points: list[list[float]] = []
    maps: list[list[float]] = []
    materials: dict[str, Material] = {}
    faces: dict[str, list[tuple[Corner, Corner, Corner]]] = {}
    current, total = "plain", 0
    for number, line in enumerate(data.decode("utf-8", errors="replace").splitlines(), 1):
        word, _, rest = line.strip().partition(" ")
        try:
            if word == "v":
                points.append([float(v) for v in rest.split()[:3]])
            elif word == "vt":
                maps.append([float(v) for v in [*rest.split(), "0"][:2]])
            elif word == "f":
                ring = [_corner(token, len(points), len(maps)) for token in rest.split()]
                fan = [(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1)]
                faces.setdefault(current, []).extend(fan)
                total += len(fan)
            elif word == "usemtl":
                current = rest.strip()
            elif word == "mtllib":
                materials |= parse_mtl(beside(rest.strip()) or b"", texture)
        except (ValueError, IndexError):
            raise Broken(f"{name}: line {number} is not a face or vertex: {line[:60]!r}") from None
        if number % 4096 == 0:
            count(len(points), total, name)
    count(len(points), total, name)
    if any(len(p) != 3 for p in points):
        raise Broken(f"{name}: a vertex without three coordinates")
    xyz, st = np.asarray(points, float).reshape(-1, 3), np.asarray(maps, float).reshape(-1, 2)
    return [
        _piece(corners, xyz, st, materials.get(key, Material(key or "plain")), name) for key, corners in faces.items()
    ]


def _corner(token: str, points: int, maps: int) -> Corner:
    """Indices of position and texture, from 0; -1 for no texture. Negative ones in the file count from the end."""
    fields = token.split("/")
    v = int(fields[0])
    t = int(fields[1]) if len(fields) > 1 and fields[1] else 0
    return (v - 1 if v > 0 else points + v), (t - 1 if t > 0 else maps + t if t < 0 else -1)


def _piece(
    corners: list[tuple[Corner, Corner, Corner]],
    xyz: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    st: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    material: Material,
    name: str,
) -> Piece:
    pairs, inverse = np.unique(np.asarray(corners, np.int64).reshape(-1, 2), axis=0, return_inverse=True)
    if pairs[:, 0].min() < 0 or pairs[:, 0].max() >= len(xyz) or pairs[:, 1].max() >= len(st):
        raise Broken(f"{name}: faces refer to vertices that do not exist")
    uv = st[pairs[:, 1]] if len(st) and pairs[:, 1].min() >= 0 else None
    return Piece(xyz[pairs[:, 0]], inverse.reshape(-1, 3).astype(np.int64), material, uv)


def parse_mtl(data: bytes, texture: Callable[[str], str | None]) -> dict[str, Material]:
    """Materials by name; Kd, d or Tr, Ns and map_Kd are understood."""
    found: dict[str, Material] = {}
    name = ""
    for line in data.decode("utf-8", errors="replace").splitlines():
        word, _, rest = line.strip().partition(" ")
        if word == "newmtl":
            name = rest.strip()
            found[name] = Material(name)
        elif name:
            found[name] = _refined(found[name], word, rest.strip(), texture)
    return found


def _refined(material: Material, word: str, rest: str, texture: Callable[[str], str | None]) -> Material:
    r, g, b, alpha = material.color
    try:
        match word:
            case "Kd":
                r, g, b = (min(max(float(v), 0.0), 1.0) for v in rest.split()[:3])
            case "d":
                alpha = float(rest.split()[-1])
            case "Tr":
                alpha = 1 - float(rest.split()[-1])
            case "Ns":
                # Blinn-Phong exponent to roughness (Walter et al. 2007).
                return replace(material, roughness=float(np.clip((2 / (float(rest) + 2)) ** 0.25, 0, 1)))
            case "map_Kd":
                return replace(material, texture=texture(rest.split()[-1]), color=(1.0, 1.0, 1.0, alpha))
            case _:
                return material
    except (ValueError, IndexError):
        return material
    return replace(material, color=(r, g, b, alpha))
