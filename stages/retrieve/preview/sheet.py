"""Contact sheets: rows of assets, each closed and, where it opens, open beside it.

The order is the caller's; every category of the embedded library by default.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.preview import render
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset

CELL, COLUMNS = 136, 14
PAPER, INK = (250, 250, 250), (30, 30, 30)
SEED = 3
_BUILDING = {"door": (0.1, 0.9, 2.1), "window": (0.1, 1.2, 1.3)}


class Cell(NamedTuple):
    """A name, and pictures of equal size to lay side by side."""

    label: str
    pictures: Sequence[NDArray[np.uint8]]


def of_asset(asset: Asset, label: str, size: int = CELL) -> Cell:
    """One asset closed, and open where it opens."""
    return Cell(label, render.pair(_apart(asset), size))


def of_category(category: str, size: int = CELL) -> list[Cell]:
    """Every style of a category of the embedded library, at its usual size; BadInput for one of another package that
    can't be built of every size."""
    furniture.tried(category, SEED)
    made = [furniture.build(category, style, _box(category), SEED) for style in furniture.styles(category)]
    return [of_asset(one, f"{category} {one.style}", size) for one in made]


def of_library(size: int = CELL) -> Iterable[Cell]:
    """Every category of the embedded library in alphabetical order, then the building's door and window.

    One piece closed and open, or two styles of what never opens.
    """
    for i, category in enumerate([*categories.TABLE, *furniture.BUILDING]):
        first, second = _shown(category, i)
        pictures = render.pair(_apart(first), size)
        yield Cell(category, pictures if first.joints else [*pictures, render.pair(second, size)[0]])


def _shown(category: str, i: int) -> tuple[Asset, Asset]:
    """Two styles, others for each category; ones that open where the category does."""
    made = [furniture.build(category, style, _box(category), SEED) for style in furniture.styles(category)]
    if any(one.joints for one in made):
        made = [one for one in made if one.joints]
    return made[i % len(made)], made[(i + 1) % len(made)]


def _box(category: str) -> tuple[float, float, float]:
    return _BUILDING.get(category) or categories.TABLE[category].size


def _apart(asset: Asset) -> Asset:
    """Only every other sliding door moves: two that change places look as if they had not."""
    kept = [link for link in asset.links if link.joint and link.joint.part == "slider_door"][1::2]
    still = [
        replace(link, joint=link.joint.model_copy(update={"range": (0.0, 1e-6)}))
        if link.joint and any(link is k for k in kept)
        else link
        for link in asset.links
    ]
    return replace(asset, links=still)


def drawn(cells: Iterable[Cell], columns: int = COLUMNS) -> Image.Image:
    """The cells in rows, none torn apart at a row's end; fewer columns where fewer are needed."""
    all_ = list(cells)
    size = len(all_[0].pictures[0])
    total = sum(len(cell.pictures) for cell in all_)
    columns = max(min(columns, total), max(len(cell.pictures) for cell in all_))
    places, column, row = [], 0, 0
    for cell in all_:
        if column + len(cell.pictures) > columns:
            column, row = 0, row + 1
        places.append((column, row))
        column += len(cell.pictures)
    points = max(11, size // 14)
    height = size + points + 4
    image = Image.new("RGB", (columns * size, (row + 1) * height), PAPER)
    draw, font = ImageDraw.Draw(image), ImageFont.load_default(points)
    for cell, (x, y) in zip(all_, places, strict=True):
        for k, picture in enumerate(cell.pictures):
            image.paste(Image.fromarray(picture), ((x + k) * size, y * height + points + 4))
        draw.text((x * size + 3, y * height + 1), _cut(cell, draw, font), fill=INK, font=font)
    return image


def _cut(cell: Cell, draw: ImageDraw.ImageDraw, font: ImageFont.FreeTypeFont | ImageFont.ImageFont) -> str:
    """The label, shortened to the width of its pictures."""
    text = cell.label.replace("_", " ")
    room = len(cell.pictures) * len(cell.pictures[0]) - 6
    while len(text) > 1 and draw.textlength(text, font=font) > room:
        text = text[:-2].rstrip() + "…"
    return text
