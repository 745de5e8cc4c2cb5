"""What can go wrong around a run: full disks, signals, folders that cannot be written."""

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from test_cli import until_idle

from apartgen import compiled
from apartgen_cli.console import fail, listen, say


def apartgen(*args: str, **kwargs) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, "-m", "apartgen_cli", *args], stderr=subprocess.PIPE, text=True,
                          timeout=120, **kwargs)


def in_a_line(done: subprocess.CompletedProcess) -> bool:
    return 1 <= done.stderr.count("\n") <= 2 and "Traceback" not in done.stderr


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
@pytest.mark.parametrize("args", [["schema", "plan"], ["plan", "studio"], ["plan", "studio", "-o", "/dev/full"]])
def test_a_full_disk_is_a_line(args):
    with open("/dev/full", "w") as full:
        done = apartgen(*args, stdout=full)
    assert done.returncode == 2 and in_a_line(done) and "No space left" in done.stderr, done


def test_an_end_by_signal_says_which():
    waiting = subprocess.Popen([sys.executable, "-m", "apartgen_cli", "metrics"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    until_idle(waiting.pid)
    waiting.send_signal(signal.SIGTERM)
    _, err = waiting.communicate(timeout=60)
    assert waiting.returncode == 128 + signal.SIGTERM and err == "apartgen: interrupted; what was finished is kept\n"


def test_where_nothing_can_be_written_compiled_functions_are_kept_apart(tmp_path, monkeypatch):
    monkeypatch.setattr(compiled, "__file__", "/proc/none/compiled.py")
    monkeypatch.setenv("XDG_CACHE_HOME", "/proc/none")
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.delenv(compiled.VARIABLE, raising=False)

    def kept() -> Path:
        compiled.keep()
        return Path(os.environ.pop(compiled.VARIABLE))

    first = kept()
    assert first.parent == tmp_path and first == kept() and first.stat().st_mode & 0o777 == 0o700
    first.chmod(0o777)
    assert kept() != first, "what others can write into is not run"
    first.rmdir()
    first.symlink_to(tmp_path)
    assert kept() != first
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    compiled.keep()
    assert compiled.VARIABLE not in os.environ and (tmp_path / "cache").is_dir()


def test_what_is_said_does_not_steer_a_terminal(capsys):
    listen(quiet=False)
    fail("no \x1b[2Jflat\x07 of \udcff, bäd 字\nnext")
    say("\x1b]0;title\x07")
    assert capsys.readouterr().err == "apartgen: no \\x1b[2Jflat\\x07 of \\xdcff, bäd 字\nnext\n\\x1b]0;title\\x07\n"
