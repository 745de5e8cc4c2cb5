"""A programme as the arrays the solver anneals, and the random trees it starts from."""

from collections import deque
from dataclasses import dataclass
from itertools import pairwise
from math import sqrt

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import AskedRoom, Program, Walls
from apartgen.stages.plan.blocks import Outline
from apartgen.stages.plan.check import entrance_room, links, neighbours
from apartgen.stages.plan.outline import wish
from apartgen.stages.plan.slicing import Ints, Problem, Scratch, Tree
from apartgen.stages.plan.standards import LINK_WALL, STANDARDS
from apartgen.stages.plan.weights import WEIGHTS

WET, WHIM, MEALS = 1, 6, 24
"""What it counts that wet rooms, rooms of a draw, and kitchen and dining room are near one another."""
ODD = 0.6
"""Share of large rooms that are made of two rectangles where nothing need be regular."""

Pair = tuple[int, int, int]
"""Two rooms that should be near one another, and how much that counts."""


@dataclass(frozen=True)
class Slack:
    """How far the requirements are relaxed; the defaults are not relaxed at all."""

    area: float = 0.12
    aspect: float = 1.0
    envelope: bool = False


@dataclass(frozen=True)
class Whim:
    """What the programme leaves open, drawn once for many runs: it is what makes two seeds differ."""

    parts: tuple[int, ...]
    near: list[Pair]
    shape: str
    aspect: float


def whim(program: Program, rng: Generator) -> Whim:
    """A corridor of one to three rectangles, few other rooms of two, pairs of rooms to be near, an outline."""
    rooms = [i for i, r in enumerate(program.rooms) if r.type != "hallway"]
    pairs = [rng.choice(rooms, 2, replace=False) for _ in range(3 if len(rooms) > 1 else 0)]
    shape, aspect = wish(program.envelope, program.regularity, rng)
    wanted = areas(program)
    parts = tuple(_parts(program, room, wanted[room.id], rng) for room in program.rooms)
    return Whim(parts, [(int(a), int(b), WHIM) for a, b in pairs], shape, aspect)


def _parts(program: Program, room: AskedRoom, area: float, rng: Generator) -> int:
    if room.type != "hallway":
        return 2 if area >= 9 and rng.random() < ODD * (1 - program.regularity) ** 1.5 else 1
    doors = sum(room.id in pair for pair in links(program))
    many = min(doors / 8, 1.0)
    return int(rng.choice([1, 2, 3], p=[1 - 0.85 * many, 0.45 * many, 0.4 * many]))


def areas(program: Program) -> dict[str, float]:
    """Net area wanted of every room, at least the least of its type."""
    return {r.id: max(r.area or 1.6 * STANDARDS[r.type].area, STANDARDS[r.type].area) for r in program.rooms}


def gross_area(program: Program, walls: Walls) -> float:
    """Floor and walls of all rooms between wall centre lines, taking rooms of aspect 1.4."""
    return sum(a + 2.03 * sqrt(a) * walls.inner + walls.inner**2 for a in areas(program).values())


def problem(program: Program, outline: Outline, whim: Whim, walls: Walls, slack: Slack) -> Problem:
    """Arrays for one run; of the programme within an outline."""
    rooms, wanted = program.rooms, areas(program)
    index = {r.id: i for i, r in enumerate(rooms)}
    joined = {r for pair in program.open_links for r in pair}
    spec = [
        _spec(room, wanted[room.id], 2.0 + 2 * many, room.id in joined, slack)
        for room, many in zip(rooms, whim.parts, strict=True)
    ]
    return Problem(
        spec=np.array(spec),
        links=np.array([(index[a], index[b]) for a, b in links(program)], np.int64).reshape(-1, 2),
        near=weighed([*_near(program), *whim.near]),
        order=_ways(program, index),
        blocks=outline.blocks,
        edges=outline.edges,
        weights=np.array([w * program.weights.get(name, 1.0) for name, w in WEIGHTS.items()]),
        limits=np.array([*outline.stretch, walls.inner, LINK_WALL + walls.inner, LINK_WALL + walls.inner + 0.1]),
    )


def _spec(room: AskedRoom, area: float, corners: float, joined: bool, slack: Slack) -> tuple[float, ...]:
    norm = STANDARDS[room.type]
    passage = room.type in ("hallway", "balcony")
    return (
        area,
        2.5 * slack.area if room.type == "hallway" else slack.area,
        min(norm.width, 0.95 * np.sqrt(area)),
        min(norm.width, 1.5),
        norm.aspect * slack.aspect,
        0.02 if passage else 1.0,
        corners,
        0.0 if room.type == "kitchen" and joined else norm.face,
        room.type == "hallway",
        norm.functional,
        norm.outer,
    )


def _near(program: Program) -> list[Pair]:
    """Pairs that should be close: each wet room and the one before it, kitchen and dining room."""
    types = [r.type for r in program.rooms]
    wet = [i for i, t in enumerate(types) if STANDARDS[t].wet]
    meals = [(i, j) for i, a in enumerate(types) for j, b in enumerate(types) if (a, b) == ("kitchen", "dining_room")]
    return [*((i, j, WET) for i, j in pairwise(wet)), *((i, j, MEALS) for i, j in meals)]


def weighed(pairs: list[Pair]) -> Ints:
    """Each pair once (q, 3), in the order it first stands in, with the sum of what it counts."""
    total: dict[tuple[int, int], int] = {}
    for a, b, count in pairs:
        pair = (min(a, b), max(a, b))
        total[pair] = total.get(pair, 0) + count
    return np.array([(*pair, count) for pair, count in total.items()], np.int64).reshape(-1, 3)


def _ways(program: Program, index: dict[str, int]) -> Ints:
    """Rooms breadth first from the entrance, with the room before each and the link between them (n, 3)."""
    near = neighbours(program)
    number = {frozenset(pair): i for i, pair in enumerate(links(program))}
    first = entrance_room(program).id
    before = {first: (-1, -1)}
    queue, order = deque([first]), []
    while queue:
        here = queue.popleft()
        order.append(here)
        for there in near[here]:
            if there not in before:
                before[there] = index[here], number[frozenset((here, there))]
                queue.append(there)
    return np.array([(index[room], *before[room]) for room in order], np.int64)


def start(program: Program, parts: tuple[int, ...], stretch: tuple[float, float], rng: Generator) -> Tree:
    """A random tree over the rooms' parts."""
    wanted = list(areas(program).values())
    room = np.repeat(np.arange(len(parts)), parts)
    share = np.concatenate([wanted[i] * rng.dirichlet(np.full(k, 6.0)) for i, k in enumerate(parts)])
    leaves = len(room)
    nodes = np.zeros((2 * leaves, 3), np.int64)
    nodes[:leaves, 0] = room
    loose = list(rng.permutation(leaves))
    for cut in range(leaves, 2 * leaves - 1):
        left, right = (loose.pop(int(rng.integers(len(loose)))) for _ in range(2))
        nodes[cut] = left, right, rng.integers(2)
        loose.append(cut)
    nodes[-1, 0] = loose[0]
    return Tree(nodes, np.append(share, np.clip(1.0, *stretch)))


def copy(tree: Tree) -> Tree:
    """An independent copy."""
    return Tree(tree.nodes.copy(), tree.share.copy())


def scratch(n: int, links: int, leaves: int, k: int) -> Scratch:
    """Room for the measures of a state of `n` rooms in an outline of `k` blocks."""
    return Scratch(
        box=np.zeros((2 * leaves - 1, 5)),
        seq=np.zeros(2 * leaves, np.int64),
        piece=np.zeros((leaves * k, 4)),
        owner=np.zeros(leaves * k, np.int64),
        last=np.zeros(n, np.int64),
        before=np.zeros(leaves * k, np.int64),
        wall=np.zeros((links, 3)),
        room=np.zeros((n, 13)),
        terms=np.zeros(15),
        entry=np.zeros(4),
        walked=np.zeros((n, 3)),
        area=np.zeros(n),
    )
