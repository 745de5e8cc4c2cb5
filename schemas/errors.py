"""Errors a user can cause, and the exit status each one ends in.

    ApartgenError
    ├── BadInput    2   the request or a file is wrong
    │   └── Unknown 2   it names what is not known here
    └── Unmet       1   well formed, but could not be fulfilled

A message says what is wrong, where (file, JSON path), and what to do.
"""

import difflib
from collections.abc import Iterable
from importlib.util import find_spec

CLOSE = 0.65
"""How alike a word must be to a name to be taken for it, of 1."""


class ApartgenError(Exception):
    """Base of everything apartgen raises on purpose; shown without a traceback."""

    exit_code = 1


class BadInput(ApartgenError):
    """Wrong usage, a malformed file, an unknown name."""

    exit_code = 2


class Unknown(BadInput):
    """A name in a file that nothing here knows; whoever read the file puts its own before it."""


class Unmet(ApartgenError):
    """A well-formed request that has no solution, or that a model refused."""

    exit_code = 1


def near(name: str, known: Iterable[str]) -> str:
    """Which of the known names was meant, as a question, or else all of them."""
    names = list(known)
    close = difflib.get_close_matches(name.lower(), names, n=3, cutoff=CLOSE)
    return f"did you mean {' or '.join(map(repr, close))}?" if close else f"there are: {', '.join(names)}"


def need_torch(what: str) -> None:
    """BadInput where PyTorch, which `what` takes, is not installed."""
    if find_spec("torch") is None:
        raise BadInput(f"{what} takes PyTorch: pip install 'apartgen[learn]'")
