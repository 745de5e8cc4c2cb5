"""What is said to the person at the terminal: on standard error only."""

import logging
import sys
from collections.abc import Iterable, Iterator
from typing import TypeVar

Item = TypeVar("Item")
log = logging.getLogger("apartgen")


class _Standard(logging.Handler):
    """Writes to whatever standard error is now."""

    def emit(self, record: logging.LogRecord) -> None:
        prefix = "" if record.levelno < logging.WARNING else f"{record.levelname.lower()}: "
        print(f"{prefix}{record.getMessage()}", file=sys.stderr)


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
    print(f"apartgen: {message}", file=sys.stderr)


def progress(items: Iterable[Item], what: str, total: int) -> Iterator[Item]:
    """The items, with a bar on standard error while they come when a person watches several."""
    if total < 2 or not sys.stderr.isatty() or log.level > logging.INFO:
        yield from items
        return
    from rich.console import Console
    from rich.progress import track

    yield from track(items, what, total, console=Console(stderr=True), transient=True)
