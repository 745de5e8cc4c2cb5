"""Counts of rooms as people may put them, drawn at random from what stands for each: just so many, nothing unread."""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np
from sentences.drawn import article, as_drawn, one, upper

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.plan.reader import read

NUMBERS = ("no", "one", "two", "three", "four", "five")
MANY = {"bedroom": ("bedroom", "bedrooms"), "bathroom": ("bathroom", "bathrooms"), "study": ("study", "studies"),
        "balcony": ("balcony", "balconies"), "kitchen": ("kitchen", "kitchens"),
        "closet": ("walk-in closet", "walk-in closets"), "living_room": ("living room", "living rooms"),
        "storage": ("storage room", "storage rooms"), "utility": ("utility room", "utility rooms"),
        "dining_room": ("dining room", "dining rooms")}  # fmt: skip
MORE = ("study", "balcony", "storage", "utility", "dining_room", "kitchen", "living_room")
"""Of these a home has one where it has any."""


@dataclass
class Meant:
    """What a draw asks for: rooms by type, and of how many bedrooms a bathroom is private."""

    rooms: dict[str, int] = field(default_factory=dict)
    private: int | None = None


Draw = tuple[str, Meant]


def _joined(rng: np.random.Generator, items: list[str]) -> str:
    last = one(rng, [" and ", ", and ", ", "] if len(items) > 2 else [" and ", ", "])
    return ", ".join(items[:-1]) + (last if items[:-1] else "") + items[-1]


COUNTED = ("{w} {s}", "{n} {s}", "{n} x {o}", "{o} x{n}", "{n}x {o}", "{S}: {n}", "{s}: {w}", "{S} ({n})", "{n} × {o}",
           "{n}x {s}", "{o} x {n}", "{o} ×{n}", "{s} = {n}", "{n} {o}(s)", "{s}: {n}", "{S} - {n}")  # fmt: skip
BEFORE = ("", "", "A flat with ", "We need ", "I'd like ", "Apartment: ", "The flat has ", "There are ", "I want ",
          "It should have ", "Please plan a flat with ", "Rooms: ", "There should be ", "My flat needs ", "We have ",
          "An apartment with ", "I am looking for a flat with ", "Flat with ", "Design a home with ", "A home having ",
          "Our home should have ", "An apartment consisting of ", "A flat comprising ", "It must have ",
          "A house which has ", "An apartment that contains ", "A flat: ", "We want ", "We would like ")  # fmt: skip


def rooms_in_a_list(rng: np.random.Generator) -> Draw:
    """`Two bedrooms, one bathroom and a study.`"""
    rooms = {"bedroom": int(rng.integers(1, 5)), "bathroom": int(rng.integers(1, 4))}
    rooms |= {str(more): 1 for more in rng.permutation(MORE)[: rng.integers(0, 4)]}
    form, before = one(rng, COUNTED), one(rng, BEFORE)
    plain = form[0] == "{" and form[:3] in ("{w}", "{n}") and ":" not in form
    items = []
    for kind, count in rooms.items():
        single, several = MANY[kind]
        noun = single if count == 1 else several
        if plain and count == 1 and rng.random() < 0.5:
            items.append(article(single))
        else:
            items.append(form.format(w=NUMBERS[count], n=count, s=noun, S=upper(noun), o=single))
    items = [items[k] for k in rng.permutation(len(items))]
    marked = any(mark in form for mark in ":=-(")
    if marked and before not in ("", "Rooms: ", "Apartment: ", "A flat: "):
        before = ""
    said = one(rng, [", ", "; ", "\n", ". "]).join(items) if marked else _joined(rng, items)
    return f"{before}{said if before else upper(said)}.", Meant(rooms)


SHORT = ("{b}BR/{w}BA", "{b} bed {w} bath", "{b}BR {w}BA apartment", "{b}bd/{w}ba", "{b} bed, {w} bath",
         "{b}-bed {w}-bath", "{b} bedroom, {w} bathroom flat", "{b} beds {w} baths", "{b} bed / {w} bath flat",
         "{b}bed/{w}bath", "{b}br {w}ba", "{b} BR, {w} BA", "{b}-bedroom, {w}-bathroom apartment",
         "{b} bed {w} bath flat", "{b} br/{w} ba", "{B}-bedroom {W}-bathroom flat", "flat, {b} bed, {w} bath",
         "apartment ({b} bed, {w} bath)", "{b}BR, {w} bath", "{b} bedroom {w} bath apartment",
         "{B} bed {W} bath house", "{b} bed + {w} bath", "{b}-bed, {w}-bath flat", "{b} bedrooms / {w} bathrooms",
         "{b} bedrooms + {w} bathrooms", "{b} bdrm {w} bath", "{b}BR+{w}BA", "{B} bedrooms, {W} bathrooms",
         "{b} bedrooms & {w} bathrooms", "{b} bdrms, {w} baths", "{b} BR & {w} BA", "{b}BR flat with {w} bathrooms",
         "{b}-bed flat, {w} baths", "{b} bed flat with {w} baths")  # fmt: skip


def counts_in_short(rng: np.random.Generator) -> Draw:
    """`2BR/1BA`"""
    beds, baths = int(rng.integers(1, 5)), int(rng.integers(1, 4))
    words = one(rng, SHORT).format(b=beds, w=baths, B=NUMBERS[beds], W=NUMBERS[baths])
    return upper(words), Meant({"bedroom": beds, "bathroom": baths})


OF = ("{W}-bedroom flat.", "{n}-bedroom apartment.", "A flat with {w} {s}.", "A flat that has {w} {s}.",
      "{W} {o} flat.", "{n} bed flat.", "{W} bed flat.", "{n}-bed apartment.", "An apartment of {w} {s}.",
      "{n} bedroomed flat.", "A {w}-bedroom home.", "A {n} bedroom house.", "Flat, {w} {s}.", "Flat ({w} {s}).",
      "A flat, {n} {s}.", "A home with {n} {s}.", "{W} {s}.", "I want {w} {s}.", "We need {n} {s}.",
      "There should be {w} {s}.", "The flat should have {w} {s}.", "A {w}-bed flat.", "A flat with {w} {s} in total.",
      "{W} {s} in total.", "I need a flat with {w} {s}, please.", "{W} {s}, please.",
      "The number of bedrooms is {w}.", "Bedrooms: {w}.", "Number of bedrooms: {n}.", "We want exactly {w} {s}.",
      "{n}BR flat.", "A {w} bedroomed house.")  # fmt: skip


def _home(rng: np.random.Generator, count: int) -> str:
    single, several = MANY["bedroom"]
    noun = single if count == 1 else several
    return one(rng, OF).format(w=NUMBERS[count], W=upper(NUMBERS[count]), n=count, s=noun, o=single)


def bedrooms_of_a_home(rng: np.random.Generator) -> Draw:
    """`Three-bedroom flat.`"""
    count = int(rng.integers(1, 6))
    return _home(rng, count), Meant({"bedroom": count})


MORE_SAID = ("It also has {x}.", "Plus {x}.", "And {x}.", "Also {x}.", "With {x}.", "There is {x} too.",
             "And {x}, too.", "In addition, {x}.", "Additionally {x}.", "There should also be {x}.",
             "We also need {x}.", "{X} too.", "{X} as well.", "I'd like {x} too.", "It should have {x} as well.",
             "{X} would be great.", "{X} please.", "It needs {x}.", "{X} is a must.", "There must be {x}.",
             "{X} is needed.", "It has to have {x}.", "Make sure there is {x}.", "Don't forget {x}.", "Include {x}.",
             "{X} is essential.", "Please add {x}.", "{X} would be nice.", "We'd love {x}.",
             "We absolutely need {x}.", "{X} is required.", "It includes {x}.", "I really want {x}.",
             "We would also like {x}.", "Also, {x} please.", "Ideally with {x}.", "It comes with {x}.",
             "There has to be {x}.", "{X} must be included.", "We want to have {x}.")  # fmt: skip


def one_room_more(rng: np.random.Generator) -> Draw:
    """`Two-bedroom flat. We also need a study.`"""
    count, kind = int(rng.integers(1, 4)), one(rng, ["study", "balcony", "storage", "utility", "dining_room"])
    said = article(MANY[kind][0])
    return f"{_home(rng, count)} {one(rng, MORE_SAID).format(x=said, X=upper(said))}", Meant(
        {"bedroom": count, kind: 1}
    )


BATHS = {"a second bathroom": 2, "two bathrooms": 2, "three bathrooms": 3, "one bathroom": 1, "a bathroom": 1,
         "2 bathrooms": 2, "a single bathroom": 1, "two full bathrooms": 2, "a couple of bathrooms": 2,
         "a pair of bathrooms": 2, "one bathroom only": 1, "just one bathroom": 1, "only one bathroom": 1,
         "two separate bathrooms": 2, "2 baths": 2, "two baths": 2}  # fmt: skip


def bathrooms_said_too(rng: np.random.Generator) -> Draw:
    """`Three-bedroom flat with a second bathroom.`"""
    count, baths = int(rng.integers(2, 5)), one(rng, BATHS)
    form = one(rng, ["With {x}.", "It has {x}.", "{X}.", "There should be {x}.", "We need {x}.", "It should have {x}."])
    return f"{_home(rng, count)} {form.format(x=baths, X=upper(baths))}", Meant(
        {"bedroom": count, "bathroom": BATHS[baths]}
    )


NOT = ("No {o}.", "Without {a}.", "I don't want {a}.", "We don't need {a}.", "{O}: none.", "There should be no {o}.",
       "It must not have {a}.", "{O} not needed.", "{A} is not needed.", "{A} isn't required.", "Zero {s}.",
       "Leave out the {o}.", "No need for {a}.", "Skip the {o}.", "There is no {o}.", "It has no {o}.", "No {s}.",
       "We do not want any {o}.", "Please no {o}.", "No {o}, please.", "But no {o}.", "Don't add {a}.", "0 {s}.",
       "We can do without {a}.", "It shouldn't have {a}.", "{O}: no.", "{O} - no.", "I do not need {a}.",
       "We won't need {a}.", "Not {a}.", "Definitely no {o}.", "There must not be {a}.", "It needs no {o}.",
       "It does not need {a}.", "I'd rather not have {a}.", "{A} is unnecessary.", "We don't want {a}.",
       "It doesn't have {a}.", "There isn't {a}.", "Do without the {o}.", "We have no use for {a}.",
       "{A} is not necessary.", "{A} is not wanted.", "No {o} needed.", "No {o} is needed.", "{S}: 0.",
       "We need no {o}.", "{A} would be a waste of space.", "Please leave the {o} out.", "{O} = 0.")  # fmt: skip
DENIED = ("balcony", "study", "dining_room", "storage", "utility")


def room_denied(rng: np.random.Generator) -> Draw:
    """`Four-bedroom flat. We can do without a study.`"""
    count, kind = int(rng.integers(2, 5)), one(rng, DENIED)
    o, s = MANY[kind]
    words = one(rng, NOT).format(o=o, s=s, O=upper(o), S=upper(s), a=article(o), A=upper(article(o)))
    return f"{_home(rng, count)} {words}", Meant({"bedroom": count, kind: 0})


NEITHER = ("No {x} and no {y}.", "No {x} or {y}.", "Neither {ax} nor {ay}.", "Without {ax} or {ay}.",
           "No {x}, no {y}.", "We need neither {ax} nor {ay}.", "We don't want {ax} or {ay}.",
           "There is no {x} and no {y}.", "No {x}/{y}.", "We don't need {ax} and we don't need {ay}.",
           "I want neither {ax} nor {ay}.", "No {x}; no {y}.", "It should have no {x} and no {y}.",
           "No {x}, and no {y} either.", "Without {x} and {y}.", "It doesn't need {ax} or {ay}.",
           "There should be neither {ax} nor {ay}.", "No {x}. No {y}.", "Neither {x} nor {y} needed.",
           "It must not have {ax} or {ay}.", "No {x} nor {y}.")  # fmt: skip


def two_rooms_denied(rng: np.random.Generator) -> Draw:
    """`Three-bedroom flat. Neither a balcony nor a study.`"""
    count = int(rng.integers(2, 5))
    a, b = (str(kind) for kind in rng.permutation(DENIED)[:2])
    x, y = MANY[a][0], MANY[b][0]
    words = one(rng, NEITHER).format(x=x, y=y, ax=article(x), ay=article(y))
    return f"{_home(rng, count)} {words}", Meant({"bedroom": count, a: 0, b: 0})


ENSUITE = {"One of the bedrooms has an ensuite.": 1, "The main bedroom has an ensuite.": 1,
           "One bedroom has an ensuite.": 1, "One bedroom has its own bathroom.": 1,
           "Each bedroom has its own bathroom.": 9, "All bedrooms are en suite.": 9,
           "Every bedroom has an ensuite.": 9, "Two of the bedrooms have ensuites.": 2,
           "The master bedroom is en suite.": 1, "One bedroom has an ensuite bathroom, the others share a bath.": 1,
           "Master with ensuite.": 1, "The main bedroom has an en-suite bathroom, the others share one.": 1,
           "The main bedroom has a private bathroom.": 1, "One of them has an ensuite.": 1,
           "One of them has its own bathroom.": 1, "Each of them has its own bathroom.": 9, "One with an ensuite.": 1,
           "Each with an ensuite.": 9, "The main bedroom has its own bath.": 1,
           "The largest bedroom has an ensuite.": 1, "An ensuite for the main bedroom.": 1,
           "All with ensuite bathrooms.": 9, "Two bedrooms have their own bathrooms.": 2,
           "The bedrooms all have ensuites.": 9, "A master ensuite.": 1,
           "One of the bedrooms should have a private bathroom.": 1, "Each bedroom should have an ensuite.": 9,
           "The main bedroom gets its own bathroom, the other bedrooms share one.": 1,
           "Ensuite to the main bedroom.": 1, "There is an ensuite off the main bedroom.": 1,
           "All of them have their own bathroom.": 9, "Two of them have an ensuite.": 2,
           "The main bedroom comes with an ensuite.": 1, "Main bedroom en suite.": 1}  # fmt: skip


def bathrooms_of_bedrooms(rng: np.random.Generator) -> Draw:
    """`Three-bedroom flat. One bedroom has an ensuite, the others share a bath.`"""
    count, said = int(rng.integers(2, 5)), one(rng, ENSUITE)
    private = min(ENSUITE[said], count)
    return f"{_home(rng, count)} {said}", Meant({"bedroom": count}, private)


KINDS = {"a main bedroom and two others": 3, "a main bedroom and two further bedrooms": 3,
         "two double bedrooms and a single": 3, "one large and two small bedrooms": 3,
         "a large bedroom and two small ones": 3, "two bedrooms and a guest room": 3,
         "two bedrooms plus a nursery": 3, "a master bedroom and a children's room": 2, "two large bedrooms": 2,
         "a master bedroom and two smaller bedrooms": 3, "three good-sized bedrooms": 3,
         "three bedrooms, one of them small": 3, "three bedrooms including a guest room": 3,
         "three bedrooms, one of which is a guest room": 3, "four bedrooms, two of them small": 4,
         "three bedrooms, of which one is for guests": 3, "a double bedroom and a single bedroom": 2,
         "two double bedrooms": 2, "one double and one single bedroom": 2, "a big bedroom and a small bedroom": 2,
         "two bedrooms of the same size": 2, "a bedroom for us and one for the children": 2,
         "a bedroom for us and two for the children": 3, "two equal bedrooms": 2,
         "three bedrooms (one large, two small)": 3, "three bedrooms: one large and two small": 3,
         "a pair of bedrooms": 2, "a main bedroom, a second bedroom and a third bedroom": 3,
         "a main bedroom, a guest bedroom and a nursery": 3, "a couple of bedrooms": 2,
         "a master bedroom plus three more bedrooms": 4, "two spacious bedrooms and a small one": 3,
         "three bedrooms, two of which are doubles": 3, "a main bedroom and another bedroom": 2,
         "one bedroom and another one": 2, "a parents' bedroom and two children's rooms": 3,
         "two double bedrooms and one single bedroom": 3, "just two bedrooms": 2,
         "three bedrooms: a main bedroom and two kids' rooms": 3, "three bedrooms, a master and two kids' rooms": 3,
         "four bedrooms, one of them for guests": 4, "two bedrooms, one big and one small": 2, "only one bedroom": 1,
         "two bedrooms and one more for guests": 3, "half a dozen bedrooms": 6,
         "one single bedroom and two doubles": 3, "two bedrooms, the bigger one for us": 2,
         "three bedrooms for us and our two kids": 3, "two bedrooms for the kids and one for us": 3,
         "two separate bedrooms": 2, "three identical bedrooms": 3,
         "a bedroom, a second bedroom and a study": 2}  # fmt: skip
HAVING = ("A flat with {x}.", "{X}.", "We need {x}.", "I want {x}.", "The flat should have {x}.",
          "There should be {x}.", "{X} and one bathroom.", "Living room, kitchen, {x}.",
          "Our flat should have {x}, a kitchen and a living room.", "An apartment with {x} and a bathroom.",
          "It should have {x}.", "We'd like {x}, please.")  # fmt: skip


def kinds_of_bedrooms(rng: np.random.Generator) -> Draw:
    """`A main bedroom and two others.`"""
    said = one(rng, KINDS)
    having = [form for form in HAVING if "," not in said or "{x} and" not in form.lower()]
    return one(rng, having).format(x=said, X=upper(said)), Meant({"bedroom": KINDS[said]})


SAID = (rooms_in_a_list, counts_in_short, bedrooms_of_a_home, one_room_more, bathrooms_said_too, room_denied,
        two_rooms_denied, bathrooms_of_bedrooms, kinds_of_bedrooms)  # fmt: skip


def wrong(text: str, meant: Meant) -> str:
    """What the programme of a text has otherwise than it is meant, empty where nothing is."""
    try:
        program = read(text, np.random.default_rng(3) if 0 in meant.rooms.values() else None)
    except (BadInput, Unmet) as error:
        return f"refused: {error}"
    found = Counter(room.type for room in program.rooms)
    faults = [f"{found[kind]} {kind}, not {count}" for kind, count in meant.rooms.items() if found[kind] != count]
    owners = {room.private_to for room in program.rooms if room.type == "bathroom" and room.private_to}
    faults += [f"{len(owners)} en suite, not {meant.private}"] if meant.private not in (None, len(owners)) else []
    return "; ".join(faults + [f"unread {program.unread}"] * bool(program.unread))


test_rooms_are_counted_in_whatever_words_they_are = as_drawn(SAID, wrong, 171101)
