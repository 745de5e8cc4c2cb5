"""Sentences nobody wrote: clauses of a small grammar, pieces of known prompts, and what is left when one breaks off."""

import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from random import Random

HERE = Path(__file__).parent
CUT = re.compile(r"(?<=[.;])\s+|,\s+|(?<=[，。；、])")
JOINTS = {"en": (", ", ". ", " and ", "; ", " but ", ", where "), "zh": ("，", "。", "、")}
SLIP = re.compile(r"\b[a-z]{5,}\b")


def clauses(language: str, many: int) -> Iterator[str]:
    """Sentences of the grammar."""
    words = tomllib.loads((HERE / "clauses.toml").read_text(encoding="utf-8"))[language]
    rng = Random(language)
    holes = {"r": "rooms", "s": "rooms", "n": "numbers", "a": "areas", "l": "lengths", "d": "sides", "o": "objects"}

    def filled(kind: str) -> str:
        return re.sub(r"\{(\w)}", lambda found: rng.choice(words[holes[found[1]]]), rng.choice(words[kind]))

    for _ in range(many):
        said = [filled("home"), *(filled("clauses") for _ in range(rng.choice((0, 1, 1, 2, 2, 3, 4))))]
        text = said[0] + "".join(rng.choice(JOINTS.get(language, (", ", ". ", "; "))) + one for one in said[1:])
        yield text + rng.choice(("", ".", "!"))


def prompts() -> list[str]:
    """What was written for the tests of the reader."""
    return (HERE / "prompts.txt").read_text(encoding="utf-8").splitlines()


def asked() -> list[str]:
    """What the reader's own tests ask it."""
    return (HERE / "asked.txt").read_text(encoding="utf-8").splitlines()


def benchmark() -> list[str]:
    """The prompts of the benchmark."""
    lines = (HERE.parent / "sentences" / "sentences.jsonl").read_text(encoding="utf-8").splitlines()
    return [json.loads(line)["prompt"] for line in lines]


def spliced(many: int, whole: list[str]) -> Iterator[str]:
    """Beginnings of prompts with pieces of others behind them."""
    rng = Random("spliced")
    pieces = [[one for text in whole if chinese(text) == kind for one in CUT.split(text)] for kind in (False, True)]
    for _ in range(many):
        first = rng.choice(whole)
        kept = CUT.split(first)[: rng.randint(1, 3)]
        between = "，" if chinese(first) else rng.choice((", ", ". ", "; "))
        yield between.join([*kept, *(rng.choice(pieces[chinese(first)]) for _ in range(rng.randint(1, 3)))])


def spoiled(many: int) -> Iterator[str]:
    """Prompts that break off, change one of their numbers, or have one letter wrong."""
    rng, whole = Random("spoiled"), [*prompts(), *benchmark()]
    for k in range(many):
        text = rng.choice(whole)
        if k % 3 == 0:
            words = list(text) if chinese(text) else text.split()
            yield ("" if chinese(text) else " ").join(words[: rng.randint(1, len(words))])
        elif k % 3 == 1:
            yield re.sub(r"\d+", lambda found: str(rng.choice((0, 1, 3, 14, 1000, int(found[0]) + 1))), text)
        else:
            yield SLIP.sub(lambda found: slip(found[0], rng) if rng.random() < 0.15 else found[0], text)


def slip(word: str, rng: Random) -> str:
    """A word with a letter left out, doubled, or in the place of its neighbour."""
    k = rng.randint(1, len(word) - 2)
    before, one, other, behind = word[:k], word[k], word[k + 1], word[k + 2:]
    return before + rng.choice((other, one + one + other, other + one)) + behind


def chinese(text: str) -> bool:
    """Whether it has Chinese characters."""
    return any("\u4e00" <= sign <= "\u9fff" for sign in text)
