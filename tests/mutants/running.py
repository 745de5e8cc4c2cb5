"""Pytest in a child of this process, which has what is slow to import already; in a clone, with its modules."""

import contextlib
import importlib
import os
import resource
import signal
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

import coverage

One = TypeVar("One")
Found = TypeVar("Found")
SLOW = ("numpy", "scipy.ndimage", "scipy.optimize", "scipy.spatial", "shapely", "numba", "matplotlib.pyplot", "mujoco",
        "networkx", "trimesh", "pydantic", "typer", "rich", "PIL.Image", "safetensors", "torch", "pxr.Usd",
        "hypothesis", "pytest")
ASKED = ("-q", "-m", "not slow")
"""Of which tests: also of those that are left out for time alone."""
HERE = Path(__file__).parent
PROJECT = ("apartgen", "apartgen_cli")
"""What the child imports from the clone, whatever this process has."""


def ready() -> None:
    """Imports what children would each import anew, but nothing of the project."""
    for name in SLOW:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)


def abreast(workers: int, what: Callable[[One], Found], some: Sequence[One]) -> Iterator[Found]:
    """What becomes of some, so many at a time, as it comes; each waits for a child of its own."""
    with ThreadPoolExecutor(workers) as pool:
        for found in as_completed([pool.submit(what, one) for one in some]):
            yield found.result()


def run(work: Path, cache: Path, arguments: Sequence[str], out: Path, seconds: int,
        cover: Path | None = None, only: Sequence[str] = (), around: Mapping[str, str] = MappingProxyType({})) -> int:
    """Pytest's exit status, negative if it took more than so many seconds of processor time or ten times as long.

    What it says goes to `out`; with `cover`, the lines of the files `only` that tests run go there; `around` joins
    the environment.
    """
    child = os.fork()
    if child == 0:
        try:
            _within(work, cache, out, seconds)
            os.environ |= around
            status = _pytest(list(arguments), cover, [str(work / file) for file in only])
        except BaseException as error:  # nothing of this may go on in the child
            print(f"{type(error).__name__}: {error}", file=sys.stderr)
            status = 3
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
    return _ended(child, 10 * seconds)


def _ended(child: int, seconds: float) -> int:
    end = time.monotonic() + seconds
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        if time.monotonic() > end:
            os.killpg(child, signal.SIGKILL)
        time.sleep(0.1)


def _within(work: Path, cache: Path, out: Path, seconds: int) -> None:
    """The child as a process of its own, whose modules are the clone's."""
    import numba

    os.setsid()
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    file = os.open(out, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    for number, name in ((1, "stdout"), (2, "stderr")):
        os.dup2(file, number)
        setattr(sys, name, open(number, "w", encoding="utf-8", closefd=False))
    own = [str(work), str(work / "tests"), str(HERE)]
    left = {"", str(HERE.parent), str(HERE.parent.parent)}
    sys.path[:] = [*own, *(path for path in sys.path if path not in left)]
    for name in [name for name in sys.modules if name.partition(".")[0] in PROJECT]:
        del sys.modules[name]
    os.chdir(work)
    os.environ["PYTHONPATH"] = os.pathsep.join(own)
    # Two changes of one length in one second have the same stamp: the second would run what was compiled of the first.
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.dont_write_bytecode = True
    os.environ["NUMBA_CACHE_DIR"] = numba.config.CACHE_DIR = str(cache)


def _pytest(arguments: list[str], cover: Path | None, only: list[str]) -> int:
    import pytest

    if cover is None:
        return int(pytest.main(arguments))
    watch = coverage.Coverage(data_file=str(cover), include=only)
    watch.start()
    try:
        return int(pytest.main(["-p", "watching", *arguments]))
    finally:
        watch.stop()
        watch.save()
