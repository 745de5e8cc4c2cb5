"""Table 1: FID, KID, SCA and CKL of floor-conditioned rooms, alone and in apartments, and of real against real."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.base import RoomType
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen_cli.bench import _compared, _scenes
from apartgen_cli.bench._compared import FURNISHER, HELD_OUT, REAL, REFERENCE

PAPER = [
    {"setting": "ATISS", "FID": 30.19, "KID": 0.0010, "SCA": 49.14, "CKL": 0.0028},
    {"setting": "DiffuScene", "FID": 25.00, "KID": 0.0004, "SCA": 51.78, "CKL": 0.0031},
    {"setting": "PhyScene", "FID": 25.52, "KID": 0.0006, "SCA": 50.10, "CKL": 0.0025},
    {"setting": "paper, single room", "FID": 29.02, "KID": 0.0004, "SCA": 49.11, "CKL": 0.0024},
    {"setting": "paper, apartment", "FID": 29.14, "KID": 0.0006, "SCA": 49.04, "CKL": 0.0025},
]
NOTE = (
    "Rooms drawn as boxes from above, 256² pixels, by one renderer for all. Every row is compared with the same "
    "reference furnishings of the same floors, as many scenes a side; what a figure would be if nothing were left to "
    "learn is the row `real against real`: other furnishings of these floors from the same source. Here the source is "
    "the furnisher that made the training data, with seeds that training did not use; `3D-FRONT` rows, made where real "
    "rooms are given (--real ssr=rooms.jsonl.gz), furnish the floors of real rooms and compare with those, which the "
    "model never saw and which lack doors and windows; there things of kinds that real rooms never have (radiators, "
    "curtains, …) are left out of ours. The paper's figures are of another network, renderer and data: compare each "
    "with its own real-against-real row only. 95 % intervals by bootstrap."
)
TAKES = ("weights", "inception_weights", "real")
SINGLE, APARTMENT, GIVEN = "single room", "apartment", "3D-FRONT"
METHODS = ("all guidance + projection", "no guidance")
SETTINGS = [f"{place}, {who}" for place in (SINGLE, APARTMENT) for who in (REFERENCE, REAL, *METHODS)]
TYPES: tuple[RoomType, ...] = ("bedroom", "living_room", "dining_room")
"""Of single rooms, in turn."""
FIGURES = ("FID", "KID", "SCA", "CKL")
SCENES, CHUNK = 1000, 50


def settings(
    weights: list[str] | None = None, inception_weights: str | None = None, real: str | None = None
) -> list[str]:
    """Rows of real rooms come only where there are some."""
    given = [f"{GIVEN}, {who}" for who in (REFERENCE, REAL, FURNISHER, *METHODS)] if real else []
    return [*SETTINGS, *given]


def trial(
    setting: str, seed: int, scenes: int, work: Path, weights: list[str] | None = None,
    inception_weights: str | None = None, real: str | None = None,
) -> list[dict[str, Any]]:
    """`scenes` rooms: what the network sees of them, and their categories."""
    place, _, who = setting.partition(", ")
    if place == GIVEN:
        homes = _compared.real_rooms(str(real), seed, scenes, other=who == REAL)
        real_ones = who in (REFERENCE, REAL)
        made = homes if real_ones else _made([_compared.bare(home) for home in homes], who, seed, weights)
    else:
        single = place == SINGLE
        plans = _drawn(seed, scenes) if single else _scenes.plans(seed, -(-scenes // 6), work)
        made = _made(plans, who, seed, weights)
    rooms = _compared.inside(made)
    if place == GIVEN:
        rooms = [(room, [o for o in objects if o.category in _compared.kinds(str(real))]) for room, objects in rooms]
    rooms = [(room, objects) for room, objects in rooms if objects]
    return _compared.seen(rooms[:scenes], inception_weights)


def used(
    setting: str, weights: list[str] | None = None, inception_weights: str | None = None, real: str | None = None
) -> dict[str, Any]:
    """The weights where something is sampled, the real rooms where they are furnished."""
    place, _, who = setting.partition(", ")
    given = {"weights": weights if who in METHODS else None, "inception_weights": inception_weights,
             "real": real if place == GIVEN else None}
    return {name: value for name, value in given.items() if value}


def _drawn(seed: int, scenes: int) -> list[Plan]:
    """Plans of one room."""
    from apartgen.stages.layout.datasets import single_rooms

    lanes = [np.random.default_rng([HELD_OUT, seed, i]) for i in range(scenes)]
    return [single_rooms.draw(rng, TYPES[i % len(TYPES)]) for i, rng in enumerate(lanes)]


def _made(plans: list[Plan], who: str, seed: int, weights: list[str] | None) -> list[Layout]:
    """The plans furnished by a method of ours, or by the furnisher."""
    if who in METHODS:
        changes = {"weights": weights[0]} if weights else {}
        return _scenes.furnished(plans, _scenes.config(who, **changes), seed)
    return _compared.furnished(plans, seed, who)


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for everything that is compared with its place's reference, at equal numbers."""
    out = []
    for setting in dict.fromkeys(r["setting"] for r in records):
        place, _, who = setting.partition(", ")
        if who == REFERENCE:
            continue
        mine = [r for r in records if r["setting"] == setting]
        reference = [r for r in records if r["setting"] == f"{place}, {REFERENCE}"]
        n = min(len(mine), len(reference))
        out.append({"setting": setting, "network": mine[0]["network"], "scenes": n,
                    **_compared.apart(mine[:n], reference[:n], rng, FIGURES)})
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """SCA of every row, with its interval; at 50 % nobody can tell."""
    name = next(name for name in rows[0] if name.startswith("SCA"))
    _scenes.bars(rows, [name], axes)
    axes.axhline(50, color="0.15", linestyle="--", linewidth=0.8)
    axes.set(ylabel="SCA, %", ylim=(0, 100))
