"""Designs that the shipped index does not know, of categories or styles that packages bring: encoded when asked for."""

from collections.abc import Sequence

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.shape import designs
from apartgen.stages.retrieve.shape.encoder import encode
from apartgen.stages.things.latents import Index


def encoded(maker: designs.Maker, category: str, styles: Sequence[str]) -> Index:
    """Rows for some styles of a category, at the sizes and seeds that the shipped index has of its own."""
    found = [design for design in designs.indexed(maker, [category]) if design.style in styles]
    latent = encode(designs.fields(maker, found)).astype(np.float16).astype(np.float64)
    return Index(
        (category,) * len(found),
        tuple(design.style for design in found),
        np.array([design.seed for design in found], np.int64),
        np.array([design.size for design in found]),
        latent,
        {},
    )


def sound(maker: designs.Maker, category: str, styles: Sequence[str]) -> tuple[list[Index], list[BadInput]]:
    """The rows of the styles that can be made, and what is wrong with the others."""
    try:
        return [encoded(maker, category, styles)], []
    except BadInput as error:
        if len(styles) == 1:
            return [], [error]
    each = [sound(maker, category, [style]) for style in styles]
    return [table for found, _ in each for table in found], [error for _, wrong in each for error in wrong]


def joined(first: Index, second: Index) -> Index:
    """The rows of two, one after the other."""
    return Index(
        first.category + second.category,
        first.style + second.style,
        np.concatenate([first.seed, second.seed]),
        np.concatenate([first.size, second.size]),
        np.concatenate([first.latent, second.latent]),
        first.record,
    )
