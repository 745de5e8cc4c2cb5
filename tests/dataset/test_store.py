"""What a data set is on the disk: nothing is lost, torn or there twice, wherever a run ended."""

import gzip
import json
import os
import signal
import threading
from functools import partial
from multiprocessing import forkserver

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen import garbage
from apartgen.dataset import pool
from apartgen.dataset.home import Done
from apartgen.dataset.store import HOMES, MANIFEST, Store, Writer
from apartgen.schemas.errors import BadInput

COUNT, PER_SHARD = 7, 3
HOME = {"kind": "plan", "digests": {"plan": "x"}, "certified": True, "metrics": {}, "rooms": {}, "objects": {},
        "signature": "s", "sides": [2.0, 3.0], "area": 6.0}


def done(i: int) -> Done:
    line = b"" if i == 4 else json.dumps({"home": i, "filling": "x" * (i * 37 % 50)}).encode() + b"\n"
    row = {"id": str(i), "prompt": "studio", "seed": i, "seconds": {"all": 0.5}}
    return Done(line, row | ({"error": "no room"} if i == 4 else HOME))


def filled(folder, count: int = COUNT) -> None:
    writer = Writer(Store(folder), PER_SHARD)
    for i in range(writer.count, count):
        writer.add(done(i))
    writer.close()


def contents(folder) -> dict[str, bytes]:
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


@given(kept=st.integers(0, COUNT), torn=st.integers(0, 400), ahead=st.integers(0, 400))
@settings(max_examples=60, deadline=None)
def test_wherever_a_run_ended_the_next_gives_the_same_bytes(tmp_path_factory, kept, torn, ahead):
    """A run may end behind any byte of a shard, or of a row whose home is written."""
    whole, folder = tmp_path_factory.mktemp("whole"), tmp_path_factory.mktemp("cut")
    filled(whole)
    filled(folder, kept)
    if kept < COUNT:
        after = tmp_path_factory.mktemp("after")
        filled(after, kept + 1)
        home_written = False
        for name, data in contents(after).items():
            before = contents(folder).get(name, b"")
            if name != MANIFEST and len(data) > len(before):
                (folder / name).write_bytes(data[:min(len(before) + ahead, len(data))])
                home_written = len(before) + ahead >= len(data)
        if home_written or kept == 4:
            before = contents(folder).get(MANIFEST, b"")
            data = contents(after)[MANIFEST]
            (folder / MANIFEST).write_bytes(data[:min(len(before) + torn, len(data))])
    filled(folder)
    assert contents(folder) == contents(whole)


def test_homes_are_read_by_row_and_shards_by_any_reader_of_gzip(tmp_path):
    filled(tmp_path)
    store = Store(tmp_path)
    assert [json.loads(store.line(row))["home"] for row in store.rows() if "shard" in row] == [0, 1, 2, 3, 5, 6]
    shards = sorted((tmp_path / HOMES).iterdir())
    assert [json.loads(line)["home"] for file in shards for line in gzip.open(file)] == [0, 1, 2, 3, 5, 6]
    assert [file.name for file in shards] == ["00000.jsonl.gz", "00001.jsonl.gz", "00002.jsonl.gz"]


def test_a_shard_that_lost_bytes_is_not_written_on(tmp_path):
    filled(tmp_path)
    os.truncate(tmp_path / HOMES / "00000.jsonl.gz", 20)
    with pytest.raises(BadInput, match=r"00000\.jsonl\.gz: \d+ bytes are missing"):
        Writer(Store(tmp_path), PER_SHARD)


def test_two_runs_do_not_write_to_one_folder(tmp_path):
    writer = Writer(Store(tmp_path), PER_SHARD)
    with pytest.raises(BadInput, match="another run"):
        Writer(Store(tmp_path), PER_SHARD)
    writer.close()
    filled(tmp_path)


def test_a_piece_that_kills_its_worker_is_lost_alone_and_in_its_place():
    pieces = [f"{i} * {i}" for i in range(12)]
    pieces[0] = pieces[5] = "__import__('os')._exit(3)"
    found = list(pool.results(eval, pieces, 2, partial(str.__add__, "lost ")))
    assert found == [f"lost {pieces[i]}" if i in (0, 5) else i * i for i in range(12)]


def test_a_piece_whose_workers_are_killed_by_others_is_done_all_the_same(tmp_path):
    """Killed in the pool and then thrice alone, as a host without memory may."""
    deadly = (f"(lambda killed: [1, __import__('os')._exit(9)] if killed.write('x') and killed.tell() < 5 else 7)"
              f"(open({str(tmp_path / 'deaths')!r}, 'a', buffering=1))")
    assert list(pool.results(eval, [deadly, "2", "3"], 2, partial(str.__add__, "lost "))) == [7, 2, 3]


def test_work_goes_on_when_what_starts_the_workers_is_killed_meanwhile():
    """Stopped, it takes the wish for a worker without answering; then it dies."""
    assert list(pool.results(eval, ["1"] * 3, 2, str)) == [1] * 3
    starter = forkserver._forkserver._forkserver_pid
    os.kill(starter, signal.SIGSTOP)
    threading.Timer(0.5, os.kill, (starter, signal.SIGKILL)).start()
    assert list(pool.results(eval, ["1 + 1"] * 5, 2, partial(str.__add__, "lost "))) == [2] * 5
    assert forkserver._forkserver._forkserver_pid != starter


@pytest.mark.parametrize("change", [
    {"shard": "../../etc/passwd"}, {"id": "../x"}, {"id": "a/b"}, {"start": -1}, {"start": 2**70},
    {"length": 10**15}, {"length": 2**70}, {"sides": [1.0, None]}, {"sides": []}, {"sides": [1.0, 1e300]},
    {"sides": [-1.0, 1.0]}, {"sides": [1.0, float("nan")]}, {"rooms": None}, {"digests": {}},
    {"seconds": 3}, {"seed": "1"}])
def test_a_row_that_no_run_wrote_is_bad_input(tmp_path, change):
    filled(tmp_path)
    first, *others = (tmp_path / MANIFEST).read_bytes().splitlines(keepends=True)
    (tmp_path / MANIFEST).write_bytes(json.dumps(json.loads(first) | change).encode() + b"\n" + b"".join(others))
    with pytest.raises(BadInput, match=r"manifest\.jsonl:1: "):
        list(Store(tmp_path).rows())


def test_workers_seldom_look_for_garbage():
    [fresh, *_] = {*pool.results(eval, ["__import__('gc').get_threshold()[0]"] * 2, 2, str)}
    assert fresh == garbage.FRESH


@pytest.mark.parametrize("compiles", [True, False])
def test_workers_that_have_compiled_are_replaced_once_and_nothing_is_lost(compiles):
    """What a compiler takes of a process it never gives back."""
    first = "__import__('numba').njit(lambda x: x + {i})(1)" if compiles else "1 + {i}"
    piece = f"(__import__('apartgen.stages.compiling'), {first}, __import__('os').getpid())[1:]"
    found = list(pool.results(eval, [piece.format(i=i) for i in range(40)], 2, str))
    assert [value for value, _ in found] == list(range(1, 41))
    who = [pid for _, pid in found]
    assert bool(set(who[:2]) & set(who[-2:])) != compiles
    assert len(set(who)) <= (4 if compiles else 2)
