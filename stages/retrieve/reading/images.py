"""Images that models bring: addressed by path, or by a data URI where they have no file; decoded within bounds."""

import base64
import binascii
import io
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from apartgen.stages.retrieve.reading.limits import Broken, read
from apartgen.stages.retrieve.reading.pieces import Array

if TYPE_CHECKING:
    from PIL.Image import Image

BYTES = 64 * 2**20
PIXELS = 100_000_000
"""Above these an image is refused before it is decoded."""
SIDE = 1024
"""Longest side of images that are kept, in pixels."""
_CLEAR = ";alpha=1"
"""In an address: the image's alpha is meant, and not to be dropped."""


def address(data: bytes, clear: bool = False) -> str:
    """A data URI; `clear` where the image's alpha cuts the surface out."""
    return f"data:image{_CLEAR if clear else ''};base64,{base64.b64encode(data).decode()}"


def decoded(at: str) -> "Image":
    """The image of an address, RGB or RGBA, brought down to `SIDE`; Broken when it can't be used."""
    from PIL import Image

    clear = at.startswith(f"data:image{_CLEAR};")
    try:
        raw = base64.b64decode(at.partition(",")[2]) if at.startswith("data:") else read(Path(at), BYTES)
        with warnings.catch_warnings():
            # Sizes are looked at here.
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            opened = Image.open(io.BytesIO(raw))
        with opened as found:
            if found.width * found.height > PIXELS:
                raise Broken(f"an image of {found.width} x {found.height} pixels, more than the {PIXELS} accepted")
            # A JPEG is decoded at about the size that is wanted.
            found.draft("RGB", (SIDE, SIDE))
            found.thumbnail((SIDE, SIDE))
            return found.convert("RGBA" if clear and np.asarray(found.convert("RGBA"))[..., 3].min() < 255 else "RGB")
    except (OSError, ValueError, SyntaxError, binascii.Error, Image.DecompressionBombError) as error:
        raise Broken(f"an image can't be read ({error})") from None


def means(at: str) -> Array:
    """Mean of each channel (3,), in [0, 1]."""
    return np.asarray(np.asarray(decoded(at).convert("RGB"), float).mean((0, 1)) / 255)


def encoded(linear: ArrayLike) -> Array:
    """Linear light to sRGB, both in [0, 1]."""
    light = np.clip(np.asarray(linear, float), 0, 1)
    return np.asarray(np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055))


def linear(srgb: ArrayLike) -> Array:
    """sRGB to linear light, both in [0, 1]."""
    value = np.asarray(srgb, float)
    return np.asarray(np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4))
