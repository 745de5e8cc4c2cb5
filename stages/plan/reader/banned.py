"""Rooms that a home is not to have."""

from typing import TYPE_CHECKING

from apartgen.stages.plan.reader.entity import DISTINCT
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det, Trait

if TYPE_CHECKING:
    from apartgen.stages.plan.reader.household import Household

ALWAYS = ("living_room", "kitchen", "bedroom", "bathroom")
"""Rooms a home has: no additional one is still one."""


def ban(home: "Household", phrase: RoomPhrase) -> None:
    """What `no second bathroom`, `no balcony` denies: rooms of a type, or those beyond a number."""
    if phrase.ordinals:  # "no second bathroom"
        home.totals.setdefault(phrase.type, len(home.ensure(phrase.type, min(phrase.ordinals) - 1, counted=True)))
    elif phrase.quantifier == Det.ANOTHER and (home.of(phrase.type) or phrase.type in ALWAYS):
        pass  # "no extra bathroom"
    elif phrase.factor != 1.0 and phrase.type in ALWAYS:
        pass  # "no big kitchen": a smaller one
    elif Trait.OPEN in phrase.labels:
        home.closed_kitchen = True  # "no open kitchen", "no open-plan living"
    elif Trait.PLACED in phrase.labels and phrase.type in ALWAYS:
        pass  # "no internal bathroom": another is
    elif phrase.type == "kitchen" and Trait.SEPARATE in phrase.labels:
        home.open_kitchen = True
    elif Trait.SEPARATE not in phrase.labels:
        label = next((x for x in sorted(phrase.labels) if x in DISTINCT), "")
        home.banned.add((phrase.type, label))
