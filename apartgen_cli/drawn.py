"""Programmes, outlines and hand-drawn rooms from JSON files that people write, and floor plans of other programs."""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from pydantic import TypeAdapter, ValidationError

from apartgen.schemas import artifact
from apartgen.schemas.base import Polygon
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Plan, Program, Room
from apartgen.stages.plan.config import PlanConfig

Type = TypeVar("Type")


@dataclass(frozen=True)
class Wanted:
    """What a plan is to be made from: a prompt, a programme, or rooms drawn by hand with or without a programme.

    `home` is a plan, or a layout, that another program drew.
    """

    prompt: str = ""
    program: Program | None = None
    rooms: list[Room] = field(default_factory=list)
    home: Plan | None = None

    @property
    def id(self) -> str:
        """What one request is told from another by: its words, or its programme."""
        return self.program.model_dump_json() if self.program else self.prompt


def wanted(source: str, config: PlanConfig | None = None) -> Wanted:
    """What a file asks for: a programme, {"rooms": [{id, type, polygon}]} drawn by hand, an artifact's programme, or
    the floor plan that is in it.
    """
    from apartgen.stages.plan import imports

    data = artifact.contents(source)
    home = imports.read(source, data, config or PlanConfig())
    return Wanted(home=home) if home is not None else asked(data, source)


def asked(data: bytes, source: str) -> Wanted:
    """What the bytes of such a file ask for; `source` says in errors where they came from."""
    raw = artifact.json_value(data, source)
    if not isinstance(raw, dict):
        raise BadInput(f"{source}: a programme is a JSON object with rooms; see program in `apartgen schema plan`")
    if "apartgen" in raw:
        return Wanted(program=artifact.parse(data, source, Plan).body.program)
    rooms = raw.get("rooms")
    if not isinstance(rooms, list) or not any(isinstance(room, dict) and "polygon" in room for room in rooms):
        return Wanted(program=_typed(Program, raw, source))
    program = _typed(Program, raw["program"], f"{source}: program") if "program" in raw else None
    return Wanted(program=program, rooms=_typed(list[Room], rooms, f"{source}: rooms"))


def outline(file: Path) -> Polygon:
    """The corners in a file."""
    return _typed(Polygon, artifact.json_value(artifact.contents(file), str(file)), str(file))


def _typed(kind: type[Type], value: Any, name: str) -> Type:
    try:
        return TypeAdapter(kind).validate_json(json.dumps(value), strict=True)
    except ValidationError as error:
        raise BadInput(f"{name}: {artifact.first_fault(error)}; see program in `apartgen schema plan`") from None
