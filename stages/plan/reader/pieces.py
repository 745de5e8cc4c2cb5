"""Pieces that patterns of English clauses are made of, known to all of them: rooms, numbers, people, verbs, units."""

import re
from collections.abc import Callable, Iterable

from apartgen.stages.plan.reader.called import rooms_called
from apartgen.stages.plan.reader.patterns import Late

Words = str | Callable[[re.Match[str]], str]
"""What stands in the place of what a pattern finds, as `re.sub` takes it."""
HALL = (r"(?:(?:central|long|short|wide|narrow|entrance|single|main|common|night|inner|bedroom|same|front|second) )*"
        r"(?:hall(?:way)?|corridor|passage(?:way)?|landing|lobby|vestibule|foyer|gallery)s?")  # fmt: skip
OUTSIDE = r"(?:(?:juliet |step-out |roof )?(?:balcon(?:y|ies)|terraces?|loggias?|patios?|verandas?|decks?))"
ROOM = (r"(?:(?:living|sitting|family|dining|laundry|utility|storage|store|guest|shower|bed|bath|play|wash|drawing|"
        r"dressing|breakfast|box|spare|powder|wet|music|work|rest|hobby|media|games?) ?rooms?|"
        r"parlou?rs?|larders?|dens?|librar(?:y|ies)|wcs?|cloak ?rooms?|kitchenettes?|conservator(?:y|ies)|"
        rf"kitchens?|stud(?:y|ies)|lounges?|toilets?|(?:home )?offices?|pantr(?:y|ies)|(?:walk-in )?closets?|nurser"
        rf"(?:y|ies)|hall(?:way)?s?|corridors?|{OUTSIDE})")  # fmt: skip
KIND = (r"(?:(?:main|master|guest|first|second|third|fourth|other|only|family|children's|kids'?|parents'|large(?:st)?|"
        rf"larger|small(?:er|est)?|big(?:ger|gest)?) )*{ROOM}")  # fmt: skip
"""A room with what tells it from others of its kind."""
DE, FR, ES, ZH = (rooms_called(language) for language in ("de", "fr", "es", "zh"))
"""A room without its article."""
BEDROOMS = r"(?:bed ?rooms|schlafzimmern?|chambres|dormitorios|habitaciones)"
BEDROOM = r"(?:(?:bed ?)?room|(?:schlaf)?zimmer|chambre|dormitorio|habitacion|cuarto)"
NUMBER = r"(?:one|two|three|four|five|six|[1-9])"
SEVERAL = r"(?:two|three|four|five|six|[2-6])"
YOUNG = (r"(?:(?:(?:little|small|young|teenage|grown-up|older|younger|elder) )?(?:twins|kids|children|sons|daughters|"
         r"boys|girls|teenagers|toddlers|grandchildren))")  # fmt: skip
ELDER = r"(?:(?:grand)?(?:mother|father)(?:-in-law)?|grand?(?: ?ma| ?pa|dad)|gran(?:ny)?|mum|mom|dad|aunt|uncle)"
CHILD = r"(?:child|kid|son|daughter|boy|girl|baby|toddler|teenager)"
SHE = (r"(?:grand ?ma|granny|gran|nan|nana|mum|mom|(?:grand)?mother(?:-in-law)?|daughter|sister|aunt|wife|girl|oma|"
       r"nanny|niece|girlfriend|maid|[a-z]+ (?:daughter|sister))")  # fmt: skip
HE = (r"(?:grand ?pa|grand?dad|dad|(?:grand)?father(?:-in-law)?|son|brother|uncle|husband|boy|opa|nephew|boyfriend|"
      r"butler|[a-z]+ (?:son|brother))")  # fmt: skip
THEY = r"(?:(?:grand)?parents|kids|children|twins|boys|girls|in-laws|couple|guests|sons|daughters)"
GROWN = (r"(?:(?:flat|house|room)mates|friends|students|colleagues|tenants|adults|lodgers|siblings|brothers|sisters|"
         r"people|persons|of us)")  # fmt: skip
MUST = (r"(?:must|should|shall|can|could|may|might|will|would|(?:is|are|has|have|needs?|ought|wants?) to)")
NOT = (r"(?:(?:must|should|may|shall|can|is|are|does|do) not|(?:is|are) not to|cannot|(?:must|should|ca|is|are|does|do|"
       r"wo)n't)")  # fmt: skip
HAS = r"(?:has|have|having|gets?|needs?|wants?|takes?|with)"
GO = r"(?:go|come|get|walk|step|pass)(?:e?s)?"
BESIDE = (r"(?:next to|besides?|near(?: to)?|close to|adjacent to|adjoining|opposite(?: to)?|across from|facing|"
          r"away from|far from|from|by)")  # fmt: skip
LEAST = (r"(?:at (?:the )?least|(?:no|not) (?:less|smaller|fewer) than|min(?:imum|imal)?(?: of)?)")
MOST = (r"(?:at (?:the )?most|(?:no|not) (?:more|larger|bigger|greater) than|max(?:imum|imal)?(?: of)?|up to)")
UNIT = r"(?:m2|sqm|sq\.? ?m|square met(?:er|re)s?|sq\.? ?ft|sqft|square feet)"
AMOUNT = r"\d+(?:[.,]\d+)?(?![.,]?\d)"
END = r"(?= ?(?:(?<!\d)[.,]|[.,](?!\d)|[;:!?)\n]|$))"
"""Where a clause may end; not within a number."""
WORDS = {
    "hall": HALL, "outside": OUTSIDE, "room": ROOM, "kind": KIND, "the": rf"(?:the|my|our|both) {KIND}",
    "number": NUMBER, "several": SEVERAL, "young": YOUNG, "grown": GROWN, "must": MUST, "not": NOT, "has": HAS,
    "go": GO, "beside": BESIDE, "least": LEAST, "most": MOST, "unit": UNIT, "amount": AMOUNT, "end": END,
    "de": DE, "fr": FR, "es": ES, "zh": ZH, "bedrooms": BEDROOMS, "bedroom": BEDROOM,
}  # fmt: skip


def rules(said: Iterable[tuple[str, Words]], **own: str) -> list[tuple[Late, Words]]:
    """Patterns with the pieces, and `own` ones, in the place of their names."""
    named = WORDS | own
    return [(Late(pattern, named), words) for pattern, words in said]


def reworded(text: str, said: Iterable[tuple[Late, Words]]) -> str:
    """A text with its clauses in other words, one rule after another."""
    for pattern, words in said:
        text = pattern.sub(words, text)
    return text
