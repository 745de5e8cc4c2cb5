"""Rooms so many times as large as others, as people may put it, drawn at random from what stands for each."""

from math import isclose

import numpy as np
from sentences.drawn import HOMES, USUAL_ROOMS, as_drawn, one, upper

from apartgen.stages.plan.reader import read

ROOMS = {"kitchen": "kitchen_1", "living room": "living_room_1", "bathroom": "bathroom_1"}
TIMES = {"twice as {b} as": 2, "twice the size of": 2, "double the size of": 2, "three times as {b} as": 3,
         "half as {b} as": 0.5, "half the size of": 0.5, "two times as {b} as": 2, "three times the size of": 3,
         "1.5 times as {b} as": 1.5, "one and a half times as {b} as": 1.5, "50% {c} than": 1.5, "2x as {b} as": 2,
         "as {b} as": 1, "the same size as": 1, "50 percent {c} than": 1.5, "twice the area of": 2,
         "2.5 times the size of": 2.5, "half the area of": 0.5, "a third of the size of": 1 / 3,
         "exactly as {b} as": 1, "just as {b} as": 1, "a quarter {c} than": 1.25, "1.5x the size of": 1.5,
         "two thirds the size of": 2 / 3, "equal in size to": 1, "exactly twice as {b} as": 2, "20% {c} than": 1.2,
         "30 % smaller than": 0.7, "at least as {b} as": None}  # fmt: skip
COMPARED = ("The {a} is {t} the {b}.", "The {a} should be {t} the {b}.", "{A} {t} the {b}.",
            "Make the {a} {t} the {b}.", "I want the {a} {t} the {b}.", "The {a} must be {t} the {b}.",
            "{A} {t} {b}.", "Have the {a} {t} the {b}.", "I want the {a} to be {t} the {b}.", "A {a} {t} the {b}.",
            "The {a} needs to be {t} the {b}.", "The {a} ought to be {t} the {b}.",
            "The {a} shall be {t} the {b}.")  # fmt: skip
PAIRS = {(2, 3): [("living room", "kitchen"), ("kitchen", "bathroom")],
         (1, 1.25, 1.2, 1.5, 2.5): [("living room", "kitchen"), ("kitchen", "bathroom"), ("living room", "bathroom")],
         (0.5, 1 / 3, 2 / 3, 0.7): [("kitchen", "living room"), ("bathroom", "kitchen")]}  # fmt: skip


def multiple_of_another(rng: np.random.Generator) -> tuple[str, tuple[str, str, float]]:
    """`The living room is twice as large as the kitchen.`"""
    times = one(rng, [t for t in TIMES if TIMES[t]])
    factor = TIMES[times]
    pairs = next(some for factors, some in PAIRS.items() if factor in factors)
    a, b = pairs[int(rng.integers(len(pairs)))]
    times = times.format(b=one(rng, ["large", "big"]), c=one(rng, ["larger", "bigger"]))
    words = one(rng, COMPARED).format(a=a, A=upper(a), b=b, t=times)
    homes = [home for home in HOMES if "kitchen" not in home or not words.startswith("A ")]
    return one(rng, homes) + words, (ROOMS[a], ROOMS[b], factor)


def wrong(text: str, meant: tuple[str, str, float]) -> str:
    """What the programme of a text has otherwise than it is meant, empty where nothing is."""
    program = read(text)
    areas, (a, b, factor) = {room.id: room.area or 0.0 for room in program.rooms}, meant
    if sorted(areas) != USUAL_ROOMS or program.unread:
        return f"rooms {sorted(areas)}, unread {program.unread}"
    return "" if isclose(areas[a] / areas[b], factor, rel_tol=0.02) else f"{areas[a] / areas[b]:.2f}, not {factor:.2f}"


SAID = (multiple_of_another,)
test_an_area_is_so_many_times_another = as_drawn(SAID, wrong, 171103)
