"""Formats that a second process writes: the same files, the same errors, nothing left behind."""

import multiprocessing
import os
import signal

import pytest
from export import sample

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.aside import aside

FORMATS = ["glb", "mjcf", "svg"]


def test_two_processes_write_what_one_does(tmp_path):
    one, two = (export.run(sample.home(), FORMATS, tmp_path / str(n), sample.load, processes=n) for n in (1, 2))
    assert one.files == two.files
    for file in one.files:
        assert (tmp_path / "1" / file.path).read_bytes() == (tmp_path / "2" / file.path).read_bytes()


def test_a_job_is_done_in_another_process_and_its_errors_come_back():
    with aside(os.getpid) as wait:
        assert wait() != os.getpid()

    with aside(lambda: signal.getsignal(signal.SIGINT)) as wait:
        assert wait() == signal.SIG_IGN != signal.getsignal(signal.SIGINT), "the first process ends both"

    def refused():
        raise BadInput("no such wall")

    with aside(refused) as wait, pytest.raises(BadInput, match="no such wall"):
        wait()


def test_a_job_whose_process_is_killed_is_done_here():
    here = os.getpid()

    def job():
        if os.getpid() != here:
            os.kill(os.getpid(), signal.SIGKILL)
        return "done"

    with aside(job) as wait:
        assert wait() == "done"


def test_a_second_process_starts_no_third():
    def further():
        with aside(os.getpid) as wait:
            return wait() == os.getpid()

    with aside(further) as wait:
        assert wait()


def test_where_forks_are_not_safe_a_job_is_done_here(monkeypatch):
    monkeypatch.setattr("sys.platform", "darwin")
    with aside(os.getpid) as wait:
        assert wait() == os.getpid()


def test_what_is_not_waited_for_ends():
    with pytest.raises(KeyboardInterrupt), aside(lambda: signal.pause()):
        raise KeyboardInterrupt
    assert multiprocessing.active_children() == []


def test_what_one_format_refuses_leaves_no_folder(tmp_path):
    def lost(library, id):
        raise BadInput("asset is lost")

    with pytest.raises(BadInput, match="lost"):
        export.run(sample.home(), ["svg", "glb"], tmp_path / "out", lost, processes=2)
    assert list(tmp_path.iterdir()) == []
