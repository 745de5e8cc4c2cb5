"""Schedules of rooms that say where a room is before how large it is: `Bathroom: NW corner, 2 x 3 m. Kitchen: …`."""

import re

from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.pieces import reworded, rules
from apartgen.stages.plan.reader.tokens import fold

_NUMBER = r"\d+(?:[.,]\d+)?"
_LENGTH = r"(?: ?(?:m|cm|ft|['’\"]|met(?:er|re)s?|feet|foot)(?![a-z\d²]))?"
_AREA = (r"(?:m2|m²|sq\.? ?(?:m|ft|feet)\b\.?|sqm|qm|square (?:met(?:er|re)s|feet)|quadratmeter|"
         r"m[eè]tres carr[eé]s|metros cuadrados)")  # fmt: skip
_SIZE = rf"{_NUMBER}{_LENGTH} ?(?:[x×]|by) ?{_NUMBER}{_LENGTH}|{_NUMBER} ?{_AREA}"
_BEHIND = r"(?= ?(?:[,.;)\n]|$))"
_ALONE = re.compile(
    rf"(?:(?<!approx)(?<!\bca)(?<!\bmin)(?<!\bmax)[,.] |[;(] ?|\n)(?:about |approx\.? |ca\.? |size |area )?"
    rf"(?P<size>{_SIZE})(?: overall| in all)?{_BEHIND}",
    re.I,
)
"""A size that belongs to nothing in the same clause."""
_LABEL = re.compile(r"(?:^|(?<=[\n.;])) *(?:[-*•] )?(?:(?:the|an?|one|1) )?(?P<name>(?:[^\W\d_]+[ "
     r"-]){0,2}[^\W\d_]+)(?: ?\d)? ?:(?! ?\d)", re.I)
_PLACES = rules((
    # "Bedrooms: 2, 12 m² each"
    (r"\b(?P<kind>(?:bed|bath) ?rooms) ?: ?(?P<n>\d)(?=, \d)", r"\g<n> \g<kind>"),
    # "the bathroom is the northernmost room"
    (r"\b(is|be) (?:the )?{side}(?:ern)? ?most(?: of all)?(?: rooms?| one)?(?= ?(?:[.,;]| and |$))",
     r"\1 in the \g<side>"),
    # "Living room: centre."
    (r"(?P<mark>[:,] ?)(?:centre|center|middle|cent(?:er|re)d|central(?:ly)?){behind}", r"\g<mark>in the centre"),
    # "Bad: Norden"
    (r"(?P<mark>[:,] ?)(?=(?:nord|sud|ost|west)en{behind})", r"\g<mark>im "),
), side="(?P<side>north|south|east|west)", behind=_BEHIND)  # fmt: skip


def scheduled(prompt: str) -> str:
    """A prompt with sizes next to the names of such rooms: `Bathroom (2 x 3 m): NW corner`."""
    labels = [found for found in _LABEL.finditer(prompt) if _is_room(found["name"])]
    ends = [*(found.start() for found in labels[1:]), len(prompt)]
    for label, end in reversed(list(zip(labels, ends, strict=False))):
        body = prompt[label.end() : end]
        sizes = list(_ALONE.finditer(body))
        if len(sizes) == 1:
            rest = body[: sizes[0].start()] + body[sizes[0].end() :]
            prompt = f"{prompt[: label.end() - 1].rstrip()} ({sizes[0]['size']}):{rest}{prompt[end:]}"
    return prompt


def in_places(text: str) -> str:
    """A folded text with places that stand alone, and counts before sizes, in words."""
    return reworded(text, _PLACES)


def _is_room(name: str) -> bool:
    readings = read_lexicon().entries.get(tuple(fold(name).replace("-", " - ").split())) or ()
    return any(reading.kind == "room" for reading in readings)
