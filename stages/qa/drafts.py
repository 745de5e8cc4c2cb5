"""From facts to questions: wrong answers are the right ones of others, and letters are dealt out evenly.

Of questions that share their answers each is right once, so that nothing is to be learnt from the words alone.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from apartgen.schemas.qa import Difficulty, Question

MOST, FEWEST = 4, 2
"""Answers that questions share."""


@dataclass(frozen=True)
class Draft:
    """A question, the right answer and wrong ones; `number` is the right one where it is a measured one.

    What is `barred` would be no fair wrong answer; `marks` are pixels of numbers in the first picture. One about films
    has no images.
    """

    text: str
    answer: str
    images: Sequence[str]
    evidence: dict[str, Any]
    wrong: tuple[str, ...] = ()
    number: float | None = None
    hard: int = 0
    barred: frozenset[str] = frozenset()
    marks: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    videos: Sequence[str] = ()


@dataclass
class _Group:
    members: list[Draft] = field(default_factory=list)

    def takes(self, draft: Draft) -> bool:
        """Whether its answer can be told from the group's."""
        if len(self.members) == MOST or any(draft.answer == other.answer for other in self.members):
            return False
        if any(draft.answer in other.barred or other.answer in draft.barred for other in self.members):
            return False
        numbers = [other.number for other in self.members if other.number is not None]
        return draft.number is None or far_enough(numbers, draft.number)


def shared(drafts: Sequence[Draft], rng: np.random.Generator, most: int) -> list[Draft]:
    """Groups of drafts whose answers are one another's wrong ones; each draft's own is right once in its group."""
    groups: list[_Group] = []
    known: set[tuple[str, ...]] = set()
    for k in rng.permutation(len(drafts)):
        draft = drafts[k]
        key = (draft.text, *draft.images, *draft.videos)
        if key in known:
            continue
        group = next((group for group in groups if group.takes(draft)), None)
        if group is None:
            groups.append(group := _Group())
        group.members.append(draft)
        known.add(key)
    full = sorted((group.members for group in groups if len(group.members) >= FEWEST), key=len, reverse=True)
    found: list[Draft] = []
    for members in full:
        if len(found) + len(members) <= max(most, MOST):
            answers = [draft.answer for draft in members]
            found += [Draft(**{**vars(draft), "wrong": tuple(a for a in answers if a != draft.answer)})
                      for draft in members]
    return found


def balanced(drafts: Sequence[Draft], rng: np.random.Generator, most: int) -> list[Draft]:
    """As many with one answer as with each other that there is."""
    by: dict[str, list[Draft]] = {}
    for k in rng.permutation(len(drafts)):
        by.setdefault(drafts[k].answer, []).append(drafts[k])
    if len(by) < 2:
        return []
    count = min(max(1, most // len(by)), *(len(some) for some in by.values()))
    return [draft for answer in sorted(by) for draft in by[answer][:count]]


def either_way(drafts: Sequence[Draft], rng: np.random.Generator, most: int) -> list[Draft]:
    """Comparisons of two things in which each is right as often as it is wrong: pairs that come out both ways, and
    rings, the first before the second, it before a third, and that before the first.
    """
    left: dict[str, dict[str, list[Draft]]] = {}
    for k in rng.permutation(len(drafts)):
        left.setdefault(drafts[k].answer, {}).setdefault(drafts[k].wrong[0], []).append(drafts[k])
    found: list[Draft] = []
    while len(found) + 2 <= most and (ring := _ring(left, most - len(found))):
        for right, wrong in zip(ring, [*ring[1:], ring[0]]):
            found.append(left[right][wrong].pop())
            if not left[right][wrong]:
                del left[right][wrong]
    return found


def _ring(ahead: dict[str, dict[str, list[Draft]]], longest: int) -> list[str]:
    """Two or three names that each come before the next, and the last before the first; empty if there are none."""
    for a, others in ahead.items():
        if b := next((b for b in others if a in ahead.get(b, {})), None):
            return [a, b]
    for a, others in ahead.items() if longest >= 3 else ():
        for b in others:
            if c := next((c for c in ahead.get(b, {}) if a in ahead.get(c, {})), None):
                return [a, b, c]
    return []


def some(drafts: Sequence[Draft], rng: np.random.Generator, most: int) -> list[Draft]:
    """Up to so many with answers as different as can be."""
    found: list[Draft] = []
    used: dict[str, int] = {}
    order = [drafts[k] for k in rng.permutation(len(drafts))]
    for limit in (1, 2):
        for draft in order:
            if len(found) < most and used.get(draft.answer, 0) < limit and draft not in found:
                found.append(draft)
                used[draft.answer] = used.get(draft.answer, 0) + 1
    return found


def asked(kind: str, drafts: Sequence[Draft], rng: np.random.Generator) -> list[Question]:
    """The questions; right answers go round the letters, from one that is drawn."""
    start = int(rng.integers(12))
    found = []
    for k, draft in enumerate(drafts):
        wrong = [draft.wrong[i] for i in rng.permutation(len(draft.wrong))]
        place = (start + k) % (len(wrong) + 1)
        options = [*wrong[:place], draft.answer, *wrong[place:]]
        found.append(Question(
            id=f"{kind}_{k}", kind=kind, text=draft.text, options=options, answer=chr(65 + place), value=draft.answer,
            images=list(draft.images), videos=list(draft.videos), marks=dict(draft.marks),
            difficulty=_difficulty(draft), evidence=draft.evidence))
    return found


def _difficulty(draft: Draft) -> Difficulty:
    score = draft.hard + min(2, len(draft.images) // 2)
    return "easy" if score <= 0 else "medium" if score <= 2 else "hard"


def far_enough(values: Sequence[float], value: float, ratio: float = 1.7, least: float = 0.25) -> bool:
    """Whether a number can be told from others by eye."""
    return all(max(v, value) > ratio * min(v, value) and abs(v - value) > least for v in values)
