"""Rows of a manifest as they must be, whoever wrote them."""

from pathlib import PurePath
from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput

Row = dict[str, Any]
FURTHEST = 2**62
"""No home begins further on in its shard, and nothing can be looked for beyond, bytes."""
LONGEST = 2**30
"""No home takes more of a shard, bytes; so much is made room for before it is read."""
WIDEST = 1e6
"""No room is wider, m: the squares of sides are added up."""


def _plain(name: str) -> str:
    """The name of a file in a folder, not a way out of it."""
    if not name or PurePath(name).name != name or "\x00" in name:
        raise ValueError("not the plain name of a file")
    return name


class _Asked(BaseModel):
    """What every row has; others add fields freely."""

    model_config = ConfigDict(strict=True, extra="allow")
    id: Annotated[str, AfterValidator(_plain)]
    prompt: str
    seed: int
    seconds: dict[str, float]


class _Failed(_Asked):
    """A request that could not be met."""

    error: str


class _Made(_Asked):
    """A home, and where it is."""

    shard: Annotated[str, AfterValidator(_plain)]
    start: int = Field(ge=0, le=FURTHEST)
    length: int = Field(ge=0, le=LONGEST)
    sha256: str
    kind: str
    digests: dict[str, str]
    certified: bool
    metrics: dict[str, float | None]
    rooms: dict[str, int]
    objects: dict[str, int]
    signature: str
    sides: list[Annotated[float, Field(ge=0, le=WIDEST)]] = Field(min_length=2)
    area: float
    split: str = ""


class _About(BaseModel):
    """What a data set was asked for."""

    model_config = ConfigDict(strict=True, extra="allow")
    by: str
    seed: int
    count: int = Field(ge=0)
    per_shard: int = Field(gt=0)
    stages: list[str]
    settings: dict[str, dict[str, Any]]
    source: dict[str, Any]
    parts: dict[str, float] = Field(default_factory=dict)


_KNOWN: dict[bool, TypeAdapter[Any]] = {True: TypeAdapter(_Made), False: TypeAdapter(_Failed)}


def about(value: dict[str, Any], where: str) -> dict[str, Any]:
    """What a data set was asked for. BadInput where something of it is missing."""
    try:
        _About.model_validate(value)
    except ValidationError as error:
        raise BadInput(f"{where}: {artifact.first_fault(error)}; take the file from a copy") from None
    return value


def row(line: bytes, where: str) -> Row:
    """A row from its line. BadInput where it is damaged."""
    value = artifact.json_value(line, where)
    if not isinstance(value, dict):
        raise BadInput(f"{where}: not a row of a manifest")
    try:
        _KNOWN["shard" in value].validate_python(value)
    except ValidationError as error:
        raise BadInput(f"{where}: {artifact.first_fault(error)}; take the file from a copy") from None
    if "shard" in value and value["kind"] not in value["digests"]:
        raise BadInput(f"{where}: digests: none of its {value['kind']}")
    return value
