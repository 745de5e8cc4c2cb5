"""The contact sheet of the whole library: every category closed and open.

`python -m stages.retrieve.furniture.sheet examples/library.png` draws it anew.
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from stages import categories
from stages.asset import Asset
from stages.retrieve import furniture
from stages.retrieve.furniture import render

CELL, COLUMNS, LABEL = 136, 14, 13
SEED = 3
_BUILDING = {"door": (0.1, 0.9, 2.1), "window": (0.1, 1.2, 1.3)}


def pictures(category: str, index: int, size: int = CELL) -> list[NDArray[np.uint8]]:
    """Two pictures of a category: one piece closed and open, or two styles of what never opens."""
    names = furniture.styles(category)
    if category in categories.TABLE and categories.TABLE[category].articulated:
        names = tuple(n for n in names if furniture.build(category, n, categories.TABLE[category].size, SEED).joints)
    box = _BUILDING.get(category) or categories.TABLE[category].size
    first = furniture.build(category, names[index % len(names)], box, SEED)
    if first.joints:
        return render.pair(_apart(first), size)
    second = furniture.build(category, names[(index + 1) % len(names)], box, SEED)
    return [*render.pair(first, size), render.pair(second, size)[0]]


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


def sheet() -> Image.Image:
    """All categories in alphabetical order, then the building's door and window."""
    names = [*categories.CATEGORIES, *furniture.BUILDING]
    cells = [(name if k == 0 else "", px) for i, name in enumerate(names) for k, px in enumerate(pictures(name, i))]
    rows = -(-len(cells) // COLUMNS)
    image = Image.new("RGB", (COLUMNS * CELL, rows * (CELL + LABEL)), (250, 250, 250))
    draw = ImageDraw.Draw(image)
    for i, (label, px) in enumerate(cells):
        x, y = i % COLUMNS * CELL, i // COLUMNS * (CELL + LABEL)
        image.paste(Image.fromarray(px), (x, y + LABEL))
        draw.text((x + 3, y + 1), label.replace("_", " "), fill=(30, 30, 30))
    return image


def write(path: Path) -> None:
    """Draws the sheet as a PNG."""
    sheet().save(path, optimize=True)


if __name__ == "__main__":
    write(Path(sys.argv[1]))
