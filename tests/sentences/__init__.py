"""The controllability benchmark: prompts with the programme an architect would write for them.

`sentences.jsonl` is written by hand: 240 prompts in two halves before the reader was tuned, of which the `held` half is
for measuring only, and more that joined the `tune` half as the reader grew. What a prompt leaves open follows these
rules:

1. A home has a living room, a kitchen, a bathroom and, unless it is a studio, a bedroom and a hallway.
   One bathroom up to two bedrooms, two up to four, three beyond. A prompt that excludes a room wins.
2. Every room opens onto the hallway; without one, onto the living room. A dining room lies between kitchen and
   living room, a balcony off the living room, a walk-in closet off the main bedroom.
3. One bathroom serves the home; further full ones are ensuite, from the main bedroom on; half baths are off the
   hallway.
4. Rooms named together ("kitchen-diner", "open-plan kitchen and living room") are one room per function, linked
   without a wall in the order kitchen, dining, living, and entered through the living room, else the kitchen.
   A studio's kitchen is a kitchenette open to the room.
5. Doors the prompt names for a room replace the usual ones, unless the room could then be reached only through a
   bedroom that does not own it. "Next to" means a door between living, dining and kitchen only.
6. One or two rooms without a word for a dwelling, and lists that end in "nothing else", are meant exactly so.
7. Areas stated hold; others are the typical ones of `reader/sense.toml`, scaled to the total where one is given.
   "Large" is 1.3 times the typical area, "small" 0.75 times.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from apartgen.schemas.plan import AskedRoom
from apartgen.stages.plan.reader.areas import fill, typical
from apartgen.stages.plan.reader.links import mark_private
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.space.graphs import RoomGraph, graph

FACTORS = {"large": 1.3, "small": 0.75, "long": 1.4}
"""What an adjective does to a typical area."""


@dataclass(frozen=True)
class Case:
    """One prompt, the graph it should give, and the areas it states (m²)."""

    id: int
    half: str
    prompt: str
    truth: RoomGraph
    stated: dict[str, float]
    quantified: bool


def cases(half: str | None = None) -> list[Case]:
    """The benchmark, or its `tune` or `held` half."""
    lines = (Path(__file__).parent / "sentences.jsonl").read_text(encoding="utf-8").splitlines()
    rows = [json.loads(line) for line in lines]
    return [case_of(row) for row in rows if half in (None, row["half"])]


def case_of(row: dict[str, Any]) -> Case:
    """The case of a line."""
    types = {room: room.rsplit("_", 1)[0] for room in row["rooms"]}
    areas = _areas(row, types)
    stated = row.get("areas", {})
    quantified = any(key in row for key in ("areas", "ratios", "total_area"))
    links = [(a, b) for a, b in row["links"]]
    return Case(row["id"], row["half"], row["prompt"], graph(types, areas, links), stated, quantified)


def _areas(row: dict[str, Any], types: dict[str, str]) -> dict[str, float]:
    rooms = [AskedRoom(id=i, type=t, private_to=None) for i, t in types.items()]
    links = [(a, b) for a, b in row["links"]]
    mark_private(rooms, links)
    traits = {i: set(names) for i, names in row.get("traits", {}).items()}
    if "bedroom_1" not in types and row.get("open_links"):
        traits["kitchen_1"] = {"small"}
    base = typical(rooms, links, traits)
    for i, names in traits.items():
        named = any(f"{types[i]}:{t}" in sense()["area_of"] for t in names)
        base[i] *= 1.0 if named else FACTORS.get(min(names), 1.0)
    areas = fill(rooms, base, row.get("areas", {}), {}, row.get("total_area"))
    for a, b, ratio in row.get("ratios", []):
        both = areas[a] + areas[b]
        areas |= {a: both * ratio / (1 + ratio), b: both / (1 + ratio)}
    return areas
