"""On which side a fridge has its hinges: away from the worktop, so that what is taken out is put down beside it."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from apartgen.schemas.layout import Box
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset
from apartgen.stages.use import kinds

MADE = "parametric"
"""The library whose pieces are made to measure."""
EVEN = 0.1
"""Worktops at both sides are as near, m."""
RIGHT = "/right"
"""How the id of what is hung on the right ends."""


def on_the_right(id: str) -> bool:
    """Whether the piece of that id has its leaf on the right."""
    return id.endswith(RIGHT)


def hung(objects: Sequence[Box], assets: Sequence[Asset], made: Callable[[str], Asset]) -> list[Asset]:
    """The assets of these objects, of those `made` to measure with leaves on the side where they belong."""
    right = hung_right(objects)
    return [replace(made(asset.id + RIGHT), latent=asset.latent)
            if on and asset.library == MADE and categories.leaves(asset.category, asset.size[1]) == 1 else asset
            for asset, on in zip(assets, right, strict=True)]


def hung_right(objects: Sequence[Box]) -> Mask:
    """Of which objects the single leaf is hung on the right, (n,): what is handed is opened on the side of the nearest
    worktop, or where both sides have one, of the nearest sink."""
    found = np.zeros(len(objects), bool)
    for i, o in enumerate(objects):
        if o.category in categories.TABLE and categories.TABLE[o.category].handed:
            room = [other for other in objects if other.room == o.room]
            far = next((sides for some in (kinds.WORKTOPS | kinds.WET, kinds.WET)
                        if abs(np.diff(sides := _far(o, room, some)).item()) > EVEN), np.zeros(2))
            found[i] = far[0] < far[1]
    return found


def _far(o: Box, room: Sequence[Box], some: frozenset[str]) -> Array:
    """From the left and the right end of a thing's front to the nearest of some categories, m, (2,); 0 for none."""
    rest = [other for other in room if other.id != o.id and kinds.basic(other.category) in some]
    if not rest:
        return np.zeros(2)
    own, others = boxes.of([o]), boxes.of(rest)
    d, w = o.size[:2]
    ends = np.array([[d / 2, w / 2], [d / 2, -w / 2]]) @ boxes.axes(own)[0] + own.center[0, :2]
    off = np.abs(boxes.local(ends, others)) - others.size[:, None, :2] / 2
    return np.asarray(np.hypot(*np.moveaxis(np.maximum(off, 0), -1, 0)).min(0))
