"""Room graphs, and how well one agrees with another: node, constraint and edge similarity (paper, Eq. 5-9)."""

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from apartgen.schemas.plan import Link, Plan, Program
from apartgen.stages.space import polygons
from apartgen.stages.space.graph_matching import Edge, matched


class RoomGraph(NamedTuple):
    """Room types and areas (m², None where not given) by node, and edges between nodes i < j."""

    types: list[str]
    areas: list[float | None]
    edges: set[Edge]


def graph(types: Mapping[str, str], areas: Mapping[str, float | None], links: Iterable[Link]) -> RoomGraph:
    """A graph of rooms by id; pairs of ids in any order are its edges."""
    index = {room: i for i, room in enumerate(types)}
    pairs = ((index[a], index[b]) for a, b in links if a != b)
    return RoomGraph(list(types.values()), [areas[room] for room in types], {(min(p), max(p)) for p in pairs})


def of_program(program: Program) -> RoomGraph:
    """The graph that was asked for."""
    rooms = program.rooms
    return graph({r.id: r.type for r in rooms}, {r.id: r.area for r in rooms}, [*program.links, *program.open_links])


def of_plan(plan: Plan) -> RoomGraph:
    """The graph of what was built; doors and openings are edges, clear floors the areas."""
    ways = [(o.rooms[0], o.rooms[1]) for o in plan.openings if o.kind in ("door", "opening") and len(o.rooms) == 2]
    areas = {room: floor.area for room, floor in polygons.floors(plan).items()}
    return graph({room.id: room.type for room in plan.rooms}, areas, ways)


def node_similarity(a: RoomGraph, b: RoomGraph) -> float:
    """S_node (Eq. 5): rooms matched by type over the larger number of rooms."""
    return (Counter(a.types) & Counter(b.types)).total() / max(len(a.types), len(b.types))


def constraint_satisfaction(a: RoomGraph, b: RoomGraph) -> float | None:
    """S_constraint (Eq. 6, 7): 1 - D_L1 / 2 between the shares of area that each room type has.

    None where either leaves an area open.
    """
    p, q = _shares(a), _shares(b)
    if p is None or q is None:
        return None
    return 1 - sum(abs(p.get(c, 0.0) - q.get(c, 0.0)) for c in sorted(p.keys() | q.keys())) / 2


def _shares(g: RoomGraph) -> dict[str, float] | None:
    areas = [area for area in g.areas if area is not None]
    if len(areas) < len(g.areas):
        return None
    whole = sum(areas) or 1.0
    shares: dict[str, float] = {}
    for kind, area in zip(g.types, areas):
        shares[kind] = shares.get(kind, 0.0) + area / whole
    return shares


def edge_similarity(a: RoomGraph, b: RoomGraph) -> float:
    """S_edge (Eq. 8, 9) under the matching by type that keeps most edges; 1 when neither has any."""
    most = max(len(a.edges), len(b.edges))
    return matched(a.types, a.edges, b.types, b.edges)[1] / most if most else 1.0
