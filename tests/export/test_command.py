"""The command `export`: what it says, and that it leaves nothing behind when it fails or is stopped."""

import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import commandline
import pytest

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "two-bedroom-flat" / "walkable.json"


@pytest.fixture
def cli(capsys, monkeypatch):
    def run(*args):
        return commandline.run(capsys, monkeypatch, *args)

    return run


def _edited(path, change):
    """The example with its refrigerator changed."""
    home = json.loads(EXAMPLE.read_text())
    change(next(o for o in home["body"]["objects"] if o["id"] == "kitchen_1_fridge_1"))
    path.write_text(json.dumps(home))
    return path


def test_a_library_that_is_none_is_said_even_where_no_asset_is_needed(cli, tmp_path):
    done = cli("export", EXAMPLE, "--format", "svg", "--library", tmp_path / "nolib", "-o", tmp_path / "scene")
    assert done.code == 2 and "nolib" in done.err
    assert list(tmp_path.iterdir()) == []


def test_exports_that_fail_leave_no_folder(cli, tmp_path):
    broken = [_edited(tmp_path / name, lambda o: o["asset"].update(library="nowhere")) for name in ("a.json", "b.json")]
    for inputs in (broken, broken[:1]):
        done = cli("export", *inputs, "--format", "nav2", "-o", tmp_path / "new" / "scenes")
        assert done.code == 2 and "nowhere" in done.err
        assert {p.name for p in tmp_path.iterdir()} == {"a.json", "b.json"}
    (tmp_path / "mine").mkdir()
    assert cli("export", *broken, "--format", "nav2", "-o", tmp_path / "mine").code == 2
    assert (tmp_path / "mine").is_dir(), "what was there before stays"


def test_an_export_that_succeeds_stays_beside_one_that_fails(cli, tmp_path):
    broken = _edited(tmp_path / "a.json", lambda o: o["asset"].update(library="nowhere"))
    done = cli("export", broken, EXAMPLE, "--format", "svg", "--format", "nav2", "-o", tmp_path / "scenes")
    assert done.code == 2 and [p.name for p in (tmp_path / "scenes").iterdir()] == ["export"]


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_stopped_export_leaves_nothing(tmp_path):
    """`kill` is heeded like Ctrl-C: once the hidden folder is there, which is filled beside the target."""
    command = [sys.executable, "-m", "apartgen_cli", "export", str(EXAMPLE), "--format", "glb", "--format", "view",
               "-o", str(tmp_path / "scene")]
    running = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    while running.poll() is None and not list(tmp_path.iterdir()):
        time.sleep(0.01)
    running.send_signal(signal.SIGTERM)
    _, err = running.communicate(timeout=60)
    assert running.returncode == 128 + signal.SIGTERM and "interrupted" in err
    assert list(tmp_path.iterdir()) == []
