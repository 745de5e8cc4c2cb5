"""What tests of phrases drawn at random share: a draw makes a text and what it means at once, so that what is meant is
known without reading.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

import numpy as np
import pytest

HOMES = ("Two-bedroom flat. ", "Living room, kitchen, bathroom and two bedrooms. ", "2 bed flat. ",
         "A home with a living room, a kitchen, two bedrooms and one bathroom. ",
         "We are looking for a flat with two bedrooms. ")  # fmt: skip
"""Before what is said of a home: all have the same rooms."""
USUAL_ROOMS = ["bathroom_1", "bedroom_1", "bedroom_2", "hallway_1", "kitchen_1", "living_room_1"]
"""Those."""

Meant = TypeVar("Meant")


def one(rng: np.random.Generator, some: Iterable[str]) -> str:
    """One of these."""
    return str(rng.choice(list(some)))


def upper(text: str) -> str:
    """A text that begins a sentence."""
    return text[0].upper() + text[1:]


def article(noun: str) -> str:
    """`an oven`, `a utility room`."""
    return f"an {noun}" if noun[0] in "aeio" else f"a {noun}"


def as_drawn(
    said: Sequence[Callable[[np.random.Generator], tuple[str, Meant]]],
    wrong: Callable[[str, Meant], str],
    seed: int,
    draws: int = 60,
) -> Callable[[Callable[[np.random.Generator], tuple[str, Meant]]], None]:
    """The test that nothing is `wrong` with any of so many draws of each kind."""

    @pytest.mark.parametrize("drawn", said, ids=lambda drawn: drawn.__name__)
    def test(drawn: Callable[[np.random.Generator], tuple[str, Meant]]) -> None:
        rng = np.random.default_rng(seed)
        faults = [(text, fault) for text, meant in (drawn(rng) for _ in range(draws)) if (fault := wrong(text, meant))]
        assert not faults

    return test
