"""Washing machine and dryer: a drum behind a round door."""

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.appliances import sheet
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.mesh import Array
from apartgen.stages.things import materials


def _porthole(kit: Kit, material: str, accent: str, drum: str) -> None:
    """A front plate with a round hole, a drum behind it, a round door that swings aside."""
    b, h = kit.base, kit.h
    swell = 0.045
    face = kit.x[1] - swell
    plate, foot = 0.03, 0.02
    for x in (kit.x[0] + 0.05, face - 0.08):
        for y in (kit.y[0] + 0.05, kit.y[1] - 0.08):
            b.box("rubber", (x, x + 0.03), (y, y + 0.03), (0, foot))
    panel = h - 0.13
    b.fill = 3 * sheet(material)
    b.mass += 38.0
    wall, back = 0.015, kit.x[0] + 0.015
    for side in ((kit.y[0], kit.y[0] + wall), (kit.y[1] - wall, kit.y[1])):
        b.box(material, (kit.x[0], face - plate), side, (foot, h - 0.02))
    inner = (kit.y[0] + wall, kit.y[1] - wall)
    b.box(material, (kit.x[0], back), inner, (foot, h - 0.02))
    b.box(material, (back, face - plate), inner, (foot, foot + wall))
    b.box(material, (kit.x[0], face), kit.y, (h - 0.02, h))
    b.box(material, (face - plate, face), kit.y, (panel, h - 0.02))
    r = min(0.17, 0.32 * kit.w)
    middle = np.array([0.0, (foot + panel) / 2 + 0.03])
    _plate(b, material, (face - plate, face), kit.y, (foot, panel), middle, r)
    deep = face - plate - back - 0.05
    wide = min(0.24, kit.w / 2 - wall - 0.02)
    b.fill = 0.05
    b.shell(
        drum,
        [(wide, 0.001), (wide, deep - 0.06), (r + 0.012, deep)],
        [(wide - 0.012, 0.012), (wide - 0.012, deep - 0.06), (r + 0.001, deep)],
        (back + 0.05, *middle),
        24,
        along=(1, 0, 0),
    )
    b.rod(drum, (back + 0.045, *middle), (back + 0.05, *middle), wide, n=24)
    b.fill = 1.0
    _controls(kit, face, panel, accent)
    _round_door(kit, face, middle, r, accent)


def _plate(b: Body, material: str, x: Span, y: Span, z: Span, middle: Array, r: float) -> None:
    n = 32
    c = mesh.circle(n)
    square = c / np.abs(c).max(1, keepdims=True)
    edge = np.where(square < 0, [y[0], z[0]] - middle, [y[1], z[1]] - middle) * np.abs(square) + middle
    hole = r * c + middle
    rings = [
        np.column_stack([np.full(n, px), ring]) for px, ring in ((x[1], edge), (x[1], hole), (x[0], hole), (x[0], edge))
    ]
    b.add(material, mesh.loft(np.array(rings), caps=False, sharp=(1, 2, 3)), touch=False)
    for i in range(n):
        b.hull(np.array([ring[j] for ring in rings for j in (i, (i + 1) % n)]))


def _controls(kit: Kit, face: float, panel: float, accent: str) -> None:
    b, z = kit.base, (panel + kit.h - 0.02) / 2
    b.turned(accent, [(0.03, 0), (0.026, 0.022)], (face, 0, z), 20, along=(1, 0, 0))
    b.box("screen", (face - 0.001, face + 0.001), (kit.y[0] + 0.08, kit.y[0] + 0.2), (z - 0.02, z + 0.02), False)
    b.box(
        "plastic_grey", (face - 0.001, face + 0.002), (kit.y[1] - 0.2, kit.y[1] - 0.04), (z - 0.035, z + 0.035), False
    )


def _round_door(kit: Kit, face: float, middle: Array, r: float, accent: str) -> None:
    body = Body()
    at = (face + 0.002, *middle)
    out = kit.x[1] - at[0]
    body.fill = 900 / materials.density(accent)
    body.turned(accent, [(r + 0.03, 0), (r + 0.03, 0.6 * out), (r + 0.016, out - 0.003)], at, 32, along=(1, 0, 0))
    body.turned("black_glass", [(r - 0.01, 0), (r - 0.02, 0.003)], (kit.x[1] - 0.003, *middle), 32, along=(1, 0, 0))
    hold = (kit.x[1], middle[0] - r - 0.015, middle[1])
    kit.hinge("door", body, (kit.x[1], middle[0] + r + 0.03, middle[1]), (0, 0, 1), handle=hold)


@design("washing_machine", "white", "graphite", "steel")
def washing_machine(kit: Kit) -> None:
    """A front loader."""
    material = {"white": "enamel", "graphite": "graphite", "steel": "steel"}[kit.style]
    _porthole(kit, material, kit.pick("plastic_grey", "chrome", "plastic_black"), "steel")


@design("dryer", "white", "graphite")
def dryer(kit: Kit) -> None:
    """A tumble dryer with a larger door."""
    _porthole(
        kit,
        {"white": "enamel", "graphite": "graphite"}[kit.style],
        "plastic_white" if kit.style == "white" else "plastic_black",
        "enamel",
    )
