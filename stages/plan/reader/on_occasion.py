"""Rules that are read only where a text has a word of theirs: most have none, and no first text is kept waiting."""

import re
from collections.abc import Callable
from functools import cache
from importlib import import_module

_RULES = (
    (re.compile(r"stud(?:y|ie)|estudio"), "studied"),
    (re.compile(r"rather|instead|in (?:place|lieu) of|opposed|prefer|not (?:in )?an? |statt|an ?stelle|plutot|au lieu|"
                r"a la place|en (?:vez|lugar) de|而不是|不要|不需|代替"), "no_room_apart"),
    (re.compile(r"of (?:them|those|these)|in (?:number|total|all)\b|to be (?:exact|precise)|pieces|pcs|units|\(\d\)|"
                r"\((?:two|three|four|five)\)|stuck|davon|an der zahl|insgesamt|elles|au total|en tout|il y en a|faut|"
                r"ell[oa]s|en total|[室间房台],.{0,2}[两二三四五2-6][间个]"), "counted_behind"),
)  # fmt: skip
"""Words of which one stands in every text that a module changes; the module, whose function has the same name."""


def on_occasion(text: str) -> str:
    """A folded text in the words of those rules whose words it has."""
    for words, name in _RULES:
        if words.search(text):
            text = _rule(name)(text)
    return text


@cache
def _rule(name: str) -> Callable[[str], str]:
    rule: Callable[[str], str] = getattr(import_module(f"apartgen.stages.plan.reader.{name}"), name)
    return rule
