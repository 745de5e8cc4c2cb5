"""Rooms of which each of several people has one, counted."""

import re

from apartgen.stages.plan.reader.lexicon import plural

EACH_NEEDS = re.compile(
    r"(?P<who>\b(?P<n>[2-6]|two|three|four|five|six) "
    r"(?!(?:\w+ )?\w*(?:rooms?|beds?|suites?)\b)(?:\w+ )?\w+)(?: who|,)? each (?:of them |one )?"
    r"(?:needs?|wants?|have|has|gets?|with) (?:an?|their own|his own|her own) "
    r"(?P<room>(?:home )?office|study|workroom|balcony|bath ?room|shower room|dressing room|closet)\b"
)
"""Whom a room is wanted for each of, a room beside those one sleeps in."""
EACH_BEHIND = re.compile(
    r"(?P<who>\b(?P<n>[2-6]|two|three|four|five|six) (?:people|persons|adults|friends|students|flatmates|roommates)),? "
    r"(?:and |with )?(?:an?|one|their own) (?:own |separate |private )?"
    r"(?P<room>study|home office|office|balcony|bath ?room|shower room)(?: for)? each\b(?! other)"
)
"""The same with `each` at the end."""
EACH_OF_FAMILY = re.compile(
    r"\b(?:everyone|everybody|each(?: one| member| person)?|every member) (?:in|of) (?:the|our|my|a) "
    r"family of (?P<n>[2-6]|two|three|four|five|six) (?:has|have|needs|wants|gets|should have|must have) "
    r"(?:an?|their|his or her|his|her) (?:own )?(?:bed ?)?room\b"
)
"""A family of which nobody shares a room."""


def apiece(text: str) -> str:
    """A folded text with as many of such rooms as there are people."""
    for pattern in (EACH_NEEDS, EACH_BEHIND):
        text = pattern.sub(_of_each, text)
    return EACH_OF_FAMILY.sub(r"\g<n> bedrooms", text)


def _of_each(match: re.Match[str]) -> str:
    """`two people who each need a study` as two people and two studies."""
    return f"{match['who']}, {match['n']} {' '.join(plural(tuple(match['room'].split())))}"
