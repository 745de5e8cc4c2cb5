"""Sizes of the relations network."""

from apartgen.schemas.base import Record


class Shape(Record):
    """Width of a token, heads and layers of both encoders, width of what pointers compare."""

    width: int = 128
    heads: int = 4
    ratio: int = 3
    scene_layers: int = 2
    frame_layers: int = 3
    key: int = 32
