"""Sets of furnished rooms that are compared: which count, and how they are split."""

from collections.abc import Iterable, Sequence

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Room

ALL = "apartment"
"""Stands for rooms of all types that the real set has."""
SEED = 0
"""Of splits and resamples."""
NOTE = (
    "Rooms of the types that the real set has; n of what a figure is a mean of in brackets: rooms, or cases of a "
    f"relation; intervals are of 95 % by bootstrap over rooms, seed {SEED}, and there is none of a single room"
)
Scene = tuple[Room, list[Box]]


def types(real: Iterable[Layout]) -> list[str]:
    """Types of rooms in a set."""
    return sorted({room.type for home in real for room in home.rooms})


def every(homes: Iterable[Layout], real: Iterable[Layout], kind: str = ALL) -> list[Scene]:
    """Every room of a type, or of any type that the real set has, with its objects."""
    wanted = set(types(real)) if kind == ALL else {kind}
    return [(room, [o for o in home.objects if o.room == room.id])
            for home in homes for room in home.rooms if room.type in wanted]


def rooms(homes: Iterable[Layout], real: Iterable[Layout], kind: str = ALL) -> list[Scene]:
    """As `every`, without rooms that hold nothing."""
    return [(room, inside) for room, inside in every(homes, real, kind) if inside]


def halves(generated: Sequence[Scene], real: Sequence[Scene]) -> tuple[list[Scene], list[Scene], list[Scene]]:
    """Equally many generated scenes, real scenes to compare with, and other real scenes, drawn at random.

    Equally many, because what is compared depends on their number.
    """
    rng = np.random.default_rng(SEED)
    mixed = [real[i] for i in rng.permutation(len(real))]
    n = min(len(generated), len(real) // 2)
    return [generated[i] for i in rng.permutation(len(generated))[:n]], mixed[:n], mixed[n : 2 * n]
