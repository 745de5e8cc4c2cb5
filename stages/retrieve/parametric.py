"""Parametric furniture made by this program: every category in several styles, each at its usual size.

The folder is not read. Furniture of any other size is made on demand, see `apartgen.stages.retrieve.furniture`.
"""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.reading.source import Source
from apartgen.stages.things.categories import TABLE


def assets(root: Path | None = None) -> Iterator[Source]:
    """One piece of every category and style; `load` builds it."""
    for category in TABLE:
        for style in furniture.styles(category):
            yield _source(category, style)


def _source(category: str, style: str) -> Source:
    d, w, h = (round(side * 1000) for side in TABLE[category].size)
    name = f"{category}/{style}/{d}x{w}x{h}/0"
    return Source(name, partial(furniture.load_asset, name))
