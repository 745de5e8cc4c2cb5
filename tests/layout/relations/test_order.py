"""The order in which a room is described, and what each object is described from."""

from pathlib import Path

import numpy as np
import pytest

from apartgen.stages.layout.datasets import _arrays, single_rooms
from apartgen.stages.layout.relations import corpus, describe, order
from apartgen.stages.layout.relations.tokens import OBJECT, WALL
from apartgen.stages.things.categories import CATEGORIES, TABLE


@pytest.fixture(scope="module")
def rooms(tmp_path_factory: pytest.TempPathFactory) -> list[corpus.Furnished]:
    path: Path = tmp_path_factory.mktemp("corpus") / "c.npz"
    _arrays.write_corpus(path, [(home, 1) for home in single_rooms.homes(None, seed=6, rooms=60)])
    return corpus.read(path)


def test_a_run_is_walked_from_its_right_end() -> None:
    names = ["hob", "kitchen_sink", "fridge", "dining_table", "kitchen_base"]
    y = [0.6, 0.0, -0.6, 0.0, 1.2]  # at a wall whose front looks along x: the left is up
    x = [0.3 + 2 * (name == "dining_table") for name in names]
    boxes = np.array([[at, along, 0, 0.6, 0.6, 0, 0.9] for at, along in zip(x, y, strict=True)])
    found = order.functional(np.array([CATEGORIES.index(n) for n in names]), boxes)
    assert [names[k] for k in found] == ["fridge", "kitchen_sink", "hob", "kitchen_base", "dining_table"]


def test_what_leads_comes_first() -> None:
    names = ["table_lamp", "nightstand", "rug", "double_bed", "mirror", "wardrobe"]
    boxes = np.array([[k, 0, 0, 0.5, 0.5, 0, 0.5] for k in range(len(names))], float)
    found = [names[k] for k in order.functional(np.array([CATEGORIES.index(n) for n in names]), boxes)]
    assert found.index("double_bed") < found.index("nightstand") < found.index("table_lamp")
    assert found[0] == "double_bed" and found.index("wardrobe") < found.index("mirror")


def test_every_object_has_a_reference_that_says_where_it_is(rooms: list[corpus.Furnished]) -> None:
    off = []
    for room in rooms:
        found, there = corpus.earlier(room, np.arange(room.n))
        assert there.all() and (found < room.shell + np.arange(room.n)).all()
        for i, k in enumerate(found):
            own, reference = room.boxes[room.shell + i], room.boxes[k]
            view = describe_from(own, reference, int(room.kind[k]))
            off.append(np.hypot(*(describe.placed(reference, view)[:2] - own[:2])))
    assert np.mean(np.array(off) < 0.0151) > 0.9


def describe_from(own: np.ndarray, reference: np.ndarray, kind: int) -> describe.Attributes:
    from apartgen.stages.layout.relations.tokens import seen

    said = describe.describe(seen(own[None], reference)[0], reference[3:5] / 2, np.array(kind))
    return said


def test_what_stands_on_something_is_described_from_it(rooms: list[corpus.Furnished]) -> None:
    seen, by = 0, list[bool]()
    for room in rooms:
        found, _ = corpus.earlier(room, np.arange(room.n))
        for i, k in enumerate(found):
            name = CATEGORIES[room.category[room.shell + i]]
            if TABLE[name].place == "top":
                seen += 1
                assert room.kind[k] == OBJECT
                assert room.boxes[room.shell + i, 5] == pytest.approx(float(room.boxes[k, 6]), abs=0.02)
            if name == "sofa":
                by.append(room.kind[k] >= WALL)
    assert seen > 10 and np.mean(by) > 0.9, "a sofa that stands free may be told from the room"


def test_given_objects_come_first_and_are_no_ones_later_reference(rooms: list[corpus.Furnished]) -> None:
    rng = np.random.default_rng(0)
    for room in rooms[:30]:
        place = rng.permutation(room.n)
        found, there = corpus.earlier(room, place)
        assert (found[there] < room.shell + np.flatnonzero(there)).all()
