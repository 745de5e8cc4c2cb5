"""Rooms that the layout model learns from after it has furnished them itself."""

from pathlib import Path

import pytest

import apartgen
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box
from apartgen.stages.layout.datasets import sampled


@pytest.fixture(scope="module")
def plans(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("plans")
    apartgen.plan("one-bedroom flat", seed=3).save(folder / "a.json")
    return folder


def place(o: Box) -> tuple[object, ...]:
    return o.id, o.category, o.center, o.size, o.yaw


def test_rooms_are_those_of_layout_or_empty(plans: Path) -> None:
    made = list(sampled.homes(plans, seed=5, times=2))
    assert len(made) == 2
    for seed, home in zip((5, 6), made, strict=True):
        told = apartgen.layout(apartgen.load(plans / "a.json"), seed=seed).body
        kept = {o.room for o in home.objects}
        assert len(kept) > len(home.rooms) / 2
        assert [place(o) for o in home.objects] == [place(o) for o in told.objects if o.room in kept]
    assert made[0].objects != made[1].objects


def test_a_room_that_came_out_badly_is_empty(plans: Path) -> None:
    home = next(sampled.homes(plans, seed=5))
    bed = next(o for o in home.objects if o.room == "bedroom_1" and o.category.endswith("bed"))
    inside = bed.model_copy(update={"id": "bedroom_1_desk_9", "category": "desk", "size": (0.6, 1.2, 0.7)})
    assert sampled._good(home).objects == home.objects
    worse = home.model_copy(update={"objects": [*home.objects, inside, inside.model_copy(update={"id": "b"})]})
    kept = sampled._good(worse).objects
    assert kept == [o for o in home.objects if o.room != "bedroom_1"]


def test_a_folder_without_plans_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="apartgen plan"):
        list(sampled.homes(tmp_path))
