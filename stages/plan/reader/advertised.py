"""Advertisements of homes, in the words of wishes: `master with en suite`, `ideal as a study`, `around a hall: …`."""

import re

from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import HALL, SEVERAL, reworded, rules

_SEVERAL = Late(rf"\b{SEVERAL}[ -](?:(?:good|large|spacious|double|single)[ -](?:sized )?)*bed(?:[ -]?rooms?\b|s\b)")
_MASTER = Late(r"(?<=[,;:(.])(?P<begin> ?(?:and )?)(?P<the>the )?(?:main|master|principal)(?: bed ?room| bed)? "
               r"(?=with |having )")  # fmt: skip


def _the_main(found: re.Match[str]) -> str:
    """`two double bedrooms, master with en suite`: one of those counted."""
    counted = _SEVERAL.search(found.string[: found.start()])
    return f"{found['begin']}one of them " if counted and (not found["the"] or "double" in counted[0]) else found[0]


_SAID = rules((
    # "second bedroom ideal as nursery or home office"
    (r",? ?\(?(?:(?:which|that) (?:is|would be) )?(?:ideal|perfect|suitable|great|good|ideally suited) "
     r"(?:as|for use as|to use as|for) (?:an? |your )?{use}(?:(?:, |,? or |/| / )(?:an? |your )?{use})*\)?(?={after})",
     ""),
    # "arranged around a central hallway: on the left the living room"
    (r"\b(?:arranged |laid out |organi[sz]ed |grouped |set )*(?:around|along|off|on either side of) "
     r"(?P<a>an? |the |one )(?P<hall>{hall}) ?[:,]? ?(?=(?:on|to) the (?:left|right)\b)", r"with \g<a>\g<hall>. "),
), use=r"(?:(?:guest|spare|play|hobby|music|work|children's) ?room|home office|study|office|nursery|library|gym)",
   after=r" ?(?:[.,;:)]|$)| and ", hall=HALL)  # fmt: skip


def advertised(text: str) -> str:
    """A folded text with such phrases in the words of rooms, without what a room might be."""
    return _MASTER.sub(_the_main, reworded(text, _SAID))
