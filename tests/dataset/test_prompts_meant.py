"""Prompts of the grammar that comes along are read as meant: what each of its texts says is written here by hand."""

import re
import tomllib
from collections import Counter
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any

import numpy as np
import pytest
from shapely.geometry import Polygon

from apartgen.schemas.plan import Program
from apartgen.stages.plan import PlanConfig, build, reader

TEXTS: dict[str, list[Any]] = tomllib.loads((files("apartgen.dataset") / "programmes.toml").read_text())
_SYMBOL, _NUMBER = re.compile(r"\{([a-z_]+)\}"), re.compile(r"\{(\d+)-(\d+)(?:/(\d+))?\}")

WORDS = {
    "study": "study", "balcony": "balcony", "dining room": "dining_room", "utility room": "utility",
    "laundry": "utility",
    "storage room": "storage", "pantry": "storage", "walk-in closet": "closet",
}
"""Rooms beyond those that every home has, by their words: none of them is there unless it is named."""
BATHS = {
    "one bathroom": (1, 1), "two bathrooms": (2, 2), "a bathroom and a separate WC": (2, 2),
    "two bathrooms and a WC": (3, 3), "a bathroom and a shower room": (2, 2), "1 bathroom": (1, 1),
    "a bathroom": (1, 1), "a shower room": (1, 1),
}
NUMBERS = {"one": 1, "two": 2, "three": 3, "four": 4, "1": 1, "2": 2, "3": 3, "4": 4}


@dataclass
class Meant:
    """What a prompt says."""

    bedrooms: int = 0
    baths: tuple[int, int] = (1, 2)
    total: float | None = None
    rooms: Counter[str] = field(default_factory=Counter)
    areas: dict[str, float] = field(default_factory=dict)
    ensuite: bool = False
    kitchen: str = "any"


def drawn(rng: np.random.Generator, symbol: str, meant: Meant) -> str:
    """A text for a symbol; what it says is added to what is meant."""
    rows = [row if isinstance(row, str) else row[1] for row in TEXTS[symbol]]
    text = rows[int(rng.integers(len(rows)))]
    text = _NUMBER.sub(lambda found: str(rng.choice(
        range(int(found[1]), int(found[2]) + 1, int(found[3] or 1)))), text)
    said(text, symbol, meant)
    return _SYMBOL.sub(lambda found: drawn(rng, found[1], meant), text)


def said(text: str, symbol: str, meant: Meant) -> None:
    """What a text says itself, the symbols in it left out."""
    if bedrooms := re.search(r"\b(one|two|three|four|[1-4])[ -]bedrooms?\b", text):
        meant.bedrooms = NUMBERS[bedrooms[1]]
    if area := re.match(r"(\d+) m²", text):
        meant.total = float(area[1])
    if area := re.search(r"\b(bedroom|living room|kitchen|study|balcony) of (\d+) m²", text):
        meant.areas[area[1].replace(" ", "_")] = float(area[2])
        meant.bedrooms += area[1] == "bedroom"
    if symbol in ("bath", "baths", "many_baths"):
        meant.baths = BATHS[text]
    elif number := re.search(r"\b1 bathroom|\band a bathroom", text):
        meant.baths = BATHS[number[0].removeprefix("and ")]
    meant.ensuite |= "ensuite" in text
    meant.rooms.update(room for word, room in WORDS.items() if re.search(rf"\b{word}\b", text))
    meant.rooms["guest WC"] += "guest WC" in text
    if "separate kitchen" in text or symbol == "living" and "open" not in text:
        meant.kitchen = "separate" if "separate" in text else meant.kitchen
    if "open-plan" in text:
        meant.kitchen = "open" if meant.kitchen == "any" else meant.kitchen


def faults(program: Program, meant: Meant) -> list[str]:
    """What of a programme is not what was meant."""
    have = Counter(room.type for room in program.rooms)
    found = [f"{have['bedroom']} bedrooms"] if have["bedroom"] != meant.bedrooms and (
        meant.bedrooms or have["bedroom"] > 1) else []
    low, high = meant.baths
    more = meant.rooms["guest WC"]
    if not low + more <= have["bathroom"] <= high + more + meant.ensuite:
        found.append(f"{have['bathroom']} bathrooms")
    if meant.ensuite and not any(room.type == "bathroom" and room.private_to for room in program.rooms):
        found.append("no ensuite")
    for room in set(WORDS.values()):
        if bool(have[room]) != bool(meant.rooms[room]) or have[room] > meant.rooms[room]:
            found.append(f"{have[room]} of {room}")
    for kind in ("living_room", "kitchen"):
        if have[kind] != 1 and not (kind == "kitchen" and not meant.bedrooms):
            found.append(f"{have[kind]} of {kind}")
    for kind, area in meant.areas.items():
        if area not in [room.area for room in program.rooms if room.type == kind]:
            found.append(f"{kind} is not of {area:g} m²")
    if program.total_area != meant.total:
        found.append(f"{program.total_area} m² in all")
    is_open = any({"kitchen", "living_room"} == {id.rpartition("_")[0] for id in pair} for pair in program.open_links)
    if meant.kitchen in ("open", "separate") and have["kitchen"] and is_open != (meant.kitchen == "open"):
        found.append(f"kitchen is {'open' if is_open else 'shut'}")
    return found


@pytest.mark.parametrize("batch", range(8))
def test_prompts_are_read_as_meant(batch):
    wrong = []
    for i in range(40):
        meant, rng = Meant(), np.random.default_rng([61, batch, i])
        text = " ".join(drawn(rng, "home", meant).split())
        if max(meant.rooms.values(), default=0) > 1:
            continue  # a room that is named twice may be one or two
        program = reader.read(text)
        wrong += [(text, *found)] if (found := faults(program, meant)) else []
    assert wrong == []


@pytest.mark.slow
def test_rooms_are_built_as_large_as_prompts_say():
    off, tried = [], 0
    for i in range(1000):
        meant, rng = Meant(), np.random.default_rng([67, i])
        program = reader.read(" ".join(drawn(rng, "home", meant).split()))
        if not meant.areas:
            continue
        built = {room.id: Polygon(room.polygon).area for room in build(program, PlanConfig(), rng).rooms}
        asked = {room.id: room.area or 0.0 for room in program.rooms if room.area == meant.areas.get(room.type)}
        off += [abs(built[room] / area - 1) for room, area in asked.items()]
        tried += 1
    print(f"{tried} prompts, {len(off)} rooms: within 5 % {np.mean(np.array(off) <= 0.05):.3f}, most {max(off):.3f}")
    assert tried >= 200 and np.mean(np.array(off) <= 0.05) >= 0.97
