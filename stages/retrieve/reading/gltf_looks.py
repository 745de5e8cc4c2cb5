"""glTF materials: surfaces of base colour, roughness and metalness, and where their images lie on a mesh."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from apartgen.stages.retrieve.reading import images
from apartgen.stages.retrieve.reading.images import encoded
from apartgen.stages.retrieve.reading.limits import FILE_BYTES, Broken
from apartgen.stages.retrieve.reading.pieces import Array
from apartgen.stages.things.asset import Material

WEBP = "EXT_texture_webp"
TRANSFORM = "KHR_texture_transform"
OLD = "KHR_materials_pbrSpecularGlossiness"
KNOWN = frozenset({WEBP, TRANSFORM, OLD, "KHR_materials_unlit", "KHR_mesh_quantization"})
"""Extensions that a file may require."""
Node = dict[str, Any]


class Look(NamedTuple):
    """A material, and how its image is laid: the set of texture coordinates and their map (2, 3)."""

    material: Material
    set: int
    map: Array


class Looks:
    """The materials of a document. `view` gives the bytes of a buffer view, `beside` those of a file."""

    def __init__(self, about: Node, view: Callable[[int], bytes], beside: Callable[[str], bytes | None]) -> None:
        self.about, self.view, self.beside = about, view, beside
        self.known: dict[tuple[Any, ...], Look] = {}
        self.addresses: dict[tuple[int, bool], str] = {}
        self.spent = 0

    def of(self, i: int | None, tint: Array) -> Look:
        """A material by number, its colour multiplied by the vertices' mean one (4) in linear light."""
        key = (i, *tint.round(4))
        if key not in self.known:
            self.known[key] = self._look({} if i is None else self.about["materials"][i], i, tint)
        return self.known[key]

    def _look(self, m: Node, i: int | None, tint: Array) -> Look:
        pbr = m.get("pbrMetallicRoughness", {})
        old = m.get("extensions", {}).get(OLD)
        if old is not None:
            pbr = {"baseColorFactor": old.get("diffuseFactor", (1, 1, 1, 1)), "metallicFactor": 0.0,
                   "roughnessFactor": 1 - float(old.get("glossinessFactor", 1)),
                   "baseColorTexture": old.get("diffuseTexture")}  # fmt: skip
        clear = m.get("alphaMode", "OPAQUE") != "OPAQUE"
        r, g, b, a = np.asarray(pbr.get("baseColorFactor", (1, 1, 1, 1)), float) * tint
        red, green, blue = (float(v) for v in encoded((r, g, b)))
        rough, metal = float(pbr.get("roughnessFactor", 1)), float(pbr.get("metallicFactor", 1))
        if i is None and not len(self.about.get("materials", [])):
            rough, metal = 0.7, 0.0
        both = self._texture(pbr.get("metallicRoughnessTexture"), False)
        if both:
            rough, metal = (float(v) for v in images.means(both)[1:] * (rough, metal))
        told = pbr.get("baseColorTexture")
        color = (red, green, blue, float(np.clip(a, 0, 1)) if clear else 1.0)
        name = str(m.get("name") or ("plain" if i is None else f"material_{i}"))
        rough, metal = (min(max(share, 0.0), 1.0) for share in (rough, metal))
        return Look(Material(name, color, rough, metal, self._texture(told, clear)), *_laid(told))

    def _texture(self, told: Node | None, clear: bool) -> str | None:
        """The address of a texture's image; None where there is none."""
        if told is None:
            return None
        texture = self.about["textures"][told["index"]]
        source = texture.get("extensions", {}).get(WEBP, texture).get("source")
        if source is None:
            return None
        if (source, clear) not in self.addresses:
            self.addresses[source, clear] = images.address(self._bytes(self.about["images"][source]), clear)
        return self.addresses[source, clear]

    def _bytes(self, image: Node) -> bytes:
        data = self.view(image["bufferView"]) if "bufferView" in image else self.beside(image.get("uri", ""))
        if data is None:
            raise Broken(f"lacks the image {image.get('uri')!r}")
        self.spent += len(data)
        if self.spent > FILE_BYTES:
            raise Broken(f"its images hold more than the {FILE_BYTES / 2**20:.0f} MB accepted")
        return data


def _laid(told: Node | None) -> tuple[int, Array]:
    """Set of texture coordinates and the map (2, 3) onto them, as KHR_texture_transform has it."""
    if told is None:
        return 0, np.eye(2, 3)
    change = told.get("extensions", {}).get(TRANSFORM, {})
    turn = float(change.get("rotation", 0))
    scale = np.diag(np.asarray(change.get("scale", (1, 1)), float))
    about = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]) @ scale
    offset = np.asarray(change.get("offset", (0, 0)), float).reshape(2, 1)
    return int(change.get("texCoord", told.get("texCoord", 0))), np.hstack([about, offset])
