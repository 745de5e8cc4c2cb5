"""Rooms compared with a limit or a denial: `at least as large as`, `as big as … or bigger`, `not larger than`."""

from dataclasses import replace

from apartgen.stages.plan.reader.denied import none_before
from apartgen.stages.plan.reader.lexeme import Lexeme

RATIOS = {"at_least": 1.15, "at_most": 0.9}
"""What is no smaller than another room is asked to be a little larger, for plans differ a little."""
LESS = 0.75
"""What `not as large as` stands for, as `smaller than` does."""
INSIDE = ("determiner", "ordinal", "adjective", "size", "room", "stop")
"""What stands in the name of the room compared with."""


def compared_within(words: list[Lexeme]) -> list[Lexeme]:
    """Limits and denials of comparisons taken into what they compare by."""
    out = list(words)
    for k, word in enumerate(words):
        following = words[k + 1].kind if k + 1 < len(words) else ""
        if word.kind == "compare" and following not in ("number", "area"):
            _limit(out, k)
            _deny(out, k)
    return [word for word in out if word.kind != "stop" or word.text]


def at_ratio(word: Lexeme, ratio: float) -> Lexeme:
    return replace(word, kind="compare", value=str(ratio), values=(ratio,))


def _limit(out: list[Lexeme], k: int) -> None:
    """`at least as large as A`, `as large as A or larger`, `as large as or larger than A`."""
    times = out[k].number == 0 and k > 1 and out[k - 1].kind == "number"
    said = k - 1 - times  # "at least three times as large as A"
    at = said if said >= 0 and out[said].kind == "bound" else _or_more(out, k)
    if at is None:
        return
    number = out[k - 1].number if times else out[k].number
    limit = replace(out[k], bounds=((out[at].value, number),))  # "at least twice as large as A"
    out[k] = at_ratio(out[k], RATIOS[out[at].value]) if out[k].number == 1.0 else limit
    for gone in (at, at + 1) if at + 1 < len(out) and out[at + 1].text == "than" else (at,):
        out[gone] = Lexeme("stop", "", "")


def _or_more(out: list[Lexeme], k: int) -> int | None:
    """Where the `or larger` stands that goes with the comparison at `k`."""
    at = k + 1
    while at < len(out) and out[at].kind in INSIDE:
        at += 1
    return at if at < len(out) and out[at].kind == "bound" and out[at].text.startswith("or ") else None


def _deny(out: list[Lexeme], k: int) -> None:
    """`must not be larger than A`, `neither is smaller than A`, `not as large as A`."""
    number = out[k].number
    alike = number == 1.0 and out[k].text.startswith("as ")
    if not (alike or number in (1.15, 1.3, 1.6, 0.9, 0.75, 0.6)):
        return
    no, none = k - 1, none_before(out, k)
    while no > 0 and out[no].kind == "stop" and out[no].value != "word":
        no -= 1
    if no >= 0 and out[no].kind == "negation" and out[no].value in ("not", "no"):
        out[no] = Lexeme("stop", "stop", "is")
    elif none is not None:
        several = out[none].text.startswith("neither") and out[none + 1].kind != "room"
        out[none] = Lexeme("determiner", "both" if several else "each", out[none].text)
    else:
        return
    out[k] = at_ratio(out[k], LESS if alike else RATIOS["at_most" if number > 1 else "at_least"])
