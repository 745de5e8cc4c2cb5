"""Lanes as another program would make them from what the documents say."""

import hashlib
import struct

import numpy as np
import pytest

from apartgen.stages import seeds


def words(*names: str) -> tuple[int, ...]:
    """Eight bytes of each name's SHA-256, as two little-endian words."""
    return tuple(word for name in names for word in struct.unpack("<II", hashlib.sha256(name.encode()).digest()[:8]))


@pytest.mark.parametrize(("seed", "names"), [(0, ()), (7, ("layout", "abc")), (2**40, ("plan", "é"))])
def test_lanes_are_told_by_two_words_a_name(seed: int, names: tuple[str, ...]) -> None:
    by_hand = np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed, spawn_key=words(*names))))
    assert seeds.drawn(seed, *names).random(4).tolist() == by_hand.random(4).tolist()
    deeper = np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed, spawn_key=words(*names, "bedroom_1"))))
    assert seeds.lane(seeds.drawn(seed, *names), "bedroom_1").random() == deeper.random()
