"""Stages over many: lines in and out, results as they are done, nothing made twice, nothing lost."""

import gzip
import json
import os
import signal
import subprocess
import sys
import time

import commandline
import handmade
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Plan
from apartgen.stages.plan.config import PlanConfig
from apartgen.steps import Step, each
from apartgen_cli.stage import over


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, stdin=b"": commandline.run(capsys, monkeypatch, *args, stdin=stdin)


def home(id: str, prompt: str = "flat") -> str:
    body = handmade.plan().model_copy(update={"prompt": prompt})
    return artifact.as_line(artifact.finish(body, Made(by="test", seed=5, id=id))[0])


@pytest.fixture
def lines() -> str:
    return "".join(home(id) for id in "abc")


def test_lines_become_lines_that_keep_their_ids(cli, lines):
    done = cli("metrics", stdin=lines)
    assert done.code == 0, done.err
    assert [json.loads(line)["made"]["id"] for line in done.out.splitlines()] == ["a", "b", "c"]


def test_one_line_alone_is_one_artifact(cli, lines):
    out = cli("metrics", stdin=lines.splitlines()[0]).out
    assert out.count("\n") > 3 and json.loads(out)["made"]["id"] == "a"


def test_files_of_lines_are_read_and_written_whole(cli, lines, tmp_path):
    (tmp_path / "in.jsonl").write_text(lines)
    (tmp_path / "in.jsonl.gz").write_bytes(gzip.compress(lines.encode()))
    for name in ("in.jsonl", "in.jsonl.gz"):
        assert cli("metrics", tmp_path / name, "-o", tmp_path / "out.jsonl").code == 0
        assert len((tmp_path / "out.jsonl").read_text().splitlines()) == 3
    assert sorted(os.listdir(tmp_path)) == ["in.jsonl", "in.jsonl.gz", "out.jsonl"]
    assert cli("metrics", tmp_path / "in.jsonl", "-o", tmp_path / "in.jsonl").code == 2


def test_in_a_folder_results_are_called_by_ids(cli, lines, tmp_path):
    assert cli("metrics", "-o", f"{tmp_path}/", stdin=lines + home("", "Studio, bright") + home("")).code == 0
    assert sorted(os.listdir(tmp_path)) == ["a.json", "b.json", "c.json", "flat.json", "studio-bright.json"]


def test_homes_of_equal_words_do_not_take_each_others_place(cli, tmp_path):
    two = home("") + home("").replace('"seed":5', '"seed":6')
    assert cli("metrics", "-o", f"{tmp_path}/", stdin=two).code == 0
    assert len(os.listdir(tmp_path)) == 2


def test_a_bad_line_is_named_and_the_others_are_done(cli, lines, tmp_path):
    done = cli("metrics", stdin=lines + '{"apartgen": "plan"}\n' + "{nonsense}\n")
    assert done.code == 2 and len(done.out.splitlines()) == 3
    assert "standard input:4" in done.err and "standard input:5" in done.err and "2 of 5" in done.err


def test_exports_of_lines_get_folders_and_are_left_when_whole(cli, lines, tmp_path):
    assert cli("export", "--format", "svg", "-o", f"{tmp_path}/", stdin=lines).code == 0
    assert sorted(os.listdir(tmp_path)) == ["a", "b", "c"]
    (tmp_path / "b" / "plan.svg").write_text("")
    before = {name: (tmp_path / name / "plan.svg").stat().st_mtime_ns for name in "abc"}
    assert cli("export", "--format", "svg", "-o", f"{tmp_path}/", stdin=lines).code == 0
    after = {name: (tmp_path / name / "plan.svg").stat().st_mtime_ns for name in "abc"}
    assert {name for name in "abc" if before[name] != after[name]} == {"b"}


def step(tried: list[str], wrong: set[str]) -> Step:
    """A stage that marks what it is given, and cannot do some."""

    def one(body, config, rng):
        tried.append(body.prompt)
        if body.prompt in wrong:
            raise Unmet("no room")
        return body.model_copy(update={"height": 3.0})

    return Step("plan", Plan, PlanConfig, each(one))


def test_failures_are_listed_and_tried_again_alone(tmp_path, monkeypatch, capsys):
    (tmp_path / "in.jsonl").write_text(home("a", "one") + home("b", "two"))
    (tmp_path / "c.json").write_text(home("c", "three"))
    inputs, out, listing = [str(tmp_path / "in.jsonl"), str(tmp_path / "c.json")], f"{tmp_path}/out/", tmp_path / "left"
    tried: list[str] = []
    assert over(step(tried, {"two", "three"}), inputs, out, None, PlanConfig(), failures=listing) == 1
    assert "in.jsonl:2 (b): no room" in capsys.readouterr().err
    rows = [json.loads(line) for line in listing.read_text().splitlines()]
    assert [row["error"] for row in rows] == ["no room"] * 2 and rows[1]["input"] == inputs[1]
    tried.clear()
    assert over(step(tried, {"three"}), None, out, None, PlanConfig(), retry=listing) == 1
    assert tried == ["two", "three"] and len(listing.read_text().splitlines()) == 1
    assert sorted(os.listdir(out)) == ["a.json", "b.json"]
    assert over(step(tried, set()), None, out, None, PlanConfig(), retry=listing) == 0
    assert listing.read_text() == "" and len(os.listdir(out)) == 3


@pytest.mark.parametrize("out", ["out/", "out.jsonl"])
def test_an_interrupted_run_goes_on_where_it_was(tmp_path, out):
    (tmp_path / "in.jsonl").write_text("".join(home(str(i), str(i)) for i in range(20)))
    tried: list[str] = []

    def stop(body, config, rng):
        if len(tried) == 7:
            raise KeyboardInterrupt
        tried.append(body.prompt)
        return body.model_copy(update={"height": 3.0})

    place = f"{tmp_path}/{out}"
    with pytest.raises(KeyboardInterrupt):
        over(Step("plan", Plan, PlanConfig, each(stop)), [f"{tmp_path}/in.jsonl"], place, None, PlanConfig())
    assert not (tmp_path / "out.jsonl").exists(), "a file of lines is there whole or not at all"
    if out.endswith("l"):
        with (tmp_path / ".out.jsonl.part").open("ab") as file:
            file.write(b'{"apartgen":"plan","version":2,"made":{"by"')
    tried.clear()
    assert over(step(tried, set()), [f"{tmp_path}/in.jsonl"], place, None, PlanConfig()) == 0
    assert tried == [str(i) for i in range(7, 20)]
    assert over(step(tried, set()), [f"{tmp_path}/in.jsonl"], place, None, PlanConfig()) == 0
    assert len(tried) == 13 and len(os.listdir(tmp_path)) == 2, "nothing is made twice, nothing is left over"
    if out.endswith("l"):
        found = [json.loads(line)["made"]["id"] for line in (tmp_path / "out.jsonl").read_text().splitlines()]
        assert found == [str(i) for i in range(20)]


def test_results_come_before_the_inputs_have_ended():
    reading = subprocess.Popen([sys.executable, "-m", "apartgen_cli", "metrics"], text=True,
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert reading.stdin and reading.stdout
    reading.stdin.write("".join(home(str(i)) for i in range(20)))
    reading.stdin.flush()
    assert json.loads(reading.stdout.readline())["made"]["id"] == "0"
    reading.kill()
    reading.communicate()


def test_a_run_that_is_killed_leaves_whole_files_only(tmp_path):
    (tmp_path / "in.jsonl").write_text("".join(home(str(i)) for i in range(300)))
    command = [sys.executable, "-m", "apartgen_cli", "-q", "metrics", f"{tmp_path}/in.jsonl", "-o", f"{tmp_path}/out/"]
    process = subprocess.Popen(command)
    end = time.monotonic() + 60
    while (not (tmp_path / "out").exists() or len(os.listdir(tmp_path / "out")) < 3) and time.monotonic() < end:
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    found = sorted((tmp_path / "out").iterdir())
    assert found and all(json.loads(file.read_text())["apartgen"] == "metrics" for file in found)
    assert not [file for file in found if file.name.startswith(".") and file.suffix != ".part"]


def test_what_a_killed_export_left_is_taken_away_by_the_next(cli, lines, tmp_path):
    out, work = tmp_path / "scene", tmp_path / ".scene.part"
    args = "export", "--format", "svg", "-o", f"{out}/"
    assert cli(*args, stdin=home("a")).code == 0
    picture = (out / "plan.svg").read_bytes()
    (work / "new").mkdir(parents=True)
    (work / "new" / "half.svg").write_text("<svg")
    out.rename(work / "old")
    with pytest.raises(SystemExit):  # killed before anything is written: the earlier one is back
        export_until_checked(out)
    assert (out / "plan.svg").read_bytes() == picture
    assert cli(*args, stdin=home("b")).code == 0 and os.listdir(tmp_path) == ["scene"]


def export_until_checked(out):
    from apartgen.stages.scene.folder import replaced

    with replaced(out):
        raise SystemExit


def test_pictures_of_lines_go_into_folders_by_id_and_what_fails_can_be_tried_again(cli, tmp_path):
    out, failed, small = tmp_path / "out", tmp_path / "failed.jsonl", ("--kind", "above", "--width", 32, "--height", 32)
    far = json.loads(home("far"))
    far["body"]["openings"][0]["rooms"] = ["attic_1"]
    done = cli("render", "-o", f"{out}/", "--points", 0, *small, "--failures", failed,
               stdin=home("a") + json.dumps(far) + "\n" + home("b"))
    assert done.code == 2 and "1 of 3 could not be done" in done.err
    assert sorted(file.name for file in out.iterdir()) == ["a", "b"] and (out / "a" / "views.json").is_file()
    assert cli("render", "-o", "-", stdin=home("a")).code == 2
