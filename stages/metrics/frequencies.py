"""CKL: Kullback-Leibler divergence of category frequencies, real from generated rooms."""

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np

from schemas.layout import Layout
from schemas.metrics import Value
from stages.categories import CATEGORIES

EPSILON = 1e-6


def compare(homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Σ p (log(p + ε) - log(q + ε)), p of the real and q of the generated objects; in all and by room type."""
    types = sorted({room.type for home in real for room in home.rooms})
    values = [_ckl("apartment", _categories(homes), _categories(real))]
    return values + [_ckl(kind, _categories(homes, kind), _categories(real, kind)) for kind in types]


def _categories(homes: Iterable[Layout], kind: str | None = None) -> list[str]:
    found = []
    for home in homes:
        types = {room.id: room.type for room in home.rooms}
        found += [o.category for o in home.objects if kind in (None, types[o.room])]
    return found


def divergence(generated: Iterable[str], real: Iterable[str]) -> float | None:
    """CKL of two lists of categories; None when either is empty."""
    counts = [Counter(generated), Counter(real)]
    names = sorted({*CATEGORIES, *counts[0], *counts[1]})
    q, p = (np.array([count[name] for name in names], float) for count in counts)
    if not q.sum() or not p.sum():
        return None
    q, p = q / q.sum(), p / p.sum()
    return float((p * (np.log(p + EPSILON) - np.log(q + EPSILON))).sum())


def _ckl(of: str, generated: list[str], real: list[str]) -> Value:
    return Value(name="CKL", value=divergence(generated, real), unit="nats", version="published", of=of,
                 n=len(generated))
