"""Modifiers waiting for their noun, and how far ahead a noun stands."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import PARTITIVE, Item, RoomPhrase
from apartgen.stages.plan.reader.ranked import rank
from apartgen.stages.plan.reader.vocabulary import Det, Trait

MODIFIERS = ("side", "size", "label", "ordinal", "style", "number", "area", "adjective", "unknown")
EXACT = {"1", "one", "single", "sole", "only one", "just one"}
"""Words for one that are no article."""
COMPARED = {"larger", "bigger", "smaller"}
LISTED = ("bed", "beds", "bath", "baths", "室", "居 室", "房", "卫")
"""Words of listings, whose numbers are totals."""


@dataclass
class Pending:
    """Modifiers read, waiting for their noun."""

    quantifier: Det = Det.BARE
    number: float | None = None
    ordinals: tuple[int, ...] = ()
    labels: set[Trait] = field(default_factory=set)
    factor: float = 1.0
    area: Lexeme | None = None
    negated: bool = False
    texts: list[str] = field(default_factory=list)
    whole: int | None = None

    def empty(self) -> bool:
        """Whether nothing is waiting."""
        return not self.texts

    def room(self, word: Lexeme) -> RoomPhrase:
        """The phrase these modifiers make with their noun."""
        kind, _, label = word.value.partition(":")
        phrase = RoomPhrase(
            kind, self.labels | {Trait(name) for name in label.split("+") if name}, self.number, self.quantifier
        )
        phrase.ordinals, phrase.plural, phrase.text = self.ordinals, word.plural, word.text
        phrase.negated, phrase.factor, phrase.whole = self.negated or self.number == 0, self.factor, self.whole
        phrase.count = self.number or None
        phrase.rank = rank(self.quantifier, self.factor, word.plural)
        if phrase.rank and COMPARED & set(self.texts) and kind in ("bedroom", "bathroom"):
            phrase.whole = max(phrase.whole or 0, 2)  # "the larger bedroom" is one of two
        if self.area:
            phrase.areas, phrase.sides, phrase.bounds = self.area.values, self.area.sides, self.area.bounds
        phrase.exact = self.number == 1 and bool(EXACT & set(self.texts))
        if kind == "bathroom" and Trait.OWN in phrase.labels:
            phrase.labels.add(Trait.ENSUITE)
        ensuite = Trait.ENSUITE in phrase.labels  # "two bedrooms, both en suite"
        if phrase.quantifier == Det.BOTH and _both(self.texts) and not word.plural and not ensuite:
            phrase.quantifier = Det.THE  # "both the bedroom and the hallway"
        counted = (word.joined and not word.plural) or (kind in ("bedroom", "bathroom") and word.text in LISTED)
        phrase.headline = counted and self.number is not None
        return phrase

    def snug(self) -> RoomPhrase | None:
        """`a snug`: a small room to sit in."""
        if self.texts[-1] != "snug" or not self.quantifier:
            return None
        return RoomPhrase("living_room", {Trait.SMALL}, quantifier=self.quantifier, factor=self.factor, text="snug")

    def elliptical(self, known: bool, following: Lexeme | None) -> RoomPhrase | None:
        """A room without a noun, `known` when one was named before: `one of them`, `the largest`, `its own`."""
        if Trait.OWN in self.labels and self.number is None:
            if following is not None and following.kind in ("side_role", "unknown", "number"):
                return None  # "with its own entrance"
            return RoomPhrase("bathroom", {Trait.ENSUITE, Trait.OWN}, text="own")
        few = self.number is not None and self.number <= 9 and self.number % 1 == 0
        one = self.quantifier in (*PARTITIVE, Det.ANOTHER) or bool(self.ordinals)
        if self.quantifier == Det.EACH and self.number == 1:
            self.number = None  # "two bedrooms, each one with a bath": each
        named = one or few or self.labels & {Trait.MASTER, Trait.GUEST, Trait.KIDS, Trait.RELATIVE}
        if named and known and not self.negated:
            phrase = RoomPhrase("", set(self.labels), self.number, self.quantifier, self.ordinals, factor=self.factor)
            phrase.another = following is not None and following.kind == "with" and self.number is not None
            phrase.text = " ".join(self.texts)
            phrase.rank = rank(self.quantifier, self.factor)
            return phrase
        sized = self.quantifier == Det.THE and self.factor != 1.0
        which = rank(self.quantifier, self.factor)
        return RoomPhrase("", {Trait.SIZED}, None, Det.THE, factor=self.factor, rank=which) if sized else None


def _both(texts: list[str]) -> bool:
    return any(t.split()[0] == "both" for t in texts)


def area_item(value: str, area: Lexeme) -> Item:
    """An area as it stands in a sentence; `value` is `total` for that of the flat."""
    return Item("area", value, area.text, values=area.values, sides=area.sides, bounds=area.bounds)


def noun_ahead(words: list[Lexeme], i: int) -> bool:
    """Whether a room or dwelling follows after modifiers only."""
    start = i
    while i < len(words) and i < start + 5 and words[i].kind in MODIFIERS:
        i += 1
    return i < len(words) and words[i].kind in ("room", "dwelling", "shorthand")


def counts_next(words: list[Lexeme], j: int) -> bool:
    """Whether the number belongs to what follows it."""
    k = j + 1
    if words[j - 1].text == "bedroom" and k < len(words) and words[k].value == "bathroom:ensuite":
        return False  # "bedroom 2 en-suite"
    return noun_ahead(words, k) or (
        k < len(words)
        and (words[k].kind in ("unit", "furniture", "furniture_count", "main_rooms") or words[k].text in ("%", "x"))
    )


def trailing_number(words: list[Lexeme], i: int, phrase: RoomPhrase) -> int:
    """`bedroom 2`, `bedrooms 1 and 2`: sets the ordinals, returns where reading goes on. `kitchen 9` is an area."""
    if i < len(words) and _bare_area(words, i, phrase):
        phrase.areas = (words[i].number,)
        return i + 1
    if i < len(words) and _each_of(words, i, phrase):
        phrase.areas = (words[i].number,)
        return i + 1
    if _lettered(words, i, phrase):
        phrase.ordinals = ("abcd".index(words[i].text) + 1,)
        return i + 1
    areas = tuple(w.number for w in words[i : _areas_end(words, i)] if w.kind == "number")
    if phrase.plural and len(areas) > 1 and phrase.count in (None, len(areas)):
        phrase.areas = areas
        return _areas_end(words, i)
    numbers: list[int] = []
    j = i
    while j < len(words) and _is_ordinal(words, j):
        numbers.append(int(words[j].number))
        j += 1
        if not (j + 1 < len(words) and _is_ordinal(words, j + 1) and _goes_on(phrase, words[j], words[j + 1])):
            break
        j += 1
    spelled = phrase.type in ("bedroom", "bathroom") and not phrase.quantifier and phrase.text not in LISTED
    fits = bool(numbers) and (phrase.plural or words[i].text[0].isdigit() or (len(numbers) == 1 and spelled))
    if phrase.count is not None or not fits:
        return i
    if phrase.plural and len(numbers) == 1 and phrase.quantifier == Det.BARE:
        phrase.count = float(numbers[0])  # "bedrooms 3, bath 2"
        return j
    phrase.ordinals, phrase.plural = tuple(numbers), phrase.plural or len(numbers) > 1
    area = j < len(words) and words[j].kind == "number" and words[j].text[0].isdigit() and 3 < words[j].number <= 200
    if area and len(numbers) == 1 and not counts_next(words, j):  # "bedroom 1 14, bedroom 2 11"
        phrase.areas = (words[j].number,)
        return j + 1
    return j


def _goes_on(phrase: RoomPhrase, joint: Lexeme, following: Lexeme) -> bool:
    """Whether `joint` leads to the number of a further room: `bedrooms 1, 2`, `bedroom 2 and 3`."""
    alike = phrase.type in ("bedroom", "bathroom") and following.text[0].isdigit()
    return joint.text in (("and", "&", ",") if phrase.plural else ("and", "&") if alike else ())


def _areas_end(words: list[Lexeme], i: int) -> int:
    """Where the areas of `bedrooms 15 and 12` end; i where no such numbers stand here."""
    j = i
    while j < len(words) and words[j].kind == "number" and 6 < words[j].number <= 60 and not counts_next(words, j):
        j += 1
        if j + 1 < len(words) and words[j].text in ("and", "&", ",", "/") and words[j + 1].kind == "number":
            j += 1
    return j if j > i + 1 and words[j - 1].kind == "number" else i


def _bare_area(words: list[Lexeme], i: int, phrase: RoomPhrase) -> bool:
    """Whether a number without unit is too great to tell rooms apart."""
    plain = words[i].kind == "number" and not phrase.plural and phrase.count is None and not phrase.areas
    if not plain:
        return False
    counts_up = phrase.type in ("bedroom", "bathroom") and not (words[i].number > 3 and _areas_said(words, i))
    if _one_of(words, i):
        return False
    small = phrase.type not in ("bedroom", "bathroom") or Trait.HALF in phrase.labels
    most = 2.5 if words[i].number % 1 else 1 if small and _all_areas(words) else 6 if counts_up else 3
    return words[i].text[0].isdigit() and most < words[i].number <= 200 and not counts_next(words, i)


def _each_of(words: list[Lexeme], i: int, phrase: RoomPhrase) -> bool:
    """Whether the number is the area of each of several: `kitchen 8, 2 bedrooms 12, bath 4`."""
    digits = words[i].kind == "number" and words[i].text[0].isdigit() and 6 < words[i].number <= 60
    several = (phrase.count or 1) > 1 and not phrase.areas
    return digits and several and not counts_next(words, i) and _areas_said(words, i)


def _all_areas(words: list[Lexeme]) -> bool:
    """Whether numbers behind rooms are areas, so that none of them counts: `living 25, kitchen 10, storage 2`."""
    told = [(a, b.number) for a, b in zip(words, words[1:], strict=False) if a.kind == "room" and b.kind == "number"]
    counts = any(n <= 3 and (a.plural or a.value in ("bedroom", "bathroom")) for a, n in told)
    return sum(n > 6 for _, n in told) > 1 and not counts


def _one_of(words: list[Lexeme], i: int) -> bool:
    """Whether so many rooms of the type were counted that the number tells one of them: `5 bedrooms … bedroom 5`."""
    kind = words[i - 1].value
    counts = [a.number for a, b in zip(words[:i], words[1:i], strict=False) if a.kind == "number" and b.value == kind]
    return words[i].number % 1 == 0 and any(words[i].number <= count for count in counts)


def _areas_said(words: list[Lexeme], i: int) -> bool:
    """Whether numbers behind other rooms are areas, and none counts this type up to here: `kitchen 12, bathroom 6`."""
    before = [w for a, w in zip(words, words[1:], strict=False) if a.text == words[i - 1].text and w.kind == "number"]
    last = [w for w in before if w is not words[i] and w.number == words[i].number - 1]
    areas = [b for a, b in zip(words[:i], words[1:i], strict=False) if a.kind == "room" and b.kind == "number"]
    said = any(w.kind == "area" for w in words[:i])
    return not last and (said or any(w.number > 6 for w in areas))


def _lettered(words: list[Lexeme], i: int, phrase: RoomPhrase) -> bool:
    """`bedroom A, bedroom B`; an article stands before its noun."""
    if i >= len(words) or words[i].text not in ("a", "b", "c", "d") or phrase.plural or phrase.count is not None:
        return False
    following = words[i + 1].kind if i + 1 < len(words) else "mark"
    return following in ("mark", "conjunction", "link", "with", "area")


def _is_ordinal(words: list[Lexeme], j: int) -> bool:
    return words[j].kind == "number" and words[j].number in range(1, 10) and not counts_next(words, j)
