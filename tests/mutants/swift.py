"""For pytest (`-p swift`): tries changes of functions one after another in children of one process that has collected.

A child gives the changed function its other code and runs some tests, until one fails. What cannot be done so (what is
compiled, or read when a module is imported) is not tried here.
"""

import functools
import importlib
import json
import os
import resource
import signal
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np
import pytest
from _pytest.runner import runtestprotocol

PLAIN = (int, float, tuple, list, dict, frozenset, set, str, np.ndarray)
"""Types of values that are only looked at, whose names may be given others."""


@dataclass(frozen=True)
class Task:
    """A change's place in its file, the tests to try it with, and how many seconds these may take."""

    key: str
    module: str
    path: str
    start: int
    end: int
    new: str
    function: str
    tests: list[str]
    seconds: int


def pytest_runtestloop(session: pytest.Session) -> bool:
    """Reads tasks from the file that MUTANTS_TASKS names, and adds what became of each to that of MUTANTS_FATES."""
    items = {item.nodeid: item for item in session.items}
    for line in Path(os.environ["MUTANTS_TASKS"]).read_text(encoding="utf-8").splitlines():
        task = Task(**json.loads(line))
        fate, by = _tried(task, [items[test] for test in task.tests if test in items])
        with open(os.environ["MUTANTS_FATES"], "a", encoding="utf-8") as file:
            file.write(json.dumps([task.key, len(task.tests), fate, by], ensure_ascii=False) + "\n")
    return True


def _tried(task: Task, items: Sequence[pytest.Item]) -> tuple[str, str]:
    ours, theirs = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(ours)
        _child(task, items, theirs)
    os.close(theirs)
    status, end = None, time.monotonic() + 20 * task.seconds
    while status is None:
        done, code = os.waitpid(child, os.WNOHANG)
        status = os.waitstatus_to_exitcode(code) if done else None
        if time.monotonic() > end:
            os.killpg(child, signal.SIGKILL)
        time.sleep(0.02)
    with os.fdopen(ours, encoding="utf-8") as said:
        by = said.read()
    return "too long" if status < 0 else {0: "survived", 1: "killed"}.get(status, "other"), by


def _child(task: Task, items: Sequence[pytest.Item], out: int) -> None:
    status = 2
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (task.seconds, task.seconds + 5))
        if swapped(importlib.import_module(task.module), task):
            failed = _first_failed(items)
            os.write(out, failed[:200].encode())
            status = 1 if failed else 0
    except BaseException as error:  # nothing of this may go on in the child
        os.write(out, f"{type(error).__name__}: {error}"[:200].encode())
        status = 3
    finally:
        os._exit(status)


def _first_failed(items: Sequence[pytest.Item]) -> str:
    for item, following in zip(items, [*items[1:], None]):
        if any(report.failed for report in runtestprotocol(item, log=False, nextitem=following)):
            return item.nodeid
    return ""


def swapped(module: ModuleType, task: Task) -> bool:
    """Whether the function of a change could be given its other code, or names of a module their other values."""
    source = Path(task.path).read_bytes()
    texts = source, source[: task.start] + task.new.encode() + source[task.end:]
    if not task.function:
        return _valued(module, compile(texts[1], task.path, "exec"))
    function = _function(module, task.function.split("."))
    if function is None:
        return False
    before, after = (_code(compile(text, task.path, "exec"), function.__code__) for text in texts)
    if before is None or after is None or before == after or after.co_freevars != function.__code__.co_freevars:
        return False
    function.__code__ = after
    return True


def _valued(module: ModuleType, code: CodeType) -> bool:
    """Gives names of a module, here and wherever they are imported to, the plain values that other code gives them."""
    found: dict[str, Any] = {name: vars(module)[name] for name in ("__name__", "__file__", "__package__", "__path__")
                             if name in vars(module)}
    exec(code, found)
    new = {name: value for name, value in found.items() if isinstance(value, PLAIN) and name in vars(module)
           and repr(value) != repr(vars(module)[name])}
    for name, value in new.items():
        old = vars(module)[name]
        for other in [one for key, one in sys.modules.items() if key.startswith("apartgen")]:
            for alias in [alias for alias, held in vars(other).items() if held is old]:
                if other is module or alias == name:
                    setattr(other, alias, value)
    return bool(new)


def _function(owner: Any, names: Sequence[str]) -> FunctionType | None:
    """The outermost function on a path of names, without what decorators put around it."""
    for name in names:
        owner = vars(owner).get(name) if hasattr(owner, "__dict__") else None
        if not isinstance(owner, type):
            break
    while not isinstance(owner, FunctionType) or hasattr(owner, "__wrapped__"):
        inner = _inner(owner)
        if inner is None:
            return None
        owner = inner
    return owner if owner.__name__ in names else None


def _inner(owner: Any) -> Any:
    if isinstance(owner, property):
        return owner.fget
    if isinstance(owner, functools.cached_property):
        return owner.func
    found = getattr(owner, "__wrapped__", None) or getattr(owner, "__func__", None)
    return None if type(owner).__module__.startswith("numba") else found


def _code(whole: CodeType, like: CodeType) -> CodeType | None:
    """The code in a module's that begins where another does."""
    for inner in whole.co_consts:
        if isinstance(inner, CodeType):
            if (inner.co_qualname, inner.co_firstlineno) == (like.co_qualname, like.co_firstlineno):
                return inner
            if found := _code(inner, like):
                return found
    return None
