"""Table 2: how well plans follow prompts with a known room graph, read by the embedded reader."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes

PAPER = [{"S_node": 0.989, "S_constraint": 0.923, "S_edge": 0.954}]
NOTE = (
    "Prompts with ground truth written by hand. `held` was written before the reader was made and not looked at while "
    "it was tuned; `tune` has grown with it. `stated` are the prompts that give areas themselves. The figures are of "
    "the plan that was built, against the graph and areas an architect would write for the prompt."
)
SETTINGS = ["tune", "held"]
SCENES, CHUNK = 600, 10
FIGURES = ["S_node", "S_constraint", "S_constraint, stated", "S_edge", "built"]


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` prompts of a half from the first on, as far as it has them; a prompt without a plan scores 0."""
    from apartgen_cli.bench._runner import SEEDS
    from stages.plan.prompts import cases

    chosen = cases(setting)
    start = seed % SEEDS
    return [_scored(case) for case in chosen[start : start + scenes]]


def _scored(case: Any) -> dict[str, Any]:
    from schemas.errors import ApartgenError
    from stages import graphs, plan
    from stages.plan.config import PlanConfig
    from stages.plan.reader import read

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
