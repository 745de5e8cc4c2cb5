"""Oven, fridge, dishwasher, microwave."""

import numpy as np

from apartgen.stages.retrieve.furniture import cases, fronts
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.cases import Cell
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.kitchen import PLINTH, STYLES, cooktop, kitchen_look, worktop_front
from apartgen.stages.retrieve.furniture.looks import Look
from apartgen.stages.retrieve.furniture.mesh import Array
from apartgen.stages.things import categories, materials
from apartgen.stages.things.categories import OVEN_TOWER

_WALL = 260.0
"""Sheet steel with insulation between, kg/m³."""


def sheet(material: str) -> float:
    """Share of a solid of the material that weighs as much as an appliance's wall."""
    return _WALL / materials.density(material)


def _housing(kit: Kit, material: str, lining: str, x: Span, y: Span, z: Span, wall: float) -> tuple[Span, Span, float]:
    """Insulated walls on five sides; returns inner y, z and the inner x of the back."""
    b = kit.base
    b.fill = sheet(material)
    for side in ((y[0], y[0] + wall), (y[1] - wall, y[1])):
        b.box(material, x, side, z)
    inner_y, inner_z = (y[0] + wall, y[1] - wall), (z[0] + wall, z[1] - wall)
    b.box(material, x, inner_y, (z[0], inner_z[0]))
    b.box(material, x, inner_y, (inner_z[1], z[1]))
    b.box(material, (x[0], x[0] + wall - 0.002), inner_y, inner_z)
    b.box(lining, (x[0] + wall - 0.002, x[0] + wall), inner_y, inner_z)
    b.fill = 1.0
    return inner_y, inner_z, x[0] + wall


def _look(material: str, metal: str, handle: str = "bar") -> Look:
    return Look(material, material, material, metal, "slab", handle, "plinth", "plastic_black")


def _glazed(body: Body, x: Span, y: Span, z: Span) -> None:
    """A dark pane let into the face of a leaf."""
    body.box("black_glass", (x[1] - 0.001, x[1] + 0.001), y, z, touch=False)


def _racks(kit: Kit, x: Span, y: Span, levels: Array) -> None:
    b = kit.base
    for z in levels:
        for py in (y[0] + 0.004, y[1] - 0.012):
            b.box("steel", x, (py, py + 0.008), (z, z + 0.006))
        n = 7
        for i in range(n):
            px = x[0] + 0.01 + i * (x[1] - x[0] - 0.026) / (n - 1)
            b.box("steel", (px, px + 0.006), (y[0] + 0.012, y[1] - 0.012), (z, z + 0.006))


@design("oven", "steel", "black", "white", "range")
def oven(kit: Kit) -> None:
    """A cooker with its hob on top, or in a tall box an oven tower."""
    if kit.h > OVEN_TOWER:
        face_of = {"steel": "white", "black": "graphite", "white": "white", "range": "sage"}[kit.style]
        own = Look("white", face_of, face_of, "aluminium", "slab", "bar", "plinth", "graphite")
        _tower(kit, own, _look("steel" if kit.style != "black" else "black", "steel"))
        return
    b, h = kit.base, kit.h
    material = {"steel": "steel", "black": "black", "white": "enamel", "range": kit.pick("cream", "navy", "sage")}[
        kit.style
    ]
    own = _look(material, "brass" if kit.style == "range" else "steel")
    front, thick = kit.x[1], 0.04
    face = front - fronts.projection(own)
    edge = face - thick - 0.002
    b.box("plastic_black", (kit.x[0] + 0.03, edge - 0.04), (kit.y[0] + 0.02, kit.y[1] - 0.02), (0, 0.06))
    panel = h - 0.11
    low = max(0.22, panel - 0.6 * h)
    _housing(kit, material, "plastic_grey", (kit.x[0], edge), kit.y, (low, panel), 0.05)
    b.fill = sheet(material)
    b.mass += 12.0
    b.box(material, (kit.x[0], face), kit.y, (panel, h - 0.006))
    b.box(material, (kit.x[0], edge), (kit.y[0], kit.y[0] + 0.02), (0.06, low))
    b.box(material, (kit.x[0], edge), (kit.y[1] - 0.02, kit.y[1]), (0.06, low))
    b.box(material, (kit.x[0], edge), (kit.y[0] + 0.02, kit.y[1] - 0.02), (0.06, 0.075))
    b.fill = 1.0
    cooktop(
        kit, (kit.x[0] + 0.02, face - 0.01), (kit.y[0] + 0.01, kit.y[1] - 0.01), h, gas=kit.style in ("range", "white")
    )
    n = 5 if kit.w < 0.75 else 7
    for i in range(n):
        y = kit.y[0] + (i + 0.5) * kit.w / n
        b.turned(
            "plastic_black" if kit.style != "range" else "brass",
            [(0.02, 0), (0.018, 0.02)],
            (face, y, panel + 0.055),
            12,
            along=(1, 0, 0),
        )
    door = fronts.flap(kit, own, front, (kit.y[0], kit.y[1]), (low, panel), thick, bar=0.8)
    door.mass *= 3 * sheet(material)
    _glazed(door, (face - thick, face), (kit.y[0] + 0.08, kit.y[1] - 0.08), (low + 0.07, panel - 0.11))
    _racks(
        kit,
        (kit.x[0] + 0.06, edge - 0.01),
        (kit.y[0] + 0.05, kit.y[1] - 0.05),
        np.linspace(low + 0.12, panel - 0.16, 2),
    )
    pans = fronts.drawer(
        kit,
        own.with_(handle="none"),
        front - fronts.projection(own),
        kit.y,
        (0.06, low),
        (kit.y[0] + 0.02, kit.y[1] - 0.02),
        kit.d * 0.7,
        thick,
        "plastic_grey",
    )
    pans.mass *= 2 * sheet(material)


@design("oven", *STYLES)
def fitted_oven(kit: Kit) -> None:
    """An oven under the worktop of its kitchen's run, or in a tall box a tower with its fronts."""
    own, slab = kitchen_look(kit), 0.038
    metal = _look("steel" if kit.style in ("shaker", "scandi", "modern") else "black", "steel")
    if kit.h > OVEN_TOWER:
        _tower(kit, own.with_(handle="bar"), metal)
        return
    b, thick = kit.base, 0.035
    under = kit.h - slab
    face = kit.x[1] - fronts.projection(metal)
    edge = face - thick - 0.002
    panel = under - 0.095
    low = max(0.23, panel - 0.55 * kit.h)
    b.box(own.leg, (kit.x[0] + 0.02, edge - 0.04), (kit.y[0] + 0.001, kit.y[1] - 0.001), (0, PLINTH))
    cases.cabinet(kit, own, kit.x, kit.y, (PLINTH, low), [[Cell("drawer")]])
    _housing(kit, metal.body, "plastic_grey", (kit.x[0], edge), kit.y, (low, panel), 0.04)
    b.mass += 22.0
    b.fill = sheet(metal.body)
    b.box(metal.body, (kit.x[0], face), kit.y, (panel, under))
    b.fill = 1.0
    b.box("screen", (face - 0.001, face + 0.001), (-0.07, 0.07), (panel + 0.03, panel + 0.065), False)
    for y in (-0.19, 0.19):
        b.turned("plastic_black", [(0.018, 0), (0.016, 0.018)], (face, y, panel + 0.047), 12, along=(1, 0, 0))
    b.box(own.top, (kit.x[0], max(face, worktop_front(kit, own))), kit.y, (under, kit.h))
    _oven_door(kit, metal, edge, (low, panel), thick)


def _oven_door(kit: Kit, metal: Look, edge: float, z: Span, thick: float) -> None:
    """A glazed flap over two racks."""
    face = kit.x[1] - fronts.projection(metal)
    door = fronts.flap(kit, metal, kit.x[1], kit.y, z, thick, bar=0.8)
    door.mass *= 3 * sheet(metal.body)
    _glazed(door, (face - thick, face), (kit.y[0] + 0.07, kit.y[1] - 0.07), (z[0] + 0.06, z[1] - 0.1))
    _racks(
        kit, (kit.x[0] + 0.05, edge - 0.02), (kit.y[0] + 0.04, kit.y[1] - 0.04), np.linspace(z[0] + 0.1, z[1] - 0.15, 2)
    )


def _tower(kit: Kit, own: Look, metal: Look) -> None:
    low, high = 0.62, 1.22
    out, b = fronts.projection(own), kit.base
    edge = kit.x[1] - out - fronts.LEAF - 0.002
    b.box("graphite", (kit.x[0] + 0.02, edge - 0.04), (kit.y[0] + 0.01, kit.y[1] - 0.01), (0, 0.1))
    cases.cabinet(kit, own, kit.x, kit.y, (0.1, low), [[Cell("drawer"), Cell("drawer")]])
    top = [[Cell("pair", 1.0, 1)]] if kit.w > 0.62 else [[Cell("left", 1.0, 1)]]
    cases.cabinet(kit, own, kit.x, kit.y, (high, kit.h), top)
    _housing(kit, metal.body, "plastic_grey", (kit.x[0], edge - 0.02), kit.y, (low, high - 0.1), 0.04)
    b.fill = sheet(metal.body)
    b.mass += 25.0
    b.box(metal.body, (kit.x[0], kit.x[1] - out), kit.y, (high - 0.1, high))
    b.fill = 1.0
    b.box(
        "screen", (kit.x[1] - out - 0.001, kit.x[1] - out + 0.001), (-0.08, 0.08), (high - 0.075, high - 0.035), False
    )
    _oven_door(kit, metal, edge - 0.02, (low, high - 0.1), 0.035)


@design("fridge", "white", "steel", "retro", "panelled")
def fridge(kit: Kit) -> None:
    """Fridge over freezer, or side by side when it is wide; shelves inside."""
    material, metal = {
        "white": ("enamel", "plastic_grey"),
        "steel": ("steel", "steel"),
        "panelled": ("graphite", "black_metal"),
        "retro": (kit.pick("mint", "cream", "blush", "dusk_blue"), "chrome"),
    }[kit.style]
    own = _look(material, metal, "edge" if kit.style in ("white", "panelled") else "bar")
    b, thick, foot, wall = kit.base, 0.045, 0.05, 0.04
    front = kit.x[1]
    edge = front - fronts.projection(own) - thick - 0.003
    b.box("plastic_black", (kit.x[0] + 0.03, edge - 0.03), (kit.y[0] + 0.02, kit.y[1] - 0.02), (0, foot))
    zones = _zones(kit, foot)
    n = categories.leaves("fridge", kit.w)
    b.mass += 16.0
    for low, high in zones:
        inner_y, inner_z, back = _housing(kit, material, "plastic_white", (kit.x[0], edge), kit.y, (low, high), wall)
        for i in range(n):
            y = (kit.y[0] + i * kit.w / n, kit.y[0] + (i + 1) * kit.w / n)
            left = i == n - 1 if n > 1 else not kit.right
            body = fronts.door(kit, own, front, y, (low, high), left, thick, 0.045 if n == 1 else 0.0)
            body.mass *= 1.2 * sheet(material)
            if n == 1:
                _bins(body, (edge - 0.042, edge + 0.003), y, (low + wall, high - wall), wall)
        levels = max(1, round((inner_z[1] - inner_z[0]) / 0.3))
        for k in range(1, levels):
            z = inner_z[0] + k * (inner_z[1] - inner_z[0]) / levels
            b.box("glass", (back, edge - 0.05), (inner_y[0] + 0.001, inner_y[1] - 0.001), (z, z + 0.006))


def _zones(kit: Kit, foot: float) -> list[Span]:
    if kit.h < 1.2:
        return [(foot, kit.h)]
    split = foot + (kit.h - foot) * (0.38 if kit.style != "retro" else 0.72)
    return [(foot, split), (split, kit.h)]


def _bins(body: Body, x: Span, y: Span, z: Span, wall: float) -> None:
    """Shelves in the door; they clear the housing's side on the way out."""
    own = (y[0] + wall + 0.045, y[1] - wall - 0.045)
    if own[1] - own[0] < 0.1:
        return
    for k in range(max(1, round((z[1] - z[0]) / 0.4))):
        low = z[0] + 0.06 + 0.36 * k
        if low + 0.09 < z[1] - 0.02:
            body.box("plastic_white", x, own, (low, low + 0.008))
            body.box("glass", (x[0], x[0] + 0.004), own, (low + 0.008, low + 0.08))


@design("dishwasher", "steel", "white", "integrated")
def dishwasher(kit: Kit) -> None:
    """A flap over two racks of a steel tub."""
    material = {"steel": "steel", "white": "enamel", "integrated": kit.pick("white", "graphite", "sage", "oak")}[
        kit.style
    ]
    own = _look(material, "steel", "bar" if kit.style != "white" else "edge")
    front, thick, b = kit.x[1], 0.035, kit.base
    face = front - fronts.projection(own)
    edge = face - thick - 0.002
    low, high = 0.1, kit.h - 0.02
    b.box("plastic_black", (kit.x[0] + 0.03, edge - 0.02), (kit.y[0] + 0.005, kit.y[1] - 0.005), (0, low))
    b.fill = 1.0
    b.mass += 18.0
    b.box("worktop_white", (kit.x[0], face), kit.y, (high, kit.h))
    kit.roles = material if kit.style == "integrated" else "", "worktop_white", ""
    inner_y, inner_z, back = _housing(kit, "enamel", "steel", (kit.x[0], edge), kit.y, (low, high), 0.025)
    body = fronts.flap(kit, own, front, kit.y, (low, high), thick, bar=0.7)
    body.mass *= 2 * sheet(material)
    if kit.style != "integrated":
        body.box("screen", (face - 0.001, face + 0.001), (-0.15, 0.15), (high - 0.09, high - 0.07), False)
    _racks(kit, (back + 0.01, edge - 0.01), (inner_y[0], inner_y[1]), np.array([inner_z[0] + 0.06, inner_z[0] + 0.34]))


@design("microwave", "steel", "black", "retro")
def microwave(kit: Kit) -> None:
    """A hinged door beside the control panel, a turntable behind it."""
    material = {"steel": "steel", "black": "plastic_black", "retro": kit.pick("mint", "cream", "blush")}[kit.style]
    own = _look(material, "chrome", "bar")
    b, front, thick, foot = kit.base, kit.x[1], 0.025, 0.012
    face = front - fronts.projection(own)
    edge = face - thick - 0.002
    panel = kit.y[0] + min(0.12, 0.24 * kit.w)
    for x in (kit.x[0] + 0.03, edge - 0.06):
        for y in (kit.y[0] + 0.03, kit.y[1] - 0.06):
            b.box("rubber", (x, x + 0.03), (y, y + 0.03), (0, foot))
    z = (foot, kit.h)
    inner_y, inner_z, back = _housing(kit, material, "plastic_grey", (kit.x[0], edge), (panel, kit.y[1]), z, 0.02)
    b.fill = sheet(material)
    b.mass += 6.0
    b.box(material, (kit.x[0], edge), (kit.y[0], panel), z)
    b.box("black_glass", (edge, face), (kit.y[0], panel), z)
    b.fill = 1.0
    b.box("screen", (face - 0.001, face + 0.001), (kit.y[0] + 0.02, panel - 0.02), (kit.h - 0.06, kit.h - 0.03), False)
    b.turned("chrome", [(0.022, 0), (0.02, 0.018)], (face, (kit.y[0] + panel) / 2, z[0] + 0.07), 16, along=(1, 0, 0))
    body = fronts.door(kit, own, front, (panel, kit.y[1]), z, True, thick)
    body.mass *= 3 * sheet(material)
    _glazed(body, (face - thick, face), (panel + 0.08, kit.y[1] - 0.03), (z[0] + 0.04, z[1] - 0.04))
    middle = ((back + edge) / 2, (inner_y[0] + inner_y[1]) / 2)
    b.rod(
        "glass",
        (*middle, inner_z[0]),
        (*middle, inner_z[0] + 0.008),
        min(edge - back, inner_y[1] - inner_y[0]) / 2 - 0.01,
        n=24,
    )
