"""Fields of a home and of its rooms, whatever their names, told one after another."""

import re
from collections import Counter
from typing import Any

from apartgen.stages.plan.reader.field_names import (
    AMOUNT,
    COUNT,
    DIRECTION,
    HOME,
    IGNORED,
    LIMIT,
    NAME,
    NOTES,
    OF_BEDROOMS,
    OPEN,
    RELATIONS,
    SIZE,
    TEXT,
    THINGS,
    UNIT,
    USUAL,
    WRAP,
)
from apartgen.stages.plan.reader.field_sentences import Sentences, Subject
from apartgen.stages.plan.reader.field_values import (
    NUMBER,
    PLACES,
    SHORT,
    SIDE,
    Unclear,
    as_list,
    as_pairs,
    is_furniture,
    is_measured,
    limited,
    plural_of,
    room,
    taken_apart,
    thing,
    truth,
    whole,
    words,
)

_BOUND = re.compile(
    rf"(at least|at most|min(?:imum)?|max(?:imum)?) (?:(width|length|area) )?({NUMBER}) ?(m|m2|sqm|doors?)?"
    r"(?: (wide|long))?"
)


class Fields(Sentences):
    """Rooms are counted first, so that each is told of as one of them."""

    def __init__(self, known: Counter[str]) -> None:
        super().__init__(known)
        self.dwelling = "flat"
        self.numbers: Counter[str] = Counter()

    def flat(self, fields: Any) -> str:
        """All that the fields of a home say."""
        self.fields("", fields)
        if not self.said and not self.counts:
            raise Unclear
        rooms = [f"{n} {name if n == 1 else plural_of(name)}" for name, n in self.counts.items() if n]
        return f"A {self.dwelling}{' with: ' if rooms else ':'}{', '.join(rooms)}. " + " ".join(self.said)

    def fields(self, subject: Subject, fields: Any) -> None:
        """Every field of one room or of the flat."""
        pairs = as_pairs(fields, areas=not subject)
        if pairs and not isinstance(pairs[0], tuple):
            return self.rooms(pairs)
        for key, value in pairs:
            if not key:
                self.statement(value)
                continue
            path = [words(part) for part in str(key).split(".")]
            inner = subject
            while len(path) > 1 and (path[0] in HOME or path[0] in WRAP or (not inner and room(path[0]))):
                inner = inner or self.name(path[0])
                path = path[1:]
            self.field(inner, " ".join(path), value)

    def statement(self, text: str) -> None:
        """`bedroom 3 adjacent to bedroom 4` among fields: a room and what is said of it."""
        subject, rest = self.parted(words(text))
        if not subject:
            raise Unclear
        if not rest:
            self.room((subject, ""), 1)
        elif whole(rest) is not None:
            self.count(subject, rest)
        else:
            self.phrase(subject, rest)

    def field(self, subject: Subject, key: str, value: Any) -> None:
        """One field, by what its key is."""
        if value is None or value == "":
            return
        key = re.sub(r"^(?:n|num|nr|no|nb|number of|no of|num of) (?=[a-z ]+s$)", "", key)
        bare, limit, unit = taken_apart(key)
        if key in IGNORED or (
            not subject and key in ("type", "kind", "unit", "dwelling", "property type", "home type")
        ):
            if isinstance(value, str) and value.lower() in ("studio", "loft", "house"):
                self.dwelling = value.lower()
        elif key in TEXT and not (subject and key in NOTES):
            self.text(value)
        elif key in WRAP and isinstance(value, str):
            for part in re.split(r",\s*", value):
                self.statement(part)
        elif key in WRAP or (not subject and key in HOME and isinstance(value, dict | list)):
            self.fields(subject, value)
        elif key in RELATIONS or (key == "doors" and isinstance(value, list | dict)):
            self.relation(subject, RELATIONS.get(key, "has a door to"), value)
        elif key in DIRECTION:
            self.each(subject, value, lambda who, to: self.place(who, to, faces=DIRECTION[key]))
        elif key in THINGS:
            self.each(subject, value, self.things)
        elif subject and key in COUNT:
            self.count(subject, value)
        elif (
            subject and key in SIZE and isinstance(value, str) and value.lower() in ("small", "large", "big", "medium")
        ):
            self.say(f"the {subject} is {value.lower()}") if value.lower() != "medium" else None
        elif bare in AMOUNT:
            self.each(subject, value, lambda who, to: self.amount(who, AMOUNT[bare], limit, to, unit))
        elif key in ("ensuite", "en suite", "ensuites", "ensuite bathroom", "ensuite bathrooms", "private bathroom"):
            self.ensuite(subject, value)
        elif key in OPEN:
            self.opened(value)
        elif subject and key in ("bed", "beds") and isinstance(value, str):
            self.things(subject, f"{words(value)} bed")
        elif not subject and is_measured(key):
            self.field(self.name(key.rpartition(" ")[0]), key.rpartition(" ")[2], value)
        elif (found := room(key)) is not None and not subject:
            self.room(found, value)
        elif found is not None and truth(value):
            self.say(f"the {subject} has a {found[0]}")
        elif not subject and key == "near entrance":
            self.relation("", RELATIONS["near"], [[one, "entrance"] for one in as_list(value)])
        elif not subject and all(self.parted(key)):
            self.field(*self.parted(key), value)
        elif not subject and isinstance(value, str) and self.is_room(value) and is_furniture(key):
            self.things(self.name(words(value)), key)
        elif subject and isinstance(value, str) and key in NOTES:
            for part in value.split(","):
                self.phrase(subject, part)
        else:
            raise Unclear

    def rooms(self, rooms: list[Any]) -> None:
        """A list of rooms: names, or fields with a name or a type."""
        told: list[tuple[str, dict[str, Any]]] = []
        for one in rooms:
            if isinstance(one, str):
                one = {"type": one}
            named = {words(k): v for k, v in one.items()} if isinstance(one, dict) else {}
            named = {k: v for k, v in named.items() if v not in (None, "")}
            kind = next((str(named[k]) for k in NAME if k in named and room(words(str(named[k])))), None)
            if kind is None:
                raise Unclear
            found = room(words(kind)) or ("", "")
            rest = {k: v for k, v in named.items() if k not in NAME}
            if not (count := whole(next((rest.pop(k) for k in list(rest) if k in COUNT), 1))):
                raise Unclear
            told += [(f"{found[0]} {(number := found[1] if count == 1 else '')}".strip(), rest)]
            beside = self.counts[found[0]]  # "bedrooms: 2 … rooms: [{name: bedroom 1}]"
            self.counts[found[0]] = max(beside, int(number)) if number else beside + count
            for k in NAME:
                if isinstance(named.get(k), str):
                    self.named[words(named[k])] = f"{found[0]} {self.counts[found[0]]}"
        for kind, rest in told:
            if kind[-1:].isdigit():
                self.fields(kind, rest)
                continue
            self.numbers[kind] += 1
            several = self.counts[kind] > 1
            group = several and sum(k == kind for k, _ in told) == 1
            self.fields(f"each {kind}" if group else f"{kind} {self.numbers[kind]}" if several else kind, rest)

    def room(self, found: tuple[str, str], value: Any) -> None:
        """A room's key: how many there are, what is said of it or of each."""
        kind, number = found
        subject = f"{kind} {number}".strip()
        told_apart = kind.endswith(" bedroom") and self.known["bedroom"] > 0  # "bedrooms: 3 … master: 15 m2"
        if number:
            self.counts[kind] = max(self.counts[kind], int(number))
        if isinstance(value, bool | int | float) or (isinstance(value, str) and not number and whole(value)):
            return self.count(kind, value)
        if isinstance(value, dict):
            count = next((v for k, v in value.items() if words(k) in COUNT), None)
            several = isinstance(count, int) and count > 1
            self.counts[kind] = (
                count if isinstance(count, int) else self.counts[kind] or int(kind not in USUAL and not told_apart)
            )
            return self.fields(
                f"each {kind}" if several else subject, {k: v for k, v in value.items() if words(k) not in COUNT}
            )
        if isinstance(value, list) and value and all(isinstance(v, dict) for v in value):
            self.counts[kind] = len(value)
            each = [(f"{kind} {k}" if len(value) > 1 else kind, one) for k, one in enumerate(value, 1)]
            for who, one in each:
                self.named |= {words(v): who for k, v in one.items() if words(k) in NAME and isinstance(v, str)}
            for who, one in each:
                self.fields(who, {k: v for k, v in one.items() if words(k) not in NAME})
            return None
        if isinstance(value, list):
            for one in value:
                self.phrase(subject, one)
            return None
        if kind in OF_BEDROOMS and self.is_room(str(value)):
            return self.say(f"the {self.other(str(value))} has a {kind}")
        if not number and not told_apart and kind not in USUAL:  # of usual rooms it is no list: others are there, too
            self.counts[kind] = self.counts[kind] or 1
        for part in re.split(r",\s*(?!\d)", str(value)):
            self.phrase(subject, part)

    def phrase(self, subject: Subject, part: Any) -> None:
        """A piece of a room's value: how many, where, how large, beside what, with what."""
        text = words(part) if isinstance(part, str) else str(part)
        text = re.sub(r"(?<=\d) (?=\d)", "-", text).strip(" .()")
        head, _, rest = text.partition(" ")
        kind = re.sub(r" \d+$", "", subject)
        if whole(text) is not None:
            return self.count(kind, text)
        if counted := re.fullmatch(r"(\d{1,2}) \(?(?:one|1|two|2) (?:is |are )?(?:en ?suite|ensuite)", text):
            self.count(kind, counted[1])
            return self.ensuite("", value=1)
        for size in range(min(4, len(text.split())), 0, -1):
            key, rest = " ".join(text.split()[:size]), " ".join(text.split()[size:])
            if key in RELATIONS and rest:
                return self.relation(subject, RELATIONS[key], re.split(r" and | & ", rest))
            if key in DIRECTION and rest and (SIDE.fullmatch(rest) or rest in PLACES):
                return self.place(subject, rest, faces=DIRECTION[key])
        if window := re.fullmatch(r"(?:with )?(?:a )?windows? (?:to|facing|towards|on)(?: the)? (.+)", text):
            return self.place(subject, window[1], faces=True)
        if head in ("with", "has", "including") and text != head:
            return self.say(f"the {subject}", "has", text.partition(" ")[2])
        if sided := re.fullmatch(rf"({NUMBER} ?(?:{UNIT})?) ({'|'.join(SHORT)}|north|south|east|west)", text):
            self.phrase(subject, sided[1])
            return self.place(subject, sided[2], faces=True)
        if re.fullmatch(rf"(?:at (?:least|most) |min(?:imum)? |max(?:imum)? |about )?{NUMBER} ?(?:{UNIT})", text):
            return self.amount(subject, "", *limited(text))
        if measured := re.fullmatch(rf"({NUMBER}) ?m? ?(?:x|by|×) ?({NUMBER}) ?m?", text):
            return self.say(f"the {subject} measures {measured[1]} x {measured[2]} m")
        if bound := _BOUND.fullmatch(text):
            what = {"wide": "width", "long": "length"}.get(bound[5] or "", bound[2] or "")
            what = "doors" if (bound[4] or "").startswith("door") else what or ("" if bound[4] != "m" else "?")
            return self.amount(subject, what, LIMIT.get(bound[1], bound[1]), bound[3], "m2")
        if text in ("small", "large", "big"):
            return self.say(f"the {subject} is {text}")
        if re.fullmatch(r"(?:the )?(?:largest|smallest|biggest)(?: room)?", text):
            return self.say(f"the {subject} is the {'smallest' if 'smallest' in text else 'largest'} room")
        if text in ("ensuite", "en suite"):
            return self.ensuite(subject, value=True)
        if text in ("open", "open plan") and kind == "kitchen":
            return self.say("the kitchen is open to the living room")
        if (
            text in PLACES
            or SIDE.fullmatch(re.sub(r"^(?:(?:in|at|on|to|towards) )?(?:the )?", "", text))
            or text in SHORT
        ):
            return self.place(subject, text, faces=False)
        if kind == "bedroom" and re.sub(r" \d$", "", (room(text) or ("", ""))[0]) in OF_BEDROOMS:
            return self.say(f"the {subject} has a {text}")
        return self.things(subject, text) if is_furniture(thing(text)[0]) else self.place(subject, text, faces=False)

    def text(self, value: Any) -> None:
        """Sentences that stand in a field."""
        if isinstance(value, list):
            for one in value:
                if isinstance(one, list) and len(one) == 3 and words(one[1]) in RELATIONS:
                    self.relation("", RELATIONS[words(one[1])], [[one[0], one[2]]])
                elif isinstance(one, dict):
                    self.constraint(one)
                else:
                    self.text(one)
        elif isinstance(value, str):
            self.say(value.strip(" .").replace("_", " "))
        elif isinstance(value, dict):
            self.fields("", value)
        else:
            raise Unclear

    def constraint(self, fields: dict[str, Any]) -> None:
        """`{type: adjacent, rooms: [a, b]}`, `{adjacent: [a, b]}`."""
        named = {words(k): v for k, v in fields.items()}
        kind = next((words(named[k]) for k in ("type", "kind", "relation", "constraint") if k in named), None)
        if kind is not None and "room" in named and "value" in named and kind not in RELATIONS:
            return self.field(self.other(named["room"]), kind, named["value"])
        if "room" in named and kind not in RELATIONS:
            return self.fields(self.other(named["room"]), {k: v for k, v in fields.items() if words(k) != "room"})
        if kind not in RELATIONS:
            return self.fields("", fields)
        rooms = next((named[k] for k in ("rooms", "between", "pair", "args") if k in named), None)
        rooms = rooms or [v for k, v in named.items() if k not in ("type", "kind", "relation", "constraint")]
        return self.relation("", RELATIONS[kind], [rooms])
