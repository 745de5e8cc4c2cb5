"""Who works at home: `two people who work from home`, `wir arbeiten beide im Homeoffice`, `我们都在家办公`.

What says so is taken out of the text; a desk for each is given a place when the rooms are known (`desks.py`).
"""

import re
from dataclasses import dataclass, replace

from apartgen.stages.plan.reader.about import People, about, numbers
from apartgen.stages.plan.reader.home_words import (
    APART,
    APIECE,
    BOTH,
    FOR_SOMEBODY,
    FOR_TWO,
    LISTED_ON,
    MANY,
    PLURAL,
    POSSIBLE,
    SO_MANY,
    STUDIES,
    STUDY_EACH,
    THERE,
    VALUED,
    WHERE,
    WORKER,
    Language,
    data,
    language,
)
from apartgen.stages.plan.reader.tokens import fold
from apartgen.stages.plan.reader.workers import Working

LOOKED_AT = 200
"""Characters before the verb that may say who works."""
WE = ("we", "wir", "nous", "我们")
FOR = ("for", "fur", "pour", "para")
STOPS = (".", "!", "?", "\n", "。")
Sides = tuple[str, str]
"""What stands before a clause that is taken out, and what behind it."""


@dataclass(frozen=True)
class Clause:
    """A verb with what stands about it; `left` ends with who works, or with the `who` that speaks of them."""

    left: str
    verb: str
    said: str
    right: str
    who: re.Match[str] | None = None
    rel: re.Match[str] | None = None

    @property
    def before(self) -> str:
        """What stands before who works."""
        last = self.who or self.rel
        return self.left if last is None else self.left[: len(self.left) - len(last.group())]


def working_at_home(prompt: str) -> tuple[Working, str]:
    """Who works at home by a prompt; the prompt folded without what says so, or as it is where nothing does."""
    folded = fold(prompt)
    working, text = at_home(folded)
    if text == folded:
        return working, prompt
    working.found = True
    text = FOR_TWO.sub(r"\g<0> people", text)
    if working.count > 1:
        text = STUDY_EACH.sub(f"we need {working.count} studies", APIECE.sub(f"{working.count} desks", text))
    return working, text


def at_home(text: str) -> tuple[Working, str]:
    """Who works at home by a folded text, and the text without the words that say it."""
    working = Working()
    for name, rows in data().items():
        if any(stem in text for stem in rows["stems"]):
            text = _Reading(language(name), working).of(text)
    return working, text


class _Reading:
    """One language's clauses of a text, one after another."""

    def __init__(self, said: Language, working: Working) -> None:
        self.said, self.working = said, working

    def of(self, text: str) -> str:
        """The text without them; those who work are counted."""
        at = 0
        while (found := self.said.core.search(text, at)) is not None:
            sides = self._without(text[: found.start()], found.group(), text[found.end() :])
            text, at = (text, found.end()) if sides is None else ("".join(sides), len(sides[0]))
        return text

    def _without(self, left: str, verb: str, right: str) -> Sides | None:
        """The text on both sides of what says who works; None where nobody does by it."""
        said = self.said
        if said.away.search(left[-LOOKED_AT:]) or said.staff.search(left[-LOOKED_AT:]):
            return None
        if (noun := WORKER.search(verb)) is not None:
            return self._workers(left, noun, right)
        left, filled = _parted(said.fill, left)
        left, denied = _parted(said.denied, left)
        left, more = _parted(said.fill, left)
        left = POSSIBLE.sub("", left)
        who = said.who.search(left[-LOOKED_AT:])
        rel = None if who else said.rel.search(left[-LOOKED_AT:])
        one = Clause(left, verb, more + filled + verb, right[said.often.match(right).end() :], who, rel)  # type: ignore[union-attr]
        if said.staff.search(one.left[-LOOKED_AT:]) or said.staff.search(one.before[-LOOKED_AT:]):
            return None
        if (valued := VALUED.match(one.right)) is not None:
            both = " both" if valued["who"] and re.search("us|both", valued["who"]) else ""
            one = replace(one, said=one.said + both, right=one.right[valued.end() :])
        self.working.speaking = self.working.speaking or who is not None
        if not (denied or said.denied_inside.search(one.said) or (who is not None and who["none"])):
            one = self._counted(one)
        return self._cut(one)

    def _workers(self, left: str, noun: re.Match[str], right: str) -> Sides:
        """`two remote workers`, `a remote developer`: people who need no verb."""
        many = MANY.search(left)
        couple = re.match(r"(?:[a-z]+ )?(?:couple|parents|famil)", right)
        several = noun["s"] == "s" or re.match(r"(?:[a-z]+ )*?[a-z]+(?<!s)s\b", right) is not None
        self.working.words = self.working.words or noun.group().strip()
        self.working.add(2 if couple else numbers().get(many[1], 2) if many and several else 2 if several else 1)
        return left, ("" if noun["adjective"] else "people" if several else "person") + right

    def _counted(self, one: Clause) -> Clause:
        """Counts those who work; returns the clause without who else does and without numbers that are read."""
        said, working = self.said, self.working
        working.words = working.words or one.verb.strip(" ,")
        who = one.who or said.who_inside.search(said.place.sub("", one.verb))
        both = BOTH.search(one.said) is not None
        if who is not None:
            self._named(who, both, one.said)
        elif both:
            working.add(2)
        else:
            working.add(2 if SO_MANY.match(one.right) else self._antecedent(one))
        if (more := said.more.match(one.right)) is not None:
            working.add(2)
        rest = more or said.rest.match(one.right)
        one = one if rest is None else replace(one, right=one.right[rest.end() :])
        if one.who is not None:
            return one
        return replace(one, left=self._uncounted(one.before) + one.left[len(one.before) :])

    def _named(self, found: re.Match[str], both: bool, said: str) -> None:
        """Those who are the subject of the verb."""
        who = found.group().strip(" ,，")
        pair = not self.said.latin and found["two"] and not who.startswith(("我们", "父母", "爸妈"))
        self.working.people = about(who)[0].people or (People(pairs=1) if pair else self.working.people)
        if found["many"]:
            self.working.add(_number(who))
        elif found["all"] or (who in WE and not both):
            self.working.everybody = True
            self.working.add(2)
        else:
            plural = re.fullmatch(r"(?:my|our|the|their) [a-z]+s", who) and re.search(r"\bwork\b", said)
            self.working.add(2 if both or found["two"] or plural else 1, re.sub(r"^(?:only|just) ", "", who))

    def _antecedent(self, one: Clause) -> int:
        """How many they are of whom a clause without a subject is said."""
        plain = one.before if one.rel is not None else self.said.suited.sub("", one.before)
        plain = plain[-LOOKED_AT:]
        if self.said.couple.search(plain):
            return 2
        if re.search(r"\bworks\b", one.said):
            return 1
        if (counted := self.said.persons.search(plain)) is not None:
            return numbers().get(counted["n"]) or int(counted["n"])
        joined = one.rel is not None and one.rel.group().strip(" ,") == "and"
        ours = joined and re.search(r"\b(?:we|they|us)\b", re.split(r"[.;!?\n]", plain)[-1])
        return 2 if ours or PLURAL.search(plain) else 1

    def _uncounted(self, left: str) -> str:
        """`for two programmers` without the number, which is that of desks; `for two people` is known."""
        counted = self.said.persons.search(left)
        many = 0 if counted is None else numbers().get(counted["n"], 0)
        known = counted is not None and any(about(f"{to} {counted.group().strip(' ,')}")[0].people for to in FOR)
        if counted is None or known or many == 1:
            return left
        return left[: counted.start()] + left[counted.end("n") :].lstrip()

    def _cut(self, one: Clause) -> Sides:
        """The two sides of what is taken out, joined as sentences are."""
        said, left, right = self.said, one.before, one.right
        keeps = said.keep.match(right)
        if one.rel is not None:
            who = one.rel.group().strip(" ,")
            return (f"{left} {who} ", right[keeps.end() :]) if keeps and who != "and" else (left, right)
        if one.who is None:
            return self._bare(left, right)
        if FOR_SOMEBODY.search(left):
            return one.left.rstrip(" ,"), right
        lead = said.lead.search(left)
        before = left[: lead.start()] if lead else left
        if (apart := APART.match(right)) is not None:
            return _joined(before, f"a desk in {apart['a']} and a desk in {apart['b']}{right[apart.end() :]}")
        if (there := THERE.match(right)) is not None:
            return _joined(before, f"{self._desks} {there['in']}{right[there.end() :]}")
        where = f"{before.rstrip(' ,')} {lead.group().strip() if lead else ''}"
        if (room := WHERE.search(where)) is not None:
            return before.rstrip(" ,") + ("" if STUDIES.search(room["kind"]) else " with a desk"), right
        if not where.endswith(" ") and (spot := said.spot.search(where)) is not None:
            return self._spot(where, spot, right)
        if keeps is not None:
            return f"{left}{one.who.group().strip(' ,')} ", right[keeps.end() :]
        so = said.so.match(right)
        return _joined(before, right[so.end() :] if so else right)

    def _bare(self, left: str, right: str) -> Sides:
        """`a place to work from home`, `a flat for working from home`, `couple, work from home`."""
        for text in (left, re.sub(r" (?:to|for|where|zum|fur|pour|para) *$", " ", left)):
            if (spot := self.said.spot.search(text)) is not None:
                return self._spot(text, spot, right)
        left = self.said.suited.sub("", left)
        apart = left.rstrip().endswith((",", ";", ":", "-", "(", *STOPS)) or not left.strip()
        return _joined(left, right) if apart else (left.rstrip(" "), right)

    def _spot(self, left: str, spot: re.Match[str], right: str) -> Sides:
        """A room to work in is a study, a place a desk, which needs no word where no room is told."""
        if not self.working.several and re.search(r"\b(?:both|us|two)\b", spot.group()):
            self.working.add(2)
        left = left[: spot.start()]
        joint = re.search(r"(?:,|\b(?:with|and|plus|mit|und|avec|et|con|y))+ *$", left)
        if not spot["room"] and joint and not re.match(r" (?:in|im|dans|en)\b", right):
            return left[: joint.start()].rstrip(), right
        return f"{left.rstrip()} ".lstrip() + ("a study" if spot["room"] else self._desks), right

    @property
    def _desks(self) -> str:
        return "two desks" if self.working.count == 2 else "a desk"


def _parted(pattern: re.Pattern[str], left: str) -> Sides:
    """A text without what it ends with, and that."""
    near = left[-LOOKED_AT:]
    found = pattern.search(near)
    return (left, "") if found is None else (left[: len(left) - len(near) + found.start()], found.group())


def _number(who: str) -> int:
    """How many `all three of us` are."""
    digits = re.findall(r"\d", who)
    near = who.split() if who.isascii() else who
    told = [n for word, n in numbers().items() if n > 2 and word in near]
    return int(digits[0]) if digits else next(iter(told), 3)


def _joined(left: str, right: str) -> Sides:
    """Two clauses that stood on both sides of one that is gone."""
    opened = left.rstrip().endswith("(")
    left, right = left.rstrip(" ,;:-–("), right.lstrip(" ,，;:-–")
    right = right.removeprefix(")").lstrip() if opened else right
    if not left or left.endswith(STOPS):
        return f"{left} ".lstrip(), right.lstrip(".!?) ")
    ends = not right or right.startswith((*STOPS, ")"))
    return left, right if ends else f"{' ' if LISTED_ON.match(right) else ', '}{right}"
