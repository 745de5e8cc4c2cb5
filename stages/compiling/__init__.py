"""Functions compiled by numba when they are first imported, and kept in its cache; said where that takes a while.

The cache sees changes of the file that a function stands in, and of nothing else: what is compiled calls only functions
of its own file or compiled ones, and whoever changes what stands here clears the cache.
"""

import logging
import multiprocessing
from collections.abc import Callable
from typing import Any, TypeVar, cast

from numba import njit
from numba.core import event

F = TypeVar("F", bound=Callable[..., Any])
NUMPY: dict[str, Any] = {"error_model": "numpy"}
log = logging.getLogger("apartgen")
# Not callable from Python: those wrappers cost as much to compile as the functions.
WITHIN: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def compiled(signature: Any = None, **options: Any) -> Callable[[F], F]:
    """Compiled for a signature when it is imported, or else when it is first called, with numba's options."""
    return cast(Callable[[F], F], njit(signature, cache=True, **{**NUMPY, **options}))


def inner(function: F) -> F:
    """Compiled where a compiled function calls it."""
    return cast(F, njit(**NUMPY, **WITHIN)(function))


class _Said(event.Listener):
    """Says once a process that something is compiled, which else would look like a program that hangs."""

    def __init__(self) -> None:
        self.said = False

    def on_start(self, event: Any) -> None:
        """What is found in the cache is no event."""
        if not self.said and multiprocessing.parent_process() is None:
            log.info("compiling, once after an installation; this may take a minute")
        self.said = True

    def on_end(self, event: Any) -> None:
        """Nothing."""


event.register("numba:compile", _Said())  # type: ignore[no-untyped-call]
