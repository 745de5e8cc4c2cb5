"""Doors moved to other rooms where what is asked limits them: so many doors at most or at least, none between two."""

from collections.abc import Iterator
from itertools import chain

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Link, Program, Requirement
from apartgen.stages.plan.check import check, entrance_room, neighbours

HOSTS: dict[str, tuple[str, ...]] = {
    "kitchen": ("dining_room", "living_room", "hallway"), "dining_room": ("living_room", "kitchen", "hallway"),
    "storage": ("hallway", "kitchen", "utility", "living_room"), "utility": ("hallway", "kitchen", "living_room"),
    "closet": ("hallway", "bedroom", "living_room"), "study": ("hallway", "living_room", "dining_room"),
    "bedroom": ("hallway", "living_room"), "bathroom": ("hallway", "utility", "bedroom", "living_room"),
    "living_room": ("hallway", "dining_room", "kitchen"), "balcony": ("living_room", "dining_room", "bedroom"),
    "hallway": ("hallway", "living_room"),
}  # fmt: skip
"""Rooms by type that another may open into, the best first; those that move first stand first."""


def rehung(program: Program) -> Program:
    """The programme with doors as its requirements limit them, as far as every room can still be reached."""
    if program.complete:
        return program
    for asked in program.requirements:
        if asked.kind == "no_door" and asked.to is not None:
            program = _parted(program, asked)
        elif asked.kind in ("at_most", "at_least") and asked.to == "doors":
            program = _counted(program, asked)
    return program


def _parted(program: Program, asked: Requirement) -> Program:
    for link in [link for link in program.links if set(link) == {asked.of, asked.to}]:
        program = next(chain(_moved(program, link, link[0]), _moved(program, link, link[1])), program)
    return program


def _counted(program: Program, asked: Requirement) -> Program:
    limit = int(float(asked.value or 0))
    for _ in program.rooms:
        doors = len(neighbours(program).get(asked.of, []))
        if (doors <= limit if asked.kind == "at_most" else doors >= limit):
            break
        found = _less(program, asked.of) if asked.kind == "at_most" else _more(program, asked.of)
        program = next(found, program)
    return program


def _less(program: Program, room: str) -> Iterator[Program]:
    """Programmes with one of a room's doors moved or, where its room has another, left out."""
    types = {r.id: r.base for r in program.rooms}
    mine = [link for link in program.links if room in link]
    other = {link: link[link[0] == room] for link in mine}
    for link in sorted(mine, key=lambda link: list(HOSTS).index(types[other[link]])):
        yield from _possible(program, [pair for pair in program.links if pair != link])
        yield from _moved(program, link, room)


def _more(program: Program, room: str) -> Iterator[Program]:
    """Programmes with one door of a room more: to one that it may open into, else another room's door moved to it."""
    types = {r.id: r.base for r in program.rooms}
    near = {*neighbours(program)[room], room}
    for host in HOSTS[types[room]]:
        for there in [r for r in types if types[r] == host and r not in near]:
            yield from _possible(program, [*program.links, (room, there)])
    for kind in [kind for kind, hosts in HOSTS.items() if types[room] in hosts]:
        for there in [r for r in types if types[r] == kind and r not in near]:
            for link in [pair for pair in program.links if there in pair]:
                moved = [pair for pair in program.links if pair != link]
                yield from _possible(program, [*moved, (room, there)])


def _moved(program: Program, link: Link, away: str) -> Iterator[Program]:
    """Programmes in which the other room of a link opens into a third one instead of into `away`."""
    room = link[link[0] == away]
    types = {r.id: r.base for r in program.rooms}
    if room == entrance_room(program).id:
        return
    near = {*neighbours(program)[room], room, away}
    for host in HOSTS[types[room]]:
        for there in [r for r in types if types[r] == host and r not in near]:
            yield from _possible(program, [(room, there) if pair == link else pair for pair in program.links])


def _possible(program: Program, links: list[Link]) -> Iterator[Program]:
    changed = program.model_copy(update={"links": links})
    try:
        check(changed)
    except Unmet:
        return
    yield changed
