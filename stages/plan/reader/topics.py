"""Which room each clause of a description speaks of, and what it says of it."""

from collections.abc import Set
from dataclasses import dataclass, field

from apartgen.stages.plan.reader.compass import HANDS, OF_ANOTHER, SIDES, place, points
from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.names import Name, Part
from apartgen.stages.plan.reader.vocabulary import Relation

VERBS = frozenset(
    "is are was are's at located locate situated placed positioned sits lies has occupies takes extends measures "
    "location borders connects can stands spans covers shares runs on in near next between".split()
)
"""What follows the room that a clause begins with."""
LINKS = {"near": Relation.NEAR, "between": Relation.NEAR, "share": Relation.NEAR, "door": Relation.DOOR,
         "only": Relation.ONLY, "open": Relation.DOOR, "own": Relation.DOOR}  # fmt: skip
NEAR = frozenset("nearby beside adjacent adjoining borders bordering touches touching neighbors neighbours".split())
INTRODUCED = (("location", "of"), ("direction", "of"), ("position", "of"), ("there", "is"), ("there", "are"))
"""Words between which and their clause no room stands."""
ARTICLES = frozenset("the a an its it's their this".split())
WHOLE = frozenset("house home floor plan floorplan building flat apartment structure diagram unit map".split())


@dataclass
class Topic:
    """What is said of one room: its size, its places, what lies to which side of what, neighbours and doors."""

    name: Name
    area: Lexeme | None = None
    places: list[str] = field(default_factory=list)
    beside: list[tuple[Name, str, Name]] = field(default_factory=list)
    links: list[tuple[Relation, Name]] = field(default_factory=list)

    def placed(self) -> bool:
        """Whether anything was said of where it lies."""
        return bool(self.places or self.beside or any(relation == Relation.NEAR for relation, _ in self.links))


class Reading:
    """Walks the parts of a text once; `topics` hold what it says."""

    def __init__(self, parts: list[Part]) -> None:
        self.parts = parts
        self.topics: dict[Name, Topic] = {}
        self.topic: Topic | None = None
        self.unread: list[str] = []
        self._link: Relation | None = None
        self._done = 0
        for k in range(len(parts)):
            self._step(k)

    def _step(self, k: int) -> None:
        part = self.parts[k]
        if k < self._done:
            return
        if part.name is not None:
            self._named(k, part.name)
        elif part.lexeme.kind == "mark" and part.text != ",":
            self._link = None
        elif part.lexeme.kind == "area":
            self._link = None
            if not self._heads(k + 1):
                self._sized(part.lexeme)
        elif end := self._run(k):
            self._done = end
            self._placed(k, end)
        elif part.lexeme.kind == "link" or part.text in NEAR:
            self._link = LINKS.get(part.lexeme.value.partition(".")[0], Relation.NEAR if part.text in NEAR else None)
        elif part.lexeme.kind == "unknown":
            self.unread.append(part.text)

    def _named(self, k: int, name: Name) -> None:
        if self._begins(k) and not self._seen_from_topic(k):
            self.topic = self.topics.setdefault(name, Topic(name))
            self._link = None
            if self._heads(k):
                self._sized(self.parts[k - 1].lexeme)
        elif self.topic is not None and self._text(k - 1) in ("a", "an") and self._text(k - 2) == "has":
            self._has(k, name)
        elif self.topic is not None and self._link is not None and name != self.topic.name:
            self.topic.links.append((self._link, name))

    def _has(self, k: int, name: Name) -> None:
        """`the living room has a bathroom on its east side. It is …`: the second room is spoken of from there on."""
        end = next((e for j in range(k + 1, k + 4) if (e := self._run(j))), 0)
        if not end or self.topic is None:
            return
        value = place({p for part in self.parts[k:end] for p in points(part.text)})
        owner, self.topic = self.topic.name, self.topics.setdefault(name, Topic(name))
        self.topic.beside += [(name, value, owner)] if value else []
        self._done = end

    def _heads(self, k: int) -> bool:
        """`the 11 x 5 bathroom`: a size before the room at `k`."""
        return self._is_name(k) and self._kind(k - 1) == "area" and self._text(k - 2) in ARTICLES

    def _begins(self, k: int) -> bool:
        """Whether a clause begins with the room at `k`."""
        j = k - 2 if self._heads(k) else k - 1
        while j >= 0 and (self.parts[j].text in ARTICLES or self.parts[j].lexeme.kind == "adjective"):
            j -= 1
        if (self._text(j - 1), self._text(j)) in INTRODUCED:
            return True
        before = self.parts[j] if j >= 0 else None
        after = self._text(k + 1)
        verb = after in VERBS or self._run(k + 1) > k or self.parts[k + 1 : k + 2] and self._kind(k + 1) == "area"
        if before is None or (before.lexeme.kind == "mark" and before.text != ","):
            return True
        comma = before.text == "," and self._link is None
        return (
            bool(verb)
            and (comma or before.lexeme.kind == "area" or after in ("is", "located"))
            and (before.text not in ("of", "to", "between", "and", "with", "from", "by", "near", "next"))
        )

    def _seen_from_topic(self, k: int) -> bool:
        """`the kitchen is to the north`: seen from the room spoken of."""
        if self.topic is None or self.parts[k].name == self.topic.name:
            return False
        j = k + 1
        while self._text(j) in ("is", "are", "lies", "directly", "also", "and", *ARTICLES) or self._is_name(j):
            j += 1
        if self._text(j) != "to":
            return False
        while self._text(j + 1) in ARTICLES:
            j += 1
        end = self._run(j + 1)
        return bool(end) and self._text(end) != "of" and self._text(end - 1) not in SIDES

    def _sized(self, area: Lexeme) -> None:
        if self.topic is None:
            self.unread.append(area.text)
        elif self.topic.area is None or (area.sides and not self.topic.area.sides):
            self.topic.area = area

    def _run(self, k: int) -> int:
        """Where the words for a place that begin at `k` end, 0 where none do."""
        j = end = k
        hands = True
        while j < len(self.parts) and self.parts[j].name is None:
            text = self.parts[j].text
            if points(text):
                if end > k and (text in OF_ANOTHER or self._text(j - 1) in SIDES and self._of_another(j)):
                    break
                hands = hands and text in HANDS
                end = j + 1
            elif text not in ("and", "-", "most", "far", "of", "the", *SIDES) or end == k:
                break
            elif text == "of" and not (self._text(j + 1) == "the" and points(self._text(j + 2))):
                break
            j += 1
        while end > k and self._text(end) in SIDES:
            end += 1
        if end == k:
            return 0
        told = self._text(end) == "of" or self._text(end - 1) in SIDES
        return end if told or not hands or self._text(k - 1) in (*ARTICLES, "to", "on", "in") else 0

    def _placed(self, start: int, end: int) -> None:
        """The place said from `start` to `end`: of the topic in the home, or seen from another room."""
        texts = [self.parts[j].text for j in range(start, end)]
        whole = place({point for text in texts for point in points(text)})
        first = next(place(set(points(text))) for text in texts if points(text))
        home = self._of_home(end)
        to = self._run(end + 1) if self._text(end) == "to" else 0
        if to:  # "at north west to east direction"
            whole = _spanned(whole, {point for j in range(end + 1, to) for point in points(self.parts[j].text)})
            self._done = end if whole else to
        if home and whole and (found := self._behind(home)):
            self.topic = self.topics.setdefault(found[0], Topic(found[0]))
            self.topic.places.append(whole)
        if self.topic is None or not whole or self._done > end:
            return
        mine = self.topic.name
        seen = first if "and" in texts else whole
        of = (self._it(end) or self._behind(end)) if self._text(end) in ("of", "from") else None
        verb = self._of_home(end, {"room", "it", "this"}) or end
        there = self._behind(verb) if self._text(verb) in ("is", "are", "lies") else None
        if of is not None:
            self._link = None
            self.topic.beside += [(mine, seen, name) for name in of]
            return
        if self._all_others(start):
            return
        others = there or self._ahead(start)
        if others:
            self.topic.beside += [(name, seen, mine) for name in others if name != mine]
            if self.topic.links and self.topic.links[-1][1] in others:
                self.topic.links.pop()
        else:
            self.topic.places.append(whole)
            self._done = max(self._done, to)

    def _it(self, end: int) -> list[Name] | None:
        """`the lounge in the corner; the kitchen north of it`: the room spoken of before."""
        before = [name for name in self.topics if self.topic is None or name != self.topic.name]
        return before[-1:] if self._text(end + 1) == "it" and before else None

    def _of_home(self, end: int, whole: Set[str] = WHOLE) -> int:
        """Where the verb of `the north corner of the house has` stands, 0 where none does."""
        j = end + 1 if self._text(end) == "of" else end
        while self._text(j) in ARTICLES:
            j += 1
        clause = j > end + 1 and self._text(j) in whole and self._text(j + 1) in ("has", "is", "contains")
        return j + 1 if clause else 0

    def _behind(self, j: int) -> list[Name] | None:
        """The rooms that follow a verb or a preposition at `j`; None where something else does."""
        out: list[Name] = []
        j += 1
        while j < len(self.parts):
            part = self.parts[j]
            if part.name is not None:
                out.append(part.name)
            elif part.text not in ARTICLES and not (out and part.text in ("and", "&")):
                break
            j += 1
        self._done = j if out else self._done
        return out or None

    def _ahead(self, start: int) -> list[Name]:
        """The rooms of `with the kitchen and the bath to the south`, before the place at `start`."""
        j = start - 1
        while j >= 0 and self.parts[j].text in (*ARTICLES, "to", "on", "in", "at", "is", "are", "directly"):
            j -= 1
        out: list[Name] = []
        to = any(self.parts[i].text in ("to", "on", "in") for i in range(j + 1, start))
        while j >= 0 and (self.parts[j].name is not None or (out and self.parts[j].text in (*ARTICLES, "and", "&"))):
            name = self.parts[j].name
            out += [name] if name is not None else []
            j -= 1
        mine = self.topic is not None and self.topic.name in out
        return [] if mine or not to else out

    def _all_others(self, start: int) -> bool:
        """`adjacent to all rooms to the east`: no place of the room spoken of."""
        j = start - 1
        while self._text(j) in (*ARTICLES, "to", "on", "in", "at"):
            j -= 1
        return j < start - 1 and self._text(j) in ("rooms", "others", "everything")

    def _of_another(self, k: int) -> bool:
        """The `right side of the bedroom` behind `south east corner`."""
        there = k + 4 if self._text(k + 3) in ARTICLES else k + 3
        return self._text(k) in HANDS and self._text(k + 2) == "of" and self._is_name(there)

    def _is_name(self, k: int) -> bool:
        return k < len(self.parts) and self.parts[k].name is not None

    def _text(self, k: int) -> str:
        return self.parts[k].text if 0 <= k < len(self.parts) else ""

    def _kind(self, k: int) -> str:
        return self.parts[k].lexeme.kind if 0 <= k < len(self.parts) else ""


def _spanned(one: str, other: set[str]) -> str:
    """Where a room lies that reaches from a place to another: at the sides that are not opposite."""
    mine = {point for word in one.split("_") for point in points(word)}
    for a, b in ("NS", "EW"):
        if {a, b} <= mine | other:
            mine -= {a, b}
    return place(mine) if mine else ""
