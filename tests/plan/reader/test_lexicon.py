"""Phrases are expanded when they are asked for, and are those that all patterns give."""

import pytest

from apartgen.stages.plan.reader.lexicon import Entries, Entry, expand, first_words, most_words, phrase, read_lexicon

PATTERNS = ["is", "{opens,opening} {onto,into}", "{,is,are} on the left {,side}", "{a,} b {c d,e}", "l'est", "a-b {c,}",
            "{baby's,kids'} room", "w/o", "küche {nord,süd}", "{,also} {,very} far"]  # fmt: skip


@pytest.mark.parametrize("pattern", PATTERNS)
def test_first_words_and_lengths_bound_the_phrases(pattern: str) -> None:
    phrases = [phrase(text) for text in expand(pattern)]
    assert first_words(pattern) == {words[0] for words in phrases if words}
    assert max(map(len, phrases)) <= most_words(pattern)


@pytest.mark.parametrize("pattern", PATTERNS)
def test_waiting_patterns_are_found(pattern: str) -> None:
    entries = Entries()
    entries.wait("link", "door", pattern)
    for words in filter(None, map(phrase, expand(pattern))):
        assert words in entries and entries.get(words) == (Entry("link", "door"),)
    assert ("nowhere",) not in entries


def test_no_phrase_is_longer_than_the_lexicon_says() -> None:
    lexicon = read_lexicon()
    assert max(len(words) for words, _ in lexicon.entries.items()) <= lexicon.longest
