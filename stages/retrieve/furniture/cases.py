"""Cabinets: a carcass of boards on a base, with columns of doors, drawers and open shelves."""

from collections.abc import Sequence
from dataclasses import dataclass

from apartgen.stages.retrieve.furniture import fronts
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.looks import Look
from apartgen.stages.things import categories

BOARD = 0.018
_REST = 0.002
"""Between a closed front and the carcass edge, m."""
BASE_HEIGHT = {
    "plinth": 0.07,
    "bracket": 0.09,
    "taper": 0.15,
    "splay": 0.16,
    "turned": 0.1,
    "frame": 0.16,
    "sled": 0.1,
    "none": 0.0,
}


@dataclass(frozen=True)
class Cell:
    """One front of a column: `kind` is drawer, left, right (by hinge), pair, open or glass; `share` of the height."""

    kind: str
    share: float = 1.0
    shelves: int = -1


Column = Sequence[Cell]


def base_height(look: Look, h: float) -> float:
    """How high the look's base is under a unit of height h."""
    return min(BASE_HEIGHT[look.base], 0.28 * h)


def stand(kit: Kit, look: Look, x: Span, y: Span, top: float) -> None:
    """The look's base under the footprint, up to `top`."""
    if top <= 0:
        return
    b, leg = kit.base, look.leg
    if look.base == "plinth":
        b.box(leg, (x[0] + 0.01, x[1] - 0.04), (y[0] + 0.005, y[1] - 0.005), (0, top))
    elif look.base == "bracket":
        _bracket(kit, leg, x, y, top)
    elif look.base in ("frame", "sled"):
        _metal(kit, look, x, y, top)
    else:
        _legs(kit, look, x, y, top)


def _posts(y: Span) -> list[float]:
    wide = y[1] - y[0]
    return [0.0, 1.0] if wide < 1.5 else [0.0, 0.5, 1.0]


def _legs(kit: Kit, look: Look, x: Span, y: Span, top: float) -> None:
    inset, lean = (0.035, 0.0) if look.base != "splay" else (0.07, 0.035)
    for share in _posts(y):
        for sx, px in ((-1, x[0] + inset), (1, x[1] - inset)):
            py = y[0] + inset + share * (y[1] - y[0] - 2 * inset)
            sy = 2 * share - 1
            if look.base == "turned":
                r = 0.026
                profile = [
                    (0.4 * r, 0),
                    (0.8 * r, 0.2 * top),
                    (r, 0.5 * top),
                    (0.5 * r, 0.78 * top),
                    (0.9 * r, 0.85 * top),
                    (0.9 * r, top),
                ]
                kit.base.turned(look.leg, profile, (px, py, 0), 12)
            else:
                foot = (px + sx * lean, py + sy * lean, 0.0)
                kit.base.leg(look.leg, foot, (px, py, top), 0.011, 0.019, 10)


def _bracket(kit: Kit, leg: str, x: Span, y: Span, top: float) -> None:
    b, t, run = kit.base, 0.02, min(0.12, 0.2 * (y[1] - y[0]))
    b.box(leg, (x[1] - t, x[1]), (y[0] + run, y[1] - run), (0.6 * top, top))
    for s, edge in ((1, y[0]), (-1, y[1])):
        b.box(leg, (x[1] - t, x[1]), _sorted(edge, edge + s * run), (0, top))
        b.box(leg, (x[0], x[1] - t), _sorted(edge, edge + s * t), (0.5 * top, top))
        b.box(leg, (x[0], x[0] + 0.08), _sorted(edge, edge + s * t), (0, 0.5 * top))


def _metal(kit: Kit, look: Look, x: Span, y: Span, top: float) -> None:
    b, t = kit.base, 0.022
    for share in _posts(y):
        middle = y[0] + 0.02 + share * (y[1] - y[0] - 0.04 - t)
        own = (middle, middle + t)
        low = (0.0, t) if look.base == "sled" else (0.0, 0.0)
        if look.base == "sled":
            b.box(look.leg, (x[0] + 0.02, x[1] - 0.03), own, low)
        for at in (x[0] + 0.02, x[1] - 0.03 - t):
            b.box(look.leg, (at, at + t), own, (low[1], top))
    if look.base == "frame":
        for at in (x[0] + 0.02, x[1] - 0.03 - t):
            b.box(look.leg, (at + 0.002, at + t - 0.002), (y[0] + 0.02 + t, y[1] - 0.02 - t), (top - t, top - 0.001))


def _sorted(a: float, b: float) -> Span:
    return (a, b) if a < b else (b, a)


def carcass(kit: Kit, look: Look, x: Span, y: Span, z: Span, top: bool = True) -> tuple[Span, Span, float]:
    """Sides, bottom, top and back; returns the inner y and z ranges and the inner x of the back."""
    b, t = kit.base, BOARD
    for side in ((y[0], y[0] + t), (y[1] - t, y[1])):
        b.box(look.body, x, side, z)
    inner_y = (y[0] + t, y[1] - t)
    b.box(look.body, (x[0] + 0.008, x[1]), inner_y, (z[0], z[0] + t))
    if top:
        b.box(look.body, (x[0] + 0.008, x[1]), inner_y, (z[1] - t, z[1]))
    b.box(look.body, (x[0], x[0] + 0.008), inner_y, z)
    return inner_y, (z[0] + t, z[1] - t if top else z[1]), x[0] + 0.008


def cabinet(
    kit: Kit, look: Look, x: Span, y: Span, z: Span, columns: Sequence[Column],
    widths: Sequence[float] | None = None, top: bool = True,
) -> None:  # fmt: skip
    """A carcass whose fronts' handles touch x[1]; columns from right (-y) to left, cells from the top down."""
    out = fronts.projection(look)
    inner_x = x[1] - out - fronts.LEAF - _REST
    inner_y, inner_z, back = carcass(kit, look, (x[0], inner_x), y, z, top)
    shares = widths or [1.0] * len(columns)
    edge = y[0]
    for i, column in enumerate(columns):
        far = y[1] if i == len(columns) - 1 else edge + (y[1] - y[0]) * shares[i] / sum(shares)
        opening = (inner_y[0] if i == 0 else edge + BOARD / 2, inner_y[1] if i == len(columns) - 1 else far - BOARD / 2)
        if i:
            kit.base.box(look.body, (back, inner_x), (edge - BOARD / 2, edge + BOARD / 2), inner_z)
        _column(kit, look, column, x[1], (edge, far), z, opening, inner_z, (back, inner_x))
        edge = far


def _column(
    kit: Kit, look: Look, column: Column, front: float, y: Span, z: Span, opening: Span, inner_z: Span, inner_x: Span
) -> None:
    total = sum(cell.share for cell in column)
    high = z[1]
    for i, cell in enumerate(column):
        low = z[0] if i == len(column) - 1 else high - (z[1] - z[0]) * cell.share / total
        room = (inner_z[0] if i == len(column) - 1 else low + BOARD / 2, inner_z[1] if i == 0 else high - BOARD / 2)
        if i and not column[i - 1].kind == cell.kind == "drawer":
            board = (high - BOARD / 2, high + BOARD / 2)
            kit.base.box(look.body, inner_x, opening, board)
        _cell(kit, look, cell, front, y, (low, high), opening, room, inner_x)
        high = low


def _cell(
    kit: Kit, look: Look, cell: Cell, front: float, y: Span, z: Span, opening: Span, room: Span, inner_x: Span
) -> None:
    if cell.kind == "drawer":
        z_front = (z[0], z[1])
        fronts.drawer(kit, look, front, y, z_front, opening, inner_x[1] - inner_x[0] - 0.012)
        return
    shelves(kit, look, inner_x, opening, room, cell.shelves)
    own = look.with_(profile="glass") if cell.kind.startswith("glass") else look
    kind = cell.kind.removeprefix("glass_")
    middle = (y[0] + y[1]) / 2
    if kind in ("left", "pair"):
        fronts.door(kit, own, front, (middle if kind == "pair" else y[0], y[1]), z, left=True)
    if kind in ("right", "pair"):
        fronts.door(kit, own, front, (y[0], middle if kind == "pair" else y[1]), z, left=False)


def shelves(kit: Kit, look: Look, x: Span, y: Span, z: Span, count: int = -1, material: str = "") -> None:
    """Loose shelves in a compartment; as many as suit its height when `count` is negative."""
    n = max(0, round((z[1] - z[0]) / 0.36) - 1) if count < 0 else count
    for i in range(n):
        at = z[0] + (i + 1) * (z[1] - z[0]) / (n + 1)
        kit.base.box(
            material or look.body, (x[0], x[1] - 0.015), (y[0] + 0.001, y[1] - 0.001), (at - BOARD / 2, at + BOARD / 2)
        )


def door_columns(kit: Kit, w: float, kind: str = "", above: Sequence[Cell] = ()) -> list[list[Cell]]:
    """Columns of hinged doors: as many leaves as `categories.leaves` says, in pairs, an odd one alone."""
    n = categories.leaves(kit.category, w)
    columns = [[*above, Cell(f"{kind}pair")] for _ in range(n // 2)]
    if n % 2:
        columns.append([*above, Cell(f"{kind}left" if n > 1 or kit.rng.random() < 0.5 else f"{kind}right")])
    return columns


def door_widths(kit: Kit, w: float) -> list[float]:
    """Shares of the columns of `door_columns`."""
    n = categories.leaves(kit.category, w)
    return [2.0] * (n // 2) + [1.0] * (n % 2)


def crown(kit: Kit, look: Look, z: Span) -> None:
    """A top board over the whole footprint, or as far as the fronts when there is no overhang."""
    front = kit.x[1] if look.overhang else kit.x[1] - fronts.projection(look)
    kit.base.box(look.top, (kit.x[0], front), kit.y, z)


def unit(
    kit: Kit, look: Look, columns: Sequence[Column], widths: Sequence[float] | None = None, cap: float = 0.02
) -> None:
    """A whole free-standing cabinet: base, body, top."""
    foot = base_height(look, kit.h)
    inset = look.overhang
    y = (kit.y[0] + inset, kit.y[1] - inset)
    x = (kit.x[0], kit.x[1])
    body_front = x[1] - fronts.projection(look)
    stand(kit, look, (x[0], body_front), y, foot)
    cabinet(kit, look, x, y, (foot, kit.h - cap), columns, widths)
    crown(kit, look, (kit.h - cap, kit.h))
