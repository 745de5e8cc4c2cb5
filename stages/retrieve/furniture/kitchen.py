"""Kitchen units: base, drawers, sink, hob, corner, wall, island, hood."""

from collections.abc import Sequence

import numpy as np

from apartgen.stages.retrieve.furniture import cases, fronts, mesh
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.cases import Cell, Column
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.looks import Look, look

STYLES = ("modern", "shaker", "scandi", "handleless", "industrial")
PLINTH = 0.1
"""Height of what fronts stand on, m."""
_SEEDS = 16
"""So many seeds in a row give a kitchen of the same materials."""
_TOPS = {"modern": ("worktop_white", "granite"), "shaker": ("oak", "marble"), "scandi": ("oak", "worktop_white"),
         "handleless": ("concrete", "worktop_white"), "industrial": ("concrete", "granite")}  # fmt: skip


def kitchen_look(kit: Kit) -> Look:
    """A kitchen's fronts: as case furniture, on a recessed plinth, under a worktop."""
    # A kitchen is bought as one: its units match over many seeds.
    taste = kit.taste(seeds=_SEEDS)
    if kit.style == "handleless":
        front = ("graphite", "white", "walnut", "sage")[int(taste.integers(4))]
        own = Look("white", front, "", "aluminium", "slab", "none", "plinth", "graphite")
    else:
        own = look(kit.style, taste).with_(body="white" if kit.style != "industrial" else "graphite")
        own = own.with_(handle={"modern": "edge", "shaker": "cup", "scandi": "tab", "industrial": "bar"}[kit.style])
    own = own.with_(base="plinth", leg="graphite", top=_TOPS[kit.style][int(taste.integers(2))], overhang=0.0)
    kit.roles = own.front, own.top, own.metal
    return own


def worktop_front(kit: Kit, own: Look) -> float:
    """The worktop stands a little in front of the doors, behind the handles' tips."""
    out = fronts.projection(own)
    return kit.x[1] - out + min(out, 0.01)


def base(kit: Kit, own: Look, columns: Sequence[Column], widths: Sequence[float] | None, slab: float = 0.038) -> float:
    """Plinth and cabinet; returns the height of the worktop's underside."""
    z = (PLINTH, kit.h - slab)
    out = fronts.projection(own)
    kit.base.box(own.leg, (kit.x[0] + 0.02, kit.x[1] - out - 0.06), (kit.y[0] + 0.001, kit.y[1] - 0.001), (0, PLINTH))
    cases.cabinet(kit, own, kit.x, kit.y, z, columns, widths)
    return z[1]


@design("kitchen_base", *STYLES)
def kitchen_base(kit: Kit) -> None:
    """Doors with a shelf, sometimes a drawer above."""
    own = kitchen_look(kit)
    above = [Cell("drawer", 0.25)] if kit.rng.random() < 0.5 else []
    z = base(kit, own, cases.door_columns(kit, kit.w, above=above), cases.door_widths(kit, kit.w))
    kit.base.box(own.top, (kit.x[0], worktop_front(kit, own)), kit.y, (z, kit.h))


@design("kitchen_drawers", *STYLES)
def kitchen_drawers(kit: Kit) -> None:
    """Three or four drawers, the deep ones below."""
    own = kitchen_look(kit)
    rows = [0.6, 0.6, 1.2, 1.2] if kit.rng.random() < 0.4 else [0.7, 1.2, 1.2]
    z = base(kit, own, [[Cell("drawer", r) for r in rows]], None)
    kit.base.box(own.top, (kit.x[0], worktop_front(kit, own)), kit.y, (z, kit.h))


@design("kitchen_corner", *STYLES)
def kitchen_corner(kit: Kit) -> None:
    """A closed corner below the worktop: where two legs of a run meet nothing could open."""
    own, z = kitchen_look(kit), kit.h - 0.038
    kit.base.box(own.leg, (kit.x[0] + 0.02, kit.x[1] - 0.06), (kit.y[0] + 0.001, kit.y[1] - 0.001), (0, PLINTH))
    kit.base.box(own.front, (kit.x[0], kit.x[1] - 0.02), kit.y, (PLINTH, z))
    kit.base.box(own.top, kit.x, kit.y, (z, kit.h))


@design("kitchen_sink", *STYLES)
def kitchen_sink(kit: Kit) -> None:
    """A sunk bowl with a low tap on its ledge, so that the worktop runs level with its neighbours."""
    own, slab = kitchen_look(kit), 0.038
    b, front = kit.base, worktop_front(kit, own)
    z, out = (PLINTH, kit.h - slab), fronts.projection(own)
    b.box(own.leg, (kit.x[0] + 0.02, kit.x[1] - out - 0.06), (kit.y[0] + 0.001, kit.y[1] - 0.001), (0, PLINTH))
    columns = [[Cell(c.kind, c.share, 0) for c in column] for column in cases.door_columns(kit, kit.w)]
    cases.cabinet(kit, own, kit.x, kit.y, z, columns, cases.door_widths(kit, kit.w), top=False)
    half = min(0.29, kit.w / 2 - 0.07)
    hole_x, hole_y = (kit.x[0] + 0.07, front - 0.075), (-half, half)
    _frame(b, own.top, (kit.x[0], front), kit.y, hole_x, hole_y, (z[1], kit.h))
    material = kit.pick("steel", "porcelain", "granite")
    b.fill = 0.15 if material == "steel" else 1.0
    deck = hole_x[0] + 0.075
    trough(b, material, (deck - 0.004, hole_x[1]), hole_y, (kit.h - 0.2, kit.h - 0.004), 0.004)
    b.box(material, (hole_x[0], deck - 0.004), hole_y, (kit.h - 0.068, kit.h - 0.06))
    for y in (hole_y[0], hole_y[1] - 0.004):
        b.box(material, (hole_x[0], deck - 0.004), (y, y + 0.004), (kit.h - 0.06, kit.h - 0.004))
    b.fill = 1.0
    tap(b, "chrome" if material != "granite" else "black_metal", hole_x[0] + 0.035, 0.0, kit.h - 0.06, kit.h, 0.13)


def _frame(b: Body, material: str, x: Span, y: Span, hole_x: Span, hole_y: Span, z: Span) -> None:
    """A slab with a rectangular hole."""
    b.box(material, (x[0], hole_x[0]), y, z)
    b.box(material, (hole_x[1], x[1]), y, z)
    b.box(material, hole_x, (y[0], hole_y[0]), z)
    b.box(material, hole_x, (hole_y[1], y[1]), z)


def trough(b: Body, material: str, x: Span, y: Span, z: Span, t: float) -> None:
    """An open box of thin walls."""
    b.box(material, x, y, (z[0], z[0] + t))
    for px in (x[0], x[1] - t):
        b.box(material, (px, px + t), y, (z[0] + t, z[1]))
    for py in (y[0], y[1] - t):
        b.box(material, (x[0] + t, x[1] - t), (py, py + t), (z[0] + t, z[1]))
    b.rod(
        "chrome",
        ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z[0] + t),
        ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, z[0] + t + 0.002),
        0.04,
    )


def tap(b: Body, metal: str, x: float, y: float, low: float, high: float, reach: float) -> None:
    """A mixer standing from `low` to `high`, its spout running forward."""
    r = min(0.012, 0.2 * (high - low))
    b.rod(metal, (x, y, low), (x, y, low + 0.006), 0.024, n=16)
    b.tube(metal, [(x, y, low + 0.006), (x, y, high - r), (x + reach, y, high - r), (x + reach, y, high - 0.035)], r)
    b.rod(metal, (x, y + 0.012, low + 0.02), (x, y + 0.05, low + 0.032), 0.006, n=8)


@design("hob", *STYLES)
def hob(kit: Kit) -> None:
    """Drawers under a glass hob with four or five zones."""
    own, slab = kitchen_look(kit), 0.038
    z = base(kit, own, [[Cell("drawer", 0.8), Cell("drawer", 1.2)]], None, slab)
    front = worktop_front(kit, own)
    kit.base.box(own.top, (kit.x[0], front), kit.y, (z, kit.h - 0.006))
    half = min(0.44, kit.w / 2 - 0.02)
    x = (kit.x[0] + 0.05, front - 0.05)
    cooktop(kit, x, (-half, half), kit.h, gas=kit.style in ("shaker", "industrial"))


def cooktop(kit: Kit, x: Span, y: Span, top: float, gas: bool) -> None:
    """Glass with heating zones, or steel with burners, of 6 mm, its upper face (or the pan rests') at `top`."""
    b, low = kit.base, top - 0.006
    if not gas:
        b.box("black_glass", x, y, (low, top - 0.0006))
    else:
        b.box("steel", x, y, (low, low + 0.001))
    middle, wide = (x[0] + x[1]) / 2, y[1] - y[0]
    zones = [(0.11, 0.25, 0.08), (-0.12, 0.25, 0.095), (0.11, 0.75, 0.095), (-0.12, 0.75, 0.08)]
    zones += [(0.0, 0.5, 0.12)] if wide > 0.75 else []
    for dx, share, r in zones:
        at = (middle + dx, y[0] + share * wide)
        r = min(r, 0.2 * wide)
        if gas:
            b.fill = 0.3
            for s in (-1, 1):
                b.box(
                    "black_metal",
                    (at[0] - r, at[0] + r),
                    (at[1] + s * 0.4 * r - 0.005, at[1] + s * 0.4 * r + 0.005),
                    (low + 0.002, top),
                    touch=False,
                )
                b.box(
                    "black_metal",
                    (at[0] + s * 0.4 * r - 0.005, at[0] + s * 0.4 * r + 0.005),
                    (at[1] - r, at[1] + r),
                    (low + 0.002, top - 0.0002),
                    touch=False,
                )
            b.fill = 1.0
            b.rod("black_metal", (*at, low + 0.001), (*at, low + 0.004), 0.4 * r, n=16)
        else:
            b.rod("plastic_grey", (*at, top - 0.0006), (*at, top), r, n=20)


@design("wall_unit", *STYLES, "glazed")
def wall_unit(kit: Kit) -> None:
    """A hung cabinet; its handles are at the lower edge."""
    style = kit.style
    if style == "glazed":
        kit.style = "shaker"
    own = kitchen_look(kit)
    kit.style = style
    kind = "glass_" if style == "glazed" else ""
    own = own.with_(body=own.front if style in ("shaker", "glazed") else own.body, hung=True)
    cases.cabinet(
        kit, own, kit.x, kit.y, (0, kit.h), cases.door_columns(kit, kit.w, kind), cases.door_widths(kit, kit.w)
    )


@design("island", *STYLES)
def island(kit: Kit) -> None:
    """Drawers and open shelves to the front, a seating overhang behind when it is deep."""
    own, slab = kitchen_look(kit), 0.038
    out, b = fronts.projection(own), kit.base
    back = kit.x[0] + (0.28 if kit.d > 0.85 else 0.02)
    b.box(own.leg, (back + 0.03, kit.x[1] - out - 0.06), (kit.y[0] + 0.05, kit.y[1] - 0.05), (0, PLINTH))
    n = max(2, round(kit.w / 0.65))
    columns: list[list[Cell]] = [[Cell("drawer", 0.7), Cell("drawer", 1.2), Cell("drawer", 1.2)] for _ in range(n)]
    columns[0] = [Cell("open", 1.0, 2)]
    z = (PLINTH, kit.h - slab)
    y = (kit.y[0] + 0.03, kit.y[1] - 0.03)
    cases.cabinet(kit, own, (back, kit.x[1]), y, z, columns)
    for side in ((kit.y[0] + 0.01, kit.y[0] + 0.029), (kit.y[1] - 0.029, kit.y[1] - 0.01)):
        b.box(own.front, (back - 0.02, kit.x[1] - out), side, (0, z[1]))
    b.box(own.front, (back - 0.02, back - 0.001), y, (0.02, z[1]))
    b.box(own.top, (kit.x[0], worktop_front(kit, own)), kit.y, (z[1], kit.h))


def _hood_box(kit: Kit, metal: str, high: float) -> None:
    """A box over its filters, glazed in front, with its buttons below the pane."""
    b, face = kit.base, kit.x[1] - 0.004
    b.box(metal, (kit.x[0], face), kit.y, (0.02, high))
    b.box(kit.pick("black_glass", "steel"), (face, kit.x[1]), (kit.y[0] + 0.01, kit.y[1] - 0.01), (0.07, high - 0.01),
          touch=False)  # fmt: skip
    for i in range(4):
        y = -0.06 + 0.04 * i
        b.box("chrome", (face, kit.x[1] - 0.001), (y - 0.008, y + 0.008), (0.04, 0.056), touch=False)
    b.box("plastic_black", (kit.x[0] + 0.03, kit.x[1] - 0.03), (kit.y[0] + 0.03, kit.y[1] - 0.03), (0.0, 0.02))


@design("hood", "chimney", "canopy", "slanted", "box")
def hood(kit: Kit) -> None:
    """A cooker hood under its chimney."""
    b, metal = kit.base, kit.pick("steel", "black_metal", "white_metal")
    b.fill = 0.06
    skirt = min(0.06, 0.2 * kit.h)
    chimney_y, chimney_x = min(0.14, 0.3 * kit.w), kit.x[0] + min(0.28, 0.7 * kit.d)
    if kit.style == "box":
        top = kit.h if kit.h < 0.45 else max(0.3, 0.5 * kit.h)
        _hood_box(kit, metal, top)
        if top < kit.h:
            b.box(metal, (kit.x[0], chimney_x), (-chimney_y, chimney_y), (top, kit.h))
        b.fill = 1.0
        return
    body = skirt + (0.35 * (kit.h - skirt) if kit.style != "canopy" else 0.0)
    if kit.style == "slanted":
        outline = [
            (0.0, kit.x[0]),
            (0.0, kit.x[0] + 0.12),
            (body, kit.x[1]),
            (body + 0.02, kit.x[1]),
            (body + 0.02, kit.x[0]),
        ]
        b.prism("black_glass", outline, kit.y[0], kit.y[1], 1)
    else:
        b.box(metal, kit.x, kit.y, (0, skirt))
        if kit.style == "chimney":
            low = np.array(
                [
                    (x, y, skirt)
                    for x, y in ((kit.x[0], kit.y[0]), (kit.x[1], kit.y[0]), (kit.x[1], kit.y[1]), (kit.x[0], kit.y[1]))
                ]
            )
            high = np.array(
                [
                    (x, y, body)
                    for x, y in (
                        (kit.x[0], -chimney_y),
                        (chimney_x, -chimney_y),
                        (chimney_x, chimney_y),
                        (kit.x[0], chimney_y),
                    )
                ]
            )
            b.add(metal, mesh.facets(np.stack([low, high])))
    b.box(metal, (kit.x[0], chimney_x), (-chimney_y, chimney_y), (body, kit.h))
    b.box(
        "plastic_white",
        (kit.x[1] - 0.05, kit.x[1] - 0.03) if kit.style != "slanted" else (kit.x[0] + 0.03, kit.x[0] + 0.08),
        (-0.1, 0.1),
        (0.0, 0.002),
    )
    b.fill = 1.0
