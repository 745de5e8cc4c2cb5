"""What German, Chinese and English say in an order of words that the rules do not follow, put into one they do."""

import re

_DE_ROOMS = {"kochen": "kuche", "essen": "esszimmer", "wohnen": "wohnzimmer"}
_DOING = "kochen|essen|wohnen"
_TOGETHER = re.compile(rf"\b(?:{_DOING})(?:(?:, ?| und |/| & | \+ )(?:{_DOING})){{1,2}}\b")
_WHOSE = {"eltern": "elternschlafzimmer", "kinder": "kinderzimmer", "gaste": "gastezimmer"}
_OF_WHOM = re.compile(r"\b(?:schlaf)?zimmer (?:der|unserer|meiner|fur (?:die|unsere)) (eltern|kinder|gaste)n?\b")
_COMPARED = re.compile(r"比([^,.;:]{1,10}?)(?:还要|还|更|要)?(大|小)(?:一些|一点|些)?(?=[,.;]|$)")
_ORDERED = [(re.compile(pattern), words) for pattern, words in (
    # "Zum Schlafzimmer gehört eine Ankleide."
    (r"\bzu(?:m|r) (\w+) gehor(?:t|en)\b", r"das \1 hat"),
    # "Der Abstellraum soll an die Küche grenzen."
    (r"\b(?:direkt )?an (?:die|das|den|der|dem) (\w+) (?:an)?grenz(?:t|en)\b", r"neben dem \1"),
    # "Es soll vom Flur aus zugänglich sein."
    (r"\b(?:vom|von d(?:er|em)|uber d(?:en|ie|as)|durch d(?:en|ie|as)) (\w+) (?:aus )?"
     r"(?:zuganglich|erreichbar|begehbar|betretbar|zu erreichen|zu betreten)\b(?: sein)?", r"zuganglich vom \1"),
    # "Das Bad soll größer sein als das WC."
    (r"\b(grosser|kleiner) sein als\b", r"\1 als"),
    # "Küche und Wohnzimmer gehen ineinander über."
    (r"\b(?:finden|liegen|sind) in einem (?:(?:grossen|gemeinsamen|einzigen) )*offenen (?:bereich|raum)(?: statt)?\b",
     "sind offen"),
    (r"\b(?:offen |fliessend )?ineinander ubergehen(?:d)?\b", "offen"),
    (r"\bgehen (?:offen |fliessend )?ineinander uber\b", "sind offen"),
    # "The bedrooms are set apart from each other."
    (r"\b(?:set|placed|kept|well|far|located) (?:well |far )?apart from\b", "far from"),
    # "一个储藏室，从厨房进去"
    (r"从([^,.;:从]{1,8}?)(?:进去|进入|进出|进)(?=[,.;]|$)", r"通向\1"),
)]  # fmt: skip


def rephrased(text: str) -> str:
    """A folded text whose verbs and comparisons stand where the rules look for them."""
    text = _OF_WHOM.sub(lambda found: _WHOSE[found[1]], text)
    text = _TOGETHER.sub(_doing, text)
    text = _COMPARED.sub(lambda found: f" {'larger' if found[2] == '大' else 'smaller'} than {found[1]}", text)
    for pattern, words in _ORDERED:
        text = pattern.sub(words, text)
    return text


def _doing(found: re.Match[str]) -> str:
    """`Kochen, Essen und Wohnen` as the rooms for it."""
    return re.sub(_DOING, lambda verb: _DE_ROOMS[verb.group()], found.group())
