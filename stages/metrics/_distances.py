"""How far two sets of features are apart: Fréchet and kernel distance, and how well a classifier tells them apart.

Sets are (n, d) and (m, d). Each figure comes with the ends of its 95 % bootstrap interval.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.metrics._table import LEVEL, interval
from apartgen.stages.space.boxes import Array

RESAMPLES = 100
SUBSETS, SUBSET = 100, 1000
"""KID is the mean over so many subsets of at most so many scenes, or of half the smaller set."""
REPEATS = 10
"""Classifiers trained, each on another half of the scenes."""
RIDGE = 1.0
"""Weight of the squared coefficients beside the summed log loss, on standardised features."""
LEAST = 4
"""Scenes a side below which nothing is said."""

Sample = NDArray[np.floating]
Weights = NDArray[np.float64]


class Figure(NamedTuple):
    """A distance and the ends of its interval."""

    value: float
    low: float
    high: float


def frechet(a: Sample, b: Sample, rng: np.random.Generator) -> Figure:
    """FID (Heusel et al. 2017): |μ_a - μ_b|² + tr(Σ_a + Σ_b - 2 (Σ_a Σ_b)^½)."""
    x, y = np.asarray(a, float), np.asarray(b, float)
    found = spread(lambda v, w: _frechet(x, y, v, w), (np.ones(len(x)), np.ones(len(y))), rng)
    return found._replace(low=max(found.low, 0.0))


def _frechet(a: Array, b: Array, v: Weights, w: Weights) -> float:
    """Of scenes that count `v` (n,) and `w` (m,) times."""
    (mean_a, root_a), (mean_b, root_b) = _moments(a, v), _moments(b, w)
    # tr (Σ_a Σ_b)^½ is the sum of the singular values of R_a R_bᵀ where Σ = RᵀR: no matrix root is needed.
    product = root_a @ root_b.T
    short = product if len(product) <= product.shape[1] else product.T
    cross = np.sqrt(np.linalg.eigvalsh(short @ short.T).clip(0)).sum()
    return float(((mean_a - mean_b) ** 2).sum() + (root_a**2).sum() + (root_b**2).sum() - 2 * cross)


def _moments(a: Array, weight: Weights) -> tuple[Array, Array]:
    """Mean (d,) and a root R (min(n, d), d) of the covariance."""
    n = weight.sum()
    mean = weight @ a / n
    root = np.sqrt(weight / (n - 1))[:, None] * (a - mean)
    root = root[weight > 0]
    return mean, root if len(root) <= root.shape[1] else np.asarray(np.linalg.qr(root, mode="r"))


def kernel(a: Sample, b: Sample, rng: np.random.Generator) -> Figure:
    """KID (Bińkowski et al. 2018): unbiased MMD² under (xᵀy / d + 1)³, mean over subsets."""
    x, y = np.asarray(a, float), np.asarray(b, float)
    grams = _gram(x, x), _gram(x, y), _gram(y, y)
    size = max(2, min(SUBSET, min(len(a), len(b)) // 2))
    drawn = [(_chosen(len(a), size, rng), _chosen(len(b), size, rng)) for _ in range(SUBSETS)]
    value = float(np.mean([_mmd(grams, v, w) for v, w in drawn]))
    ones = np.ones(len(a)), np.ones(len(b))
    whole = spread(lambda v, w: _mmd(grams, v, w), ones, rng)
    return Figure(value, value + whole.low - whole.value, value + whole.high - whole.value)


def _gram(a: Array, b: Array) -> Array:
    return np.asarray((a @ b.T / a.shape[1] + 1) ** 3)


def _chosen(n: int, size: int, rng: np.random.Generator) -> Weights:
    weight = np.zeros(n)
    weight[rng.choice(n, size, replace=False)] = 1
    return weight


def _mmd(grams: tuple[Array, Array, Array], v: Weights, w: Weights) -> float:
    aa, ab, bb = grams
    n, m = v.sum(), w.sum()
    within = [(u @ g @ u - u @ np.diag(g)) / (k * (k - 1)) for u, g, k in ((v, aa, n), (w, bb, m))]
    return float(sum(within) - 2 * (v @ ab @ w) / (n * m))


def spread(
    figure: Callable[[Weights, Weights], float], ones: tuple[Weights, Weights], rng: np.random.Generator
) -> Figure:
    """A figure of scenes that count so many times, with how far resamples scatter about their own mean.

    Scenes that a resample repeats raise a distance by themselves, so the interval is laid about the figure.
    """
    value = figure(*ones)
    drawn = [figure(*(rng.multinomial(len(o), o / len(o)).astype(float) for o in ones)) for _ in range(RESAMPLES)]
    low, high = np.quantile(np.array(drawn) - np.mean(drawn), [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return Figure(value, value + float(low), value + float(high))


def separability(a: Sample, b: Sample, rng: np.random.Generator) -> Figure:
    """SCA (Ritchie et al. 2019), %: how often a linear classifier tells the sets apart; 50 is best, 100 worst.

    Anew `REPEATS` times, it learns from half the scenes of either set and is asked about the others; equally many of
    either set are taken. The interval is over scenes.
    """
    n = min(len(a), len(b))
    asked, right = np.zeros(len(a) + len(b)), np.zeros(len(a) + len(b))
    both, label = np.concatenate([a, b]).astype(float), np.repeat([1.0, -1.0], [len(a), len(b)])
    for lane in rng.spawn(REPEATS):
        mine, theirs = lane.permutation(len(a))[:n], len(a) + lane.permutation(len(b))[:n]
        train, test = np.r_[mine[: n // 2], theirs[: n // 2]], np.r_[mine[n // 2 :], theirs[n // 2 :]]
        score = _trained(both[train], label[train])(both[test])
        asked[test] += 1
        right[test] += (score * label[test] > 0) + 0.5 * (score == 0)
    told = asked > 0
    return Figure(*interval(np.stack([100 * right[told] / asked[told], asked[told]], -1), rng))


def _trained(x: Array, label: Array) -> Callable[[Array], Array]:
    """Scores of a logistic regression on standardised features (n, d), labels ±1 (n,)."""
    from scipy import optimize, special

    mean, scale = x.mean(0), x.std(0) + 1e-9
    z = (x - mean) / scale

    def loss(w: Array) -> tuple[float, Array]:
        margin = label * (z @ w[1:] + w[0])
        pull = -label * special.expit(-margin)
        value = np.logaddexp(0, -margin).sum() + RIDGE / 2 * w[1:] @ w[1:]
        return float(value), np.r_[pull.sum(), z.T @ pull + RIDGE * w[1:]]

    w = optimize.minimize(loss, np.zeros(x.shape[1] + 1), jac=True, method="L-BFGS-B", options={"maxiter": 200}).x
    return lambda x: np.asarray((x - mean) / scale @ w[1:] + w[0])
