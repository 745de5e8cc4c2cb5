"""Classes keep to common sense; what was asked for wins."""

import numpy as np
import pytest
import torch

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.layout.features import EMPTY, N_CLASSES
from apartgen.stages.layout.guided import assign
from apartgen.stages.layout.sense import at_home, sense, settle
from apartgen.stages.things.categories import CATEGORIES


def classes(kind: str, seed: int, n: int = 9, wanted: dict[str, int] | None = None) -> list[str]:
    logits = np.random.default_rng(seed).normal(0, 3, (n, N_CLASSES)).astype(np.float32)
    logits[:, EMPTY] = -30
    asked = np.full(len(CATEGORIES), -1)
    for name, number in (wanted or {}).items():
        asked[CATEGORIES.index(name)] = number
    settle(logits, ROOM_TYPES.index(kind), asked)
    return [CATEGORIES[c] for c in logits.argmax(-1)]


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("kind", ["bedroom", "kitchen", "bathroom", "living_room", "study", "dining_room"])
def test_least_and_most_hold(kind: str, seed: int) -> None:
    found = classes(kind, seed)
    for group in sense().least[ROOM_TYPES.index(kind)]:
        assert any(CATEGORIES[c] in found for c in group)
    for number, group in sense().most:
        names = [CATEGORIES[c] for c in group]
        # A class that a room cannot do without may come on top of what it has most of.
        assert sum(name in names for name in found) <= number + 1


def test_what_is_asked_for_is_left_alone() -> None:
    logits = np.full((4, N_CLASSES), -5, np.float32)
    logits[:, CATEGORIES.index("tv")] = 5
    asked = np.full(len(CATEGORIES), -1)
    asked[CATEGORIES.index("tv")] = 4
    settle(logits, ROOM_TYPES.index("living_room"), asked)
    assert (logits.argmax(-1) == CATEGORIES.index("tv")).sum() == 3, "one makes place for a seat"


def test_what_needs_another_gets_it_or_goes_whichever_is_likelier() -> None:
    at = {name: CATEGORIES.index(name) for name in ("tv", "tv_stand", "sofa", "plant")}
    for stand, plant, expected in [(1.0, -4.0, {"tv", "tv_stand"}), (-4.0, 4.5, {"plant"})]:
        logits = np.full((3, N_CLASSES), -9, np.float32)
        logits[0, at["tv"]] = logits[1:, at["sofa"]] = 5
        logits[2, at["tv_stand"]], logits[0, at["plant"]] = stand, plant
        settle(logits, ROOM_TYPES.index("living_room"), np.full(len(CATEGORIES), -1))
        assert {CATEGORIES[c] for c in logits.argmax(-1)} == {"sofa", *expected}


def test_no_class_is_left_without_what_it_needs() -> None:
    for seed in range(60):
        found = classes("living_room", seed)
        for category, companions in sense().needs:
            assert CATEGORIES[category] not in found or {CATEGORIES[c] for c in companions} & set(found)


def test_rooms_do_not_take_what_belongs_elsewhere() -> None:
    table = at_home()
    for kind, name, allowed in [
        ("living_room", "bath", False), ("living_room", "double_bed", False), ("bedroom", "double_bed", True),
        ("bathroom", "toilet", True), ("kitchen", "toilet", False),
    ]:
        assert table[ROOM_TYPES.index(kind), CATEGORIES.index(name)] == allowed
    assert table[:, EMPTY].all()


def test_a_companion_is_not_made_where_there_are_enough_of_its_kind() -> None:
    """A nightstand needs a bed to stand at, but a room with a bunk bed gets no second bed for it."""
    logits = np.full((5, N_CLASSES), -5, np.float32)
    for slot, name in enumerate(["bunk_bed", "nightstand", "wardrobe", "plant", "rug"]):
        logits[slot, CATEGORIES.index(name)] = 5
    settle(logits, ROOM_TYPES.index("bedroom"), np.full(len(CATEGORIES), -1))
    names = [CATEGORIES[c] for c in logits.argmax(-1)]
    assert "bunk_bed" in names and not {"double_bed", "single_bed", "nightstand"} & set(names)


def test_a_table_has_chairs_for_two() -> None:
    logits = np.full((6, N_CLASSES), -5, np.float32)
    for slot, name in enumerate(["dining_table", "chair", "sofa", "tv_stand", "tv", "plant"]):
        logits[slot, CATEGORIES.index(name)] = 5
    logits[5, CATEGORIES.index("chair")] = 0
    settle(logits, ROOM_TYPES.index("living_room"), np.full(len(CATEGORIES), -1))
    assert [CATEGORIES[c] for c in logits.argmax(-1)] == ["dining_table", "chair", "sofa", "tv_stand", "tv", "chair"]


@pytest.mark.parametrize("seed", range(40))
def test_what_is_asked_for_and_what_a_room_is_for_stand_together(seed: int) -> None:
    logits = np.random.default_rng(seed).normal(0, 3, (8, N_CLASSES)).astype(np.float32)
    logits[:, EMPTY] = -30
    asked = np.full(len(CATEGORIES), -1)
    desk = asked[CATEGORIES.index("desk")] = 2
    assign(torch.from_numpy(logits), torch.from_numpy(asked))
    settle(logits, ROOM_TYPES.index("bedroom"), asked)
    found = [CATEGORIES[c] for c in logits.argmax(-1)]
    assert found.count("desk") == desk
    assert {"double_bed", "single_bed", "bunk_bed"} & set(found)
