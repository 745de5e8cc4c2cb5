"""From a programme to a plan: annealing in waves, doors and windows for the best, relaxation where none is valid."""

import logging
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

import numpy as np
import shapely
from numpy.random import Generator
from shapely.geometry import Polygon

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Envelope, Plan, Program, Room
from apartgen.stages.plan import doors, kernel, windows
from apartgen.stages.plan.balconies import hang, indoors
from apartgen.stages.plan.bettered import bettered
from apartgen.stages.plan.blocks import Outline, given, gross
from apartgen.stages.plan.check import check
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.contradict import lacks, told
from apartgen.stages.plan.fitting import fitted
from apartgen.stages.plan.judge import faults
from apartgen.stages.plan.met import judged, unmet
from apartgen.stages.plan.outline import draw, ring
from apartgen.stages.plan.problem import Slack, Whim, copy, gross_area, open_problem, scratch, whim, within
from apartgen.stages.plan.rehung import rehung
from apartgen.stages.plan.relax import ladder
from apartgen.stages.plan.slicing import EPS, LACKING, Floats, Ints, Problem
from apartgen.stages.plan.starts import Known, known, start
from apartgen.stages.plan.turn import askew, turned, turned_plan
from apartgen.stages.plan.wishes import placed

HOT, COLD = 20.0, 1.0
"""Temperatures between which a run anneals, in units of cost."""
SPREAD = 6.0
"""Difference of cost up to which one arrangement is as good as another."""
CHOICE = 48
"""Rooms in all the arrangements to choose from: one of a large flat is as good as several of a small one."""
BEYOND = 5.0
TRIED = 72
"""Arrangements that take no doors or windows after which a step is given up, within a given outline."""
LOOKS = 5
"""Whims from the first that has a plan, of which the plan that meets most is taken where it is told where rooms lie."""
PATIENCE = 6
"""Waves of runs on one whim; it is dropped after the first where none is valid."""

log = logging.getLogger("apartgen")
Each = Callable[[Callable[[Generator], "Run"], list[Generator]], Iterable["Run"]]
"""A map over the chances of runs."""


@dataclass(frozen=True)
class Run:
    """Result of one annealing run: its cost, what it lacks, the rectangles of the rooms; what misses, when asked."""

    cost: float
    lack: float
    boxes: Floats
    owner: Ints
    missed: Callable[[], list[str]]


@dataclass(frozen=True)
class Whole:
    """What all runs on one whim have in common; an outline only where one is given."""

    program: Program
    wanted: Whim
    arrays: Problem
    known: Known
    gross: float
    outline: Outline | None


def whole(program: Program, config: PlanConfig, slack: Slack, wanted: Whim, trees: Known) -> Whole:
    """What the runs on a whim need."""
    outline = None if program.envelope.outline is None else given(program.envelope, config.walls.inner)
    arrays, area = open_problem(program, wanted, config.walls, slack), gross_area(program, config.walls)
    return Whole(program, wanted, arrays, trees, area, outline)


def anneal(of: Whole, config: PlanConfig, rng: Generator) -> Run:
    """One run from a random start."""
    program, wanted = of.program, of.wanted
    outline = of.outline or draw(program.envelope, of.gross, wanted.shape, wanted.aspect, rng)
    p = within(of.arrays, outline)
    tree = start(of.known, wanted.parts, outline.stretch, rng)
    new, best = copy(tree), copy(tree)
    z = scratch(p, sum(wanted.parts))
    seed = rng.integers(1, 2**63, 1).astype(np.uint64)
    steps = config.proposals * sum(wanted.parts)
    cost = kernel.anneal(p, tree, new, best, z, seed, steps, HOT, COLD)
    if z.terms[LACKING] < EPS:
        best, cost = bettered(best, float(cost), p, z, seed, steps)
    lack = float(z.terms[-1])
    missed = partial(lacks, program, p, z)
    leaves = len(best.share) - 1
    if of.outline is not None:
        boxes = z.box[:leaves, :4] if lack > EPS else fitted(best, z.box, gross(program.envelope, config.walls.inner))
        return Run(float(cost), lack, _to_the_edge(boxes), best.nodes[:leaves, 0], missed)
    count = int(z.seq[-1])
    return Run(float(cost), lack, np.round(z.piece[:count], 2), z.owner[:count].copy(), missed)


def _to_the_edge(boxes: Floats) -> Floats:
    """Boxes at the rim of all boxes, drawn out beyond any corner that steps for slanting walls cut off."""
    lo, hi = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    lows = np.where(boxes[:, :2] < lo + EPS, boxes[:, :2] - BEYOND, boxes[:, :2])
    return np.hstack([lows, np.where(boxes[:, 2:] > hi - EPS, boxes[:, 2:] + BEYOND, boxes[:, 2:])])


def floors(program: Program, run: Run, inner: float) -> dict[str, Polygon]:
    """Clear floors: the rooms' rectangles, joined, within a given outline, and half a wall inset."""
    out = {}
    for i, room in enumerate(program.rooms):
        shape = shapely.union_all(shapely.box(*run.boxes[run.owner == i].T))
        if program.envelope.outline is not None:
            shape = shape.intersection(gross(program.envelope, inner))
        out[room.id] = shape.buffer(-inner / 2, join_style="mitre")
    return out


def finish(program: Program, run: Run, config: PlanConfig, given_up: tuple[str, ...] = ()) -> Plan | None:
    """A plan with balconies, doors and windows, or None where they find no place."""
    rooms = floors(indoors(program), run, config.walls.inner)
    if any(not isinstance(shape, Polygon) or shape.is_empty for shape in rooms.values()):
        return None
    shapes = hang(program, rooms, config.walls)
    if shapes is None:
        return None
    try:
        passages = doors.place(program, shapes, config.walls)
    except Unmet:
        return None
    glass = windows.place(program, shapes, passages, config.walls)
    if windows.dark(program, glass):
        return None
    built = [Room(id=r.id, type=r.type, polygon=ring(shapes[r.id])) for r in program.rooms]
    plan = Plan(
        program=program, rooms=built, openings=[*passages, *glass], height=config.height, walls=config.walls,
        relaxed=list(given_up),
    )  # fmt: skip
    return None if faults(plan) else plan


def waves(of: Whole, config: PlanConfig, rng: Generator, each: Each) -> Iterator[list[Run]]:
    """Annealing runs on one whim, a wave at a time; what they are does not depend on the number of threads."""
    for _ in range(PATIENCE):
        yield list(each(lambda lane: anneal(of, config, lane), rng.spawn(config.wave)))


@contextmanager
def threads(many: int) -> Iterator[Each]:
    """A map over runs, in so many threads where they are several."""
    if many == 1:
        yield map
        return
    with ThreadPoolExecutor(many) as pool:
        yield pool.map


def solve(program: Program, config: PlanConfig, rng: Generator) -> Plan:
    """The best plan found; raises Unmet naming the contradiction where even relaxed requirements admit none."""
    check(program)
    with threads(config.processes) as each:
        return _solved(program, config, rng, each)


def _solved(program: Program, config: PlanConfig, rng: Generator, each: Each) -> Plan:
    program = rehung(program)
    envelope = program.envelope
    program, angle = _upright(program)
    closest: list[Run] = []
    for step in ladder(program):
        tried, inside, best, left = 0, indoors(step.program), list[Plan](), LOOKS if placed(program) else 1
        trees = known(inside)
        for failed in range(-(-config.whims // 2) if step.slack != Slack() and step.given_up else config.whims):
            valid: list[Run] = []
            wanted = whim(step.program, config.walls, failed, rng)
            about = _with_envelope(step.program, wanted.envelope)
            shared = whole(_with_envelope(inside, wanted.envelope), config, step.slack, wanted, trees)
            for runs in waves(shared, config, rng, each):
                valid += [run for run in runs if run.lack < EPS]
                closest = sorted([*closest, *runs], key=lambda run: run.lack)[:1]
                if not valid or len(valid) >= enough(program, config):
                    break
            tried += len(valid)
            plan = _first(about, valid, config, step.given_up, rng)
            best = sorted([*best, *([plan] if plan is not None else [])], key=unmet)[:1]
            left -= bool(best)
            if best and (left < 1 or unmet(best[0]) == 0):
                break
            if tried >= TRIED and envelope.outline is not None:
                break
        if best:
            for line in step.given_up:
                log.warning("plan: %s", line)
            return _told(judged(_turned_back(best[0], angle, envelope)))
    raise Unmet(told(program, closest[0].missed() or ["the doors get in each other's way"]))


def enough(program: Program, config: PlanConfig) -> int:
    """Valid arrangements to choose from: twice as many where the programme says what to choose by."""
    chosen = any(factor != 1.0 for factor in program.weights.values())
    return (1 + chosen) * min(config.enough, max(1, CHOICE // len(program.rooms)))


def _told(plan: Plan) -> Plan:
    """The plan; what it does not have of what was asked is told."""
    for asked in plan.program.requirements:
        if asked.met is False:
            log.warning('plan: not met: "%s"', asked.text or f"{asked.of}: {asked.kind} {asked.value or asked.to}")
    return plan


def _upright(program: Program) -> tuple[Program, float]:
    """The programme with its outline turned to the axes, and the angle to turn the plan back by."""
    if program.envelope.outline is None:
        return program, 0.0
    angle = askew([Polygon(program.envelope.outline)])
    outline = turned(program.envelope.outline, -angle)
    return program.model_copy(update={"envelope": program.envelope.model_copy(update={"outline": outline})}), angle


def _with_envelope(program: Program, envelope: Envelope) -> Program:
    return program.model_copy(update={"envelope": envelope})


def _turned_back(plan: Plan, angle: float, given: Envelope) -> Plan:
    """The plan in the position that the outline was given in."""
    if angle == 0.0:
        return plan
    envelope = plan.program.envelope.model_copy(update={"outline": given.outline})
    return turned_plan(plan.model_copy(update={"program": _with_envelope(plan.program, envelope)}), angle)


def _first(
    program: Program, runs: list[Run], config: PlanConfig, given_up: tuple[str, ...], rng: Generator
) -> Plan | None:
    """The run that meets most of what is asked for and takes doors and windows, as a plan: cheap ones first."""
    keys = [run.cost + SPREAD * rng.random() for run in runs]
    plans = (finish(program, runs[i], config, given_up) for i in np.argsort(keys))
    best: Plan | None = None
    for plan in plans:
        seen = plan and judged(plan)
        best = seen if seen is not None and (best is None or unmet(seen) < unmet(best)) else best
        if best is not None and unmet(best) == 0:
            break
    return best
