"""Numbers with their units: areas, shares, counts of listings."""

from collections.abc import Sequence
from dataclasses import replace

from apartgen.stages.plan.reader.at_least import compared_within
from apartgen.stages.plan.reader.bounds import bounded
from apartgen.stages.plan.reader.contrasted import that_hold
from apartgen.stages.plan.reader.denied import limits_denied, nowhere_less
from apartgen.stages.plan.reader.dimensions import dimensions
from apartgen.stages.plan.reader.extents import extents
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.listings import (
    bare,
    bare_limits,
    counted_behind,
    listing,
    made,
    numbers_joined,
    paired_off,
    sized_anew,
)
from apartgen.stages.plan.reader.ranged import ranged

SQUARE_METRES = {"m2": 1.0, "ft2": 0.09290304}

LENGTHS = ("m", "meter", "meters", "metre", "metres", "metros", "metro")
BETWEEN = ("between", "entre", "zwischen")
OF_THAT = (["of", "that"], ["of", "it"])
COMPARATIVES = ("larger", "bigger", "smaller")
MORE_OR_LESS = (1.3, 0.75)
"""What `larger than` and `smaller than` are read as, where nobody says by how much."""
SAID = 1e-6
"""What tells such a ratio that is said from one that is not."""


def quantities(words: list[Lexeme]) -> list[Lexeme]:
    """Merge compound numbers, then numbers with their units into areas and shares."""
    words = _of_home(that_hold(_numbers(ranged(paired_off(words)))))
    return counted_behind(_of_things(_quantities(words)))


def _quantities(words: list[Lexeme]) -> list[Lexeme]:
    words = extents(nowhere_less(dimensions(words)))
    words = limits_denied(_one_of(_area_lists(bare_limits(_areas(_than_that(_by_percent(_shares(words))))))))
    return listing(sized_anew(bare(bounded(compared_within(words)))))


def _of_things(words: list[Lexeme]) -> list[Lexeme]:
    """The area of `4 cells of 6 m²`, things that no plan knows, is not the home's."""
    out = list(words)
    for k in range(3, len(words)):
        number, thing, of = words[k - 3 : k]
        told = number.kind == "number" and number.number > 1 and thing.kind == "unknown" and of.text in ("of", "with")
        if told and words[k].kind == "area":
            out[k] = Lexeme("unknown", "", words[k].text)
    return out


def _one_of(words: list[Lexeme]) -> list[Lexeme]:
    """The `one of` of `two of 10 m² and one of 15 m²` counts."""
    out: list[Lexeme] = []
    for word, after in zip(words, [*words[1:], Lexeme("mark", ".", ".")], strict=False):
        counts = word.text == "one of" and after.kind == "area"
        out += [Lexeme("number", "1", "one", values=(1.0,)), Lexeme("stop", "", "of")] if counts else [word]
    return out


def _of_home(words: list[Lexeme]) -> list[Lexeme]:
    """`un piso de 80 metros`, `an apartment of 60 meters` are square metres."""
    out = list(words)
    for k in range(2, len(words) - 1):
        number, unit, after = words[k], words[k + 1], words[k + 2 : k + 3]
        home = [w.kind for w in words[k - 2 : k]] == ["dwelling", "stop"] and words[k - 1].text in ("of", "de", "von")
        length = any(w.kind in ("adjective", "size") or w.text in ("long", "wide", "x", "by", "from") for w in after)
        if home and number.kind == "number" and number.number >= 20 and unit.text in LENGTHS and not length:
            out[k + 1] = replace(unit, kind="unit", value="m2")
    return out


def _numbers(words: list[Lexeme]) -> list[Lexeme]:
    """`twenty five` → 25, `eight hundred and ten` → 810, `two and a half` → 2.5, `two or three` → 2."""
    out: list[Lexeme] = []
    for k, word in enumerate(words):
        last = out[-1] if out and out[-1].kind == "number" else None
        joint = words[k - 1].text if k and words[k - 1].text in ("and", "or") else ""
        following = words[k + 1] if k + 1 < len(words) else None
        if last is None or not (word.kind in ("number", "fraction") or (following and _binds(last, word, following))):
            out.append(word)
        elif word.kind in ("number", "fraction"):
            total = _joined(last, joint, word)
            if total is None:
                out.append(word)
            else:
                out[-1] = replace(last, value=str(total), text=f"{last.text} {word.text}", values=(total,))
    return out


def _binds(last: Lexeme, word: Lexeme, following: Lexeme) -> bool:
    """Whether `and` or `or` stands inside one number."""
    if word.text == "and" and following.kind == "number":
        return last.number >= 100 and last.number % 100 == 0 and following.number < 100
    half = word.text == "and" and following.kind == "fraction" and following.text in ("a half", "half")
    return half or (word.text == "or" and following.kind == "number")


def _joined(last: Lexeme, joint: str, word: Lexeme) -> float | None:
    """The value of two numbers in a row, None when they are two numbers."""
    n, m = last.number, word.number
    if joint == "or":
        return n
    if word.kind == "fraction":
        return n + 0.5 if joint == "and" and word.text in ("a half", "half") else None
    if word.text[0].isdigit() and not joint:
        return None
    if m in (100, 1000):
        return n * m
    return n + m if (n >= 20 and n % 10 == 0 and m < 10) or (n >= 100 > m) else None


def _shares(words: list[Lexeme]) -> list[Lexeme]:
    """`half of the floor area`, `40 %`."""
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        word = words[i]
        percent = i + 1 < len(words) and (words[i + 1].text == "%" or words[i + 1].value == "percent")
        end = _of_its_size(words, i)
        ahead = words[i + 1] if i + 1 < len(words) else word
        if word.kind == "fraction" and ahead.kind == "compare" and ahead.number == 1.0:  # "two thirds the size of"
            text = f"{word.text} {ahead.text}"
            out.append(replace(ahead, value=word.value, values=word.values, text=text))
            i += 2
            continue
        if word.kind == "fraction" and [w.text for w in words[i + 1 : i + 3]] in OF_THAT:
            out.append(replace(word, kind="compare", text=f"{word.text} of that"))  # "the kitchen half of that"
            i += 3
            continue
        if word.kind == "fraction" and end > i:
            out.append(replace(word, kind="compare"))
            i = end
            continue
        if word.kind == "number" and percent:
            value, end = word.number / 100, i + 2
        elif word.kind == "fraction" or (word.text == "half" and _of_area(words, i + 1) > i + 1):
            value, end = word.number if word.values else 0.5, i + 1
        else:
            out.append(word)
            i += 1
            continue
        after = _of_area(words, end)
        whole = _square(words, after) if after > end else None
        if after > end or percent:
            out.append(Lexeme("share", str(value), word.text, values=(value,)))
            end = after
            if whole is not None:  # "a third of the 90 m²"
                out.append(Lexeme("area", "total", f"{whole:g} m2", values=(whole,)))
                end += 2
        else:
            out.append(word)
        i = end
    return out


def _of_its_size(words: list[Lexeme], i: int) -> int:
    """Where `two thirds its size`, `three quarters the size of` ends; i when it does not stand here."""
    texts = [w.text for w in words[i + 1 : i + 4]]
    if texts in (["of", "its", "size"], ["of", "its", "area"]):
        return i + 4
    if texts[1:2] != ["size"] or texts[0] not in ("its", "their", "the"):
        return i
    return i + 3 if texts[0] != "the" else i + 4 if texts[2:] == ["of"] else i


def _of_area(words: list[Lexeme], i: int) -> int:
    """Where `of the [total] [floor] area` or `of the flat` ends; i when it does not stand here."""
    j = i
    while j < len(words) and (
        words[j].text in ("of", "the", "its", "de", "la", "der", "del") or words[j].kind == "determiner"
    ):
        j += 1
    ends = j
    while ends < len(words) and words[ends].kind in ("area_word", "dwelling"):
        ends += 1
    return ends if ends > j or (j > i and _square(words, j) is not None) else i


def _square(words: list[Lexeme], i: int) -> float | None:
    """Square metres of the `90 m²` at `i`, None when there is none."""
    if i + 1 < len(words) and words[i].kind == "number" and words[i + 1].value in SQUARE_METRES:
        return words[i].number * SQUARE_METRES[words[i + 1].value]
    return None


def _areas(words: list[Lexeme]) -> list[Lexeme]:
    out: list[Lexeme] = []
    i = 0
    while i < len(words):
        area, end = _area(words, i)
        out.append(area or words[i])
        i = end if area else i + 1
    return out


def _area(words: list[Lexeme], i: int) -> tuple[Lexeme | None, int]:
    """`12 m²`, `10-12 m²`, `12 and 14 m²`."""
    numbers, joints, j = numbers_joined(words, i)
    unit = words[j].value if numbers and j < len(words) and words[j].kind == "unit" else ""
    if unit not in SQUARE_METRES:
        return None, i
    listed = len(numbers) > 1 and words[i + 1].text == "," and numbers[0] <= 3 < min(numbers[1:])
    if listed and words[i].text.isalpha():
        return None, i  # "bedrooms: one, 13 m²", "the other one, 13 m²"
    numbers = [n * SQUARE_METRES[unit] for n in numbers]
    between = joints == ["-"] and numbers[0] < numbers[1]
    values = [sum(numbers) / 2] if joints == ["-"] else numbers
    return replace(made(values, words, i, j + 1), bounds=_range(numbers) if between else ()), j + 1


def _range(values: Sequence[float]) -> tuple[tuple[str, float], ...]:
    return (("at_least", min(values)), ("at_most", max(values)))


def _area_lists(words: list[Lexeme]) -> list[Lexeme]:
    """`12 m² and 14 m²` as one, unless the second belongs to a room of its own; `between 8 and 10 m²` as 9."""
    out: list[Lexeme] = []
    for i, word in enumerate(words):
        last = out[-2] if len(out) > 1 else None
        own = i + 1 < len(words) and words[i + 1].kind in ("room", "size", "label") and not words[i + 1].plural
        if (
            word.kind == "area"
            and last is not None
            and last.kind == "area"
            and out[-1].text in ("and", ",", "+", "/", "&", "und", "et", "y")
            and not own
        ):
            out[-2:] = [replace(last, values=last.values + word.values)]
        elif word.kind == "area" and len(word.values) == 2 and out and out[-1].text in BETWEEN:
            out[-1] = replace(word, values=(sum(word.values) / 2,), bounds=_range(word.values))
        else:
            out.append(word)
    return out


def _than_that(words: list[Lexeme]) -> list[Lexeme]:
    """`a third larger than that`, `twice as large as that`: than what was named last."""
    out: list[Lexeme] = []
    for k, word in enumerate(words):
        compared = bool(out) and out[-1].kind == "compare" and out[-1].text.endswith(("than", "as"))
        if compared and word.text == "that" and [w.text for w in words[k + 1 : k + 2]] != ["of"]:
            out[-1] = replace(out[-1], text=f"{out[-1].text} that")
        else:
            out.append(word)
    return out


def _by_percent(words: list[Lexeme]) -> list[Lexeme]:
    """`40 % larger than`, `a quarter smaller than`, `50 % larger`."""
    out: list[Lexeme] = []
    for word in words:
        part = out[-1] if out and out[-1].kind in ("share", "fraction") else None
        compares = word.kind == "compare" or (word.kind == "size" and word.text in COMPARATIVES)
        if compares and part is not None and word.number in MORE_OR_LESS:
            ratio = 1 + part.number * (1 if word.number > 1 else -1)
            ratio += SAID if ratio in MORE_OR_LESS else 0
            out[-1] = replace(word, kind="compare", value=str(ratio), text=f"{part.text} {word.text}", values=(ratio,))
        else:
            out.append(word)
    return out
