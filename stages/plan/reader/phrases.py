"""Lexemes grouped into phrases: rooms with their numbers and traits, furniture, relations, marks."""

from dataclasses import dataclass, field

from stages.plan.reader.lexemes import Lexeme
from stages.plan.reader.lexicon import Lexicon

OPEN_TYPES = ("living_room", "kitchen", "dining_room")
COPULAS = ("is", "are", "be", "ist", "sind", "est", "sont", "es", "son", "lie", "lies")
MODIFIERS = ("size", "label", "ordinal", "style", "number", "area", "adjective", "unknown")
ADJECTIVES = ("adjoining", "adjacent", "connecting", "attached", "connected", "neighbouring", "neighboring")
"""Relations that describe the room after them: `an adjoining kitchen`."""
OTHER_NOUNS = ("side", "end", "level", "storey", "story", "floor", "person", "persons", "people", "students", "student", "family")
"""`one side` counts no rooms."""
PARTITIVE = ("all", "each", "both", "one_of", "other", "none")


@dataclass(eq=False)
class RoomPhrase:
    """A mention of rooms. `type` is "" for an elliptical one ("one of them") until it is resolved.

    `quantifier` is the determiner's value; `area` has one value, or one per room, in m².
    """

    type: str = ""
    labels: set[str] = field(default_factory=set)
    count: float | None = None
    quantifier: str = ""
    ordinals: tuple[int, ...] = ()
    plural: bool = False
    areas: tuple[float, ...] = ()
    share: float | None = None
    factor: float = 1.0
    negated: bool = False
    headline: bool = False
    whole: int | None = None
    together: bool = False
    another: bool = False
    subset: bool = False
    owned: list["RoomPhrase"] = field(default_factory=list)
    objects: list[tuple[str, int]] = field(default_factory=list)
    object_count: int | None = None
    object_category: str = ""
    text: str = ""

    @property
    def definite(self) -> bool:
        """Whether it speaks of rooms known already."""
        return self.quantifier in ("the", *PARTITIVE)


@dataclass(eq=False)
class Item:
    """One element of a sentence; `kind` is room, object, objects, area, share, or the kind of a lexeme."""

    kind: str
    value: str = ""
    text: str = ""
    room: RoomPhrase | None = None
    number: float = 1.0
    values: tuple[float, ...] = ()
    joined: bool = False
    form: str = ""


@dataclass
class _Pending:
    """Modifiers read, waiting for their noun."""

    quantifier: str = ""
    number: float | None = None
    ordinals: tuple[int, ...] = ()
    labels: set[str] = field(default_factory=set)
    factor: float = 1.0
    area: Lexeme | None = None
    share: float | None = None
    negated: bool = False
    texts: list[str] = field(default_factory=list)
    whole: int | None = None

    def empty(self) -> bool:
        return not self.texts


class Phraser:
    """Walks lexemes once, left to right; `items` and `unread` hold the outcome."""

    def __init__(self, lexicon: Lexicon) -> None:
        self.lexicon = lexicon
        self.items: list[Item] = []
        self.unread: list[str] = []
        self.pending = _Pending()

    def walk(self, words: list[Lexeme]) -> "Phraser":
        """Read all lexemes."""
        i = 0
        while i < len(words):
            i = self._step(words, i)
        self._flush()
        return self

    def _step(self, words: list[Lexeme], i: int) -> int:
        word = words[i]
        following = words[i + 1] if i + 1 < len(words) else None
        if word.text == "den" and following is not None and following.kind == "room":
            return i + 1  # German article
        if word.kind == "link" and word.text in ADJECTIVES and not self.pending.empty() and following is not None and following.kind == "room":
            self.pending.labels.add("adjoining")
            return i + 1
        if self._modifier(word, words, i):
            return i + 1
        if word.kind == "room" and not self._is_object(word, following):
            return self._room(words, i)
        if word.kind == "room":
            self._object(word, self.lexicon.also_object[word.text])
            return i + 1
        self._other(word, words, i)
        return i + 1

    def _modifier(self, word: Lexeme, words: list[Lexeme], i: int) -> bool:
        """Whether the lexeme was kept for the noun to come."""
        p = self.pending
        match word.kind:
            case "determiner":
                self._determiner(word)
            case "number" if p.number is None or p.ordinals:
                p.number = word.number
            case "number" if p.quantifier == "the" and "of" in p.texts:
                p.whole = int(word.number)
            case "number":
                self._flush()
                self.pending.number = word.number
                self.pending.texts.append(word.text)
                return True
            case "ordinal":
                p.ordinals += (int(word.number),)
            case "label" if _noun_ahead(words, i + 1) or word.value in ("master", "guest", "kids", "separate", "open"):
                p.labels.add(word.value)
            case "size" if _noun_ahead(words, i + 1) or p.quantifier:
                p.factor = word.number
            case "area" if _noun_ahead(words, i + 1) and not self._after_room(p):
                p.area = word
            case "compare" if word.number == -1 and _noun_ahead(words, i + 1):
                p.labels.add("equal")
            case "adjective" if not p.empty() or _noun_ahead(words, i + 1):
                pass
            case "unknown" if not p.empty() and _noun_ahead(words, i + 1):
                self.unread.append(word.text)
            case "style" if not p.empty() and _noun_ahead(words, i + 1):
                self.items.append(Item("style", word.value, word.text))
            case "stop" if word.text in ("of", "de", "von") and p.number is not None and _noun_ahead(words, i + 1 + (i + 1 < len(words) and words[i + 1].kind == "determiner")):
                p.quantifier = "the"
            case "negation" if word.value in ("no", "without"):
                self._flush()
                self.pending.negated = True
                self.items.append(Item("negation", word.value, word.text))
            case _:
                return False
        self.pending.texts.append(word.text)
        return True

    def _after_room(self, p: _Pending) -> bool:
        """An area right behind a room belongs to it: `bedroom 12 m² kitchen 8 m²`."""
        return p.empty() and bool(self.items) and self.items[-1].kind == "room"

    def _determiner(self, word: Lexeme) -> None:
        p = self.pending
        if p.quantifier in PARTITIVE and word.value in ("the", "a"):
            return
        if word.value == "own":
            p.labels.add("own")
        elif not (p.quantifier == "the" and word.value == "a"):
            p.quantifier = "other" if {p.quantifier, word.value} == {"the", "other"} else word.value

    def _is_object(self, word: Lexeme, following: Lexeme | None) -> bool:
        """`bed` and `bath` are furniture where a room is being furnished, not after "3 …" of a listing."""
        if word.text not in self.lexicon.also_object or word.joined or (following is not None and following.kind in ("dwelling", "room", "number", "shorthand")):
            return False
        if word.text == "bed" and self.pending.quantifier == "a" and self.pending.number is None:
            return True
        last = [i for i in self.items if i.kind not in ("conjunction", "mark")][-2:]
        furnishing = any(i.kind in ("object", "with") for i in last[-1:])
        return furnishing and any(i.kind in ("object", "room") for i in last) and last[0].kind != "dwelling" and self._furnishes(word, last)

    def _furnishes(self, word: Lexeme, last: list[Item]) -> bool:
        owner = next((i.room.type for i in reversed(self.items) if i.room), "")
        return {"bed": "bedroom", "beds": "bedroom"}.get(word.text, "bathroom") == owner and last[-1].kind in ("object", "with")

    def _room(self, words: list[Lexeme], i: int) -> int:
        word, p = words[i], self.pending
        kind, _, label = word.value.partition(":")
        labels = set(p.labels) | (set(label.split("+")) if label else set())
        if kind == "bathroom" and "own" in labels:
            labels.add("ensuite")
        if p.quantifier == "both" and not word.plural:
            p.quantifier = "the"  # "both the bedroom and the hallway"
        phrase = RoomPhrase(kind, labels, p.number, p.quantifier, p.ordinals, word.plural, negated=p.negated, factor=p.factor, text=word.text)
        phrase.areas = p.area.values if p.area else ()
        phrase.share = p.share
        phrase.whole = p.whole
        phrase.headline = (word.joined and p.number is not None and word.kind == "room" and not word.plural) or (kind in ("bedroom", "bathroom") and word.text in ("bed", "beds", "bath", "baths", "室", "居 室", "房") and p.number is not None)
        self.items.append(Item("room", kind, word.text, phrase, joined=word.joined and p.empty()))
        self.pending = _Pending()
        return self._trailing_number(words, i + 1, phrase)

    def _trailing_number(self, words: list[Lexeme], i: int, phrase: RoomPhrase) -> int:
        """`bedroom 2`, `bedrooms 1 and 2`."""
        numbers: list[int] = []
        j = i
        while j < len(words) and words[j].kind == "number" and words[j].number in range(1, 10) and not _counts_next(words, j):
            numbers.append(int(words[j].number))
            j += 1
            if j + 1 < len(words) and words[j].text in ("and", "&", ",") and words[j + 1].kind == "number" and phrase.plural:
                j += 1
            else:
                break
        if numbers and phrase.count is None and (words[i].text[0].isdigit() or phrase.plural) and (len(numbers) == 1 or phrase.plural):
            phrase.ordinals = tuple(numbers)
            return j
        return i

    def _object(self, word: Lexeme, category: str) -> None:
        p = self.pending
        count = 0 if p.negated else p.number if p.number is not None else 2 if word.plural or p.quantifier == "several" else 1
        self.items.append(Item("object", category, word.text, number=count))
        self.pending = _Pending()

    def _other(self, word: Lexeme, words: list[Lexeme], i: int) -> None:
        p = self.pending
        if word.kind == "furniture":
            return self._object(word, word.value)
        if word.kind == "dwelling":
            self._dwelling(word)
            return None
        if word.kind == "main_rooms":
            return self._main_rooms(word)
        if word.kind == "furniture_count" and p.number is not None:
            self.items.append(Item("objects", "", word.text, number=p.number))
            self.pending = _Pending()
            return None
        if word.kind == "compare" and p.number is not None and word.number == 0:
            self.items.append(Item("compare", str(p.number), word.text, number=p.number))
            self.pending = _Pending()
            return None
        self._flush(word)
        if word.kind == "unknown":
            self.unread.append(word.text)
            return None
        self._plain(word)
        return None

    def _main_rooms(self, word: Lexeme) -> None:
        """`3-room flat` counts living and sleeping rooms; `every room` means all others."""
        p, self.pending = self.pending, _Pending()
        if p.number is not None and p.quantifier not in PARTITIVE:
            self.items.append(Item("main_rooms", "", word.text, number=p.number))
        elif p.quantifier in ("all", "each", "other") or word.value == "everything":
            p.quantifier = p.quantifier or ("other" if "else" in word.text else "all")
            self.items.append(Item("room", "any", word.text, RoomPhrase("any", set(), None, p.quantifier, plural=True, text=word.text)))

    def _dwelling(self, word: Lexeme) -> None:
        p = self.pending
        if p.area:
            self.items.append(Item("area", "total", p.area.text, values=p.area.values))
        if p.factor != 1.0:
            self.items.append(Item("flat_size", "", word.text, number=p.factor))
        self.items.append(Item("dwelling", word.value, word.text, joined=word.joined, number=p.number or 1))
        self.pending = _Pending()

    def _plain(self, word: Lexeme) -> None:
        if word.kind == "stop":
            if word.text in COPULAS:
                self.items.append(Item("copula", "s" if word.text in ("is", "ist", "est", "es") else "p" if word.text != "be" else "", word.text))
            return
        value, _, form = word.value.partition(".")
        if word.kind == "compare":
            value, form = word.value, ""
        number = word.values[0] if word.values else 1.0
        self.items.append(Item(word.kind, value, word.text, number=number, values=word.values, joined=word.joined, form=form))
        if word.kind == "shorthand":
            self.items[-1].values = ()
            self.items[-1].value = ""
            self.items.pop()
            for kind, count in word.parts:
                phrase = RoomPhrase(kind, set(), count, headline=True, text=word.text)
                self.items.append(Item("room", kind, word.text, phrase))

    def _flush(self, following: Lexeme | None = None) -> None:
        """Modifiers without a noun: an elliptical room ("one of them", "the largest"), or a loose adjective."""
        p, self.pending = self.pending, _Pending()
        if p.empty() or (following is not None and following.text in OTHER_NOUNS):
            return
        partitive = p.quantifier in PARTITIVE or (p.number is not None and p.number <= 9) or p.ordinals or p.labels & {"master", "guest", "kids"}
        if "own" in p.labels and p.number is None:
            self.items.append(Item("room", "bathroom", "own", RoomPhrase("bathroom", {"ensuite", "own"}, text="own")))
        elif partitive and not p.negated and any(i.room and i.room.type for i in self.items):
            phrase = RoomPhrase("", set(p.labels), p.number, p.quantifier, p.ordinals, factor=p.factor, text=" ".join(p.texts))
            phrase.another = following is not None and following.kind == "with" and p.number is not None
            self.items.append(Item("room", "", phrase.text, phrase))
        elif p.quantifier == "the" and p.factor != 1.0:
            self.items.append(Item("room", "", " ".join(p.texts), RoomPhrase("", {"size"}, None, "the", factor=p.factor)))
        elif p.labels & {"open"}:
            self.items.append(Item("open", "", "open"))
        elif p.number not in (None, 1):
            self.unread.append(" ".join(p.texts))
        elif p.factor != 1.0:
            self.items.append(Item("size", "", p.texts[-1], number=p.factor))
        if p.area:
            self.items.append(Item("area", "", p.area.text, values=p.area.values))


def _noun_ahead(words: list[Lexeme], i: int) -> bool:
    """Whether a room or dwelling follows after modifiers only."""
    start = i
    while i < len(words) and i < start + 5 and words[i].kind in MODIFIERS:
        i += 1
    return i < len(words) and words[i].kind in ("room", "dwelling", "shorthand")


def _counts_next(words: list[Lexeme], j: int) -> bool:
    """Whether the number belongs to what follows it."""
    k = j + 1
    return _noun_ahead(words, k) or (k < len(words) and (words[k].kind in ("unit", "furniture", "furniture_count", "main_rooms") or words[k].text in ("%", "x")))
