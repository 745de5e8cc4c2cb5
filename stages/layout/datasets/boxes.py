"""Rooms as ATISS, DiffuScene and PhyScene preprocess them: `<room>/boxes.npz` with `dataset_stats.txt` above.

`translations` are box centres from the floor's centroid, `sizes` half extents [x, y, z] before turning, `angles` turns
about y, `class_labels` one-hot rows over the stats' names. A split file is a CSV of `room, split`.
"""

import csv
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from schemas.base import RoomType
from schemas.errors import BadInput
from schemas.layout import Layout
from stages.layout.datasets import _frames, _words

FIELDS = (
    "floor_plan_vertices", "floor_plan_faces", "floor_plan_centroid", "class_labels", "translations", "sizes", "angles",
)
HEIGHT = 2.6


def homes(root: Path | None, split: str | None = None, splits: Path | None = None) -> Iterator[Layout]:
    """Every room below `root`, or those that the CSV `splits` puts into `split`."""
    if root is None or not root.is_dir():
        raise BadInput("boxes: name a folder that holds dataset_stats.txt and a folder with boxes.npz for every room")
    names = _names(root / "dataset_stats.txt")
    wanted = None if split is None else _members(splits, split)
    for path in sorted(root.rglob("boxes.npz")):
        if wanted is None or path.parent.name.split("_")[-1] in wanted or path.parent.name in wanted:
            yield layout(path, names)


def _names(path: Path) -> list[str]:
    try:
        return [str(name) for name in json.loads(path.read_text())["class_labels"]]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BadInput(f"{path}: no class_labels to be read ({error!r})") from error


def _members(path: Path | None, split: str) -> set[str]:
    if path is None:
        raise BadInput("boxes: a split needs the CSV that says which rooms are in it")
    try:
        with path.open(newline="") as file:
            return {row[0].strip() for row in csv.reader(file) if len(row) > 1 and row[1].strip() == split}
    except OSError as error:
        raise BadInput(f"{path}: cannot be read ({error})") from error


def layout(path: Path, names: list[str]) -> Layout:
    """The room of one `boxes.npz`; the folder's name tells its type, a bed makes it a bedroom otherwise."""
    try:
        with np.load(path, allow_pickle=False) as file:
            data = {name: np.asarray(file[name], float) for name in FIELDS}
    except (OSError, ValueError, KeyError) as error:
        raise BadInput(f"{path}: not a preprocessed room ({error})") from error
    labels = [names[k] for k in data["class_labels"].argmax(1)]
    floor = _frames.outline(data["floor_plan_vertices"], data["floor_plan_faces"].astype(int))
    if floor is None:
        raise BadInput(f"{path}: its floor has no area")
    room = _frames.room(_type(path, labels), 1, list(floor.exterior.coords))
    centroid, objects = data["floor_plan_centroid"], []
    angles = data["angles"].reshape(len(labels), -1)[:, 0]
    rows = zip(labels, data["translations"], data["sizes"], angles, strict=True)
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


def _type(path: Path, labels: list[str]) -> RoomType:
    word = path.parent.name.split("_")[-1].split("-")[0]
    named = _words.room_type(word)
    if named is not None:
        return named
    return "bedroom" if any("bed" in label for label in labels) else "living_room"
