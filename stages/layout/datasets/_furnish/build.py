"""Carries out the rules in one room: a set-up's core in order, then extras until the count is reached."""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.random import Generator

from apartgen.stages.layout.datasets._furnish import kitchen, prefer, sizes
from apartgen.stages.layout.datasets._furnish.pose import hangs, prior
from apartgen.stages.layout.datasets._furnish.poses import PLACES
from apartgen.stages.layout.datasets._furnish.shape import Shape
from apartgen.stages.layout.datasets._furnish.space import Space
from apartgen.stages.layout.datasets._furnish.step import Setup, Step, floor_for, most_of, setups, use_of
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import belong_together

ATTEMPTS = 5
NOISE = 0.35
"""Spread of taste among possible poses, in units of their preference, m."""
CANDIDATES = 160
GROUP_TRIES = 3
COUNT_SPREAD = 0.42
LOOKS = 5
"""How many of the liked poses are tried for passage."""
MATCHING = (
    "nightstand", "chair", "stool", "bookshelf", "balcony_chair", "shelving", "curtain", "armchair", "table_lamp",
)
"""What people buy several of the same."""


@dataclass
class Builder:
    """A room in the making."""

    space: Space
    rng: Generator
    count: int
    models: dict[str, Array] = field(default_factory=dict)
    missed: int = 0

    @property
    def full(self) -> bool:
        """Whether all that was wanted stands."""
        return self.space.n >= self.count

    def run(self, step: Step) -> None:
        """Carry out one rule, chance and repeats included."""
        few = self.count - self.space.n < max(step.slots, step.need + 1)
        if few or self.rng.random() > step.chance or self.space.shape.area < step.least:
            return
        for _ in range(int(self.rng.integers(step.repeat[0], step.repeat[1] + 1))):
            if self.full:
                return
            if not any(self._group(step) for _ in range(GROUP_TRIES if step.need else 1)):
                return

    def _group(self, step: Step) -> bool:
        """Place one object and what follows it; undone where too little of that finds a place."""
        i = self.put(step)
        if i < 0:
            return False
        for after in step.then:
            self.run(after if after.of else replace(after, anchor=i))
        if self.space.n - i - 1 < step.need:
            self.space.drop_last(i)
            return False
        return True

    def put(self, step: Step) -> int:
        """Place one object; its index, -1 where nothing fits."""
        if step.at == "run":
            before = self.space.n
            kitchen.furnish(self.space, self.count, self.rng)
            return self.space.n - 1 if self.space.n > before else -1
        for lean in (step.size, -0.5, -1.0):
            name = str(self.rng.choice(step.put))
            small = self.space.shape.area < floor_for(name)
            if small or len(self.space.find(step.put)) >= most_of(step, name, self.space.shape.type):
                continue
            size = self._size(name, lean, fresh=lean != step.size)
            i = self._try(name, size, step)
            if i >= 0:
                return i
        return -1

    def _size(self, name: str, lean: float | None, fresh: bool) -> Array:
        if name not in MATCHING:
            return sizes.draw(name, self.rng, lean)
        if fresh or name not in self.models:
            self.models[name] = sizes.draw(name, self.rng, lean)
        return self.models[name].copy()

    def _try(self, name: str, size: Array, step: Step) -> int:
        space, rng = self.space, self.rng
        at, partner = PLACES[step.at](space, name, size, step, rng)
        at = at.take(hangs(name, at, space))
        if at.n > CANDIDATES:
            at = at.take(rng.permutation(at.n)[:CANDIDATES])
        if step.loose and step.at in ("wall", "corner"):
            at.center[:, :2] += rng.uniform(-0.5, 0.5, (at.n, 2)) * step.loose
        use = use_of(step, name)
        if partner >= 0 and not belong_together(name, space.category[partner]):
            partner = -1
        at = at.take(space.fits(name, at, use, partner))
        if not at.n:
            return -1
        liking = prior(step, at.n)
        for feature, weight in step.prefer.items():
            liking = liking + weight * prefer.FEATURES[feature](space, at, step)
        for k in np.argsort(-(liking + rng.gumbel(0, NOISE, at.n)))[:LOOKS]:
            if space.stays_open(name, at.take([k])):
                return space.add(name, at.take([k]), use, step.gap[0] if step.at == "wall" else 0.0)
        return -1


def furnish(
    shape: Shape, rng: Generator, count: int | None = None, must: tuple[tuple[str, ...], ...] = ()
) -> Space:
    """A furnished room; `count` objects at most, drawn from the set-up's range when None.

    `must`: of each of these sets of categories at least one, beyond what the room's rules say, where it finds a place.
    """
    best, most = Space(shape), -1.0
    for _ in range(ATTEMPTS):
        setup = _draw(shape, rng, must)
        wanted = count if count is not None else _count(setup, shape, rng)
        builder = Builder(Space(shape), rng, wanted)
        cored = _carry_out(builder, setup)
        score = builder.space.n / max(wanted, 1) + cored
        if score > most:
            best, most = builder.space, score
        if cored and builder.space.n >= 0.8 * wanted:
            break
    return best


def _draw(shape: Shape, rng: Generator, must: tuple[tuple[str, ...], ...]) -> Setup:
    able = [replace(s, must=s.must + must) for s in setups(shape.type) if all(s.puts(names) for names in must)]
    able = able or list(setups(shape.type))
    fitting = [s for s in able if s.least <= shape.area <= s.most] or able
    weight = np.array([s.weight for s in fitting])
    return fitting[int(rng.choice(len(fitting), p=weight / weight.sum()))]


def _count(setup: Setup, shape: Shape, rng: Generator) -> int:
    """Objects wanted: around what is usual for the floor area, widely spread."""
    least, per_area, most = setup.count
    usual = least + per_area * shape.area
    wanted = round(usual * rng.lognormal(0, COUNT_SPREAD))
    if wanted > most:
        wanted = round(rng.uniform(min(usual, most), most))
    return int(max(2, least - 1, wanted))


def _carry_out(builder: Builder, setup: Setup) -> bool:
    """Place core and extras; whether the room has what a room of its kind cannot do without."""
    for step in setup.core:
        builder.run(step)
    have = set(builder.space.category)
    cored = all(have & set(names) for names in setup.must) and bool(have)
    left = list(setup.extra)
    while left and not builder.full:
        weight = np.array([step.weight for step in left])
        k = int(builder.rng.choice(len(left), p=weight / weight.sum()))
        builder.run(left.pop(k))
    return cored
