"""S_node, S_constraint, S_edge: the built rooms against the programme's graph (Eq. 5-9)."""

from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.space import graphs
from apartgen.stages.space.graphs import RoomGraph

NEEDS = Plan


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """The scores against a programme, that of a reference plan, or the apartment's own.

    S_constraint is None where the reference leaves an area open.
    """
    built, wanted = graphs.of_plan(home), _reference(home.program if against is None else against)
    scores = {
        "S_node": graphs.node_similarity(built, wanted),
        "S_constraint": graphs.constraint_satisfaction(built, wanted),
        "S_edge": graphs.edge_similarity(built, wanted),
    }
    return [Value(name=name, value=value, unit="score", version="published") for name, value in scores.items()]


def _reference(against: Plan | Program) -> RoomGraph:
    """A programme's graph; a plan's own programme, with what was built where that leaves areas or links open."""
    if isinstance(against, Program):
        return graphs.of_program(against)
    asked, built = graphs.of_program(against.program), graphs.of_plan(against)
    if not asked.edges:
        return built
    by_id = {room.id: area for room, area in zip(against.rooms, built.areas)}
    areas = [by_id.get(room.id) if room.area is None else room.area for room in against.program.rooms]
    return asked._replace(areas=areas)
