"""Images of an indexed library: each kept once under the digest of its content, tinted as its material says."""

import hashlib
import io
import logging
from dataclasses import replace
from pathlib import Path

import numpy as np

from apartgen.stages.retrieve.reading.images import decoded, encoded, linear
from apartgen.stages.retrieve.reading.limits import Broken
from apartgen.stages.things.asset import Asset, Material

LOG = logging.getLogger("apartgen")
FOLDER = "textures"


def kept(asset: Asset, library: Path) -> Asset:
    """The asset with its images as PNG files below `library`, and its materials in their mean colours.

    An image that can't be read is left out, and the material stays plain.
    """
    made: dict[Material, Material] = {}
    links = []
    for link in asset.links:
        for mesh in link.visuals:
            if mesh.material not in made:
                made[mesh.material] = _kept(mesh.material, asset.id, library)
        links.append(replace(link, visuals=[replace(mesh, material=made[mesh.material]) for mesh in link.visuals]))
    return replace(asset, links=links)


def _kept(material: Material, id: str, library: Path) -> Material:
    if material.texture is None:
        return material
    try:
        image = decoded(material.texture)
    except Broken as fault:
        LOG.warning("%s: material %s: %s; left plain", id, material.name, fault)
        return replace(material, texture=None)
    pixels = np.asarray(image, float) / 255
    tint = linear(material.color[:3])
    if (tint < 0.999).any():
        pixels[..., :3] = encoded(linear(pixels[..., :3]) * tint)
    r, g, b = (float(v) for v in encoded(linear(pixels[..., :3]).mean((0, 1))).round(4))
    data = _png(np.rint(pixels * 255).astype(np.uint8))
    name = f"{hashlib.sha256(data).hexdigest()[:16]}.png"
    (library / FOLDER).mkdir(parents=True, exist_ok=True)
    (library / FOLDER / name).write_bytes(data)
    return replace(material, color=(r, g, b, material.color[3]), texture=name)


def _png(pixels: np.ndarray[tuple[int, ...], np.dtype[np.uint8]]) -> bytes:
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, "PNG")
    return buffer.getvalue()
