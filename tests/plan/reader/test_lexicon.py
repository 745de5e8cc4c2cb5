"""Phrases are expanded when they are asked for, and are those that all patterns give."""

import pytest

from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.lexicon import Entries, Entry, read_lexicon
from apartgen.stages.plan.reader.phrase import first_letters, first_words, most_words, phrase, plural
from apartgen.stages.plan.reader.tables import expand
from apartgen.stages.plan.reader.tokens import fold, tokenize

PATTERNS = ["is", "{opens,opening} {onto,into}", "{,is,are} on the left {,side}", "{a,} b {c d,e}", "l'est", "a-b {c,}",
            "{baby's,kids'} room", "w/o", "küche {nord,süd}", "{,also} {,very} far", "{été,à} côté", "十"]
# fmt: skip


@pytest.mark.parametrize("pattern", PATTERNS)
def test_first_words_and_lengths_bound_the_phrases(pattern: str) -> None:
    phrases = [phrase(text) for text in expand(pattern)]
    assert first_words(pattern) == {words[0] for words in phrases if words}
    assert first_letters(pattern) == {words[0][0] for words in phrases if words}
    assert max(map(len, phrases)) <= most_words(pattern)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_waiting_patterns_are_found(pattern: str) -> None:
    entries = Entries()
    entries.wait("link", "door", pattern)
    for words in filter(None, map(phrase, expand(pattern))):
        assert words in entries and entries.get(words) == (Entry("link", "door"),)
    assert ("nowhere",) not in entries


@pytest.mark.parametrize("pattern", ["den", "{dining,breakfast} {nook,}", "room for {work,reading}", "pantry", "küche"])
def test_nouns_are_found_in_both_numbers(pattern: str) -> None:
    entries = Entries()
    entries.wait("room", "study", pattern)
    for words in map(phrase, expand(pattern)):
        assert entries.get(words) == (Entry("room", "study"),)
        assert entries.get(plural(words)) == (Entry("room", "study", plural=True),)
    waiting = Entries()
    waiting.wait("room", "study", pattern)
    assert {w for words, _ in entries.items() for w in words} <= {fold(word) for word, _ in waiting.words()}


def test_phrases_are_split_as_tokens_are() -> None:
    for words, _ in list(read_lexicon().entries.items())[::7]:
        text = " ".join(words)
        assert phrase(text) == tuple(t.text for t in tokenize(fold(text)) if t.text != "-")


def test_no_phrase_is_longer_than_the_lexicon_says() -> None:
    lexicon = read_lexicon()
    assert max(len(words) for words, _ in lexicon.entries.items()) <= lexicon.longest


def test_what_is_asked_for_first_makes_no_difference() -> None:
    """Patterns wait for words with their first letters; all were expanded at once in what this is held against."""
    at_once, one_by_one = (read_lexicon.__wrapped__().entries for _ in range(2))
    all_of_them = dict(at_once.items())
    assert len(all_of_them) > 10_000
    for words in sorted(all_of_them, key=lambda words: words[::-1]):
        assert one_by_one.get(words) == all_of_them[words], words


def test_the_first_of_two_that_say_the_same_counts() -> None:
    entries = Entries()
    for value, pattern in (("first", "{alpha,beta} room"), ("second", "alpha room"), ("third", "{,beta} room")):
        entries.wait("room", value, pattern)
    assert [entries.get((word, "room"))[0].value for word in ("beta", "alpha")] == ["first", "first"]
    assert entries.get(("room",)) == (Entry("room", "third"),)


def test_a_word_without_letters_is_no_phrase() -> None:
    assert read_lexicon().entries.get(("",)) is None and ("",) not in read_lexicon().entries
    spec = read("spec: {beds: 3, baths: 2, ensuite_for: bedroom_1, hall_width_min: 1.2}")
    assert sum(room.type == "bedroom" for room in spec.rooms) == 3
