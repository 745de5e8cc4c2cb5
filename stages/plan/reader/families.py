"""Words of people who write of their own family: whose children they tell of, and where they sleep themselves."""

import re

from apartgen.stages.plan.reader.kin import kind_of, pattern, several
from apartgen.stages.plan.reader.patterns import late

OURS = re.compile(
    r"^(?:\w+ (?:of|von|de) )?(?:both |beide )?"
    r"(?:our|my|mein\w*|unser\w*|nos|notre|mes|mon|ma|mis?|nuestr\w+)\b"
)
BEDROOMS = re.compile(
    r"\b(?:bed ?rooms?|master|parents|schlafzimmer|eltern\w*|chambre|dormitorios?|habitaci\w+|my room|our room|us|"
    r"(?:and|&|und|et|y) (?:i|me|ich|moi|yo)|i (?:also|need|want|get)|we (?:also|need|have|get|sleep))\b|卧"
)
"""What tells where those sleep whose children have rooms."""
COUNTED = re.compile(r"(?:\b\d|one|two|three|four|five|six|[一两二三四五])[ -]?(?:bed|br\b|居室|室)")
"""A number of bedrooms, beside which people have no further rooms."""
LIVING = re.compile(r"\b(?:lives?|stays?|moves? in) with (?:us|me) and "
                    r"(?=ha[sv]e?|needs?|gets?|wants?|takes?|sleeps?)")
HAVING = re.compile(
    r"(?:\b(?:we have|we are|we've|our|my|wir haben|unsere|nous avons|nos|tenemos|nuestr[oa]s)\b|我们|一家)[^.]{0,48}"
    r"kids room|\b(?:i|we) have (?:an?|one|two|three|\d) (?:son|daughter|boy|girl|child|kid)s?\b(?=.*\d kids rooms)"
)
"""Children of those who write."""
HEADED = re.compile(r"[:;.-] ?(?:an?|\d) (?:small |large )?(?:kids room|relative's room)")
FAMILY = re.compile(r"\b(?:couple|family|paar|familie|famille|pareja|familia) (?:with|of|mit|avec|con)\b")
"""Families whose members are counted elsewhere."""
ALIKE = ("(?:girl|daughter)", "(?:boy|son)", "(?:child|kid|children|boy|girl|son|daughter)")
"""Words for the same children."""
OWN_TOO = re.compile(r"kids room|\b(?:own|alone|suy[oa]|eigenes?|sienn?e?)\b")
"""What tells of the rooms of others beside those who share one."""
FAMILY_ROOM = re.compile(r"\b(?:(?:we are|wir sind|nous sommes|somos) )?(?:an? |the |our |eine? |une? |una )?"
                         r"(?:family|familie|famille|familia|couple|paar|pareja) "
                         r"(?:with|of|ha[sv]e|mit|avec|con) (?:(?:twins|(?:an?|two|three) "
                         r"(?:child|kid|son|daughter|boy|girl)(?:s|ren)?) and )?"
                         r"(?=(?:an?|\d) (?:kids room|relative's room))")  # fmt: skip
"""A family before the rooms of its children, of which the parents have another one."""
TOGETHER = re.compile(
    r"\b(?:the |our |my )?(sons|daughters|boys|girls|kids|children|brothers|sisters|twins) (?:both |can |will )?"
    r"(?:(?:sleep|stay|live|are) (?:together|in one|in the same)|share)(?: an?| one| the same)?(?: bed ?room| "
    r"room)?\b"
)
KEPT = re.compile(r"\b(?:ours|mine|(?<=keep )(?:our|my) own(?= ?(?:[.,;!]|$)))(?![a-z'])")
HERS = re.compile(r"\b(?:she|he) (?:needs|gets|wants|has|should have|will (?:have|get)) (?:an?|her own|his own) "
                  r"bed ?room\b")  # fmt: skip
_WHOSE = r"(?P<room>(?:an?|\d) (?:relative's|kids|parents') (?:rooms?|bedroom))"
LIVE_WITH = late(
    r"(?:\b(?P<who>the couple|i|we|ich|wir|je|j'|nous)(?: still| also)? ?(?:live|wohnen?|leben?|habite|habitons|vis|"
    r"vivons)"
    r"(?: together| zusammen)? (?:with|mit|avec)|\b(?P<quien>vivo|vivimos|convivo) (?:juntos )?con|"
    rf"\b(?P<me>me|i|myself|mich|moi|mi|yo) (?:and|und|et|y|&)) {_WHOSE}"
)
"""Those who live with somebody whose room is told of."""
AND_ME = late(rf"{_WHOSE},? (?:and|und|et|y|&) (?:me|i|myself|mich|moi|mi|yo)\b(?= ?(?:[,.;:]|$))")
_SPOUSE = r"(?:wife|husband|partner|spouse|girlfriend|boyfriend|fiancee?)"
_PARTNER = (r"(?:mari|femme|compagne|compagnon|copine|copain|marido|mujer|espos[oa]|pareja|novi[oa]|mann|frau|"
            r"partner(?:in)?|"
            r"freundin)")  # fmt: skip
COUPLE = late(
    rf"\b(?:my|our) {_SPOUSE} and (?:i|me|myself)\b|\b(?:me|myself|i)(?: and|,) my {_SPOUSE}\b"
    rf"|\b(?:mon|ma|mi|meine?[rnm]?) {_PARTNER}(?:,| et| y| und) (?:moi|yo|ich|mich)\b"
    rf"|\b(?:moi|yo|ich|mich)(?:,| et| y| und) (?:mon|ma|mi|meine?[rnm]?) {_PARTNER}\b"
)
SUMMED = re.compile(
    r"((?:kids room|relative's room|parents' bedroom)s?\b.*[.:;] ?(?:so,? )?(?:\d|two|three|four|five|six) bed "
    r"?rooms)"
    r"\b(?! in total)"
)
"""Bedrooms that are counted once those who have rooms are named: all of them."""


def alike(noun: str) -> str:
    """A pattern of words for the same children as `noun` says."""
    return next((same for same in ALIKE if re.fullmatch(same, noun)), noun)


def we_keep(text: str) -> str:
    """`mum moves in. She needs a bedroom, we keep ours`: hers and the parents' bedroom."""
    said = KEPT.sub("the parents' bedroom", re.sub(r" - (?=(?:ours|mine)\b)", ", ", text))
    return text if said == text else said if COUNTED.search(text) else HERS.sub("a relative's room", said)


def heading(text: str) -> str:
    """`our three daughters: …`, before the rooms of each, counts no further rooms."""
    def people(match: re.Match[str]) -> str:
        return "" if kind_of(match) == "child" and several(match) else match.group()

    rooms = "(?:an?|\\d) (?:small |large )?(?:kids room|relative's room)"
    if HEADED.search(text) is None:
        return text
    we = "(?:(?:we (?:have|are)|tenemos|wir haben|nous avons) (?:got )?)?"
    return pattern(f"{we}{{who}} ?[:;.-]+ ?(?={rooms})").sub(people, text)


def with_ours(text: str, claims: list[str]) -> str:
    """`our two kids each want a room`: whose children they are have one too, where no other bedroom is spoken of."""
    rest = HAVING.sub("", text)  # "we have three kids rooms" tells not where those sleep who have them
    if rest != text and not (FAMILY.search(text) or COUNTED.search(text) or BEDROOMS.search(rest)):
        return f"{text.rstrip(' .!')}. a parents' bedroom."
    if (beside := _beside_mine(text)) != text and not COUNTED.search(text):
        return beside
    ours = [match for claim in claims if OURS.search(claim) for match in pattern("{who}").finditer(claim)]
    if not any(match["child"] or match["twins"] for match in ours) or COUNTED.search(text) or BEDROOMS.search(text):
        return text
    return f"{text.rstrip(' .!')}. a parents' bedroom."


def _beside_mine(text: str) -> str:
    """`i live with a relative's room`: that, and the room of those who live with them, where none is told of."""
    found = LIVE_WITH.search(text) or AND_ME.search(text)
    if found is None:
        return text
    rest = text[: found.start()] + text[found.end() :]
    if BEDROOMS.search(rest) or any(kind_of(one) == "spouse" for one in pattern("{who}").finditer(rest)):
        return text
    several_of_us = {"the couple", "we", "wir", "nous", "vivimos"} & set(found.groupdict().values())
    mine = "a parents' bedroom" if several_of_us else "my room"
    return f"{text[: found.start()]}{found['room']}{text[found.end() :].rstrip(' .!')}. {mine}."
