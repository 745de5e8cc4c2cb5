"""The floor plan: what was asked for, and the rooms, doors and windows built."""

from typing import Annotated, Any, Literal, cast

from pydantic import ConfigDict, Field, SerializerFunctionWrapHandler, ValidationInfo, field_validator, model_serializer

from apartgen.schemas.base import ROOM_TYPES, Number, Point, Polygon, Positive, Record, RoomType
from apartgen.schemas.rooms import base_of, kinds

Link = tuple[str, str]
Side = Literal["south", "east", "north", "west"]


class Typed(Record):
    """What has a type of room: one of those that always exist, or another that is `like` one of these."""

    model_config = ConfigDict(json_schema_extra={"anyOf": [
        {"properties": {"type": {"enum": list(ROOM_TYPES)}}},
        {"properties": {"like": {"enum": list(ROOM_TYPES)}}, "required": ["like"]},
    ]})

    id: str
    like: RoomType | None = Field(None, description="for a type that not everybody knows")
    type: str = Field(pattern=r"^[a-z][a-z_]*$", description=f"{', '.join(ROOM_TYPES)}, or what is `like` one of them")

    @field_validator("type")
    @classmethod
    def _known(cls, type: str, given: ValidationInfo) -> str:
        if given.data.get("like") is None and base_of(type) is None:
            raise ValueError(f"{type!r} is no type of room; there are {', '.join(kinds())}; say which one it is like")
        return type

    @model_serializer(mode="wrap")
    def _whole(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        rest: dict[str, Any] = handler(self)
        head = {name: rest.pop(name) for name in ("id", "type") if name in rest}
        rest.pop("like", None)
        return head | ({} if self.type == self.base else {"like": self.base}) | rest

    @property
    def base(self) -> RoomType:
        """The type that always exists: its own, or the one that it is like."""
        return self.type if self.type in ROOM_TYPES else self.like or cast(RoomType, base_of(self.type))


class AskedRoom(Typed):
    """One room of the programme; `area` in m², None where the prompt leaves it open."""

    id: str = Field(pattern=r"^[a-z][a-z_]*_[0-9]+$")
    area: Positive | None = None
    private_to: str | None = Field(None, description="an ensuite's or a walk-in closet's owner")
    children: int | None = Field(
        None, ge=1, le=6, description="so many children sleep in it, where that is known",
        exclude_if=lambda known: known is None)


class AskedObjects(Record):
    """Furnishing the prompt names: `count` objects of `category` in `room`."""

    room: str
    category: str
    count: int = Field(ge=0, le=100)


class Envelope(Record):
    """The outline the rooms must fill."""

    shape: Literal["auto", "rectangle", "L", "notched"] = "auto"
    outline: Polygon | None = Field(None, description="a given outline, metres")
    party_walls: list[Side] = Field([], description="sides without windows")
    entrance: Side | None = None
    facades: int | None = Field(None, ge=1, le=4, description="sides with windows; drawn where nobody says")
    dwelling: Literal["flat", "corner_flat", "house"] = Field(
        "flat", description="a flat is entered from the stair behind one of its party walls, a house from outside"
    )


class Requirement(Record):
    """What else was asked of a room or an object: `text` are the words it came from, `met` whether the result has it
    (None where nobody looked yet).
    """

    id: str
    kind: str = Field(description="position, dimension, adjacent, apart, order, …")
    of: str
    to: str | None = None
    value: Number | str | None = None
    text: str = ""
    met: bool | None = None


class Program(Record):
    """What the plan solver is asked for, filled by a reader from the prompt."""

    rooms: list[AskedRoom] = Field(min_length=1, max_length=40)
    links: list[Link] = Field([], description="what must connect by a door or opening")
    open_links: list[Link] = Field([], description="links without a wall between (open plan)")
    weights: dict[str, float] = Field({}, description="reward weights by name")
    objects: list[AskedObjects] = []
    counts: dict[str, Annotated[int, Field(ge=0)]] = Field(
        {}, description="objects wanted in a room"
    )
    total_area: Positive | None = None
    regularity: float = Field(0.7, ge=0, le=1)
    envelope: Envelope = Field(default_factory=Envelope)
    complete: bool = Field(False, description="exactly these rooms and links, nothing may be added")
    unread: list[str] = Field([], description="words of the prompt not understood")
    requirements: list[Requirement] = Field([], description="what else was asked")


class Room(Typed):
    """A built room; `polygon` is its clear floor, wall face to wall face, counter-clockwise."""

    polygon: Polygon


class Opening(Record):
    """A door, window, entrance or wall-less passage.

    `segment` lies on the centre line of the wall it cuts; its length is the clear width.
    A hinged leaf (door, entrance) turns about `segment[hinge]` into the room `into` by 90°.
    """

    id: str
    kind: Literal["door", "opening", "entrance", "window"]
    rooms: list[str] = Field(min_length=1, max_length=2)
    segment: tuple[Point, Point]
    sill: Number
    head: Number
    hinge: Literal[0, 1] = 0
    into: str | None = None


class Walls(Record):
    """Wall thickness in metres; neighbouring floors are `inner` apart."""

    inner: Positive = 0.10
    outer: Positive = 0.30


class Finish(Record):
    """What a room is finished with, by names of materials and designs; empty where it is as usual."""

    style: str = Field("", description="what the rest was drawn from")
    floor: str = ""
    wall: str = ""
    joinery: str = Field("", description="of doors, windows and skirting")
    door: str = Field("", description="a design")
    window: str = Field("", description="a design")
    metal: str = Field("", description="of what one takes doors by")
    woods: list[str] = Field([], description="of furniture, one or two")
    cloth: list[str] = Field([], description="of large seats, of small ones")
    rug: str = ""
    bedding: str = ""
    front: str = Field("", description="of kitchen units, as the next two")
    worktop: str = ""
    handles: str = ""


class Plan(Record):
    """Body of a `plan` artifact."""

    prompt: str = ""
    program: Program
    rooms: list[Room] = Field(min_length=1)
    openings: list[Opening]
    height: Positive = 2.6
    walls: Walls = Field(default_factory=Walls)
    relaxed: list[str] = Field([], description="what the solver had to give up, in words")
    finishes: dict[str, Finish] = Field({}, description="by room")
