"""A Ray cluster that is there already: homes are tasks of one core, done again where a node dies with them."""

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

from apartgen.dataset.pool import AHEAD
from apartgen.schemas.errors import BadInput

Work = TypeVar("Work")
Result = TypeVar("Result")
AGAIN = 3
"""How often a piece is begun anew whose worker or node died."""


def results(function: Callable[[Work], Result], work: Iterable[Work], workers: int | None,
            lost: Callable[[Work], Result], folder: Path) -> Iterator[Result]:
    """As `pool.results`; no more than some pieces a core are under way, so that neither work nor results pile up.

    Ray's workers live on from task to task, with what they have loaded, and think with one thread each.
    """
    ray = _connected()
    task = ray.remote(num_cpus=1, max_retries=AGAIN)(_done)
    cores = workers or max(1, int(ray.cluster_resources().get("CPU", 1)))
    pieces = iter(work)
    waiting: deque[tuple[Work, Any]] = deque()
    try:
        while True:
            fresh = islice(pieces, cores * AHEAD - len(waiting))
            waiting.extend((piece, task.remote(function, piece)) for piece in fresh)
            if not waiting:
                return
            piece, answer = waiting.popleft()
            try:
                result: Result = ray.get(answer)
            except (ray.exceptions.RayError, OSError) as error:
                if isinstance(error, ray.exceptions.RayTaskError):
                    raise
                result = lost(piece)
            yield result
    finally:
        for _, answer in waiting:
            ray.cancel(answer, force=True)


def _done(function: Callable[[Work], Result], piece: Work) -> Result:
    return function(piece)


def _connected() -> Any:
    try:
        import ray
    except ImportError:
        raise BadInput('--engine ray: Ray is not installed; pip install "apartgen[ray]"') from None
    address = os.environ.get("RAY_ADDRESS", "auto")
    try:
        ray.init(address=address, ignore_reinit_error=True, log_to_driver=False, logging_level="error")
    except ConnectionError as error:
        why = str(error).partition("\n")[0]
        raise BadInput(f"--engine ray: no cluster at {address} ({why}); start one with `ray start --head`, or set "
                       "RAY_ADDRESS") from None
    return ray
