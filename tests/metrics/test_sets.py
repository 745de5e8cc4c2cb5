"""Figures over sets of apartments: counts, frequencies, relations, tables."""

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.schemas.metrics import Metrics, Value
from apartgen.schemas.plan import AskedObjects
from apartgen.stages import metrics
from apartgen.stages.metrics import _distances, frequencies, quantity, relations
from apartgen.stages.things import categories

DOWN, UP = -np.pi / 2, np.pi / 2


def values(found, name, version="ours", of="apartment"):
    return next(v.value for v in found if (v.name, v.version, v.of) == (name, version, of))


def asked(home, **program):
    return home.model_copy(update={"program": home.program.model_copy(update=program)})


def test_q_ratio_counts_rooms_with_exactly_the_number():
    home = h.home(h.thing("sofa", 1, 1), h.thing("plant", 3, 2), h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM))
    found = quantity.measure(asked(home, counts={h.LIVING: 2, h.BEDROOM: 2}))
    assert values(found, "Q_ratio", "published") == 0.5
    assert values(found, "Q_ratio", "published", h.LIVING) == 1
    wishes = [AskedObjects(room=h.LIVING, category=name, count=1) for name in ("sofa", "tv")]
    assert values(quantity.measure(asked(home, objects=wishes)), "Q_ratio", "categories") == 0.5
    assert values(quantity.measure(home), "Q_ratio", "published") is None


def ckl(*sets):
    figure = frequencies.divergence(*sets, np.random.default_rng(0))
    return figure and figure.value


def test_ckl_by_hand():
    assert ckl([["sofa"], ["bed"]], [["bed", "sofa"], [], ["sofa", "bed"]]) == pytest.approx(0)
    by_hand = 0.5 * np.log(0.5 / 0.75) + 0.5 * np.log(0.5 / 0.25)
    assert ckl([["sofa"] * 3, ["tv"]], [["sofa", "tv"]]) == pytest.approx(by_hand, abs=1e-5)
    # A category that is never generated costs much, but not everything.
    assert ckl([["sofa"]], [["sofa", "tv"]]) == pytest.approx(
        0.5 * np.log(0.5) + 0.5 * (np.log(0.5) - np.log(1e-6)), abs=1e-4)
    assert ckl([[]], [["tv"]]) is None and ckl([], [["tv"]]) is None


def test_the_interval_of_ckl_covers_it_and_narrows_with_more_scenes():
    rng = np.random.default_rng(2)
    def wide(n):
        sets = [[["sofa"] if hit else ["tv"] for hit in rng.random(n) < share] for share in (0.5, 0.7)]
        figure = frequencies.divergence(*sets, np.random.default_rng(0))
        assert figure.low <= figure.value <= figure.high
        return figure.high - figure.low
    assert wide(400) < 0.6 * wide(40)


def spread_over(rooms):
    """Homes whose living rooms hold these categories."""
    return [h.home(*(h.thing(name, 0.5 + 0.1 * i, 1) for i, name in enumerate(names))) for names in rooms]


def test_frequencies_by_hand():
    homes, real = spread_over([["sofa", "plant", "plant"], []]), spread_over([["sofa"], ["sofa"], ["tv_stand"]])
    found = [v for v in frequencies.compare(homes, real) if (v.of, v.name[:3]) == ("living_room", "fre")]
    assert [(v.name, v.version, round(v.value, 3), v.n) for v in found] == [
        ("frequency/plant", "generated", 1.0, 2), ("frequency/plant", "real", 0.0, 3),
        ("frequency/sofa", "generated", 0.5, 2), ("frequency/sofa", "real", 0.667, 3),
        ("frequency/tv_stand", "generated", 0.0, 2), ("frequency/tv_stand", "real", 0.333, 3)]
    assert (found[0].low, found[0].high) == (0.0, 2.0) and (found[1].low, found[1].high) == (0.0, 0.0)
    # All categories of a type together are the objects of its rooms.
    (whole,) = [v.value for v in relations.compare(homes, real)
                if (v.name, v.of, v.version) == ("objects_a_room", "living_room", "generated")]
    assert whole == sum(v.value for v in found if v.version == "generated")


def test_a_table_shows_the_ten_most_frequent_of_either_set():
    names = sorted(categories.TABLE)[:13]
    common, rare = names[:9], names[9:]
    homes, real = spread_over([common, common]), spread_over([common, [*common, rare[3]], rare])
    found = metrics.compare(homes, real, ["frequencies"])
    shown = [line.split(" | ")[0][2:] for line in metrics.side_by_side(found).splitlines() if "/" in line]
    assert {name.partition("/")[2] for name in shown} == {*common, rare[3]}
    assert len({v.name for v in found.values if v.name.startswith("frequency/")}) == 13


def test_relations_are_resampled_by_rooms():
    # In one room all four chairs are at the table, in the other none: by rooms anything from 0 to 1 may come.
    table = h.thing("dining_table", 2, 1.5, 0, size=(0.8, 2.4, 0.75))
    at = [h.thing("chair", 1.3, 1.2 + 0.2 * i, 0, size=(0.5, 0.5, 0.9)) for i in range(4)]
    away = [h.thing("chair", 1.3, 1.2 + 0.2 * i, np.pi, size=(0.5, 0.5, 0.9)) for i in range(4)]
    both = [h.home(table, *at), h.home(table, *away)]
    (found,) = [v for v in relations.compare(both, both) if (v.name, v.of, v.version) == (
        "seat_at_table", "living_room", "generated")]
    assert (found.value, found.n, found.low, found.high) == (0.5, 8, 0.0, 1.0)


def test_relations_by_hand():
    bed = h.thing("double_bed", 5.6, 1.95, DOWN, h.BEDROOM, size=(2.0, 1.6, 1.0))
    at, away = h.thing("nightstand", 6.7, 2.75, DOWN, h.BEDROOM), h.thing("nightstand", 4.4, 0.3, 0.5, h.BEDROOM)
    table, chair = h.thing("dining_table", 2, 2, 0, size=(1, 1, 0.75)), h.thing("chair", 1.2, 2, 0)
    turned = h.thing("chair", 2.8, 2, 0)
    found = relations.measure(h.home(bed, at, away, table, chair, turned))
    assert values(found, "nightstand_at_bed") == 0.5
    assert values(found, "seat_at_table") == 0.5
    assert values(found, "tv_faces_sofa") is None
    assert values(found, "back_to_wall") == pytest.approx(2 / 3)
    assert values(found, "yaw_aligned") == pytest.approx(5 / 6)
    assert values(found, "objects_a_room") == 3


def test_a_tv_faces_its_sofa():
    sofa = h.thing("sofa", 0.5, 1.5, 0)
    facing, away = h.thing("tv_stand", 3.7, 1.5, np.pi), h.thing("tv_stand", 3.7, 1.5, 0)
    assert values(relations.measure(h.home(sofa, facing)), "tv_faces_sofa") == 1
    assert values(relations.measure(h.home(sofa, away)), "tv_faces_sofa") == 0


def test_sets_are_compared_by_room_type():
    homes, real = [h.home(h.thing("sofa", 1, 1))], [h.home(h.thing("sofa", 1, 1), h.thing("tv_stand", 3, 2))]
    found = metrics.compare(homes, real).values
    assert values(found, "CKL", "published") > 1 and values(found, "CKL", "published", "bedroom") is None
    assert values(found, "objects_a_room", "real", "living_room") == 2
    assert values(metrics.compare(real, real).values, "CKL", "published") == pytest.approx(0)
    with pytest.raises(BadInput, match="does not compare"):
        metrics.compare(homes, real, ["graph"])
    with pytest.raises(BadInput, match="at least one"):
        metrics.compare([], real)
    with pytest.raises(BadInput, match="compares a set"):
        metrics.run(homes[0], ["frequencies"])


def one(name, value, n=None):
    return Metrics(values=[Value(name=name, value=value, n=n), Value(name=name, value=9, of="bedroom_1")])


def test_a_table_of_means_and_pooled_shares():
    rng = np.random.default_rng(0)
    (row,) = metrics.table([one("R_acoll", 0.0, 1), one("R_acoll", 1.0, 3), one("R_acoll", None)], rng)
    assert (row.value, row.n) == (0.5, 2) and row.low == 0 and row.high == 1
    (row,) = metrics.table([one("Col_obj", 0.0, 1), one("Col_obj", 1.0, 3)], rng)
    assert row.value == 0.75
    (row,) = metrics.table([one("R_acoll", 0.25)] * 5, rng)
    assert row.low == row.value == row.high == 0.25


def test_a_table_for_people_says_how_it_was_made():
    rows = metrics.table([one("R_acoll", 0.25)] * 5, np.random.default_rng(3))
    text = metrics.markdown(rows, seed=3)
    assert "| R_acoll | ours | apartment | 0.250 | 0.250 - 0.250 | 5 |" in text and text.endswith("seed 3\n")


def test_a_single_apartment_has_no_interval():
    text = metrics.markdown(metrics.table([one("R_acoll", 0.25)], np.random.default_rng(3)), seed=3)
    assert "| R_acoll | ours | apartment | 0.250 | - | 1 |" in text


def test_intervals_cover_the_mean_as_often_as_they_say():
    rng = np.random.default_rng(1)
    hits = 0
    for _ in range(200):
        drawn = [one("R_acoll", float(v)) for v in rng.normal(0.5, 0.1, 40)]
        (row,) = metrics.table(drawn, rng)
        hits += row.low <= 0.5 <= row.high
    assert 0.88 < hits / 200 <= 0.99


def test_a_comparison_for_people_has_both_sets_in_a_row():
    homes, real = [h.home(h.thing("sofa", 1, 1))], [h.home(h.thing("sofa", 1, 1), h.thing("tv_stand", 3, 2))]
    lines = metrics.side_by_side(metrics.compare(homes, real, ["frequencies", "relations"])).splitlines()
    assert lines[0] == "| figure | of | generated | real | published |"
    assert "| objects_a_room | living_room | 1.000 (1) | 2.000 (1) |  |" in lines
    assert "| frequency/tv_stand | living_room | 0.000 (1) | 1.000 (1) |  |" in lines
    assert "| CKL | bedroom | - | - | - |" in lines
    assert {line.count("|") for line in lines if line.startswith("|")} == {6} and "n of what" in lines[-1]


def test_small_figures_and_intervals_in_a_table():
    found = Metrics(values=[Value(name="KID", value=0.0004, version="generated", low=-0.0001, high=0.02, n=9)],
                    notes=["by the network"])
    assert "| KID | apartment | 0.00040 [-0.00010, 0.020] (9) |" in metrics.side_by_side(found)
    assert metrics.side_by_side(found).endswith("\n\nby the network\n")


@pytest.mark.parametrize(("low", "high"), [(None, None), (0.1, None), (None, 0.3)])
def test_half_an_interval_is_none(low, high):
    found = Metrics(values=[Value(name="KID", value=0.2, version="generated", low=low, high=high)])
    assert "| KID | apartment | 0.200 |" in metrics.side_by_side(found)


def test_a_classifier_that_sees_no_difference_is_right_every_other_time():
    """Scenes that are all the same; and of sets far apart all are told."""
    same, other = np.ones((20, 3)), np.ones((12, 3))
    found = _distances.separability(same, other, np.random.default_rng(0))
    assert tuple(found) == pytest.approx((50, 50, 50))
    noise = np.random.default_rng(1).normal(0, 0.1, (12, 3))
    assert _distances.separability(same, other + 5 + noise, np.random.default_rng(0))[0] == 100


def test_rooms_of_types_that_the_real_set_lacks_do_not_count():
    sofa, bed = h.thing("sofa", 1, 1), h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM)
    only = h.home(sofa).model_copy(update={"rooms": h.plan().rooms[:1]})
    assert values(frequencies.compare([h.home(sofa, bed)], [only]), "CKL", "published") == pytest.approx(0)
    assert values(relations.compare([h.home(sofa, bed)], [only]), "objects_a_room", "generated") == 1


def test_the_real_rooms_stand_beside_the_generated_ones():
    real = [h.home(h.thing("sofa", 1, 1)), h.home(h.thing("tv_stand", 3, 2))] * 10
    found = frequencies.compare([h.home(h.thing("plant", 1, 1))] * 30, real)
    generated, floor = (values(found, "CKL", version) for version in ("generated", "real"))
    assert generated > 5 > 0.5 > floor >= 0
    assert [v.n for v in found if (v.name, v.of) == ("CKL", "apartment")] == [30, 10, 10]
