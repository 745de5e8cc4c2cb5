"""Make a whole apartment from a sentence, every stage in one process."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.planning import checked
from apartgen.schemas.base import Record
from apartgen.whole import DEFAULT_FORMATS, KINDS, make
from apartgen_cli.console import say
from apartgen_cli.export import FORMATS
from apartgen_cli.options import CONFIG, checked_seed, configured, tables
from apartgen_cli.streams import made_folder

PROMPT = Annotated[str, typer.Argument(metavar="PROMPT", help='What is wanted, e.g. "two-bedroom flat".')]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; what is already there goes on from.")]
SEED = Annotated[int, typer.Option("--seed", min=0, callback=checked_seed, help="Fixes everything drawn.")]
FORMAT = Annotated[list[str] | None, typer.Option(
    "--format", help=f"Any number of times; of {', '.join(FORMATS)}. [default: {', '.join(DEFAULT_FORMATS)}]")]
POPULATE = Annotated[bool, typer.Option("--populate/--no-populate", help="Put small things into the home.")]
LLM = Annotated[str | None, typer.Option("--llm", help="Language model that reads the prompt, by its litellm name.")]


def settings(file: Path | None, formats: list[str], llm: str | None) -> dict[str, Record]:
    """The configuration of every stage, from the tables of a settings file and the options."""
    table = tables(file)
    # What one stage took from a library, the later ones look up there.
    libraries = {"libraries": table.get("retrieve", {}).get("libraries", [])}
    given: dict[str, dict[str, Any]] = {"plan": {"llm": llm} if llm else {}, "walkable": libraries,
                                        "populate": libraries, "export": libraries | {"format": formats}}
    return {word: configured(kind, given.get(word, {}), table.get(word)) for word, kind in KINDS.items()}


def _run(prompt: PROMPT, out: FOLDER, seed: SEED = 0, format: FORMAT = None, llm: LLM = None,
         config: CONFIG = None, populate: POPULATE = True) -> None:
    """Make a whole apartment; a run that was stopped, or whose settings changed in part, goes on where it can."""
    chosen = settings(config, format or list(DEFAULT_FORMATS), llm)
    if not populate:
        del chosen["populate"]
    for file in make(checked(prompt), made_folder(out), seed, chosen):
        say(str(file))


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"make": _run}
