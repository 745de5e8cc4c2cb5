"""Furnishing says what it has to say by its log alone."""

import subprocess
import sys

CODE = """
import warnings
import handmade, numpy as np
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
warnings.simplefilter("always")
assert layout.run(handmade.plan(), LayoutConfig(candidates=1), np.random.default_rng(1)).objects
"""


def test_nothing_warns_while_rooms_are_furnished() -> None:
    """In a process of its own, since some warnings come only once."""
    done = subprocess.run([sys.executable, "-c", f"import sys; sys.path.insert(0, 'tests')\n{CODE}"],
                          capture_output=True, text=True, timeout=240)
    assert done.returncode == 0 and "Warning" not in done.stderr, done.stderr
