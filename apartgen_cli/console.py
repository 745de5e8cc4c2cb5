"""What is said to the person at the terminal: on standard error only."""

import logging
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TypeVar

Item = TypeVar("Item")
log = logging.getLogger("apartgen")


class _Standard(logging.Handler):
    """Writes to whatever standard error is now."""

    def emit(self, record: logging.LogRecord) -> None:
        prefix = "" if record.levelno < logging.WARNING else f"{record.levelname.lower()}: "
        print(printable(f"{prefix}{record.getMessage()}"), file=sys.stderr)


def listen(quiet: bool) -> None:
    """Show the messages and warnings of the stages, or with `quiet` errors only."""
    log.handlers = [_Standard()]
    log.propagate = False
    log.setLevel(logging.ERROR if quiet else logging.INFO)


def say(message: str) -> None:
    """A message that `--quiet` leaves out."""
    log.info("%s", message)


def fail(message: str) -> None:
    """What is wrong, in one or two lines."""
    print(printable(f"apartgen: {message}"), file=sys.stderr)


def printable(text: str) -> str:
    """A text without what would steer a terminal; what files and models say is not ours."""
    return "".join(c if c.isprintable() or c in "\n\t" else f"\\x{ord(c):02x}" for c in text)


def progress(items: Iterable[Item], what: str, total: int | None) -> Iterator[Item]:
    """The items, with a bar while they come when there are several; `total` None: nobody knows how many."""
    if total is not None and total < 2:
        yield from items
        return
    with watched(what, total) as report:
        for done, item in enumerate(items, 1):
            yield item
            report(done)


@contextmanager
def watched(what: str, total: int | None) -> Iterator[Callable[..., None]]:
    """A bar on standard error where a person watches; `report(done, loss)` moves it. `total` None: nobody knows."""
    if not sys.stderr.isatty() or log.level > logging.INFO:
        yield lambda done, loss=None: None
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        ProgressColumn,
        Task,
        TextColumn,
        TimeRemainingColumn,
    )
    from rich.text import Text

    class Rate(ProgressColumn):
        """How many an hour."""

        def render(self, task: Task) -> Text:
            return Text(f"{task.speed * 3600:,.0f}/h" if task.speed else "")

    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), Rate(), TimeRemainingColumn()
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(what, total=total)

        def report(done: int, loss: float | None = None) -> None:
            bar.update(task, completed=done, description=what if loss is None else f"{what} (loss {loss:.4f})")

        yield report
