"""For pytest (`-p watching`): tells coverage which test runs, and writes what each cost and whether it passed.

What fixtures run counts for all tests of a file, because they share them.
"""

import json
import os
from collections.abc import Iterator
from pathlib import Path

import coverage
import pytest

_cost: dict[str, float] = {}
_failed: set[str] = set()


def _seconds() -> float:
    return sum(os.times()[:4])


def _runs(name: str) -> None:
    if running := coverage.Coverage.current():
        running.switch_context(name)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """The seconds of processor time of a test, its fixtures and its children."""
    start = _seconds()
    result = yield
    _cost[item.nodeid] = _seconds() - start
    return result


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Fixtures are the whole file's."""
    _runs(item.nodeid.partition("::")[0])


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_call(item: pytest.Item) -> None:
    """The test itself."""
    _runs(item.nodeid)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Fixtures again."""
    _runs(item.nodeid.partition("::")[0])


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Tests that fail or are left out without any change say nothing about one."""
    if report.outcome != "passed":
        _failed.add(report.nodeid)


def pytest_sessionfinish() -> None:
    """Writes what was learned to the file that MUTANTS_COST names."""
    if path := os.environ.get("MUTANTS_COST"):
        passed = {name: round(cost, 3) for name, cost in _cost.items() if name not in _failed}
        Path(path).write_text(json.dumps(passed, indent=0), encoding="utf-8")
