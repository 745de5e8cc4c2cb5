"""Whatever is read, however it is damaged: an answer, or an error that names it. `python -m fuzz` runs many more."""

import resource
import signal
import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzz.targets import SHARE, passes


@pytest.fixture(autouse=True)
def quickly():
    """No case is busy for ten seconds of a processor."""
    before = signal.signal(signal.SIGPROF, _late)
    yield
    signal.setitimer(signal.ITIMER_PROF, 0)
    signal.signal(signal.SIGPROF, before)


def _late(*_: object) -> None:
    raise AssertionError("busy for ten seconds")


@pytest.mark.parametrize("target", SHARE, ids=lambda target: target.__name__)
def test_what_is_read_is_answered_or_named(target):
    with tempfile.TemporaryDirectory() as folder:

        @settings(max_examples=SHARE[target], deadline=None, derandomize=True, database=None)
        @given(seed=st.integers(0, 2**31))
        def one(seed: int) -> None:
            signal.setitimer(signal.ITIMER_PROF, 10)
            passes(target, seed, Path(folder))

        one()
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < 4 * 2**20, "kB"
