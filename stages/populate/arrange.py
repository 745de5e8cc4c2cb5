"""How things are put together on a board: by themselves, in rows, stacks and grids."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from apartgen.stages.populate.boards import Board, Spot
from apartgen.stages.things.small import Design

APART = 0.0015
"""Between books, and between other things in a row or grid that there is no more room for, m."""
FINGERS = 0.012
"""Between things where there is room: what fingers need that take one, m."""
LIFT = 0.0005
"""Things are put down so far above what carries them, m."""
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
    """Things side by side from right to left, as many of them as there is room for, books close together."""
    close = designs[0].kind.rests
    for n in range(len(designs), 0, -1):
        for apart in (APART,) if close else (FINGERS, APART):
            if row := _row(designs[:n], lying, board, where, apart, rng):
                return row
    return []


def _row(
    designs: Sequence[Design], lying: bool, board: Board, where: str, apart: float, rng: np.random.Generator
) -> list[Put]:
    sizes = np.array([design.size_of(lying) for design in designs])
    deep, wide, high = sizes[:, 0].max(), sizes[:, 1].sum() + apart * (len(sizes) - 1), sizes[:, 2].max()
    at = board.claim(deep + 2 * APART, wide + max(AROUND[1], 2 * apart), high, where, rng)
    if at is None:
        return []
    left = at[1] - wide / 2 + np.concatenate([[0.0], np.cumsum(sizes[:-1, 1] + apart)]) + sizes[:, 1] / 2
    edge = (deep - sizes[:, 0]) / 2 * (1 if where == "front" else -1 if where == "back" else 0)
    return [Put(design, lying, board, Spot(float(at[0] + e), float(y), board.place.z + LIFT, 0.0))
            for design, y, e in zip(designs, left, edge)]


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
