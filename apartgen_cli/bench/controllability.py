"""Table 2: how well plans follow prompts with a known room graph; in a checkout, where the sentences are."""

import importlib.util
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen_cli.bench import _scenes

PAPER = [{"S_node": 0.989, "S_constraint": 0.923, "S_edge": 0.954}]
NOTE = (
    "Prompts with rooms and links written by hand, and the areas that they state. `held` was written before the reader "
    "was made and not looked at while it was tuned; `tune` has grown with it. The figures are of the plan that was "
    "built. Areas that a prompt leaves open are in the ground truth the typical ones that the reader itself takes, so "
    "that S_constraint over all prompts says little more than that the plan keeps the areas the reader asked for. What "
    "counts is `stated`: of the 119 of 628 prompts (held: 20 of 120) that give any area, ratio of areas or total; "
    "there, too, what is left open is typical: five of them give the area of every room."
)
SETTINGS = ["tune", "held"]
SCENES, CHUNK = 600, 10
DRAWN = ["S_node", "S_constraint", "S_constraint, stated", "S_edge"]
FIGURES = [*DRAWN, "built"]
SENTENCES = Path(__file__).parents[2] / "tests" / "sentences" / "__init__.py"


def sentences() -> ModuleType:
    """The sentences and their programmes, which are kept with the tests; BadInput in what is installed without them."""
    spec = importlib.util.spec_from_file_location("sentences", SENTENCES)
    if not SENTENCES.exists() or spec is None or spec.loader is None:
        raise BadInput("controllability: its sentences are part of the repository, not of the package; "
                       "run it in a checkout, installed with pip install -e .")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def settings() -> list[str]:
    """The halves, where there are any."""
    sentences()
    return SETTINGS


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` prompts of a half from the first on, as far as it has them; a prompt without a plan scores 0."""
    from apartgen_cli.bench._runner import SEEDS

    chosen = sentences().cases(setting)
    start = seed % SEEDS
    return [_scored(case) for case in chosen[start : start + scenes]]


def _scored(case: Any) -> dict[str, Any]:
    from apartgen.schemas.errors import ApartgenError
    from apartgen.stages import plan
    from apartgen.stages.plan.config import PlanConfig
    from apartgen.stages.plan.reader import read
    from apartgen.stages.space import graphs

    try:
        made = plan.build(read(case.prompt), PlanConfig(processes=1), np.random.default_rng(case.id))
    except ApartgenError as error:
        return {
            "prompt": case.prompt,
            "error": str(error),
            "S_node": 0.0,
            "S_constraint": 0.0,
            "S_edge": 0.0,
            "built": 0.0,
        }
    graph = graphs.of_plan(made)
    constraint = graphs.constraint_satisfaction(graph, case.truth)
    return {
        "prompt": case.prompt,
        "S_node": graphs.node_similarity(graph, case.truth),
        "S_constraint": constraint,
        **({"S_constraint, stated": constraint} if case.quantified else {}),
        "S_edge": graphs.edge_similarity(graph, case.truth),
        "built": 1.0,
    }


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each half and one for both."""
    both = [{**r, "setting": "both"} for r in records]
    return _scenes.intervals([*records, *both], [*SETTINGS, "both"], FIGURES, rng)


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Similarities of every row with their intervals, and the paper's; they are near 1, so no bars from 0."""
    width, least = 0.16, 0.91
    for k, (name, colour) in enumerate(zip(DRAWN, _scenes.COLOURS)):
        shift = (k - (len(DRAWN) - 1) / 2) * width
        there = [(i, row[name]) for i, row in enumerate(rows) if name in row]
        if not there:
            continue
        value, low, high = np.array([found for _, found in there]).T
        at, least = np.array([i for i, _ in there]) + shift, min(least, *low)
        axes.errorbar(at, value, [value - low, high - value], fmt="o", capsize=3, color=colour, label=name)
        if name in PAPER[0]:
            axes.plot(len(rows) + shift, PAPER[0][name], "D", color=colour)
    axes.set_xticks(range(len(rows) + 1), [*(row["setting"] for row in rows), "the paper"])
    axes.set(ylabel="similarity", ylim=(max(least - 0.01, 0), 1.005))
    _scenes.tidy(axes)
