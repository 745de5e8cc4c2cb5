"""What windows are made of: bars of frame, posts and sashes about a pane, in several designs; and their handles."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

Corner = tuple[float, float, float]
Box = tuple[Corner, Corner]

FRAME = 0.06
"""Width of a window's frame, m."""
_DEEP = 0.035  # m, half the depth of a frame
_BAR = 0.024  # m, width of a glazing bar
_SASH = 0.05
_PANE_MOST = 1.1  # m, wider windows are divided


class Hole(NamedTuple):
    """The opening in the wall: half its width, its sill, its head, and where the window is on x, m."""

    half: float
    z0: float
    z1: float
    at: float

    def bar(self, y0: float, y1: float, z0: float, z1: float, deep: float = _DEEP, out: float = 0.0) -> Box:
        """A piece of the frame, shifted out into the room."""
        return (self.at - deep + out, y0, z0), (self.at + deep + out, y1, z1)

    def inner(self) -> tuple[float, float, float, float]:
        """What the frame leaves: y0, y1, z0, z1."""
        return -self.half + FRAME, self.half - FRAME, self.z0 + FRAME, self.z1 - FRAME


class Window(NamedTuple):
    """Boxes of frame and sashes, and of the handles on them."""

    bars: list[Box]
    handles: list[Box]


def window(design: str, hole: Hole) -> Window:
    """Frame, posts and what the design adds; nothing for a design that there is not."""
    return DESIGNS.get(design, _single)(hole)


def _frame(hole: Hole, panes: int) -> list[Box]:
    bars = [hole.bar(-hole.half, hole.half, hole.z0, hole.z0 + FRAME),
            hole.bar(-hole.half, hole.half, hole.z1 - FRAME, hole.z1)]
    for k, y in enumerate(np.linspace(-hole.half, hole.half, panes + 1)):
        shift = {0: FRAME / 2, panes: -FRAME / 2}.get(k, 0.0)
        middle = float(y) + shift
        bars.append(hole.bar(middle - FRAME / 2, middle + FRAME / 2, hole.z0 + FRAME, hole.z1 - FRAME))
    return bars


def _panes(hole: Hole, most: float = _PANE_MOST) -> int:
    return max(1, int(np.ceil(2 * hole.half / most)))


def _single(hole: Hole) -> Window:
    return Window(_frame(hole, _panes(hole)), [])


def _casement(hole: Hole) -> Window:
    """Sashes stand out of the frame by a little, each with a handle on its free side."""
    panes = max(_panes(hole, 0.8), 2 if hole.half > 0.4 else 1)
    bars, handles = _frame(hole, panes), []
    edges = np.linspace(-hole.half, hole.half, panes + 1)
    for k, (a, b) in enumerate(zip(edges[:-1].tolist(), edges[1:].tolist())):
        y0, y1 = a + (FRAME if k == 0 else FRAME / 2), b - (FRAME if k == panes - 1 else FRAME / 2)
        z0, z1 = hole.z0 + FRAME, hole.z1 - FRAME
        sides = [(y0, y0 + _SASH, z0, z1), (y1 - _SASH, y1, z0, z1)]
        rails = [(y0 + _SASH, y1 - _SASH, z0, z0 + _SASH), (y0 + _SASH, y1 - _SASH, z1 - _SASH, z1)]
        bars += [hole.bar(*side, out=0.012) for side in (*sides, *rails)]
        y, z, x = (y0 if k % 2 else y1) + (_SASH / 2) * (1 if k % 2 else -1), (z0 + z1) / 2, hole.at + 0.047
        handles.append(((x, y - 0.012, z - 0.03), (x + 0.012, y + 0.012, z + 0.03)))
        handles.append(((x + 0.012, y - 0.008, z - 0.11), (x + 0.026, y + 0.008, z + 0.02)))
    return Window(bars, handles)


def _transom(hole: Hole) -> Window:
    """A bar across at two thirds of the height, posts below it."""
    y0, y1, z0, z1 = hole.inner()
    at = z0 + 0.68 * (z1 - z0)
    bars = _frame(hole, 1)
    for y in np.linspace(-hole.half, hole.half, max(_panes(hole, 0.8), 2) + 1)[1:-1].tolist():
        bars.append(hole.bar(y - FRAME / 2, y + FRAME / 2, z0, at - FRAME / 2))
    return Window([*bars, hole.bar(y0, y1, at - FRAME / 2, at + FRAME / 2)], [])


def _grid(field: float, deep: float) -> Callable[[Hole], Window]:
    """Glazing bars that divide the pane into fields about so wide."""

    def draw(hole: Hole) -> Window:
        y0, y1, z0, z1 = hole.inner()
        bars = _frame(hole, 1)
        levels = np.linspace(z0, z1, max(2, round((z1 - z0) / field)) + 1).tolist()
        for y in np.linspace(y0, y1, max(2, round((y1 - y0) / field)) + 1)[1:-1].tolist():
            bars.append(hole.bar(y - _BAR / 2, y + _BAR / 2, z0, z1, deep))
        bars += [hole.bar(y0, y1, z - _BAR / 2, z + _BAR / 2, deep - 0.001) for z in levels[1:-1]]
        return Window(bars, [])

    return draw


DESIGNS: dict[str, Callable[[Hole], Window]] = {
    "single": _single, "casement": _casement, "transom": _transom, "georgian": _grid(0.36, 0.022),
    "steel": _grid(0.62, 0.028),
}  # fmt: skip
"""What each design adds to a hole."""
