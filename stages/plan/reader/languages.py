"""Which language a prompt is in; those that the reader does not know are refused rather than guessed at."""

import re
import tomllib
from functools import cache
from pathlib import Path

from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.reader.lexicon import Lexicon, read_lexicon
from apartgen.stages.plan.reader.tokens import Token, fold, tokenize

KANA = re.compile("[\u3041-\u30ff\uff66-\uff9f]")
MOST_KNOWN = 0.6
"""Share of known words from which a sentence is understood, whatever its language."""
FEW_KNOWN = 0.4
"""Share of known words below which one without small words of a known language is not."""
ENGLISH = {"flat", "apartment", "house", "home", "bedroom", "bedrooms"}
"""Words that tell the language of a few words without any small one: "wheelchair accessible flat"."""


def understood(prompt: str) -> None:
    """BadInput when most words are of a language the reader does not know."""
    tokens = tokenize(fold(prompt))
    counted = {id(b) for a, b in zip(tokens, tokens[1:], strict=False) if a.kind == "number"}  # "3b2b", "60 sqm"
    words = [t for t in tokens if t.kind == "word" and id(t) not in counted]
    if not words:
        return
    if KANA.search(prompt):
        raise _refused("Japanese")
    known = _known(words, read_lexicon()) / len(words)
    if known >= 1.0:
        return
    texts = [t.text for t in words]
    ours = max(sum(text in small for text in texts) for small in _small("read").values())
    ours += any(_is_room(t) for t in tokens if id(t) in counted)  # "1BR, bay window"
    theirs, name = max((sum(text in small for text in texts), name) for name, small in _small("other").items())
    ours += theirs == 0 and not ENGLISH.isdisjoint(texts)
    plainly = theirs >= 3 and theirs >= 3 * ours
    foreign = theirs >= 2 and theirs > ours and (known < MOST_KNOWN or plainly)
    if foreign or (ours < theirs and known < FEW_KNOWN):
        raise _refused(name)
    if ours == 0 and known < FEW_KNOWN and len(words) > 1:
        raise _refused("")


def language(prompt: str) -> str:
    """`en`, `de`, `fr`, `es` or `zh`, whichever the prompt has most small words of; "" where it has none."""
    if re.search("[\u4e00-\u9fff]", prompt):
        return "zh"
    texts = [t.text for t in tokenize(fold(prompt))]
    counts = {name: sum(text in small for text in texts) for name, small in _small("read").items()}
    return max(counts, key=lambda name: counts[name]) if any(counts.values()) else ""


def _refused(name: str) -> BadInput:
    what = f"language not understood ({name}?)" if name else "language not understood"
    return BadInput(f"{what}; write the prompt in English, German, French, Spanish or Chinese")


def _known(words: list[Token], lexicon: Lexicon) -> int:
    """How many words stand in phrases of the lexicon as they are spelled, or end as its compounds do."""
    count = i = 0
    while i < len(words):
        texts = [t.text for t in words[i : i + lexicon.longest]]
        taken = max((n for n in range(1, len(texts) + 1) if tuple(texts[:n]) in lexicon.entries), default=0)
        count += taken or any(texts[0].endswith(end) and len(texts[0]) > len(end) + 2 for end in lexicon.suffixes)
        i += taken or 1
    return count


def _is_room(token: Token) -> bool:
    readings = read_lexicon().entries.get((token.text,)) or ()
    return token.kind == "word" and any(one.kind == "room" for one in readings)


@cache
def _small(group: str) -> dict[str, frozenset[str]]:
    data = tomllib.loads((Path(__file__).parent / "languages.toml").read_text(encoding="utf-8"))
    return {name: frozenset(words) for name, words in data[group].items()}
