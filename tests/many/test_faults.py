"""What can go wrong around a run: full disks, signals, folders that cannot be written."""

import os
import signal
import subprocess
import sys

import pytest
from test_cli import until_idle


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
