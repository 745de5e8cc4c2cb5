"""What experiments say of themselves, their rows of real rooms, and their figures."""

import re

import pytest
from matplotlib.figure import Figure
from sentences import cases

from apartgen.schemas.errors import BadInput
from apartgen_cli.bench import _runner, articulation, controllability
from apartgen_cli.bench._compared import REAL


def test_the_note_counts_the_prompts_that_give_areas():
    every, held = cases(), cases("held")
    whole = sum(len(case.stated) == len(case.truth.types) for case in every)
    found = [int(n) for n in re.findall(r"\d+", re.search(r"of the (\d+ of .*?\))", controllability.NOTE).group(1))]
    given = [sum(case.quantified for case in half) for half in (every, held)]
    assert found == [given[0], len(every), given[1], len(held)]
    assert whole == 5 and "five of them" in controllability.NOTE


def test_controllability_draws_every_row_and_the_paper():
    rows = [{"setting": name, "scenes": 3} | {figure: [low + 0.02, low, 1.0] for figure in controllability.DRAWN}
            for name, low in (("tune", 0.8), ("held", 0.95))]
    del rows[1]["S_constraint, stated"]
    axes = Figure().subplots()
    controllability.draw(rows, axes)
    assert [text.get_text() for text in axes.get_xticklabels()] == ["tune", "held", "the paper"]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == controllability.DRAWN
    assert axes.get_ylim()[0] == pytest.approx(0.79)
    heights = sorted(y for line in axes.get_lines() for y in line.get_ydata() if line.get_marker() == "D")
    assert heights == [0.923, 0.954, 0.989]


@pytest.mark.parametrize("setting", [REAL, f"{REAL}{articulation.ASSETS}"])
def test_rooms_as_the_furnisher_has_them_are_measured_like_the_others(setting, tmp_path):
    assert setting in articulation.SETTINGS
    first, second = articulation.trial(setting, 8, 2, tmp_path), articulation.trial(setting, 8, 2, tmp_path)
    assert first == second and len(first) == 2
    assert all({"Col_obj/ours", "R_out/ours", "R_reach/standing"} <= set(record) for record in first)


def test_what_is_installed_without_its_sentences_says_so(monkeypatch, tmp_path):
    monkeypatch.setattr(controllability, "SENTENCES", tmp_path / "sentences" / "__init__.py")
    with pytest.raises(BadInput, match="in a checkout"):
        _runner.jobs(controllability, 10, 0)


def test_a_figure_of_few_prompts_leaves_out_what_none_of_them_gives():
    axes = Figure().subplots()
    controllability.draw([{"setting": "held", "S_node": [1.0, 0.9, 1.0]}], axes)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["S_node"]
