"""Furnishes a room: several particles, each object drawn from p(candidate) · exp(−λ φ(candidate)).

This is Eq. 2 without a gradient: the posterior over candidates is shifted by the energies of what they break, so that
rooms keep to what the model thinks likely. A particle that can go nowhere begins again, at most `BEGUN` times.
"""

from collections import Counter
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.layout.relations import across, ahead, corners, exchange, followers, known, lengthened, order, runs
from apartgen.stages.layout.relations.ahead import Ahead
from apartgen.stages.layout.relations.astray import anywhere, somewhere
from apartgen.stages.layout.relations.beds import narrower
from apartgen.stages.layout.relations.dining import others
from apartgen.stages.layout.relations.instead import alternatives
from apartgen.stages.layout.relations.propose import Ask, Particle, Said, Speaker, merged, propose
from apartgen.stages.layout.relations.sizes import narrowest
from apartgen.stages.layout.relations.standing import BROKEN, CUT, Furniture
from apartgen.stages.layout.relations.tokens import Array
from apartgen.stages.use import kinds

BEGUN = 3
"""How often a room is begun at most; once more with only those units of a run that it cannot do without."""
TRIES = 2
"""How often candidates are drawn for an object before its room is begun again; once more for what is to be large."""
LOOKS, LAST = 8, 40
"""Candidates whose ways are looked at before new ones are drawn, and where none will be."""
YIELDS = frozenset({"armchair"})
"""What is left out rather than put where the table finds no place with its chairs."""
LOUNGED_IN = kinds.EASY - kinds.BEDS | {"coffee_table", "side_table"}
"""What a room where one sleeps is rather without than without a bed."""
INSTEAD = {"double_bed": ("single_bed",)}
"""What serves where something needed finds no place at all."""
SAME, ELSEWHERE = 0.05, 0.15
"""A candidate that is no good takes those with it that are so near, m; farther ones where a group finds no place."""
PART, LITTLE = 0.5, 0.2
"""A bed has its wardrobe and both nightstands, a sofa its television and table, where they are placed anyway; where no
bed finds such a place, one of them."""
PARTLY = kinds.BEDS | kinds.SOFAS
GOOD = dict.fromkeys(kinds.TABLES, 1.0) | dict.fromkeys(kinds.DOUBLE, LITTLE)
"""A place among candidates is that good before others are looked for."""
LAMBDA = 0.5
"""λ of Eq. 2, for prices in metres of way: what breaks a requirement costs ten and more, and is not taken at all."""
Floats = NDArray[np.floating[Any]]


@dataclass(frozen=True)
class Room:
    """A room to be furnished: what the model sees of it, its space, what is given, and what was asked for by name."""

    speaker: Speaker
    empty: Furniture
    given: tuple[tuple[str, Array], ...]
    asked: Counter[str]
    counted: bool
    least: tuple[frozenset[str], ...]

    def needs(self, name: str, there: list[str]) -> bool:
        """Whether the room is not what was asked for, or not what it is for, without one more of a category."""
        lacking = any(name in group and not group & set(there) for group in self.least)
        return self.counted or lacking or there.count(name) < self.asked[name]


class Sampler:
    """Particles of one room, stepped together; `contents` draws the names of what a particle is to hold."""

    def __init__(self, room: Room, rng: np.random.Generator, constrained: bool = True, places: str = "model") -> None:
        self.room, self.rng, self.constrained, self.places = room, rng, constrained, places

    def begin(self, left: list[str]) -> Particle:
        """A room with nothing but what is given."""
        furniture = self.room.empty.fork()
        for name, box in self.room.given:
            furniture.add(name, box)
        return Particle(furniture, list(left))

    def steps(self, contents: list[list[str]]) -> Generator[list[Particle], list[Said], list[Particle]]:
        """Finished rooms, of as many lists of contents; those in which something finds no place are given up, as long
        as half of them are left. On the way come those that go on, and what is said of them is sent back."""
        particles: dict[int, Particle] = {i: self.begin(left) for i, left in enumerate(contents)}
        going = [i for i, p in particles.items() if p.left]
        while going:
            said = yield [particles[i] for i in going]
            for i, (name, boxes, weight) in zip(going, said, strict=True):
                if self.places == "random":
                    boxes = anywhere(particles[i].furniture, name, boxes, self.room.speaker.shell, self.rng)
                    weight = np.full(len(boxes), 1 / len(boxes))
                spare = 2 * len(particles) > len(contents) + 1
                further = self._placed(particles[i], name, boxes, weight, contents[i], spare)
                if further is None:
                    del particles[i]
                else:
                    particles[i] = further
            going = [i for i in going if i in particles and particles[i].left]
        return list(particles.values())

    def _placed(self, p: Particle, name: str, boxes: Array, weight: Floats, contents: list[str],
                spare: bool) -> Particle | None:
        """The particle with an object more, or as it is to go on without; None where it is given up, being `spare`."""
        other, found = self._looked_for(p, name, boxes, weight, _without(p.left, name))
        if other != name:
            p.left[p.left.index(name)] = name = other
        if found is None and p.tries + 1 < TRIES + (name in self.room.speaker.large):
            p.tries += 1
            return p
        needed = found is None and self.room.needs(name, p.furniture.names)
        if found is None and spare and needed:
            return None
        if needed and p.begun < BEGUN:
            return self._anew(p, contents)
        if needed or found is None and name == runs.DISHES:
            found = self._instead(p, name, boxes)
        bare = self._bare(name, contents)
        if found is None and needed and p.begun == BEGUN and len(bare) < len(contents):
            return self._anew(p, bare, [f"no place for the {o}; left out"
                                        for o in (Counter(contents) - Counter(bare)).elements() if o != exchange.BASE])
        p.left.remove(name)
        if found is None:
            name, found = self._last_resort(p, name, needed)
        p.tries = 0
        if found is not None and self.constrained:
            found = self.room.empty.space.cut(followers.at_ease(p.furniture, name, found, self.rng))
        given = len(self.room.given)
        if found is not None:
            p.furniture.add(name, found)
        if self.constrained and name in order.runs() and order.runs().isdisjoint(p.left):
            empty, counted = self.room.empty.fork, self.room.counted or exchange.BASE in self.room.asked
            p.furniture = exchange.settled(p.furniture, given, empty, counted)
            if not counted:
                p.furniture = lengthened.run_on(p.furniture, self.room.speaker.shell, given, empty, self.room.asked)
            p.furniture = corners.squared(p.furniture, given, empty)
        if self.constrained and not p.left:
            p.furniture = lengthened.grown(p.furniture, self.room.speaker.large, given, self.room.empty.fork)
            p.furniture = across.watched(p.furniture, given, self.room.empty.fork, self.room.asked)
        return p

    def _looked_for(self, p: Particle, name: str, boxes: Array, weight: Floats,
                    left: Sequence[str]) -> tuple[str, Array | None]:
        """What is put there, and its place: among candidates, the second time anywhere, another thing where that one
        does; a poor place, where little of what follows finds its own, after all others."""
        there, first, second = p.furniture, p.tries == 0, p.tries == 1
        if second and (some := self._fitting(there, name, boxes, left)):
            return some
        enough = 1.0 if first else GOOD.get(kinds.basic(name), 0.0) * second
        found = self._chosen(there, name, boxes, weight, strict=first, left=left, enough=enough)
        if found is None and second:
            if some := self._fitting(there, name, boxes, left, strict=False) or self._another(p, name, boxes, left):
                return some
            found = self._chosen(there, name, boxes, weight, left=left) if enough else None
        return name, found

    def _anew(self, p: Particle, contents: list[str], notes: Sequence[str] = ()) -> Particle:
        again = self.begin(contents)
        again.begun, again.notes = p.begun + 1, list(notes)
        return again

    def _bare(self, name: str, contents: list[str]) -> list[str]:
        """The contents without what the room can do without, for what it cannot: units of a run or a bathroom, what one
        lounges in for a bed; what was asked for stays."""
        if kinds.basic(name) in kinds.BEDS:
            return [other for other in contents if self.room.asked[other] or kinds.basic(other) not in LOUNGED_IN]
        if self.room.counted or name not in order.runs() | kinds.FIXTURES.keys():
            return contents
        return [other for other in contents if self.room.asked[other] or not runs.spare(other)]

    def _chosen(self, there: Furniture, name: str, boxes: Array, weight: Floats, loose: bool = False,
                strict: bool = False, left: Sequence[str] = (), enough: float = 0.0,
                looks: int = LOOKS) -> Array | None:
        """A candidate that breaks nothing, drawn by its shifted weight; None where there is none. One that leaves no
        room for what of its run or group is `left` to come is taken only where there is no other, that for most of it,
        and where it leads a group, for `enough` of it."""
        if not self.constrained:
            return np.asarray(boxes[self._draw(weight)])
        rest = Ahead(there, ahead.needed(left, there.names), self.room.speaker.shell)
        boxes, weight = merged(boxes, weight)
        if self.places == "model":
            boxes, weight = known.further(there, name, boxes, weight, self.room.speaker.shell)
        price = there.prices(name, boxes, loose, strict)
        shift = np.exp(-LAMBDA * (price + across.price(there, name, boxes, left)))
        weight = np.where(price < BROKEN, weight * shift, 0.0)
        second, best, near = None, -1.0, SAME
        for _ in range(looks):
            if weight.sum() <= 0:
                break
            k = self._draw(weight)
            if there.shuts(name, boxes[k], loose) < CUT:
                share = followers.fit(there, name, boxes[k], left)
                near = SAME if share == 1 else ELSEWHERE
                if share == 1 and rest.leaves_room(name, boxes[k]):
                    return np.asarray(boxes[k])
                if share > best and share >= enough and not self._spare(name):
                    second, best = np.asarray(boxes[k]), share
            weight[np.abs(boxes[:, :2] - boxes[k, :2]).max(1) < near] = 0.0
        return second

    def _spare(self, name: str) -> bool:
        """Whether something is left out rather than put where it takes the place of what is to come."""
        return runs.spare(name) or kinds.basic(name) in YIELDS and not self.room.asked[name]

    def _fitting(self, there: Furniture, name: str, boxes: Array, left: Sequence[str],
                 strict: bool = True) -> tuple[str, Array] | None:
        """A place for what leads a group, anywhere in the room, where what follows it finds its own, also for a
        smaller one, or another table; else, if one is not `strict`, where most of that does."""
        first = name, followers.leading(name, boxes, there.space, narrowest(self.room.speaker.large, name))
        tables = [some for some in others(name, boxes, there.space, left)
                  if some[0] == name or not self.room.asked[name]]
        beds = narrower(name, boxes, there.space)
        for other, places in [first, *tables] if strict else [first, *beds] if beds else tables[-1:]:
            if (found := self._one_of(there, other, places, left, strict)) is not None:
                return other, found
        return None

    def _one_of(self, there: Furniture, name: str, places: Array, left: Sequence[str],
                strict: bool = True) -> Array | None:
        if not self.constrained or self.places != "model" or not len(places):
            return None
        weight, kind = followers.likely(there, name, places, left), kinds.basic(name)
        enough = (PART if kind in PARTLY else 1.0) if strict else LITTLE * (kind in PARTLY)
        looks = LAST if weight.max() == 1 or not strict else LOOKS
        return self._chosen(there, name, places, weight, strict=strict, left=left, enough=enough, looks=looks)

    def _another(self, p: Particle, name: str, boxes: Array, left: Sequence[str]) -> tuple[str, Array] | None:
        """What serves as well where nothing but its own kind of it found no place, as a wardrobe with sliding doors."""
        some = [] if self.room.asked[name] else alternatives(name, boxes, p.furniture, self.room.speaker.large)
        for other, places in some:
            if (found := self._one_of(p.furniture, other, places, left)) is not None:
                return other, found
        return None

    def _draw(self, weight: Floats) -> int:
        total = weight.cumsum()
        return int(min(total.searchsorted(self.rng.random() * total[-1], "right"), len(weight) - 1))

    def _instead(self, p: Particle, name: str, boxes: Array) -> Array | None:
        """The place of a unit that gives way, which is left out with what stands on it."""
        names, there = p.furniture.names, p.furniture.boxes
        for k in reversed(range(len(self.room.given), len(names) if name in order.runs() else 0)):
            some = runs.in_place(name, boxes, there[k])
            if self.room.asked[names[k]] or not runs.gives_way(names, there, k, name) or not len(some):
                continue
            rest = self.room.empty.fork()
            for i in np.flatnonzero(~runs.carried(there, k)):
                rest.add(names[i], there[i])
            found = self._chosen(rest, name, some, np.full(len(some), 1 / len(some)))
            if found is not None:
                p.furniture = rest
                p.notes.append(f"no place for the {names[k]}; left out")
                return found
        return None

    def _last_resort(self, p: Particle, name: str, needed: bool) -> tuple[str, Array | None]:
        """Anywhere, and smaller, for what is needed, or a bed of one for two; else it is left out. All that is said."""
        for other in (name, *INSTEAD.get(name, ())) if needed else ():
            for scale in (1.0, 0.85, 0.7):
                boxes = somewhere(p.furniture, other, scale, self.room.speaker.shell, self.rng)
                weight = np.full(len(boxes), 1 / len(boxes))
                found = self._chosen(p.furniture, other, boxes, weight, loose=True, looks=LAST)
                if found is not None:
                    how = " where such things stand; put where it fits" if other == name else f"; a {other} instead"
                    p.notes.append(f"no place for the {name}{how}")
                    return other, found
        p.notes.append(f"no place for the {name}; left out")
        return name, None


def _without(left: Sequence[str], name: str) -> list[str]:
    some = list(left)
    some.remove(name)
    return some


def furnished(rooms: Sequence[tuple[Sampler, list[list[str]]]]) -> list[list[Particle]]:
    """Finished rooms of each sampler, of as many lists of contents; all are stepped together."""
    steps = [sampler.steps(contents) for sampler, contents in rooms]
    done: list[list[Particle]] = [[] for _ in rooms]
    said: dict[int, list[Said] | None] = dict.fromkeys(range(len(rooms)))
    while said:
        asks = dict[int, Ask]()
        for k, words in said.items():
            try:
                going = next(steps[k]) if words is None else steps[k].send(words)
            except StopIteration as end:
                done[k] = end.value
            else:
                asks[k] = Ask(rooms[k][0].room.speaker, going, rooms[k][0].rng)
        said = dict(zip(asks, propose(list(asks.values())), strict=True))
    return done
