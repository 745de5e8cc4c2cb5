"""What else is asked of rooms, as typed requirements: places, dimensions, neighbours."""

from collections.abc import Iterator
from itertools import product

from apartgen.schemas.plan import Requirement
from apartgen.stages.plan.reader.distributed import matched
from apartgen.stages.plan.reader.doors import entities
from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.statements import Asked, Said, Statement
from apartgen.stages.plan.reader.vocabulary import OPPOSITE, Det, Relation
from apartgen.stages.plan.reader.worded_in import in_its_language

FAR = ("away from", "far from")
MUTUAL = ("adjacent", "apart", "opposite", "no_door")
"""What holds of two rooms either way round."""
HABITABLE = ("living_room", "dining_room", "bedroom", "study")
LONG = 6.0
"""Metres from which on a hallway is a long one."""
LARGER, SMALLER = (1.15, 1.3, 1.6), (0.9, 0.75, 0.6)
"""Ratios that stand for words like `larger than`, which say no number."""
BESIDE = ("next to", "adjacent to", "beside", "alongside", "next door to", "close to", "near", "near to", "by",
          "adjoin", "adjoins", "adjoining", "border", "bordering", "neighbouring", "touching")  # fmt: skip


def requirements(said: Said, home: Household, ids: dict[int, str]) -> list[Requirement]:
    """One requirement for each room, or pair of rooms, something is asked of."""
    found: list[tuple[str, str, str | None, str | None, str]] = []
    for wish in [*said.asked, *_dimensions(said), *_limits(said), *_neighbours(said.statements)]:
        others = [wish.to or None] if isinstance(wish.to, str) else [ids[id(e)] for e in entities(wish.to, home)]
        of = [ids[id(e)] for e in _meant(wish, home, said)] if wish.of else ["home"]
        others += [ids[id(e)] for e in _all_others(wish, home) if ids[id(e)] not in (*of, *others)]
        pairs = [(ids[id(a)], ids[id(b)]) for a, b in _one_each(wish, home)] or product(of, others)
        rows = [(wish.kind, a, b, wish.value or None, wish.text) for a, b in pairs if a != b]
        for row in rows:
            again = (row[0], row[2], row[1], *row[3:]) if row[0] in MUTUAL else row
            found += [] if row in found or again in found else [row]
    found += _short(said, home, ids)
    found += _sized(said, home, ids, {of for kind, of, to, *_ in found if sizes(kind, to)})
    return [
        Requirement(id=f"asked_{n}", kind=kind, of=a, to=b, value=value, text=in_its_language(text, said.prompt))
        for n, (kind, a, b, value, text) in enumerate(found, 1)
    ]


def _all_others(wish: Asked, home: Household) -> list[Entity]:
    """`larger than the other bedrooms`: all of them, also those that have been spoken of."""
    phrases = wish.to if wish.kind == "order" and not isinstance(wish.to, str) else []
    kinds = [p.type for p in phrases if p.quantifier == Det.OTHER and (p.plural or not p.text.isascii())]
    return [e for kind in kinds for e in home.of(kind)]


def _one_each(wish: Asked, home: Household) -> list[tuple[Entity, Entity]]:
    """`each bedroom next to a bathroom`: a bathroom for each."""
    one = wish.to[0] if wish.kind == "adjacent" and isinstance(wish.to, list) and len(wish.to) == 1 else None
    unresolved = one is not None and one.quantifier == Det.EACH and id(one) not in home.refs
    return list(matched(entities(wish.of, home), home.of(one.type))) if one is not None and unresolved else []


def _elsewhere(wish: Asked, said: Said, home: Household) -> list[Entity]:
    """Rooms of which something of the kind is asked by name, where `everything else` is spoken of."""
    alike = [
        w
        for w in said.asked
        if w is not wish and w.kind == wish.kind and isinstance(w.to, str) == isinstance(wish.to, str)
    ]
    return [e for w in alike if not any(p.type == "any" for p in w.of) for e in entities(w.of, home)]


def _meant(wish: Asked, home: Household, said: Said) -> list[Entity]:
    """`no room smaller than 8 m²` is said of rooms that people spend the day or the night in."""
    every = next((phrase for phrase in wish.of if phrase.type == "any"), None)
    if every is None:
        return entities(wish.of, home)
    sized = wish.kind in ("at_least", "at_most") and wish.to != "doors"
    kinds = HABITABLE if sized else (*HABITABLE, "kitchen", "bathroom")
    excluded = entities(every.excluded, home)
    excluded += _elsewhere(wish, said, home) if every.quantifier == Det.OTHER else []
    if every.excluded and wish.kind in ("at_least", "at_most"):
        kinds = (*HABITABLE, "kitchen", "bathroom")  # "every room but the bathroom has at least 10 m²"
    return [e for kind in kinds for e in home.of(kind) if e not in excluded]


def _dimensions(said: Said) -> Iterator[Asked]:
    for room in said.rooms:
        for phrase in (room, *room.owned):
            if phrase.sides:
                a, b = (f"{side:.2f}".rstrip("0").rstrip(".") for side in phrase.sides)
                yield Asked("dimension", [phrase], "", f"{a} x {b}", f"{phrase.text} {a} x {b} m")


def _limits(said: Said) -> Iterator[Asked]:
    for room in said.rooms:
        for phrase in (room, *room.owned):
            for kind, limit in phrase.bounds:
                yield Asked(kind, [phrase], "", f"{limit:g}", f"{phrase.text} {kind.replace('_', ' ')} {limit:g} m²")


def _short(said: Said, home: Household, ids: dict[int, str]) -> list[tuple[str, str, str | None, str | None, str]]:
    """Of every hallway where no long ones are wanted."""
    halls = home.of("hallway") if "no_long_hallway" in said.styles else []
    return [("at_most", ids[id(hall)], "length", f"{LONG:g}", "no long hallway") for hall in halls]


def sizes(kind: str, to: str | None) -> bool:
    """Whether a requirement says how large a room is, so that its area alone need not be asked for."""
    return kind in ("area", "dimension") or kind in ("at_least", "at_most") and to is None


def _sized(
    said: Said, home: Household, ids: dict[int, str], told: set[str]
) -> Iterator[tuple[str, str, str | None, str | None, str]]:
    """Areas that were said of rooms one by one."""
    phrases = [phrase for room in said.rooms for phrase in (room, *room.owned) if phrase.areas]
    named = {id(e): phrase for phrase in phrases for e in entities([phrase], home)}
    for room in home.rooms:
        phrase = named.get(id(room))
        if room.area is not None and ids[id(room)] not in told and not (phrase and phrase.together):
            value = f"{room.area:.2f}".rstrip("0").rstrip(".")
            yield "area", ids[id(room)], None, value, f"{phrase.text if phrase else 'every room'} {value} m²"


def _neighbours(statements: list[Statement]) -> Iterator[Asked]:
    for s in statements:
        words = s.relation.removeprefix("not ")
        denied = words != s.relation
        kind = ""
        if s.kind == Relation.NEAR:
            kind = "opposite" if words.startswith(OPPOSITE) else "adjacent"
        elif s.kind == Relation.NOT and (words in FAR or (denied and words in BESIDE)):
            kind = "apart"
        elif s.kind == Relation.NOT and denied and not words.startswith(OPPOSITE):
            kind = "no_door"
        if s.kind == Relation.COMPARE and s.number in LARGER + SMALLER:
            kind = "order"
        if kind:
            value = ("larger" if s.number > 1 else "smaller") if kind == "order" else ""
            names = [" and ".join(p.text for p in phrases) for phrases in (s.left, s.right)]
            yield Asked(kind, s.left, s.right, value, f"{names[0]} {s.relation or value} {names[1]}")
