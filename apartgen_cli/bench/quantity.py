"""Table 3: share of scenes that hold exactly the number of objects asked for, N = 5 … 16."""

from pathlib import Path
from typing import Any

import numpy as np

from apartgen_cli.bench import _scenes

TARGETS = range(5, 17)
PAPER = [
    {"N": n, "Q_ratio": q}
    for n, q in zip(TARGETS, (0.95, 0.95, 0.96, 0.95, 0.96, 0.97, 0.96, 0.96, 0.96, 0.95, 0.95, 0.95), strict=True)
]
NOTE = (
    "Scenes are living rooms and bedrooms of 12 m² and more. `exact` fills N slots by construction, `guided` is Eq. 3 "
    "below 10 % of the schedule, `free` is told the count and not guided."
)
SETTINGS = [f"{count} {n}" for count in ("exact", "guided", "free") for n in TARGETS]
SCENES, CHUNK = 100, 50
LABELS = {"exact": "exact by construction", "guided": "Eq. 3", "free": "unguided"}
ROOMS = ("living_room", "bedroom")
LEAST_AREA = 12.0


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """`scenes` rooms, each asked for N objects."""
    count, n = setting.split()
    homes = []
    for home in _scenes.plans(seed, scenes, work):
        wanted = [room for room in home.rooms if room.base in ROOMS and _scenes.area(room.polygon) >= LEAST_AREA]
        for room in wanted[:1]:
            program = home.program.model_copy(update={"counts": {room.id: int(n)}, "objects": []})
            openings = [o for o in home.openings if room.id in o.rooms]
            homes.append(home.model_copy(update={"rooms": [room], "openings": openings, "program": program}))
    made = _scenes.furnished(homes, _scenes.config("all guidance + projection", count=count), seed)
    return [{"N": int(n), "count": count, "hit": float(len(home.objects) == int(n))} for home in made]


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """A row for each N."""
    out = []
    for n in TARGETS:
        row: dict[str, Any] = {"N": n}
        for count in LABELS:
            hits = [r["hit"] for r in records if r["N"] == n and r["count"] == count]
            if hits:
                row[f"Q_ratio, {count}"], row["scenes"] = _scenes.mean(hits, rng), len(hits)
        out.append(row)
    return out


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """Q_ratio over N."""
    for count in LABELS:
        mine = [r for r in rows if f"Q_ratio, {count}" in r]
        value, low, high = np.array([r[f"Q_ratio, {count}"] for r in mine]).reshape(-1, 3).T
        # Side by side, because two of them often agree.
        at = np.array([r["N"] for r in mine]) + {"exact": -0.12, "guided": 0.12}.get(count, 0.0)
        axes.errorbar(at, value, [value - low, high - value], marker="o", capsize=2, label=LABELS[count])
    axes.plot([r["N"] for r in PAPER], [r["Q_ratio"] for r in PAPER], "k--", label="paper")
    axes.set(xlabel="N asked for", ylabel="Q_ratio", ylim=(-0.02, 1.04), xticks=TARGETS)
    _scenes.tidy(axes)
