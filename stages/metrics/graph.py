"""S_node, S_constraint, S_edge: the built rooms against the programme's graph (Eq. 5-9)."""

from typing import NamedTuple

from shapely.geometry import Polygon

from schemas.metrics import Value
from schemas.plan import Plan, Program
from stages.metrics._matching import Edge, matched

NEEDS = Plan


class Graph(NamedTuple):
    """Room types and areas by node (None where not given), and edges between nodes i < j."""

    types: list[str]
    areas: list[float | None]
    edges: set[Edge]


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """The scores against a programme, that of a reference plan, or the apartment's own.

    S_constraint is None where the reference leaves an area open.
    """
    gen, gt = of_plan(home), _reference(home.program if against is None else against)
    pairs, edges = matched(gen.types, gen.edges, gt.types, gt.edges)
    most = max(len(gen.edges), len(gt.edges))
    return [
        Value(name="S_node", value=len(pairs) / max(len(gen.types), len(gt.types)), unit="score", version="published"),
        Value(name="S_constraint", value=constraint(gen, gt), unit="score", version="published"),
        Value(name="S_edge", value=edges / most if most else 1.0, unit="score", version="published"),
    ]


def _reference(against: Plan | Program) -> Graph:
    """A programme's graph; a plan's own programme, with what was built where that leaves areas or links open."""
    if isinstance(against, Program):
        return of_program(against)
    asked, built = of_program(against.program), of_plan(against)
    if not asked.edges:
        return built
    by_id = {room.id: area for room, area in zip(against.rooms, built.areas)}
    areas = [by_id.get(room.id) if room.area is None else room.area for room in against.program.rooms]
    return asked._replace(areas=areas)


def constraint(gen: Graph, gt: Graph) -> float | None:
    """1 - D_L1 / 2 between the shares of area that each room type has (Eq. 6, 7)."""
    a, b = _shares(gen), _shares(gt)
    if a is None or b is None:
        return None
    return 1 - sum(abs(a.get(c, 0.0) - b.get(c, 0.0)) for c in sorted(a.keys() | b.keys())) / 2


def _shares(graph: Graph) -> dict[str, float] | None:
    areas = [area for area in graph.areas if area is not None]
    if len(areas) < len(graph.areas):
        return None
    shares: dict[str, float] = {}
    for kind, area in zip(graph.types, areas):
        shares[kind] = shares.get(kind, 0.0) + area / sum(areas)
    return shares


def of_plan(plan: Plan) -> Graph:
    """The graph of what was built; doors and openings are edges, clear floors the areas."""
    index = {room.id: i for i, room in enumerate(plan.rooms)}
    ways = [o.rooms for o in plan.openings if o.kind in ("door", "opening") and len(o.rooms) == 2]
    return Graph([room.type for room in plan.rooms], [Polygon(room.polygon).area for room in plan.rooms],
                 _edges([(index[a], index[b]) for a, b in ways]))


def of_program(program: Program) -> Graph:
    """The graph that was asked for."""
    index = {room.id: i for i, room in enumerate(program.rooms)}
    links = [*program.links, *program.open_links]
    return Graph([room.type for room in program.rooms], [room.area for room in program.rooms],
                 _edges([(index[a], index[b]) for a, b in links]))


def _edges(pairs: list[Edge]) -> set[Edge]:
    return {(min(pair), max(pair)) for pair in pairs if pair[0] != pair[1]}
