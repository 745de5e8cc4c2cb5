"""The vocabulary: what its facts keep among themselves, and how entries that are like others are read."""

from dataclasses import replace

import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.things import categories
from apartgen.stages.things.categories import CATEGORIES, TABLE, read, stand_in, used_for
from apartgen.stages.things.claims import amiss


def test_facts_agree():
    for name, kind in TABLE.items():
        assert np.all(np.array(kind.min) <= kind.size) and np.all(np.array(kind.size) <= kind.max), name
        assert kind.rooms and kind.lineage[0] == name and stand_in(name) in CATEGORIES
        assert kind.place != "top" or kind.belongs, f"{name} stands on nothing"
        assert not (kind.hangs and kind.place != "top") and not (kind.kneehole and kind.place != "floor")
        assert (kind.lumens > 0) == kind.is_for("light"), name
        assert (kind.flap > 0) == (kind.opens == "flap"), name
        for other in {*kind.instead, kind.serves} - {name}:
            assert TABLE[other].place == kind.place, (name, other)
            assert other == kind.like or not set(TABLE[other].uses).isdisjoint(kind.uses), (name, other)


@pytest.mark.parametrize(("wrong", "meant"), [("sofaa", "sofa"), ("bok_shelf", "bookshelf"), ("wardrobes", "wardrobe")])
def test_a_misspelled_category_is_told_with_the_one_that_was_meant(wrong, meant):
    assert f"did you mean {meant!r}?" in categories.unknown(wrong)
    assert "did you mean" not in categories.unknown("xyzzy")


def test_nobody_stands_in_for_himself():
    assert not [name for name, kind in TABLE.items() if name in kind.instead]
    assert all(TABLE[TABLE[name].serves].serves == TABLE[name].serves for name in TABLE)


def test_one_word_means_one_thing():
    words = [word for kind in TABLE.values() for word in kind.synonyms]
    assert len(words) == len(set(words))
    assert categories.by_word()["couch"] == "sofa" and categories.by_word()["tv stand"] == "tv_stand"


def test_uses_hold_what_people_would_say():
    """Of those that ship; what is like one of them is used for the same."""
    for uses, said in ((("sleep",), {"double_bed", "single_bed", "bunk_bed", "cot"}), (("bathe",), {"bath", "shower"}),
                       (("dine",), {"dining_table", "round_table"}), (("rinse", "cool"), {"kitchen_sink", "fridge"})):
        assert said <= used_for(*uses) and {TABLE[name].lineage[-1] for name in used_for(*uses)} == said


@pytest.mark.parametrize(("use", "said"), [
    ("sleeping", "^no use 'sleeping'; did you mean 'sleep'"), ("zzz", "^no use 'zzz'; there are: .*sleep")])
def test_a_use_that_there_is_not_is_an_error(use, said):
    """Else what is written with it is silently about nothing."""
    with pytest.raises(ValueError, match=said):
        used_for("cook", use)


def test_a_use_that_an_entry_brings_is_one(monkeypatch):
    bench = replace(TABLE["desk"], name="bench_of_tests", uses=("tinker",))
    monkeypatch.setattr(categories, "TABLE", TABLE | {bench.name: bench})
    assert used_for("tinker") == {"bench_of_tests"}
    used_for.cache_clear()


DESK = {"standing_desk": {"like": "desk", "size": [0.7, 1.5, 1.0], "min": [0.6, 1.0, 0.9], "max": [0.9, 2.0, 1.2],
                          "synonyms": ["standing desk", "desk"]}}


@pytest.fixture
def newcomers(monkeypatch):
    """Two newcomers in the vocabulary, one like the other."""
    rows = DESK | {"crank_desk": {"like": "standing_desk", "opens": ""}}
    monkeypatch.setattr(categories, "TABLE", TABLE | read(rows, TABLE))
    cached = (categories.groups, categories.by_word, categories.used_for, categories.carriers)
    for function in cached:
        function.cache_clear()
    yield categories.TABLE
    monkeypatch.undo()
    for function in cached:
        function.cache_clear()


def test_what_is_like_another_has_its_facts_but_for_its_own(newcomers):
    crank, desk = newcomers["crank_desk"], TABLE["desk"]
    assert crank.lineage == ("crank_desk", "standing_desk", "desk") and crank.size == (0.7, 1.5, 1.0)
    assert (crank.uses, crank.rooms, crank.family, crank.matters) == (desk.uses, desk.rooms, desk.family, desk.matters)
    assert crank.opens == "" and newcomers["standing_desk"].opens == desk.opens == "drawer"
    assert crank.serves == "desk" and crank.called == "crank desk" and not crank.synonyms


def test_others_are_to_it_as_to_what_it_is_like(newcomers):
    assert categories.belong_together("crank_desk", "office_chair") and categories.tucks("office_chair", "crank_desk")
    assert not categories.belong_together("crank_desk", "sofa")
    assert "crank_desk" in categories.carriers() and "crank_desk" in categories.used_for("write")
    assert stand_in("crank_desk") == "desk" and stand_in("crank_desk", {"standing_desk", "desk"}) == "standing_desk"
    assert stand_in("crank_desk", {"sofa"}) is None and stand_in("unheard_of") is None


def test_what_an_entry_leaves_out_is_left_out():
    """Numbers, marks and lists alike."""
    rows = {"futon": {"like": "double_bed", "rule": [], "mass": [], "stands": {}, "uses": []}}
    futon, bed = read(rows, TABLE)["futon"], TABLE["double_bed"]
    assert bed.rule and bed.mass and bed.uses and bed.stands != futon.stands == type(bed.stands)()
    assert futon.rule is None and futon.mass is None and futon.uses == () and futon.size == bed.size


def test_no_rule_is_larger_than_what_it_is_for():
    """A bed is 1.6 m wide as a rule; one that comes in 1.5 m at most is 1.5 m."""
    small = {"like": "double_bed", "size": [2.0, 1.45, 0.9], "max": [2.2, 1.5, 1.2]}
    assert read({"small_bed": small}, TABLE)["small_bed"].rule == (2.0, 1.5, 0.4)


def test_it_takes_no_word_that_is_spoken_for(newcomers):
    assert categories.by_word()["desk"] == "desk"
    assert categories.by_word()["standing desk"] == "standing_desk"
    assert categories.by_word()["crank desk"] == "crank_desk"


@pytest.mark.parametrize("rows, fault", [
    ({"desk": {"like": "chair"}}, r"\[desk\] is there already"),
    ({"thing": {"like": "dask"}}, r"\[thing\] like: 'dask' is no category; did you mean 'desk'\?"),
    ({"a": {"like": "b"}, "b": {"like": "a"}}, r"\[a\] is like one that is like it"),
    ({"thing": {"like": "desk", "colour": "red"}}, r"\[thing\] colour: there is no fact of that name; "),
    ({"thing": {"like": "desk", "leafmax": 1}}, r"\[thing\] leafmax: .* did you mean 'leaf_max'\?"),
    ({"thing": {"like": "desk", "size": [1, "wide", 1]}}, r"\[thing\] size: 'wide' is no number$"),
    ({"thing": {"like": "desk", "stands": {"lean": True, "leen": 1}}}, r"\[thing\] stands.leen: there is no fact"),
    ({"thing": {"like": "desk", "synonyms": "table"}}, r"\[thing\] synonyms: 'table' is no list; write \[ … \]$"),
    ({"thing": {"like": "desk", "synonyms": ["board", " "]}}, r"\[thing\] synonyms: ' ' is no word; leave it out$"),
    ({"thing": {"like": "desk", "synonyms": ["--"]}}, r"\[thing\] synonyms: '--' is no word; leave it out$"),
    ({"thing": {"like": "desk", "labels": 3}}, r"\[thing\] labels: '3' is no table; write { name = value }$"),
    ({"thing": {"like": "desk", "rooms": ["stduy"]}}, r"\[thing\] rooms: 'stduy' is no type .*did you mean 'study'"),
    ({"thing": {"like": "desk", "uses": ["wark"]}}, r"\[thing\] uses: 'wark' is no use; did you mean 'work'"),
    ({"thing": {"like": "desk", "size": [1, 1]}}, r"\[thing\] size has 2 values, which are too few"),
    ({"thing": {"like": "desk", "size": [9, 1, 1]}}, r"\[thing\] size .* is not within min"),
    ({"thing": {"like": "desk", "place": "attic"}}, r"\[thing\] place: 'attic' is none of 'floor', 'wall'"),
    ({"thing": {"like": "desk", "belongs": ["dask"]}}, r"\[thing\] belongs: 'dask' is no category; did you"),
    ({"thing": {"size": [1, 1, 1]}}, r"\[thing\] place: is missing"),
    ({"thing": 3}, "thing is no entry"),
    ({"Pinball_Machine": {"like": "desk"}}, r"\[Pinball_Machine\] is no name of small letters, digits and _"),
])
def test_a_faulty_entry_is_named(rows, fault):
    with pytest.raises(BadInput, match=fault):
        read(rows, TABLE)


def test_words_that_are_spoken_for_are_known():
    """Of a newcomer's words those that others there are called by."""
    found = read({"thing": {"like": "desk", "synonyms": ["Fridge", "thing", "secretaire thing"]}}, TABLE)
    assert list(amiss(found, TABLE)) == ["[thing] synonyms: 'Fridge' is said of another category; left out"]


def test_a_symbol_that_nobody_draws_is_told():
    rows = {"thing": {"like": "desk", "symbol": "tabel"}, "box": {"like": "desk", "symbol": ""}}
    (told,) = amiss(read(rows, TABLE), TABLE)
    assert told.startswith("[thing] symbol: nothing is drawn for 'tabel'; did you mean 'table'")


def test_every_symbol_is_drawn():
    from apartgen.stages.export._symbols import SYMBOLS

    assert {kind.symbol for kind in TABLE.values()} <= SYMBOLS.keys()


def test_a_fault_of_a_checkout_is_told_with_its_file(tmp_path):
    file = tmp_path / "categories.toml"
    file.write_text("[rack]\nsynonims = []\n", encoding="utf-8")
    with pytest.raises(BadInput, match=r"^categories\.toml: \[rack\] "):
        categories._load(file)
