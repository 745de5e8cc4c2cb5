"""What holds for every test."""

import logging
from collections.abc import Iterator

import pytest


@pytest.fixture(autouse=True)
def _heard_anew() -> Iterator[None]:
    """A command that ran in a test leaves the program's log to no later one: it speaks on standard error alone."""
    yield
    log = logging.getLogger("apartgen")
    log.handlers, log.propagate = [], True
    log.setLevel(logging.NOTSET)
