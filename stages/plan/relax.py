"""What is given up, in this order, where no plan meets everything: areas, aspect, envelope, an extra hallway, links."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from shapely.geometry import Polygon

from apartgen.schemas.plan import AskedRoom, Program
from apartgen.stages.plan.check import check, entrance_room, links
from apartgen.stages.plan.problem import Slack

INNER = 1.05
"""Area within an outline over that of its rooms, because of the walls between."""
MISFIT = 1.17
"""Factor by which an outline may be larger or smaller than what the rooms take."""
LOOSE = 0.19
"""Part by which areas may differ where they cannot differ less, before that is told."""


HEED = 0.1
"""Share that preferences count where no plan is found with all they count."""
HEEDS = (0.4, 0.2, 0.1)
"""Shares that wishes count as everything is then tried anew; only the least within a given outline, where a run takes
longer."""


@dataclass(frozen=True)
class Step:
    """One rung: the programme and slack to solve with, and what that gives up, in words."""

    program: Program
    slack: Slack
    given_up: tuple[str, ...] = ()
    changed: bool = False


def ladder(program: Program) -> Iterator[Step]:
    """Rungs from nothing given up to as much as may be; then the same anew, with wishes that count ever less."""
    yield from _rungs(program)
    for heed in HEEDS if program.envelope.outline is None else HEEDS[-1:]:
        yield from (replace(step, slack=replace(step.slack, heed=heed, urge=HEED)) for step in _rungs(program))


def _rungs(program: Program) -> Iterator[Step]:
    said = misfit(program)
    yield Step(program, Slack(), tuple(said))
    yield Step(program, Slack(area=LOOSE), tuple(said))
    if any(factor > 1 for factor in program.weights.values()):  # what is preferred yields before areas
        yield Step(program, Slack(area=LOOSE, urge=HEED), tuple(said))
    said.append("areas may differ from what was asked by up to 30 %")
    yield Step(program, Slack(area=0.3), tuple(said))
    said.append("rooms may be half as long again for their width as they should")
    slack = Slack(area=0.3, aspect=1.5)
    yield Step(program, slack, tuple(said))
    if program.envelope.outline is None and program.envelope.shape != "rectangle":
        free = program.envelope.model_copy(update={"shape": "rectangle"})
        program = program.model_copy(update={"envelope": free})
        said.append("the outline is a rectangle")
        yield Step(program, slack, tuple(said), True)
    if program.complete:
        return
    extra = with_hallway(program)
    if extra is not None:
        program = extra
        said.append("a hallway was added")
        yield Step(program, slack, tuple(said), True)
    for dropped in spare_links(program):
        kept = [pair for pair in program.links if pair != dropped]
        program = program.model_copy(update={"links": kept})
        said.append(f"{dropped[0]} and {dropped[1]} are not linked")
        yield Step(program, slack, tuple(said), True)


def misfit(program: Program) -> list[str]:
    """What to say where a given outline is not as large as the rooms asked for, so that they get shares of it."""
    outline = program.envelope.outline
    if outline is None or any(room.area is None for room in program.rooms):
        return []
    wanted = INNER * sum(room.area or 0.0 for room in program.rooms)
    given = float(Polygon(outline).area)
    if 1 / MISFIT < given / wanted < MISFIT:
        return []
    return [f"the outline has {given:.0f} m² where the rooms asked for take {wanted:.0f} m²: areas are shares of it"]


def with_hallway(program: Program) -> Program | None:
    """The programme with a hallway taking over the links of its busiest room; None where there are halls enough."""
    halls = [room for room in program.rooms if room.type == "hallway"]
    if len(halls) > 1 or len(program.rooms) < 4:
        return None
    busy = halls[0].id if halls else entrance_room(program).id
    name = f"hallway_{len(halls) + 1}"
    mine = [pair for pair in program.links if busy in pair]
    moved = mine if not halls else mine[len(mine) // 2 :]
    rest = [pair for pair in program.links if pair not in moved]
    over = [(name, a if b == busy else b) for a, b in moved]
    area = 0.08 * sum(room.area or 8.0 for room in program.rooms)
    hall = AskedRoom(id=name, type="hallway", area=max(3.0, area), private_to=None)
    return program.model_copy(update={"rooms": [*program.rooms, hall], "links": [*rest, (busy, name), *over]})


def spare_links(program: Program) -> list[tuple[str, str]]:
    """Links without which every room can still be reached, those that were asked last first."""
    out = []
    for pair in reversed(program.links):
        kept = [p for p in program.links if p != pair and p not in out]
        try:
            check(program.model_copy(update={"links": kept}))
        except Exception:  # noqa: S112
            continue
        out.append(pair)
    return out if len(links(program)) > 1 else []
