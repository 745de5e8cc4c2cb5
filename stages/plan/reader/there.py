"""What `in there`, `in it` and `the two` mean: the room that a sentence is about, the two that it has just named."""

import re

from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import AMOUNT, KIND, MUST, UNIT

_NAMED = rf"(?:(?:the|my|our|an?|one|his|her|their) )?(?:[a-z]+'s )?(?:own )?(?:{KIND}|(?:bed ?)?room(?: \d)?)"
_ROOM = Late(rf"(?P<at>\b(?:(?:next|close|adjacent|door|one|opposite|belong(?:s|ing)?) to|beside|near|off|from|"
             rf"opposite|behind|of|into|to|through|than) )?\b(?P<room>{_NAMED})\b(?!'s)")  # fmt: skip
_THERE = Late(r"(?<!open )(?<!opens )(?<!leads )\b(?:in|inside) "
              r"(?:there|it|that one|this one)\b(?! (?:is|are|must|should|has|will|was|can))|"
              r"(?<=[a-z] )\bon it(?= ?(?:[.,;]|$))")  # fmt: skip
_POSSESSED = Late(r"\b(?:mine|hers|ours|theirs|his (?=can|should|must|is|has|needs))\b")
_SENTENCE = Late(r"[.!?;\n](?!\d)")
_BESIDE = r"(?:(?:right|directly|just) )?(?:next to|beside|adjacent to|adjoining|close to|near|opposite)"
_TWO = Late(
    rf"(?P<a>{_NAMED}) (?:(?:{MUST} )?(?:be|is|lies|goes) |that is |which is )?{_BESIDE} (?P<b>{_NAMED}|it)"
    rf"(?P<mid>[?!.,;]* ?(?:(?:and|with|plus) )?)(?:an? |one )?(?:(?:connecting|direct|inner) )?door between "
    r"(?:the two|them|both)"
    r"(?: rooms)?(?: (?:would be|is) (?:great|nice|lovely|good|perfect|important|needed)| too| as well(?! as\b))?"
    rf"(?P<also>,? (?:as well as|and|plus|besides|in addition to|but)(?: also)?[^.;!?]*?"
    r"\b(?P<hall>hall(?:way)?|corridor)\b[^.;!?]*)?"
)
_BOTH = Late(
    rf"\b(?:an? |its |one )?(?:second )?door from (?P<a>{_NAMED}) (?:in addition to|besides|as well as|on top of) "
    rf"the (?:one|door|other|usual one) (?:from|to|off|on) (?P<b>{_NAMED})"
)


_ENTERED = Late(
    r"(?P<a>(?:an? |one |the )?(?:little |small |big )?(?:pantry|larder|storage(?: room)?|store ?room|"
    r"utility(?: room)?|laundry(?: room)?|"
    r"closet|balcony|terrace))(?: for [a-z]+)?,? (?:that |which )?(?:you|i|we|one) (?:can |could |should )?(?:enter|"
    r"reach|get into|go into|walk into|step into|get to)s?(?:,? (?:straight|directly))? from (?P<b>it|there)\b"
)
_DOOR_THERE = Late(
    rf"(?P<x>(?P<b>{_NAMED})(?:[^.;]*?)) (?:is |are )?(?P<by>{_BESIDE}) (?P<a>{_NAMED})[,.;] ?(?:and )?between "
    rf"(?:them |the two |it )?(?:there )?"
    r"(?:is|should be|must be) (?:an? |one )?door\b"
)
_OPEN_TO_IT = Late(rf"(?P<a>{_NAMED})\b(?P<x>[^.;]*?) and (?P<k>the kitchen) is open to it\b")
_ITS_WINDOW = Late(
    rf"(?P<x>(?:^|(?<=[.!?] ))[^.!?]*?\b{_NAMED}\b[^.!?]*?)[,;]? (?:and |with |)its windows? "
    r"(?:should |must |has to |have to )?(?:facing|looking|looks?|faces?|to|towards|"
    r"oriented)(?: to(?:wards)?)?(?: the)? (?P<s>(?:north|south)(?:[ -]?(?:east|west))?|east|west)\b"
)
_UNDER = Late(rf"(?P<x>[^.;]*?\b{_NAMED}\b[^.;]*?); ?keep it (?P<l>under|below|above|over) (?P<n>{AMOUNT} ?{UNIT})")


def whose_place(text: str) -> str:
    """A folded text with `in there` as in the room that is meant, `a door between the two` with both named."""
    text = _ENTERED.sub(_entered, text)
    text = _DOOR_THERE.sub(r"\g<x> is \g<by> \g<a>. \g<b> has a door to \g<a>", text)
    text = _OPEN_TO_IT.sub(r"\g<a>\g<x>. \g<k> is open to the living room", text) if "living room" in text else text
    text = _ITS_WINDOW.sub(_its_window, text) if "its window" in text else text
    text = _UNDER.sub(_kept_under, text)
    text = _BOTH.sub(r"a door to \g<a> and a door to \g<b>", text)
    text = _TWO.sub(_door_between, text) if "door between" in text else text
    return _THERE.sub(_place, text) if _THERE.search(text) else text


def _the(room: str) -> str:
    return re.sub(r"^(?:an?|one) ", "the ", room)


def _its_window(found: re.Match[str]) -> str:
    """`a study beside the living room with its window to the north`: that of the last room that is no landmark."""
    here = _rooms(found["x"])
    return f"{found['x']}. {_the(here[-1])} faces {found['s']}" if here else found.group()


def _kept_under(found: re.Match[str]) -> str:
    """`a storage room off the kitchen; keep it under 4 m2`."""
    here = _rooms(found["x"])
    bound = "at most" if found["l"] in ("under", "below") else "at least"
    return f"{found['x']}. {_the(here[-1])} is {bound} {found['n']}" if here else found.group()


def _entered(found: re.Match[str]) -> str:
    """`the kitchen needs an island and a pantry you enter from it`: reached from the first room that is no landmark."""
    before = found.string[: found.start()]
    ends = [m.end() for m in _SENTENCE.finditer(before)]
    here = _rooms(before[ends[-1] if ends else 0 :])
    return f"{found['a']} reached from {_the(here[0])}" if here else found.group()


def _door_between(found: re.Match[str]) -> str:
    """`a nursery next to our bedroom, with a door between the two as well as one to the hall`."""
    a, b = found["a"], found["b"]
    if b == "it":
        before = _rooms(found.string[: found.start()])
        if not before:
            return found.group()
        b = before[-1]
    bare = _the(a)
    hall = f" and a door to the {found['hall']}" if found["hall"] else ""
    if found["also"] and not found["hall"]:
        hall = found["also"]
    other = _the(b)
    return f"{a} next to {other}. {bare} has a door to {other}{hall}"


def _place(found: re.Match[str]) -> str:
    """`in the nursery` for `in there`: the last room of the sentence that is no landmark,
    else what the one before is about."""
    before = found.string[: found.start()]
    ends = [m.end() for m in _SENTENCE.finditer(before)]
    here = _rooms(before[ends[-1] if ends else 0 :])
    preposition = "on" if found.group() == "on it" else "in"
    if _POSSESSED.search(before[ends[-1] if ends else 0 :]):
        return found.group()
    if here:
        room = here[-1]
    else:
        earlier = [_rooms(before[a:b]) for a, b in zip([0, *ends], ends, strict=False)]
        told = next((rooms for rooms in reversed(earlier) if rooms), None)
        if told is None:
            return found.group()
        room = told[0]
    return f"{preposition} {_the(room)}"


def _rooms(sentence: str) -> list[str]:
    """Rooms that a sentence speaks of, without those that only say where."""
    found = list(_ROOM.finditer(sentence))
    return [m["room"] for m in found if not m["at"] and not m["room"].endswith("rooms")]
