"""Errors a user can cause, and the exit status each one ends in.

    ApartgenError
    ├── BadInput    2   the request or a file is wrong
    └── Unmet       1   well formed, but could not be fulfilled

A message says what is wrong, where (file, JSON path), and what to do.
"""

from importlib.util import find_spec


class ApartgenError(Exception):
    """Base of everything apartgen raises on purpose; shown without a traceback."""

    exit_code = 1


class BadInput(ApartgenError):
    """Wrong usage, a malformed file, an unknown name."""

    exit_code = 2


class Unmet(ApartgenError):
    """A well-formed request that has no solution, or that a model refused."""

    exit_code = 1


def need_torch(what: str) -> None:
    """BadInput where PyTorch, which `what` takes, is not installed."""
    if find_spec("torch") is None:
        raise BadInput(f"{what} takes PyTorch: pip install 'apartgen[learn]'")
