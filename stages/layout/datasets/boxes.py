"""Rooms as ATISS, DiffuScene and PhyScene preprocess them: `<room>/boxes.npz` with `dataset_stats.txt` above.

`translations` are box centres from the floor's centroid, `sizes` half extents [x, y, z] before turning, `angles` turns
about y, `class_labels` one-hot rows over the stats' names. A split file is a CSV of `room, split`.
"""

import csv
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import RoomType
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages.layout.datasets import _frames, _words

FIELDS = (
    "floor_plan_vertices", "floor_plan_faces", "floor_plan_centroid", "class_labels", "translations", "sizes", "angles",
)
HEIGHT = 2.6


def homes(root: Path | None, split: str | None = None, splits: Path | None = None) -> Iterator[Layout]:
    """Every room below `root`, or those that the CSV `splits` puts into `split`."""
    if root is None or not root.is_dir():
        raise BadInput("boxes: name a folder that holds dataset_stats.txt and a folder with boxes.npz for every room")
    names, paths = _names(root / "dataset_stats.txt"), sorted(root.rglob("boxes.npz"))
    if not paths:
        raise BadInput(f"{root}: no folder in it has a boxes.npz")
    if split is not None or splits is not None:
        wanted = _members(splits, split)
        paths = [p for p in paths if p.parent.name.split("_")[-1] in wanted or p.parent.name in wanted]
        if not paths:
            raise BadInput(f"{splits}: puts no room of {root} into {split!r}")
    for path in paths:
        yield layout(path, names)


def _names(path: Path) -> list[str]:
    try:
        return [str(name) for name in json.loads(path.read_text())["class_labels"]]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BadInput(f"{path}: no class_labels to be read ({error!r})") from error


def _members(path: Path | None, split: str | None) -> set[str]:
    if path is None or split is None:
        raise BadInput("boxes: a split takes its name, --split, and the CSV that says which rooms are in it, --splits")
    try:
        with path.open(newline="") as file:
            return {row[0].strip() for row in csv.reader(file) if len(row) > 1 and row[1].strip() == split}
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadInput(f"{path}: no split file to be read ({error})") from error


def layout(path: Path, names: list[str]) -> Layout:
    """The room of one `boxes.npz`; the folder's name tells its type, a bed makes it a bedroom otherwise."""
    try:
        with np.load(path, allow_pickle=False) as file:
            data = {name: np.asarray(file[name], float) for name in FIELDS}
    except (OSError, ValueError, KeyError) as error:
        raise BadInput(f"{path}: not a preprocessed room ({error})") from error
    if wrong := next(_wrong(data, len(names)), None):
        raise BadInput(f"{path}: not a preprocessed room ({wrong})")
    labels = [names[k] for k in data["class_labels"].argmax(1)] if len(data["class_labels"]) else []
    floor = _frames.outline(data["floor_plan_vertices"], data["floor_plan_faces"].astype(int))
    if floor is None:
        raise BadInput(f"{path}: its floor has no area")
    room = _frames.room(_type(path, labels), 1, list(floor.exterior.coords))
    centroid, angles, objects = data["floor_plan_centroid"].ravel(), data["angles"].ravel(), []
    rows = zip(labels, data["translations"].reshape(-1, 3), data["sizes"].reshape(-1, 3), angles, strict=True)
    for k, (label, at, half, angle) in enumerate(rows):
        name = _words.category(label)
        if name is None:
            continue
        x, y, z = at + centroid
        w, h, d = 2 * half
        name = _words.by_size(name, (d, w, h))
        yaw = float(angle - np.pi / 2)
        objects.append(_frames.box(f"{room.id}.{name}_{k + 1}", room.id, name, (x, -z, y), (d, w, h), yaw))
    return _frames.home([room], [], objects, HEIGHT)


def _wrong(data: dict[str, NDArray[np.float64]], names: int) -> Iterator[str]:
    """What is unfit in a room's arrays, one row an object, and in its floor."""
    n, corners, faces = len(data["class_labels"]), data["floor_plan_vertices"], data["floor_plan_faces"]
    numbers = {"translations": 3 * n, "sizes": 3 * n, "angles": n, "floor_plan_centroid": 3}
    for name, value in data.items():
        if value.size != numbers.get(name, value.size):
            yield f"{name} has {value.size} numbers, {numbers[name]} belong to {n} labelled objects"
        if not np.isfinite(value).all():
            yield f"{name} is not finite"
    if n and (data["class_labels"].ndim != 2 or data["class_labels"].argmax(1).max() >= names):
        yield f"a label is none of the {names} in dataset_stats.txt"
    if corners.ndim != 2 or corners.shape[1] != 3 or faces.size % 3:
        yield "its floor is no mesh of triangles"
    if faces.size and not (faces.min() >= 0 and faces.max() < len(corners)):
        yield "a face of its floor names a corner that is not there"


def _type(path: Path, labels: list[str]) -> RoomType:
    word = path.parent.name.split("_")[-1].split("-")[0]
    named = _words.room_type(word)
    if named is not None:
        return named
    return "bedroom" if any("bed" in label for label in labels) else "living_room"
