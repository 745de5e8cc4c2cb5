"""The Makefile of the examples: six homes by shards, killed and resumed, and only the stale made again."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "dataset"
LATER = ("layout", "retrieve", "walkable", "populate")
COPY = "sh -c 'cp $$0 $$2'"
"""A stage that leaves homes as they are."""
pytestmark = pytest.mark.skipif(shutil.which("make") is None, reason="needs make")


@pytest.fixture
def folder(tmp_path):
    return Path(shutil.copytree(EXAMPLE, tmp_path / "dataset"))


def command(folder: Path, *more: str, real: bool = False) -> list[str]:
    swapped = [] if real else [f"{word.upper()}={COPY}" for word in LATER]
    (folder / "settings.toml").write_text("[plan]\nenough = 1\ncandidates = 1\n[layout]\ncandidates = 1\n")
    return ["make", "-C", str(folder), "-j2", "SHARD=3", "CONFIG=settings.toml", f"PYTHON={sys.executable}",
            f"APARTGEN={sys.executable} -m apartgen_cli", *swapped, *more]


def make(folder: Path, *more: str, real: bool = False) -> str:
    done = subprocess.run(command(folder, *more, real=real), capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    return done.stdout


def timeless(file: Path) -> list[dict]:
    homes = [json.loads(line) for line in file.read_text().splitlines()]
    for home in homes:
        home["made"].pop("seconds")
    return homes


def test_killed_and_resumed_it_gives_the_same_and_only_the_stale_is_made_again(folder, tmp_path):
    other = Path(shutil.copytree(folder, tmp_path / "other"))
    running = subprocess.Popen(command(folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               start_new_session=True)
    end = time.monotonic() + 120
    while not list(folder.glob("build/.*.plan.jsonl.part")) and time.monotonic() < end:
        time.sleep(0.01)
    os.killpg(running.pid, signal.SIGKILL)
    running.wait()
    assert not (folder / "build" / "table.md").exists()
    make(folder)
    make(other)
    for name in ("00000", "00001"):
        mine, undisturbed = (timeless(one / "build" / f"{name}.populate.jsonl") for one in (folder, other))
        assert mine == undisturbed and len(mine) == 3
    assert len((folder / "build" / "table.md").read_text().splitlines()) > 3
    assert not list(folder.glob("build/.*"))
    plans = sorted(folder.glob("build/*.plan.jsonl"))
    before = [file.stat().st_mtime_ns for file in plans]
    assert "--prompts" not in make(folder), "all is there"
    text = (folder / "prompts.txt").read_text()
    (folder / "prompts.txt").write_text(text.replace("55 m²", "50 m²"))
    assert "00001.plan.jsonl" in make(folder)
    assert [file.stat().st_mtime_ns != old for file, old in zip(plans, before)] == [False, True]


def test_what_cannot_be_made_is_listed_and_left_out(folder):
    (folder / "prompts.txt").write_text("studio\na 20 m² flat with four bedrooms of 15 m² each\n")
    make(folder, "homes")
    assert len((folder / "build/00000.populate.jsonl").read_text().splitlines()) == 1
    assert json.loads((folder / "build/00000.plan.failed").read_text())["id"] == "0000001"


@pytest.mark.slow
def test_all_stages_make_six_homes_that_the_judge_certifies(folder):
    assert make(folder, "check", real=True).count("certified") == 6
