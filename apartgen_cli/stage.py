"""Runs one stage over its inputs: reads artifacts, has the stage advance them, writes what comes back.

A command module names its step and how options are called; `make` chains the same steps.
"""

import logging
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from apartgen.schemas.artifact import Made
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError
from apartgen.steps import Outcome, Step, lane, made
from apartgen_cli.check import judge
from apartgen_cli.console import log, progress
from apartgen_cli.inputs import Read, artifacts, inputs_of, named
from apartgen_cli.options import (
    CONFIG,
    FAILURES,
    INPUTS,
    OUT,
    RETRY,
    SEED,
    TRUST,
    configured,
    tables,
    with_options,
)
from apartgen_cli.results import Results, results
from apartgen_cli.tally import Tally

AT_ONCE = 16
"""Inputs that a stage is given together; so many are in memory."""


@dataclass(frozen=True)
class Stage:
    """A step as the command line sees it; `names` maps fields of its configuration to other option names."""

    step: Step
    names: Mapping[str, str] = field(default_factory=dict)

    def command(self) -> Callable[..., Any]:
        """The stage as a command with an option for every described field of its configuration."""

        def run(inputs: INPUTS = None, out: OUT = None, seed: SEED = None, config: CONFIG = None,
                trust: TRUST = False, failures: FAILURES = None, retry: RETRY = None, *, given: Any) -> int:
            settings = configured(self.step.config, given, tables(config).get(self.step.word), self.names)
            return over(self.step, inputs, out, seed, settings, trust, failures, retry)

        return with_options(run, self.step.config, self.names)


def over(stage: Step, inputs: Sequence[str] | None, out: str | None, seed: int | None, config: Record,
         trust: bool = False, failures: Path | None = None, retry: Path | None = None) -> int:
    """Run a stage over all inputs; every result is written as soon as it is there. Returns the exit status."""
    given = inputs_of(inputs, retry)
    into = results(stage.word, given.files, out, given.many)
    reads = named(artifacts(given.items, stage.takes, stage.rather is not None, judge(trust)))
    with Tally(given.many, failures or retry) as tally:
        run = _Run(stage, config, seed, into, tally)
        for _ in progress(run.all(reads), stage.word, given.total):
            pass
        into.close()
    return tally.status


@dataclass
class _Run:
    """A stage over inputs, some at a time."""

    stage: Step
    config: Record
    seed: int | None
    results: Results
    tally: Tally

    def all(self, reads: Iterator[Read]) -> Iterator[None]:
        """Everything that comes; gives something at every input that is done with."""
        while some := list(islice(reads, AT_ONCE if self.tally.many else 1)):
            wanted = [self._wanted(read) for read in some]
            outcomes = self._outcomes([(read, record) for read, record in zip(some, wanted) if record])
            for read, record in zip(some, wanted):
                if record:
                    self._settled(read, record, outcomes)
                yield

    def _wanted(self, read: Read) -> Made | None:
        """How the result is to come about; None where it is there, or can't be."""
        if isinstance(read.outcome, ApartgenError):
            self.tally.failed(read, read.outcome)
            return None
        if fault := self.stage.refused(read.outcome.kind):
            self.tally.failed(read, fault)
            return None
        used = read.outcome.made.seed if self.seed is None else self.seed
        wanted = made(self.stage.word, used, self.config, read.outcome, data=self.stage.data(self.config))
        found = self.results.found(read.name, self.stage.word, wanted, read.artifact.body.prompt)
        if found is None:
            return wanted
        self._tallied(read, found.body)
        return None

    def _outcomes(self, work: list[tuple[Read, Made]]) -> Iterator[Outcome]:
        homes = [(read.label, self.stage.taken(read.artifact).body if self.stage.rather else read.artifact.body)
                 for read, _ in work]
        lanes = [lane(record.seed, self.stage.word, home) for (_, record), (_, home) in zip(work, homes)]
        return _told(self.stage, homes, self.config, lanes, self.tally.many)

    def _settled(self, read: Read, record: Made, outcomes: Iterator[Outcome]) -> None:
        began, outcome = perf_counter(), next(outcomes)
        if isinstance(outcome, ApartgenError):
            self.tally.failed(read, outcome)
            return
        seconds = round(perf_counter() - began, 2)
        self.results.put(read.name, outcome, record.model_copy(update={"seconds": seconds}))
        self._tallied(read, outcome)

    def _tallied(self, read: Read, body: Any) -> None:
        if short := self.stage.missed(body, self.config):
            self.tally.failed(read, short)
        else:
            self.tally.done()


def _told(stage: Step, inputs: list[tuple[str, Any]], config: Record, rngs: list[np.random.Generator],
          many: bool) -> Iterator[Outcome]:
    """What comes of every input; where there are several, what is said about one begins with its name.

    A message is about the body that its record bears, as of stages that do all at once, else about the next in turn.
    """
    names, now = {id(body): name for name, body in inputs}, ""

    def named(record: logging.LogRecord) -> bool:
        if name := names.get(id(getattr(record, "body", None)), now):
            record.msg, record.args = f"{name}: {record.getMessage()}", ()
        return True

    if many:
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
