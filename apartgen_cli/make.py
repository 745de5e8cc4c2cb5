"""Make a whole apartment from a sentence, every stage in one process."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.requests import Request, listed, sentence
from apartgen.schemas import artifact
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.whole import DEFAULT_FORMATS, KINDS, make
from apartgen_cli.console import progress, say
from apartgen_cli.export import FORMATS, unless_empty
from apartgen_cli.options import CONFIG, FAILURES, RETRY, checked_seed, configured, tables
from apartgen_cli.streams import made_folder
from apartgen_cli.tally import Tally

Settings = Mapping[str, Mapping[str, Any]]
PROMPT = Annotated[str | None, typer.Argument(metavar="PROMPT", help='What is wanted, e.g. "two-bedroom flat".')]
FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; what is already there goes on from.")]
SEED = Annotated[int | None, typer.Option(
    "--seed", min=0, callback=checked_seed, help="Fixes everything drawn; 0, or the request's, by default.")]
MANY = Annotated[str | None, typer.Option(
    "--prompts", metavar="FILE", help="A list of prompts, as of `plan`; each gets a folder in the given one.")]
FORMAT = Annotated[list[str] | None, typer.Option(
    "--format", help=f"Any number of times; of {', '.join(FORMATS)}. [default: {', '.join(DEFAULT_FORMATS)}]")]
POPULATE = Annotated[bool, typer.Option("--populate/--no-populate", help="Put small things into the home.")]
LLM = Annotated[str | None, typer.Option("--llm", help="Language model that reads the prompt, by its litellm name.")]


def settings(file: Path | None, formats: list[str], llm: str | None, own: Settings | None = None) -> dict[str, Record]:
    """The configuration of every stage, from the tables of a settings file, a request's `own` and the options."""
    table = tables(file)
    table |= {word: {**table.get(word, {}), **values} for word, values in (own or {}).items()}
    # What one stage took from a library, the later ones look up there.
    libraries = {"libraries": table.get("retrieve", {}).get("libraries", [])}
    given: dict[str, dict[str, Any]] = {"plan": {"llm": llm} if llm else {}, "walkable": libraries,
                                        "populate": libraries, "export": libraries | {"format": formats}}
    return {word: configured(kind, given.get(word, {}), table.get(word)) for word, kind in KINDS.items()}


def _run(out: FOLDER, prompt: PROMPT = None, seed: SEED = None, format: FORMAT = None, llm: LLM = None,
         config: CONFIG = None, populate: POPULATE = True, prompts: MANY = None, failures: FAILURES = None,
         retry: RETRY = None) -> int:
    """Make a whole apartment; a run that was stopped, or whose settings changed in part, goes on where it can."""
    if sum(given is not None for given in (prompt, prompts, retry)) != 1:
        raise BadInput("give a prompt, or --prompts, or --retry; one of them")
    listing = str(retry) if retry is not None else prompts
    if listing is None:
        _one(Request(sentence(str(prompt))), made_folder(out), seed, partial(_settings, config, format, llm, populate))
        return 0
    name = "standard input" if listing == STREAM else listing
    work = [_Asked(one) for one in listed(artifact.contents(listing), name)]
    with Tally(True, failures or retry) as tally:
        for asked in progress(work, "make", len(work)):
            try:
                request = asked.checked()
                with unless_empty(Path(out) / request.name) as folder:
                    made_folder(str(folder))
                    _one(request, folder, seed, partial(_settings, config, format, llm, populate))
            except ApartgenError as error:
                tally.failed(asked, error)
            else:
                tally.done()
    return tally.status


@dataclass(frozen=True)
class _Asked:
    """A request of a list, or what is wrong with its line."""

    one: Request | ApartgenError

    @property
    def label(self) -> str:
        """What messages call it."""
        return self.one.name if isinstance(self.one, Request) else str(self.one).split(": ")[0]

    def row(self) -> dict[str, Any] | None:
        """Its line in a list of failures."""
        return self.one.row() if isinstance(self.one, Request) else None

    def checked(self) -> Request:
        """The request; raises what is wrong with it."""
        if isinstance(self.one, ApartgenError):
            raise self.one
        return self.one


def _one(request: Request, folder: Path, seed: int | None, chosen: Callable[[Settings], dict[str, Record]]) -> None:
    used = (request.seed or 0) if seed is None else seed
    for file in make(request.prompt, folder, used, chosen(request.settings), request.id):
        say(str(file))


def _settings(config: Path | None, formats: list[str] | None, llm: str | None, populate: bool, own: Settings,
              ) -> dict[str, Record]:
    chosen = settings(config, formats or list(DEFAULT_FORMATS), llm, own)
    return chosen if populate else {word: one for word, one in chosen.items() if word != "populate"}


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"make": _run}
