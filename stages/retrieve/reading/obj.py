"""Wavefront OBJ and its materials."""

import io
from array import array
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.retrieve.reading.pieces import Array, Piece, count
from apartgen.stages.things.asset import Material

MTL_BYTES = 4 * 2**20
LINE_BYTES = 2**20
Open = Callable[[str], bytes | None]
"""Gives the bytes of a file named beside the model, None where there is none."""


def parse(data: bytes, name: str, beside: Open, texture: Callable[[str], str | None] = lambda _: None) -> list[Piece]:
    """One piece per material; `texture` says where an image named by the material is found."""
    points, maps = array("d"), array("d")
    materials: dict[str, Material] = {}
    # Position and texture index of each corner of each triangle, by material.
    corners: dict[str, array[int]] = {}
    current, total = "plain", 0
    lines = iter(partial(io.BytesIO(data).readline, LINE_BYTES + 1), b"")
    for number, raw in enumerate(lines, 1):
        if len(raw) > LINE_BYTES:
            raise Broken(f"{name}: line {number} is longer than the {LINE_BYTES} bytes accepted")
        word, _, rest = raw.strip().decode("utf-8", errors="replace").partition(" ")
        try:
            if word == "v":
                x, y, z = rest.split()[:3]
                points.extend((float(x), float(y), float(z)))
            elif word == "vt":
                maps.extend(float(v) for v in [*rest.split(), "0"][:2])
            elif word == "f":
                ring = [_corner(token, len(points) // 3, len(maps) // 2) for token in rest.split()]
                own = corners.setdefault(current, array("q"))
                for i in range(1, len(ring) - 1):
                    own.extend((*ring[0], *ring[i], *ring[i + 1]))
                total += max(len(ring) - 2, 0)
            elif word == "usemtl":
                current = rest.strip()
            elif word == "mtllib":
                materials |= parse_mtl(beside(rest.strip()) or b"", texture)
        except (ValueError, IndexError, OverflowError):
            line = raw[:60].decode("utf-8", errors="replace").strip()
            raise Broken(f"{name}: line {number} is not a face or vertex: {line!r}") from None
        if number % 4096 == 0:
            count(len(points) // 3, total, name)
    count(len(points) // 3, total, name)
    xyz, st = np.asarray(points).reshape(-1, 3), np.array(maps).reshape(-1, 2)
    return [
        _piece(np.array(own).reshape(-1, 2), xyz, st, materials.get(key, Material(key or "plain")), name)
        for key, own in corners.items()
        if len(own)
    ]


def _corner(token: str, points: int, maps: int) -> tuple[int, int]:
    """Indices of position and texture, from 0; -1 for no texture. Negative ones in the file count from the end."""
    fields = token.split("/")
    v = int(fields[0])
    t = int(fields[1]) if len(fields) > 1 and fields[1] else 0
    return (v - 1 if v > 0 else points + v), (t - 1 if t > 0 else maps + t if t < 0 else -1)


def _piece(pairs: NDArray[np.int64], xyz: Array, st: Array, material: Material, name: str) -> Piece:
    used, inverse = np.unique(pairs, axis=0, return_inverse=True)
    if used[:, 0].min() < 0 or used[:, 0].max() >= len(xyz) or used[:, 1].max() >= len(st):
        raise Broken(f"{name}: faces refer to vertices that do not exist")
    uv = st[used[:, 1]] if len(st) and used[:, 1].min() >= 0 else None
    return Piece(xyz[used[:, 0]], inverse.reshape(-1, 3).astype(np.int64), material, uv)


def parse_mtl(data: bytes, texture: Callable[[str], str | None]) -> dict[str, Material]:
    """Materials by name; Kd, d or Tr, Ns, map_Kd, and Pr and Pm of the physically based extension are understood."""
    if len(data) > MTL_BYTES:
        raise Broken(f"a material file of {len(data)} bytes, more than the {MTL_BYTES} accepted")
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
            case "Kd" if material.texture is None:
                r, g, b = (min(max(float(v), 0.0), 1.0) for v in rest.split()[:3])
            case "d":
                alpha = float(rest.split()[-1])
            case "Tr":
                alpha = 1 - float(rest.split()[-1])
            case "Ns":
                # Blinn-Phong exponent to roughness (Walter et al. 2007).
                return replace(material, roughness=float(np.clip((2 / (float(rest) + 2)) ** 0.25, 0, 1)))
            case "Pr":
                return replace(material, roughness=min(max(float(rest), 0.0), 1.0))
            case "Pm":
                return replace(material, metalness=min(max(float(rest), 0.0), 1.0))
            case "map_Kd":
                found = texture(_named(rest))
                return replace(material, texture=found, color=(1.0, 1.0, 1.0, alpha)) if found else material
            case _:
                return material
    except (ValueError, IndexError):
        return material
    return replace(material, color=(r, g, b, alpha))


def _named(rest: str) -> str:
    """The file of a map: what is left, blanks and all, behind options and their values."""
    words = rest.split()
    while words and words[0].startswith("-") and len(words) > 1:
        words = words[1:]
        while len(words) > 1 and _is_value(words[0]):
            words = words[1:]
    return rest[rest.index(words[0]) :] if words and words[0] in rest else rest


def _is_value(word: str) -> bool:
    return word in ("on", "off") or word.replace(".", "", 1).replace("-", "", 1).isdigit()
