"""Sentences that break off: read or refused, never a traceback."""

import json
from itertools import accumulate
from pathlib import Path

import pytest

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Program
from apartgen.stages.plan.reader import read

LINES = (Path(__file__).parents[2] / "sentences/sentences.jsonl").read_text(encoding="utf-8").splitlines()
PROMPTS = [json.loads(line)["prompt"] for line in LINES]
PARTS = 3


@pytest.mark.parametrize("part", range(PARTS))
def test_a_sentence_may_break_off_behind_any_word(part: int) -> None:
    """Every 24th prompt of the benchmark, shorter ones and longer ones."""
    for prompt in sorted(PROMPTS, key=len)[part * 8 :: 8 * PARTS]:
        for begun in accumulate(prompt.split()[:40], "{} {}".format):
            try:
                assert isinstance(read(begun), Program)
            except (BadInput, Unmet) as error:
                assert str(error), begun


@pytest.mark.parametrize("prompt", ["0 of two-bedroom ) m four . a m four", "0 of the two bedrooms four"])
def test_pieces_that_say_none_of_a_room_first_are_read_or_refused(prompt: str) -> None:
    """Of a draw of damaged prompts."""
    try:
        assert isinstance(read(prompt), Program)
    except (BadInput, Unmet) as error:
        assert str(error)


def test_rooms_that_are_next_to_nothing_are_not_next_to_each_other() -> None:
    assert not read("Two bedrooms. The bedrooms should be next to").requirements
    assert read("Two bedrooms. The bedrooms should be next to each other.").requirements
