"""Areas and sizes as people may put them, drawn at random from what stands for each: all are kept, nothing is unread.

A draw makes the words and what they ask for at once, so that what is asked for is known without reading.
"""

from dataclasses import dataclass, field
from math import isclose

import numpy as np
from sentences.drawn import HOMES, USUAL_ROOMS, as_drawn, one, upper

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.plan.reader import read

SQUARE = {"m²": 1.0, "m2": 1.0, "sqm": 1.0, "sq m": 1.0, "sq. m": 1.0, "square metres": 1.0, "square meters": 1.0,
          "sq metres": 1.0, "SQM": 1.0, "m^2": 1.0, "square feet": 0.09290304, "sq ft": 0.09290304, "sqft": 0.09290304,
          "sq. ft.": 0.09290304, "ft²": 0.09290304}  # fmt: skip
ABOUT = ("", "", "", "about ", "around ", "roughly ", "approximately ", "approx. ", "ca. ", "circa ", "~", "some ",
         "exactly ", "just ", "almost ")  # fmt: skip
WORDS = {8: "eight", 9: "nine", 10: "ten", 12: "twelve", 14: "fourteen", 16: "sixteen", 20: "twenty",
         24: "twenty-four", 25: "twenty five", 30: "thirty"}  # fmt: skip
USUAL = {"kitchen_1": (8, 10, 12, 14), "living_room_1": (20, 24, 25, 30), "bathroom_1": (4, 5, 6, 7),
         "bedroom_1": (14, 15, 16, 18)}  # fmt: skip
ROOMS = {"kitchen": "kitchen_1", "living room": "living_room_1", "bathroom": "bathroom_1", "lounge": "living_room_1",
         "main bedroom": "bedroom_1", "master bedroom": "bedroom_1"}  # fmt: skip


@dataclass
class Meant:
    """What a draw asks for: areas of rooms in m², the home's, and requirements."""

    areas: dict[str, float] = field(default_factory=dict)
    total: float | None = None
    asked: set[tuple[str, str, float]] = field(default_factory=set)


Draw = tuple[str, Meant]


def _in(rng: np.random.Generator, room: str) -> tuple[str, float]:
    """An area that such a room may have, in some unit, and what it is in m²."""
    unit = one(rng, SQUARE)
    usual = int(rng.choice(USUAL[room]))
    if SQUARE[unit] < 1:
        number = round(usual / SQUARE[unit] / 10) * 10
        return f"{number} {unit}", number * SQUARE[unit]
    if rng.random() < 0.15 and usual in WORDS and unit.startswith("square"):
        return f"{WORDS[usual]} {unit}", usual
    if rng.random() < 0.2:
        return f"{usual}.5 {unit}", usual + 0.5
    joint = "" if unit in ("m²", "m2", "sqm", "SQM") and rng.random() < 0.4 else " "
    return f"{usual}{joint}{unit}", usual


def _home(rng: np.random.Generator, words: str) -> str:
    """A home before such words: `A kitchen of 12 m²` may be another one where a kitchen was told of before."""
    another = words.lower().startswith(("a ", "some "))
    return one(rng, [home for home in HOMES if "kitchen" not in home or not another])


OF_ROOM = (
    "The {r} is {a}.", "The {r} measures {a}.", "The {r} should be {a}.", "The {r} must be {a}.", "The {r} has {a}.",
    "The {r} needs to be {a}.", "The {r} covers {a}.", "The {r} takes up {a}.", "The {r} should have {a}.",
    "The {r} has an area of {a}.", "The {r} has a floor area of {a}.", "The {r} should have an area of {a}.",
    "{R} of {a}.", "{R} with {a}.", "{R} ({a}).", "{R}: {a}.", "{R} - {a}.", "{R}, {a}.", "{R} = {a}.", "{R} {a}.",
    "{A} for the {r}.", "The area of the {r} is {a}.", "The size of the {r} should be {a}.", "{R} area: {a}.",
    "The {r}'s area is {a}.", "Give the {r} {a}.", "Make the {r} {a}.", "I want the {r} to be {a}.", "{R} size {a}.",
    "I'd like the {r} to be {a}.", "We need the {r} to be {a}.", "The {r} should measure {a}.", "The {r} is to be {a}.",
    "Let the {r} be {a}.", "The {r} will be {a}.", "The {r} ought to be {a}.", "The {r} should be {a} in size.",
    "The {r} is {a} large.", "The {r} is {a} big.", "Please make the {r} {a}.", "The {r} can be {a}.",
    "The {r} comes to {a}.", "The {r}: {a}.", "{A} {r}.", "A {r} of {a}.", "A {r} with an area of {a}.",
    "The {r} gets {a}.", "The {r} should be {a} in area.", "The {r} shall be {a}.", "The {r} occupies {a}.",
    "For the {r}, {a}.", "For the {r} I want {a}.", "As for the {r}, it should be {a}.", "The {r} — {a}.",
    "The {r} has a size of {a}.", "The {r} would be {a}.",
)  # fmt: skip


def area_of_a_room(rng: np.random.Generator) -> Draw:
    """`The kitchen is about 12 square metres.`"""
    room = one(rng, ROOMS)
    said, value = _in(rng, ROOMS[room])
    said = one(rng, ABOUT) + said
    words = one(rng, OF_ROOM).format(r=room, R=upper(room), a=said, A=upper(said))
    return _home(rng, words) + words, Meant({ROOMS[room]: value}, asked={("area", ROOMS[room], value)})


WITH = ("Two-bedroom flat with a {r} of {a}.", "A two-bedroom flat with a {a} {r}.", "Two-bedroom flat, {r} {a}.",
        "Two-bedroom flat with a {r} ({a}).", "Two-bedroom apartment whose {r} is {a}.", "2-bed flat w/ {a} {r}.",
        "Two-bedroom flat, the {r} being {a}.", "I want a two-bedroom flat with a {r} that is {a}.",
        "Two-bedroom flat where the {r} is {a}.", "Two-bedroom flat with {a} of {r}.", "2 bedroom flat - {r}: {a}.",
        "A two-bedroom flat; the {r} has {a}.", "A two-bedroom flat in which the {r} measures {a}.",
        "A two-bedroom flat with a {r} measuring {a}.", "A two-bedroom flat and a {r} of {a}.",
        "A two-bedroom flat with a {r} that measures {a}.", "Two bedroom flat with {r} {a}.")  # fmt: skip


def area_in_a_home(rng: np.random.Generator) -> Draw:
    """`A two-bedroom flat with a 12 sqm kitchen.`"""
    room = one(rng, ROOMS)
    said, value = _in(rng, ROOMS[room])
    forms = [form for form in WITH if said[0].isdigit() or "{a} of" not in form]
    words = one(rng, forms).format(r=room, a=one(rng, ABOUT) + said)
    return words, Meant({ROOMS[room]: value}, asked={("area", ROOMS[room], value)})


LIMITS = {
    "at_least": ("at least {a}", "no less than {a}", "not less than {a}", "a minimum of {a}", "{a} or more",
                 "no smaller than {a}", "not smaller than {a}", "{a} at least", "{a} minimum", "min. {a}", "min {a}",
                 "{a} or larger", ">= {a}", "≥ {a}", "not under {a}", "minimum {a}", "not below {a}", "{a} and up",
                 "over {a}", "larger than {a}", "more than {a}", "{a} or above", "bigger than {a}", "upwards of {a}",
                 "{a} min", "above {a}", "at the very least {a}", "at minimum {a}"),
    "at_most": ("at most {a}", "no more than {a}", "not more than {a}", "a maximum of {a}", "up to {a}",
                "no larger than {a}", "no bigger than {a}", "not larger than {a}", "{a} at most", "{a} maximum",
                "max. {a}", "max {a}", "<= {a}", "≤ {a}", "not over {a}", "{a} or less", "maximum {a}", "not above {a}",
                "under {a}", "smaller than {a}", "less than {a}", "{a} or smaller", "not bigger than {a}",
                "{a} tops", "{a} max", "below {a}", "{a} at the most", "not exceeding {a}", "at the very most {a}"),
}  # fmt: skip
LIMITED = ("The {r} should be {a}.", "The {r} must be {a}.", "{R}: {a}.", "{R} {a}.", "The {r} is {a}.", "{R} ({a}).",
           "I want the {r} to be {a}.", "The {r} needs to be {a}.", "{R}, {a}.", "The {r} has to be {a}.",
           "Make the {r} {a}.", "The {r} measures {a}.", "Please make the {r} {a}.", "A {r}, {a}.")  # fmt: skip


def limit_of_a_room(rng: np.random.Generator) -> Draw:
    """`The kitchen should be no smaller than 12 m².`"""
    room, kind = one(rng, ROOMS), one(rng, LIMITS)
    said, value = _in(rng, ROOMS[room])
    limit = one(rng, [form for form in LIMITS[kind] if form[0] not in "<>≤≥" or said[0].isdigit()]).format(a=said)
    words = one(rng, LIMITED).format(r=room, R=upper(room), a=limit)
    return _home(rng, words) + words, Meant(asked={(kind, ROOMS[room], value)})


BETWEEN = ("between {x} and {y} {u}", "{x} to {y} {u}", "from {x} to {y} {u}", "{x}-{y} {u}", "{x} - {y} {u}",
           "{x}–{y} {u}", "between {x} {u} and {y} {u}", "at least {x} {u} and at most {y} {u}", "{x} {u} to {y} {u}",
           "somewhere between {x} and {y} {u}", "in the range of {x} to {y} {u}", "at least {x} and at most {y} {u}",
           "more than {x} but less than {y} {u}", "at least {x} {u} but no more than {y} {u}",
           "no less than {x} and no more than {y} {u}")  # fmt: skip


def limits_of_a_room(rng: np.random.Generator) -> Draw:
    """`The kitchen should be between 10 and 12 m².`"""
    room = one(rng, ROOMS)
    least = int(rng.choice(USUAL[ROOMS[room]]))
    most, unit = least + int(rng.integers(1, 4)), one(rng, [u for u in SQUARE if SQUARE[u] == 1])
    limit = one(rng, BETWEEN).format(x=least, y=most, u=unit)
    words = one(rng, LIMITED).format(r=room, R=upper(room), a=limit)
    asked = {("at_least", ROOMS[room], least), ("at_most", ROOMS[room], most)}
    return _home(rng, words) + words, Meant(asked=asked)


SIDES = ("{x} x {y} {u}", "{x} {u} x {y} {u}", "{x}x{y} {u}", "{x} by {y} {u}", "{x} {u} by {y} {u}", "{x}×{y} {u}",
         "{x} × {y} {u}", "{x} {u} by {y}", "{x}x{y}{u}", "{x} * {y} {u}", "{x} times {y} {u}",
         "{x} {u} wide and {y} {u} long", "{y} {u} long and {x} {u} wide", "{x} {u} wide by {y} {u} long",
         "{y} {u} long, {x} {u} wide", "{x} {u} in width and {y} {u} in length")  # fmt: skip
METRES = {"m": 1.0, "metres": 1.0, "meters": 1.0, "ft": 0.3048, "feet": 0.3048}
SIDED = ("The {r} is {a}.", "The {r} measures {a}.", "{R} {a}.", "{R}: {a}.", "{R} ({a}).", "The {r} should be {a}.",
         "The {r} must measure {a}.", "{R} of {a}.", "{R}, {a}.", "A {a} {r}.", "A {r} of {a}.", "Make the {r} {a}.",
         "The size of the {r} is {a}.", "The {r} has dimensions of {a}.", "I want the {r} to be {a}.",
         "The dimensions of the {r} are {a}.", "The {r} is about {a}.", "{R} size: {a}.", "{R} dimensions: {a}.",
         "The {r} measures roughly {a}.", "A {r} measuring {a}.", "The {r} is to be {a}.")  # fmt: skip
LONG = {"kitchen_1": (2.5, 4), "living_room_1": (4, 5.5), "bathroom_1": (2, 3), "bedroom_1": (3.5, 4.5)}


def sides_of_a_room(rng: np.random.Generator) -> Draw:
    """`The kitchen measures 3 by 4 metres.`"""
    room, unit, sides = one(rng, ROOMS), one(rng, METRES), one(rng, SIDES)
    x, y = LONG[ROOMS[room]]
    x, y = (x + rng.integers(0, 2) * 0.5, y + rng.integers(0, 2) * 0.5)
    if METRES[unit] < 1:
        x, y = round(x / METRES[unit]), round(y / METRES[unit])
    how = [form for form in SIDED if "long" not in sides and "in " not in sides or "A {a}" not in form]
    if unit in ("m", "ft") and rng.random() < 0.3:
        sides = one(rng, ["{x}{u} x {y}{u}", "{x}{u}x{y}{u}", "{x}{u} by {y}{u}", "{x}{u} × {y}{u}"])
    said = sides.format(x=f"{x:g}", y=f"{y:g}", u=unit)
    words = one(rng, how).format(r=room, R=upper(room), a=said)
    area = float(x * y * METRES[unit] ** 2)
    return _home(rng, words) + words, Meant({ROOMS[room]: area}, asked={("dimension", ROOMS[room], 0)})


IN_ALL = ("{A} in total.", "Total area {a}.", "Total area of {a}.", "{A} altogether.", "{A} in all.",
          "The flat is {a}.", "The whole flat measures {a}.", "The total floor area should be {a}.", "Total: {a}.",
          "{A} overall.", "The flat has {a}.", "The flat should be {a}.", "The flat should have {a} in total.",
          "Size: {a}.", "Area: {a}.", "Floor area: {a}.", "The total area is {a}.", "The apartment is {a} in total.",
          "{A} total.", "All in all {a}.", "Overall area {a}.", "The home covers {a}.", "The overall size is {a}.",
          "In total it should be {a}.", "Altogether {a}.", "It should have {a} in all.", "Total size {a}.",
          "The size of the flat is {a}.", "The area of the flat should be {a}.", "The apartment has an area of {a}.",
          "The flat's total area is {a}.", "We have {a}.", "There are {a} in total.", "Total living area: {a}.",
          "I want {a} in total.", "Living space {a}.", "The entire apartment measures {a}.", "It is {a} in total.",
          "The total should be {a}.", "All together {a}.", "{A} of living space.",
          "{A} of floor space.")  # fmt: skip
HOME_OF = ("A two-bedroom flat of {a}.", "Two-bedroom flat, {a}.", "{A} two-bedroom flat.", "Two-bedroom flat ({a}).",
           "A two-bedroom flat with {a}.", "A {a} flat with two bedrooms.", "Flat with two bedrooms on {a}.",
           "A two-bedroom flat with a total area of {a}.", "Two-bedroom flat, total area {a}.", "2 bed, 1 bath, {a}.",
           "Two-bedroom flat - {a}.", "Two-bedroom flat with {a} of floor space.", "2BR apartment, {a}.",
           "Two-bedroom flat, {a} in total.", "A two-bedroom flat measuring {a}.", "Two-bedroom flat: {a}.",
           "A two-bedroom flat that measures {a}.", "A two-bedroom flat that is {a}.", "{A} flat, 2 bedrooms.",
           "A two-bedroom flat covering {a}.", "A flat of {a} with two bedrooms.", "{A}, two bedrooms.",
           "Two bedrooms, kitchen, living room, bathroom; {a} in total.")  # fmt: skip


def area_of_the_home(rng: np.random.Generator) -> Draw:
    """`85 square metres in all.`"""
    unit = one(rng, SQUARE)
    number = int(rng.choice([70, 80, 85, 92] if SQUARE[unit] == 1 else [800, 900, 1000, 950]))
    said, value = f"{number} {unit}", number * SQUARE[unit]
    about = one(rng, ABOUT)
    home, words = (one(rng, HOMES), one(rng, IN_ALL)) if rng.random() < 0.65 else ("", one(rng, HOME_OF))
    if rng.random() < 0.3:
        kind = one(rng, LIMITS)
        limit = one(rng, LIMITS[kind]).format(a=said)
        if "{A}" in words:
            return area_of_the_home(rng)
        return home + words.format(a=limit), Meant(asked={(kind, "home", value)})
    return home + words.format(a=about + said, A=upper(about + said)), Meant(total=value)


EACH = ("Each bedroom {a}.", "Each bedroom is {a}.", "Both bedrooms are {a}.", "Bedrooms of {a} each.",
        "The bedrooms are {a} each.", "The bedrooms should be {a} each.", "Every bedroom should be {a}.",
        "Both bedrooms should have {a}.", "Bedrooms: {a} each.", "{A} for each bedroom.", "{A} per bedroom.",
        "Bedrooms {a} each.", "The bedrooms should each be {a}.", "The bedrooms each measure {a}.",
        "All bedrooms {a}.", "Each of the bedrooms should be {a}.", "Each of the two bedrooms is {a}.",
        "Both of the bedrooms are {a}.", "The two bedrooms are {a} each.", "The bedrooms have {a} each.",
        "Bedrooms ({a} each).", "Each bedroom: {a}.", "All of the bedrooms are {a}.", "The bedrooms are both {a}.",
        "Bedroom sizes: {a} each.", "Both bedrooms {a}.", "Each bedroom has an area of {a}.", "Each bedroom of {a}.",
        "Make each bedroom {a}.", "Every bedroom: {a}.")  # fmt: skip
EACH_HOME = ("A flat with two bedrooms of {a} each.", "A flat with two {a} bedrooms.",
             "A flat with two bedrooms, {a} each.", "A flat with two bedrooms ({a} each).",
             "A flat with two bedrooms, each {a}.", "2 x {a} bedrooms.", "A flat with two bedrooms, each of {a}.",
             "A flat with two bedrooms, both {a}.", "Two bedrooms at {a} each.",
             "A flat with two bedrooms that are {a} each.", "A flat with 2 bedrooms of {a}.",
             "A flat with two bedrooms of {a} apiece.",
             "A flat with two bedrooms, each measuring {a}.")  # fmt: skip


def area_of_each(rng: np.random.Generator) -> Draw:
    """`Each bedroom 12 m².`"""
    said, value = _in(rng, "kitchen_1")
    if rng.random() < 0.65:
        text = one(rng, HOMES) + one(rng, EACH).format(a=said, A=upper(said))
    else:
        text = one(rng, EACH_HOME).format(a=said)
    beds = ("bedroom_1", "bedroom_2")
    return text, Meant(dict.fromkeys(beds, value), asked={("area", bed, value) for bed in beds})


TWO = ("Bedrooms of {x} and {y} {u}.", "Bedrooms of {x} {u} and {y} {u}.", "The bedrooms are {x} and {y} {u}.",
       "One bedroom of {x} {u} and one of {y} {u}.", "One bedroom is {x} {u}, the other {y} {u}.",
       "The first bedroom is {x} {u}, the second {y} {u}.", "The larger bedroom is {x} {u}, the smaller {y} {u}.",
       "Bedrooms: {x} {u} and {y} {u}.", "Bedrooms ({x} {u} and {y} {u}).", "Bedrooms: {x} and {y} {u}.",
       "Main bedroom {x} {u}, the other one {y} {u}.", "Bedroom 1: {x} {u}, bedroom 2: {y} {u}.",
       "The main bedroom is {x} {u} and the second bedroom is {y} {u}.", "Bedrooms {x} and {y} {u}.",
       "The bedrooms should have {x} and {y} {u}.", "The bedrooms measure {x} {u} and {y} {u}.",
       "One of the bedrooms is {x} {u}, the other is {y} {u}.", "Bedroom 1 {x} {u}; bedroom 2 {y} {u}.",
       "The main bedroom has {x} {u}, the other bedroom {y} {u}.", "Bedrooms of {x} {u} and of {y} {u}.",
       "One bedroom should be {x} {u} and the other {y} {u}.", "Master bedroom: {x} {u}. Second bedroom: {y} {u}.",
       "The first bedroom should be {x} {u} and the second one {y} {u}.", "Bedrooms {x} + {y} {u}.",
       "The bigger bedroom has {x} {u} and the smaller one {y} {u}.", "Bedrooms: {x}/{y} {u}.",
       "A main bedroom of {x} {u} and a second bedroom of {y} {u}.", "Bedroom A {x} {u}, bedroom B {y} {u}.",
       "The main bedroom {x} {u}, the second {y} {u}.", "{x} {u} for the main bedroom and {y} {u} for the other.",
       "The larger of the bedrooms is {x} {u}, the smaller one is {y} {u}.")  # fmt: skip


def areas_of_two(rng: np.random.Generator) -> Draw:
    """`Bedrooms of 14 and 11 m².`"""
    unit = one(rng, [u for u in SQUARE if SQUARE[u] == 1])
    x, y = int(rng.choice([14, 15, 16])), int(rng.choice([9, 10, 11, 12]))
    meant = {"bedroom_1": float(x), "bedroom_2": float(y)}
    said = one(rng, TWO).format(x=x, y=y, u=unit)
    return _home(rng, said) + said, Meant(meant, asked={("area", room, value) for room, value in meant.items()})


ITEM = ("{r} {a}", "{r}: {a}", "{r} of {a}", "a {a} {r}", "{r} ({a})", "a {r} of {a}", "{r} = {a}", "{r} - {a}",
        "the {r} is {a}", "the {r} should be {a}", "{a} for the {r}", "{a} {r}", "the {r} has {a}", "{r} with {a}",
        "the {r} {a}", "{r} approx. {a}", "{r}, {a}", "{r} about {a}", "- {r}: {a}")  # fmt: skip
JOINTS = (", ", "; ", ". ", "\n", " and ", ", and ")


def areas_in_a_list(rng: np.random.Generator) -> Draw:
    """`Living room 25 m², kitchen 12 m², bathroom 5 m².`"""
    rooms = [str(room) for room in rng.permutation(["kitchen", "living room", "bathroom", "main bedroom"])]
    form, joint = one(rng, ITEM), one(rng, JOINTS)
    if form == "{r}, {a}" or (form[0] == "-"):
        joint = "; " if form[0] == "{" else "\n"
    rooms = rooms[: 2 if "and" in joint else int(rng.integers(2, 5))]
    unit = one(rng, [u for u in SQUARE if SQUARE[u] == 1])
    values = {room: int(rng.choice(USUAL[ROOMS[room]])) for room in rooms}
    items = [form.format(r=room, a=f"{value} {unit}") for room, value in values.items()]
    items = [upper(item) if joint in (". ", "\n") else item for item in items]
    meant = {ROOMS[room]: float(value) for room, value in values.items()}
    said = upper(joint.join(items)) + "."
    text = _home(rng, said) + said
    return text, Meant(meant, asked={("area", room, value) for room, value in meant.items()})


SAID = (area_of_a_room, area_in_a_home, limit_of_a_room, limits_of_a_room, sides_of_a_room, area_of_the_home,
        area_of_each, areas_of_two, areas_in_a_list)  # fmt: skip


def _alike(asked: list[tuple[str, str, float]], meant: set[tuple[str, str, float]]) -> bool:
    pairs = list(zip(sorted(asked), sorted(meant), strict=False))
    return len(asked) == len(meant) and all(a[:2] == b[:2] and isclose(a[2], b[2], rel_tol=0.002) for a, b in pairs)


def wrong(text: str, meant: Meant) -> str:
    """What the programme of a text has otherwise than it is meant, empty where nothing is."""
    try:
        program = read(text)
    except (BadInput, Unmet) as error:
        return f"refused: {error}"
    areas = {room.id: room.area or 0.0 for room in program.rooms}
    faults = [f"rooms {sorted(areas)}"] if sorted(areas) != USUAL_ROOMS else []
    faults += [f"{room} is {areas.get(room)}, not {value:.2f}" for room, value in meant.areas.items()
               if not isclose(areas.get(room, 0.0), value, rel_tol=0.01)]  # fmt: skip
    asked = [(r.kind, r.of, 0.0 if r.kind == "dimension" else float(r.value or 0)) for r in program.requirements]
    faults += [f"asked {sorted(asked)}"] if not _alike(asked, meant.asked) else []
    limited = any(of == "home" for _, of, _ in meant.asked)
    if not limited and not isclose(program.total_area or 0.0, meant.total or 0.0, rel_tol=0.001):
        faults.append(f"in all {program.total_area}, not {meant.total}")
    return "; ".join(faults + [f"unread {program.unread}"] * bool(program.unread))


test_a_size_is_kept_in_whatever_words_it_is_said = as_drawn(SAID, wrong, 171100, draws=40)
