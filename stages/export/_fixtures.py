"""Plan symbols of cabinets, kitchens and bathrooms; the same contract as `_symbols`."""

import numpy as np

from apartgen.stages.export._pen import FAINT, PAPER, STEEL, WATER, WOOD, Pen


def cabinet(pen: Pen, d: float, w: float, fill: str = WOOD, doors: float = 0.0) -> None:
    """A box with its fronts as a double line, divided every `doors` metres."""
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, fill)
    front = d / 2 - 0.025
    pen.line((front, -w / 2), (front, w / 2))
    if doors:
        for y in np.linspace(-w / 2, w / 2, max(1, round(w / doors)) + 1)[1:-1]:
            pen.line((front, y), (d / 2, y))


def sink(pen: Pen, d: float, w: float) -> None:
    """A kitchen sink with its drainer."""
    cabinet(pen, d, w, STEEL, 0.4)
    bowl = min(0.5, 0.6 * w)
    pen.rect(-d / 2 + 0.13, d / 2 - 0.09, -w / 2 + 0.07, -w / 2 + 0.07 + bowl, WATER, 0.06)
    middle = -w / 2 + 0.07 + bowl / 2
    pen.oval(0.02, middle, 0.03, 0.03)
    pen.line((-d / 2 + 0.06, middle), (-d / 2 + 0.24, middle), width=1.1)
    for y in np.arange(-w / 2 + 0.14 + bowl, w / 2 - 0.05, 0.045):
        pen.line((-d / 2 + 0.16, y), (d / 2 - 0.12, y), ink=FAINT)


def rings(pen: Pen, d: float, w: float, knobs: bool = False) -> None:
    """A hob, with knobs when it is a cooker."""
    cabinet(pen, d, w, STEEL)
    pen.rect(-d / 2 + 0.06, d / 2 - 0.08, -w / 2 + 0.03, w / 2 - 0.03, PAPER, 0.02)
    for x, y, r in ((-0.13, -0.14, 0.085), (0.11, -0.14, 0.07), (-0.13, 0.14, 0.07), (0.11, 0.14, 0.085)):
        pen.oval(x * d / 0.6 - 0.01, y * w / 0.6, r, r)
        pen.oval(x * d / 0.6 - 0.01, y * w / 0.6, r / 2, r / 2, None, FAINT)
    for y in np.linspace(-w / 4, w / 4, 5) if knobs else ():
        pen.oval(d / 2 - 0.05, y, 0.014, 0.014)


def marked(pen: Pen, d: float, w: float, word: str, drum: bool = False, fill: str = PAPER) -> None:
    """An appliance: a box with its letters, and a drum."""
    cabinet(pen, d, w, fill)
    if drum:
        pen.oval(0, 0, 0.36 * min(d, w), 0.36 * min(d, w), None, FAINT)
    pen.word(-0.01, 0, word)


def fridge(pen: Pen, d: float, w: float) -> None:
    """A fridge, crossed."""
    cabinet(pen, d, w, PAPER)
    pen.line((-d / 2, -w / 2), (d / 2 - 0.025, w / 2), ink=FAINT)
    pen.line((-d / 2, w / 2), (d / 2 - 0.025, -w / 2), ink=FAINT)


def toilet(pen: Pen, d: float, w: float) -> None:
    """Cistern and bowl."""
    tank = min(0.2, 0.3 * d)
    pen.rect(-d / 2, -d / 2 + tank, -w / 2, w / 2, PAPER, 0.03)
    middle, long = tank / 2 - 0.01, (d - tank) / 2 + 0.01
    pen.oval(middle, 0, long, 0.46 * w, PAPER)
    pen.oval(middle + 0.02, 0, long - 0.07, 0.33 * w, WATER)


def basin(pen: Pen, d: float, w: float) -> None:
    """One or two washbasins in a cabinet."""
    cabinet(pen, d, w, PAPER, 0.5)
    basins = 2 if w > 1.25 else 1
    for k in range(basins):
        y = (k + 0.5) * w / basins - w / 2
        pen.oval(0.03, y, 0.32 * d, min(0.26, 0.38 * w / basins), WATER)
        pen.oval(0.03, y, 0.02, 0.02)
        pen.line((-d / 2 + 0.05, y), (-d / 2 + 0.17, y), width=1.1)


def bath(pen: Pen, d: float, w: float) -> None:
    """A bath with its drain and tap."""
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, PAPER, 0.03)
    pen.rect(-d / 2 + 0.07, d / 2 - 0.07, -w / 2 + 0.09, w / 2 - 0.07, WATER, 0.22)
    pen.oval(0, -w / 2 + 0.26, 0.03, 0.03)
    pen.line((0, -w / 2 + 0.03), (0, -w / 2 + 0.16), width=1.1)


def shower(pen: Pen, d: float, w: float) -> None:
    """A shower tray falling to its drain."""
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WATER)
    pen.rect(-d / 2 + 0.04, d / 2 - 0.04, -w / 2 + 0.04, w / 2 - 0.04, None)
    for a, b in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        pen.line((a * (d / 2 - 0.04), b * (w / 2 - 0.04)), (0, 0), ink=FAINT)
    pen.oval(0, 0, 0.05, 0.05, PAPER)


def heater(pen: Pen, d: float, w: float) -> None:
    """A round water heater."""
    pen.oval(0, 0, d / 2, w / 2, PAPER)
    pen.word(0, 0, "WH")
