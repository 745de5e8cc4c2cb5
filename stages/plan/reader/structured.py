"""Prompts that programs write: JSON, YAML-like `key: value` and `key=value` fields, told in plain sentences."""

import json
import re
from collections import Counter
from itertools import accumulate
from typing import Any

from apartgen.stages.plan.reader.field_values import Unclear
from apartgen.stages.plan.reader.fields_told import Fields

_FIELD = re.compile(r"\s*([A-Za-z][\w. -]{0,40}?)\s*(:(?!=)|>=|<=|==?|>|<|≥|≤)\s*(.+?)\s*,?\s*")
_INDENTED = re.compile(r"^\w[\w ]*:\s*\n\s+[\w\"'-].*", re.MULTILINE)
"""Lines that belong to the key above them."""
_CALL = re.compile(r"(?P<before>[\w .:=/-]{1,60}?)[(:=]\s*(?P<fields>\{.*\})\s*\)?[;.]?", re.DOTALL)
"""`plan_home({"bedrooms": 2})`, `Tool call: plan. Args: {…}`."""
_BOUNDS = {">=": "at least", "≥": "at least", ">": "at least", "<=": "at most", "≤": "at most", "<": "at most"}
_COUNTED = re.compile(r"\b(\w*(?:bedrooms|bathrooms|balconies|toilets))\s*:?\s*(?:>=|≥)\s*(\d)(?=\s*(?:[;,|\n]|$))")
"""`bedrooms>=2`: so many, and no area."""
_ANEW = re.compile(
    r"(?<=[:=])(?: ?[\w.]{1,8}(?: ?(?:m2|m²|sqm|sq ?ft))? ?(?:-+>|=>|→|⇒) ?(?:(?:actually|rather|now|no|"
    r"make (?:it|that)|changed to),? )*)+(?=(?:\d|one|two|three|four|five|six)\b)", re.IGNORECASE)  # fmt: skip
"""What stood in a field before: `bedrooms: two -> three`."""
_N = r"(?:[1-9]|one|two|three|four|five|six)"
_RANGED = re.compile(
    rf"((?:bed|bath) ?rooms?|beds|baths|toilets|balconies)(\s*[:=]\s*)(?:(?:between|from) ({_N}) (?:and|to) {_N}|"
    rf"({_N}) ?(?:-|–|to|or|\.\.) ?{_N})(?=\s*(?:[,;.|\n}}]|$))|\b({_N}) \((?:or|maybe|possibly|perhaps) {_N}\)"
    r"(?= (?:bed|bath))", re.IGNORECASE)  # fmt: skip
"""`bedrooms: 2-4`, `3 (or 4) bedrooms`: the least is always meant."""

DEEPEST = 20
"""Brackets within brackets that a prompt may have to be read as fields."""


def in_sentences(prompt: str) -> str:
    """A prompt whose every field is understood as sentences, each other one as it is."""
    prompt = _ANEW.sub(" ", _COUNTED.sub(r"\1=\2", prompt))
    prompt = _RANGED.sub(lambda found: "".join(part or "" for part in found.groups()), prompt)
    text = prompt.strip()
    call = _CALL.fullmatch(text)
    if call and (told := in_sentences(call["fields"])) != call["fields"]:
        return f"{call['before'].strip(' (:=')}. {told}"
    try:
        fields = _parsed(text) if text[:1] in ("{", "[") else _nested(text) if _INDENTED.search(text) else _lines(text)
        if not fields:
            return prompt
        counting = Fields(Counter())
        counting.flat(fields)
        return Fields(counting.counts).flat(fields)
    except Unclear:
        return prompt


def _parsed(text: str) -> Any:
    deepest = max(accumulate((sign in "[{") - (sign in "]}") for sign in text), default=0)
    if deepest > DEEPEST:
        return None
    try:
        return json.loads(text)
    except ValueError:
        return _nested(text)


def _nested(text: str) -> Any:
    """YAML, without the references by which a short text means a huge one."""
    if re.search(r"[&*]\w", text):
        return None
    import yaml  # type: ignore[import-untyped]  # noqa: PLC0415 (20 ms, for few prompts)

    try:
        found = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError):
        return None
    return found if isinstance(found, dict | list) else None


def _lines(text: str) -> list[Any] | None:
    """`key: value` pairs, one a line or parted by `;` or `|`, or a table's rows; None of what is mostly sentences."""
    if re.search(r"\|\s*:?--", text):
        return _table(text.split("\n"))
    parts = [
        p
        for p in re.split(r"\s*(?:[\n;|]|,(?=\s*[\w. -]{2,30}\s*=)|\s(?=[\w.]{2,40}[<>]?=))\s*", text)
        if p.strip(" ,.")
    ]
    found = [_FIELD.fullmatch(p) for p in parts]
    if len(parts) < 2 or sum(m is None for m in found) * 2 > len(parts):
        return None
    pairs = [(m[1], f"{_BOUNDS.get(m[2], '')} {m[3]}".strip(" .")) if m else ("", part.strip(" ."))
             for m, part in zip(found, parts, strict=True)]  # fmt: skip
    return pairs if not any(value.endswith(("?", "!")) or len(value.split()) > 12 for _, value in pairs) else None


def _table(lines: list[str]) -> list[Any] | None:
    """The rows of a Markdown table that is all of a prompt, by the names over their cells."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in lines if line.strip()]
    if len(rows) < 3 or not all("|" in line for line in lines if line.strip()):
        return None
    head, _, *body = rows
    names = [re.sub(r"[()\[\]]", "", name) for name in head]
    return [
        {"room": row[0]} | {n: c for n, c in zip(names[1:], row[1:], strict=False) if c not in ("", "-", "–")}
        for row in body
    ]
