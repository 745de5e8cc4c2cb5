"""Frequencies of categories in generated and real rooms, and CKL, their Kullback-Leibler divergence."""

from collections.abc import Iterable, Sequence

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._distances import Figure, spread
from apartgen.stages.metrics._sets import ALL, SEED, Scene, every, halves, rooms, types
from apartgen.stages.metrics._table import FREQUENCY, LEVEL, RESAMPLES
from apartgen.stages.space.boxes import Array
from apartgen.stages.things.categories import CATEGORIES

EPSILON = 1e-6


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """CKL, and frequency/CATEGORY: objects of a category in a room, in all rooms and by room type.

    CKL is Σ p (log(p + ε) - log(q + ε)), p of half of the real rooms and q of as many others. Versions: generated = q
    of generated rooms · real = q of the other half of the real ones · published = q of all generated and p of all real
    rooms. Frequencies are of all rooms of either set, the greatest first.
    """
    kinds = (ALL, *types(real))
    return [value for part in (_divergences, _frequencies) for kind in kinds for value in part(homes, real, kind)]


def _divergences(homes: Sequence[Layout], real: Sequence[Layout], kind: str) -> list[Value]:
    generated, reference = rooms(homes, real, kind), rooms(real, real, kind)
    drawn, half, other = halves(generated, reference)
    values = []
    for version, q, p in (("published", generated, reference), ("generated", drawn, half), ("real", other, half)):
        figure = divergence(_categories(q), _categories(p), np.random.default_rng(SEED))
        found = _figures(np.array(figure), len(q)) if figure else {"value": None}
        values.append(Value(name="CKL", unit="nats", version=version, of=kind, n=len(q), **found))
    return values


def _frequencies(homes: Sequence[Layout], real: Sequence[Layout], kind: str) -> list[Value]:
    sides = {"generated": _categories(every(homes, real, kind)), "real": _categories(every(real, real, kind))}
    names = sorted({name for scenes in sides.values() for scene in scenes for name in scene})
    means = {version: _mean_counts(_counts(scenes, names)) for version, scenes in sides.items() if scenes}
    greatest = np.max([mean for mean, _, _ in means.values()], axis=0)
    return [
        Value(name=FREQUENCY + names[i], unit="objects", version=version, of=kind, n=len(scenes),
              **_figures(means[version][:, i], len(scenes)) if scenes else {"value": None})
        for i in np.argsort(-greatest, kind="stable").tolist() for version, scenes in sides.items()]


def _mean_counts(counts: Array) -> Array:
    """Means of counts (rooms, categories), and the ends of their bootstrap intervals over rooms, (3, categories)."""
    n, rng = len(counts), np.random.default_rng(SEED)
    drawn = rng.multinomial(n, np.full(n, 1 / n), RESAMPLES) @ counts / n
    return np.stack([counts.mean(0), *np.quantile(drawn, [(1 - LEVEL) / 2, (1 + LEVEL) / 2], axis=0)])


def _figures(found: Array, n: int) -> dict[str, float]:
    """Value and ends of the interval, which a single room has not."""
    return dict(zip(("value", "low", "high")[: 3 if n > 1 else 1], map(float, found)))


def _categories(scenes: Iterable[Scene]) -> list[list[str]]:
    return [[o.category for o in inside] for _, inside in scenes]


def divergence(
    generated: Sequence[Sequence[str]], real: Sequence[Sequence[str]], rng: np.random.Generator
) -> Figure | None:
    """CKL of the categories in two lists of scenes; None when either holds nothing."""
    names = sorted({*CATEGORIES, *(name for scene in (*generated, *real) for name in scene)})
    q, p = (_counts(scenes, names) for scenes in (generated, real))
    if not q.sum() or not p.sum():
        return None
    found = spread(lambda v, w: _ckl(v @ q, w @ p), (np.ones(len(q)), np.ones(len(p))), rng)
    return found._replace(low=max(found.low, min(found.value, 0.0)))


def _counts(scenes: Sequence[Sequence[str]], names: list[str]) -> Array:
    """How often each scene has each category, (scenes, categories)."""
    counts = np.array([[scene.count(name) for name in names] for scene in map(list, scenes)], float)
    return counts.reshape(len(scenes), len(names))


def _ckl(q: Array, p: Array) -> float:
    q, p = q / max(q.sum(), 1), p / max(p.sum(), 1)  # a resample may hold nothing
    return float((p * (np.log(p + EPSILON) - np.log(q + EPSILON))).sum())
