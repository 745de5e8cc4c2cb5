"""Command lines: where results go, what is said, and the exit status."""

import json
import logging
import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import commandline
import handmade
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import Plan
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.plan.config import PlanConfig
from apartgen.steps import Step, each
from apartgen_cli import make
from apartgen_cli.console import listen
from apartgen_cli.main import WORDS
from apartgen_cli.options import configured
from apartgen_cli.stage import over


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args, stdin=b"": commandline.run(capsys, monkeypatch, *args, stdin=stdin)


@pytest.fixture(scope="module")
def text() -> str:
    return artifact.finish(handmade.plan(), Made(by="test", seed=5))[0]


@pytest.fixture
def plan(text, tmp_path):
    file = tmp_path / "plan.json"
    file.write_text(text)
    return file


def refused(done, code: int = 2) -> str:
    """What a refusal says: a line or two, no traceback, nothing on standard output."""
    assert done.code == code, done
    assert done.out == "" and 1 <= done.err.count("\n") <= 2 and "Traceback" not in done.err, done
    return done.err


def test_a_sentence_becomes_a_plan_on_standard_output(cli):
    done = cli("plan", "studio", "--seed", 3)
    read = artifact.parse(done.out.encode(), "out", Plan)
    assert done.code == 0 and read.made.seed == 3 and read.body.prompt == "studio"
    assert "wrote" not in done.err


@pytest.mark.parametrize("args", [["plan"], ["plan", "-"]])
def test_the_prompt_may_come_from_a_pipe(cli, args):
    assert json.loads(cli(*args, stdin="studio\n").out)["body"]["prompt"] == "studio"


def test_a_result_goes_into_a_file_and_nothing_else_is_said_on_standard_output(cli, tmp_path):
    done = cli("plan", "studio", "-o", tmp_path / "a.json")
    assert done.code == 0 and done.out == "" and "a.json" in done.err
    assert cli("--quiet", "plan", "studio", "-o", tmp_path / "b.json").err == ""
    one, two = commandline.timeless(tmp_path).values()
    assert one == two


def test_several_inputs_fill_a_folder(cli, tmp_path):
    done = cli("plan", "studio", "one-bedroom flat", "-o", f"{tmp_path}/plans/")
    assert done.code == 0 and sorted(os.listdir(tmp_path / "plans")) == ["one-bedroom-flat.json", "studio.json"]
    done = cli("metrics", *(tmp_path / "plans").iterdir(), "-o", f"{tmp_path}/figures/")
    assert done.code == 0 and sorted(os.listdir(tmp_path / "figures")) == ["one-bedroom-flat.json", "studio.json"]


def test_a_plan_alone_or_among_others_is_the_same(cli, tmp_path):
    cli("plan", "studio", "one-bedroom flat", "-o", f"{tmp_path}/", "--seed", 4)
    alone = json.loads(cli("plan", "one-bedroom flat", "--seed", 4).out)
    assert json.loads((tmp_path / "one-bedroom-flat.json").read_text())["body"] == alone["body"]


def test_equal_names_are_told_apart_by_their_folders(cli, text, tmp_path):
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "plan.json").write_text(text)
    assert cli("metrics", tmp_path / "a/plan.json", tmp_path / "b/plan.json", "-o", f"{tmp_path}/m/").code == 0
    assert (tmp_path / "m/a/metrics.json").exists() and (tmp_path / "m/b/metrics.json").exists()


def test_inputs_are_not_overwritten_by_results(cli, text, tmp_path):
    file = tmp_path / "flat.json"
    file.write_text(text)
    assert "would be lost" in refused(cli("metrics", file, "-o", f"{tmp_path}/"))
    assert file.read_text() == text


def test_one_bad_input_of_several_does_not_stop_the_others(cli, plan, tmp_path):
    (tmp_path / "bad.json").write_text("{}")
    done = cli("metrics", plan, tmp_path / "bad.json", "-o", f"{tmp_path}/m/")
    assert done.code == 2 and os.listdir(tmp_path / "m") == ["metrics.json"]
    assert "bad.json" in done.err and "1 of 2" in done.err


def test_two_inputs_whose_results_would_get_one_name(cli, plan, text, tmp_path):
    copy = plan.with_name("layout.json")
    copy.write_text(text)
    message = refused(cli("metrics", plan, copy, "-o", f"{tmp_path}/many/"))
    assert str(plan) in message and str(copy) in message and "metrics.json" in message
    assert not (tmp_path / "many").exists()


def test_the_seed_is_the_inputs_unless_given(cli, plan):
    assert json.loads(cli("metrics", plan).out)["made"]["seed"] == 5


def test_inputs_are_named_by_their_digest(cli, plan, text):
    digest = artifact.parse(text.encode(), "plan", Plan).digest
    assert json.loads(cli("metrics", plan).out)["made"]["inputs"] == {"plan": digest}


REFUSALS = {
    "no command": (["sell"], "No such command"),
    "no such option": (["plan", "studio", "--floors", "2"], "--floors"),
    "option without value": (["plan", "studio", "--seed"], "--seed"),
    "negative seed": (["plan", "studio", "--seed", "-1"], "--seed"),
    "seed no number": (["plan", "studio", "--seed", "x"], "--seed"),
    "setting out of range": (["plan", "studio", "--wave", "0"], "--wave 0"),
    "setting no number": (["layout", "PLAN", "--guidance", "articulation=nan"], "articulation=nan: input should"),
    "setting infinite": (["layout", "PLAN", "--guidance-scale", "inf"], "--guidance-scale inf"),
    "negative weight": (["layout", "PLAN", "--guidance", "inside=-5"], "--guidance inside=-5"),
    "weight that nothing heeds": (["layout", "PLAN", "--guidance", "quantity=50"], "--count guided"),
    "repeats that nothing heeds": (["layout", "PLAN", "--scaling", "sigma", "--guidance-repeats", "9"], "one gradient"),
    "endless learning rate": (["train", "layout", "--lr", "inf"], "--lr inf"),
    "raster too fine": (["walkable", "PLAN", "--resolution", "0.00001"], "--resolution 1e-05"),
    "reach within the robot": (["walkable", "PLAN", "--reach", "0.1"], "radius is 0.25"),
    "corpus into a folder": (["train", "corpus", "single_rooms", "--rooms", "1", "-o", "."], "name a file"),
    "corpus into nowhere": (["train", "corpus", "single_rooms", "--rooms", "1", "-o", "none/c.npz"], "no folder none"),
    "weights into nowhere": (["train", "layout", "-o", "none/w.safetensors"], "no folder none"),
    "split of an unsplit source": (
        ["train", "corpus", "single_rooms", "--rooms", "1", "--split", "val", "-o", "c.npz"], "none of single_rooms"),
    "empty prompt": (["plan", "  "], "prompt is empty"),
    "prompt not text": (["plan", "a\udcff"], "not UTF-8"),
    "endless prompt": (["plan", "room " * 9000], "characters"),
    "missing file": (["metrics", "nowhere.json"], "nowhere.json"),
    "several results, no folder": (["plan", "studio", "loft", "-o", "a.json"], "give -o a.json/"),
    "a file where a sentence is expected": (["plan", "plan.json"], "--prompts"),
    "an artifact where a sentence is expected": (["plan", '{"apartgen": "plan"}'], "JSON where a sentence"),
    "sentences and a list of them": (["plan", "studio", "--prompts", "p.txt"], "give one of them"),
    "the input as output": (["metrics", "PLAN", "-o", "plan.json"], "would be lost"),
    "compressed output": (["plan", "studio", "-o", "a.jsonl.gz"], "not compressed"),
    "unknown kind": (["schema", "palace"], "walkable"),
    "unknown metric": (["metrics", "PLAN", "--metric", "beauty"], "beauty"),
    "unknown format": (["export", "PLAN", "--format", "papyrus", "-o", "x/"], "papyrus"),
    "no format": (["export", "PLAN", "-o", "x/"], "--format"),
    "export into a pipe": (["export", "PLAN", "--format", "svg", "-o", "-"], "folder"),
    "no folder to make": (["make", "studio"], "--out"),
    "settings missing": (["plan", "studio", "--config", "none.toml"], "none.toml"),
    "unwritable": (["plan", "studio", "-o", "/proc/none/a.json"], "cannot be written"),
    "plan where a layout is needed": (["retrieve", "PLAN"], "a plan artifact where layout"),
}


@pytest.mark.parametrize("name", REFUSALS)
def test_wrong_requests_end_in_a_line_and_status_2(cli, plan, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    args, message = REFUSALS[name]
    assert message in refused(cli(*[str(plan) if arg == "PLAN" else arg for arg in args]))


def test_what_cannot_be_met_ends_with_status_1(cli):
    refused(cli("plan", "a 20 m² flat with four bedrooms of 15 m² each"), code=1)


def test_an_empty_pipe_says_so(cli):
    assert "standard input: empty" in refused(cli("metrics"))


def test_settings_come_from_a_file_and_options_win(cli, tmp_path):
    file = tmp_path / "settings.toml"
    file.write_text("[plan]\nwave = 8\nenough = 1\n")
    config = json.loads(cli("plan", "studio", "--config", file, "--enough", 2).out)["made"]["config"]
    assert config["wave"] == 8 and config["enough"] == 2
    file.write_text("[plan]\nrooms = 8\n")
    assert "'rooms' is unknown" in refused(cli("plan", "studio", "--config", file))
    file.write_text("[layuot]\nsteps = 1\n")
    for command in (["plan", "studio"], ["layout", file], ["train", "layout"], ["make", "studio", "-o", tmp_path]):
        assert "[layuot] is unknown" in refused(cli(*command, "--config", file))
    file.write_text("layout = 5\n")
    assert "is no table" in refused(cli("layout", file, "--config", file))
    file.write_text("[train-layout.shape]\nwidht = 9\n")
    assert "'widht' is unknown" in refused(cli("train", "layout", "--config", file))
    file.write_text("[plan\n")
    assert "not TOML" in refused(cli("plan", "studio", "--config", file))


def test_weights_by_name_change_those_named_wherever_they_are_given(tmp_path):
    file = tmp_path / "settings.toml"
    file.write_text('[layout]\nmodel = "diffusion"\nguidance = {walkway = 1.0, inside = 0}\n')
    from_file = make.settings(file, ["svg"], None)["layout"].guidance
    given = configured(LayoutConfig, {"model": "diffusion", "guidance": ["walkway=1", "inside=0"]}).guidance
    assert from_file == given == {"articulation": 1.0, "inside": 0.0, "openings": 1.0, "walkway": 1.0}


def test_what_is_said_of_one_input_of_several_begins_with_its_name(capsys, text, tmp_path):
    def step(body, config, rng):
        logging.getLogger("apartgen").warning("tight")
        raise Unmet("no room")

    def at_once(bodies, config, rngs):
        for body in reversed(bodies):
            logging.getLogger("apartgen").info("tight", extra={"body": body})
        return [Unmet("no room")] * len(bodies)

    files = [tmp_path / name for name in ("a.json", "b.json")]
    for file in files:
        file.write_text(text)
    listen(quiet=False)
    for advance in (each(step), at_once):
        many = Step("layout", Plan, PlanConfig, advance)
        assert over(many, [str(file) for file in files], f"{tmp_path}/out/", 0, PlanConfig()) == 1
        said = capsys.readouterr().err.splitlines()
        for file in files:
            assert f"apartgen: {file}: no room" in said
            assert sum(line.endswith(f"{file}: tight") for line in said) == 1
    with pytest.raises(Unmet, match="^no room$"):
        over(Step("layout", Plan, PlanConfig, each(step)), [str(files[0])], f"{tmp_path}/out/", 0, PlanConfig())
    assert capsys.readouterr().err == "warning: tight\n"


DRAWN = {"rooms": [
    {"id": "living_room_1", "type": "living_room", "polygon": [[0, 0], [5, 0], [5, 4], [0, 4]]},
    {"id": "bedroom_1", "type": "bedroom", "polygon": [[5, 0], [8, 0], [8, 4], [5, 4]]},
    {"id": "bathroom_1", "type": "bathroom", "polygon": [[0, 4], [2.5, 4], [2.5, 6.5], [0, 6.5]]},
]}


def test_rooms_drawn_by_hand_and_programmes_come_in_place_of_a_prompt(cli, tmp_path):
    file = tmp_path / "drawn.json"
    file.write_text(json.dumps(DRAWN))
    drawn = json.loads(cli("plan", "--from", file).out)["body"]
    assert {room["id"] for room in drawn["rooms"]} == {room["id"] for room in DRAWN["rooms"]}
    assert {opening["kind"] for opening in drawn["openings"]} >= {"door", "entrance", "window"}
    file.write_text(json.dumps(drawn["program"]))
    again = json.loads(cli("plan", "--from", file, "--party-wall", "north", "--entrance", "south").out)["body"]
    assert again["program"]["rooms"] == drawn["program"]["rooms"]
    assert again["program"]["envelope"]["party_walls"] == ["north"]
    file.write_text('{"rooms": [{"id": "bedroom_1"}]}')
    assert "rooms[0].type: field required" in refused(cli("plan", "--from", file))
    refused(cli("plan", "studio", "--from", file))


def test_the_examples_work(cli, tmp_path):
    examples = Path(__file__).parent.parent / "examples"
    for name in ("drawn", "programme"):
        assert cli("plan", "--from", examples / f"{name}.json", "-o", tmp_path / "plan.json").code == 0
    assert cli("plan", "studio", "--config", examples / "settings.toml", "-o", tmp_path / "plan.json").code == 0
    settings = make.settings(examples / "settings.toml", ["svg"], None)
    assert settings["walkable"].robot_radius == 0.3 and settings["layout"].candidates == 8


def test_an_outline_is_filled(cli, tmp_path):
    file = tmp_path / "outline.json"
    file.write_text("[[0, 0], [9, 0], [9, 6.5], [0, 6.5]]")
    rooms = json.loads(cli("plan", "one-bedroom flat", "--outline", file).out)["body"]["rooms"]
    points = [point for room in rooms for point in room["polygon"]]
    assert max(x for x, _ in points) - min(x for x, _ in points) == pytest.approx(9, abs=0.11)
    assert max(y for _, y in points) - min(y for _, y in points) == pytest.approx(6.5, abs=0.11)
    file.write_text("[[0, 0], [9, 0]]")
    assert "outline.json" in refused(cli("plan", "studio", "--outline", file))


def test_variants_are_different_plans(cli, tmp_path):
    assert cli("plan", "one-bedroom flat", "--variants", 3, "-o", f"{tmp_path}/").code == 0
    bodies = [json.loads((tmp_path / f"plan-{k}.json").read_text())["body"]["rooms"] for k in (1, 2, 3)]
    assert all(a != b for i, a in enumerate(bodies) for b in bodies[:i])
    lines = cli("plan", "one-bedroom flat", "--variants", 3).out.splitlines()
    assert [json.loads(line)["body"]["rooms"] for line in lines] == bodies


def test_a_failed_run_leaves_the_old_result(cli, plan, tmp_path):
    old = tmp_path / "old.json"
    old.write_text("good")
    refused(cli("metrics", tmp_path / "missing.json", "-o", old))
    assert old.read_text() == "good"


def test_an_export_appears_in_its_folder_with_its_list(cli, plan, tmp_path):
    done = cli("export", plan, "--format", "svg", "-o", f"{tmp_path}/scene/")
    assert done.code == 0, done.err
    files = json.loads((tmp_path / "scene/export.json").read_text())["body"]["files"]
    assert any(file["format"] == "svg" for file in files)
    assert all((tmp_path / "scene" / file["path"]).is_file() for file in files)
    assert cli("export", plan, "--format", "svg", "-o", f"{tmp_path}/scene/").code == 0, "it may be replaced"


def test_nothing_is_read_from_a_terminal_or_written_to_one(tmp_path, plan):
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "apartgen_cli"]
    try:
        reading = subprocess.run([*command, "metrics"], stdin=theirs, capture_output=True, text=True, timeout=60)
        writing = subprocess.run([*command, "metrics", plan], stdout=theirs, stderr=subprocess.PIPE, text=True,
                                 timeout=60)
    finally:
        os.close(ours)
        os.close(theirs)
    assert reading.returncode == 2 and "nothing to read" in reading.stderr
    assert writing.returncode == 2 and "nowhere to write" in writing.stderr


def test_a_closed_pipe_is_no_error_to_speak_of(plan):
    command = f"{sys.executable} -m apartgen_cli schema walkable | head -c 10"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, timeout=60)
    assert done.stdout == '{\n  "$sche' and done.stderr == ""


def until_idle(pid: int) -> None:
    """Wait until a process has done its imports and waits for input: its CPU time stands still."""
    seen, still, end = -1, 0, time.monotonic() + 60
    while still < 4 and time.monotonic() < end:
        time.sleep(0.5)
        fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        used, asleep = int(fields[11]) + int(fields[12]), fields[0] == "S"
        still = still + 1 if used == seen and used > 0 and asleep else 0
        seen = used


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs /proc")
def test_an_interrupt_is_a_line(tmp_path):
    # A shell's background job hands down an ignored SIGINT.
    waiting = subprocess.Popen([sys.executable, "-m", "apartgen_cli", "metrics"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    until_idle(waiting.pid)
    waiting.send_signal(signal.SIGINT)
    out, err = waiting.communicate(timeout=60)
    assert waiting.returncode == 130 and out == "" and err == "apartgen: interrupted; what was finished is kept\n"


@pytest.mark.parametrize("word", WORDS)
def test_every_command_explains_itself(cli, word):
    done = cli(word, "--help")
    assert done.code == 0 and "Usage" in done.out
