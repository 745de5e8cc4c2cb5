"""Words for a way through a home, and the numbers of these words."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from math import degrees
from typing import get_args

from apartgen.schemas.base import RoomType
from apartgen.stages.export._legs import Leg, Passed
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import one, spoken

STRAIGHT, BEAR, BACK = 30.0, 60.0, 150.0
"""Below the first one goes straight on, below the second one bears aside, from the third one turns about, degrees."""
LENGTH = 200
"""Numbers of an instruction, as the published data sets have them; those after its end are 0."""
EXTRAS = ["<pad>", "<unk>", "<s>", "</s>"]
"""Words that no text has, the first of the vocabulary."""
SIDES = ("straight ahead", "ahead on your left", "ahead on your right", "on your left", "on your right")


@dataclass(frozen=True)
class Style:
    """How somebody talks: turns by what they are, then what is passed, ways out of the first and of later rooms, the
    end. Without `passing`, nothing that is passed is told.
    """

    turns: Mapping[str, str]
    passing: str
    leaving: str
    going: str
    ending: str


STYLES = (
    Style({"bear": "bear {}", "turn": "turn {}", "back": "turn around"}, "pass {thing} on your {hand}",
          "leave {here} through the {hole} {side} into {there}", "go through the {hole} {side} into {there}",
          "stop in front of {thing}"),
    Style({"bear": "go slightly to the {}", "turn": "take a {}", "back": "turn back"},
          "walk past {thing} on your {hand}", "walk out of {here} by the {hole} {side} and enter {there}",
          "take the {hole} {side} and enter {there}", "walk up to {thing} and wait there"),
    Style({"bear": "keep {}", "turn": "go {}", "back": "face the other way"}, "",
          "exit {here} to {there} by the {hole} {side}", "continue to {there} by the {hole} {side}",
          "halt at {thing}"),
)  # fmt: skip


def told(style: Style, legs: list[Leg], rooms: list[str], seen: list[list[Passed]], things: Mapping[str, str],
         goal: str) -> str:
    """Sentences, one a leg: through `rooms` by their names, past `seen`, to the thing `goal`."""
    return " ".join(_sentence(style, k, legs, rooms, seen[k], things, goal) for k in range(len(legs)))


def _sentence(style: Style, k: int, legs: list[Leg], rooms: list[str], seen: list[Passed], things: Mapping[str, str],
              goal: str) -> str:
    leg = legs[k]
    parts = [(turn.at, _turned(style, turn.angle)) for turn in leg.turns if turned(turn.angle)]
    parts += [(one.at, style.passing.format(thing=things[one.id], hand="left" if one.left else "right"))
              for one in seen if style.passing]
    said = [text for _, text in sorted(parts, key=lambda part: part[0])]
    if leg.way_out is None:
        said.append(style.ending.format(thing=things[goal]))
    else:
        how = style.leaving if k == 0 else style.going
        hole = "door" if leg.way_out.kind == "door" else "opening"
        said.append(how.format(here=rooms[k], hole=hole, side=side(leg.side), there=rooms[k + 1]))
    text = ", ".join(said[:-1]) + (" and " if said[1:] and " and " not in said[-1] else ", " if said[1:] else "")
    text += said[-1]
    return f"{text[0].upper()}{text[1:]}."


def turned(angle: float) -> str:
    """What kind of turn it is; nothing for hardly any."""
    off = abs(degrees(angle))
    return "" if off < STRAIGHT else "bear" if off < BEAR else "turn" if off < BACK else "back"


def _turned(style: Style, angle: float) -> str:
    return style.turns[turned(angle)].format("left" if angle > 0 else "right")


def side(angle: float) -> str:
    """Where something is that lies that far to the left; nothing for what is behind."""
    ahead, left = turned(angle), "left" if angle > 0 else "right"
    return {"": SIDES[0], "bear": f"ahead on your {left}", "turn": f"on your {left}", "back": ""}[ahead]


def tokens(text: str) -> list[str]:
    """Words and full stops, as Habitat's `tokenize` splits them."""
    return re.findall(r"[\w-]+|\.", text.lower())


@cache
def vocabulary() -> list[str]:
    """Every word that instructions of this version may have, the same for all homes."""
    kinds = [name for name, kind in TABLE.items() if kind.place == "floor"]
    said = [text for s in STYLES for text in (*s.turns.values(), s.passing, s.leaving, s.going, s.ending)]
    said += [*SIDES, "left right door opening the with .", *(spoken(name) for name in kinds), *map(one, kinds),
             *(kind.replace("_", " ") for kind in get_args(RoomType))]
    return EXTRAS + sorted({word for text in said for word in tokens(re.sub(r"{\w*}", " ", text))})


def numbers(text: str) -> list[int]:
    """The numbers of a text's words, and 0 after them."""
    known = {word: k for k, word in enumerate(vocabulary())}
    found = [known[word] for word in tokens(text)]
    return [*found, *[0] * (LENGTH - len(found))]
