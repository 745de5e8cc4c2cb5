"""Plan symbols of furniture: what each category looks like from above, drawn to its size.

A symbol is `draw(pen, d, w)` in the object's frame: depth `d` along x with the front at +d/2, width `w` along y.
"""

from collections.abc import Callable
from functools import partial

import numpy as np

from apartgen.stages.export import _fixtures
from apartgen.stages.export._pen import CLOTH, DARK, FAINT, GREEN, LEAF, PAPER, STEEL, WOOD, Pen
from apartgen.stages.things import chaises
from apartgen.stages.things.categories import TABLE

Symbol = Callable[[Pen, float, float], None]


def _bed(pen: Pen, d: float, w: float, pillows: int = 2) -> None:
    back, half = -d / 2, w / 2
    pen.rect(back, d / 2, -half, half, WOOD, 0.03)
    pen.rect(back + 0.07, d / 2 - 0.02, -half + 0.03, half - 0.03, PAPER, 0.05)
    wide = (w - 0.16) / pillows
    for k in range(pillows):
        y = -half + 0.08 + k * wide
        pen.rect(back + 0.12, back + 0.50, y + 0.03, y + wide - 0.03, PAPER, 0.09)
    fold = back + 0.62
    pen.rect(fold, d / 2 - 0.02, -half + 0.02, half - 0.02, CLOTH, 0.05)
    pen.line((fold + 0.16, -half + 0.02), (fold + 0.16, half - 0.02), ink=FAINT)
    pen.line((fold + 0.16, half - 0.5), (d / 2 - 0.35, half - 0.02), ink=FAINT)


def _bunk(pen: Pen, d: float, w: float) -> None:
    _bed(pen, d, w, 1)
    pen.line((-d / 2, -w / 2), (d / 2, w / 2), ink=FAINT, dashed=True)


def _cot(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD, 0.02)
    pen.rect(-d / 2 + 0.05, d / 2 - 0.05, -w / 2 + 0.05, w / 2 - 0.05, PAPER, 0.03)
    pen.rect(-d / 2 + 0.1, -d / 2 + 0.3, -w / 2 + 0.12, w / 2 - 0.12, PAPER, 0.06)


def _wardrobe(pen: Pen, d: float, w: float, sliding: bool = False) -> None:
    _fixtures.cabinet(pen, d, w, WOOD, 0 if sliding else 0.5)
    pen.line((-0.02, -w / 2 + 0.04), (-0.02, w / 2 - 0.04), ink=FAINT)
    for k, y in enumerate(np.arange(-w / 2 + 0.1, w / 2 - 0.06, 0.09)):
        lean = 0.02 * ((k * 7) % 5 - 2) / 2
        pen.line((-0.02 - 0.2 * min(1, d), y - lean), (-0.02 + 0.2 * min(1, d), y + lean), ink=FAINT)
    if sliding:
        pen.line((d / 2 - 0.055, -0.05), (d / 2 - 0.055, w / 2))


def _shelves(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD)
    for y in np.linspace(-w / 2, w / 2, max(1, round(w / 0.45)) + 1)[1:-1]:
        pen.line((-d / 2, y), (d / 2, y))
    pen.line((-d / 2, -w / 2), (d / 2, w / 2), ink=FAINT)


def _desk(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD, 0.02)
    pen.rect(-d / 2 + 0.06, d / 2 - 0.04, w / 2 - min(0.42, w / 3), w / 2 - 0.04, None, ink=FAINT, dashed=True)


def _table(pen: Pen, d: float, w: float, r: float = 0.04) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD, r)
    pen.rect(-d / 2 + 0.05, d / 2 - 0.05, -w / 2 + 0.05, w / 2 - 0.05, None, r, FAINT)


def _round(pen: Pen, d: float, w: float) -> None:
    pen.oval(0, 0, d / 2, w / 2, WOOD)
    pen.oval(0, 0, d / 2 - 0.05, w / 2 - 0.05, None, FAINT)


def _chair(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2 + 0.05, d / 2, -w / 2 + 0.02, w / 2 - 0.02, PAPER, 0.07)
    pen.rect(-d / 2, -d / 2 + 0.07, -w / 2, w / 2, WOOD, 0.035)


def _office_chair(pen: Pen, d: float, w: float) -> None:
    for angle in np.radians(np.arange(18, 378, 72)):
        pen.line((0, 0), (0.48 * d * np.cos(angle), 0.48 * w * np.sin(angle)), ink=FAINT)
    pen.rect(-d / 3, d / 3, -w / 3, w / 3, CLOTH, 0.1)
    pen.rect(-d / 2, -d / 2 + 0.09, -w / 3, w / 3, CLOTH, 0.045)


def _stool(pen: Pen, d: float, w: float) -> None:
    pen.oval(0, 0, d / 2, w / 2, PAPER)
    pen.oval(0, 0, d / 2 - 0.04, w / 2 - 0.04, None, FAINT)


def _sofa(pen: Pen, d: float, w: float) -> None:
    back, arm = 0.22 * d, min(0.2, 0.14 * w + 0.03)
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, CLOTH, 0.06)
    pen.rect(-d / 2, -d / 2 + back, -w / 2, w / 2, CLOTH, 0.05)
    for y0, y1 in ((-w / 2, -w / 2 + arm), (w / 2 - arm, w / 2)):
        pen.rect(-d / 2 + 0.02, d / 2 - 0.02, y0, y1, CLOTH, 0.06)
    seats = max(1, round((w - 2 * arm) / 0.72))
    wide = (w - 2 * arm) / seats
    for k in range(seats):
        y = -w / 2 + arm + k * wide
        pen.rect(-d / 2 + back, d / 2, y, y + wide, PAPER, 0.05)


def _corner_sofa(pen: Pen, d: float, w: float) -> None:
    """Seats along the back, and a chaise on the left that comes to the front."""
    back, arm, chaise = 0.2, 0.16, chaises.chaise_width(w)
    x1 = -d / 2 + chaises.seat_depth(d)
    y1 = w / 2 - chaise
    pen.shape([(-d / 2, -w / 2), (x1, -w / 2), (x1, y1), (d / 2, y1), (d / 2, w / 2), (-d / 2, w / 2)], CLOTH)
    pen.rect(-d / 2, -d / 2 + back, -w / 2, w / 2, CLOTH, 0.05)
    pen.rect(-d / 2 + 0.02, x1, -w / 2, -w / 2 + arm, CLOTH, 0.05)
    wide = (w - chaise - arm) / max(1, round((w - chaise - arm) / 0.75))
    for y in np.arange(-w / 2 + arm, w / 2 - chaise - 0.1, wide):
        pen.rect(-d / 2 + back, x1, y, y + wide, PAPER, 0.05)
    pen.rect(-d / 2 + back, d / 2, w / 2 - chaise, w / 2 - 0.02, PAPER, 0.05)


def _cushion(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, CLOTH, 0.12)
    pen.rect(-d / 2 + 0.06, d / 2 - 0.06, -w / 2 + 0.06, w / 2 - 0.06, None, 0.08, FAINT)


def _slats(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD, 0.02)
    for x in np.linspace(-d / 2, d / 2, 5)[1:-1]:
        pen.line((x, -w / 2 + 0.02), (x, w / 2 - 0.02), ink=FAINT)


def _screen(pen: Pen, d: float, w: float) -> None:
    pen.rect(-min(0.1, d / 3), min(0.1, d / 3), -w / 6, w / 6, STEEL)
    pen.rect(-0.025, 0.025, -w / 2, w / 2, DARK, 0.01)


def _above(pen: Pen, d: float, w: float) -> None:
    """What hangs above the cut: a dashed outline."""
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, None, dashed=True, ink=FAINT)


def _strip(pen: Pen, d: float, w: float, fill: str = STEEL) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, fill)


def _radiator(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, PAPER)
    for y in np.arange(-w / 2 + 0.06, w / 2, 0.06):
        pen.line((-d / 2, y), (d / 2, y), ink=FAINT)


def _bin(pen: Pen, d: float, w: float) -> None:
    pen.oval(0, 0, d / 2, w / 2, STEEL)
    pen.oval(0, 0, d / 3, w / 3, None, FAINT)


def _basket(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD, 0.05)
    for y in np.linspace(-w / 2, w / 2, 6)[1:-1]:
        pen.line((-d / 2 + 0.02, y), (d / 2 - 0.02, y), ink=FAINT)


def _lamp(pen: Pen, d: float, w: float, above: bool = False) -> None:
    r = min(d, w) / 2
    r = min(r, 0.2) if above else r
    pen.oval(0, 0, r, r, None if above else PAPER, FAINT if above else "#4a4744", dashed=above)
    for a in (0, np.pi / 2):
        x, y = 0.75 * r * np.cos(a + np.pi / 4), 0.75 * r * np.sin(a + np.pi / 4)
        pen.line((-x, -y), (x, y), ink=FAINT)


def _wall_lamp(pen: Pen, d: float, w: float) -> None:
    angles = np.linspace(-np.pi / 2, np.pi / 2, 13)
    pen.shape([(-d / 2 + d * np.cos(a), w / 2 * np.sin(a)) for a in angles], PAPER)


def _plant(pen: Pen, d: float, w: float) -> None:
    for k in range(9):
        a = 2 * np.pi * k / 9 + 0.35 * (k % 2)
        reach = 0.5 - 0.09 * (k % 3)
        t = np.linspace(0, 1, 12)
        width = 0.2 * np.sin(np.pi * t) * reach
        along = np.concatenate([t, t[::-1]]) * reach
        across = np.concatenate([width, -width[::-1]])
        points = np.stack([along * np.cos(a) - across * np.sin(a), along * np.sin(a) + across * np.cos(a)], 1)
        pen.shape(points * [d, w], GREEN, LEAF)
    pen.oval(0, 0, 0.09 * d, 0.09 * w, GREEN, LEAF)


def _planter(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, WOOD)
    for y in np.arange(-w / 2 + 0.12, w / 2 - 0.05, 0.16):
        pen.oval(0, y, 0.36 * d, 0.09, GREEN, LEAF)


def _rug(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2, -w / 2, w / 2, "#f2ede4", ink=FAINT)
    for inset in (0.07, 0.11):
        pen.rect(-d / 2 + inset, d / 2 - inset, -w / 2 + inset, w / 2 - inset, None, ink="#c9c0b2")


def _curtain(pen: Pen, d: float, w: float) -> None:
    for side in (-1, 1):
        y = np.linspace(w / 2, 0.28 * w, 40) * side
        x = 0.32 * d * np.sin(np.arange(40) * 1.1)
        pen.line(*zip(x.tolist(), y.tolist(), strict=True), ink=FAINT)


def _coat_rack(pen: Pen, d: float, w: float) -> None:
    pen.oval(0, 0, 0.3 * d, 0.3 * w, PAPER)
    for a in np.arange(0, 2 * np.pi, np.pi / 3):
        pen.line((0, 0), (0.46 * d * np.cos(a), 0.46 * w * np.sin(a)))


def _board(pen: Pen, d: float, w: float) -> None:
    pen.shape([(-d / 2, -w / 2), (d / 2, -w / 2), (d / 2, 0.2 * w), (0.12 * d, w / 2), (-0.12 * d, w / 2),
               (-d / 2, 0.2 * w)], CLOTH)


def _piano(pen: Pen, d: float, w: float) -> None:
    pen.rect(-d / 2, d / 2 - 0.16, -w / 2, w / 2, DARK)
    pen.rect(d / 2 - 0.2, d / 2, -w / 2 + 0.04, w / 2 - 0.04, PAPER)
    for y in np.linspace(-w / 2 + 0.04, w / 2 - 0.04, 30)[1:-1]:
        pen.line((d / 2 - 0.2, y), (d / 2, y), ink=FAINT, width=0.3)


SYMBOLS: dict[str, Symbol] = {
    "": partial(_fixtures.cabinet, doors=0.5), "steel cabinet": partial(_fixtures.cabinet, fill=STEEL),
    "bed": _bed, "bed with one pillow": partial(_bed, pillows=1), "bunk": _bunk, "barred bed": _cot,
    "clothes": _wardrobe, "clothes behind doors": partial(_wardrobe, sliding=True), "shelves": _shelves,
    "worktop": _desk, "table": _table, "rounded table": partial(_table, r=0.08), "round table": _round,
    "seat": _chair, "seat on wheels": _office_chair, "round seat": _stool, "seats": _sofa,
    "seats round a corner": _corner_sofa, "cushion": _cushion, "slats": _slats, "screen": _screen,
    "sink": _fixtures.sink, "rings": _fixtures.rings, "rings and knobs": partial(_fixtures.rings, knobs=True),
    "double doors": _fixtures.fridge, "DW": partial(_fixtures.marked, word="DW"),
    "MW": partial(_fixtures.marked, word="MW"), "WM": partial(_fixtures.marked, word="WM", drum=True),
    "TD": partial(_fixtures.marked, word="TD", drum=True), "OV": partial(_fixtures.marked, word="OV", fill=STEEL),
    "outline": _above, "bowl and cistern": _fixtures.toilet, "basin": _fixtures.basin, "tub": _fixtures.bath,
    "tray": _fixtures.shower, "strip": _strip, "ribs": _radiator, "pail": _bin, "basket": _basket,
    "round lamp": _lamp, "lamp above": partial(_lamp, above=True), "half a lamp": _wall_lamp, "leaves": _plant,
    "row of leaves": _planter, "border": _rug, "folds": _curtain, "hooks": _coat_rack, "board": _board,
    "keys": _piano, "tank": _fixtures.heater,
}  # fmt: skip
"""By what `categories.toml` calls it; a cabinet where it says nothing."""
FITTED = "OV"
"""Of an oven between kitchen units."""


def draw(pen: Pen, category: str, d: float, w: float, fitted: bool = False) -> None:
    """The category's symbol at its size; a cabinet for those without one of their own."""
    symbol = FITTED if fitted else TABLE[category].symbol if category in TABLE else ""
    SYMBOLS.get(symbol, SYMBOLS[""])(pen, d, w)
