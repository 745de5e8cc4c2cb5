"""Types of room that the solver need not know: planned as what they are like, then called what they are."""

from collections.abc import Iterable
from typing import TypeVar

from apartgen.schemas.plan import AskedRoom, Plan, Program, Typed
from apartgen.schemas.rooms import kinds

Of = TypeVar("Of", bound=Typed)


def plain(program: Program) -> Program:
    """The programme with no types of room but those that always exist, and with the floor that others are for."""
    if all(room.type == room.base for room in program.rooms):
        return program
    return program.model_copy(update={"rooms": [as_base(_with_area(room)) for room in program.rooms]})


def _with_area(room: AskedRoom) -> AskedRoom:
    known = kinds().get(room.type)
    return room if known is None or room.area is not None else room.model_copy(update={"area": known.area})


def as_base(room: Of) -> Of:
    """The room as of the type that it is like."""
    return room.model_copy(update={"type": room.base, "like": None})


def named(plan: Plan, rooms: Iterable[Typed]) -> Plan:
    """The plan with the types of room that these rooms of its programme had."""
    own = {room.id: {"type": room.type, "like": room.base} for room in rooms if room.type != room.base}
    if not own:
        return plan

    def called(found: list[Of]) -> list[Of]:
        return [room.model_copy(update=own.get(room.id, {})) for room in found]

    asked = plan.program.model_copy(update={"rooms": called(plan.program.rooms)})
    return plan.model_copy(update={"program": asked, "rooms": called(plan.rooms)})
