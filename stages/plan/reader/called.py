"""What rooms are called, as patterns: the words that the lexicon has for them, language by language."""

import re
from functools import cache

from apartgen.stages.plan.reader.tables import expand, languages

_TOLD_FROM_OTHERS = r"(?: principal(?:e|es)?| parentale| d'amis| (?:de|para) invitados)?"


@cache
def rooms_called(language: str, *types: str) -> str:
    """A pattern for one room, of some types or of any; the longest words come first."""
    group = languages()[language]["room"]
    wanted = [patterns for value, patterns in group.items() if not types or value.partition(":")[0] in types]
    words = {text for patterns in wanted for pattern in patterns for text in expand(pattern)}
    names = [re.sub(r"[ -]+", "[ -]", word) for word in sorted(words, key=lambda w: (-len(w), w)) if len(word) > 1]
    return f"(?:(?:{'|'.join(names)}){'' if language == 'zh' else _TOLD_FROM_OTHERS})"
