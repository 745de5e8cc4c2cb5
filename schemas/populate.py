"""The apartment with the small things that people keep in it."""

from typing import Annotated, Any, Literal

from pydantic import Field, SerializerFunctionWrapHandler, model_serializer

from apartgen.schemas.base import Number, Point, Record, Vector
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.schemas.walkable import Report, Walkable

KIND = "populate"


class Inside(Record):
    """Where a thing was put: which receptacle of which object."""

    object: str
    receptacle: str


class Grasp(Record):
    """How a parallel gripper takes hold, in the thing's frame: where between its jaws, from where it comes, along which
    way it closes, and how far it is open before, m; fingers reach 1 cm beyond. It is `clear` where two fingers and the
    thing between them touch nothing else in the home, what stands before it being open.
    """

    at: Vector
    approach: Vector
    close: Vector
    width: Number
    clear: bool = False


class Thing(Furnishing):
    """A small thing. `in` is where it was put; what hangs on a wall or stands on the floor has none."""

    stage: Literal["populate"]
    in_: Inside | None = Field(None, alias="in")
    grasps: list[Grasp] = Field(default_factory=list)

    model_config = Furnishing.model_config | {"populate_by_name": True}

    @model_serializer(mode="wrap")
    def _short(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """A home has hundreds: what is empty is left out."""
        return {name: value for name, value in handler(self).items() if value not in ([], None)}


class Receptacle(Record):
    """Where things can be put on an object or in it: an outline in the object's frame at height `z`, and the clearance
    above it; `part` is the joint that has to be opened first.
    """

    name: str
    kind: Literal["top", "shelf", "inside", "drawer", "basin"]
    polygon: list[Point]
    z: Number
    clearance: Number
    part: str | None = None


class Populate(Retrieve):
    """Body of a `populate` artifact; `walkable` is that of the file it was made from, where there was one."""

    walkable: Report | None = None
    objects: list[Annotated[Thing | Furnishing, Field(union_mode="left_to_right")]] = Field(
        default_factory=list)
    receptacles: dict[str, list[Receptacle]] = Field(default_factory=dict, description="by object")
    states: dict[str, dict[str, bool | Number]] = Field(
        default_factory=dict, description="by object or opening: `on`, and `open.JOINT`, the share of its range")
    affordances: dict[str, list[str]] = Field(default_factory=dict, description="by object")
    switches: dict[str, list[str]] = Field(default_factory=dict, description="by switch, the lamps that it switches")


SAID = ("receptacles", "states", "affordances", "switches")
"""Fields that are said of things, besides them."""


def furniture_only(raw: Any) -> Any:
    """The body of a populated home's JSON without its small things, as a home that was not populated has it."""
    if not isinstance(raw, dict):
        return raw
    kept = {name: value for name, value in raw.items() if name not in SAID}
    objects = raw.get("objects")
    if isinstance(objects, list):
        kept["objects"] = [o for o in objects if not (isinstance(o, dict) and o.get("stage") == KIND)]
    return kept


def without_things(home: Any) -> Any:
    """A home without its small things, as the kind that it was made from; any other home as it is."""
    if not isinstance(home, Populate):
        return home
    kind = Walkable if home.walkable is not None else Retrieve
    fields = {name: getattr(home, name) for name in kind.model_fields}
    return kind.model_construct(**fields | {"objects": [o for o in home.objects if not isinstance(o, Thing)]})
