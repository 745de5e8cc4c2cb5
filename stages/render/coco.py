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
            self._found.append({
                "id": len(self._found) + 1, "image_id": image, "category_id": thing.label, "iscrowd": 0,
                "area": part.pixels, "bbox": list(part.rectangle), "instance": thing.id,
                "segmentation": {"size": [view.height, view.width], "counts": compressed(instance == part.number)},
            })

    def text(self) -> str:
        """The file."""
        whole = {"images": self._images, "annotations": self._found, "categories": self._categories}
        return json.dumps(whole, separators=(",", ":")) + "\n"


def runs(mask: NDArray[np.bool_]) -> list[int]:
    """Lengths of runs of a mask column by column, those outside it first."""
    flat = mask.ravel(order="F")
    change = np.flatnonzero(np.diff(flat)) + 1
    ends = np.concatenate([[0], change, [len(flat)]])
    lengths: list[int] = np.diff(ends).tolist()
    return [0, *lengths] if flat[0] else lengths


def compressed(mask: NDArray[np.bool_]) -> str:
    """Runs as COCO writes them: differences to the run before last, five bits a character from the low end."""
    lengths, text = runs(mask), []
    for k, length in enumerate(lengths):
        left = length - (lengths[k - 2] if k > 2 else 0)
        more = True
        while more:
            bits = left & 31
            left >>= 5
            more = left != (-1 if bits & 16 else 0)
            text.append(chr(48 + bits + (32 if more else 0)))
    return "".join(text)
