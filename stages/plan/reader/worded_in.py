"""The words of requirements in the language of their prompt, where rules have put them into English."""

import re
from unicodedata import normalize

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
    """`kuche at most 10 m²` of a German prompt with a `Küche` as `Küche höchstens 10 m²`."""
    text = _spelled(text, prompt)
    if _SAID.search(text) is None:
        return text
    words = _WORDS.get(language(prompt), {})
    return _SAID.sub(lambda found: words.get(found.group(), found.group()), text)


def _spelled(text: str, prompt: str) -> str:
    """The text with words that stand together in the prompt spelled as there: for `walk - in`, `kuche` and `客 厅`."""
    folded = "".join(normalize("NFKD", letter)[0].lower() for letter in prompt)
    words, out = text.split(), []
    while words:
        runs = (many for many in range(len(words), 0, -1) if words[0].isalpha() and words[many - 1].isalpha())
        found = next(((many, as_said) for many in runs if (as_said := _found(words[:many], folded, prompt))), None)
        many, run = found or (1, words[0])
        out.append(run)
        words = words[many:]
    return " ".join(out)


def _found(words: list[str], folded: str, prompt: str) -> str:
    """How words are spelled where they stand in a row in a prompt, rather within a sentence than at its beginning."""
    row = r"(?<![a-z])" + r"\W{0,3}".join(map(re.escape, words)) + r"(?![a-z])"
    places = [prompt[one.start() : one.end()] for one in re.finditer(row, folded)]
    return min(places, key=lambda place: place[:1].isupper(), default="")
