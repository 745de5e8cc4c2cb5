"""Warm workers on the cores of one machine: results in the order of the work, few at a time, whoever dies."""

import multiprocessing
import os
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from typing import Generic, NamedTuple, TypeVar

from apartgen import garbage

Work = TypeVar("Work")
Result = TypeVar("Result")
AHEAD = 8
"""Pieces of work a worker that are under way, or done before their turn."""
ENDED = 4
"""Workers of its own that a piece must have ended to be given up: one may be killed by others, and another after it."""
STARTS, PAUSE = 60, 0.5
"""How often a worker is tried to be started, and s between."""
SETTLED = 2
"""Pieces a worker after the first that had something compiled by which all that is needed has been."""
_THREADS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS")


class _Told(NamedTuple, Generic[Result]):
    """What a worker gives for a piece, and whether it has compiled anything so far."""

    result: Result
    compiled: bool


def results(function: Callable[[Work], Result], work: Iterable[Work], workers: int,
            lost: Callable[[Work], Result]) -> Iterator[Result]:
    """What the function gives for each piece of work, in order; `lost(piece)` for one that its worker does not survive.

    Workers load what they need once; those that had to compile it, as after an installation, are replaced, for they
    keep what the compiler took. Work and results can be pickled.
    """
    if workers == 1:
        yield from map(function, work)
        return
    pieces, pool = iter(work), _started(workers)
    waiting: deque[tuple[Work, Future[_Told[Result]] | None]] = deque()
    left = SETTLED * workers
    try:
        while True:
            fresh = islice(pieces, workers * AHEAD - len(waiting))
            waiting.extend((piece, _submitted(pool, function, piece)) for piece in fresh)
            if not waiting:
                return
            piece, future = waiting.popleft()
            try:
                told = _of(future)
            except BrokenProcessPool:
                # Whose piece it was is not told, so the first is done alone and the others again; so at every death
                # one piece more is done with.
                pool.shutdown(wait=False, cancel_futures=True)
                told = _alone(function, piece, lost)
                pool = _started(workers)
                waiting = deque((piece, old if _is_done(old) else _submitted(pool, function, piece))
                                for piece, old in waiting)
            yield told.result
            left -= told.compiled
            if told.compiled and left == 0:
                pool, old_pool = _started(workers), pool
                waiting = deque((piece, _submitted(pool, function, piece) if old is None or old.cancel() else old)
                                for piece, old in waiting)
                old_pool.shutdown(wait=False)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


def cores(workers: int | None) -> int:
    """As many workers as are asked for; all cores by default."""
    return workers or os.cpu_count() or 1


def _submitted(pool: ProcessPoolExecutor, function: Callable[[Work], Result],
               piece: Work) -> Future[_Told[Result]] | None:
    """None where the pool is broken, be it by the death of what starts its workers."""
    try:
        return pool.submit(_done, function, piece)
    except (BrokenProcessPool, EOFError, ConnectionError):
        return None


def _done(function: Callable[[Work], Result], piece: Work) -> _Told[Result]:
    """In a worker."""
    result, compiling = function(piece), sys.modules.get("apartgen.stages.compiling")
    return _Told(result, compiling is not None and compiling.has_compiled())


def _of(future: Future[Result] | None) -> Result:
    if future is None:
        raise BrokenProcessPool
    return future.result()


def _is_done(future: Future[Result] | None) -> bool:
    if future is None or not future.done() or future.cancelled():
        return False
    return not isinstance(future.exception(), BrokenProcessPool)


def _alone(function: Callable[[Work], Result], piece: Work, lost: Callable[[Work], Result]) -> _Told[Result]:
    """In a pool of its own, lost when it has ended too many of them. What starts workers may be dying itself: a worker
    that could not be started says nothing of the piece, and is waited for.
    """
    deaths = 0
    for _ in range(STARTS):
        pool = _started(1)
        try:
            future = _submitted(pool, function, piece)
            if future is not None:
                return future.result()
            time.sleep(PAUSE)
        except BrokenProcessPool:
            deaths += 1
            if deaths == ENDED:
                return _Told(lost(piece), False)
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
    raise BrokenProcessPool("no worker can be started")


def _started(workers: int) -> ProcessPoolExecutor:
    for name in _THREADS:
        os.environ.setdefault(name, "1")
    context = multiprocessing.get_context("forkserver" if sys.platform == "linux" else "spawn")
    if sys.platform == "linux":
        context.set_forkserver_preload(["apartgen.dataset.home"])
    return ProcessPoolExecutor(workers, context, _settle)


def _settle() -> None:
    """A worker is interrupted by nobody, and ends when who started it has ended, however that was."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    garbage.seldom()
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
