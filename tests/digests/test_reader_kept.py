"""What sentences that nobody wrote are read as, or why not, as it was."""

from collections.abc import Iterable
from itertools import islice

import numpy as np
import pytest
from digests import composed, kept

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.plan import reader

GROUP = 20
"""Sentences a digest."""


def told(texts: Iterable[str]) -> dict[str, list[object]]:
    """What becomes of sentences, in groups."""
    found, rest = dict[str, list[object]](), iter(texts)
    while some := list(islice(rest, GROUP)):
        found[f"{len(found)}"] = [read(text, k) for k, text in enumerate(some)]
    return found


def read(text: str, seed: int) -> object:
    """A programme, or why there is none."""
    try:
        return reader.read(text, np.random.default_rng(seed))
    except (BadInput, Unmet) as error:
        return str(error)


@pytest.mark.parametrize("language", ["en", "de", "fr", "es", "zh"])
@pytest.mark.wide
def test_clauses(language):
    kept.same("reader", f"clauses {language}", told(composed.clauses(language, 400 if language == "en" else 160)))


def test_known_prompts():
    kept.same("reader", "known", told(composed.prompts()))


@pytest.mark.wide
@pytest.mark.parametrize("part", range(4))
def test_asked_elsewhere(part):
    """Sentences of the reader's own tests, which look at some of what is read."""
    kept.same("reader", f"asked {part}", told(composed.asked()[part::4]))


@pytest.mark.wide
def test_spliced_of_those():
    kept.same("reader", "spliced of asked", told(composed.spliced(400, composed.asked())))


@pytest.mark.wide
def test_spliced():
    kept.same("reader", "spliced", told(composed.spliced(500, composed.prompts())))


@pytest.mark.wide
def test_spoiled():
    kept.same("reader", "spoiled", told(composed.spoiled(600)))
