"""CKL: Kullback-Leibler divergence of category frequencies, real from generated rooms."""

from collections.abc import Iterable, Sequence

import numpy as np

from schemas.layout import Layout
from schemas.metrics import Value
from stages.boxes import Array
from stages.categories import CATEGORIES
from stages.metrics._distances import Figure, spread
from stages.metrics._sets import ALL, SEED, Scene, halves, rooms, types

EPSILON = 1e-6


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Σ p (log(p + ε) - log(q + ε)), p of half of the real rooms and q of as many others, in all and by room type.

    Versions: generated = q of generated rooms · real = q of the other half of the real ones · published = q of all
    generated and p of all real rooms.
    """
    values = []
    for kind in (ALL, *types(real)):
        generated, reference = rooms(homes, real, kind), rooms(real, real, kind)
        drawn, half, other = halves(generated, reference)
        for version, q, p in (("published", generated, reference), ("generated", drawn, half), ("real", other, half)):
            figure = divergence(_categories(q), _categories(p), np.random.default_rng(SEED))
            found = figure._asdict() if figure else {"value": None}
            values.append(Value(name="CKL", unit="nats", version=version, of=kind, n=len(q), **found))
    return values


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
