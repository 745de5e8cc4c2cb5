"""One sentence for one field of a room, as the rules of sentences read it best."""

import re
from collections import Counter
from typing import Any

from apartgen.stages.plan.reader.field_names import HOME, LIMIT, UNIT, WRAP
from apartgen.stages.plan.reader.field_values import (
    NUMBER,
    PLACES,
    SHORT,
    SIDE,
    Unclear,
    limited,
    pairs_of,
    plural_of,
    room,
    thing,
    truth,
    whole,
    words,
)

Subject = str
"""A room in words, `bedroom 2`; empty for the whole flat."""


class Sentences:
    """Sentences said so far; `known` are the rooms counted in the whole prompt, `named` rooms by names of their own."""

    def __init__(self, known: Counter[str]) -> None:
        self.known = known
        self.counts: Counter[str] = Counter()
        self.said: list[str] = []
        self.named: dict[str, str] = {}

    def say(self, *parts: str) -> None:
        """One sentence more."""
        sentence = " ".join(p for p in parts if p)
        if not sentence:
            raise Unclear
        self.said.append(f"{sentence[0].upper()}{sentence[1:]}.")

    def name(self, key: str) -> Subject:
        """The room that a key names, the flat for `home`."""
        if key in HOME or key in WRAP:
            return ""
        found = room(key)
        if found is None:
            raise Unclear
        return " ".join(p for p in found if p)

    def is_room(self, name: Any) -> bool:
        """Whether a key is a room's."""
        return words(name) in self.named or words(name) in HOME or room(words(name)) is not None

    def other(self, name: Any) -> Subject:
        """A room that is named in a field."""
        text = re.sub(r"^(?:the|of|to|from) ", "", words(name))
        text = re.sub(r" only$", "", text)
        known = self.named.get(text)
        if known:
            kind, _, number = known.rpartition(" ")
            return known if not number.isdigit() or self.counts[kind] > 1 else kind
        return "entrance" if text in ("entrance", "entry", "front door", "main door") else self.name(text)

    def place(self, subject: Subject, to: Any, *, faces: bool) -> None:
        """Where a room lies in the flat or what its windows look to."""
        text = words(to) if isinstance(to, str) else ""
        text = SHORT.get(text, re.sub(r"^(?:(?:in|at|on|to|towards) )?(?:the )?", "", text))
        side = SIDE.fullmatch(text)
        if not subject:
            raise Unclear
        if side:
            direction = " ".join(p for p in side.groups()[:2] if p)
            self.say(f"the {subject}", f"faces {direction}" if faces else
                     f"is in the {direction}{' corner' if side[3] == 'corner' else ''}")  # fmt: skip
        elif text.removesuffix(" of the flat") in PLACES:
            self.say(f"the {subject} is", PLACES[text.removesuffix(" of the flat")])
        else:
            raise Unclear

    def relation(self, subject: Subject, verb: str, value: Any) -> None:
        """`near: kitchen`, `near: {study: entrance}`, `near: [[study, kitchen]]`."""
        for one, other in pairs_of(subject, value):
            a, b = (one if one == subject and subject else self.other(one)), self.other(other)
            if verb.startswith("no door"):
                self.say(f"there is no door between the {a} and the {b}")
            elif a:
                self.say(f"the {a}", verb, f"the {b}")
            else:
                raise Unclear

    def amount(self, subject: Subject, what: str, limit: str, value: Any, unit: str = "m2") -> None:
        """An area, a width, a length or a number of doors, or its limits."""
        if isinstance(value, dict):
            for key, one in value.items():
                bound = LIMIT.get(words(key)) or ("" if words(key) in ("value", "exact", "target") else None)
                if bound is None:
                    raise Unclear
                self.amount(subject, what, bound, one, unit)
            return None
        if isinstance(value, list) and len(value) == 2 and all(isinstance(v, int | float) for v in value):
            if what == "dimension":
                return self.say(f"the {subject} measures {value[0]} x {value[1]} m")
            self.amount(subject, what, "at least", value[0], unit)
            return self.amount(subject, what, "at most", value[1], unit)
        text = str(value).lower()
        if sides := re.fullmatch(rf"({NUMBER}) ?m? ?(?:x|by|×) ?({NUMBER}) ?m?", text):
            return self.say(f"the {subject or 'flat'} measures {sides[1]} x {sides[2]} m")
        if several := re.fullmatch(rf"({NUMBER}) ?(?:-|–|to) ?({NUMBER}) ?(?:{UNIT}|m)?", text):
            self.amount(subject, what, "at least", several[1], unit)
            return self.amount(subject, what, "at most", several[2], unit)
        bound, number, its = limited(text)
        limit, unit = limit or bound, its or unit
        who = "the whole flat" if not subject else f"each {subject}" if self.known[subject] > 1 else f"the {subject}"
        if number is None or what in ("?", "dimension"):
            raise Unclear
        match what:
            case "width" | "length":
                self.say(who, "is", limit, f"{number} m", "wide" if what == "width" else "long")
            case "doors":
                self.say(who, "has", limit or "at most", number, "doors")
            case _:
                self.say(who, "is", limit, number, unit or "m2")

    def things(self, subject: Subject, value: Any) -> None:
        """Furniture of a room: a list, a table of counts, or words."""
        if isinstance(value, dict):
            named = [f"{n} {words(k)}" for k, n in value.items() if isinstance(n, int) and n]
        else:
            listed = value if isinstance(value, list) else re.split(r",\s*|\s+and\s+", str(value))
            several = Counter(thing(one) for one in listed)
            named = [f"{n * more} {name}" for (name, n), more in several.items()]
        if not subject or not named:
            raise Unclear
        for piece in named:
            count, _, name = piece.partition(" ")
            self.say(f"the {subject} has {count} {name if count == '1' or name.endswith('s') else plural_of(name)}")

    def ensuite(self, subject: Subject, value: Any) -> None:
        """A bathroom of a room's own; how many of the flat's, or whose."""
        if isinstance(value, str) and self.is_room(value):
            subject, value = self.other(value), True
        if subject and truth(value):
            self.say(f"the {subject} has an ensuite bathroom")
        elif not subject and truth(value) is False:
            self.say("no ensuite bathroom")
        elif not subject and isinstance(value, int) and value > 0 and value is not True:
            self.say(f"{value} of the bathrooms {'are' if value > 1 else 'is'} en suite")
        elif not subject:
            raise Unclear

    def opened(self, value: Any) -> None:
        """An open plan: whether, or of which rooms; pairs of them are opened one after another."""
        ends = [re.split(r"\s*<?->?\s*", one) for one in (re.split(r",\s*", value) if isinstance(value, str) else value
                if isinstance(value, list) else []) if isinstance(one, str)]  # fmt: skip
        value = ends if ends and all(len(pair) == 2 for pair in ends) else value
        if isinstance(value, list) and value and all(isinstance(one, list | dict) for one in value):
            for one in value:
                self.opened(list(one.values()) if isinstance(one, dict) else one)
            return
        names = (
            value
            if isinstance(value, list)
            else re.split(r"\s*(?:\+|,|&|/|\band\b)\s*", value if isinstance(value, str) else "")
        )
        rooms = [self.other(name) for name in names if self.is_room(name)] if truth(value) is None else []
        if len(rooms) == len(names) > 1:
            for one in rooms[1:]:
                self.say(f"the {rooms[0]} is open to the {one}")
        elif truth(value) is not None:
            self.say("the kitchen is open to the living room" if truth(value) else "no open kitchen")
        else:
            raise Unclear

    def each(self, subject: Subject, value: Any, tell: Any) -> None:
        """A field of one room, or of several in a table by their names."""
        rooms = isinstance(value, dict) and not subject and all(self.is_room(k) for k in value)
        if rooms:
            for name, one in value.items():
                tell(self.other(name), one)
        else:
            tell(subject, value)

    def count(self, kind: str, value: Any) -> None:
        """`2`, `x2`, `true`, `none` of a room."""
        number = whole(value)
        if number is None:
            raise Unclear
        if number:
            self.counts[kind] = number
        else:
            self.counts.pop(kind, None)
            self.say(f"no {kind}")

    def parted(self, text: str) -> tuple[Subject, str]:
        """The room that words begin with, and the rest of them."""
        parts = text.split()
        for k in range(min(5, len(parts)), 0, -1):
            if (found := room(" ".join(parts[:k]))) is not None:
                return " ".join(p for p in found if p), " ".join(parts[k:])
        return "", text
