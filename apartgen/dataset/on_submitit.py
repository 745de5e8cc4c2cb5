"""Jobs of Slurm by submitit: some homes a job, so that loading the models is paid once for all of them.

Where there is no Slurm, submitit runs the jobs on this machine. Partition, account and the like are Slurm's own
variables: SBATCH_PARTITION, SBATCH_ACCOUNT.
"""

import shutil
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

from apartgen.schemas.errors import BadInput

Work = TypeVar("Work")
Result = TypeVar("Result")
A_JOB = 100
"""Pieces a job."""
JOBS = 64
"""Jobs under way, where nobody says."""
MINUTES = 24 * 60
LOGS = ".jobs"
"""Where jobs keep what they are given, say and answer; it is cleared away at the end."""


def results(function: Callable[[Work], Result], work: Iterable[Work], workers: int | None,
            lost: Callable[[Work], Result], folder: Path) -> Iterator[Result]:
    """As `pool.results`, `workers` jobs at a time. Where a job ends without an answer, each of its pieces is a job of
    its own, once.
    """
    executor = _executor(folder / LOGS)
    pieces = iter(work)
    waiting: deque[tuple[list[Work], Any]] = deque()
    try:
        while True:
            while len(waiting) < (workers or JOBS) and (batch := list(islice(pieces, A_JOB))):
                waiting.append((batch, executor.submit(_each, function, batch)))
            if not waiting:
                return
            batch, job = waiting.popleft()
            yield from _answer(job) or _one_by_one(executor, function, batch, lost)
    finally:
        for _, job in waiting:
            job.cancel()
        shutil.rmtree(folder / LOGS, ignore_errors=True)


def _each(function: Callable[[Work], Result], batch: list[Work]) -> list[Result]:
    return [function(piece) for piece in batch]


def _one_by_one(executor: Any, function: Callable[[Work], Result], batch: list[Work], lost: Callable[[Work], Result],
                ) -> Iterator[Result]:
    jobs = [executor.submit(partial(_each, function), [piece]) for piece in batch]
    for piece, job in zip(batch, jobs):
        yield from _answer(job) or [lost(piece)]


def _answer(job: Any) -> list[Any] | None:
    """What a job gives; None where it was killed, or Slurm ended it. What the work itself raises is raised."""
    from submitit.core.utils import FailedJobError, UncompletedJobError

    try:
        return list(job.result())
    except FailedJobError:
        raise
    except UncompletedJobError:
        return None


def _executor(folder: Path) -> Any:
    try:
        import submitit
    except ImportError:
        raise BadInput('--engine submitit: submitit is not installed; pip install "apartgen[submitit]"') from None
    executor = submitit.AutoExecutor(folder)
    executor.update_parameters(name="apartgen", timeout_min=MINUTES, cpus_per_task=1, tasks_per_node=1)
    return executor
