"""What was said as a programme: rooms with ids, links, areas, furniture, weights."""

import logging
import re
from dataclasses import replace

from numpy.random import Generator

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import AskedObjects, AskedRoom, Envelope, Link, Program
from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.newcomers import as_base, plain
from apartgen.stages.plan.reader.about import About
from apartgen.stages.plan.reader.areas import fill, typical
from apartgen.stages.plan.reader.contradict import consistent
from apartgen.stages.plan.reader.desks import add_desks, add_study
from apartgen.stages.plan.reader.doors import Doors, Pair, doors_said, ensuites, every_room
from apartgen.stages.plan.reader.entity import MOST, Entity, whose
from apartgen.stages.plan.reader.halls import hall_rank
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.languages import understood
from apartgen.stages.plan.reader.links import complete_links, edge
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.missing import add_missing_rooms, beside_usual, full_graph
from apartgen.stages.plan.reader.nurseries import children
from apartgen.stages.plan.reader.parse import mentions, parse
from apartgen.stages.plan.reader.requirements import requirements
from apartgen.stages.plan.reader.rooms_in_all import all_named, make_room, make_up, told
from apartgen.stages.plan.reader.shared_out import shared_out
from apartgen.stages.plan.reader.sizes import areas_told, room_areas
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.structured import in_sentences
from apartgen.stages.plan.reader.style import style_of
from apartgen.stages.plan.reader.unread import with_clauses
from apartgen.stages.plan.reader.vocabulary import Det, Trait
from apartgen.stages.plan.reader.wanted import add_bedrooms, add_rooms
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.rooms import furnishing

log = logging.getLogger("apartgen")
LONGEST = 8000
ENDLESS = re.compile(r"[a-zà-öø-ÿœß]{100,}|[0-9]{100,}", re.IGNORECASE)
"""No word and no number: patterns would look through all that follows at each of its letters."""
"""Characters of a prompt."""
LIVED_IN = ("living_room", "kitchen", "dining_room", "bedroom", "bathroom", "study")
"""Rooms that `a lamp in every room` speaks of."""

AREAS_TOLD = 6.0
"""What areas count where a prompt tells those of rooms, but not where they lie, which is the rarer wish."""
IN_ROOM = {("kitchen_sink", "bathroom"): "vanity", ("chair", "balcony"): "balcony_chair",
           ("dining_table", "balcony"): "balcony_table"}  # fmt: skip
"""What things are in rooms where their name is that of others: the sink of a bathroom, the table on a balcony."""

def read(prompt: str, rng: Generator | None = None) -> Program:
    """The programme a prompt asks for, gaps filled by architectural common sense. Pure; no network.

    With `rng`, a prompt that leaves its rooms open gets what homes of its size have, by lot.
    BadInput when no room can be read or the request is absurd, Unmet when it contradicts itself.
    """
    said = bounded(prompt)
    if said.corrected:
        log.warning("read in the prompt: %s", ", ".join(f'"{a}" as "{b}"' for a, b in dict.fromkeys(said.corrected)))
    beside = {id(p) for wish in said.asked if not isinstance(wish.to, str) for p in wish.to}
    home = Household(mentions(said.statements) | beside, {id(p) for wish in said.asked for p in wish.of})
    for phrase in _introduced_first(said.rooms):
        home.resolve(phrase)
    silent = replace(said.about, lived=False) == About() and not said.working.found
    if not (home.rooms or said.dwelling or said.main_rooms or said.in_all) and silent:
        raise BadInput(
            f'no room could be read from the prompt {_quoted(prompt)}; name rooms, e.g. "two-bedroom flat with a study"'
        )
    closed = home.closed_kitchen or any(e.type == "kitchen" and Trait.SEPARATE in e.labels for e in home.rooms)
    home.open_kitchen = home.open_kitchen or (said.open_plan and not closed)
    consistent(said, home)
    doors = doors_said(said.statements, home)
    complete = (said.only and not beside_usual(said, home)) or full_graph(said, home, doors) or all_named(said, home)
    if not complete:
        named = {room.type for room in home.rooms} | ({"any"} if said.main_rooms else set())
        named |= {"studio"} if said.dwelling == "studio" else set()
        add_study(said, home)
        make_room(said, home)
        add_bedrooms(said, home, rng)
        add_missing_rooms(said, home, doors)
        make_up(said, home)
        if rng is not None and not (said.only or said.in_all):
            add_rooms(said, home, doors, named, rng)
    add_desks(said, home)
    every_room(said.statements, home, doors)
    _every_area(said, home)
    ensuites(home, doors)
    told(said, home)
    if len(home.rooms) > MOST:
        raise BadInput(f"the prompt asks for more than {MOST} rooms; ask for fewer")
    return _program(said, home, doors, complete)


def _every_area(said: Said, home: Household) -> None:
    """`every room is 12 m²`, hallways apart."""
    for phrase in said.rooms:
        excluded = {id(e) for p in phrase.excluded for e in home.refs.get(id(p), [])}
        for room in home.rooms if phrase.type == "any" and len(phrase.areas) == 1 and not phrase.bounds else []:
            if room.area is None and room.type != "hallway" and id(room) not in excluded:
                room.area = phrase.areas[0]


def bounded(prompt: str) -> Said:
    """What a prompt says; BadInput when it is empty, asks for more rooms than a home has, for areas out of range."""
    if not prompt.strip():
        raise BadInput('the prompt is empty; name rooms, e.g. "two-bedroom flat"')
    if len(prompt) > LONGEST:
        raise BadInput(f"the prompt has {len(prompt)} characters; keep it below {LONGEST}")
    prompt = in_sentences(ENDLESS.sub(lambda word: word[0][:100], prompt))
    understood(prompt)
    said = parse(prompt)
    _counts_in_bounds(said)
    return said


def _introduced_first(phrases: list[RoomPhrase]) -> list[RoomPhrase]:
    """Totals first; `each bedroom … three bedrooms` is read the other way round."""
    early: set[int] = set()
    for k, phrase in enumerate(phrases):
        universal = phrase.quantifier in (Det.EACH, Det.ALL, Det.BOTH) and phrase.count is None
        known = any(p.type == phrase.type for p in phrases[:k])
        several = phrase.quantifier == Det.THE and phrase.plural and phrase.count is None and not phrase.labels
        counted = any(p.type == phrase.type and (p.count or 0) > 2 and p.quantifier == Det.BARE for p in phrases[k:])
        if several and not known and counted:
            early.add(id(phrase))  # "the bedrooms are far from the kitchen. Three bedrooms."
        if universal and not known and any(p.type == phrase.type and p.count for p in phrases[k:]):
            early.add(id(phrase))
    return sorted(phrases, key=lambda p: 0 if p.headline else 2 if id(p) in early else 1)


def _quoted(prompt: str) -> str:
    text = " ".join(prompt.split())
    return f'"{text[:60]}…"' if len(text) > 60 else f'"{text}"'


def _counts_in_bounds(said: Said) -> None:
    """Absurd requests end here rather than in the solver."""
    asked = sum(int(p.count or 1) for p in said.rooms if not p.negated)
    most = max([p.count or 0 for p in said.rooms if not p.negated] + [said.main_rooms or 0], default=0)
    if most > MOST or asked > 3 * MOST:
        raise BadInput(
            f"the prompt asks for {int(max(most, asked))} rooms; a home of at most {MOST} rooms can be planned"
        )
    for phrase in said.rooms:
        for area in phrase.areas:
            if not 0.5 <= area <= 1000:
                raise BadInput(
                    f"an area of {area:g} m² for a {phrase.type or 'room'} is out of range; give 0.5 to 1000 m²"
                )
    if said.total_area is not None and not 5 <= said.total_area <= 2000:
        raise BadInput(f"a total area of {said.total_area:g} m² is out of range; give 5 to 2000 m²")


def _program(said: Said, home: Household, doors: Doors, complete: bool) -> Program:
    ids = _ids(home)
    ordered = _ordered(home)
    rooms = [as_base(AskedRoom(id=ids[id(e)], type=e.type, private_to=_private(e, ids))) for e in ordered]

    def pairs(found: list[Pair]) -> list[Link]:
        return sorted({edge(ids[id(a)], ids[id(b)]) for a, b in found})

    banned = set(pairs(doors.forbidden))
    links = [link for link in pairs(doors.links) if link not in banned]
    links = complete_links(rooms, links, banned, set(pairs(doors.near)), {ids[id(e)] for e in doors.only},
                           set(pairs(doors.passing)), {ids[id(e)] for e in doors.reached})  # fmt: skip
    areas = room_areas(said, home, rooms, links, ids)
    sleep = children([e for e in ordered if e.type == "bedroom"], said.about.people, said.prompt)
    style = style_of(said)
    wanted = requirements(said, home, ids)
    if areas_told(said, home) and not any(asked.kind == "position" for asked in wanted):
        style["weights"]["typical_area"] = style["weights"].get("typical_area", 1.0) * AREAS_TOLD
    return Program(
        rooms=[
            AskedRoom(id=r.id, type=e.type, area=areas[r.id], private_to=r.private_to, children=sleep.get(id(e)))
            for e, r in zip(ordered, rooms, strict=True)
        ],
        links=links,
        open_links=[link for link in pairs(doors.open) if link in links],
        weights=style["weights"],
        objects=_furnishing(said, home, ids),
        counts={ids[id(e)]: e.object_count for e in _ordered(home) if e.object_count is not None},
        total_area=None if said.total_area is None else round(said.total_area, 2),
        regularity=style["regularity"],
        envelope=_envelope(said),
        complete=complete,
        unread=with_clauses(said.unread, said.beyond, said.prompt),
        requirements=wanted,
    )


def _ordered(home: Household) -> list[Entity]:
    """By type, the main bedroom and the hall one enters first."""
    types = [str(t) for t in ROOM_TYPES]
    return sorted(home.rooms, key=lambda e: (types.index(kinds()[e.type].base), e.type not in types, _rank(e)))


def _rank(room: Entity) -> int:
    return hall_rank(room) if room.type == "hallway" else whose(room) if room.type == "bedroom" else 0


def _ids(home: Household) -> dict[int, str]:
    seen: dict[str, int] = {}
    out: dict[int, str] = {}
    for entity in _ordered(home):
        seen[entity.type] = seen.get(entity.type, 0) + 1
        out[id(entity)] = f"{entity.type}_{seen[entity.type]}"
    return out


def _private(entity: Entity, ids: dict[int, str]) -> str | None:
    owner = entity.owner
    return ids[id(owner)] if owner is not None and owner.type == "bedroom" else None


def _furnishing(said: Said, home: Household, ids: dict[int, str]) -> list[AskedObjects]:
    wanted: dict[tuple[str, str], int] = {}
    for e in _ordered(home):
        for category, count in e.objects:
            category = IN_ROOM.get((category, e.type), category)
            wanted[ids[id(e)], category] = wanted.get((ids[id(e)], category), 0) + count
    for e in _ordered(home):
        for category, count in furnishing(e.type).objects.items():
            wanted.setdefault((ids[id(e)], category), count)
    for phrase in said.rooms:
        excluded = [id(e) for p in phrase.excluded for e in home.refs.get(id(p), [])]
        for e in _ordered(home) if phrase.type == "any" else []:
            for category, count in phrase.objects if e.type in LIVED_IN and id(e) not in excluded else []:
                wanted.setdefault((ids[id(e)], category), count)
    counted = {category for _, category in wanted}  # "I collect plants. … ten plants in the living room"
    loose = [(c, n) for c, n in said.loose_objects if [e.type for e in _homes(c, home)][:1] == ["bedroom"]]
    shared = shared_out(loose, [e for e in _ordered(home) if e.type == "bedroom"])
    for room, category, count in shared:
        wanted[ids[id(room)], category] = wanted.get((ids[id(room)], category), 0) + count
    for category, count in said.loose_objects:
        if category in said.uncounted & counted or category in {one for _, one, _ in shared}:
            continue
        if homes := _homes(category, home):
            for one in homes if count == 0 else []:  # "no rugs": in none of the rooms that would have one
                wanted.setdefault((ids[id(one)], category), 0)
            key = ids[id(homes[0])], category
            wanted[key] = wanted.get(key, 0) + count
        elif count:  # what no room could have is as good as banned
            said.unread.append(category.replace("_", " ") or f"{count} objects")
    return [
        AskedObjects(room=room, category=category, count=min(count, 100)) for (room, category), count in wanted.items()
    ]


def _homes(category: str, home: Household) -> list[Entity]:
    """The rooms that furniture stands in where nobody says which, the most usual first."""
    usual = TABLE[category].rooms if category else ()
    if category and not home.of("bedroom") and {"bedroom", "dining_room"} & set(usual):
        return home.of("living_room")
    return ("utility" in usual and home.of("utility")) or [e for kind in usual for e in home.of(kind)]


def _envelope(said: Said) -> Envelope:
    party = [side for role, sides in said.sides if role == "party_wall" for side in sides.split("_")]
    entrance = next((sides.split("_")[0] for role, sides in said.sides if role == "entrance"), None)
    about = {"facades": said.about.facades, "dwelling": said.about.dwelling or "flat"}
    said_so = {"shape": said.shape or "auto", "party_walls": list(dict.fromkeys(party)), "entrance": entrance}
    return Envelope.model_validate(said_so | about)


def complete_program(program: Program) -> Program:
    """A hand-written programme with its missing areas and, unless it is `complete`, its missing links filled."""
    known = {r.id for r in program.rooms}
    for a, b in [*program.links, *program.open_links]:
        if {a, b} - known:
            raise BadInput(
                f"program.links names {sorted({a, b} - known)[0]!r}, which is no room of program.rooms; correct the id"
            )
    links = sorted({edge(a, b) for a, b in [*program.links, *program.open_links]})
    rooms = plain(program).rooms
    if not program.complete or (not links and len(rooms) > 1):
        links = complete_links(rooms, links, set())
    base = typical(rooms, links, {})
    stated = {r.id: r.area for r in rooms if r.area is not None}
    areas = fill(rooms, base, stated, {}, program.total_area)
    rooms = [r.model_copy(update={"area": areas[r.id]}) for r in program.rooms]
    return program.model_copy(update={"rooms": rooms, "links": links})
