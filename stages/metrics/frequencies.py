"""CKL: Kullback-Leibler divergence of category frequencies, real from generated rooms."""

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np

from schemas.layout import Layout
from schemas.metrics import Value
from stages.categories import CATEGORIES
from stages.metrics._sets import ALL, Scene, halves, rooms, types

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
            value = divergence(_categories(q), _categories(p))
            values.append(Value(name="CKL", value=value, unit="nats", version=version, of=kind, n=len(q)))
    return values


def _categories(scenes: Iterable[Scene]) -> list[str]:
    return [o.category for _, inside in scenes for o in inside]


def divergence(generated: Iterable[str], real: Iterable[str]) -> float | None:
    """CKL of two lists of categories; None when either is empty."""
    counts = [Counter(generated), Counter(real)]
    names = sorted({*CATEGORIES, *counts[0], *counts[1]})
    q, p = (np.array([count[name] for name in names], float) for count in counts)
    if not q.sum() or not p.sum():
        return None
    q, p = q / q.sum(), p / p.sum()
    return float((p * (np.log(p + EPSILON) - np.log(q + EPSILON))).sum())
