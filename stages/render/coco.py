"""The things in frames as COCO has them: an image a frame, an annotation with its mask for each thing seen."""

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.render import Instance, View

LEAST = 3
"""Pixels below which a thing is left out."""
WITHOUT = ("wall", "floor", "ceiling", "trim")
"""Classes that are no things to be counted."""


class Coco:
    """Collects frames."""

    def __init__(self, labels: dict[str, int], things: list[Instance]) -> None:
        self._things = {thing.number: thing for thing in things if thing.category not in WITHOUT}
        names = [name for name in labels if name not in WITHOUT]
        self._images: list[dict[str, Any]] = []
        self._found: list[dict[str, Any]] = []
        self._categories = [{"id": labels[name], "name": name} for name in names]

    def add(self, view: View, file: str, instance: NDArray[np.uint16]) -> None:
        """One frame with its picture's name and the numbers of things in it."""
        image = len(self._images) + 1
        self._images.append({"id": image, "file_name": file, "width": view.width, "height": view.height})
        for part in view.visible:
            if part.pixels < LEAST or part.number not in self._things:
                continue
            thing = self._things[part.number]
            x, y, wide, high = part.rectangle
            mask = compressed(instance[y:y + high, x:x + wide] == part.number, (x, y), instance.shape)
            self._found.append({
                "id": len(self._found) + 1, "image_id": image, "category_id": thing.label, "iscrowd": 0,
                "area": part.pixels, "bbox": list(part.rectangle), "instance": thing.id,
                "segmentation": {"size": [view.height, view.width], "counts": mask},
            })

    def text(self) -> str:
        """The file."""
        whole = {"images": self._images, "annotations": self._found, "categories": self._categories}
        return json.dumps(whole, separators=(",", ":")) + "\n"


def runs(mask: NDArray[np.bool_], corner: tuple[int, int] = (0, 0), shape: tuple[int, int] | None = None) -> list[int]:
    """Lengths of runs of a mask column by column, those outside it first; its upper left pixel is at `corner`, column
    and row, of a picture of a `shape`, rows and columns, or it is all of the picture.
    """
    rows, columns = shape or mask.shape
    column, row = np.divmod(np.flatnonzero(mask.T), len(mask))
    at = (column + corner[0]) * rows + row + corner[1]
    apart = np.flatnonzero(np.diff(at) > 1)
    ends = np.stack([at[[0, *(apart + 1)]], at[[*apart, -1]] + 1], -1).ravel() if len(at) else at
    lengths: list[int] = np.diff(np.concatenate([[0], ends, [rows * columns]])).tolist()
    return lengths if lengths[-1] else lengths[:-1]


def compressed(mask: NDArray[np.bool_], corner: tuple[int, int] = (0, 0), shape: tuple[int, int] | None = None) -> str:
    """Runs as COCO writes them: differences to the run before last, five bits a character from the low end."""
    lengths, text = runs(mask, corner, shape), []
    for k, length in enumerate(lengths):
        left = length - (lengths[k - 2] if k > 2 else 0)
        more = True
        while more:
            bits = left & 31
            left >>= 5
            more = left != (-1 if bits & 16 else 0)
            text.append(chr(48 + bits + (32 if more else 0)))
    return "".join(text)
