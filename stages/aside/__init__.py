"""Work that a second process does beside this one, where the system has a safe fork."""

import multiprocessing
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Any, TypeVar

T = TypeVar("T")


@contextmanager
def aside(job: Callable[[], T]) -> Iterator[Callable[[], T]]:
    """Starts a job in a copy of this process; what is given waits for it, and returns or raises as it did.

    A job whose process is lost, or may have none of its own, is done here. Leaving before it is waited for ends it.
    """
    if sys.platform != "linux" or multiprocessing.parent_process() is not None:
        yield job
        return
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(duplex=False)
    child = context.Process(target=_answer, args=(job, theirs), daemon=True)
    child.start()
    theirs.close()
    try:
        yield lambda: _result(job, ours)
    finally:
        child.kill()
        child.join()
        ours.close()


@contextmanager
def at_once(job: Callable[[], T]) -> Iterator[Callable[[], T]]:
    """As `aside`, here and now."""
    done = job()
    yield lambda: done


def _answer(job: Callable[[], T], to: "Connection[Any, Any]") -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the first process ends both
    try:
        to.send((job(), None))
    except Exception as error:
        to.send((None, error))


def _result(job: Callable[[], T], from_: "Connection[Any, Any]") -> T:
    try:
        found, error = from_.recv()
    except EOFError:
        return job()
    if error is not None:
        raise error
    value: T = found
    return value
