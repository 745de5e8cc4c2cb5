"""How case furniture of a style looks: materials, front profile, handles, base."""

from dataclasses import dataclass, replace

import numpy as np


@dataclass(frozen=True)
class Look:
    """Material names of carcass, fronts, top, handles and base; profile, handle and base kinds.

    `hung` has the handles of doors at their lower edge, where people reach what hangs on a wall.
    """

    body: str
    front: str
    top: str
    metal: str
    profile: str
    handle: str
    base: str
    leg: str
    overhang: float = 0.0
    hung: bool = False

    def with_(self, **changes: object) -> "Look":
        """The same look but for some fields."""
        return replace(self, **changes)  # type: ignore[arg-type]


_LOOKS: dict[str, tuple[Look, ...]] = {
    "modern": (
        Look("white", "white", "white", "aluminium", "slab", "edge", "plinth", "graphite"),
        Look("greige", "greige", "greige", "black_metal", "slab", "edge", "plinth", "graphite"),
        Look("light_oak", "white", "light_oak", "aluminium", "slab", "edge", "plinth", "graphite"),
        Look("graphite", "graphite", "oak", "black_metal", "slab", "edge", "plinth", "black"),
    ),
    "scandi": (
        Look("white", "light_oak", "light_oak", "light_oak", "slab", "knob", "taper", "light_oak"),
        Look("birch", "birch", "birch", "tan_leather", "slab", "tab", "taper", "birch"),
        Look("birch", "white", "birch", "birch", "slab", "knob", "taper", "birch"),
        Look("oak", "dusk_blue", "oak", "oak", "slab", "knob", "taper", "oak"),
    ),
    "shaker": (
        Look("cream", "cream", "oak", "brass", "shaker", "knob", "bracket", "cream", 0.012),
        Look("sage", "sage", "oak", "brass", "shaker", "cup", "bracket", "sage", 0.012),
        Look("navy", "navy", "marble", "brass", "shaker", "knob", "bracket", "navy", 0.012),
        Look("white", "white", "pine", "black_metal", "shaker", "cup", "bracket", "white", 0.012),
    ),
    "industrial": (
        Look("dark_oak", "dark_oak", "dark_oak", "black_metal", "plank", "bar", "frame", "black_metal"),
        Look("black", "oak", "oak", "black_metal", "plank", "bar", "frame", "black_metal"),
        Look("graphite", "graphite", "pine", "black_metal", "slab", "bar", "frame", "black_metal"),
    ),
    "classic": (
        Look("cherry", "cherry", "cherry", "brass", "raised", "knob", "turned", "cherry", 0.018),
        Look("walnut", "walnut", "walnut", "brass", "raised", "knob", "turned", "walnut", 0.018),
        Look("cream", "cream", "cream", "brass", "raised", "knob", "turned", "cream", 0.018),
    ),
    "midcentury": (
        Look("walnut", "walnut", "walnut", "brass", "fluted", "none", "splay", "walnut"),
        Look("teak", "teak", "teak", "brass", "fluted", "none", "splay", "teak"),
        Look("walnut", "white", "walnut", "brass", "slab", "knob", "splay", "walnut"),
    ),
    "japandi": (
        Look("oak", "cane", "oak", "black_metal", "woven", "tab", "sled", "oak"),
        Look("ash_black", "cane", "ash_black", "brass", "woven", "tab", "sled", "ash_black"),
        Look("light_oak", "cane", "light_oak", "brass", "woven", "knob", "sled", "light_oak"),
    ),
}  # fmt: skip

CASE_STYLES: tuple[str, ...] = tuple(_LOOKS)


def look(style: str, rng: np.random.Generator) -> Look:
    """A look of the style, by the seed."""
    options = _LOOKS[style]
    return options[int(rng.integers(len(options)))]
