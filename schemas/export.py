"""The list of files an export wrote."""

from pydantic import Field

from apartgen.schemas.base import Record


class File(Record):
    """One file, its path relative to the output folder."""

    path: str
    format: str
    sha256: str


class Export(Record):
    """Body of an `export` artifact."""

    files: list[File] = Field(default_factory=list)
    credits: list[str] = Field(default_factory=list)
