"""Floor plans of other programs, one file a format: walls, openings, names of rooms, and furniture if there is any."""

import logging
from types import ModuleType

from shapely.errors import ShapelyError

from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.plan.config import PlanConfig
from apartgen.stages.plan.drawing import Drawing

PACKAGE = "apartgen.stages.plan.imports"
log = logging.getLogger("apartgen")


def formats() -> dict[str, str]:
    """Every format's name and what it is."""
    return registry.members(PACKAGE)


def _drawing(member: ModuleType, name: str, data: bytes) -> Drawing:
    """What a format reads; whatever its parser stumbles over is the file's fault."""
    try:
        drawing: Drawing = member.read(name, data)
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError, ShapelyError) as error:
        kind = member.__name__.rpartition(".")[2]
        raise BadInput(
            f"broken where {kind} does not allow it ({type(error).__name__}: {error}); save it again"
        ) from error
    return drawing


def read(name: str, data: bytes, config: PlanConfig) -> Plan | None:
    """The plan that a file holds, a layout where it has furniture; None for a file of no format known here.

    What is completed is said in warnings. Errors begin with the file's name.
    """
    member = next((member for member in registry.sound(PACKAGE).values() if member.holds(name, data)), None)
    if member is None:
        return None
    from apartgen.stages.plan.drawing.completed import plan_of

    try:
        plan, said = plan_of(_drawing(member, name, data), config)
    except ApartgenError as error:
        raise type(error)(f"{name}: {error}") from error
    for remark in said:
        log.warning("%s: %s", name, remark)
    return plan
