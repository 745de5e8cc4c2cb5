"""What stands before a noun and waits for it: determiners, numbers, sizes, traits."""

from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import PARTITIVE, Item
from apartgen.stages.plan.reader.particles import OTHER_NOUNS
from apartgen.stages.plan.reader.pending import Pending, area_item, noun_ahead
from apartgen.stages.plan.reader.vocabulary import Det, Trait

LABELS = ("master", "guest", "kids", "relative", "separate", "open")
"""Labels that may stand without a noun: `the kids`, `one for the parents`."""


class Modifiers:
    """Keeps modifiers until their noun comes; `items` and `unread` hold what was read before."""

    def __init__(self) -> None:
        self.items: list[Item] = []
        self.unread: list[str] = []
        self.pending = Pending()

    def _modifier(self, word: Lexeme, words: list[Lexeme], i: int) -> bool:
        """Whether the lexeme was kept for the noun to come."""
        p = self.pending
        match word.kind:
            case "determiner":
                self._determiner(word)
            case "number" if p.number is None or p.ordinals:
                p.number = word.number
            case "number" if p.quantifier == Det.THE and "of" in p.texts:
                p.whole = int(word.number)
            case "number":
                self._flush()
                self.pending.number = word.number
                self.pending.texts.append(word.text)
                return True
            case "ordinal":
                p.ordinals += (int(word.number),)
            case "label" if noun_ahead(words, i + 1) or word.value in LABELS:
                p.labels.add(Trait(word.value))
            case "size" if noun_ahead(words, i + 1) or p.quantifier:
                p.factor = word.number
            case "area" if noun_ahead(words, i + 1) and not self._after_room(p):
                p.area = word
            case "compare" if word.number == -1 and noun_ahead(words, i + 1):
                p.labels.add(Trait.EQUAL)
            case "adjective" if not p.empty() or noun_ahead(words, i + 1):
                pass
            case "unknown" if not p.empty() and noun_ahead(words, i + 1):
                self.unread.append(word.text)
                p.labels |= {Trait.PLACED} if p.negated else set()  # "no internal bathrooms"
            case "style" | "side" if not p.empty() and noun_ahead(words, i + 1):
                self.items.append(Item(word.kind, word.value, word.text))
            case "stop" if (
                word.text in ("of", "de", "von")
                and p.number is not None
                and noun_ahead(words, i + 1 + (i + 1 < len(words) and words[i + 1].kind == "determiner"))
            ):
                p.quantifier = Det.THE
            case "stop" if p.negated and word.text == "any":
                pass  # "we don't want any hallway"
            case "negation" if word.value in ("no", "without"):
                self._flush()
                self.pending.negated = True
                self.items.append(Item("negation", word.value, word.text))
            case _:
                return False
        self.pending.texts.append(word.text)
        return True

    def _after_room(self, p: Pending) -> bool:
        """An area right behind a room belongs to it: `bedroom 12 m² kitchen 8 m²`."""
        return p.empty() and bool(self.items) and self.items[-1].kind == "room"

    def _determiner(self, word: Lexeme) -> None:
        told = self.pending.quantifier == Det.THE and self.pending.factor != 1.0
        told = told or self.pending.texts == ["one"]
        if word.value == "a" and (self.pending.quantifier == Det.OTHER or self.pending.ordinals or told):
            self._flush(word)  # "the other a balcony", "the largest a balcony", "one a balcony"
        p = self.pending
        if p.quantifier in PARTITIVE and word.value in ("the", "a"):
            return
        if word.value == "own":
            p.labels.add(Trait.OWN)
        elif not (p.quantifier == Det.THE and word.value == "a"):
            p.quantifier = Det.OTHER if {p.quantifier, word.value} == {Det.THE, Det.OTHER} else Det(word.value)

    def _flush(self, following: Lexeme | None = None) -> None:
        """Modifiers without a noun: an elliptical room ("one of them", "the largest"), or a loose adjective."""
        p, self.pending = self.pending, Pending()
        if p.empty() or (following is not None and following.text in OTHER_NOUNS):
            return
        text = " ".join(p.texts)
        if p.number is not None and following is not None and following.kind == "unit":
            self.unread.append(f"{text} {following.text}")
            return
        known = any(i.room and i.room.type for i in self.items)
        phrase = p.elliptical(known, following)
        phrase = p.snug() if phrase is None else phrase
        if phrase is not None:
            self.items.append(Item("room", phrase.type, text, phrase))
        elif Trait.OPEN in p.labels:
            self.items.append(Item("open", "", text))
        elif p.number not in (None, 1):
            self.unread.append(text)
        elif p.factor != 1.0:
            self.items.append(Item("size", "", p.texts[-1], number=p.factor))
        elif p.labels == {Trait.SEPARATE}:
            self.items.append(Item("label", Trait.SEPARATE, text))
        elif p.labels or p.ordinals:
            self.unread.append(text)
        if p.area:
            self.items.append(area_item("", p.area))
