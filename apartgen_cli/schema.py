"""Show the JSON Schema of an artifact."""

import json
from collections.abc import Callable
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import BODIES, json_schema, write

KIND = Annotated[str, typer.Argument(metavar="KIND", help=f"One of {', '.join(BODIES)}.")]


def show(kind: KIND, out: Annotated[str, typer.Option("--out", "-o", help="A file; standard output by default.")] = "-",
         ) -> None:
    """Write the schema."""
    write(json.dumps(json_schema(kind), indent=2, ensure_ascii=False) + "\n", out)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"schema": show}
