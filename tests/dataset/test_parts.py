"""Sources, grammars, twins and splits of data sets."""

import itertools
import json
import logging

import handmade
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen import planning
from apartgen.dataset import shape, splits
from apartgen.dataset.grammar import Grammar
from apartgen.dataset.source import Drawn, Listed, source
from apartgen.schemas.errors import BadInput
from apartgen.stages import seeds


def test_a_list_is_gone_through_again_under_new_ids():
    found = list(Listed(b'studio\n{"id": "a/b", "prompt": "loft", "seed": 3}\n', "list", 5).requests())
    assert [(one.prompt, one.id) for one in found] == [
        ("studio", ""), ("loft", "a/b"), ("studio", "studio+1"), ("loft", found[1].name + "+1"), ("studio", "studio+2")]
    assert len({one.name for one in found}) == 5 and found[3].seed == 3


@pytest.mark.parametrize("data, count", [(b"studio\nplan.json\n", None), (b"", None),
                                         (b'{"id": "a", "prompt": "x"}\n{"id": "a+1", "prompt": "x"}', 4)])
def test_a_list_with_anything_wrong_makes_nothing(data, count):
    with pytest.raises(BadInput):
        Listed(data, "list", count)


def test_a_grammar_draws_by_number_and_every_wording_is_understood(caplog):
    caplog.set_level(logging.ERROR, "apartgen")  # taken back after the test
    grammar = Grammar.read("default")
    first = [one.prompt for one in Drawn(grammar, 7, 120).requests()]
    assert first[:50] == [one.prompt for one in Drawn(grammar, 7, 50).requests()]
    assert first != [one.prompt for one in Drawn(grammar, 8, 120).requests()] and len(set(first)) > 80
    for i, prompt in enumerate(first):
        program, _ = planning.read(prompt, planning.PlanSettings(), seeds.drawn(0, str(i)))
        assert not program.unread, prompt


@pytest.mark.parametrize("text, words", [
    ("home = ['{nothing}']", "nothing"), ("house = ['x']", "'home'"), ("home = [[0, 'x']]", "weight"),
    ("home = [", "TOML"), ("home = ['{home} {home}']", "without end"), ("home = 3", "weight"),
    ("home = ['{9-4}']", "9 to 4"), ("home = ['{4-9/0}']", "by 0"), ("home = [[1e300, 'x'], [1e308, 'y']]", "weight"),
    ("home = ['{a0}']\n" + "\n".join(f"a{i} = ['{{a{i + 1}}} {{a{i + 1}}}']" for i in range(38)) + "\na38 = ['x']",
     "without end")])
def test_a_wrong_grammar_is_told(tmp_path, text, words):
    file = tmp_path / "g.toml"
    file.write_text(text)
    with pytest.raises(BadInput, match=words):
        Grammar.read(str(file)).sentence(0, 0)


def test_numbers_of_a_grammar_are_within_their_bounds(tmp_path):
    (tmp_path / "g.toml").write_text("home = ['{40-90/5} m² {2-3}']")
    drawn = {Grammar.read(str(tmp_path / "g.toml")).sentence(0, i) for i in range(300)}
    assert drawn == {f"{a} m² {b}" for a, b in itertools.product(range(40, 91, 5), (2, 3))}


def test_a_source_is_one_or_the_other(tmp_path):
    for arguments in ((None, None, 3), ("a", "default", 3), (None, "default", None)):
        with pytest.raises(BadInput):
            source(*arguments, 0)


def row(id: str, signature: str, sides: list[float]) -> dict:
    return {"id": id, "shard": "x", "signature": signature, "sides": sides}


@given(st.lists(st.tuples(st.sampled_from("ab"), st.lists(st.integers(0, 60), min_size=2, max_size=2)), min_size=1,
                max_size=60), st.integers(0, 5))
@settings(max_examples=100, deadline=None)
def test_twins_are_never_parted(homes, seed):
    rows = [row(str(i), signature, [side / 20 for side in sides]) for i, (signature, sides) in enumerate(homes)]
    part = splits.assigned(rows, {"train": 0.5, "test": 0.5}, seed)
    assert set(part) == {one["id"] for one in rows}
    for a, b in itertools.combinations(rows, 2):
        far = np.sqrt(np.mean((np.array(a["sides"]) - np.array(b["sides"])) ** 2))
        if a["signature"] == b["signature"] and far < splits.TWINS_WITHIN:
            assert part[a["id"]] == part[b["id"]]


def test_parts_get_their_shares():
    rows = [row(str(i), str(i), [1.0]) for i in range(3000)]
    part = splits.assigned(rows, splits.parts_of("train=8,test=2"), 0)
    assert 0.77 < sum(name == "train" for name in part.values()) / 3000 < 0.83
    for text in ("train", "a=0", "a=-1,b=2", "", "a=nan", "=1"):
        with pytest.raises(BadInput):
            splits.parts_of(text)


def test_the_shape_of_a_home_is_the_same_however_it_lies_and_is_named():
    home = handmade.plan()
    raw = json.loads(home.model_dump_json())

    def turned(point):
        return [-point[1] + 3.0, point[0] + 7.0]

    text = json.dumps(raw)
    for room in raw["rooms"]:
        text = text.replace(f'"{room["id"]}"', f'"{room["type"]}_{int(room["id"].rpartition("_")[2]) + 50}"')
    other = json.loads(text)
    for room in other["rooms"]:
        room["polygon"] = [turned(point) for point in room["polygon"]]
    for opening in other["openings"]:
        opening["segment"] = [turned(point) for point in opening["segment"]]
    other["rooms"].reverse()
    found, again = shape.of(home), shape.of(type(home).model_validate_json(json.dumps(other)))
    assert found["signature"] == again["signature"] and found["area"] == again["area"] > 0
    assert np.allclose(found["sides"], again["sides"])
    cut = home.model_copy(update={"openings": [o for o in home.openings if o.kind != "door"]})
    assert shape.of(cut)["signature"] != found["signature"]
