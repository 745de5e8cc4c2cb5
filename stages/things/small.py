"""Small things: what people keep in and on their furniture, in sizes, masses and looks; the data is `small.toml`.

A thing is drawn in parts whose places are shares of its box, so that one entry serves every size. Its id holds all that
makes it, `mug/straight/115x82x95/3`; a style that ends in `_lying` is the same thing laid on its left side.
"""

import tomllib
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np
from pydantic import ConfigDict, TypeAdapter

LYING = "_lying"
Size = tuple[float, float, float]
AnyLength = TypeVar("AnyLength", int, float)
_EDGES, _PRINT = ("frame", "mount"), "print"
_SEEDS = 12
LATITUDE = 0.2
"""So much smaller or larger than is drawn today may a thing be that a home has: earlier versions drew others."""
Part = tuple[Any, ...]
"""A shape's name, the slot of its material, and where it is in the box."""


@dataclass(frozen=True, kw_only=True)
class Small:
    """One kind of small thing; `small.toml` says what each fact is."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    name: str = ""
    min: Size
    max: Size
    mass: tuple[float, float]
    weighed: tuple[str, ...]
    listed: tuple[float, float] | None = None
    entry: str = ""
    friction: float = 0.5
    surface: str = "hard"
    looks: dict[str, tuple[str, ...]]
    styles: dict[str, tuple[Part, ...]]
    former: tuple[str, ...] = ()
    collide: tuple[Part, ...] = (("box",),)
    designs: int = 2
    rests: bool = False
    pitch: float = 1.0
    fixed: bool = False
    wide: bool = False
    affords: tuple[str, ...] = ()
    on: float = 0.0

    @property
    def round(self) -> bool:
        """Whether it is as deep as wide and looks alike from all sides."""
        return self.min[0] == self.min[1] and self.max[0] == self.max[1] and all(
            shape in ("turn", "pot") and len(numbers) < 3
            for parts in self.styles.values() for shape, _, *numbers in parts)

    @property
    def bears(self) -> float:
        """How high is what lies on it, as a share of its own height."""
        return float(self.collide[0][-1]) if len(self.collide) > 1 else 1.0

    @property
    def seeds(self) -> int:
        """How many sets of colours models of it have."""
        return max(_SEEDS, *map(len, self.looks.values()))

    @property
    def called(self) -> str:
        """Its name in sentences."""
        return self.name.replace("_", " ")


class Design(NamedTuple):
    """One model of a kind: its style, its size standing, and the seed of its colours."""

    kind: Small
    style: str
    size: Size
    seed: int

    def size_of(self, lying: bool = False) -> Size:
        """Depth, width and height as it stands or lies."""
        d, w, h = self.size
        return (d, h, w) if lying else self.size

    def id(self, lying: bool = False) -> str:
        """The asset's id."""
        d, w, h = (round(side * 1000) for side in self.size_of(lying))
        return f"{self.kind.name}/{self.style}{LYING * lying}/{d}x{w}x{h}/{self.seed}"


def _load() -> dict[str, Small]:
    rows = tomllib.loads((Path(__file__).parent / "small.toml").read_text(encoding="utf-8"))
    kinds = TypeAdapter(dict[str, Small]).validate_python(rows)
    return {name: replace(kind, name=name) for name, kind in kinds.items()}


TABLE: dict[str, Small] = _load()


@cache
def styles(name: str) -> tuple[str, ...]:
    """The styles of a kind, those of what may lie too."""
    own = tuple(TABLE[name].styles)
    return (*own, *(style + LYING for style in own)) if TABLE[name].rests else own


def upright(style: str, size: tuple[AnyLength, ...]) -> tuple[str, tuple[AnyLength, AnyLength, AnyLength]]:
    """The style and size that a thing has as it stands."""
    d, w, h = size
    return (style.removesuffix(LYING), (d, h, w)) if style.endswith(LYING) else (style, (d, w, h))


def mass(kind: Small, size: Size) -> float:
    """What a thing of that size weighs, kg: between the lightest and the heaviest of its kind as its volume is."""
    least, most, own = (float(np.prod(side)) for side in (kind.min, kind.max, size))
    share = (own - least) / (most - least) if most > least else 0.5
    return float(np.interp(share, [0, 1], kind.mass))


def drawn(kind: Small, rng: np.random.Generator) -> Design:
    """A model of a kind; its sides grow together, those of round things alike."""
    low, high = np.asarray(kind.min), np.asarray(kind.max)
    share = np.clip(rng.uniform(0, 1) + np.array([0.0, 0.0, rng.normal(0, 0.15)]), 0, 1)
    if kind.wide:
        share = rng.uniform(0, 1, 3)
    d, w, h = np.round((low + share * (high - low)) * 1000) / 1000
    names = [style for style in kind.styles if style not in kind.former]
    style = names[int(rng.integers(len(names)))]
    return Design(kind, style, (float(d), float(w), float(h)), int(rng.integers(kind.seeds)))


def worn(kind: Small, seed: int) -> dict[str, str]:
    """A material for each slot: seeds in a row go through those of the first, the others are by chance."""
    chance = np.random.default_rng([seed, *kind.name.encode()])
    (first, names), *rest = kind.looks.items()
    return {first: names[seed % len(names)]} | {slot: own[int(chance.integers(len(own)))] for slot, own in rest}


def look(design: Design) -> tuple[str, ...]:
    """What tells a model from another across a room: what is printed on it, or its style, and the colours that it shows
    but for those of frame and mount."""
    colours = worn(design.kind, design.seed)
    shown = {slot for _, slot, *_ in design.kind.styles[design.style]}.difference(_EDGES)
    return "" if _PRINT in shown else design.style, *(colours[slot] for slot in colours if slot in shown)
