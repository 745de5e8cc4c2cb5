"""A training corpus in memory: batches of one object count each, mirrored and turned at random."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
import torch
from numpy.typing import NDArray

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.stages.layout.config import LATENT, N_MAX, TrainConfig
from apartgen.stages.layout.features import Objects
from apartgen.stages.layout.rooms import MAX_CORNERS, MAX_OPENINGS, UNKNOWN, Rooms, oriented
from apartgen.stages.things.categories import CATEGORIES

SHAPES = {
    "category": (N_MAX,), "center": (N_MAX, 3), "size": (N_MAX, 3), "yaw": (N_MAX,), "polygon": (MAX_CORNERS, 2),
    "room_type": (), "height": (), "openings": (MAX_OPENINGS, 7), "style": (),
}  # fmt: skip
"""What a corpus holds of every room."""


@dataclass
class Corpus:
    """Rooms with their objects as arrays; category (n, 24) is -1 where a slot is empty, style (n,) a room's style."""

    rooms: Rooms
    category: NDArray[np.int64]
    center: NDArray[np.float32]
    size: NDArray[np.float32]
    yaw: NDArray[np.float32]
    style: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.category)

    @property
    def count(self) -> NDArray[np.int64]:
        """Objects in each room, (n,)."""
        return np.asarray((self.category >= 0).sum(1))


def read_corpus(path: Path) -> Corpus:
    """Read an `.npz` corpus; BadInput names what is missing or unfit."""
    try:
        with np.load(path, allow_pickle=False) as file:
            data = {name: file[name] for name in SHAPES}
            made_for = file["categories"].tolist() if "categories" in file else list(CATEGORIES)
    except (OSError, ValueError, KeyError, TypeError, EOFError, BadZipFile) as error:
        raise BadInput(f"{path}: not a layout corpus ({error}); make one with `apartgen train corpus`") from error
    if made_for != list(CATEGORIES):
        raise BadInput(f"{path}: made for another furniture vocabulary; make it anew with `apartgen train corpus`")
    if wrong := next(_wrong(data), None):
        raise BadInput(f"{path}: {wrong}; make it anew with `apartgen train corpus`")
    n = len(data["category"])
    floats = {
        name: data[name].astype(np.float32) for name in ("polygon", "openings", "height", "center", "size", "yaw")
    }
    rooms = Rooms(
        polygon=floats["polygon"],
        openings=floats["openings"],
        type=data["room_type"].astype(np.int64),
        height=floats["height"],
        count=np.full(n, UNKNOWN),
        wanted=np.full((n, len(CATEGORIES)), UNKNOWN),
        origin=np.zeros((n, 2), np.float32),
    )
    category = data["category"].astype(np.int64)
    return Corpus(
        oriented(rooms), category, floats["center"], floats["size"], floats["yaw"], data["style"].astype(np.int64)
    )


def _wrong(data: dict[str, NDArray[Any]]) -> Iterator[str]:
    """What training cannot work with."""
    n = data["category"].shape[:1]
    for name, shape in SHAPES.items():
        if data[name].shape != (*n, *shape):
            yield f"{name} has the shape {data[name].shape}, not {(*n, *shape)}"
        elif data[name].dtype.kind not in "iuf":
            yield f"{name} holds no numbers"
    there = data["category"] >= 0
    if not there.any():
        yield "holds no furnished room"
    for name, least, most in (("category", UNKNOWN, len(CATEGORIES)), ("room_type", 0, len(ROOM_TYPES))):
        if (data[name] < least).any() or (data[name] >= most).any():
            yield f"{name} has an index outside {least} to {most - 1}"
    for name in ("center", "size", "yaw"):
        if not np.isfinite(data[name][there]).all():
            yield f"{name} of an object is not finite"
    if not (np.isfinite(data["height"]).all() and np.isfinite(data["polygon"][:, :3]).all()):
        yield "a room has no height, or fewer than three corners"


def mirrored(rooms: Rooms) -> Rooms:
    """The rooms with y negated; polygons stay counter-clockwise."""
    flip = np.array([1, -1], np.float32)
    used = (~np.isnan(rooms.polygon[..., 0])).sum(1)
    order = np.arange(rooms.polygon.shape[1])[None] * np.ones_like(used)[:, None]
    backward = np.where(order < used[:, None], used[:, None] - 1 - order, order)
    polygon = np.take_along_axis(rooms.polygon, backward[..., None], 1) * flip
    openings = rooms.openings * np.array([1, -1, 1, -1, 1, 1, 1], np.float32)
    return oriented(replace(rooms, polygon=polygon, openings=openings))


def turned(points: NDArray[np.float32], quarter: int) -> NDArray[np.float32]:
    """Plane points (..., 2) turned by `quarter` right angles."""
    c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][quarter % 4]
    return np.stack([c * points[..., 0] - s * points[..., 1], s * points[..., 0] + c * points[..., 1]], -1)


def batch(
    corpus: Corpus,
    index: NDArray[np.int64],
    slots: int,
    rng: np.random.Generator,
    shapes: NDArray[np.float32],
    config: TrainConfig,
) -> tuple[Objects, Rooms]:
    """The rooms `index`, one random symmetry for all, their objects shuffled into the first `slots` slots."""
    rooms, quarter, mirror = corpus.rooms[index], int(rng.integers(4)), bool(rng.integers(2))
    order = np.argsort(rng.random((len(index), N_MAX)) + (corpus.category[index] < 0), 1)[:, :slots]
    if slots == N_MAX:
        order = rng.permuted(order, axis=1)
    rows = index[:, None]
    category, center, size = corpus.category[rows, order], corpus.center[rows, order], corpus.size[rows, order]
    yaw = corpus.yaw[rows, order] * (-1 if mirror else 1) + quarter * np.pi / 2
    if mirror:
        rooms, center = mirrored(rooms), center * np.array([1, -1, 1], np.float32)
    openings = rooms.openings.copy()
    openings[..., 0:2], openings[..., 2:4] = turned(openings[..., 0:2], quarter), turned(openings[..., 2:4], quarter)
    rooms = replace(rooms, polygon=turned(rooms.polygon, quarter), openings=openings)
    center = np.concatenate([turned(center[..., :2], quarter), center[..., 2:]], -1)
    rooms.count, rooms.wanted = conditions(category, rng, config)
    latent = shapes[category, corpus.style[index][:, None] % shapes.shape[1]]
    arrays = (center, np.maximum(size, 1e-3), yaw.astype(np.float32), category, latent)
    tensors = [torch.from_numpy(np.ascontiguousarray(np.nan_to_num(a))) for a in arrays]
    return Objects(*tensors), rooms


def conditions(
    category: NDArray[np.int64], rng: np.random.Generator, config: TrainConfig
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Counts (B,) and counts by category (B, C) of rooms, left unknown at random (classifier-free training)."""
    b = len(category)
    histogram = (category[:, :, None] == np.arange(len(CATEGORIES))).sum(1)
    count = np.where(rng.random(b) < config.drop_count, UNKNOWN, histogram.sum(1))
    rate = rng.random((b, 1)) * (rng.random((b, 1)) > config.drop_wanted)
    told = rng.random(histogram.shape) < np.where(histogram > 0, rate, rate * 0.05)
    return count, np.where(told, histogram, UNKNOWN)


def shape_latents() -> NDArray[np.float32]:
    """Shape latents (C+1, S, 32) of each category's styles in the embedded library, repeated to S; the last is 0."""
    from apartgen.stages.things.latents import style_latents

    rows = [np.asarray(style_latents(name)[1], np.float32) for name in CATEGORIES]
    most = max(len(row) for row in rows)
    table = np.zeros((len(CATEGORIES) + 1, most, LATENT), np.float32)
    for i, row in enumerate(rows):
        table[i] = row[np.arange(most) % len(row)]
    return table
