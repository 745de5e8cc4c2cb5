"""Copies of a data set in places that fsspec knows."""

import json

import pytest

from apartgen.dataset.copies import Place
from apartgen.dataset.home import Done
from apartgen.dataset.store import Store, Writer
from apartgen.schemas.errors import BadInput, Unmet

HOME = {"prompt": "studio", "seed": 1, "seconds": {"all": 0.5}, "kind": "plan", "digests": {"plan": "x"},
        "certified": True, "metrics": {}, "rooms": {}, "objects": {}, "signature": "s", "sides": [2.0, 3.0],
        "area": 6.0}

fsspec = pytest.importorskip("fsspec")


def more(folder, homes=2):
    """A data set with some homes more, two in a shard."""
    folder.mkdir(exist_ok=True)
    store = Store(folder)
    store.describe({"apartgen_dataset": 1, "seed": 7, "count": homes})
    writer = Writer(store, 2)
    for i in range(writer.count, homes):
        writer.add(Done(b'{"home": %d}\n' % i, {"id": str(i)} | HOME))
    writer.close()
    return folder


def contents(url):
    system, root = fsspec.core.url_to_fs(url)
    return {name[len(root):].strip("/"): system.cat_file(name) for name in system.find(root)}


@pytest.fixture(params=["memory", "file"])
def url(request, tmp_path):
    return {"memory": f"memory://copies{tmp_path}/a", "file": f"file://{tmp_path}/copies/a"}[request.param]


def test_a_copy_has_every_byte_and_grows_with_its_data_set(tmp_path, url):
    for homes in (3, 3, 5):
        data = more(tmp_path / "data", homes)
        (data / ".hidden").write_text("of a run that is under way")
        Place(url).take(data)
        assert contents(url) == {file.relative_to(data).as_posix(): file.read_bytes() for file in data.rglob("*")
                                 if file.is_file() and file.name != ".hidden"}


def test_only_shards_that_grew_are_copied_again(tmp_path, url):
    Place(url).take(more(tmp_path / "data", 3))
    told = Place(url).take(more(tmp_path / "data", 5))
    assert [name for name in told if name.startswith("homes")] == ["homes/00001.jsonl.gz", "homes/00002.jsonl.gz"]


def test_a_manifest_tells_of_no_home_that_is_not_there(tmp_path, url):
    told = Place(url).take(more(tmp_path / "data", 5))
    assert told.index("manifest.jsonl") > max(i for i, name in enumerate(told) if name.startswith("homes"))


def test_another_data_set_is_left_alone(tmp_path, url):
    Place(url).take(more(tmp_path / "data"))
    before, other = contents(url), more(tmp_path / "other", 4)
    (other / "dataset.json").write_text(json.dumps({"apartgen_dataset": 1, "seed": 8, "count": 4}))
    with pytest.raises(BadInput, match="another data set"):
        Place(url).take(other)
    assert contents(url) == before


def test_a_place_that_takes_nothing_is_told_and_a_build_goes_on(tmp_path, caplog):
    (tmp_path / "full").write_text("a file")
    place = Place(f"file://{tmp_path}/full/data")
    with pytest.raises(Unmet, match="cannot be written"):
        place.take(more(tmp_path / "data"))
    place.try_taking(tmp_path / "data")
    assert "cannot be written" in caplog.text


def test_an_address_that_nothing_knows_is_bad_input():
    with pytest.raises(BadInput, match="nowhere"):
        Place("nowhere://data")
