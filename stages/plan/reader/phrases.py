"""Lexemes grouped into phrases: rooms with their numbers and traits, furniture, relations, marks."""

from dataclasses import replace

from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.lexicon import Lexicon
from apartgen.stages.plan.reader.mention import OPEN_TYPES, PARTITIVE, Item, RoomPhrase, rooms_of
from apartgen.stages.plan.reader.modifiers import Modifiers
from apartgen.stages.plan.reader.orders import extreme
from apartgen.stages.plan.reader.particles import (
    ADJECTIVES,
    CONTRACTED,
    COPULAS,
    ELSE,
    GERMAN,
    bathing,
    fronts,
    furnishes,
    has_to,
    holds,
    is_german,
    of_dwelling,
    owns_home,
    passed_over,
)  # fmt: skip
from apartgen.stages.plan.reader.pending import Pending, area_item, trailing_number
from apartgen.stages.plan.reader.vocabulary import Det, Trait

HALLS = ("hallway", "corridor", "hall", "passage", "hallways", "corridors", "passages")
"""Last words of styles that are said of one hallway: `long corridor`, `short hallway`, `long corridors`."""
SLEEPERS = {Trait.KIDS, Trait.GUEST, Trait.RELATIVE, Trait.MASTER}
"""Labels of whose rooms are bedrooms."""
ADVERBIAL = ("ly", "ed", "ing", "s", "erweise")
PERHAPS = ("maybe", "perhaps", "best", "always", "somewhere", "even", "still", "right", "just", "also")
"""What may stand before a relation and is no noun."""


DONE = ("studies", "study", "store", "stores")
MODALS = ("can", "could", "to", "will", "must", "should", "may", "we", "i", "you", "they")
"""Verbs that also name rooms, and what stands before a verb."""


class Phraser(Modifiers):
    """Walks lexemes once, left to right; `items` and `unread` hold the outcome."""

    def __init__(self, lexicon: Lexicon) -> None:
        super().__init__()
        self.lexicon = lexicon

    def walk(self, words: list[Lexeme]) -> "Phraser":
        """Read all lexemes."""
        i = 0
        while i < len(words):
            i = self._step(words, i)
        self._flush()
        return self

    def _step(self, words: list[Lexeme], i: int) -> int:
        word = words[i]
        if word.value == "word" and word.kind in ("stop", "adjective"):
            self.unread.append(word.text)
        following = words[i + 1] if i + 1 < len(words) else None
        if owns_home(word, following):
            return i + 1
        if word.text == "den" and following is not None and is_german(following):
            return i + 1  # German article
        if word.text == "links" and following is not None and following.text in GERMAN:
            word = words[i] = replace(word, kind="place", value="left")
        if word.text == "that" and following is not None and following.kind == "room" and self._clause_begins():
            self._determiner(replace(word, kind="determiner", value="the"))
            self.pending.texts.append(word.text)
            return i + 1
        if (
            word.kind == "link"
            and word.text in ADJECTIVES
            and not self.pending.empty()
            and following is not None
            and following.kind == "room"
        ):
            self.pending.labels.add(Trait.ADJOINING)
            return i + 1
        if skipped := self._without_meaning(words, i):
            return i + skipped
        word = words[i] = bathing(word, following, Trait.OWN in self.pending.labels)
        if word.kind == "style" and word.text.endswith(" bedrooms") and not self.pending.empty():
            self.items.append(Item("style", word.value, word.text))  # "five private bedrooms"
            word = words[i] = replace(word, kind="room", value="bedroom", text="bedrooms", plural=True)
        if word.kind == "style" and _of_hall(word.text):
            self.items.append(Item("style", word.value, word.text))  # "one long hallway": a hallway, too
            word = words[i] = replace(word, kind="room", value="hallway", text=word.text.split()[-1])
        after = words[i + 1 : i + 9]
        if word.kind == "stop" and (holds(word, after[:2], self.items) or fronts(word, after, self.items)):
            self._flush(word)
            self.items.append(Item("with", "in", word.text))
            if word.text in CONTRACTED:
                self._determiner(replace(word, kind="determiner", value="the"))
            return i + 1
        if word.text in CONTRACTED and word.kind == "stop" and following is not None and following.kind == "room":
            self._flush(word)
            self._determiner(replace(word, kind="determiner", value="the"))
            self.pending.texts.append(word.text)
            return i + 1
        if self._modifier(word, words, i):
            return i + 1
        if word.kind == "room" and self._is_done(word, words[i - 1] if i else None):
            self.pending, word = Pending(), replace(word, kind="unknown")
            words[i] = word  # "one of whom studies at home", "we can store skis there"
        if word.text in ("cupboard", "cupboards") and not self._in_hall():
            word = words[i] = replace(word, kind="unknown")
        if word.kind == "room" and not self._is_object(word, following):
            return self._room(words, i)
        if word.kind == "room":
            self._object(word, self.lexicon.also_object[word.text])
            return i + 1
        self._other(word, following)
        return i + 1

    def _without_meaning(self, words: list[Lexeme], i: int) -> int:
        """How many words from `i` on belong to a verb alone: `I would like a study`, `has to be`, `I have to go`."""
        like = words[i].text == "like" and words[i].kind == "link" and not self._compares()
        to_be = words[i].text == "to" and i + 1 < len(words) and words[i + 1].text == "be"
        return 1 if like or to_be else 2 if has_to(words, i) else 0

    def _is_object(self, word: Lexeme, following: Lexeme | None) -> bool:
        """`bed` and `bath` are furniture where a room is being furnished, not after "3 …" of a listing."""
        if (
            word.text not in self.lexicon.also_object
            or word.joined
            or (following is not None and following.kind in ("dwelling", "room", "number", "shorthand", "area"))
        ):
            return False
        if self.pending.factor != 1.0 and word.text not in ("bed", "beds"):
            return False  # "a bath with a tub, and a small toilet"
        if word.text in ("toilet", "bath") and self.pending.quantifier == Det.THE:
            return False  # "a shower and no bathtub, the toilet close to the bedroom"
        if word.text == "bed" and self.pending.quantifier == Det.A and self.pending.number is None:
            return True
        last = [i for i in self.items if i.kind not in passed_over(self.items)][-2:]
        furnishing = any(i.kind in ("object", "with") for i in last[-1:])
        return (
            furnishing
            and any(i.kind in ("object", "room") for i in last)
            and last[0].kind != "dwelling"
            and furnishes(word, last, self.items)
        )

    def _room(self, words: list[Lexeme], i: int) -> int:
        word, p = words[i], self.pending
        phrase = p.room(word)
        if phrase.quantifier == Det.ONE_OF and "which" in p.texts[0] and not word.plural:
            phrase.quantifier = Det.A  # "three rooms, one of which is a study"
        key = [w.text if w.kind == "mark" else w.kind for w in words[max(i - 2, 0) : i]]
        if key in (["unknown", ":"], ["label", ":"]) and any(r.type == phrase.type for r in rooms_of(self.items)):
            phrase.quantifier = Det.THE  # "1 living; hub: living"
        phrase.headline = phrase.headline or (phrase.count is not None and of_dwelling(words, i))
        listed = [i.value for i in self.items[-2:]]  # "kitchen, dining and living areas" are three rooms
        if phrase.type in OPEN_TYPES and phrase.count is None and listed[:1] and listed[0] in OPEN_TYPES:
            phrase.plural = phrase.plural and self.items[-1].kind != "conjunction"
        if phrase.text in ("living areas", "living spaces") and phrase.count is None:
            phrase.plural = phrase.quantifier in PARTITIVE  # "the living areas in the south"
        self.items.append(Item("room", phrase.type, word.text, phrase, joined=word.joined and p.empty()))
        self.pending = Pending()
        return trailing_number(words, i + 1, phrase)

    def _object(self, word: Lexeme, category: str) -> None:
        if self.pending.quantifier == Det.OTHER and self.pending.texts[-1].split()[-1] in ("others", "rest"):
            self._flush(word)  # "the largest gets a double bed, the others single beds"
        if self.pending.quantifier == Det.OTHER and self.pending.number is not None and word.plural:
            self._others_with(word)
        p, self.pending = self.pending, Pending()
        if self.items and self.items[-1].kind == "negation" and self.items[-1].value == "not":
            p.negated = bool(self.items.pop())  # "with a shower and not a bathtub"
        several = word.plural or p.quantifier == Det.SEVERAL
        count = p.number if p.number is not None else 2 if several else 1
        the = p.quantifier == Det.THE and not several and p.number is None
        told = the and any(i.kind == "object" and i.value == category for i in self.items)
        form = "some" if several and p.number is None else "again" if told else ""
        self.items.append(Item("object", category, word.text, number=0 if p.negated else count, form=form))

    def _others_with(self, word: Lexeme) -> None:
        """`one has a double bed, the other two single beds`: two beds of one room, or two rooms with such beds."""
        number, last = int(self.pending.number or 0), (self.items or [Item("")])[-1]
        counted = [r for r in rooms_of(self.items) if r.type and r.type != "any" and (r.count or 1) > 1][-1:]
        if not counted or not (last.kind in ("conjunction", "boundary") or last.value in (",", ".")):
            return
        one = int(counted[0].count or 0) - 1 < number
        phrase = RoomPhrase("", quantifier=Det.OTHER, count=None if one else float(number), text="the other")
        self.items.append(Item("room", "", "the other", phrase))
        self.pending = Pending()
        if one:
            self.pending.number = float(number)
            self.pending.texts.append(str(number))

    def _other(self, word: Lexeme, following: Lexeme | None) -> None:
        """What is no modifier and no room."""
        p = self.pending
        counted = p.number is not None
        if word.kind == "furniture":
            self._object(word, word.value)
        elif word.kind == "dwelling":
            self._dwelling(word)
        elif word.kind == "main_rooms":
            self._main_rooms(word)
        elif counted and (word.kind == "furniture_count" or (word.kind == "compare" and word.number == 0)):
            kind = "objects" if word.kind == "furniture_count" else "compare"
            self.items.append(Item(kind, "", word.text, number=p.number or 0, bounds=word.bounds))
            self.pending = Pending()
        else:
            thing = word.kind == "unknown" and (p.quantifier in (Det.A, Det.THE) or self._listed(word, following))
            self._flush(word)
            self._plain(word, following)
            self.items += [Item("thing", "", word.text)] * thing

    def _main_rooms(self, word: Lexeme) -> None:  # `3-room flat`: living and sleeping rooms; `every room`: all others
        p, self.pending = self.pending, Pending()
        if p.labels & SLEEPERS and word.plural and p.number is not None and not p.negated:
            phrase = p.room(replace(word, kind="room", value="bedroom"))  # "the children's two rooms"
            self.items.append(Item("room", "bedroom", word.text, phrase))
        elif p.negated:
            self.unread.append(f"no {word.text}")
        elif (most := extreme(p.texts)) and not word.plural:
            self.items.append(Item("extreme", most, f"{p.texts[-1]} {word.text}"))
        elif p.number is not None and p.quantifier not in PARTITIVE:
            self.items.append(Item("main_rooms", "", word.text, number=p.number))
            if p.number % 1:
                self.unread.append("half room")
        elif p.quantifier in (Det.ALL, Det.EACH, Det.OTHER) or word.value == "everything":
            quantifier = p.quantifier or (Det.OTHER if any(w in word.text for w in ELSE) else Det.ALL)
            phrase = RoomPhrase("any", quantifier=quantifier, plural=True, text=word.text)
            self.items.append(Item("room", "any", word.text, phrase))

    def _dwelling(self, word: Lexeme) -> None:
        p = self.pending
        if p.area:
            self.items.append(area_item("total", p.area))
        if p.factor != 1.0:
            self.items.append(Item("flat_size", "", word.text, number=p.factor))
        self.items.append(Item("dwelling", word.value, word.text, joined=word.joined, number=p.number or 1))
        self.pending = Pending()

    def _plain(self, word: Lexeme, following: Lexeme | None) -> None:
        """A lexeme that stays as it is."""
        if word.kind == "unknown":
            self.unread.append(word.text)
        elif word.kind == "graph" and word.text == "links" and self._verb_follows(following):
            self.items.append(Item("link", "door", word.text, form="s"))
        elif word.kind == "shorthand":
            for kind, n in word.parts:
                phrase = RoomPhrase(kind, count=n or None, headline=n > 0, negated=n == 0, text=word.text)
                self.items.append(Item("room", kind, word.text, phrase))
        elif word.kind == "compound":
            self.items.append(Item("main_rooms", "", word.text, number=float(word.value)))
            self.items.append(Item("dwelling", "flat", word.text))
        elif word.kind == "stop":
            self.items += [Item("copula", COPULAS[word.text], word.text)] if word.text in COPULAS else []
        else:
            value, _, form = (word.value, "", "") if word.kind in ("compare", "mark") else word.value.partition(".")
            number = word.values[0] if word.values else 1.0
            traits = (number, word.values, word.joined, form, word.sides, word.bounds)
            self.items.append(Item(word.kind, value, word.text, None, *traits))

    def _listed(self, word: Lexeme, following: Lexeme | None) -> bool:
        """Whether an unknown noun stands in a list, with a relation behind: `…, garage next to the kitchen`."""
        begins = self.pending.empty() and bool(self.items) and self.items[-1].value == ","
        related = following is not None and following.kind == "link"
        return begins and related and not word.text.endswith(ADVERBIAL) and word.text not in PERHAPS

    def _is_done(self, word: Lexeme, before: Lexeme | None) -> bool:
        """Whether a word for a room is a verb: what somebody does."""
        if before is None or word.text not in DONE or self.pending.number is not None:
            return False
        whom = before.text.endswith("whom") and word.text == "studies"
        person = before.kind in ("unknown", "relative") or before.text in ("she", "he")
        return whom or (self.pending.empty() and (person if word.text == "studies" else before.text in MODALS))

    def _in_hall(self) -> bool:
        """`a hall with a cupboard`: large enough to be one of the rooms."""
        return [i.value for i in self.items[-2:]] == ["hallway", "with"]

    def _clause_begins(self) -> bool:
        """Whether `that hallway` names a hallway: no `that` of a relative clause."""
        last = self.items[-1] if self.items else Item("mark", ".")
        return self.pending.empty() and (last.kind in ("conjunction", "boundary", "front", "link") or last.value == ".")

    def _compares(self) -> bool:
        """Whether `like` says of a room what was said of another: `the kitchen is off the hall like the bedrooms`."""
        start = max((k + 1 for k, i in enumerate(self.items) if i.value == "."), default=0)
        clause = self.items[start:]
        return len(clause) > 2 and clause[-1].kind == "room" and clause[-2].kind in ("link", "front")

    def _verb_follows(self, following: Lexeme | None) -> bool:
        """Whether `links` has a subject and an object: `the hall links the lounge with …`."""
        return bool(self.items) and self.items[-1].kind == "room" and following is not None and following.kind != "mark"


def _of_hall(text: str) -> bool:
    """Whether a style is said of a hallway that there is to be: not so of `no long hallway`."""
    words = text.split()
    return words[-1] in HALLS and words[0] not in ("no", "without")
