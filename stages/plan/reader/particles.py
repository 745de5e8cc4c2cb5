"""Small words that are read by what they are rather than by the lexicon: copulas, articles in prepositions, `den`."""

from dataclasses import replace

from apartgen.stages.plan.reader.kin import data as people
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import Item, is_mark

COPULAS = dict.fromkeys(("is", "ist", "est", "es", "lies"), "s") | dict.fromkeys(
    ("are", "sind", "sont", "son", "lie"), "p"
)
COPULAS |= {"be": "", "should be": ""}
"""Words like `is`, and whether they are singular or plural."""

ADJECTIVES = ("adjoining", "adjacent", "connecting", "attached", "connected", "neighbouring", "neighboring")
"""Relations that describe the room after them: `an adjoining kitchen`."""

OTHER_NOUNS = frozenset("side end level storey story floor person persons people students student family".split())
"""`one side` counts no rooms."""


GERMAN = ("man", "wir", "ich", "die", "der", "das", "ein", "eine", "liegt", "liegen", "ist", "sind", "davon",
          "zwei", "drei")
"""What tells German `links`, left, and `den`, the, from the English words."""

CONTRACTED = ("zum", "zur", "im", "am", "beim", "ins", "del", "al", "au")
"""Prepositions that have an article in them: `im Bad` is `in the bathroom`."""

IN = ("im", "in", "en", "dans", "ins", "在")
"""Words for `in` of other languages, of furniture; elsewhere they say nothing."""

ON = ("on", "auf", "sur")
"""Words for `in` where the room is a balcony."""

ELSE = ("else", "ander", "autre", "demas")
"""What tells the other rooms from all."""


def is_german(following: Lexeme) -> bool:
    """Whether `den` before it is an article."""
    noun = following.kind in ("room", "determiner", "number", "size", "ordinal", "label")
    return (noun and not following.text[0].isdigit()) or following.text in GERMAN


def bathing(word: Lexeme, following: Lexeme | None, own: bool) -> Lexeme:
    """`a shower of 3 m²`, `its own shower` are rooms; furniture has no floor area."""
    sized = following is not None and following.kind == "area"
    if word.text != "shower" or not (own or sized):
        return word
    return replace(word, kind="room", value="bathroom:ensuite+shower" if own else "bathroom:shower")


BUREAU = ("bureau", "bureaux")
"""French for a study and for a desk."""
LEADING = ("stop", "determiner", "number", "reach", "negation", "size", "conjunction")
"""What may stand between a room and what is in it: `dans le salon il y a un canapé`."""


def holds(word: Lexeme, after: list[Lexeme], items: list[Item]) -> bool:
    """Whether this is the `in` of `ein Esstisch im Wohnzimmer`."""
    room = [w.kind for w in after if w.kind != "determiner"][:1] == ["room"]
    things = [i for i in items if i.kind in ("object", "room") or i.value == "."]
    goes_on = bool(things) and things[-1].kind == "object" and things[-1].number == 0  # "keine Teppiche: weder im …"
    desk = bool(items) and items[-1].text in BUREAU and any(i.kind == "object" for i in items[-3:-1])
    return _inside(word, after) and room and bool(items) and (items[-1].kind == "object" or goes_on or desk)


def fronts(word: Lexeme, after: list[Lexeme], items: list[Item]) -> bool:
    """Whether this is the `dans` of `dans le salon, un canapé`, which begins a clause."""
    begins = not items or items[-1].kind in ("conjunction", "boundary") or items[-1].value in (".", ",", ":")
    room = next((k for k, w in enumerate(after[:3]) if w.kind == "room"), None) if _inside(word, after[:3]) else None
    which = after[:room] if room is not None else []
    if room is None or not begins or any(w.kind != "determiner" or w.value == "each" for w in which):
        return False
    thing = next((w for w in after[room + 1 :] if w.kind not in LEADING and w.text != ","), word)
    return thing.kind == "furniture" or thing.text in BUREAU


def _inside(word: Lexeme, after: list[Lexeme]) -> bool:
    """Whether a word says that something is in the room behind it; on a balcony, too."""
    room = next((w for w in after if w.kind == "room"), None)
    return word.text in IN or (word.text in ON and room is not None and room.value.startswith("balcony"))


def has_to(words: list[Lexeme], i: int) -> bool:
    """Whether `have to` stands at `i`, which says of nobody that they have something."""
    to, verb = [*(w.text for w in words[i + 1 : i + 2]), ""][0], words[i + 2 : i + 3]
    noun = bool(verb) and verb[0].kind in ("room", "determiner", "number", "label", "size", "mark")
    return words[i].text in ("have", "has", "had", "having") and to == "to" and bool(verb) and not noun


def owns_home(word: Lexeme, following: Lexeme | None) -> bool:
    """Whose home it is says nothing of it, unless these are people counted: `a detective's apartment`."""
    owner = word.kind == "unknown" and word.text.endswith("'s")
    home = following is not None and following.kind == "dwelling"
    return owner and home and not any(word.text.startswith(stem) for stem in people()["stems"])


def of_dwelling(words: list[Lexeme], i: int) -> bool:
    """`un appartement d'une chambre avec …`: the flat has what follows the room at `i`."""
    before = [w for w in words[max(i - 3, 0) : i] if w.kind != "number"]
    return [w.kind for w in before] == ["dwelling", "stop"] and before[1].text in ("of", "de", "von")


def furnishes(word: Lexeme, last: list[Item], items: list[Item]) -> bool:
    """Whether a word that may be a room or furniture goes on with the furniture of the room spoken of."""
    owner = next((i.room.type for i in reversed(items) if i.room and i.room.type), "")
    of = {"bed": "bedroom", "beds": "bedroom", "bibliotheque": "study"}.get(word.text, "bathroom")
    whose = last[-1].text == "for" and word.text in ("toilet", "wc")  # "a bathroom for everybody and a toilet"
    return of == owner and last[-1].kind in ("object", "with") and not whose


def passed_over(items: list[Item]) -> tuple[str, ...]:
    """Kinds that stand between furniture and what goes on with it: `a shower and no bath`, `a shower, but no bath`."""
    between = ("conjunction", "mark", "area")
    before = [i for i in items if i.kind not in ("negation", "boundary")][-2:]
    denied = items[-1:] and items[-1].kind == "negation" and items[-1].value in ("no", "without")
    goes_on = [i.kind for i in before] in (["object", "conjunction"], ["object", "mark"]) or _ends_in_thing(before)
    return (*between, "negation", "boundary") if denied and goes_on and not is_mark(before[-1], ".") else between


def _ends_in_thing(before: list[Item]) -> bool:
    return bool(before) and before[-1].kind == "object"
