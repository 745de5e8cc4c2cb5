"""A prompt as a list of tokens, folded so that the lexicon needs one spelling of each word."""

import re
import unicodedata
from dataclasses import dataclass
from typing import Literal, cast

from apartgen.stages.plan.reader.notation import sided, worded
from apartgen.stages.plan.reader.sheets import without_tables

Kind = Literal["number", "word", "mark"]

CJK = "\u3400-\u9fff"

_INCHES = re.compile(
    r"""(\d+)\s?(?:'|(?:ft|feet|foot)\b\.?)\s?(\d{1,2}(?:\.\d+)?)(?![\d.'m])\s?(?:"|''|in(?:ch(?:es)?)?\b)?"""
)
_FEET = re.compile(r"(\d)'(?=\s?(?:x|by)\b)|(?<=[xy] )(\d+)'(?![\d'])")
_METRES = re.compile(r"(?<![\w.,])(\d{1,2}) ?m ?(\d{2})(?=\s?(?:[x*,;)]|by\b|$)|\.(?:\s|$))")  # "5m50 x 4m20"
_FRACTIONS = {"½": ".5", "¼": ".25", "¾": ".75"}
_BOUNDS = {"(?:>=|≥)": "at least", "(?:<=|≤)": "at most"}
_NUMBERED = re.compile(r"(?:(?<=\s)|^)(\d{1,2})[.)]\s+(?=[^\W\d])")
_NESTED = re.compile(r'"([\w ]+)"\s*:\s*\{\s*"area(?: m2)?"\s*:\s*([\d.]+)\s*\}')
_PAIRED = re.compile(r"(:\s?\d+(?:\.\d+)?\s?(?:sqm|m2|sqft)?)[^\S\n]+(?!sq|m\b)(?=[a-z ]+:\s?\d)")
_SQUARED = re.compile(r"(?<=\d)\s?(?:m|met(?:er|re)s?) squared?\b|(?<=\d\d)\s?met(?:er|re)s? square\b")
_QUOTES = str.maketrans(
    {
        "’": "'",
        "‘": "'",
        "`": "'",
        "–": "-",
        "—": "-",
        "−": "-",
        "×": "x",
        "，": ",",
        "。": ".",
        "；": ";",
        "、": ",",
        "”": '"',
        "“": '"',
        "′": "'",
        "″": '"',
        "œ": "oe",
        "æ": "ae",
        "[": "(",
        "]": ")",
        "{": "(",
        "}": ")",
        "_": " ",
        "|": ";",
    }
)
_TOKEN = re.compile(
    rf"""(?P<number>\d{{1,3}}(?:[,' ]\d{{3}})+(?![\d])|\d+(?:\.\d+)?e[+]?\d+|\d+[.,]\d+|\.\d+|\d+)
    |(?P<word>m\^?2|ft\^?2|w/o|w/|[a-z]+(?:'[a-z]+)*'?|[{CJK}]|[^\W\d_]+)
    |(?P<mark><?-+>|=>|→|⇒|↔|[-,;:.!?()/&+%\n])""",
    re.VERBOSE,
)


@dataclass(frozen=True, slots=True)
class Token:
    """`text` is folded; `glued` says that nothing stands between this token and the one before."""

    text: str
    kind: Kind
    start: int
    end: int
    glued: bool
    value: float = 0.0


def fold(text: str) -> str:
    """Lower case without accents, typographic marks made plain; same length is not kept."""
    text = _NESTED.sub(r'"\1": \2 m2', sided(without_tables(text).replace("_", " ")))
    text = re.sub(r'(?<=["\w])"?\s*,\s*(?="[\w ]+"\s*:)', '" . ', text)  # `"kitchen": "open", "bath": …`
    for sign, words in _BOUNDS.items():
        text = re.sub(rf"\s*{sign}\s*(?=\d)", f" {words} ", text)
    text = re.sub(r"(?<![-=<>])>", "->", re.sub(r"~~[^~]*~~", "", text))  # what is struck through is not said
    text = re.sub(r"(?<=\d)â(?:€[™²])?", "'", text)  # a prime that came through a wrong encoding
    text = re.sub(r"=(?!>)", ":", text)  # `hall=none` is said like `hall: none`
    for sign, plain in _FRACTIONS.items():
        text = re.sub(rf"(?<=\d)\s?{sign}", plain, text)
        text = text.replace(sign, "0" + plain)
    text = unicodedata.normalize("NFKC", text.translate(_QUOTES)).lower().replace("ß", "ss")
    text = worded(text)
    text = _INCHES.sub(lambda found: f"{float(found[1]) + float(found[2]) / 12:.4f} feet ", text)
    text = _METRES.sub(r"\1.\2 m", text)
    text = _FEET.sub(lambda found: f"{found[1] or found[2]} feet", text)
    text = _SQUARED.sub(" m2", _unnumbered(text))
    text = _PAIRED.sub(r"\1, ", text)
    text = re.sub(r"\b(?:extras?|additional|misc)\s*:", ",", text)
    text = re.sub(r"\bd'(?=au (?:moins|plus)\b)", "", text)
    text = re.sub(r"\.\.+", ", ", text)  # a pause ends no sentence
    text = re.sub(r"(?<=\d)\s?\*\s?(?=\d)", " x ", text)
    parts = unicodedata.normalize("NFD", text)
    return unicodedata.normalize("NFC", "".join(c for c in parts if not unicodedata.combining(c)))


def _unnumbered(text: str) -> str:
    """Without the numbers of a list, `1. kitchen 2. bath`, that count up from one; not so `of bedroom 1. Bedroom 2.`"""
    found = list(_NUMBERED.finditer(text))
    numbers = [int(one[1]) for one in found]
    counted = len(numbers) > 1 and numbers == list(range(1, len(numbers) + 1))
    begins = counted and text[: found[0].start()].rstrip(" ")[-1:] in ("", "\n", ":", ";", ",", ".", "-")
    return _NUMBERED.sub("; ", text) if begins else text


def tokenize(text: str) -> list[Token]:
    """Tokens of a folded text; characters of no token (quotes, emoji) are skipped."""
    out: list[Token] = []
    end = -1
    for found in _TOKEN.finditer(text):
        kind = cast(Kind, found.lastgroup)
        body = found.group()
        word = body.rstrip("'").replace("^", "") if kind == "word" else body
        value = _number(body) if kind == "number" else 0.0
        out.append(Token(word, kind, found.start(), found.end(), found.start() == end, value))
        end = found.end()
    return out


def _number(body: str) -> float:
    """12,5 is a decimal comma; 1,200 and 1 200 are thousands."""
    if re.fullmatch(r"\d{1,3}(?:[,' ]\d{3})+", body):
        return float(re.sub(r"[,' ]", "", body))
    return float(body.replace(",", "."))
