"""What a pattern needs stands in all that it finds, so that nothing is lost where it is not compiled."""

import tomllib
from pathlib import Path

import pytest
from sentences import cases

from apartgen.stages.plan.reader import lexicon
from apartgen.stages.plan.reader.about import about
from apartgen.stages.plan.reader.patterns import Late, needed
from apartgen.stages.plan.reader.people import housed
from apartgen.stages.plan.reader.tables import tables
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.unread import limits

LEXICON = sorted((Path(lexicon.__file__ or "").parent / "lexicon").glob("*.toml"))


@pytest.mark.parametrize(
    ("pattern", "needs"),
    [
        ("flat", [{"flat"}]),
        (r"\bkids?\b", [{"kid"}]),
        ("(?:house|villa)s?", [{"house", "villa"}]),
        ("a(?:bc)?d", [{"a"}, {"d"}]),
        ("ab+c", [{"ab"}, {"c"}]),
        ("ab*c", [{"a"}, {"c"}]),
        ("one|two three", [{"one", "two three"}]),
        (r"(?:\w+|lift)", []),
        ("(?<!x)lift(?! shaft)", [{"lift"}]),
        ("[ab]c{0,2}d", [{"d"}]),
        (r"(?P<n>\d+) rooms", [{" rooms"}]),
        (r"\w+ \(\d", [{" ("}]),
        (r"a\(?b\.", [{"a"}, {"b."}]),
        ("{who} sleeps", [{"twins", "boy"}, {" sleeps"}]),
        ("{who}* sleeps", [{" sleeps"}]),
    ],
)
def test_needs(pattern: str, needs: list[set[str]]) -> None:
    assert [set(words) for words in needed(pattern, {"who": "twins|boys?"})] == needs


def test_nothing_that_a_pattern_finds_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = [fold(case.prompt) for case in cases()]
    texts += [words for text in texts for words in text.split(", ") if len(words) > 3]
    quick = [(about(text), housed(text), limits(text)) for text in texts]
    monkeypatch.setattr(Late, "lacked_by", lambda self, text: False)
    assert quick == [(about(text), housed(text), limits(text)) for text in texts]


@pytest.mark.parametrize("file", LEXICON, ids=lambda file: file.stem)
def test_the_files_of_the_lexicon_are_toml(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    assert tables(text) == tomllib.loads(text)
