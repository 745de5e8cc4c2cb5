"""The weights of the plan solver: what each of them moves by its dose, and by a sentence that asks for it."""

from pathlib import Path
from typing import Any

import numpy as np

PAPER: list[dict[str, Any]] = []
NOTE = (
    "Each weight times 0, 1, 4 and 16 for two flats, the same seeds at every dose, and one sentence a weight beside "
    "the same flats without it. A term's measure is taken from the finished plan (`apartgen.stages.plan.seen`), as the "
    "mean of both flats. `d/se`: difference of means over its standard error within the flats, from dose 0 to 16 and "
    "from without the sentence to with it. `areas`: `S_constraint`, against 1. The terms of staircases are idle: no "
    "plan has stairs."
)
DOSES = (0.0, 4.0, 16.0)
FLATS = {"two_bedroom": "two-bedroom flat", "three_bedroom": "three-bedroom flat"}
"""Archetypes and prompts; in the one few walls are left to align, in the other few corners to hold."""
USUAL, PLAIN = "usual", "flat"
SENTENCES = {
    "shortest_path": "direct routes from the entrance", "typical_area": "exact room sizes",
    "aspect_ratio": "square rooms", "convexity": "no recesses", "conciseness": "simple room shapes",
    "exterior_length": "lots of daylight", "exterior_corner": "corner rooms", "collinearity": "aligned walls",
    "functional_room": "little circulation", "narrow_passage": "wide passages", "near_rooms": "wet rooms side by side",
    "wide_corridor": "narrow corridors", "privacy": "quiet bedrooms",
}  # fmt: skip
SETTINGS = [USUAL, *(f"{term} × {dose:g}" for term in SENTENCES for dose in DOSES),
            PLAIN, *(f"{PLAIN} with {words}" for words in SENTENCES.values())]
SCENES, CHUNK = 40, 40
TABLES = {
    "Dose and response": ["term", "measure", "× 0", "× 1", "× 4", "× 16", "d/se", "areas × 1", "areas × 16"],
    "Sentences": ["sentence", "measure", "without", "with", "d/se with", "areas without", "areas with"],
}


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` plans of each flat with one weight changed, or with one sentence."""
    from apartgen.stages import plan
    from apartgen.stages.plan.seen import seen
    from apartgen.stages.plan.study import measured

    out, config = [], plan.PlanConfig(processes=1)
    for flat in FLATS:
        program = _program(setting, flat)
        for i in range(seed, seed + scenes):
            one = plan.build(program, config, np.random.default_rng(i))
            out.append({"flat": flat, "seed": i, **seen(one), "areas": measured(one)["S_constraint"]})
    return out


def _program(setting: str, flat: str) -> Any:
    from apartgen.stages.plan import reader
    from apartgen.stages.plan.study import archetypes

    if setting.startswith(PLAIN):
        return reader.read(FLATS[flat] + setting.removeprefix(PLAIN))
    term, _, dose = setting.partition(" × ")
    weights = {} if setting == USUAL else {term: float(dose)}
    return archetypes()[flat].model_copy(update={"weights": weights})


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each term: its measure at every dose, and without and with its sentence."""
    from apartgen.stages.plan.seen import UNITS

    by = {setting: [r for r in records if r["setting"] == setting] for setting in SETTINGS}
    out = []
    for term, words in SENTENCES.items():
        dose = {0.0: by[f"{term} × 0"], 1.0: by[USUAL], 4.0: by[f"{term} × 4"], 16.0: by[f"{term} × 16"]}
        plain, asked = by[PLAIN], by[f"{PLAIN} with {words}"]
        out.append({
            "term": f"`{term}`", "sentence": words, "measure": UNITS[term],
            **{f"× {d:g}": _mean(found, term) for d, found in dose.items()},
            "d/se": effect(dose[0.0], dose[16.0], term),
            "areas × 1": _mean(dose[1.0], "areas"), "areas × 16": _mean(dose[16.0], "areas"),
            "without": _mean(plain, term), "with": _mean(asked, term), "d/se with": effect(plain, asked, term),
            "areas without": _mean(plain, "areas"), "areas with": _mean(asked, "areas"),
        })  # fmt: skip
    return out


def _mean(records: list[dict[str, Any]], name: str) -> float:
    return float(np.mean([r[name] for r in records]))


def effect(before: list[dict[str, Any]], after: list[dict[str, Any]], name: str) -> float:
    """Difference of two means over its standard error, both within flats of which there are equally many."""
    apart, error = 0.0, 0.0
    for flat in {r.get("flat") for r in before}:
        a, b = (np.array([r[name] for r in found if r.get("flat") == flat]) for found in (before, after))
        apart += b.mean() - a.mean()
        error += a.var(ddof=1) / len(a) + b.var(ddof=1) / len(b) if min(len(a), len(b)) > 1 else 0.0
    return float(apart / max(np.sqrt(error), 1e-9))
