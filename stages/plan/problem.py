"""A programme as the arrays the solver anneals, and the random trees it starts from."""

from collections import deque
from dataclasses import dataclass, replace

import numpy as np
from numpy.random import Generator

from schemas.plan import Program, Walls
from stages.plan.check import entrance_room, links, neighbours
from stages.plan.kernel import Problem, Scratch, Tree
from stages.plan.outline import Outline
from stages.plan.standards import LINK_WALL, STANDARDS

TERMS: dict[str, float] = {
    "shortest_path": 2.0,
    "typical_area": 10.0,
    "aspect_ratio": 5.0,
    "convexity": 50.0,
    "conciseness": 8.0,
    "exterior_length": 0.2,
    "exterior_corner": 0.02,
    "collinearity": 0.1,
    "functional_room": 10.0,
    "narrow_passage": 5.0,
    "staircase": 0.0,
    "wet_rooms": 0.5,
    "wide_corridor": 4.0,
}


@dataclass(frozen=True)
class Slack:
    """How far the requirements are relaxed; the defaults are not relaxed at all."""

    area: float = 0.12
    aspect: float = 1.0
    envelope: bool = False


def areas(program: Program) -> dict[str, float]:
    """Net area wanted of every room, at least the least of its type."""
    return {r.id: max(r.area or 1.6 * STANDARDS[r.type].area, STANDARDS[r.type].area) for r in program.rooms}


def gross_area(program: Program, walls: Walls) -> float:
    """Floor and walls of all rooms between wall centre lines, taking rooms of aspect 1.4."""
    return sum(a + 2.03 * np.sqrt(a) * walls.inner + walls.inner**2 for a in areas(program).values())


def problem(program: Program, outline: Outline, parts: list[int], walls: Walls, slack: Slack) -> Problem:
    """Arrays for one run; `parts` says of how many rectangles each room is made."""
    rooms, wanted = program.rooms, areas(program)
    norms = [STANDARDS[r.type] for r in rooms]
    index = {r.id: i for i, r in enumerate(rooms)}
    hall = np.array([r.type in ("hallway", "balcony") for r in rooms])
    target = np.array([wanted[r.id] for r in rooms])
    order, parent = _ways(program, index)
    joined = {r for pair in program.open_links for r in pair}
    return Problem(
        target=target,
        loose=np.where(hall, 3 * slack.area, slack.area),
        width=np.array([min(n.width, 0.95 * np.sqrt(a)) for n, a in zip(norms, target, strict=True)]),
        joint=np.array([min(n.width, 1.5) for n in norms]),
        aspect=np.array([n.aspect for n in norms]) * slack.aspect,
        form=np.where(hall, 0.02, 1.0),
        corners=np.array([2.0 + 2 * k for k in parts]),
        face=np.array([0.0 if r.type == "kitchen" and r.id in joined else n.face for r, n in zip(rooms, norms, strict=True)]),
        role=np.array([(r.type == "hallway", n.wet, n.functional, n.outer) for r, n in zip(rooms, norms, strict=True)], np.int64),
        links=np.array([(index[a], index[b]) for a, b in links(program)], np.int64).reshape(-1, 2),
        order=order,
        parent=parent,
        blocks=outline.blocks,
        edges=outline.edges,
        weights=np.array([w * program.weights.get(name, 1.0) for name, w in TERMS.items()]),
        limits=np.array([*outline.stretch, walls.inner, LINK_WALL + walls.inner, LINK_WALL + walls.inner + 0.1]),
    )


def _ways(program: Program, index: dict[str, int]) -> tuple[np.ndarray, np.ndarray]:
    near = neighbours(program)
    start = entrance_room(program).id
    before = {start: -1}
    queue, order = deque([start]), []
    while queue:
        here = queue.popleft()
        order.append(index[here])
        for there in near[here]:
            if there not in before:
                before[there] = index[here]
                queue.append(there)
    return np.array(order, np.int64), np.array([before[r.id] for r in program.rooms], np.int64)


def parts(program: Program, rng: Generator) -> list[int]:
    """Of how many rectangles each room is made: corridors of up to three, others rarely of two when regular."""
    odd = (1 - program.regularity) ** 2
    out = []
    for room, area in zip(program.rooms, areas(program).values(), strict=True):
        if room.type == "hallway":
            many = min(len(program.rooms) / 8, 1.0)
            out.append(int(rng.choice([1, 2, 3], p=[1 - 0.65 * many, 0.45 * many, 0.2 * many])))
        else:
            out.append(2 if area >= 9 and rng.random() < odd else 1)
    return out


def start(program: Program, parts: list[int], stretch: tuple[float, float], rng: Generator) -> Tree:
    """A random tree over the rooms' parts."""
    wanted = list(areas(program).values())
    room = np.repeat(np.arange(len(parts)), parts)
    share = np.concatenate([wanted[i] * rng.dirichlet(np.full(k, 6.0)) for i, k in enumerate(parts)])
    leaves = len(room)
    left, right, upright = (np.zeros(2 * leaves - 1, np.int64) for _ in range(3))
    nodes = list(rng.permutation(leaves))
    for cut in range(leaves, 2 * leaves - 1):
        left[cut], right[cut] = (nodes.pop(int(rng.integers(len(nodes)))) for _ in range(2))
        upright[cut] = rng.integers(2)
        nodes.append(cut)
    s = float(np.clip(1.0, *stretch))
    return Tree(left, right, upright, room.astype(np.int64), share, np.array([nodes[0]], np.int64), np.array([s]))


def copy(tree: Tree) -> Tree:
    """An independent copy."""
    return Tree(*(np.array(a) for a in tree))


def scratch(n: int, leaves: int, k: int) -> Scratch:
    """Room for the measures of a state of `n` rooms."""
    nodes, most = 2 * leaves - 1, leaves * k
    return Scratch(
        np.zeros((nodes, 4)), np.zeros(nodes, np.int64), np.zeros(nodes), np.zeros((most, 4)), np.zeros(most, np.int64),
        np.zeros((n, n)), np.zeros((n, n, 2)), np.zeros((n, 12)), np.zeros(14), np.zeros(3), np.zeros((n, 3)),
    )  # fmt: skip


__all__ = ["Slack", "areas", "copy", "gross_area", "parts", "problem", "replace", "scratch", "start"]
