"""Furniture as people may ask for it, drawn at random from what stands for each: it is where it is meant to be."""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np
from sentences.drawn import HOMES, USUAL_ROOMS, article, as_drawn, one, upper

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.plan.reader import read

ROOMS = {"living room": "living_room_1", "lounge": "living_room_1", "kitchen": "kitchen_1", "bathroom": "bathroom_1",
         "main bedroom": "bedroom_1", "master bedroom": "bedroom_1", "hallway": "hallway_1",
         "hall": "hallway_1"}  # fmt: skip
THINGS = {
    "living_room_1": {"sofa": "sofa", "couch": "sofa", "armchair": "armchair", "coffee table": "coffee_table",
                      "TV": "tv", "bookshelf": "bookshelf", "piano": "piano", "rug": "rug", "floor lamp": "floor_lamp",
                      "television": "tv", "sideboard": "sideboard", "bookcase": "bookshelf",
                      "corner sofa": "corner_sofa", "desk": "desk", "side table": "side_table"},
    "bedroom_1": {"desk": "desk", "wardrobe": "wardrobe", "chest of drawers": "chest", "double bed": "double_bed",
                  "nightstand": "nightstand", "bookshelf": "bookshelf", "mirror": "mirror", "dressing table":
                  "dressing_table", "single bed": "single_bed", "bedside table": "nightstand", "dresser": "chest"},
    "kitchen_1": {"fridge": "fridge", "dishwasher": "dishwasher", "oven": "oven", "microwave": "microwave",
                  "dining table": "dining_table", "washing machine": "washing_machine", "stool": "stool"},
    "bathroom_1": {"bathtub": "bath", "shower": "shower", "washing machine": "washing_machine", "mirror": "mirror",
                   "towel rail": "towel_rail", "dryer": "dryer", "laundry basket": "laundry_basket"},
    "hallway_1": {"coat rack": "coat_rack", "shoe cabinet": "shoe_cabinet", "wardrobe": "wardrobe", "bench": "bench",
                  "mirror": "mirror", "console table": "console_table", "shoe rack": "shoe_cabinet"},
}  # fmt: skip
SEVERAL = {"two": 2, "three": 3, "2": 2, "3": 3, "a pair of": 2, "a couple of": 2}
ALIKE = (
    "armchair",
    "bookshelf",
    "floor lamp",
    "rug",
    "nightstand",
    "stool",
    "mirror",
    "wardrobe",
    "single bed",
    "desk",
)
"""Things of which a room may have several."""
SIZES = ("", "", "", "", "large ", "big ", "small ", "comfortable ", "nice ", "proper ")


@dataclass
class Meant:
    """What a draw asks for: things in rooms, or things in any room."""

    things: dict[tuple[str, str], int] = field(default_factory=dict)
    anywhere: dict[str, int] = field(default_factory=dict)
    either: bool = False


Draw = tuple[str, Meant]


def _several(noun: str) -> str:
    return {"bookshelf": "bookshelves"}.get(noun, f"{noun}s")


def _thing(rng: np.random.Generator, room: str) -> tuple[str, str, int]:
    """Some thing for such a room: its words, its category, and how many."""
    noun = one(rng, THINGS[room])
    if noun in ALIKE and rng.random() < 0.4:
        many = one(rng, SEVERAL)
        return f"{many} {_several(noun)}", THINGS[room][noun], SEVERAL[many]
    return article(one(rng, SIZES) + noun), THINGS[room][noun], 1


def _things(rng: np.random.Generator, room: str, most: int = 3, comma: bool = True) -> tuple[str, dict[str, int]]:
    """One thing or a list of several."""
    found: dict[str, tuple[str, int]] = {}
    for _ in range(int(rng.integers(1, most + 1))):
        said, category, count = _thing(rng, room)
        found.setdefault(category, (said, count))
    words = [said for said, _ in found.values()]
    joints = [" and ", " and ", " plus ", " as well as ", *([", and ", ", "] if comma else [])]
    joint = one(rng, joints) if len(words) > 1 else ""
    return ", ".join(words[:-1]) + joint + words[-1], {category: count for category, (_, count) in found.items()}


IN_ROOM = (
    "The {r} has {x}.", "Put {x} in the {r}.", "There is {x} in the {r}.", "{X} in the {r}.", "In the {r}, {x}.",
    "In the {r} there is {x}.", "I want {x} in the {r}.", "We need {x} in the {r}.", "The {r} should have {x}.",
    "{R}: {x}.", "{R} with {x}.", "{R} ({x}).", "{X} for the {r}.", "Place {x} in the {r}.", "The {r} needs {x}.",
    "Furnish the {r} with {x}.", "The {r} comes with {x}.", "The {r} is furnished with {x}.", "The {r} contains {x}.",
    "I'd like {x} in the {r}.", "{X} should be in the {r}.", "The {r} gets {x}.", "The {r} includes {x}.",
    "There should be {x} in the {r}.", "Add {x} to the {r}.", "The {r} is equipped with {x}.", "The {r} must have {x}.",
    "In the {r} I want {x}.", "In the {r} we need {x}.", "The {r} with {x}.", "The {r} shall have {x}.", "{R} has {x}.",
    "The {r} has to have {x}.", "The {r} must contain {x}.", "There must be {x} in the {r}.", "{R} - {x}.",
    "I would like the {r} to have {x}.", "We want the {r} to have {x}.", "{X} must go in the {r}.", "{R} has got {x}.",
    "Have {x} in the {r}.", "Please put {x} in the {r}.", "Equip the {r} with {x}.", "The {r} will have {x}.",
    "The {r} needs to have {x}.", "Please add {x} in the {r}.", "Make sure the {r} has {x}.", "For the {r}, {x}.",
    "In the {r}: {x}.", "For the {r} I'd like {x}.", "The {r} has room for {x}.", "I need {x} in the {r}.",
    "There is room for {x} in the {r}.", "The {r} should be furnished with {x}.", "The {r} ought to have {x}.",
    "{X} belongs in the {r}.", "The {r} features {x}.", "Inside the {r} there is {x}.", "{X} stands in the {r}.",
    "{X} goes in the {r}.", "{X} should stand in the {r}.", "{X} into the {r}, please.", "{X} in the {r}, please.",
)  # fmt: skip


def things_in_a_room(rng: np.random.Generator) -> Draw:
    """`The living room has a sofa and two armchairs.`"""
    room = one(rng, ROOMS)
    said, things = _things(rng, ROOMS[room])
    words = one(rng, IN_ROOM).format(r=room, R=upper(room), x=said, X=upper(said))
    homes = [home for home in HOMES if room != "lounge" or "iving room" not in home]
    return one(rng, homes) + words, Meant({(ROOMS[room], thing): count for thing, count in things.items()})


WITH = ("Two-bedroom flat with {x} in the {r}.", "A two-bedroom flat; {x} in the {r}.", "2 bed flat, {x} in the {r}.",
        "Two-bedroom flat with a {r} that has {x}.", "A two-bedroom flat whose {r} has {x}.",
        "A two-bedroom flat where the {r} has {x}.", "Two-bedroom flat, the {r} with {x}.",
        "I want a two-bedroom flat with {x} in the {r}.",
        "A two-bedroom flat, with {x} in the {r}.", "A two-bedroom flat in which the {r} has {x}.",
        "A flat with two bedrooms and {x} in the {r}.", "A two-bedroom flat with a {r} with {x}.")  # fmt: skip


def things_in_a_home(rng: np.random.Generator) -> Draw:
    """`Two-bedroom flat with a desk in the living room.`"""
    room = one(rng, ROOMS)
    said, things = _things(rng, ROOMS[room], 2, comma=False)
    text = one(rng, WITH).format(r=room, x=said)
    return text, Meant({(ROOMS[room], thing): count for thing, count in things.items()})


EACH = ("{X} in each bedroom.", "Each bedroom has {x}.", "Every bedroom needs {x}.", "Both bedrooms have {x}.",
        "Each bedroom with {x}.", "Both bedrooms should have {x}.", "Put {x} in every bedroom.",
        "{X} in both bedrooms.", "{X} in all bedrooms.", "The bedrooms each have {x}.",
        "In each bedroom there is {x}.", "{X} for each bedroom.", "The bedrooms have {x} each.",
        "Bedrooms with {x} each.", "Each of the bedrooms has {x}.", "{X} in every bedroom.",
        "There is {x} in each bedroom.", "Both of the bedrooms have {x}.", "All bedrooms have {x}.",
        "{X} per bedroom.", "Each bedroom should have {x}.", "Each bedroom gets {x}.", "In both bedrooms I want {x}.",
        "Both bedrooms: {x}.", "I want {x} in each bedroom.", "We need {x} in both bedrooms.", "Bedrooms: {x} each.",
        "Both bedrooms with {x}.", "Every bedroom must have {x}.", "{X} in each of the bedrooms.",
        "Each bedroom: {x}.", "In each bedroom, {x}.", "There should be {x} in every bedroom.",
        "Both bedrooms need {x}.", "The two bedrooms each have {x}.", "All bedrooms with {x}.",
        "Each bedroom contains {x}.", "Bedrooms have {x} each.")  # fmt: skip


def things_in_each(rng: np.random.Generator) -> Draw:
    """`A desk in each bedroom.`"""
    said, things = _things(rng, "bedroom_1", 2)
    text = one(rng, HOMES) + one(rng, EACH).format(x=said, X=upper(said))
    beds = ("bedroom_1", "bedroom_2")
    return text, Meant({(bed, thing): count for bed in beds for thing, count in things.items()})


APART = ("{X} in the main bedroom and {y} in the other one.", "The main bedroom has {x}, the other {y}.",
         "The main bedroom has {x} and the second bedroom has {y}.", "{X} in the main bedroom, {y} in the other.",
         "The main bedroom has {x}, the second one {y}.", "{X} in the master bedroom and {y} in the second bedroom.",
         "Main bedroom with {x}, second bedroom with {y}.", "Main bedroom: {x}. Second bedroom: {y}.",
         "Put {x} in the main bedroom and {y} in the other bedroom.", "Bedroom 1: {x}; bedroom 2: {y}.",
         "The main bedroom should have {x} and the other one {y}.", "The master has {x}; the other bedroom has {y}.",
         "The first bedroom has {x}, the second has {y}.", "The first bedroom needs {x} and the second one {y}.",
         "In the main bedroom there is {x}, in the other {y}.", "In the main bedroom {x}, in the second {y}.",
         "The larger bedroom has {x}, the smaller one {y}.", "The bigger bedroom gets {x}, the smaller one gets {y}.",
         "There is {x} in the main bedroom and {y} in the second one.",
         "In the first bedroom {x}, in the second {y}.")  # fmt: skip
ONE_OF = ("One bedroom has {x}, the other {y}.", "One bedroom has {x}, the other has {y}.",
          "One has {x}, the other {y}.", "One of the bedrooms has {x}, the other one {y}.",
          "One bedroom with {x} and one with {y}.", "One bedroom should have {x} and the other {y}.",
          "{X} in one bedroom and {y} in the other.", "{X} in one bedroom, {y} in the other one.",
          "In one bedroom {x}, in the other {y}.", "One of them has {x}, the other has {y}.",
          "In one bedroom there is {x} and in the other {y}.")  # fmt: skip


def things_apart(rng: np.random.Generator) -> Draw:
    """`A double bed in the main bedroom, two single beds in the other.`"""
    x, here = _things(rng, "bedroom_1", 1)
    y, there = _things(rng, "bedroom_1", 1)
    if here == there:
        return things_apart(rng)
    either = rng.random() < 0.35
    text = one(rng, HOMES) + one(rng, ONE_OF if either else APART).format(x=x, X=upper(x), y=y)
    meant = {("bedroom_1", thing): count for thing, count in here.items()}
    meant |= {("bedroom_2", thing): count for thing, count in there.items()}
    return text, Meant(meant, either=either)


NOT = ("No {o} in the {r}.", "The {r} has no {o}.", "I don't want {a} in the {r}.", "We don't need {a} in the {r}.",
       "There is no {o} in the {r}.", "The {r} without {a}.", "The {r} should not have {a}.",
       "Don't put {a} in the {r}.", "The {r} must not have {a}.", "There should be no {o} in the {r}.",
       "The {r} doesn't need {a}.", "{R}: no {o}.", "The {r} does not have {a}.", "Please no {o} in the {r}.",
       "The {r} doesn't have {a}.", "{R} without {a}.", "We want no {o} in the {r}.", "In the {r}, no {o}.",
       "In the {r} there is no {o}.", "The {r} needs no {o}.", "The {r} should have no {o}.",
       "No {o} in the {r}, please.", "There must not be {a} in the {r}.", "The {r} must have no {o}.",
       "I want no {o} in the {r}.", "{R} with no {o}.", "The {r} won't have {a}.")  # fmt: skip


def things_denied(rng: np.random.Generator) -> Draw:
    """`The living room has no TV.`"""
    room = one(rng, ROOMS)
    noun = one(rng, THINGS[ROOMS[room]])
    words = one(rng, NOT).format(r=room, R=upper(room), o=noun, a=article(noun))
    homes = [home for home in HOMES if room != "lounge" or "iving room" not in home]
    return one(rng, homes) + words, Meant({(ROOMS[room], THINGS[ROOMS[room]][noun]): 0})


TABLES = ("A dining table for {n}.", "A table for {n} in the kitchen.",
          "The kitchen has a dining table with {n} chairs.", "A dining table and {n} chairs in the kitchen.",
          "The kitchen has a table for {n}.", "A table for {n} people.", "A dining table with {n} chairs.",
          "Put a table for {n} in the kitchen.", "The kitchen needs a table for {n}.",
          "I want a dining table for {n}.", "A dining table that seats {n}.", "A dining table seating {n}.",
          "The kitchen should have a table with {n} chairs.", "There is a table for {n} people in the kitchen.",
          "We need a dining table for {n} people.", "A table with {n} chairs in the kitchen.",
          "{N} chairs and a dining table in the kitchen.", "The kitchen has a table and {n} chairs.",
          "A kitchen table for {n}.", "The dining table seats {n}.",
          "A dining table for {n} persons.")  # fmt: skip


def tables_for_several(rng: np.random.Generator) -> Draw:
    """`A dining table for six.`"""
    number = one(rng, ["four", "six", "4", "6", "eight"])
    text = one(rng, HOMES) + one(rng, TABLES).format(n=number, N=upper(number))
    count = {"four": 4, "six": 6, "eight": 8}.get(number) or int(number)
    return text, Meant(anywhere={"dining_table": 1, "chair": count})


OURS = ("We have {x}.", "I own {x}.", "There must be space for {x}.", "Room for {x}.", "I'd like {x}.", "{X} too.",
        "It must fit {x}.", "With {x}.", "Space for {x}.", "It should have {x}.", "I need {x}.", "We want {x}.",
        "There should be {x}.", "I want {x}.", "We need room for {x}.", "Plus {x}.", "And {x}.", "Also {x}.", "{X}.",
        "It needs {x}.", "We also need {x}.", "{X} would be nice.", "Please add {x}.", "{X}, please.", "Include {x}.",
        "I have {x} that must fit in.", "We'd like to have {x}.", "It has to have {x}.", "We would like {x}.",
        "There has to be room for {x}.", "There is {x}.", "We're bringing {x}.", "I would like to have {x}.",
        "It should be furnished with {x}.", "Furnished with {x}.")  # fmt: skip
LOOSE = {"piano": "piano", "bookshelf": "bookshelf", "sofa": "sofa", "washing machine": "washing_machine",
         "desk": "desk", "dishwasher": "dishwasher", "coat rack": "coat_rack", "armchair": "armchair",
         "bathtub": "bath", "TV": "tv"}  # fmt: skip


def things_of_ours(rng: np.random.Generator) -> Draw:
    """`There must be space for a piano.`"""
    nouns = [str(noun) for noun in rng.permutation(list(LOOSE))[: rng.integers(1, 3)]]
    said = " and ".join(article(noun) for noun in nouns)
    words = one(rng, OURS).format(x=said, X=upper(said))
    return one(rng, HOMES) + words, Meant(anywhere={LOOSE[noun]: 1 for noun in nouns})


LISTED = ("{r}: {x}", "{x} in the {r}", "the {r} has {x}", "{r} with {x}", "the {r} with {x}", "{r} - {x}", "{r} ({x})",
          "in the {r}, {x}", "in the {r} {x}", "the {r} gets {x}", "the {r} needs {x}", "- {r}: {x}")  # fmt: skip


def things_in_a_list(rng: np.random.Generator) -> Draw:
    """`Living room: a sofa and a TV. Kitchen: a dishwasher.`"""
    rooms = [str(room) for room in rng.permutation(["living room", "kitchen", "bathroom", "main bedroom", "hallway"])]
    form, joint = one(rng, LISTED), one(rng, [". ", "; ", "\n", ", "])
    joint = "\n" if form[0] == "-" else ". " if joint == ", " and ":" in form else joint
    meant, items = {}, []
    for room in rooms[: rng.integers(2, 4)]:
        said, things = _things(rng, ROOMS[room], 1 if joint == ", " else 2)
        meant |= {(ROOMS[room], thing): count for thing, count in things.items()}
        items.append(form.format(r=room, x=said))
    items = [upper(item) for item in items] if joint in (". ", "\n") else items
    return one(rng, HOMES) + upper(joint.join(items)) + ".", Meant(meant)


SAID = (things_in_a_room, things_in_a_home, things_in_each, things_apart, things_denied, tables_for_several,
        things_of_ours, things_in_a_list)  # fmt: skip


def wrong(text: str, meant: Meant) -> str:
    """What the programme of a text has otherwise than it is meant, empty where nothing is."""
    try:
        program = read(text)
    except (BadInput, Unmet) as error:
        return f"refused: {error}"
    rooms = sorted(room.id for room in program.rooms)
    faults = [f"rooms {rooms}"] if rooms != USUAL_ROOMS else []
    found = {(thing.room, thing.category): thing.count for thing in program.objects}
    if meant.anywhere:
        totals: Counter[str] = Counter()
        for (_, category), count in found.items():
            totals[category] += count
        faults += [f"things {found}"] if dict(totals) != meant.anywhere else []
    else:
        swapped = {(room.replace("_1", "_0").replace("_2", "_1").replace("_0", "_2"), thing): n
                   for (room, thing), n in meant.things.items()}  # fmt: skip
        faults += [f"things {found}"] if found != meant.things and not (meant.either and found == swapped) else []
    return "; ".join(faults + [f"unread {program.unread}"] * bool(program.unread))


test_things_are_where_they_are_said_to_be = as_drawn(SAID, wrong, 171102)
