"""What commands import: a look at `sys.modules`, not at the clock."""

import json
import os
import subprocess
import sys

import commandline
import handmade
import pytest

from apartgen.schemas import artifact, errors
from apartgen_cli.main import WORDS

HEAVY = {"torch", "litellm", "trimesh", "pxr", "mujoco", "matplotlib"}
LIGHT = HEAVY | {"scipy", "numba", "shapely", "networkx", "numpy", "pydantic"}
"""What even the scientific packages are left out of."""

CODE = """
import json, sys
from apartgen_cli.main import status
assert status(sys.argv[1:]) == 0
print(json.dumps(sorted({name.partition(".")[0] for name in sys.modules})), file=sys.stderr)
"""


def loaded(*args: str, stdin: str = "") -> set[str]:
    """Top-level packages in memory after one command line."""
    done = subprocess.run([sys.executable, "-c", CODE, *args], input=stdin, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stderr.splitlines()[-1]))


@pytest.fixture(scope="module")
def plan() -> str:
    return artifact.finish(handmade.plan(), artifact.Made(by="test", seed=0))[0]


@pytest.mark.parametrize("args", [["--help"], ["--version"], ["-h"]])
def test_help_needs_next_to_nothing(args):
    assert not loaded(*args) & LIGHT


def test_help_of_a_command_needs_nothing_heavy():
    """One process asks for all of them: what one command loads stays."""
    code = ("import sys; from apartgen_cli.main import status\n"
            f"for word in {list(WORDS)}:\n"
            "    assert status([word, '--help']) == 0\n"
            f"    heavy = {HEAVY} & set(sys.modules)\n"
            "    assert not heavy, f'{word} loads {heavy}'\n"
            "    print(word, file=sys.stderr)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and done.stderr.split() == list(WORDS), done.stderr


def test_schema_needs_nothing_heavy():
    assert not loaded("schema", "walkable") & HEAVY


def test_a_plan_needs_nothing_heavy():
    assert not loaded("plan", "studio") & HEAVY


@pytest.mark.parametrize("word", ["layout", "dataset"])
def test_rooms_are_furnished_without_torch(plan, word, tmp_path):
    """It costs a second and hundreds of MB, and only training and the diffusion model need it."""
    if word == "layout":
        assert not loaded("layout", "--candidates", "1", stdin=plan) & HEAVY
    else:
        args = ("dataset", "build", "-", "--workers", "1", "--out", str(tmp_path / "set"))
        assert "torch" not in loaded(*args, stdin="studio\n")


def test_metrics_need_nothing_heavy(plan):
    assert not loaded("metrics", stdin=plan) & HEAVY


def test_nobody_looks_through_all_that_is_loaded_again_and_again():
    code = ("import gc, sys; from apartgen_cli.main import main\nsys.argv = ['apartgen', '-q', 'plan', 'studio']\n"
            "try: main()\nfinally: print(gc.get_stats()[2]['collections'], file=sys.stderr)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0 and int(done.stderr.splitlines()[-1]) <= 1, done.stderr


@pytest.mark.parametrize("args", [("layout", "--model", "diffusion"), ("train", "layout", "--corpus", "none.npz"),
                                  ("train", "shape")])
def test_what_takes_torch_says_how_to_get_it(plan, args, monkeypatch, capsys):
    monkeypatch.setattr(errors, "find_spec", lambda name: None)
    done = commandline.run(capsys, monkeypatch, *args, stdin=plan)
    assert done.code == 2 and "PyTorch: pip install 'apartgen[learn]'" in done.err
    assert commandline.run(capsys, monkeypatch, "layout", "--candidates", "1", stdin=plan).code == 0


def test_what_is_compiled_is_said_the_first_time(tmp_path):
    """Else a program of half a minute without a word looks as if it hung; `--quiet` and later runs are silent."""
    def told(quiet: bool, cache: str) -> str:
        code = (f"from apartgen_cli.console import listen; listen({quiet}); "
                "from apartgen.stages.things import rectangles")
        ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120,
                             env=os.environ | {"NUMBA_CACHE_DIR": str(tmp_path / cache)})
        return ran.stderr

    assert told(False, "cache").count("compiling") == 1
    assert told(False, "cache") == ""
    assert told(True, "other") == ""
