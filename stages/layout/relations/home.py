"""Furnishes an apartment with the relations model, each room by itself: the best of K samples."""

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.random import Generator

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan, Room
from apartgen.stages import seeds
from apartgen.stages.layout import choice, wishes
from apartgen.stages.layout import rooms as room_arrays
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.layout.meals import AROUND, table_of
from apartgen.stages.layout.projection.paths import walked_in
from apartgen.stages.layout.projection.space import space_of
from apartgen.stages.layout.relations import contents, features, furnishings, living, sampler, sizes, weights
from apartgen.stages.layout.relations.living import BASKET
from apartgen.stages.layout.relations.propose import Particle, Speaker
from apartgen.stages.layout.relations.sampler import Room as Task
from apartgen.stages.layout.relations.sampler import Sampler
from apartgen.stages.layout.relations.standing import Furniture
from apartgen.stages.layout.relations.tokens import Array, shell
from apartgen.stages.layout.relations.told import Rules, as_asked
from apartgen.stages.layout.rooms import UNKNOWN, Rooms
from apartgen.stages.layout.sense import sense
from apartgen.stages.things.categories import CATEGORIES, stand_in
from apartgen.stages.things.latents import style_latents
from apartgen.stages.use import arrivals, belongings, eat_together, lacks_of, site
from apartgen.stages.use.household import duties, sleepers
from apartgen.stages.use.kinds import COATS, TABLES, basic
from apartgen.stages.use.site import Site

FRAMES, BRANCHES, OFFSETS = 2, 4, 24
"""References of an object that are tried at once, branches of each, offsets of every branch: some 200 candidates."""

DRAWN = 6
"""Contents drawn for every sample, where several are made: those are furnished that lack least."""
GOOD, POOR, SHARED = 0.3, 1.0, 0.7
"""Energies of the best of half of a room's K samples, and of K: above, the other half, and K more, are drawn; of a room
that all share already above this share of it."""
SELDOM = frozenset({"living_room", "kitchen"})
"""Of few of these one sample leaves nothing to wish for, as it does in three of five bedrooms and bathrooms."""
HOOKS = "coat_rack"
"""What takes coats where a cupboard finds no place."""
BATHS, BATHED = frozenset({"shower", "bath"}), 2.8
"""One of these is in a bathroom of so much floor, m²."""
UNMET = 30.0
"""What it costs that something was asked for and is not there: more than all that a room may lack."""
SHARP, SURE = 3.0, 2.0
"""What logits of attributes, and of references, are multiplied with before anything is drawn."""


def furnished(plan: Plan, config: LayoutConfig, rng: Generator, given: Sequence[Box] = ()) -> tuple[Layout, list[str]]:
    """One apartment, and what is to be said about it; `given` objects stay, and `config.room` names the rooms to do."""
    home = seeds.lane(rng, "home")
    arrays = room_arrays.of_plan(plan, home.random())
    style = int(home.integers(1 << 16))
    due = [i for i, room in enumerate(plan.rooms) if not config.room or room.id in config.room]
    there = {i: [] if config.room else [o for o in given if o.room == plan.rooms[i].id] for i in due}
    chances = {i: seeds.lane(rng, plan.rooms[i].id + " habits").random(len(living.WAYS)).tolist() for i in due}
    ways = {i: living.draw(plan, plan.rooms[i], chances[i]) for i in due}
    spared = {i: living.forgone(site(plan, plan.rooms[i].id), ways[i]) for i in due}
    tasks = {i: _task(plan, i, arrays, config, there[i]) for i in due}
    best: dict[int, Furnished] = {}
    left = {i: _rounds(config.candidates, plan.rooms[i].base) for i in due}
    while some := [i for i in due if left[i] and (i not in best or best[i].cost > left[i][0].above + spared[i])]:
        rounds = [left[i].pop(0) for i in some]
        rooms = [_sampler(plan, tasks[i], i, arrays, config, round.samples,
                          seeds.lane(rng, plan.rooms[i].id + round.name), there[i], ways[i])
                 for i, round in zip(some, rounds, strict=True)]
        for i, made in zip(some, sampler.furnished(rooms), strict=True):
            one = _best(plan, plan.rooms[i], made, arrays.origin[i], style, there[i])
            best[i] = min(best.get(i, one), one, key=lambda one: one.cost)
    objects: list[Box] = []
    notes: list[str] = []
    for i, room in enumerate(plan.rooms):
        if i not in best:
            objects += [o for o in given if o.room == room.id]
            continue
        objects += best[i].objects
        notes += [f"{room.id}: {note}" for note in best[i].notes]
        if lacks := wishes.unmet(plan.program, room.id, best[i].objects):
            notes.append(f"{room.id}: has {'; '.join(lacks)}")
    return Layout(**plan.model_dump(include=set(Plan.model_fields)), objects=objects), notes


class Round(NamedTuple):
    """Samples of a room, drawn from a lane of that name, where its best so far has more energy than that."""

    name: str
    samples: int
    above: float = 0.0


def _rounds(candidates: int, base: str | None) -> list[Round]:
    """What is drawn of a room of a type, one round after another; nothing is better than what has no energy."""
    if candidates == 1:
        return [Round("", 1)]
    half, poor = -(-candidates // 2), POOR * (SHARED if base == "living_room" else 1.0)
    first = [Round("", half)] if base in SELDOM or half == 1 else [Round("", 1), Round(" besides", half - 1)]
    return [*first, Round(" once more", candidates - half, GOOD), Round(" again", candidates, poor)]


NO_LIGHT = {"plant": 0}
"""What is not kept where no daylight comes, unless it is asked for."""


class Furnished(NamedTuple):
    """A furnishing of a room: its objects, what is to be said about it, and its energy."""

    objects: list[Box]
    notes: list[str]
    cost: float


def _best(plan: Plan, room: Room, made: Sequence[Particle], origin: Array, style: int, given: list[Box]) -> Furnished:
    """The sample of least energy, the first of equals."""
    second = living.called(wishes.of_room(plan.program, room.id))
    some = [(_boxes(room, p, origin, style, given, second), [living.in_words(note, second) for note in p.notes])
            for p in made]
    rows = [Furnished(found, notes, choice.cost(plan, room.id, found)
                      + UNMET * len(wishes.unmet(plan.program, room.id, found))) for found, notes in some]
    return min(rows, key=lambda row: row.cost)


def _sampler(plan: Plan, task: Task, i: int, arrays: Rooms, config: LayoutConfig, k: int, rng: Generator,
             given: list[Box], ways: Sequence[Mapping[str, int]]) -> tuple[Sampler, list[list[str]]]:
    """What furnishes a room, and the contents of each of its k samples."""
    room = plan.rooms[i]
    place = site(plan, room.id)
    asked = wanted_of(arrays, i, plan, room)
    told = {o.category for o in given} | {name for name in asked if asked[name]}
    own = living.unless_told(ways, told | ({"armchair"} if asked["sofa"] > 1 else set()))
    wanted = living.settled({**_kept(plan, place, given), **_long_table(plan, room), **(NO_LIGHT if place.dark else {}),
                             **{name: count for name, count in own.items() if name != BASKET},
                             **({} if given else wishes.of_sleepers(plan.program, room.id, place.area)),
                             **furnishings.idle(wishes.of_room(plan.program, room.id), (o.category for o in given),
                                                room.base), **asked}, (o.category for o in given))
    rules = Rules(task.speaker.known, _least(room, float(arrays.area[i])), wanted, living.never(plan, room))
    lanes = rng.spawn((DRAWN * k if config.candidates > 1 else 1) + 1)
    drawn = _contents(task, rules, arrays, i, plan, room, lanes[1:])
    if room.id not in plan.program.counts and asked.get(HOOKS, UNKNOWN) != 0:
        drawn = [_hung(place, given, some) for some in drawn]
    if room.id not in plan.program.counts and not given:
        diners = eat_together(place) if place.meals else 0
        drawn = [furnishings.completed(some, asked, room.base, place.area, diners) for some in drawn]
    if room.id not in plan.program.counts and BASKET in own:
        drawn = [[name for name in some if name != BASKET] + [BASKET] * own[BASKET] for some in drawn]
    names = sorted(drawn, key=lambda some: _lacking(place, task, some))[:k]
    return Sampler(task, lanes[0], config.constraints, config.places), names


def _task(plan: Plan, i: int, arrays: Rooms, config: LayoutConfig, given: list[Box]) -> Task:
    model, known, _ = weights.load(Path(config.weights) if config.weights else None)
    room, walls = plan.rooms[i], shell(arrays, i)
    told, due = sleepers(plan), duties(plan, room)
    facts = features.room_facts(float(arrays.area[i]), float(arrays.height[i]), -1 if told is None else told)
    type_ = known.type(room.base)
    speaker = Speaker(model, known, walls, type_, facts, FRAMES, BRANCHES, OFFSETS, SHARP, SURE,
                      large=sizes.least(room.base, float(arrays.area[i]), due, told or 0))
    asked = living.settled(wanted_of(arrays, i, plan, room), (o.category for o in given))
    least = _least(room, float(arrays.area[i]))
    if (table := table_of(plan)) and table[0] == room.id:  # whichever of them finds a place
        least, asked = (*least, TABLES), Counter({name: n for name, n in asked.items() if name not in TABLES})
    empty = Furniture(space_of(arrays, i), walked_in(room.base))
    return Task(speaker, empty, tuple((o.category, _row(o, arrays.origin[i])) for o in given), asked,
                room.id in plan.program.counts, least)


def _row(o: Box, origin: Array) -> Array:
    """A given object as a token's box in the room's frame."""
    x, y, z = o.center
    d, w, h = o.size
    return np.array([x - origin[0], y - origin[1], o.yaw, d, w, z - h / 2, z + h / 2], np.float32)


def _least(room: Room, area: float) -> tuple[frozenset[str], ...]:
    """Of what a room of its type is never without, by `sense.toml`, and where one washes, not in a toilet alone."""
    kind = ROOM_TYPES.index(room.base)
    bath = [BATHS] if room.base == "bathroom" and area >= BATHED else []
    return (*(frozenset(CATEGORIES[c] for c in group) for group in sense().least[kind]), *bath)


def wanted_of(arrays: Rooms, i: int, plan: Plan, room: Room) -> Counter[str]:
    """Objects asked for by category, those of the programme and the home's table; 0 where there are to be none."""
    wanted = Counter({CATEGORIES[c]: int(k) for c, k in enumerate(arrays.wanted[i]) if k != UNKNOWN})
    asked = wishes.of_room(plan.program, room.id)
    for category, count in asked.items():
        if count and basic(category) not in asked:
            wanted[basic(category)] = 0  # what is like it comes in its place, not beside it
        wanted[category] = count
    return wanted


def _kept(plan: Plan, place: Site, given: list[Box]) -> Counter[str]:
    """What the room is to hold for the whole home, unless there is no place; nothing where things are counted."""
    if place.id in plan.program.counts:
        return Counter()
    there = {o.category for o in given}
    coats = [] if COATS & there or place.kind == "hallway" else arrivals(place)
    return Counter(name for name in (*belongings(place), *coats) if name not in there)


def _hung(place: Site, given: list[Box], names: list[str]) -> list[str]:
    """Contents of a hall that one enters, with hooks beside a cupboard, which may find no place."""
    lacking = HOOKS in arrivals(place) and not COATS & {o.category for o in given} and HOOKS not in names
    return [*names, HOOKS] if place.kind == "hallway" and lacking else names


def _long_table(plan: Plan, room: Room) -> Counter[str]:
    """No round table where more eat than find a seat at one."""
    many = duties(plan, room).eats > 0 and (sleepers(plan) or 0) > AROUND
    return Counter({"round_table": 0}) if many else Counter()


def _contents(task: Task, rules: Rules, arrays: Rooms, i: int, plan: Plan, room: Room,
              rngs: list[Generator]) -> list[list[str]]:
    """Names of what samples of a room are to hold beyond what is given."""
    known = task.speaker.known
    there, asked = np.zeros((2, len(known.categories)), np.int64)
    for name, _ in task.given:
        there[known.category(name)] += 1
        asked[known.category(name)] += name in known.categories
    wanted = np.where(rules.wanted >= 0, np.maximum(rules.wanted - asked, 0), UNKNOWN)
    likes = list((Counter(rules.likes) - Counter(name for name, _ in task.given)).elements())
    for name in likes:  # drawn as what it is like, in its turn
        wanted[known.category(name)] = max(wanted[known.category(name)], 0) + 1
    count = plan.program.counts.get(room.id, UNKNOWN)
    if count != UNKNOWN:
        count = max(0, count - len(task.given))
    told = sleepers(plan)
    facts = contents.facts(task.speaker.shell.boxes, task.speaker.shell.kind, float(arrays.area[i]),
                           -1 if told is None else told, duties(plan, room))
    model, type_ = task.speaker.model.contents, task.speaker.type
    drawn = contents.draw(model, type_, facts, count, wanted, rules.drawn, rngs, there)
    return [as_asked([known.categories[c] for c in one], likes) for one in drawn]


def _lacking(place: Site, task: Task, names: list[str]) -> float:
    """What a room with these contents and those given lacks."""
    return sum(lack.cost for lack in lacks_of(place, [*names, *(name for name, _ in task.given)]))


def _boxes(room: Room, p: Particle, origin: Array, style: int, given: list[Box],
           called: Mapping[str, str]) -> list[Box]:
    """A finished room's objects in the world, those given as they were, others as they are `called`."""
    out, taken, seen = list(given), {o.id for o in given}, Counter[str]()
    for spoken, box in list(zip(p.furniture.names, p.furniture.boxes.astype(float), strict=True))[len(given):]:
        name = called.get(spoken, spoken)
        seen[name] += 1
        while (id_ := f"{room.id}_{name}_{seen[name]}") in taken:
            seen[name] += 1
        x, y, yaw, depth, width, low, high = box
        yaw = (yaw + np.pi) % (2 * np.pi) - np.pi
        out.append(Box(
            id=id_, room=room.id, category=name, yaw=round(float(yaw), 5),
            center=(round(float(x + origin[0]), 4), round(float(y + origin[1]), 4), round(float(low + high) / 2, 4)),
            size=(round(float(depth), 4), round(float(width), 4), round(float(high - low), 4)),
            latent=_latent(name, style)))
    return out


def _latent(name: str, style: int) -> list[float]:
    """The shape latent of a category in the home's style."""
    names, _ = style_latents(model := stand_in(name, CATEGORIES) or name)
    return list(_rounded(model, style % len(names))) if names else []


@cache
def _rounded(model: str, style: int) -> tuple[float, ...]:
    return tuple(round(float(v), 3) for v in style_latents(model)[1][style])


def check(rooms: Collection[str], plan: Plan) -> list[str]:
    """Names of rooms that a plan does not have."""
    return sorted(set(rooms) - {room.id for room in plan.rooms})
