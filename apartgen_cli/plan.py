"""Draw a floor plan from a sentence."""

import re
import sys
from collections.abc import Callable, Iterator
from time import perf_counter
from typing import Annotated, Any

import typer
from pydantic import Field

from apartgen_cli.console import progress
from apartgen_cli.options import CONFIG, OUT, SEED, configured, tables, with_options
from apartgen_cli.stage import lane, made, settled, written
from apartgen_cli.streams import Target, is_folder, targets
from schemas.artifact import STREAM
from schemas.errors import ApartgenError, BadInput
from schemas.plan import Plan, Program
from stages.plan.config import PlanConfig

PROMPTS = Annotated[list[str] | None, typer.Argument(
    metavar="PROMPT", help='What is wanted, e.g. "two-bedroom flat"; - or a pipe is standard input.')]
_LONGEST = 10_000
_SLUG = 48


class PlanSettings(PlanConfig):
    """The solver's settings, and how the prompt is read."""

    llm: str | None = Field(None, description="Language model that reads the prompt, by its litellm name; "
                                              "the embedded reader by default.")


def draw(prompt: str, config: PlanSettings, seed: int) -> Plan:
    """The plan for one prompt."""
    from stages import plan

    return plan.build(_read(prompt, config), config, lane(seed, "plan"), prompt)


def _read(prompt: str, config: PlanSettings) -> Program:
    if config.llm is None:
        from stages.plan import reader

        return reader.read(prompt)
    from stages.plan import llm

    return llm.read(prompt, config.llm)[0]


def prompts(given: list[str] | None) -> list[str]:
    """The prompts on the command line or standard input, stripped and checked."""
    if not given and sys.stdin.isatty():
        raise BadInput('no prompt; say what is wanted, e.g. apartgen plan "two-bedroom flat" -o plan.json')
    texts = [sys.stdin.buffer.read().decode("utf-8", "surrogateescape") if text == STREAM else text
             for text in given or [STREAM]]
    return [checked(text) for text in texts]


def checked(text: str) -> str:
    """The prompt without space around it; BadInput when it cannot be one."""
    text = text.strip()
    if not text:
        raise BadInput('the prompt is empty; say what is wanted, e.g. "two-bedroom flat"')
    if len(text) > _LONGEST:
        raise BadInput(f"the prompt has {len(text)} characters; at most {_LONGEST} are read")
    if not text.isprintable() and any("\ud800" <= c <= "\udfff" or c == "\0" for c in text):
        raise BadInput("the prompt is not UTF-8 text; give it in that encoding")
    return text


def _places(texts: list[str], out: str | None) -> list[Target]:
    """One place a prompt; in a folder, named after the prompt's words."""
    if out is None or not is_folder(out):
        return targets("plan", [STREAM] * len(texts), out)
    slugs = ["-".join(re.findall(r"\w+", text.lower()))[:_SLUG].strip("-") or "plan" for text in texts]
    names = [f"{slug}-{slugs[:i].count(slug) + 1}" if slugs.count(slug) > 1 else slug for i, slug in enumerate(slugs)]
    return targets("plan", ["plan.json"] if len(texts) == 1 else [f"{name}.json" for name in names], out)


def _drawn(texts: list[str], config: PlanSettings, seed: int) -> Iterator[Plan | ApartgenError]:
    for text in texts:
        try:
            yield draw(text, config, seed)
        except ApartgenError as error:
            yield error


def _run(inputs: PROMPTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None, *, given: Any) -> int:
    settings = configured(PlanSettings, given, tables(config).get("plan"))
    texts = prompts(inputs)
    places, seed = _places(texts, out), seed or 0
    errors: list[ApartgenError] = []
    began = perf_counter()
    for place, plan in zip(places, progress(_drawn(texts, settings, seed), "plan", len(texts))):
        if isinstance(plan, ApartgenError):
            errors.append(plan)
            continue
        written(plan, made(seed, settings, seconds=perf_counter() - began), place)
        began = perf_counter()
    return settled(errors, len(texts))


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"plan": with_options(_run, PlanSettings)}
