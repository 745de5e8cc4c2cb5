"""`apartgen check` from the command line: files, folders, pipes, its words and its exit status."""

import json
from pathlib import Path

import commandline
import pytest

ROOT = Path(__file__).parents[2]
RIGHT = ROOT / "examples/two-bedroom-flat/walkable.json"


@pytest.fixture
def run(capsys, monkeypatch):
    def checked(*args, stdin=b""):
        return commandline.run(capsys, monkeypatch, "check", *args, stdin=stdin)

    return checked


@pytest.fixture
def wrong(tmp_path):
    """The flat with a bed under the floor and without an entrance."""
    raw = json.loads(RIGHT.read_text())
    raw["body"]["openings"] = [o for o in raw["body"]["openings"] if o["kind"] != "entrance"]
    bed = next(o for o in raw["body"]["objects"] if o["category"] == "double_bed")
    bed["center"][2] -= 1.5
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(raw))
    return file


def test_a_right_home_is_certified(run):
    done = run(RIGHT)
    assert (done.code, done.out) == (0, f"{RIGHT}: certified\n")


def test_faults_are_told_one_a_line_with_ids_and_place(run, wrong):
    done = run(wrong)
    head, *rows = done.out.splitlines()
    assert done.code == 1 and head.startswith(f"{wrong}: refused, ")
    assert any(row.strip() == "no-entrance: there is no way in" for row in rows)
    (bed,) = (row for row in rows if row.strip().startswith("storey "))
    assert "double_bed_1 at (" in bed and bed.endswith("): 1.5 m under the floor or above the ceiling")


def test_machines_get_a_line_of_json_for_every_home(run, wrong):
    done = run(RIGHT, wrong, "--json")
    right, refused = map(json.loads, done.out.splitlines())
    assert done.code == 1 and right == {"file": str(RIGHT), "kind": "walkable", "certified": True, "faults": []}
    assert refused["certified"] is False
    fault = next(fault for fault in refused["faults"] if fault["code"] == "storey")
    assert fault["refuses"] and fault["value"] == pytest.approx(1.5) and len(fault["at"]) == 3 and len(fault["of"]) == 1


def test_a_pipe_a_list_and_a_folder(run, wrong, tmp_path):
    piped = run(stdin=RIGHT.read_bytes())
    assert (piped.code, piped.out) == (0, "standard input: certified\n")
    rows = [json.dumps(json.loads(file.read_text())) for file in (RIGHT, wrong)]
    listed = run("-", stdin="\n".join(rows) + "\n")
    assert listed.code == 1 and [row.split(",")[0] for row in listed.out.splitlines() if not row.startswith(" ")] == [
        "standard input:1: certified", "standard input:2: refused"]
    (tmp_path / "deep").mkdir()
    (tmp_path / "deep/right.json").write_text(rows[0])
    (tmp_path / "notes.json").write_text('{"no": "home"}')
    (tmp_path / "metrics.json").write_text((ROOT / "tests/golden/v1/metrics.json").read_text())
    folder = run(tmp_path, "--json")
    names = {Path(json.loads(row)["file"]).name: json.loads(row)["certified"] for row in folder.out.splitlines()}
    assert folder.code == 1 and names == {"wrong.json": False, "right.json": True}


def test_what_is_noted_is_shown_and_refuses_when_wanted(run):
    before = ROOT / "tests/golden/v1/retrieve.json"
    plain, noted, strict = run(before), run(before, "--notes"), run(before, "--strict")
    assert (plain.code, noted.code, strict.code) == (0, 0, 1)
    assert len(plain.out.splitlines()) == 1 and "certified, 1 note" in plain.out
    assert "note: unreached " in noted.out and "refused, 1 fault" in strict.out


@pytest.mark.parametrize("data", [b"", b"{", b"[1]", b'{"apartgen": "plan"}', b'{"apartgen": "castle"}', b"\xff\xfe"])
def test_what_cannot_be_read_is_said(run, data):
    done = run("-", stdin=data)
    assert done.code == 2 and done.out == "" and done.err.startswith("apartgen: standard input")
    assert len(done.err.splitlines()) <= 2


def test_the_worst_decides_and_all_are_looked_at(run, wrong, tmp_path):
    done = run(tmp_path / "none.json", wrong, RIGHT)
    assert done.code == 2 and "none.json: cannot be read" in done.err
    assert "refused" in done.out and done.out.endswith(f"{RIGHT}: certified\n")
    (tmp_path / "empty").mkdir()
    assert run(tmp_path / "empty").code == 2


def test_files_that_no_stage_would_read_are_judged_all_the_same(run, wrong):
    raw = json.loads(wrong.read_text())
    raw["body"]["objects"][1]["id"] = raw["body"]["objects"][0]["id"]
    raw["body"]["rooms"][0]["polygon"].reverse()
    wrong.write_text(json.dumps(raw))
    done = run(wrong)
    assert done.code == 1 and "twice" in done.out and "clockwise" in done.out


@pytest.mark.parametrize("word, more", [("layout", []), ("walkable", []), ("export", ["--format", "svg"])])
def test_every_stage_looks_at_its_inputs_first(capsys, monkeypatch, tmp_path, wrong, word, more):
    done = commandline.run(capsys, monkeypatch, word, wrong, *more, "-o", tmp_path / "out")
    assert done.code == 2 and not (tmp_path / "out").exists()
    assert "no-entrance" in done.err and "--trust" in done.err and len(done.err.splitlines()) == 1


def test_who_trusts_a_file_gets_what_it_holds(capsys, monkeypatch, tmp_path, wrong):
    done = commandline.run(capsys, monkeypatch, "export", wrong, "--trust", "--format", "svg", "-o", tmp_path / "out")
    assert done.code == 0 and list((tmp_path / "out").glob("*.svg"))


def test_figures_of_faulty_homes_come_with_a_warning(capsys, monkeypatch, tmp_path, wrong):
    done = commandline.run(capsys, monkeypatch, "metrics", wrong, "--metric", "counts", "-o", tmp_path / "m.json")
    assert done.code == 0 and "warning" in done.err and "no-entrance" in done.err
