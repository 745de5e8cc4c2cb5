"""bench realism: what its rows are of, how runs are told apart, and that replaced rooms are what the stage makes."""

import json
from pathlib import Path
from typing import Any

import commandline
import handmade
import numpy as np
import pytest
from matplotlib.figure import Figure
from safetensors.numpy import save_file
from shapely.geometry import Point, Polygon

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.stages import layout
from apartgen.stages.layout.config import LayoutConfig
from apartgen_cli.bench import _compared, _lived_in, _replaced, _runner, _scenes, realism

PLAIN = LayoutConfig(model="diffusion", threads=1, projection=False, guidance_repeats=4)


@pytest.fixture(scope="module")
def sampled() -> Layout:
    return layout.run(handmade.plan(), PLAIN, np.random.default_rng(3))


def test_replaced_rooms_are_what_the_layout_stage_makes_of_its_samples(sampled: Layout) -> None:
    whole = layout.run(handmade.plan(), LayoutConfig(model="diffusion", threads=1), np.random.default_rng(3))
    done, moves = _replaced.projected(sampled)
    assert [(o.id, o.category) for o in done.objects] == [(o.id, o.category) for o in whole.objects]
    for mine, theirs in zip(done.objects, whole.objects, strict=True):
        assert np.allclose(mine.center, theirs.center, atol=1e-3) and np.allclose(mine.size, theirs.size, atol=1e-3)
    assert {room: len(found) for room, found in moves.items()} == {
        room.id: sum(o.room == room.id for o in done.objects) for room in done.rooms}


def test_random_places_are_on_the_rooms_own_floor_and_nothing_else_changes(sampled: Layout) -> None:
    from apartgen.stages.layout.projection.standing import Item

    for room in sampled.rooms:
        items = [Item(o.category, np.array(o.center), np.array(o.size), o.yaw) for o in sampled.objects]
        placed = _replaced.anywhere(np.random.default_rng(1))(room, items)
        for before, after in zip(items, placed, strict=True):
            assert Polygon(room.polygon).contains(Point(after.center[:2]))
            assert after.category == before.category and after.center[2] == before.center[2]
            assert (after.size == before.size).all()
    again = _replaced.anywhere(np.random.default_rng(1))(sampled.rooms[-1], items)
    assert len({tuple(item.center) for item in again}) == len(items)


def test_the_best_of_every_room_is_taken_from_its_own_candidate() -> None:
    bed = handmade.thing("double_bed", 6.04, 1.5, np.pi, handmade.BEDROOM)
    sofa = handmade.thing("sofa", 2, 0.47, np.pi / 2)
    one, two, none = handmade.home(bed), handmade.home(sofa), handmade.home()
    best = _replaced.chosen([none, one, two])
    assert [o.id for o in best.objects] == [sofa.id, bed.id]


def weights(path: Path, **header: str) -> str:
    save_file({"x": np.zeros(1, np.float32)}, path, header)
    return str(path)


def test_weights_make_rows_of_their_own_model(tmp_path: Path) -> None:
    one, two = weights(tmp_path / "a.safetensors", rank="[]"), weights(tmp_path / "b.safetensors", config="{}")
    assert (realism.model_of(one), realism.model_of(two)) == ("relations", "diffusion")
    names = realism.settings([one, two])
    assert "relations, raw · a" in names and "relations, raw" not in names and "diffusion, raw · b" in names
    assert not any("· b" in name for name in names if name.startswith("relations"))
    assert realism.used("relations, raw · a", [one, two], "ssr=x") == {"weights": [one], "real": "ssr=x"}
    assert realism.used("corpus", [one, two]) == {} and set(realism.settings()) == set(realism.SETTINGS)
    with pytest.raises(BadInput, match="rename one"):
        (tmp_path / "c").mkdir()
        realism.settings([one, weights(tmp_path / "c" / "a.safetensors", rank="[]")])


def record(setting: str, kind: str, **more: Any) -> dict[str, Any]:
    return {"setting": setting, "of": kind, "habits": {"desk has its chair": [1.0, 0.0]}, "energy": 1.0, "objects": 5,
            "faults": {"use": 2, "bodies": 0, "neighbours": 1}, "lacks": {"number": 1, "cost": 0.5}, "moves": [],
            **more}


def test_rows_are_figures_and_columns_settings() -> None:
    some = [record("relations, raw", "bedroom", moves=[0.1, 0.7]) for _ in range(30)]
    other = [record("corpus", "bedroom", faults={"use": 0, "bodies": 0, "neighbours": 0}) for _ in range(30)]
    rows = {row["figure"]: row for row in realism.rows([*some, *other], np.random.default_rng(0))}
    assert rows["faults, use"]["relations, raw"] == [2, 2, 2] and rows["faults, use"]["corpus"] == [0, 0, 0]
    assert rows["moved over .5 m"]["relations, raw"] == [0.5, 0.5, 0.5] and "corpus" not in rows["moved over .5 m"]
    assert rows["desk has its chair"]["corpus"][0] == 0.5 and rows["rooms"]["corpus"] == 30
    axes = Figure().subplots()
    realism.draw(list(rows.values()), axes)
    assert {round(bar.get_height(), 6) for bar in axes.patches} == {0, 2}
    text = _runner._markdown(realism, {"experiment": "realism"}, list(rows.values()))  # type: ignore[arg-type]
    assert "| bedroom | faults, use | 0 [0, 0] | 2 [2, 2] |" in text and "## Diffusion model" in text


def test_training_runs_are_pooled() -> None:
    runs = [record(f"relations, raw · {name}", "bedroom", faults={"use": n, "bodies": 0, "neighbours": 0})
            for name, n in (("a", 1), ("b", 3)) for _ in range(20)]
    row = next(row for row in realism.rows(runs, np.random.default_rng(0)) if row["figure"] == "faults, use")
    assert row["relations, raw"] == [2, pytest.approx(2**0.5, abs=1e-5)] and row["relations, raw · b"] == [3, 3, 3]


def test_medians_and_means_have_intervals_over_rooms() -> None:
    rng = np.random.default_rng(0)
    rooms = [[1.0, 2.0], [4.0], [9.0, 9.0]]
    assert _lived_in.summed("double bed's width, m", rooms, rng)[0] == 4
    middle, low, high = _lived_in.summed("sofas a room", rooms, rng)
    assert middle == 5 and 1.5 <= low < middle < high <= 9


def test_looks_are_compared_with_the_corpus_and_real_rooms_of_the_same_type() -> None:
    def look(shift: float, category: str) -> dict[str, Any]:
        features = np.random.default_rng(int(shift * 10)).normal(shift, 1, (40, 5)).astype(np.float32)
        return [{"network": "test", "suffix": "_t", "categories": [category], "features": _compared._packed(row)}
                for row in features]  # type: ignore[return-value]

    def some(setting: str, whole: float, common: float) -> list[dict[str, Any]]:
        return [record(setting, "bedroom", whole=w, common=c)
                for w, c in zip(look(whole, "sofa"), look(common, "tv"), strict=True)]

    records = [*some("corpus", 0.0, 0.0), *some("real", 3.0, 3.0), *some("relations, raw", 0.0, 3.0),
               *some("real, other half", 3.0, 3.0)]
    rows = {row["figure"]: row for row in realism.rows(records, np.random.default_rng(0))}
    near, far = rows["SCA_t against corpus"], rows["SCA_t against real rooms"]
    assert 30 < near["relations, raw"][0] < 70 < 90 < far["corpus"][0] and 30 < far["relations, raw"][0] < 70
    assert "real" not in near and "real" not in far and "real, other half" in far and "corpus" not in near


def test_real_rooms_may_be_named_by_path_and_source(tmp_path, capsys, monkeypatch) -> None:  # type: ignore
    given: list[Any] = []
    monkeypatch.setattr(_runner, "run", lambda *args: given.append(args[-1]) or [])
    (tmp_path / "rooms.jsonl").touch()
    asked = ("bench", "realism", "--real", tmp_path / "rooms.jsonl", "--as", "ssr", "-o", tmp_path / "out")
    assert commandline.run(capsys, monkeypatch, *asked).code == 0
    assert given == [{"real": f"ssr={tmp_path / 'rooms.jsonl'}"}]


def test_a_trial_tells_of_every_furnished_room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = handmade.home(handmade.thing("sofa", 2, 0.47, np.pi / 2), handmade.thing("rug", 2, 1.5),
                         handmade.thing("double_bed", 6.04, 1.5, np.pi, handmade.BEDROOM))
    monkeypatch.setattr(_scenes, "plans", lambda seed, n, work: [handmade.plan()] * n)
    kitchen = handmade.plan().rooms[0].model_copy(update={"type": "kitchen"})
    units = [handmade.thing("kitchen_sink", 2, 2.7, -np.pi / 2), handmade.thing("hob", 1.3, 2.7, -np.pi / 2)]
    monkeypatch.setattr(_compared, "furnished", lambda plans, seed, lane: [home for _ in plans])
    monkeypatch.setattr(_compared, "seen", lambda rooms, _=None: [{"categories": [o.category for o in things]}
                                                                 for _, things in rooms])
    monkeypatch.setattr(_compared, "kinds", lambda real: frozenset({"sofa", "double_bed"}))
    cooking = handmade.home(*units).model_copy(update={"rooms": [kitchen]})
    (only,) = _lived_in.records(cooking, "ssr=x", {})
    assert only["habits"]["things on the floor"] == [2] and only["habits"]["kitchen in one run"] == [1]
    found = realism.trial("corpus", 5, 2, tmp_path, real="ssr=x")
    assert [r["of"] for r in found] == ["living_room", "bedroom"] * 2
    assert found[0]["whole"]["categories"] == ["sofa", "rug"] and found[0]["common"]["categories"] == ["sofa"]
    assert found[1]["faults"]["use"] == 0 and found[1]["lacks"]["number"] > 0
    assert json.loads(json.dumps(found)) == found


def test_kinds_that_descriptions_do_not_tell_apart_are_one_and_rare_ones_none(monkeypatch: pytest.MonkeyPatch) -> None:
    assert len({_compared.coarse(name) for name in ("sideboard", "bookshelf", "display_cabinet")}) == 1
    assert _compared.coarse("sofa") == _compared.coarse("corner_sofa") == "sofa" and _compared.coarse("tv") == "tv"
    often = [handmade.home(handmade.thing("corner_sofa", 2, 1), handmade.thing("sideboard", 1, 2)) for _ in range(99)]
    rooms = [*often, handmade.home(handmade.thing("rug", 2, 1))]
    monkeypatch.setattr(_compared, "_read", lambda name, folder: rooms)
    _compared.kinds.cache_clear()
    found = _compared.kinds("ssr=once")
    _compared.kinds.cache_clear()
    assert found == {_compared.coarse("sofa"), _compared.coarse("sideboard")}, "one rug in a hundred rooms is no kind"


def test_bare_floors_are_seen_without_their_things(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[list[str]] = []

    def seen(rooms: Any, _: Any = None) -> list[dict[str, Any]]:
        shown.append([o.category for _, things in rooms for o in things])
        return [{"categories": []} for _ in rooms]

    monkeypatch.setattr(_compared, "seen", seen)
    monkeypatch.setattr(_compared, "kinds", lambda real: frozenset({"sofa"}))
    (room,) = _lived_in.records(handmade.home(handmade.thing("corner_sofa", 2, 1), handmade.thing("rug", 2, 2)),
                                "ssr=x", {})
    assert shown == [["corner_sofa", "rug"], ["sofa"], []] and {"whole", "common", "bare"} <= set(room)
