"""Data sets to learn from: what is in the tables is what robots did, by the layout that lerobot reads."""

import json

import numpy as np
import pytest
from embodied import blocks, test_interact

from apartgen.schemas.errors import BadInput
from apartgen.stages.embodied import base, instructions, interact, lerobot, navigate, world
from apartgen.stages.embodied.interact.robot import NAMES
from apartgen.stages.embodied.outcome import RATE, Course
from apartgen_cli.bench import _demonstrations, embodied

flat = test_interact.flat


@pytest.fixture(scope="module")
def driven(tmp_path_factory):
    """The base's way along a corridor, and what it was asked."""
    home = blocks.furnished(blocks.corridor(7, 1.2), blocks.block("goal", 6.7, 0.6, 0.4, 0.6, np.pi))
    folder = tmp_path_factory.mktemp("corridor")
    apartment = world.build(*blocks.exported(home, folder), base.mjcf(), moving=(), fused=True, name="home-1")
    (outcome,) = navigate.run(apartment, np.random.default_rng(0))
    return apartment, outcome


def test_the_base_goes_where_its_commands_lead(driven):
    """Speeds that were commanded, added up, are the way that it drove within 6 %; it ends near its goal."""
    _, outcome = driven
    state, around, action = (np.array(v) for v in (outcome.course.state, outcome.course.around, outcome.course.action))
    assert len(state) == len(action) == round(outcome.numbers["seconds"] * RATE)
    x, y, heading = state[:, :3].T
    went = np.array([action[:-1, 0] * np.cos(heading[:-1]), action[:-1, 0] * np.sin(heading[:-1])]).sum(1) / RATE
    assert went == pytest.approx([x[-1] - x[0], y[-1] - y[0]], abs=0.3)
    assert np.allclose(state[1:, 3:], action[:-1])  # what was commanded before
    assert (around == around[0]).all() and np.hypot(*(state[-1, :2] - around[0, :2])) < 0.25


@pytest.mark.parametrize("made, word", [(test_interact.drawer(), "drawer"), (test_interact.leaf(), "door")])
def test_the_manipulator_follows_its_targets_and_the_part_opens(flat, made, word):
    apartment = flat(made, test_interact.chest(0.3, 2.0))
    (outcome,) = interact.run(apartment)
    state, around, action = (np.array(v) for v in (outcome.course.state, outcome.course.around, outcome.course.action))
    assert len(state) == pytest.approx(outcome.numbers["seconds"] * RATE, abs=2) and state.shape[1] == len(NAMES)
    assert np.abs(state[1:, :11] - action[:-1, :11]).max() < 0.12 and around[0, 0] == pytest.approx(0, abs=1e-3)
    assert around[-1, 0] / made[-1].joint.range[1] >= 0.8
    hand = np.hypot(*(around[:, 1:3] - state[:, :2]).T)
    assert 0.2 < hand.min() and hand.max() < 1.2  # the handle, as far off as an arm gets
    assert instructions.task(apartment, outcome) == f"open the {word} of the chest in the living room"


def _course(half, n, rng):
    names = lerobot.FEATURES[half]
    state, around, action = (rng.normal(size=(n, len(names[name]))).tolist() for name in names)
    return Course(state=state, around=around, action=action)


@pytest.fixture(params=["navigation", "interaction"])
def half(request):
    return request.param


@pytest.fixture
def written(half, tmp_path):
    """Three episodes of two tasks, and the folder of their data set."""
    pytest.importorskip("pyarrow")
    rng = np.random.default_rng(5)
    some = [lerobot.Episode(task, f"home-1:{k}", _course(half, n, rng))
            for k, (task, n) in enumerate([("open the door", 7), ("go home", 4), ("open the door", 1)])]
    files = lerobot.write(half, some, tmp_path / "set")
    return some, tmp_path / "set", files


def _table(path):
    from pyarrow import parquet

    return parquet.read_table(path)


def test_the_files_are_those_of_version_3(written):
    _, folder, files = written
    assert {file.relative_to(folder).as_posix() for file in files} == {
        "meta/info.json", "meta/stats.json", "meta/tasks.parquet", "meta/episodes/chunk-000/file-000.parquet",
        "data/chunk-000/file-000.parquet"}
    assert set(files) == {file for file in folder.rglob("*") if file.is_file()}


def test_rows_come_back_as_they_were(half, written):
    some, folder, _ = written
    info = json.loads((folder / "meta/info.json").read_text())
    rows = _table(folder / info["data_path"].format(chunk_index=0, file_index=0))
    assert set(rows.column_names) == set(info["features"]) and info["codebase_version"] == "v3.0"
    for name, about in info["features"].items():
        kind = rows.schema.field(name).type
        assert str(getattr(kind, "value_type", kind)) in (about["dtype"], "float" if "float" in about["dtype"] else "")
        assert getattr(kind, "list_size", 1) == about["shape"][0] == len(about["names"] or [0])
    for part, name in (("state", lerobot.STATE), ("around", lerobot.AROUND), ("action", lerobot.ACTION)):
        told = np.concatenate([getattr(episode.course, part) for episode in some])
        assert np.array(rows[name].to_pylist()) == pytest.approx(told, abs=1e-6)
    columns = {name: np.array(rows[name].to_pylist()) for name in lerobot.COUNTED}
    assert columns["index"].tolist() == list(range(12)) and info["total_frames"] == 12
    assert columns["episode_index"].tolist() == [0] * 7 + [1] * 4 + [2]
    assert columns["timestamp"] == pytest.approx(columns["frame_index"] / info["fps"])


def test_episodes_and_tasks_point_at_their_rows(written):
    some, folder, _ = written
    rows = _table(folder / "data/chunk-000/file-000.parquet").to_pylist()
    tasks = {row["task_index"]: row["task"] for row in _table(folder / "meta/tasks.parquet").to_pylist()}
    episodes = _table(folder / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert len(episodes) == len(some) and sorted(tasks) == [0, 1]
    for k, (told, episode) in enumerate(zip(some, episodes)):
        mine = rows[episode["dataset_from_index"] : episode["dataset_to_index"]]
        assert episode["length"] == len(mine) == len(told.course.action)
        assert {row["episode_index"] for row in mine} == {k} and episode["tasks"] == [told.task]
        assert {tasks[row["task_index"]] for row in mine} == {told.task} and episode["apartgen_id"] == told.id
        assert episode["stats/action/max"] == pytest.approx(np.max(told.course.action, axis=0), abs=1e-6)


def test_statistics_are_those_of_all_rows(written):
    some, folder, _ = written
    stats = json.loads((folder / "meta/stats.json").read_text())["action"]
    told = np.concatenate([episode.course.action for episode in some])
    assert stats["mean"] == pytest.approx(told.mean(0), abs=1e-6) and stats["count"] == [len(told)]
    assert stats["std"] == pytest.approx(told.std(0), abs=1e-6) and stats["min"] == pytest.approx(told.min(0), abs=1e-6)
    assert stats["q50"] == pytest.approx(np.median(told, axis=0), abs=1e-6)


def test_pandas_takes_the_words_for_the_index_of_tasks(written):
    pandas = pytest.importorskip("pandas")
    tasks = pandas.read_parquet(written[1] / "meta/tasks.parquet")
    assert tasks.index.tolist() == ["go home", "open the door"] and tasks.iloc[1].name == "open the door"
    assert tasks.loc["open the door"].task_index == 1


def test_the_same_episodes_give_the_same_bytes(half, written, tmp_path):
    some, _, files = written
    again = lerobot.write(half, some, tmp_path / "again")
    assert [file.read_bytes() for file in files] == [file.read_bytes() for file in again]


def test_a_run_without_apartments_is_refused(tmp_path):
    with pytest.raises(BadInput, match="no apartments in .*run `apartgen bench embodied"):
        embodied.lerobot(tmp_path, tmp_path / "set")


def test_only_what_succeeds_is_kept(driven):
    apartment, outcome = driven
    failed = outcome.model_copy(update={"success": False})
    kept = _demonstrations._succeeded(apartment, [failed, outcome])
    assert [(one.task, one.id) for one in kept] == [("go to the bookshelf in the hallway", outcome.id)]


def test_figures_of_numbers_by_hand():
    found = lerobot._stats({"action": np.array([[1, 8], [2, 4], [6, 0]])})["action"]
    assert (found["min"], found["max"], found["mean"], found["count"]) == ([1, 0], [6, 8], [3, 4], [3])
    assert found["std"] == pytest.approx(np.sqrt([14 / 3, 32 / 3])) and found["q50"] == [2, 4]
