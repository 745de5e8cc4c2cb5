"""How often Python looks for garbage, and that a program that ends leaves it be."""

import gc
import subprocess
import sys
import textwrap

LEAVING = """
import gc, sys
from apartgen import garbage

class Loop:
    def __init__(self):
        self.me = self

gc.disable()
loops = [Loop() for _ in range(1000)]
found = []
gc.callbacks.append(lambda phase, info: found.append(info["collected"]))
del loops
if {stop}:
    garbage.no_more()
gc.collect()
print(sum(found))
"""


def collected(stop: bool) -> int:
    """How much garbage a collection finds of a thousand objects in cycles, once it is told to leave things alone."""
    code = textwrap.dedent(LEAVING).format(stop=stop)
    return int(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)


def test_what_was_there_is_left_alone_at_the_end():
    assert collected(stop=False) >= 1000
    assert collected(stop=True) == 0


def test_programs_leave_it_alone_when_they_end():
    """The last word of a program: everything that it has is out of the collector's sight, and its status is its own."""
    code = ("import atexit, gc, sys\nfrom apartgen_cli.main import main\nsys.argv = ['apartgen', '--version']\n"
            "atexit.register(lambda: print(gc.get_freeze_count() > 10_000))\nmain()")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stdout.splitlines()[-1] == "True"


def test_what_runs_afterwards_is_looked_at():
    assert gc.isenabled() and gc.get_freeze_count() == 0
