"""From facts to questions: wrong answers are the right ones of others, and letters are dealt out evenly.

Of questions that share their answers each is right once, so that nothing is to be learnt from the words alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from apartgen.schemas.qa import Difficulty, Question
from apartgen.stages.qa.facts import far_enough

MOST, FEWEST = 4, 3
"""Answers that questions share."""


@dataclass(frozen=True)
class Draft:
    """A question, the right answer and wrong ones; `number` is the right one where it is a measured one."""

    text: str
    answer: str
    images: Sequence[str]
    evidence: dict[str, Any]
    wrong: tuple[str, ...] = ()
    number: float | None = None
    hard: int = 0


@dataclass
class _Group:
    members: list[Draft] = field(default_factory=list)

    def takes(self, draft: Draft) -> bool:
        """Whether its answer can be told from the group's."""
        if len(self.members) == MOST or any(draft.answer == other.answer for other in self.members):
            return False
        numbers = [other.number for other in self.members if other.number is not None]
        return draft.number is None or far_enough(numbers, draft.number)


def shared(drafts: Sequence[Draft], rng: np.random.Generator, most: int, fewest: int = FEWEST) -> list[Draft]:
    """Groups of drafts whose answers are one another's wrong ones; each draft's own is right once in its group."""
    groups: list[_Group] = []
    known: set[tuple[str, ...]] = set()
    for k in rng.permutation(len(drafts)):
        draft = drafts[k]
        key = (draft.text, *draft.images)
        if key in known:
            continue
        group = next((group for group in groups if group.takes(draft)), None)
        if group is None:
            groups.append(group := _Group())
        group.members.append(draft)
        known.add(key)
    full = sorted((group.members for group in groups if len(group.members) >= fewest), key=len, reverse=True)
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
            images=list(draft.images), difficulty=_difficulty(draft), evidence=draft.evidence))
    return found


def _difficulty(draft: Draft) -> Difficulty:
    score = draft.hard + min(2, len(draft.images) // 2)
    return "easy" if score <= 0 else "medium" if score <= 2 else "hard"
