"""Values and files told in short: numbers rounded to a tenth of a millimetre, so that another machine finds the same.

Floats are rounded with an offset that no round number of ours is near to, so that none lies on an edge by itself.
"""

import base64
import gzip
import hashlib
import io
import re
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path, PurePath
from typing import Any

import numpy as np
import pydantic
import shapely
from PIL import Image

STEP, OFFSET = 1e-4, 0.3137
UNTOLD = re.compile(rb"\b[0-9a-f]{64}\b|\"seconds\": [0-9.]+")
"""Digests of what is rounded elsewhere, and times."""
NUMBER = re.compile(rb"-?\d+\.\d+(?:[eE][-+]?\d+)?|-?\d+[eE][-+]?\d+")
DATA = re.compile(rb"base64,([A-Za-z0-9+/=]+)")
BLOCK, SHADES = 8, 12
"""Pictures are told by the means of squares of so many pixels, in steps of so many of 255."""


def digest(value: Any) -> str:
    """Twelve signs for a value of any kind."""
    found = hashlib.sha256()
    for piece in told(value):
        found.update(piece)
        found.update(b"\0")
    return found.hexdigest()[:12]


def told(value: Any) -> Iterator[bytes]:
    """A value as a sequence of bytes."""
    if isinstance(value, float | np.floating):
        yield str(_steps(np.asarray(float(value)))).encode()
    elif isinstance(value, np.ndarray):
        yield from _array(value)
    elif isinstance(value, Path):
        yield from of_files(value)
    elif isinstance(value, shapely.Geometry):
        yield value.geom_type.encode()
        yield from _array(shapely.get_coordinates(value.normalize(), include_z=value.has_z))
    else:
        yield from _whole(value)


def _whole(value: Any) -> Iterator[bytes]:
    if isinstance(value, Enum):
        yield value.name.encode()
    elif isinstance(value, pydantic.BaseModel):
        yield from told(value.model_dump())
    elif is_dataclass(value):
        for field in fields(value):
            yield field.name.encode()
            yield from told(getattr(value, field.name))
    elif isinstance(value, Mapping):
        for key, one in value.items():
            yield from told(key)
            yield from told(one)
    elif isinstance(value, set | frozenset):
        yield from sorted(digest(one).encode() for one in value)
    elif isinstance(value, Iterable) and not isinstance(value, str | bytes):
        yield type(value).__name__.encode() if isinstance(value, list | tuple) else b""
        for one in value:
            yield from told(one)
    else:
        yield value if isinstance(value, bytes) else _plain(value)


def _plain(value: Any) -> bytes:
    if value is None or isinstance(value, str | int | np.integer | np.bool_ | PurePath):
        return str(value).encode()
    raise TypeError(f"{type(value)}: how is it told?")


def _steps(numbers: np.ndarray) -> np.ndarray:
    """Numbers in steps of a tenth of a millimetre; what is too large for that is told by its first digits."""
    numbers = np.where(np.abs(numbers) > 1e8, np.copysign(np.inf, numbers), numbers)
    whole = np.floor(np.nan_to_num(numbers, nan=-7e7, posinf=3e9, neginf=-3e9) / STEP + OFFSET)
    return whole.astype(np.int64)


def _array(value: np.ndarray) -> Iterator[bytes]:
    yield str(value.shape).encode()
    if value.dtype.kind in "fc":
        yield _steps(value.view(float) if value.dtype == complex else value).tobytes()
    elif value.dtype.kind in "iub":
        yield value.astype(np.int64).tobytes()
    else:
        yield from (piece for one in value.ravel().tolist() for piece in told(one))


def of_files(folder: Path) -> Iterator[bytes]:
    """Names and contents of all files in a folder, or of one."""
    for file in sorted(folder.rglob("*")) if folder.is_dir() else [folder]:
        if file.is_file() and file.name != "SHA256SUMS":
            yield str(file.relative_to(folder)).encode()
            yield from of_file(file.name, file.read_bytes())


def of_file(name: str, data: bytes) -> Iterator[bytes]:
    """What is in a file, by how its name ends."""
    end = name.rpartition(".")[2]
    if end in ("png", "jpg"):
        yield from of_picture(data)
    elif end == "gz":
        yield from of_file(name.removesuffix(".gz"), gzip.decompress(data))
    elif end in ("zip", "usdz", "sh3d", "npz"):
        with zipfile.ZipFile(io.BytesIO(data)) as kept:
            for inner in sorted(kept.namelist()):
                yield inner.encode()
                yield from of_file(inner, kept.read(inner))
    elif end == "npy":
        yield from _array(np.load(io.BytesIO(data)))
    elif end in ("glb", "bin", "stl"):
        yield from of_words(data)
    elif end == "usdc":
        yield from of_usd(name, data)
    else:
        yield of_text(data)


def of_text(data: bytes) -> bytes:
    """A text with its numbers rounded, and what stands in it in letters for bytes."""
    data = DATA.sub(lambda found: digest(list(of_words(base64.b64decode(found[1])))).encode(), data)
    return NUMBER.sub(lambda found: str(_steps(np.asarray(float(found[0])))).encode(), UNTOLD.sub(b"", data))


def of_words(data: bytes) -> Iterator[bytes]:
    """Bytes of floats of four bytes and others: what looks like a float of ours is rounded."""
    if data[:4] == b"glTF":  # a text, then bytes
        text = 20 + int.from_bytes(data[12:16], "little")
        yield of_text(data[20:text])
        data = data[text:]
    if data[1:4] == b"PNG":
        yield from of_picture(data)
        return
    words = np.frombuffer(data[: len(data) // 4 * 4], "<u4")
    with np.errstate(invalid="ignore"):
        floats = words.view("<f4").astype(float)
    ours = (np.abs(floats) > 1e-5) & (np.abs(floats) < 1e5)
    yield np.where(ours, _steps(np.where(ours, floats, 0)), words.astype(np.int64)).tobytes()


def of_picture(data: bytes) -> Iterator[bytes]:
    """A picture in coarse squares and shades."""
    shades = np.asarray(Image.open(io.BytesIO(data)), float)
    h, w = (side // BLOCK * BLOCK for side in shades.shape[:2])
    squares = shades[:h, :w].reshape(h // BLOCK, BLOCK, w // BLOCK, BLOCK, -1).mean((1, 3))
    yield str(shades.shape).encode()
    yield np.floor(squares / SHADES + OFFSET).astype(np.int64).tobytes()


def of_usd(name: str, data: bytes) -> Iterator[bytes]:
    """A scene as its own text."""
    import tempfile

    from pxr import Usd

    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / name.rpartition("/")[2]
        file.write_bytes(data)
        yield of_text(Usd.Stage.Open(str(file)).GetRootLayer().ExportToString().encode())
