"""The furniture vocabulary: sizes, where things stand, what opens and how far it sweeps.

The data is `categories.toml`; the order of `CATEGORIES` is alphabetical, so that class indices are stable.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from apartgen.schemas.layout import Box

Place = Literal["floor", "wall", "ceiling", "top", "flat"]
Opens = Literal["", "leaf", "drawer", "flap", "lid", "sliding"]

DRAWER_TRAVEL = 0.75
"""A drawer comes out by this share of its unit's depth."""
OVEN_TOWER = 1.3
"""Ovens that are higher stand in a tower, others under a worktop or their own hob, m."""
LEAST_CLEARANCE_HEIGHT = 1.8
"""What hangs above this is no obstacle to people, m."""


@dataclass(frozen=True)
class Category:
    """One kind of furniture; sizes are [depth, width, height] in metres."""

    name: str
    place: Place
    rooms: tuple[str, ...]
    size: tuple[float, float, float]
    min: tuple[float, float, float]
    max: tuple[float, float, float]
    opens: Opens = ""
    leaf_max: float = 0.6
    flap: float = 0.0
    belongs: tuple[str, ...] = ()
    z: float = 0.0
    back: bool = False
    soft: bool = False
    loose: bool = False
    synonyms: tuple[str, ...] = ()

    @property
    def articulated(self) -> bool:
        """Whether any part of it moves."""
        return self.opens != ""


def _load() -> dict[str, Category]:
    table = tomllib.loads((Path(__file__).parent / "categories.toml").read_text())
    return {name: Category(name=name, **_frozen(table[name])) for name in sorted(table)}


def _frozen(row: dict[str, Any]) -> dict[str, Any]:
    return {key: tuple(value) if isinstance(value, list) else value for key, value in row.items()}


TABLE: dict[str, Category] = _load()
CATEGORIES: tuple[str, ...] = tuple(TABLE)


def leaves(category: str, width: float) -> int:
    """How many hinged doors stand side by side across `width` metres."""
    return max(1, int(np.ceil(width / TABLE[category].leaf_max - 1e-6)))


def reach(category: str, size: ArrayLike) -> NDArray[np.float64]:
    """How far open parts may stand out in front of a box, metres.

    An upper bound over all designs of the category, used before an asset is chosen and kept by every
    asset of the embedded library. `size` is (..., 3); returns (...,).
    """
    d, w, h = np.moveaxis(np.asarray(size, float), -1, 0)
    kind = TABLE[category]
    match kind.opens:
        case "leaf":
            out = w / np.maximum(1, np.ceil(w / kind.leaf_max - 1e-6))
        case "drawer":
            out = DRAWER_TRAVEL * d
        case "flap":
            out = kind.flap * h
        case _:
            out = np.zeros_like(d)
    return np.asarray(out, float)


@cache
def groups() -> frozenset[tuple[str, str]]:
    """Ordered pairs (child, parent) that touch by design, such as a chair and its table."""
    return frozenset((c.name, parent) for c in TABLE.values() for parent in c.belongs)


def belong_together(a: str, b: str) -> bool:
    """Whether contact between categories `a` and `b` is part of their use."""
    return (a, b) in groups() or (b, a) in groups()


INSTEAD = {
    "double_bed": ("single_bed",), "bunk_bed": ("single_bed",), "wardrobe": ("sliding_wardrobe",),
    "sliding_wardrobe": ("wardrobe",), "corner_sofa": ("sofa", "armchair"), "sofa": ("armchair",),
    "bath": ("shower",), "dining_table": ("round_table",),
}
"""Kinds that do for another."""
SEATS = frozenset({"chair", "office_chair", "stool", "bench", "balcony_chair"})


def tucks(a: str, b: str) -> bool:
    """Whether one is a seat that may be drawn under the other."""
    return belong_together(a, b) and (a in SEATS or b in SEATS)


@cache
def by_word() -> dict[str, str]:
    """Category of every synonym, lower case."""
    own = {c.name.replace("_", " "): c.name for c in TABLE.values()}
    return own | {word: c.name for c in TABLE.values() for word in c.synonyms}


def fitted_ovens(objects: Sequence[Box]) -> frozenset[str]:
    """Ids of ovens fitted into a kitchen with a hob of its own; elsewhere an oven is a cooker."""
    hobs = {o.room for o in objects if o.category == "hob"}
    return frozenset(o.id for o in objects if o.category == "oven" and o.room in hobs)
