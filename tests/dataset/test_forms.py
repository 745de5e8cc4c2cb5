"""Data sets in the forms that others read: tables, tars, their own loaders."""

import json
import tarfile

import commandline
import pytest

from apartgen.dataset import finish, table, tars
from apartgen.dataset.build import again, build
from apartgen.dataset.source import Listed
from apartgen.dataset.store import HOMES, Store
from apartgen.schemas.errors import BadInput

PROMPTS = (b'a 20 m2 flat with four bedrooms of 15 m2 each\nstudio\n{"id": "a.b", "prompt": "studio", "seed": 5}\n'
           b'studio\n')
QUICK = {"layout": {"candidates": 1}, "plan": {"candidates": 1, "enough": 1}}


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    """Three homes and, first, a failure; without small things."""
    folder = tmp_path_factory.mktemp("forms") / "data"
    return build(Listed(PROMPTS, "list"), folder, given=QUICK, workers=1, per_shard=3, populate=False)


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args: commandline.run(capsys, monkeypatch, "dataset", *args)


def test_homes_without_small_things_are_their_own_data_set(data):
    rows = [row for row in data.rows() if "shard" in row]
    assert [row["kind"] for row in rows] == ["walkable"] * 3 and data.about()["stages"][-1] == "walkable"
    assert again(rows[1], data.about()).line == data.line(rows[1])
    with pytest.raises(BadInput, match="another stages"):
        build(Listed(PROMPTS, "list"), data.folder, given=QUICK, workers=1, per_shard=3)


def test_tars_hold_every_home_and_come_out_the_same(cli, data, tmp_path):
    options = "--format", "webdataset", "--format", "svg", "--shard", 1, "--workers", 1
    for name in ("one", "two"):
        done = cli("export", data.folder, "-o", tmp_path / name, *options)
        assert done.code == 0, done.err
    found = {file.name: file.read_bytes() for file in (tmp_path / "one").iterdir()}
    assert found == {file.name: file.read_bytes() for file in (tmp_path / "two").iterdir()} and len(found) == 3
    rows = {f"{i:07d}": row for i, row in enumerate(data.rows()) if "shard" in row}
    seen = {}
    for name in found:
        with tarfile.open(tmp_path / "one" / name) as tar:
            members = {member.name: tar.extractfile(member).read() for member in tar}
        [key] = {member.partition(".")[0] for member in members}
        assert name.startswith(f"{rows[key]['split']}-") and members[f"{key}.home.json"] == data.line(rows[key])
        assert json.loads(members[f"{key}.row.json"]) == rows[key] and members[f"{key}.plan.svg"].startswith(b"<?xml")
        seen[key] = members
    assert seen.keys() == rows.keys()


def test_a_format_of_many_files_has_no_place_in_a_tar(cli, data, tmp_path):
    done = cli("export", data.folder, "-o", tmp_path, "--format", "webdataset", "--format", "mjcf", "--id", "a.b",
               "--workers", 1)
    assert done.code == 1 and "many files a home" in done.err and not list(tmp_path.iterdir())


def test_the_table_has_every_figure_of_every_row(data):
    parquet = pytest.importorskip("pyarrow.parquet")
    table.write(data)
    read = parquet.read_table(data.folder / table.NAME).to_pylist()
    for row, told in zip(data.rows(), read, strict=True):
        flat = table.flat(row)
        assert {name: told[name] for name in flat} == flat
        assert all(value is None for name, value in told.items() if name not in flat)
    assert read[0]["error"] and read[1]["metrics.R_out"] == 0.0 and read[0]["metrics.R_out"] is None


def test_rows_that_disagree_are_words(data, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    store = Store(tmp_path)
    rows = list(data.rows())
    rows[1]["note"], rows[2]["note"], rows[1]["rank"], rows[2]["rank"] = 3, "three", 1, 0.5
    store.rewrite(rows)
    table.write(store)
    read = parquet.read_table(tmp_path / table.NAME).to_pylist()
    assert [row["note"] for row in read] == [None, "3", "three", None]
    assert [row["rank"] for row in read] == [None, 1.0, 0.5, None]


def test_datasets_reads_what_the_card_says(data, tmp_path):
    datasets = pytest.importorskip("datasets.load")  # a folder of tests bears the name, too
    finish.finish(data)
    options = {"split": "train", "cache_dir": str(tmp_path)}
    rows = datasets.load_dataset(str(data.folder), "manifest", **options)
    assert rows["id"] == [row["id"] for row in data.rows()] and rows["metrics.R_out"][1] == 0.0
    lines = datasets.load_dataset("text", data_files=str(data.folder / HOMES / "*.jsonl.gz"), **options)
    assert [json.loads(line) for line in lines["text"]] == [
        json.loads(data.line(row)) for row in data.rows() if "shard" in row]


def test_webdataset_reads_the_tars(data, tmp_path):
    webdataset = pytest.importorskip("webdataset")
    made = [row for row in data.rows() if "shard" in row]
    assert [error for _, error in tars.export(data, made, tmp_path, None, 2, 1)] == [""] * 3
    read = {}
    for file in sorted(tmp_path.iterdir()):
        for sample in webdataset.WebDataset(str(file), shardshuffle=False).decode():
            read[sample["row.json"]["id"]] = sample["home.json"]
    assert read == {row["id"]: json.loads(data.line(row)) for row in made}
