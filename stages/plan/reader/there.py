"""What `in there`, `in it` and `the two` mean: the room that a sentence is about, the two that it has just named."""

import re

from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import KIND, MUST

_NAMED = rf"(?:(?:the|my|our|an?|one|his|her|their) )?(?:own )?(?:{KIND}|bed ?room \d)"
_ROOM = Late(rf"(?P<at>\b(?:(?:next|close|adjacent|door|one|opposite|belong(?:s|ing)?) to|beside|near|off|from|"
             rf"opposite|behind|of|into|to|through|than) )?\b(?P<room>{_NAMED})\b(?!'s)")  # fmt: skip
_THERE = Late(r"(?<!open )(?<!opens )(?<!leads )(?<!go )(?<!get )(?<!goes )\b(?:in|inside) "
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


def whose_place(text: str) -> str:
    """A folded text with `in there` as in the room that is meant, `a door between the two` with both named."""
    text = _BOTH.sub(r"a door to \g<a> and a door to \g<b>", text)
    text = _TWO.sub(_door_between, text) if "door between" in text else text
    return _THERE.sub(_place, text) if _THERE.search(text) else text


def _door_between(found: re.Match[str]) -> str:
    """`a nursery next to our bedroom, with a door between the two as well as one to the hall`."""
    a, b = found["a"], found["b"]
    if b == "it":
        before = _rooms(found.string[: found.start()])
        if not before:
            return found.group()
        b = before[-1]
    bare = re.sub(r"^(?:an?|one) ", "the ", a)
    hall = f" and a door to the {found['hall']}" if found["hall"] else ""
    if found["also"] and not found["hall"]:
        hall = found["also"]
    other = re.sub(r"^(?:an?|one) ", "the ", b)
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
    return f"{preposition} {re.sub(r'^(?:an?|one) ', 'the ', room)}"


def _rooms(sentence: str) -> list[str]:
    """Rooms that a sentence speaks of, without those that only say where."""
    found = list(_ROOM.finditer(sentence))
    return [m["room"] for m in found if not m["at"]]
