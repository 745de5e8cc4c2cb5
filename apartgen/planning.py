"""From a request to a floor plan: how the sentence is read, what is fixed around the flat, what is drawn."""

import logging
import os
from pathlib import Path
from typing import Any

from numpy.random import Generator
from pydantic import Field

from apartgen.schemas.base import Polygon
from apartgen.schemas.errors import BadInput, Unmet
from apartgen.schemas.plan import Envelope, Plan, Program, Side
from apartgen.stages import seeds
from apartgen.stages.plan.config import PlanConfig

log = logging.getLogger("apartgen")
_LONGEST = 10_000


class PlanSettings(PlanConfig):
    """The solver's settings, how the prompt is read, and what stands fixed around the flat."""

    llm: str | None = Field(None, description="Language model that reads the prompt, by its litellm name; "
                                              "the embedded reader by default")
    entrance: Side | None = Field(None, description="Side of the entrance")
    party_walls: list[Side] = Field(default_factory=list, description="Side without windows, any number of times")
    facades: int | None = Field(None, ge=1, le=4, description="Sides with windows; drawn where nobody says")
    outline: Polygon | None = None



def read(prompt: str, config: PlanSettings, rng: Generator | None = None) -> tuple[Program, dict[str, Any]]:
    """The programme of a prompt, and what a language model took to read it; `rng` draws what the prompt leaves open."""
    if config.llm is None:
        from apartgen.stages.plan import reader

        program, used = reader.read(prompt, rng), dict[str, Any]()
    else:
        from apartgen.stages.plan import llm

        program, used = llm.read(prompt, config.llm, _cache())
    if program.unread:
        log.warning("not understood in the prompt: %s", ", ".join(f'"{words}"' for words in program.unread))
    return enclosed(program, config), used


def enclosed(program: Program, config: PlanSettings) -> Program:
    """The programme with what the settings say of its surroundings."""
    given = {name: getattr(config, name) for name in ("entrance", "party_walls", "facades", "outline")}
    envelope = program.envelope.model_dump() | {name: value for name, value in given.items() if value}
    return program.model_copy(update={"envelope": Envelope.model_validate(envelope)})


def draw(prompt: str, config: PlanSettings, seed: int, id: str = "") -> tuple[Plan, dict[str, Any]]:
    """The plan for one prompt, and what a language model took to read it; it draws by its id, else by its words."""
    from apartgen.stages import plan

    rng, again = (seeds.drawn(seed, "plan", id or prompt, *more) for more in ((), ("again",)))
    program, used = read(prompt, config, rng.spawn(1)[0])
    try:
        return plan.build(program, config, rng, prompt), used
    except Unmet:
        other = program if config.llm else _drawn_anew(prompt, config, again)
        if other == program:
            raise
        log.warning("%s: what the request leaves open is drawn anew, as no plan had room for it", prompt)
        return plan.build(other, config, again, prompt), used


def _drawn_anew(prompt: str, config: PlanSettings, rng: Generator) -> Program:
    """The programme with other rooms and areas where the prompt leaves them open."""
    from apartgen.stages.plan import reader

    return enclosed(reader.read(prompt, rng.spawn(1)[0]), config)


def checked(text: str) -> str:
    """The prompt without space around it; BadInput when it cannot be one."""
    text = text.strip()
    if not text:
        raise BadInput('the prompt is empty; say what is wanted, e.g. "two-bedroom flat"')
    if len(text) > _LONGEST:
        raise BadInput(f"the prompt has {len(text)} characters; at most {_LONGEST} are read")
    if any("\ud800" <= c <= "\udfff" or c == "\0" for c in text):
        raise BadInput("the prompt is not UTF-8 text; give it in that encoding")
    return text


def _cache() -> Path:
    base = os.environ.get("XDG_CACHE_HOME")
    return (Path(base) if base else Path.home() / ".cache") / "apartgen" / "llm"
