"""What a data set holds, in numbers: spread of every figure, kinds of rooms and things, failures, twins, time."""

from collections import Counter
from collections.abc import Iterable
from typing import Any

import numpy as np

from apartgen.dataset import splits
from apartgen.dataset.rows import Row
from apartgen.dataset.store import HOMES, Store

QUANTILES = (0, 5, 25, 50, 75, 95, 100)


def statistics(store: Store) -> dict[str, Any]:
    """Counts and quantiles, ready for JSON."""
    rows = list(store.rows())
    made = [row for row in rows if "shard" in row]
    groups = splits.twins(made)
    size = sum(file.stat().st_size for file in (store.folder / HOMES).glob("*.gz"))
    return {
        "homes": len(made), "failed": len(rows) - len(made), "certified": sum(row["certified"] for row in made),
        "drawn_again": sum("thrown_away" in row for row in made),
        "bytes": size, "seconds": round(sum(row["seconds"].get("all", 0.0) for row in rows), 1),
        "split": dict(Counter(row["split"] for row in made if "split" in row)),
        "programmes": len({row["signature"] for row in made}), "prompts": len({row["prompt"] for row in made}),
        "twins": {"groups": sum(len(group) > 1 for group in groups),
                  "homes": sum(len(group) for group in groups if len(group) > 1)},
        "failures": _kinds(row["error"] for row in rows if "error" in row),
        "thrown_away": _kinds(why for row in made for why in row.get("thrown_away", [])),
        "rooms": _counted(row["rooms"] for row in made), "objects": _counted(row["objects"] for row in made),
        "figures": _figures(made),
    }


def _kinds(errors: Iterable[str]) -> dict[str, int]:
    return dict(Counter(map(_kind, errors)).most_common(20))


def _kind(error: str) -> str:
    """An error without its numbers, so that those alike are counted together."""
    return "".join("#" if c.isdigit() else c for c in error)[:100]


def _counted(tables: Iterable[dict[str, int]]) -> dict[str, int]:
    total: Counter[str] = Counter()
    for table in tables:
        total.update(table)
    return dict(total.most_common())


def _figures(made: list[Row]) -> dict[str, dict[str, float]]:
    """Mean and quantiles of each number that homes have."""
    found: dict[str, list[float]] = {}
    for row in made:
        values = {"area": row["area"], "rooms": sum(row["rooms"].values()), "objects": sum(row["objects"].values()),
                  **row["metrics"], **{f"seconds {word}": value for word, value in row["seconds"].items()}}
        for name, value in values.items():
            if value is not None:
                found.setdefault(name, []).append(float(value))
    return {name: _spread(np.array(values)) for name, values in found.items()}


def _spread(values: np.ndarray) -> dict[str, float]:
    spread = {"n": float(len(values)), "mean": float(values.mean())}
    spread |= {f"p{q}": float(np.percentile(values, q)) for q in QUANTILES}
    return {name: round(value, 4) for name, value in spread.items()}


def table(found: dict[str, Any]) -> str:
    """The same for people, as Markdown."""
    lines = [f"{found['homes']} homes, {found['failed']} failed, {found['certified']} certified, "
             f"{found['drawn_again']} of them after a draw was thrown away; "
             f"{found['programmes']} graphs of rooms, {found['prompts']} prompts; "
             f"{found['twins']['homes']} homes in {found['twins']['groups']} groups of twins; "
             f"{found['bytes'] / max(found['homes'], 1) / 1000:.1f} kB and "
             f"{found['seconds'] / max(found['homes'] + found['failed'], 1):.2f} s a home."]
    for name in ("split", "rooms", "objects", "failures", "thrown_away"):
        if found[name]:
            counts = ", ".join(f"{key} {n}" for key, n in list(found[name].items())[:40])
            lines += ["", f"**{name.replace('_', ' ')}**: {counts}"]
    lines += ["", "| figure | n | mean | " + " | ".join(f"p{q}" for q in QUANTILES) + " |",
              "|---" * (3 + len(QUANTILES)) + "|"]
    for name, spread in found["figures"].items():
        cells = [name, f"{spread['n']:.0f}", *(f"{spread[key]:.3g}" for key in list(spread)[1:])]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"
