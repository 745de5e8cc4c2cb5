"""Draw a floor plan from a sentence."""

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter
from typing import Annotated, Any

import typer

from apartgen.planning import PlanSettings, draw, enclosed, read
from apartgen.requests import Request, decoded, listed, named, sentence
from apartgen.schemas import artifact
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen.stages import seeds
from apartgen.steps import made
from apartgen_cli.console import progress
from apartgen_cli.drawn import Wanted, outline, wanted
from apartgen_cli.options import CONFIG, FAILURES, OUT, RETRY, SEED, configured, tables, with_options
from apartgen_cli.results import Results, results
from apartgen_cli.tally import Tally

PROMPTS = Annotated[list[str] | None, typer.Argument(
    metavar="PROMPT", help='What is wanted, e.g. "two-bedroom flat"; - or a pipe is standard input.')]
FROM = Annotated[str | None, typer.Option(
    "--from", metavar="FILE", help="Instead of a prompt: a programme or rooms drawn by hand, as JSON; a floor plan as "
                                   "sh3d, ifc, dxf, RoomPlan or ProcTHOR JSON.")]
OUTLINE = Annotated[Path | None, typer.Option(
    "--outline", metavar="FILE", help="The clear outline to fill, a JSON list of [x, y] in metres.")]
VARIANTS = Annotated[int, typer.Option("--variants", min=1, max=100, help="Clearly different plans for each prompt.")]
MANY = Annotated[str | None, typer.Option(
    "--prompts", metavar="FILE", help="Prompts, one a line, or JSON with id, prompt, seed, settings; - is a pipe.")]
ONE = Annotated[bool, typer.Option("--one", help="All of standard input is one prompt, not one a line.")]
NAMES = {"party_walls": "party_wall"}


@dataclass(frozen=True)
class Order:
    """A plan to be drawn, of what and as which request; or what is wrong with it."""

    label: str
    wanted: Wanted
    request: Request
    error: ApartgenError | None = None

    def row(self) -> dict[str, Any]:
        """Its line in a list of failures, which is a list of prompts."""
        return self.request.row()


def orders(given: list[str] | None, listing: str | None, one: bool) -> list[Order]:
    """What is asked for: sentences on the command line, a list of prompts, or standard input."""
    if listing is not None:
        if given:
            raise BadInput("--prompts stands instead of sentences; give one of them")
        return _ordered(listed(artifact.contents(listing), "standard input" if listing == STREAM else listing))
    if not given and sys.stdin.isatty():
        raise BadInput('no prompt; say what is wanted, e.g. apartgen plan "two-bedroom flat" -o plan.json')
    texts = [line for text in given or [STREAM] for line in (_piped(one) if text == STREAM else [text])]
    found = [Request(sentence(text)) for text in texts]
    return _ordered([replace(found[0], name="plan")] if len(found) == 1 else list(named(found)))


def _piped(one: bool) -> list[str]:
    """The prompts on standard input: a line each, or all of it."""
    text = decoded(sys.stdin.buffer.read(), "the prompt")
    if text.lstrip()[:1] in ("{", "["):
        sentence(text)
    return [text] if one or not text.strip() else [line for line in text.splitlines() if line.strip()]


def _ordered(found: Sequence[Request | ApartgenError]) -> list[Order]:
    return [Order(str(one).split(": ")[0], Wanted(), Request(""), one) if isinstance(one, ApartgenError)
            else Order(one.id or one.prompt[:60], Wanted(prompt=one.prompt), one) for one in found]


@dataclass(frozen=True)
class _Run:
    """Plans for many requests, each with its own settings and seed."""

    settings: Callable[[Mapping[str, Any]], PlanSettings]
    seed: int | None
    variants: int
    results: Results
    tally: Tally

    def all(self, work: list[Order]) -> Iterator[None]:
        """One order after another."""
        for order in work:
            try:
                self._one(order)
            except ApartgenError as error:
                self.tally.failed(order, error)
            yield

    def _one(self, order: Order) -> None:
        if order.error is not None:
            raise order.error
        config = self.settings(order.request.settings.get("plan", {}))
        seed = (order.request.seed or 0) if self.seed is None else self.seed
        record = made("plan", seed, config).model_copy(update={"id": order.request.id})
        alone = self.variants == 1
        if not (alone and self.results.found(order.request.name, "plan", record, order.wanted.prompt)):
            began = perf_counter()
            plans, used = _several(order.wanted, config, seed, self.variants, order.request.id)
            seconds = round((perf_counter() - began) / self.variants, 2)
            for k, plan in enumerate(plans, 1):
                name = order.request.name if alone else f"{order.request.name}-{k}"
                self.results.put(name, plan, record.model_copy(update={"model": used, "seconds": seconds}))
        self.tally.done()


def _several(one: Wanted, config: PlanSettings, seed: int, k: int, id: str,
             ) -> tuple[list[Plan], dict[str, Any]]:
    from apartgen.stages import plan

    if one.home is not None:
        return [one.home], {}
    if one.rooms:
        return [plan.from_polygons(one.rooms, config, one.program)] * k, {}
    if one.program is None and k == 1:
        single, used = draw(one.prompt, config, seed, id)
        return [single], used
    program, used = (enclosed(one.program, config), {}) if one.program else read(one.prompt, config)
    rng = seeds.drawn(seed, "plan", id or one.id)
    if k == 1:
        return [plan.build(program, config, rng, one.prompt)], used
    return plan.build_variants(program, config, rng, k, one.prompt), used


def _run(inputs: PROMPTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None, from_: FROM = None,
         outline_: OUTLINE = None, variants: VARIANTS = 1, prompts: MANY = None, one: ONE = False,
         failures: FAILURES = None, retry: RETRY = None, *, given: Any) -> int:
    if outline_ is not None:
        given["outline"] = outline(outline_)
    table = tables(config).get("plan", {})
    settings = configured(PlanSettings, given, table, NAMES)
    if retry is not None and prompts is not None:
        raise BadInput("--retry stands instead of --prompts; give one of them")
    work = _asked(inputs, from_, str(retry) if retry else prompts, one, settings)
    if work[0].wanted.rooms and variants > 1:
        raise BadInput("--variants: rooms drawn by hand make one plan; leave it out")
    many = len(work) > 1 or variants > 1
    into = results("plan", [STREAM], out, many)
    with Tally(len(work) > 1, failures or retry) as tally:
        run = _Run(lambda own: configured(PlanSettings, given, table | own, NAMES), seed, variants, into, tally)
        for _ in progress(run.all(work), "plan", len(work)):
            pass
        into.close()
    return tally.status


def _asked(inputs: list[str] | None, from_: str | None, listing: str | None, one: bool, settings: PlanSettings,
           ) -> list[Order]:
    if from_ is None:
        return orders(inputs, listing, one)
    if inputs or listing:
        raise BadInput("--from stands instead of a prompt; give one of them")
    return [Order(from_, wanted(from_, settings), Request("", name="plan"))]


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"plan": with_options(_run, PlanSettings, NAMES)}
