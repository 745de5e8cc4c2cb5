"""How things are put together on a board: by themselves, in rows, stacks and grids."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from apartgen.stages.populate.boards import Array, Board, Spot
from apartgen.stages.things.small import Design

APART = 0.0015
"""Between books, and between other things in a row or grid that there is no more room for, m."""
FINGERS = 0.012
"""Between things where there is room: what fingers need that take one, m."""
STANDS_OUT = (0.025, 0.04)
"""So far before its neighbours stands a book that stands out for fingers, m."""
LIFT = 0.0005
"""Things are put down so far above what carries them, m."""
RIM = 0.86
"""The share of a tray, in depth and in width, that things lie on."""
AROUND = (2 * FINGERS, 0.008)
"""Between a thing by itself and the next one, m: where there is room, and where there is less."""


class Put(NamedTuple):
    """A thing on a board; `under` is the row of what it stands on among those that were put with it, -1 the board."""

    design: Design
    lying: bool
    board: Board
    spot: Spot
    under: int = -1


def one(design: Design, lying: bool, board: Board, where: str, turned: float, rng: np.random.Generator) -> list[Put]:
    """A thing by itself, turned by up to so much."""
    d, w, h = design.size_of(lying)
    yaw = float(rng.uniform(-turned, turned)) if turned else 0.0
    c, s = abs(np.cos(yaw)), abs(np.sin(yaw))
    dx, dy = (d * c + w * s, d * s + w * c) if d != w or not design.kind.round else (d, w)
    at = _claimed(board, dx, dy, h, where, rng)
    return [] if at is None else [Put(design, lying, board, Spot(*at, board.place.z + LIFT, yaw))]


def _claimed(
    board: Board, dx: float, dy: float, h: float, where: str, rng: np.random.Generator
) -> tuple[float, float] | None:
    """The middle of a free rectangle with room about it, with little where there is no other."""
    found = (board.claim(dx + around, dy + around, h, where, rng) for around in AROUND)
    return next((at for at in found if at is not None), None)


def row(designs: Sequence[Design], lying: bool, board: Board, where: str, rng: np.random.Generator) -> list[Put]:
    """Things side by side from right to left, as many as there is room for, books close together and, where there is
    depth, some of them further out.
    """
    close = designs[0].kind.rests
    out = _standing_out(len(designs), rng) if close else np.zeros(len(designs))
    for n in range(len(designs), 0, -1):
        for apart, so_far in ((APART, out), (APART, 0 * out)) if close else ((FINGERS, out), (APART, out)):
            if row := _row(designs[:n], lying, board, where, apart, so_far[:n], rng):
                return row
    return []


def _standing_out(n: int, rng: np.random.Generator) -> Array:
    """How far before its neighbours each book of a row stands, m: every second or third of them does."""
    chosen = np.cumsum([rng.integers(0, 2), *rng.integers(2, 4, n)])
    return np.where(np.isin(np.arange(n), chosen), rng.uniform(*STANDS_OUT, n), 0.0)


def _row(
    designs: Sequence[Design], lying: bool, board: Board, where: str, apart: float, out: Array,
    rng: np.random.Generator,
) -> list[Put]:
    sizes = np.array([design.size_of(lying) for design in designs])
    fronts = _fronts(sizes[:, 0], where, out)
    deep, wide, high = fronts.max(), sizes[:, 1].sum() + apart * (len(sizes) - 1), sizes[:, 2].max()
    at = board.claim(deep + 2 * APART, wide + max(AROUND[1], 2 * apart), high, where, rng)
    if at is None:
        return []
    left = at[1] - wide / 2 + np.concatenate([[0.0], np.cumsum(sizes[:-1, 1] + apart)]) + sizes[:, 1] / 2
    middle = at[0] - deep / 2 + fronts - sizes[:, 0] / 2
    return [Put(design, lying, board, Spot(float(x), float(y), board.place.z + LIFT, 0.0))
            for design, x, y in zip(designs, middle, left)]


def _fronts(depths: Array, where: str, out: Array) -> Array:
    """How far from the back of a row the front of each thing is, m: their fronts, backs or middles in one line, but for
    those that stand `out` so far before what is beside them.
    """
    free = depths.max() - depths
    line = depths + free * (1.0 if where == "front" else 0.0 if where == "back" else 0.5)
    beside = np.maximum(np.append(0.0, line[:-1]), np.append(line[1:], 0.0))
    return np.asarray(np.where(out > 0, np.maximum(line, beside + out), line), np.float64)


def grid(designs: Sequence[Design], lying: bool, board: Board, where: str, rng: np.random.Generator) -> list[Put]:
    """Things in rows behind each other, as many of them as there is room for."""
    for n in range(len(designs), 0, -1):
        across = min(n, int(np.ceil(np.sqrt(n))) + int(rng.integers(0, 2)))
        for apart in (FINGERS, 2 * APART):
            if grid := _grid(designs[:n], lying, board, where, across, apart, rng):
                return grid
    return []


def _grid(
    designs: Sequence[Design], lying: bool, board: Board, where: str, across: int, apart: float,
    rng: np.random.Generator,
) -> list[Put]:
    rows = -(-len(designs) // across)
    d, w, h = np.array([design.size_of(lying) for design in designs]).max(0) + [apart, apart, 0.0]
    at = board.claim(d * rows, w * across + apart, h, where, rng)
    if at is None:
        return []
    i = np.arange(len(designs))
    x = at[0] + (i // across - (rows - 1) / 2) * d
    y = at[1] + (i % across - (across - 1) / 2) * w
    return [Put(design, lying, board, Spot(float(a), float(b), board.place.z + LIFT, 0.0))
            for design, a, b in zip(designs, x, y)]


def stack(
    designs: Sequence[Design], lying: bool, board: Board, where: str, turned: float, rng: np.random.Generator
) -> list[Put]:
    """Things on top of each other, the largest below, as many as there is height for."""
    ordered = sorted(designs, key=lambda design: -design.size_of(lying)[0] * design.size_of(lying)[1])
    for n in range(len(ordered), 0, -1):
        sizes = np.array([design.size_of(lying) for design in ordered[:n]])
        pitch = np.array([design.kind.pitch for design in ordered[:n]]) * sizes[:, 2] + LIFT
        bottoms = np.concatenate([[0.0], np.cumsum(pitch)[:-1]]) + LIFT
        yaw = float(rng.uniform(-turned, turned))
        turns = yaw + np.where(np.arange(n) > 0, rng.uniform(-0.05, 0.05, n), 0.0)
        c, s = np.abs(np.cos(turns)), np.abs(np.sin(turns))
        dx, dy = (sizes[:, 0] * c + sizes[:, 1] * s).max(), (sizes[:, 0] * s + sizes[:, 1] * c).max()
        at = _claimed(board, float(dx), float(dy), float((bottoms + sizes[:, 2]).max()), where, rng)
        if at is not None:
            return [Put(design, lying, board, Spot(*at, float(board.place.z + z), float(t)), k - 1)
                    for k, (design, z, t) in enumerate(zip(ordered[:n], bottoms, turns))]
    return []


def dished(
    dish: Design, designs: Sequence[Design], board: Board, where: str, turned: float, rng: np.random.Generator
) -> list[Put]:
    """A tray or a board with things beside each other on it, as many of them as there is room for."""
    d, w, h = dish.size
    sizes = np.array([design.size for design in designs])
    low, yaw = dish.kind.bears * h + LIFT, float(rng.uniform(-turned, turned))
    c, s = np.cos(yaw), np.sin(yaw)
    for n in range(len(designs), 0, -1):
        spots = _beside(sizes[:n].max(0), n, (RIM * d, RIM * w))
        if not len(spots):
            continue
        dx, dy = d * abs(c) + w * abs(s), d * abs(s) + w * abs(c)
        at = _claimed(board, dx, dy, max(h, low + float(sizes[:n, 2].max())) + LIFT, where, rng)
        if at is None:
            return []
        x, y = (spots @ [[c, s], [-s, c]] + at).T
        z = board.place.z + LIFT
        return [Put(dish, False, board, Spot(*at, z, yaw)), *(
            Put(design, False, board, Spot(float(a), float(b), z + low, yaw), 0)
            for design, a, b in zip(designs, x, y))]
    return []


def _beside(size: Array, n: int, room: tuple[float, float]) -> Array:
    """The middles (n, 2) of so many things beside each other about the middle of a room, (0, 2) if they don't fit."""
    step = size[:2] + FINGERS
    across = min(n, max(int((room[1] + FINGERS) / step[1]), 1))
    rows = -(-n // across)
    if rows * step[0] - FINGERS > room[0] or across * step[1] - FINGERS > room[1]:
        return np.zeros((0, 2))
    i = np.arange(n)
    return np.stack([i // across - (rows - 1) / 2, i % across - (across - 1) / 2], 1) * step
