"""`apartgen dataset`: the same homes whoever makes them, however often it is killed; damage is found."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import commandline
import pytest

from apartgen.dataset.store import HOMES, MANIFEST, Store

PROMPTS = ["studio", "studio", '{"id": "mine", "prompt": "studio", "seed": 5}',
           "a 20 m² flat with four bedrooms of 15 m² each",
           '{"id": "high", "prompt": "studio", "settings": {"plan": {"height": 3}}}']
SETTINGS = '[layout]\ncandidates = 1\n[plan]\nenough = 1\ncandidates = 1\n'


def timeless(folder: Path) -> dict[str, bytes]:
    """Every file of a data set, times left out, those of the table of times too."""
    found = {file.relative_to(folder).as_posix(): file.read_bytes() for file in sorted(folder.rglob("*"))
             if file.is_file() and file.name not in ("README.md", "croissant.json", "manifest.parquet")}
    found[MANIFEST] = re.sub(rb'"seconds":\{[^}]*\}', b"", found[MANIFEST])
    return found


@pytest.fixture(scope="module")
def lists(tmp_path_factory):
    folder = tmp_path_factory.mktemp("lists")
    (folder / "prompts.jsonl").write_text("\n".join(PROMPTS) + "\n")
    (folder / "settings.toml").write_text(SETTINGS)
    return folder


def arguments(lists: Path, out: Path, workers: int = 2) -> list[str]:
    return [sys.executable, "-m", "apartgen_cli", "dataset", "build", str(lists / "prompts.jsonl"), "-o", str(out),
            "--config", str(lists / "settings.toml"), "--shard", "3", "--workers", str(workers), "--seed", "2"]


@pytest.fixture(scope="module")
def data(lists, tmp_path_factory):
    out = tmp_path_factory.mktemp("data") / "data"
    done = subprocess.run(arguments(lists, out), capture_output=True, text=True, timeout=300)
    assert done.returncode == 1 and "Traceback" not in done.stderr, done.stderr
    return out


@pytest.fixture
def copy(data, tmp_path):
    return Path(shutil.copytree(data, tmp_path / "data"))


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args: commandline.run(capsys, monkeypatch, "dataset", *args)


def test_every_request_has_a_row_and_every_home_its_own_draw(data):
    rows = list(Store(data).rows())
    assert [row["id"] for row in rows] == ["studio", "studio-2", "mine", rows[3]["id"], "high"]
    assert "four bedrooms" in rows[3]["prompt"] and rows[3]["status"] == 1 and "shard" not in rows[3]
    homes = {row["id"]: json.loads(Store(data).line(row)) for row in rows if "shard" in row}
    assert len({json.dumps(home["body"]["rooms"]) for home in homes.values()}) == 4
    assert homes["mine"]["made"]["seed"] == 5 and homes["studio"]["made"]["seed"] == 2
    assert homes["high"]["body"]["height"] == 3
    assert all(row["certified"] == (not row["faults"]) for row in rows if "shard" in row)
    assert {row["split"] for row in rows if "shard" in row} <= {"train", "val", "test"}
    [failed] = (data / "failures.jsonl").read_text().splitlines()
    assert "four bedrooms" in json.loads(failed)["prompt"]


def test_a_build_that_is_killed_and_resumed_is_the_same(lists, data, tmp_path):
    out = tmp_path / "data"
    running = subprocess.Popen(arguments(lists, out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 120
    while time.monotonic() < end and running.poll() is None and (
            not (out / MANIFEST).exists() or (out / MANIFEST).read_bytes().count(b"\n") < 2):
        time.sleep(0.02)
    running.send_signal(signal.SIGKILL)
    running.wait()
    done = subprocess.run(arguments(lists, out, workers=1), capture_output=True, text=True, timeout=300)
    assert done.returncode in (0, 1), done.stderr
    assert timeless(out) == timeless(data)
    before = {file: file.stat().st_mtime_ns for file in out.rglob("*")}
    assert subprocess.run(arguments(lists, out), capture_output=True, timeout=300).returncode == 0
    assert {file: file.stat().st_mtime_ns for file in (out / HOMES).iterdir()}.items() <= before.items()


def test_a_sound_data_set_is_verified_and_described(cli, data):
    assert cli("verify", data, "--workers", 1).out == ""
    found = json.loads(cli("stats", data, "--json").out)
    assert found["homes"] == 4 and found["failed"] == 1
    assert found["certified"] == sum(row.get("certified", False) for row in Store(data).rows())
    assert found["figures"]["area"]["n"] == 4 and found["rooms"]["bathroom"] >= 4
    assert "4 homes, 1 failed" in cli("stats", data).out and "4 homes, 1 failed" in (data / "README.md").read_text()
    metadata = json.loads((data / "croissant.json").read_text())
    assert metadata["conformsTo"].endswith("1.0") and metadata["distribution"][0]["sha256"]


DAMAGE = {
    "a byte": lambda folder: _flip(folder / HOMES / "00000.jsonl.gz", 3000),
    "the end": lambda folder: os.truncate(folder / HOMES / "00001.jsonl.gz", 500),
    "a row": lambda folder: _rows(folder, lambda rows: rows[1:]),
    "a row twice": lambda folder: _rows(folder, lambda rows: [*rows, rows[0]]),
    "an order": lambda folder: _rows(folder, lambda rows: [rows[1], rows[0], *rows[2:]]),
    "a claim": lambda folder: _rows(folder, lambda rows: [_other_claim(rows[0]), *rows[1:]]),
    "a digest": lambda folder: _rows(folder, lambda rows: [re.sub(rb'"sha256:..', b'"sha256:zz', rows[0]),
                                                           *rows[1:]]),
    "a file": lambda folder: (folder / HOMES / "00007.jsonl.gz").write_bytes(b"x"),
}


def _other_claim(row: bytes) -> bytes:
    said = json.loads(row)
    return json.dumps(said | {"certified": not said["certified"]}).encode() + b"\n"


def _flip(file: Path, place: int) -> None:
    data = bytearray(file.read_bytes())
    data[place] ^= 1
    file.write_bytes(data)


def _rows(folder: Path, change) -> None:
    file = folder / MANIFEST
    file.write_bytes(b"".join(change(file.read_bytes().splitlines(keepends=True))))


@pytest.mark.parametrize("kind", DAMAGE)
def test_damage_of_every_kind_is_found(cli, copy, kind):
    DAMAGE[kind](copy)
    done = cli("verify", copy, "--workers", 1)
    assert done.code == 1 and done.out and "Traceback" not in done.err


def test_one_home_comes_out_again_byte_for_byte(cli, data, tmp_path):
    rows = {row["id"]: row for row in Store(data).rows()}
    for id in ("studio-2", "high"):
        assert cli("rebuild", data, id, "-o", tmp_path / f"{id}.json").code == 0
        assert (tmp_path / f"{id}.json").read_bytes() == Store(data).line(rows[id])
    assert cli("rebuild", data, "nobody").code == 2


def test_a_home_that_would_come_out_otherwise_is_told(cli, copy):
    _rows(copy, lambda rows: [re.sub(rb'"seed":2', b'"seed":3', rows[0]), *rows[1:]])
    done = cli("rebuild", copy, "studio")
    assert done.code == 1 and "differently from plan on" in done.err


def test_sets_are_divided_and_merged(cli, lists, data, copy, tmp_path):
    assert cli("split", copy, "--parts", "all=1").code == 0
    assert {row["split"] for row in Store(copy).rows() if "shard" in row} == {"all"}
    assert cli("merge", data, copy, "-o", tmp_path / "both").code == 0
    both = [row["sha256"] for row in Store(tmp_path / "both").rows() if "shard" in row]
    assert both == [row["sha256"] for row in Store(data).rows() if "shard" in row]
    assert cli("verify", tmp_path / "both", "--workers", 1).code == 0
    assert cli("merge", data, copy, "-o", tmp_path / "both").code == 2, "a folder that is taken"


def test_another_data_set_is_not_written_into_this_one(lists, copy, cli):
    assert cli("build", lists / "prompts.jsonl", "-o", copy, "--seed", 3).code == 2
    assert cli("build", "--prompts-from", "default", "--count", 3, "-o", copy, "--seed", 2).code == 2
    assert cli("build", lists / "prompts.jsonl", "-o", lists).code == 2, "a folder of other files"


def test_scenes_share_their_files(cli, data, tmp_path):
    done = cli("export", data, "-o", tmp_path, "--format", "svg", "--id", "studio", "--id", "mine", "--workers", 1)
    assert done.code == 0, done.err
    assert sorted(os.listdir(tmp_path)) == ["mine", "store", "studio"]
    stored = {file.name: file.stat().st_ino for file in (tmp_path / "store").rglob("*") if file.is_file()}
    for id in ("mine", "studio"):
        files = json.loads((tmp_path / id / "export.json").read_text())["body"]["files"]
        assert files and all((tmp_path / id / file["path"]).stat().st_ino == stored[file["sha256"]] for file in files)
