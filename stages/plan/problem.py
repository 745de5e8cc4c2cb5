"""A programme as the arrays the solver anneals, and the random trees it starts from."""

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from math import sqrt

import numpy as np
from numpy.random import Generator

from apartgen.schemas.plan import AskedRoom, Envelope, Program, Walls
from apartgen.stages.plan.balconies import fronts, indoors, overlooked
from apartgen.stages.plan.blocks import Outline
from apartgen.stages.plan.check import entrance_room, links, neighbours
from apartgen.stages.plan.outline import wish
from apartgen.stages.plan.slicing import L_WALL, R_COLUMNS, Ints, Problem, Scratch, Tree
from apartgen.stages.plan.standards import LINK_WALL, STANDARDS
from apartgen.stages.plan.surroundings import surrounded
from apartgen.stages.plan.weights import counted
from apartgen.stages.plan.wished import ADJACENT, APART, SERVING
from apartgen.stages.plan.wishes import placed, wishes

WET, WHIM, MEALS = 3, 3, 24
"""What it counts that wet rooms, rooms of a draw, kitchen and dining room are near one another."""
COOK = 40.0
"""What a metre counts that lacks of the wall between a kitchen without a door to where one eats and that room, while
nothing is given up."""
SERVED = 12.0
"""What a metre counts that the walls for the doors of such a kitchen and of that room are too far apart in a hall."""
CUT_OFF = 0.05
"""Share of draws in which such a kitchen need not lie there."""
PARTED, QUIET = 0.9, 12.0
"""Share of draws in which two bedrooms, where there are no more, had better share no wall (people build a third of them
so that they do), and what a metre of it counts then."""
ODD = (0.6, 2.0)
"""Share of large rooms, and of living rooms, that are made of two rectangles where nothing need be regular."""

HUB, HUB_PARTS, HUB_WITHIN = 4, (0.2, 0.4, 0.4), (0.25, 0.25, 0.25, 0.25)
"""Doors from which on a room of a home that is told whole is a hub, and how often one is of one to three rectangles, of
one to four within a given outline."""

EATEN_IN = ("dining_room", "living_room")
"""Rooms that a kitchen lies at, the best first."""

LONGEST = 0.9
"""No room is made longer than this share of its greatest aspect for the sake of its width."""
ARM, ARM_FREE, ARM_WITHIN = 0.9, 1.5, 1.2
"""Width that each part of a room has at least: in an outline that is drawn for it as a share of its least width, and in
metres; within a given one in metres."""

LEAN = 0.45
"""Part by which a hallway may be smaller than it was thought, at no cost: the floor is better in the rooms."""
LONE, ALONE = 13.0, 5.0
"""What counts against a bathroom without wall on the outline, where the risers are; where places of rooms are told."""
JOG = 0.6
"""Depth up to which a jog of a given outline leaves a room as wide as it is beside it, m."""

Pair = tuple[int, int, int]
"""Two rooms that should be near one another, and how much that counts."""


@dataclass(frozen=True)
class Slack:
    """How far requirements are relaxed, and the shares that wishes and factors of weights count; by default in full."""

    area: float = 0.12
    aspect: float = 1.0
    envelope: bool = False
    heed: float = 1.0
    urge: float = 1.0


@dataclass(frozen=True)
class Whim:
    """What the programme leaves open, drawn once for many runs: it is what makes two seeds differ."""

    parts: tuple[int, ...]
    near: list[Pair]
    shape: str
    aspect: float
    envelope: Envelope = field(default_factory=Envelope)
    fronts: Mapping[str, float] = field(default_factory=dict)
    beside: list[tuple[int, int]] = field(default_factory=list)
    parted: list[tuple[int, int]] = field(default_factory=list)


def whim(whole: Program, walls: Walls, failed: int, rng: Generator) -> Whim:
    """A corridor of one to three rectangles, few other rooms of two, pairs of rooms to be near, an outline.

    After draws that `failed` there may be more façade.
    """
    program = indoors(whole)
    rooms = [i for i, r in enumerate(program.rooms) if r.type != "hallway"]
    pairs = [rng.choice(rooms, 2, replace=False) for _ in range(3 if len(rooms) > 1 else 0)]
    shape, aspect = wish(program.envelope, program.regularity, len(program.rooms), rng)
    wanted = areas(program)
    parts = tuple(_parts(program, room, wanted[room.id], rng) for room in program.rooms)
    near = [(int(a), int(b), WHIM) for a, b in pairs]
    beside = _kitchens(program) if rng.random() >= CUT_OFF else []
    about = surrounded(program, aspect, gross_area(program, walls), failed, rng, overlooked(whole))
    beds = [i for i, room in enumerate(program.rooms) if room.base == "bedroom"]
    parted = [(beds[0], beds[1])] if len(beds) == 2 and not placed(program) and rng.random() < PARTED else []
    return Whim(parts, near, shape, aspect, about, fronts(whole), beside, parted)


def _parts(program: Program, room: AskedRoom, area: float, rng: Generator) -> int:
    if _hub(program, room):
        odds = HUB_PARTS if program.envelope.outline is None else HUB_WITHIN
        return 1 + int(rng.choice(len(odds), p=odds))
    if room.type != "hallway" and program.envelope.outline and any(_hub(program, other) for other in program.rooms):
        return 1  # what a hub bends round
    if room.type != "hallway":
        asked = program.weights.get("conciseness", 1.0) * program.weights.get("convexity", 1.0)
        odd = ODD[room.type == "living_room"] * (1 - program.regularity) / max(asked, 0.5)
        return 1 + int(area >= 9 and rng.random() < odd)
    doors = sum(room.id in pair for pair in links(program))
    many = min(doors / 8, 1.0)
    return int(rng.choice([1, 2, 3], p=[1 - 0.9 * many, 0.7 * many, 0.2 * many]))


def _hub(program: Program, room: AskedRoom) -> bool:
    """Whether most ways lead through a room that is no hallway, since the programme has none beside what it tells."""
    return program.complete and room.type != "hallway" and sum(room.id in pair for pair in links(program)) >= HUB


def areas(program: Program) -> dict[str, float]:
    """Net area wanted of every room, at least the least of its type."""
    return {r.id: max(r.area or 1.6 * STANDARDS[r.base].area, STANDARDS[r.base].area) for r in program.rooms}


def gross_area(program: Program, walls: Walls) -> float:
    """Floor and walls of all rooms between wall centre lines, taking rooms of aspect 1.4."""
    return sum(a + 2.03 * sqrt(a) * walls.inner + walls.inner**2 for a in areas(program).values())


def problem(program: Program, outline: Outline, whim: Whim, walls: Walls, slack: Slack) -> Problem:
    """Arrays for one run; of the rooms indoors within an outline."""
    return within(open_problem(program, whim, walls, slack), outline)


def within(p: Problem, outline: Outline) -> Problem:
    """The arrays of a run with another outline."""
    limits = np.append(outline.stretch, p.limits[L_WALL:])
    return p._replace(blocks=outline.blocks, edges=outline.edges, limits=limits)


def open_problem(program: Program, whim: Whim, walls: Walls, slack: Slack) -> Problem:
    """Arrays for all runs on one whim, without an outline."""
    rooms, wanted = program.rooms, areas(program)
    index = {r.id: i for i, r in enumerate(rooms)}
    joined = {r for pair in program.open_links for r in pair}
    strict, jog = slack == Slack(), 0.0 if program.envelope.outline is None else JOG
    spec = [
        _spec(program, room, wanted[room.id], room.id in joined, whim.fronts.get(room.id, 0.0), slack) for room in rooms
    ]
    return Problem(
        spec=np.array(spec),
        links=np.array([(index[a], index[b]) for a, b in links(program)], np.int64).reshape(-1, 2),
        near=weighed([*_near(program), *whim.near]),
        order=_ways(program, index),
        blocks=np.zeros((0, 4)),
        edges=np.zeros((0, 6)),
        wishes=np.vstack([
            wishes(program) * (1.0, 1.0, 1.0, 1.0, 1.0, slack.heed),
            *((ADJACENT, kitchen, living, 0.0, 0.0, COOK * strict) for kitchen, living in whim.beside),
            *((APART, *pair, 0.0, 0.0, QUIET * strict) for pair in whim.parted),
            *((SERVING, *pair, *doors, SERVED * strict) for pair in whim.beside for doors in _off_one(program, *pair)),
        ]),
        weights=np.array(counted(program.weights, slack.urge)),
        limits=np.array([1.0, 1.0, *(walls.inner + more for more in (0.0, LINK_WALL, LINK_WALL + 0.1)), jog]),
    )


def _spec(
    program: Program, room: AskedRoom, area: float, joined: bool, front: float, slack: Slack
) -> tuple[float, ...]:
    norm = STANDARDS[room.base]
    passage = room.type in ("hallway", "balcony")
    return (
        area,
        2.5 * slack.area if room.type == "hallway" else slack.area,
        min(norm.width, 0.95 * np.sqrt(area)),
        min(norm.width, _arm(program, room)),
        norm.aspect * slack.aspect,
        0.02 if passage else 1.0,
        4.0,
        max(front, 0.0 if room.type == "kitchen" and joined else norm.face),
        room.type == "hallway",
        norm.functional,
        norm.outer,
        {"bedroom": 1.0, "living_room": -1.0}.get(room.type, 0.0),
        (room.type == "bathroom") * (ALONE if placed(program) else LONE),
        max(norm.across, np.sqrt(area / (LONGEST * norm.aspect))) if norm.across else np.inf,
        (room.type == "hallway") * _lean(program),
    )


def _lean(program: Program) -> float:
    """Part by which a hallway may be smaller at no cost: where areas are told it keeps its own."""
    return 0.0 if program.complete or program.weights.get("typical_area", 1.0) > 1 else LEAN


def _arm(program: Program, room: AskedRoom) -> float:
    """Least width of each part of a room; a hub is a hallway, too, where its outline is given."""
    if program.envelope.outline is None:
        return max(ARM_FREE, ARM * STANDARDS[room.base].width)
    return STANDARDS["hallway"].width if _hub(program, room) else ARM_WITHIN


def _near(program: Program) -> list[Pair]:
    """Pairs that should be close: each wet room and the one before it, kitchen and dining room."""
    types = [r.base for r in program.rooms]
    wet = [i for i, t in enumerate(types) if STANDARDS[t].wet]
    return [*((i, j, WET) for i, j in pairwise(wet)), *_pairs(program, "kitchen", "dining_room", MEALS)]


def _kitchens(program: Program) -> list[tuple[int, int]]:
    """Kitchens without a link to a room where one eats, each with such a room that it is not to be apart from."""
    types, near = {r.id: r.base for r in program.rooms}, neighbours(program)
    index = {room: i for i, room in enumerate(types)}
    tables = sorted((r for r in types if types[r] in EATEN_IN), key=lambda r: EATEN_IN.index(types[r]))
    apart = {frozenset((one.of, one.to)) for one in program.requirements if one.kind == "apart"}
    lone = [r for r in types if types[r] == "kitchen" and not set(tables) & set(near[r])]
    found = ((kitchen, [t for t in tables if frozenset((kitchen, t)) not in apart]) for kitchen in lone)
    return [(index[kitchen], index[free[0]]) for kitchen, free in found if free]


def _off_one(program: Program, a: int, b: int) -> list[tuple[int, int]]:
    """The links by which two rooms open off one other, if they do; by their numbers."""
    near = neighbours(program)
    number = {frozenset(pair): i for i, pair in enumerate(links(program))}
    one, other = program.rooms[a].id, program.rooms[b].id
    both = (room for room in near[one] if room in near[other])
    return [(number[frozenset((one, room))], number[frozenset((other, room))]) for room in both][:1]


def _pairs(program: Program, kind: str, other: str, counts: int) -> list[Pair]:
    types = [r.base for r in program.rooms]
    return [(i, j, counts) for i, a in enumerate(types) for j, b in enumerate(types) if (a, b) == (kind, other)]


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


def copy(tree: Tree) -> Tree:
    """An independent copy."""
    return Tree(tree.nodes.copy(), tree.share.copy())


def scratch(p: Problem, leaves: int) -> Scratch:
    """Room for the measures of a state of so many leaves."""
    n, k = len(p.spec), len(p.blocks)
    return Scratch(
        box=np.zeros((2 * leaves - 1, 6)),
        seq=np.zeros(2 * leaves + 2, np.int64),
        cuts=np.zeros(2 * leaves, np.int64),
        ends=np.zeros(2 * leaves, np.int64),
        piece=np.zeros((leaves * k, 4)),
        owner=np.zeros(leaves * k, np.int64),
        last=np.zeros(n, np.int64),
        before=np.zeros(leaves * k, np.int64),
        wall=np.zeros((len(p.links), 4)),
        room=np.zeros((n, R_COLUMNS)),
        terms=np.zeros(16),
        entry=np.zeros(7),
        walked=np.zeros((n, 3)),
        area=np.zeros(n),
        scale=np.zeros(1),
        block=np.zeros((k, 4)),
        around=np.zeros(4),
        level=np.zeros((2, len(p.edges) + 1)),
        edge=np.zeros((len(p.edges), 3)),
        clip=np.zeros((k, 3)),
    )
