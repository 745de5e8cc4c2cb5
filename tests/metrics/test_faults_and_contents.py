"""Faults and contents as figures of a home: of every room, named, and summed up over its furnished rooms."""

import tracemalloc

import handmade
import numpy as np
import pytest

from apartgen.schemas.metrics import Value
from apartgen.stages import metrics, use
from apartgen.stages.metrics import _shares

HOME = handmade.home(
    handmade.thing("sofa", 2, 2.52, -np.pi / 2, id="sofa"),
    handmade.thing("tv_stand", 0.9, 2.7, -np.pi / 2, id="stand"),
    handmade.thing("double_bed", 6.04, 1.5, np.pi, handmade.BEDROOM, id="bed"),
)


def figures(*objects: object) -> dict[tuple[str, str, str], Value]:
    found = metrics.run(handmade.home(*objects), ["faults", "contents"]).values  # type: ignore[arg-type]
    return {(v.name, v.version, v.of): v for v in found}


def test_rooms_have_their_faults_by_number_and_by_name() -> None:
    found = figures(*HOME.objects)
    names = {name for name, _, of in found if name.startswith("fault/") and of == handmade.LIVING}
    assert names == {"fault/sofa not facing the television", "fault/television that nobody watches",
                     "fault/things stand in one another"}
    assert found["faults", "use", handmade.LIVING].value == 2
    assert found["faults", "bodies", handmade.LIVING].value == 1
    assert found["faults", "use", handmade.BEDROOM].value == 0
    assert found["faults", "use", "apartment"].value == pytest.approx(1)


def test_what_rooms_lack_is_counted_and_weighed() -> None:
    found = figures(*HOME.objects)
    assert found["lack/double bed without nightstand", "ours", handmade.BEDROOM].value == 2
    lacks = list(use.lacks(use.of_plan(HOME, handmade.BEDROOM, HOME.objects)))
    assert found["lacks", "cost", handmade.BEDROOM].value == pytest.approx(sum(lack.cost for lack in lacks))
    assert found["lacks", "number", handmade.BEDROOM].value == len(lacks)
    both = [found["lacks", "cost", room].value for room in (handmade.LIVING, handmade.BEDROOM)]
    assert found["lacks", "cost", "apartment"].value == pytest.approx(np.mean(both))  # type: ignore[arg-type]


def test_an_empty_home_has_no_faults_and_lacks_everything() -> None:
    found = figures()
    assert all(found["faults", version, "apartment"].value is None for version in ("use", "bodies", "neighbours"))
    assert found["lacks", "cost", "apartment"].value > figures(*HOME.objects)["lacks", "cost", "apartment"].value


def test_sets_are_compared_by_rooms_that_have_a_fault_and_by_those_that_have_none() -> None:
    good = handmade.home(handmade.thing("sofa", 2, 0.47, np.pi / 2), handmade.thing("tv_stand", 2, 2.77, -np.pi / 2))
    sets = [handmade.home(*HOME.objects[:2]), *[good] * 3], [good]
    found = {(v.name, v.version, v.of): v for v in metrics.compare(*sets, ["faults", "contents"]).values}
    assert found["fault/sofa not facing the television/ours", "generated", handmade.LIVING[:-2]].value == 0.25
    assert found["fault/sofa not facing the television/ours", "real", handmade.LIVING[:-2]].value == 0
    assert found["faults/use", "generated", "apartment"].value == 0.5
    assert found["lack/no coffee table/ours", "generated", "apartment"].value == 1
    text = metrics.side_by_side(metrics.compare(*sets, ["contents"]))
    assert len([line for line in text.splitlines() if "lack/" in line and "| apartment |" in line]) <= 10


def test_of_a_room_that_is_too_crowded_nothing_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = figures(*HOME.objects)
    monkeypatch.setattr(_shares, "CROWD", 1)
    found = figures(*HOME.objects)
    assert {of for name, _, of in found if name in ("faults", "lacks")} == {"apartment", *(
        room.id for room in HOME.rooms if room.id != handmade.LIVING)} & {of for _, _, of in whole}
    assert all(found[key].value is None for key in found if key[2] == "apartment")
    assert all(found[key] == whole[key] for key in found if key[2] != "apartment")


def test_many_things_take_memory_by_their_number_not_by_its_square() -> None:
    rng = np.random.default_rng(0)
    home = handmade.home(*(handmade.thing("chair", *rng.uniform(0, 4, 2), id=f"chair_{i}") for i in range(4000)))
    tracemalloc.start()
    try:
        [value, *_] = metrics.run(home, ["collision"]).values
        assert value.value == 1 and tracemalloc.get_traced_memory()[1] < 4000**2 * 8 * 2, "two matrices of all pairs"
    finally:
        tracemalloc.stop()
