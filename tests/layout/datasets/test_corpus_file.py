"""The corpus file: what is written is what training reads."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages.layout.corpus import read_corpus
from apartgen.stages.layout.datasets import _arrays, single_rooms
from apartgen.stages.things.categories import CATEGORIES


@pytest.fixture(scope="module")
def homes() -> list[Layout]:
    return list(single_rooms.homes(None, seed=3, rooms=8))


@pytest.mark.parametrize("rooms, alone", [(None, True), (single_rooms.MANY, True), (single_rooms.MANY + 1, False)])
def test_only_many_rooms_are_made_on_all_cores_and_without_a_number_they_have_no_end(
    rooms: int | None, alone: bool, homes: list[Layout], monkeypatch: pytest.MonkeyPatch
) -> None:
    @contextmanager
    def spread(processes: int) -> Iterator[Any]:
        assert (processes == 1) == alone
        yield map

    monkeypatch.setattr(single_rooms, "spreading", spread)
    monkeypatch.setattr("os.cpu_count", lambda: 4)
    assert list(islice(single_rooms.homes(seed=3, rooms=rooms), 3)) == homes[:3]


def test_training_reads_every_object_where_it_stands(homes: list[Layout], tmp_path: Path) -> None:
    n = _arrays.write_corpus(tmp_path / "c.npz", [(home, 1) for home in homes])
    corpus = read_corpus(tmp_path / "c.npz")
    assert len(corpus) == n >= 6
    kept = [home for home in homes if len(_arrays.rows(home, np.random.default_rng(0))["height"])]
    for k, home in enumerate(kept):
        corners = np.array(home.rooms[0].polygon)
        origin = (corners.min(0) + corners.max(0)) / 2
        seen = [(o.category, *np.round(np.array(o.center[:2]) - origin, 3), o.center[2]) for o in home.objects]
        want = sorted(seen)
        used = corpus.category[k] >= 0
        assert used.sum() == len(home.objects)
        got = sorted(zip([CATEGORIES[c] for c in corpus.category[k][used]], corpus.center[k][used], strict=True),
                     key=lambda row: (row[0], *np.round(row[1][:2].astype(float), 3)))
        assert [w[0] for w in want] == [g[0] for g in got]
        assert np.allclose([w[1:4] for w in want], [g[1] for g in got], atol=2e-3)
        assert ROOM_TYPES[corpus.rooms.type[k]] == home.rooms[0].type
        assert np.isclose(corpus.rooms.area[k], _area(corners), rtol=1e-4)


def _area(corners: np.ndarray) -> float:
    x, y = corners.T
    return float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2)


def test_arrays_have_the_agreed_shapes(homes: list[Layout], tmp_path: Path) -> None:
    n = _arrays.write_corpus(tmp_path / "c.npz", [(home, 2) for home in homes])
    with np.load(tmp_path / "c.npz", allow_pickle=False) as data:
        shapes = {name: data[name].shape for name in data}
        assert shapes == {
            "category": (n, 24), "center": (n, 24, 3), "size": (n, 24, 3), "yaw": (n, 24), "polygon": (n, 32, 2),
            "room_type": (n,), "height": (n,), "openings": (n, 20, 7), "style": (n,), "source": (n,), "sleepers": (n,),
            "duties": (n, 4),
            "categories": (len(CATEGORIES),),
        }
        assert (data["source"] == 2).all() and (data["style"] >= 0).all() and (data["style"] < 8).all()
        assert (np.abs(data["yaw"]) <= np.pi + 1e-6).all()


@pytest.mark.parametrize("change, said", [
    ({"category": np.zeros((3, 5), int)}, "category has the shape"),
    ({"yaw": None}, "yaw"),
    ({"category": np.full((1, 24), len(CATEGORIES))}, "category has an index outside"),
    ({"category": np.full((1, 24), -1)}, "no furnished room"),
    ({"room_type": np.full(1, len(ROOM_TYPES))}, "room_type has an index outside"),
    ({"center": np.full((1, 24, 3), np.nan)}, "center of an object is not finite"),
    ({"height": np.array(["high"])}, "height holds no numbers"),
    ({"categories": np.array(["throne"])}, "another furniture vocabulary"),
])
def test_what_training_cannot_work_with_is_named(homes: list[Layout], tmp_path: Path, change: Any, said: str) -> None:
    _arrays.write_corpus(tmp_path / "c.npz", [(home, 1) for home in homes])
    with np.load(tmp_path / "c.npz") as file:
        first = {name: file[name] if name == "categories" else file[name][:1] for name in file}
    np.savez(tmp_path / "c.npz", **{name: value for name, value in (first | change).items() if value is not None})
    with pytest.raises(BadInput, match=rf"c\.npz.*{said}"):
        read_corpus(tmp_path / "c.npz")
    np.savez(tmp_path / "c.npz", **{name: value for name, value in first.items() if name != "categories"})
    assert len(read_corpus(tmp_path / "c.npz")) == 1, "a file that does not name its categories is read"


def test_nothing_is_no_corpus(homes: list[Layout], tmp_path: Path) -> None:
    bare = homes[0].model_copy(update={"objects": []})
    with pytest.raises(BadInput, match="none of the 1 homes"):
        _arrays.write_corpus(tmp_path / "c.npz", [(bare, 1)])
    with pytest.raises(BadInput, match="cannot be written"):
        _arrays.write_corpus(tmp_path / "none" / "c.npz", [(home, 1) for home in homes])
    assert not list(tmp_path.iterdir())


def test_writing_twice_gives_the_same_arrays(homes: list[Layout], tmp_path: Path) -> None:
    for name in ("a", "b"):
        _arrays.write_corpus(tmp_path / f"{name}.npz", [(home, 0) for home in homes], seed=4)
    with np.load(tmp_path / "a.npz") as a, np.load(tmp_path / "b.npz") as b:
        np.testing.assert_equal(dict(a), dict(b))


def test_more_objects_than_slots_keep_what_matters(homes: list[Layout]) -> None:
    home = next(h for h in homes if len(h.objects) >= 8)
    many = [o.model_copy(update={"id": f"{o.id}_{k}"}) for k in range(6) for o in home.objects]
    crowded = home.model_copy(update={"objects": many})
    row = _arrays.rows(crowded, np.random.default_rng(0))
    assert (row["category"][0] >= 0).all()
    floor = [CATEGORIES.index(o.category) for o in many if o.center[2] - o.size[2] / 2 < 1e-3 and o.category != "rug"]
    assert np.isin(row["category"][0], floor).sum() >= min(24, len(floor))


def test_rooms_without_essentials_are_left_out(homes: list[Layout]) -> None:
    home = next(h for h in homes if h.rooms[0].type in ("bedroom", "kitchen", "living_room", "study", "dining_room"))
    bare = home.model_copy(update={"objects": [o for o in home.objects if o.category == "ceiling_lamp"]})
    assert len(_arrays.rows(bare, np.random.default_rng(0))["height"]) == 0
