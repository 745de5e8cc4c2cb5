"""How well one room graph agrees with another: node, constraint and edge similarity (paper, Eq. 5-9)."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations, product

from schemas.plan import Link, Program


@dataclass(frozen=True)
class RoomGraph:
    """Rooms as id → type and id → area (m²), doors as unordered pairs of ids."""

    types: dict[str, str]
    areas: dict[str, float]
    edges: frozenset[frozenset[str]]


def graph(types: dict[str, str], areas: dict[str, float], links: list[Link]) -> RoomGraph:
    """A graph from pairs in any order."""
    return RoomGraph(types, areas, frozenset(frozenset(pair) for pair in links))


def of_program(program: Program) -> RoomGraph:
    """The graph a programme asks for."""
    types = {r.id: str(r.type) for r in program.rooms}
    areas = {r.id: r.area or 0.0 for r in program.rooms}
    return graph(types, areas, [*program.links, *program.open_links])


def node_similarity(a: RoomGraph, b: RoomGraph) -> float:
    """S_node (Eq. 5): rooms matched by type over the larger number of rooms."""
    matched = sum((Counter(a.types.values()) & Counter(b.types.values())).values())
    return matched / max(len(a.types), len(b.types))


def constraint_satisfaction(a: RoomGraph, b: RoomGraph) -> float:
    """S_constraint (Eq. 6-7): one minus half the L1 distance of area shares by room type."""
    p, q = _shares(a), _shares(b)
    return 1 - 0.5 * sum(abs(p.get(c, 0.0) - q.get(c, 0.0)) for c in sorted({*p, *q}))


def edge_similarity(a: RoomGraph, b: RoomGraph) -> float:
    """S_edge (Eq. 8-9) under the matching by type that keeps most edges; 1 when neither has any."""
    most = max(len(a.edges), len(b.edges))
    if not most:
        return 1.0
    best = max(len({frozenset(m.get(v, v + "?") for v in e) for e in a.edges} & b.edges) for m in _matchings(a, b))
    return best / most


def _shares(g: RoomGraph) -> dict[str, float]:
    whole = sum(g.areas.values()) or 1.0
    out: dict[str, float] = {}
    for room, kind in g.types.items():
        out[kind] = out.get(kind, 0.0) + g.areas[room] / whole
    return out


def _matchings(a: RoomGraph, b: RoomGraph) -> Iterator[dict[str, str]]:
    """Every maximum matching of equal types, as a's ids → b's."""
    choices = []
    for kind in sorted(set(a.types.values())):
        mine = sorted(i for i, t in a.types.items() if t == kind)
        theirs = sorted(i for i, t in b.types.items() if t == kind)
        if len(mine) <= len(theirs):
            choices.append([dict(zip(mine, p, strict=False)) for p in permutations(theirs, len(mine))])
        else:
            choices.append([dict(zip(p, theirs, strict=True)) for p in permutations(mine, len(theirs))])
    for parts in product(*choices):
        yield {k: v for part in parts for k, v in part.items()}
