"""The words of requirements in the language of their prompt, where rules have put them into English."""

import re

from apartgen.stages.plan.reader.languages import language

_WORDS = {
    "de": {"at least": "mindestens", "at most": "höchstens", "next to": "neben", "far from": "weit von",
               "larger": "größer als", "smaller": "kleiner als", "long": "lang", "wide": "breit", "doors": "Türen"},
    "fr": {"at least": "au moins", "at most": "au plus", "next to": "à côté de", "far from": "loin de",
               "larger": "plus grand que", "smaller": "plus petit que", "long": "de long", "wide": "de large",
               "doors": "portes"},
    "es": {"at least": "al menos", "at most": "como máximo", "next to": "junto a", "far from": "lejos de",
                "larger": "más grande que", "smaller": "más pequeño que", "long": "de largo", "wide": "de ancho",
                "doors": "puertas"},
    "zh": {"at least": "至少", "at most": "至多", "next to": "紧邻", "far from": "远离", "larger": "大于",
                "smaller": "小于", "long": "长", "wide": "宽", "doors": "扇门"},
}  # fmt: skip
_SAID = re.compile(rf"\b(?:{'|'.join(_WORDS['de'])})\b")


def in_its_language(text: str, prompt: str) -> str:
    """`cuisine at most 10 m²` of a French prompt as `cuisine au plus 10 m²`."""
    if _SAID.search(text) is None:
        return text
    words = _WORDS.get(language(prompt), {})
    return _SAID.sub(lambda found: words.get(found.group(), found.group()), text)
