"""Figures over many apartments: means with bootstrap confidence intervals."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from apartgen.schemas.metrics import Metrics, Value
from apartgen.stages.metrics._sets import SEED
from apartgen.stages.space.boxes import Array

POOLED = ("Col_obj", "R_out", "R_blocked")
"""Shares of all objects of all apartments; every other figure is a mean over apartments."""
SIDES = ("generated", "real")
"""Versions that a comparison's table begins with."""
FREQUENCY, FAULT, LACK = "frequency/", "fault/", "lack/"
"""Begins the names of how often categories, faults and lacks come."""
MOST = 10
"""A table shows so many of each of these of a room type, the most frequent ones."""
RESAMPLES = 1000
LEVEL = 0.95


class Row(NamedTuple):
    """A figure over `n` apartments: its value and the ends of its 95 % interval."""

    name: str
    version: str
    of: str
    unit: str
    value: float
    low: float
    high: float
    n: int


def markdown(rows: Sequence[Row], seed: int) -> str:
    """A table for people; how the intervals were made stands below it."""
    head = "| figure | version | of | value | 95 % interval | n |\n|---|---|---|---|---|---|\n"
    lines = [f"| {r.name} | {r.version} | {r.of} | {r.value:.3f} | {_ends(r)} | {r.n} |" for r in rows]
    return f"{head}" + "\n".join(lines) + f"\n\nn apartments; bootstrap of {RESAMPLES} resamples, seed {seed}\n"


def _ends(row: Row) -> str:
    """An interval; one apartment has none."""
    return f"{row.low:.3f} - {row.high:.3f}" if row.n > 1 else "-"


def side_by_side(metrics: Metrics) -> str:
    """A table for people of what `compare` found: a row a figure, its versions in columns, n in brackets.

    Of what is told by frequency only the greatest are shown. How the figures came about stands below it.
    """
    versions = sorted({v.version for v in metrics.values}, key=lambda version: (version not in SIDES, version))
    rows: dict[tuple[str, str], dict[str, str]] = {}
    rare = _rare(metrics)
    for v in metrics.values:
        if (v.name, v.of) not in rare:
            rows.setdefault((v.name, v.of), {})[v.version] = _cell(v)
    head = f"| figure | of | {' | '.join(versions)} |\n|---|---|{'---|' * len(versions)}\n"
    return head + "".join(
        f"| {name} | {of} | {' | '.join(found.get(version, '') for version in versions)} |\n"
        for (name, of), found in rows.items()) + "".join(f"\n{text}\n" for text in metrics.notes)


def _rare(metrics: Metrics) -> set[tuple[str, str]]:
    """(name, of) of the frequencies beyond the `MOST` greatest of each room type, in whichever set is greater."""
    greatest: dict[tuple[str, str], dict[str, float]] = {}
    for v in metrics.values:
        if (kind := v.name.partition("/")[0] + "/") in (FREQUENCY, FAULT, LACK):
            of = greatest.setdefault((kind, v.of), {})
            of[v.name] = max(of.get(v.name, 0.0), v.value or 0.0)
    return {(name, of) for (_, of), found in greatest.items()
            for name in sorted(found, key=lambda n: -found[n])[MOST:]}


def _cell(v: Value) -> str:
    if v.value is None:
        return "-"
    shown = _short(v.value) + ("" if v.low is None or v.high is None else f" [{_short(v.low)}, {_short(v.high)}]")
    return shown if v.n is None else f"{shown} ({v.n})"


def _short(value: float) -> str:
    """Three decimals, more of what is small."""
    return f"{value:.3f}" if abs(value) >= 0.01 or value == 0 else f"{value:.5f}"


def table(measured: Sequence[Metrics], rng: np.random.Generator, of: Iterable[str] = ("apartment",)) -> list[Row]:
    """One row a figure, in the order of first appearance; apartments in which it is undefined are left out.

    Intervals are percentiles of `RESAMPLES` bootstrap means over apartments, drawn from `rng`.
    """
    wanted = set(of)
    cells: dict[tuple[str, str, str, str], list[tuple[float, float]]] = {}
    for metrics in measured:
        for v in metrics.values:
            if v.of in wanted and v.value is not None:
                weight = float(v.n) if v.name in POOLED and v.n else 1.0
                cells.setdefault((v.name, v.version, v.of, v.unit), []).append((v.value, weight))
    return [Row(*key, *interval(np.array(found), rng), len(found)) for key, found in cells.items()]


def averaged(figure: Value, found: Sequence[tuple[float, float]]) -> Value:
    """The figure as weighted mean of (value, weight) pairs, one a room; its interval where there are several."""
    if not found:
        return figure
    value, low, high = interval(np.array(found), np.random.default_rng(SEED))
    ends = {"low": low, "high": high} if len(found) > 1 else {}
    return figure.model_copy(update={"value": value, **ends})


def interval(found: Array, rng: np.random.Generator) -> tuple[float, float, float]:
    """Weighted mean of (value, weight) pairs (n, 2), and its bootstrap interval."""
    value, weight = found.T
    drawn = rng.integers(len(value), size=(RESAMPLES, len(value)))
    means = (value * weight)[drawn].sum(1) / weight[drawn].sum(1)
    low, high = np.quantile(means, [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return float((value * weight).sum() / weight.sum()), float(low), float(high)
