"""Runs one stage over its inputs: reads artifacts, has the stage advance them, writes what comes back.

A command module names its step and how options are called; `make` chains the same steps.
"""

import logging
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from time import perf_counter
from typing import Any, TypeVar

import numpy as np

from apartgen.schemas import artifact
from apartgen.schemas.artifact import STREAM, Artifact, Made
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError
from apartgen.steps import Outcome, Step, lane, made
from apartgen_cli.check import Reader, read_sound, reader
from apartgen_cli.console import fail, log, progress, say
from apartgen_cli.options import CONFIG, INPUTS, OUT, SEED, TRUST, configured, tables, with_options
from apartgen_cli.streams import Target, sources, targets

Kept = TypeVar("Kept")


@dataclass(frozen=True)
class Stage:
    """A step as the command line sees it; `names` maps fields of its configuration to other option names."""

    step: Step
    names: Mapping[str, str] = field(default_factory=dict)

    def command(self) -> Callable[..., Any]:
        """The stage as a command with an option for every described field of its configuration."""

        def run(inputs: INPUTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None,
                trust: TRUST = False, *, given: Any) -> int:
            settings = configured(self.step.config, given, tables(config).get(self.step.word), self.names)
            return over(self.step, inputs, out, seed, settings, trust)

        return with_options(run, self.step.config, self.names)


def over(stage: Step, inputs: Sequence[str] | None, out: str | None, seed: int | None, config: Record,
         trust: bool = False) -> int:
    """Run a stage over all inputs; every result is written as soon as it is there. Returns the exit status."""
    names = sources(inputs)
    places = dict(zip(names, targets(stage.word, names, out)))
    work, errors = opened([(name, name) for name in names], stage.takes, stage.rather is not None, reader(trust))
    work = [(name, stage.taken(read) if stage.rather else read) for name, read in work]
    used_seeds = [read.made.seed if seed is None else seed for _, read in work]
    began = perf_counter()
    outcomes = _told(stage, [(name, read.body) for name, read in work], config,
                    [lane(s, stage.word, read.body) for s, (_, read) in zip(used_seeds, work)])
    for (name, read), used, outcome in zip(work, used_seeds, progress(outcomes, stage.word, len(work))):
        if isinstance(outcome, ApartgenError):
            errors.append(about(name, outcome, len(names)))
            continue
        written(outcome, made(used, config, read, perf_counter() - began, stage.data(config)), places[name])
        if short := stage.missed(outcome, config):
            errors.append(about(name, short, len(names)))
        began = perf_counter()
    return settled(errors, len(names))


def _told(stage: Step, inputs: list[tuple[str, Any]], config: Record, rngs: list[np.random.Generator],
          ) -> Iterator[Outcome]:
    """What comes of every input; where there are several, what is said about one begins with its name.

    A message is about the body that its record bears, as of stages that do all at once, else about the next in turn.
    """
    names, now = {id(body): name for name, body in inputs}, ""

    def named(record: logging.LogRecord) -> bool:
        if name := names.get(id(getattr(record, "body", None)), now):
            record.msg, record.args = f"{name}: {record.getMessage()}", ()
        return True

    if len(inputs) > 1:
        log.addFilter(named)
    try:
        outcomes = iter(stage.advance([body for _, body in inputs], config, rngs))
        for name, _ in inputs:
            now = name
            outcome = next(outcomes)
            now = ""
            yield outcome
    finally:
        log.removeFilter(named)


def about(name: str, error: ApartgenError, total: int) -> ApartgenError:
    """The error with the name of its input, where there are several."""
    return type(error)(f"{name}: {error}") if total > 1 else error


def opened(pairs: Iterable[tuple[str, Kept]], model: type[Record], whole: bool = False, read: Reader = read_sound,
           ) -> tuple[list[tuple[Kept, Artifact[Any]]], list[ApartgenError]]:
    """The inputs that can be read, each with what was paired with its name, and what is wrong with the others."""
    work: list[tuple[Kept, Artifact[Any]]] = []
    errors: list[ApartgenError] = []
    for name, place in pairs:
        try:
            work.append((place, read(name, model, whole)))
        except ApartgenError as error:
            errors.append(error)
    return work, errors


def written(body: Record, made: Made, place: Target) -> None:
    """Write one result."""
    text, _ = artifact.finish(body, made)
    artifact.write(text, place)
    if str(place) != STREAM:
        say(f"wrote {Path(place)}")


def settled(errors: list[ApartgenError], total: int) -> int:
    """The exit status after all inputs; a single input's error is raised as it is."""
    if total == 1 and errors:
        raise errors[0]
    for error in errors:
        fail(str(error))
    if errors:
        fail(f"{len(errors)} of {total} could not be done")
    return max((error.exit_code for error in errors), default=0)
