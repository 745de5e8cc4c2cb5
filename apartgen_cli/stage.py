"""Runs one stage over its inputs: reads artifacts, has the stage advance them, writes what comes back.

A command module describes its stage by a `Stage`; `make` chains the same descriptions.
"""

import hashlib
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
from apartgen.schemas.errors import ApartgenError, Unmet
from apartgen.schemas.plan import Plan
from apartgen.stages import seeds
from apartgen_cli import __version__
from apartgen_cli.console import fail, log, progress, say
from apartgen_cli.options import CONFIG, INPUTS, OUT, SEED, configured, tables, with_options
from apartgen_cli.streams import Target, sources, targets

BY = f"apartgen {__version__}"
Kept = TypeVar("Kept")
Outcome = Record | ApartgenError
Advance = Callable[[list[Any], Any, list[np.random.Generator]], Iterable[Outcome]]


@dataclass(frozen=True)
class Stage:
    """One stage as the command line sees it.

    `advance(bodies, config, rngs)` gives, for each body and in order, the next body or the error that prevents it.
    `names` maps fields of the configuration to other option names. `missed(body, config)` says what a result that
    is written all the same falls short of. `data(config)` names the files, beside the input, that a result hangs on.
    """

    word: str
    takes: type[Record]
    config: type[Record]
    advance: Advance
    names: Mapping[str, str] = field(default_factory=dict)
    missed: Callable[[Any, Any], Unmet | None] = lambda body, config: None
    data: Callable[[Any], Mapping[str, Path]] = lambda config: {}

    def command(self) -> Callable[..., Any]:
        """The stage as a command with an option for every described field of its configuration."""

        def run(inputs: INPUTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None, *, given: Any) -> int:
            settings = configured(self.config, given, tables(config).get(self.word), self.names)
            return over(self, inputs, out, seed, settings)

        return with_options(run, self.config, self.names)


def each(step: Callable[[Any, Any, np.random.Generator], Record]) -> Advance:
    """An `Advance` out of a function of one body; an error of one leaves the others be."""

    def advance(bodies: list[Any], config: Any, rngs: list[np.random.Generator]) -> Iterator[Outcome]:
        for body, rng in zip(bodies, rngs):
            try:
                yield step(body, config, rng)
            except ApartgenError as error:
                yield error

    return advance


def lane(seed: int, word: str, home: Plan) -> np.random.Generator:
    """The random numbers of one stage for one apartment: the same alone or in a batch, under whatever name."""
    return seeds.drawn(seed, word, seeds.plan_digest(home))


def made(seed: int, config: Record, previous: Artifact[Any] | None = None, seconds: float = 0.0,
         data: Mapping[str, Path] | None = None) -> Made:
    """How a result of this program came about."""
    inputs = {previous.kind: previous.digest} if previous else {}
    inputs |= {name: _digest(file) for name, file in (data or {}).items() if file.is_file()}
    return Made(by=BY, seed=seed, config=config.model_dump(mode="json"), inputs=inputs, seconds=round(seconds, 2))


def _digest(file: Path) -> str:
    return "sha256:" + hashlib.sha256(file.read_bytes()).hexdigest()


def over(stage: Stage, inputs: Sequence[str] | None, out: str | None, seed: int | None, config: Record) -> int:
    """Run a stage over all inputs; every result is written as soon as it is there. Returns the exit status."""
    names = sources(inputs)
    places = dict(zip(names, targets(stage.word, names, out)))
    work, errors = opened([(name, name) for name in names], stage.takes)
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


def _told(stage: Stage, inputs: list[tuple[str, Any]], config: Record, rngs: list[np.random.Generator],
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


def opened(pairs: Iterable[tuple[str, Kept]], model: type[Record], whole: bool = False,
           ) -> tuple[list[tuple[Kept, Artifact[Any]]], list[ApartgenError]]:
    """The inputs that can be read, each with what was paired with its name, and what is wrong with the others."""
    work: list[tuple[Kept, Artifact[Any]]] = []
    errors: list[ApartgenError] = []
    for name, place in pairs:
        try:
            work.append((place, artifact.read(name, model, whole)))
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
