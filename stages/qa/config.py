"""What is asked."""

from pydantic import Field

from apartgen.schemas.base import Record


class QaConfig(Record):
    """Settings of the stage."""

    kind: list[str] = Field(default_factory=list, description="kinds of question, all by default")
    each: int = Field(8, ge=1, le=100, description="most questions of a kind")
