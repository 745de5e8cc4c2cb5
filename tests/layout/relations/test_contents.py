"""What a room holds: exactly what was asked for, whatever the weights are."""

import numpy as np
import pytest

from apartgen.stages.layout.relations import contents, order, trained
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.things.categories import CATEGORIES

C = len(CATEGORIES)
SMALL = Training(shape=Shape(width=32, heads=2, scene_layers=1, frame_layers=1, key=8))
RULES = contents.Rules(order.ranks(), np.ones(C, bool), ())


def drawn(seed: int, count: int = -1, wanted: dict[str, int] | None = None, rules: contents.Rules = RULES,
          given: dict[str, int] | None = None) -> list[str]:
    asked = np.full(C, contents.UNKNOWN)
    for name, number in (wanted or {}).items():
        asked[CATEGORIES.index(name)] = number
    there = np.bincount([CATEGORIES.index(name) for name, k in (given or {}).items() for _ in range(k)], minlength=C)
    model = trained.frozen(trained.empty(SMALL.model_copy(update={"seed": seed % 3})))
    facts = np.random.default_rng(seed).normal(size=contents.FACTS).astype(np.float32)
    rngs = [np.random.default_rng([seed, k]) for k in range(2)]
    found = contents.draw(model.contents, seed % 11, facts, count, asked, rules, rngs, there)[seed % 2]
    return [CATEGORIES[c] for c in found]


@pytest.mark.parametrize("seed", range(20))
def test_the_number_asked_for_is_met(seed: int) -> None:
    count = seed % 12 + 1
    assert len(drawn(seed, count)) == count


@pytest.mark.parametrize("seed", range(20))
def test_categories_asked_for_are_met_and_none_where_none_is_wanted(seed: int) -> None:
    found = drawn(seed, 9 if seed % 2 else -1, {"desk": 2, "chair": 3, "rug": 0, "table_lamp": 1})
    assert [found.count(name) for name in ("desk", "chair", "rug", "table_lamp")] == [2, 3, 0, 1]


@pytest.mark.parametrize("seed", range(12))
def test_what_a_room_is_never_without_is_there(seed: int) -> None:
    group = tuple(CATEGORIES.index(name) for name in ("double_bed", "single_bed"))
    rules = contents.Rules(RULES.rank, RULES.known, (group,))
    found = drawn(seed, 1 if seed % 2 else -1, rules=rules)
    assert {"double_bed", "single_bed"} & set(found)


def test_what_cannot_be_drawn_is_not() -> None:
    known = np.array([name != "sofa" for name in CATEGORIES])
    rules = contents.Rules(RULES.rank, known, ())
    assert not any("sofa" in drawn(seed, 12, rules=rules) for seed in range(15))


def test_contents_come_in_functional_order() -> None:
    found = drawn(5, 12)
    ranks = [order.ranks()[CATEGORIES.index(name)] for name in found]
    assert ranks == sorted(ranks)


def test_seven_of_a_kind_are_told_from_six() -> None:
    """A table for eight has more than six chairs, and an even number of them."""
    told = contents.reached(np.arange(contents.UP_TO + 1)[:, None], 1)
    assert contents.UP_TO >= 8 and len(np.unique(told, axis=0)) == contents.UP_TO + 1
