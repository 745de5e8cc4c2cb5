"""Draw a floor plan from a sentence."""

import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from time import perf_counter
from typing import Annotated, Any

import typer

from apartgen.planning import PlanSettings, checked, draw, enclosed, read
from apartgen.schemas.artifact import STREAM, Made
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen.stages import seeds
from apartgen.steps import made
from apartgen_cli.console import progress
from apartgen_cli.drawn import Wanted, outline, wanted
from apartgen_cli.options import CONFIG, OUT, SEED, configured, tables, with_options
from apartgen_cli.stage import settled, written
from apartgen_cli.streams import Target, is_folder, targets

PROMPTS = Annotated[list[str] | None, typer.Argument(
    metavar="PROMPT", help='What is wanted, e.g. "two-bedroom flat"; - or a pipe is standard input.')]
FROM = Annotated[str | None, typer.Option(
    "--from", metavar="FILE", help="A programme, or rooms drawn by hand, as JSON, instead of a prompt.")]
OUTLINE = Annotated[Path | None, typer.Option(
    "--outline", metavar="FILE", help="The clear outline to fill, a JSON list of [x, y] in metres.")]
VARIANTS = Annotated[int, typer.Option("--variants", min=1, max=100, help="Clearly different plans for each prompt.")]
_SLUG = 48
NAMES = {"party_walls": "party_wall"}


def prompts(given: list[str] | None) -> list[str]:
    """The prompts on the command line or standard input, stripped and checked."""
    if not given and sys.stdin.isatty():
        raise BadInput('no prompt; say what is wanted, e.g. apartgen plan "two-bedroom flat" -o plan.json')
    texts = [sys.stdin.buffer.read().decode("utf-8", "surrogateescape") if text == STREAM else text
             for text in given or [STREAM]]
    return [checked(text) for text in texts]


def _places(texts: list[str], variants: int, out: str | None) -> list[Target]:
    """One place a plan; in a folder, named after the prompt's words."""
    if out is None or not is_folder(out):
        return targets("plan", [STREAM] * len(texts) * variants, out)
    slugs = ["-".join(re.findall(r"\w+", text.lower()))[:_SLUG].strip("-") or "plan" for text in texts]
    if len(texts) == 1:
        slugs = ["plan"]
    each = [slug for slug in slugs for _ in range(variants)]
    names = [f"{slug}-{each[:i].count(slug) + 1}" if each.count(slug) > 1 else slug for i, slug in enumerate(each)]
    return targets("plan", [f"{name}.json" for name in names], out)


def _outcomes(
    work: list[Wanted], config: PlanSettings, seed: int, k: int
) -> Iterator[tuple[Plan, Made] | ApartgenError]:
    """`k` plans, or errors, for everything wanted."""
    for one in work:
        began = perf_counter()
        try:
            plans, used = _several(one, config, seed, k)
        except ApartgenError as error:
            yield from [error] * k
            continue
        record = made(seed, config, seconds=(perf_counter() - began) / k)
        for plan in plans:
            yield plan, record.model_copy(update={"model": used})


def _several(one: Wanted, config: PlanSettings, seed: int, k: int) -> tuple[list[Plan], dict[str, Any]]:
    from apartgen.stages import plan

    if one.rooms:
        return [plan.from_polygons(one.rooms, config, one.program)] * k, {}
    if one.program is None and k == 1:
        single, used = draw(one.prompt, config, seed)
        return [single], used
    program, used = (enclosed(one.program, config), {}) if one.program else read(one.prompt, config)
    rng = seeds.drawn(seed, "plan", one.id)
    if k == 1:
        return [plan.build(program, config, rng, one.prompt)], used
    return plan.build_variants(program, config, rng, k, one.prompt), used


def _run(inputs: PROMPTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None, from_: FROM = None,
         outline_: OUTLINE = None, variants: VARIANTS = 1, *, given: Any) -> int:
    if outline_ is not None:
        given["outline"] = outline(outline_)
    settings = configured(PlanSettings, given, tables(config).get("plan"), NAMES)
    if from_ and inputs:
        raise BadInput("--from stands instead of a prompt; give one of them")
    work = [wanted(from_)] if from_ else [Wanted(prompt=text) for text in prompts(inputs)]
    if work[0].rooms and variants > 1:
        raise BadInput("--variants: rooms drawn by hand make one plan; leave it out")
    places = _places([one.prompt for one in work], variants, out)
    errors: list[ApartgenError] = []
    outcomes = _outcomes(work, settings, seed or 0, variants)
    for place, outcome in zip(places, progress(outcomes, "plan", len(places))):
        if isinstance(outcome, ApartgenError):
            errors += [outcome] if outcome not in errors else []
            continue
        written(*outcome, place)
    return settled(errors, len(work))


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"plan": with_options(_run, PlanSettings, NAMES)}
