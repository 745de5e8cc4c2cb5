"""Functions compiled by numba when they are first imported, and kept in its cache; said where that takes a while.

The cache sees changes of the file that a function stands in, and of nothing else: what is compiled calls only functions
of its own file or compiled ones, and whoever changes what stands here clears the cache.
"""

import logging
import multiprocessing
import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any, TypeVar, cast

from numba import njit
from numba.core import event

_BLAS = "scipy.linalg.cython_blas"


def _without_blas() -> None:
    """What numba looks for SciPy's linear algebra for when it begins, .16 s of every command, is np.correlate, which no
    compiled function has; products of matrices would look for it anew."""
    if _BLAS not in sys.modules:
        sys.modules[_BLAS] = None  # type: ignore[assignment]
        try:
            import_module("numba.np.arraymath")
        finally:
            del sys.modules[_BLAS]


_without_blas()
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


_SAID = _Said()
event.register("numba:compile", _SAID)  # type: ignore[no-untyped-call]


def has_compiled() -> bool:
    """Whether anything was compiled in this process, which keeps what the compiler took, some 250 MB for all stages."""
    return _SAID.said
