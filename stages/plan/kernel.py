"""Simulated annealing over slicing trees, compiled."""

from pathlib import Path
from typing import Protocol
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from apartgen.stages.compiling import compiled
from apartgen.stages.plan.slicing import (
    COMPILED,
    EPS,
    L_LONG,
    L_SHORT,
    LACKING,
    LEFT,
    R_AREA,
    RIGHT,
    S_TARGET,
    UPRIGHT,
    Floats,
    Problem,
    Scratch,
    Tree,
    inner,
)
from apartgen.stages.plan.terms import evaluate

Seed = NDArray[np.uint64]
LOOKS = ((0.15, 0.3), (0.3, 0.15), (0.5, 0.06))
"""Shares of the steps after which a run is given up if the best state lacks more than so much a room, m.

Of 3000 runs each of four common flats, one look at .35 for .15 takes 1.4 times the steps a valid plan."""


@inner
def _random(state: Seed) -> float:
    x = state[0]
    x ^= x << np.uint64(13)
    x ^= x >> np.uint64(7)
    x ^= x << np.uint64(17)
    state[0] = x
    return float(x >> np.uint64(11)) / 9007199254740992.0


@inner
def _replace(t: Tree, old: int, new: int) -> None:
    # hang `new` where `old` hung
    last = t.nodes.shape[0] - 1
    if t.nodes[last, 0] == old:
        t.nodes[last, 0] = new
    for node in range(t.share.shape[0] - 1, last):
        if node != new:
            if t.nodes[node, LEFT] == old:
                t.nodes[node, LEFT] = new
            elif t.nodes[node, RIGHT] == old:
                t.nodes[node, RIGHT] = new


@inner
def _regraft(t: Tree, leaf: int, onto: int, upright: int, before: bool) -> bool:
    # move a leaf beside another node; whether that changes anything
    up = leaf  # an int64 at once: of a literal, `_replace` would be compiled anew
    for node in range(t.share.shape[0] - 1, t.nodes.shape[0] - 1):
        if t.nodes[node, LEFT] == leaf or t.nodes[node, RIGHT] == leaf:
            up = node
    if onto == leaf or onto == up:
        return False
    _replace(t, up, t.nodes[up, RIGHT] if t.nodes[up, LEFT] == leaf else t.nodes[up, LEFT])
    _replace(t, onto, up)
    t.nodes[up, LEFT], t.nodes[up, RIGHT] = (leaf, onto) if before else (onto, leaf)
    t.nodes[up, UPRIGHT] = upright
    return True


@inner
def _propose(p: Problem, t: Tree, area: Floats, rng: Seed) -> bool:
    # change a state; whether it is another one now
    leaves = t.share.shape[0] - 1
    move, u = _random(rng), _random(rng)
    i, j = int(_random(rng) * leaves), int(_random(rng) * leaves)
    cut = leaves + int(u * (leaves - 1))
    changed = True
    if move < 0.25:
        changed = i != j
        t.nodes[i, 0], t.nodes[j, 0] = t.nodes[j, 0], t.nodes[i, 0]
        t.share[i], t.share[j] = t.share[j], t.share[i]
    elif move < 0.33:
        t.nodes[cut, UPRIGHT] = 1 - t.nodes[cut, UPRIGHT]
    elif move < 0.40:
        t.nodes[cut, LEFT], t.nodes[cut, RIGHT] = t.nodes[cut, RIGHT], t.nodes[cut, LEFT]
    elif move < 0.68:
        changed = _regraft(t, i, int(u * (2 * leaves - 1)), int(_random(rng) * 2), _random(rng) < 0.5)
    elif move < 0.84:
        t.share[i] *= np.exp(0.5 * (u + _random(rng) - 1))
    elif move < 0.95:  # towards the wanted areas
        for leaf in range(leaves):
            ratio = p.spec[t.nodes[leaf, 0], S_TARGET] / max(area[t.nodes[leaf, 0]], 0.2)
            t.share[leaf] *= min(max(ratio, 0.7), 1.4)
    else:
        before = t.share[leaves]
        t.share[leaves] = min(max(before * np.exp(0.12 * (u - 0.5)), p.limits[L_SHORT]), p.limits[L_LONG])
        changed = t.share[leaves] != before
    return changed


@inner
def _copy(a: Tree, b: Tree) -> None:
    for i in range(a.nodes.shape[0]):
        for j in range(3):
            b.nodes[i, j] = a.nodes[i, j]
    for i in range(a.share.shape[0]):
        b.share[i] = a.share[i]


def _stamp() -> int:
    """Changes with the sources that `anneal` is compiled from."""
    sources = ("slicing.py", "measured.py", "wished.py", "terms.py", "kernel.py")
    return crc32(b"".join((Path(__file__).parent / name).read_bytes() for name in sources))


class Anneal(Protocol):
    """Anneal the tree `t` in place for the problem `p`.

    Leaves in `best` the cheapest state that lacks nothing, else the cheapest, its measures in `z`; returns its cost.
    A run that still lacks much at one of `LOOKS` ends there.
    `new` is room for a state, `rng` a (1,) seed, not 0; the temperature falls geometrically from `hot` to `cold`.
    """

    def __call__(self, p: Problem, t: Tree, new: Tree, best: Tree, z: Scratch, rng: Seed, steps: int, hot: float,
                 cold: float) -> float:
        """The cost."""


def _compiled(stamp: int) -> Anneal:
    # numba's cache of a function sees changes in its own file only; a captured value is part of the key, too.
    def anneal(p: Problem, t: Tree, new: Tree, best: Tree, z: Scratch, rng: Seed, steps: int, hot: float,
               cold: float) -> float:
        cost = low = lack = np.inf
        valid, temperature, cooling, last = stamp < 0, hot, (cold / hot) ** (1 / steps), steps
        for step in range(steps + 2):  # the first looks at the start
            for look, most in LOOKS:
                if step == 1 + int(look * steps) and lack > most * p.spec.shape[0]:
                    last = min(last, step - 1)
            bar = np.inf
            _copy(best if step > last else t, new)
            if 0 < step <= last:
                temperature *= cooling
                bar = cost - temperature * np.log(1 - _random(rng))
                if new.share.shape[0] > 2 and not _propose(p, new, z.area, rng):
                    continue
            tried = evaluate(p, new, z, bar)
            if step > last:  # `z` holds the best
                break
            if tried > bar:
                continue
            _copy(new, t)
            cost = tried
            for r in range(z.area.shape[0]):
                z.area[r] = z.room[r, R_AREA]
            ok = z.terms[LACKING] < EPS
            if (ok and not valid) or (ok == valid and tried < low):
                low, lack, valid = tried, z.terms[LACKING], ok
                _copy(t, best)
        return low

    return compiled(**COMPILED, no_cfunc_wrapper=True)(anneal)


anneal = _compiled(_stamp())
