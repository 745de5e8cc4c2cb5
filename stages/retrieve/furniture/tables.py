"""Dining and round tables."""

import numpy as np

from apartgen.stages.retrieve.furniture.chairs import splayed
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.mesh import Array


def ellipse(kit: Kit, scale: float = 1.0, n: int = 32, exponent: float = 2.0) -> Array:
    """An outline (n, 2) that fills the footprint; larger exponents are squarer."""
    t = 2 * np.pi * np.arange(n) / n
    c = np.stack([np.cos(t), np.sin(t)], 1)
    return np.asarray(scale * np.sign(c) * np.abs(c) ** (2 / exponent) * [kit.d / 2, kit.w / 2])


def apron(kit: Kit, wood: str, inset: float, z: Span) -> None:
    b, t = kit.base, 0.02
    x, y = (kit.x[0] + inset, kit.x[1] - inset), (kit.y[0] + inset, kit.y[1] - inset)
    for px in (x[0], x[1] - t):
        b.box(wood, (px, px + t), y, z)
    for py in (y[0], y[1] - t):
        b.box(wood, (x[0] + t, x[1] - t), (py, py + t), (z[0] + 0.001, z[1]))


@design("dining_table", "farmhouse", "scandi", "trestle", "industrial", "pedestal", "glass")
def dining_table(kit: Kit) -> None:
    """A rectangular table for its chairs to be pushed under."""
    b, h = kit.base, kit.h
    wood = kit.pick("oak", "walnut", "light_oak", "dark_oak")
    top = (h - 0.035, h)
    if kit.style == "glass":
        b.rounded("glass", kit.x, kit.y, (h - 0.012, h), 0.005)
        metal_frame(kit, kit.pick("chrome", "black_metal", "brass"), h - 0.012, 0.04)
        return
    if kit.style == "scandi":
        b.rounded(wood, kit.x, kit.y, top, 0.015)
    elif kit.style == "pedestal":
        b.prism(kit.pick("white", "marble", "walnut"), ellipse(kit, n=48, exponent=3.2), *top, smooth=False)
    else:
        n = max(3, round(kit.d / 0.16)) if kit.style in ("farmhouse", "trestle") else 1
        for i in range(n):
            x = (kit.x[0] + i * kit.d / n, kit.x[0] + (i + 1) * kit.d / n - (0.002 if i < n - 1 else 0.0))
            b.box(wood, x, kit.y, top)
    {
        "farmhouse": _farm_legs,
        "scandi": _scandi_legs,
        "trestle": _trestle,
        "industrial": _industrial,
        "pedestal": _tulips,
    }[kit.style](kit, wood, top[0])


def _farm_legs(kit: Kit, wood: str, z: float) -> None:
    leg = kit.pick(wood, "cream", "sage")
    apron(kit, leg, 0.05, (z - 0.1, z))
    for x in (kit.x[0] + 0.07, kit.x[1] - 0.07):
        for y in (kit.y[0] + 0.07, kit.y[1] - 0.07):
            profile = [
                (0.022, 0),
                (0.032, 0.04),
                (0.022, 0.08),
                (0.04, 0.3),
                (0.036, z - 0.2),
                (0.026, z - 0.17),
                (0.042, z - 0.14),
                (0.042, z),
            ]
            kit.base.turned(leg, profile, (x, y, 0), 16)


def _scandi_legs(kit: Kit, wood: str, z: float) -> None:
    inset = 0.03
    apron(kit, wood, 0.14, (z - 0.07, z))
    splayed(kit, wood, z, (kit.x[0] + inset, kit.x[1] - inset), (kit.y[0] + inset, kit.y[1] - inset), 0.016, 0.03)


def _trestle(kit: Kit, wood: str, z: float) -> None:
    b = kit.base
    for s in (-1, 1):
        y = s * (kit.w / 2 - min(0.35, 0.2 * kit.w))
        b.box(wood, (-0.42 * kit.d, 0.42 * kit.d), (y - 0.04, y + 0.04), (0, 0.07))
        b.box(wood, (-0.4 * kit.d, 0.4 * kit.d), (y - 0.04, y + 0.04), (z - 0.06, z))
        for side in (-1, 1):
            outline = [
                (0.07, side * 0.3 * kit.d),
                (z - 0.06, side * 0.05),
                (z - 0.06, side * 0.05 + 0.08),
                (0.07, side * 0.3 * kit.d + 0.08),
            ]
            outline = [(a, c - 0.04) for a, c in outline]
            b.prism(wood, outline, y - 0.03, y + 0.03, 1)
    y = kit.w / 2 - min(0.35, 0.2 * kit.w) + 0.08
    b.box(wood, (-0.035, 0.035), (-y, y), (0.4 * z, 0.4 * z + 0.08))


def metal_frame(kit: Kit, metal: str, z: float, s: float) -> None:
    b = kit.base
    b.fill = 0.25
    for y in (kit.y[0] + 0.06, kit.y[1] - 0.06 - s):
        for x in (kit.x[0] + 0.05, kit.x[1] - 0.05 - s):
            b.box(metal, (x, x + s), (y, y + s), (0, z))
        b.box(metal, (kit.x[0] + 0.05 + s, kit.x[1] - 0.05 - s), (y + 0.001, y + s - 0.001), (z - s, z - 0.001))
    for x in (kit.x[0] + 0.05, kit.x[1] - 0.05 - s):
        b.box(metal, (x + 0.002, x + s - 0.002), (kit.y[0] + 0.06 + s, kit.y[1] - 0.06 - s), (z - s + 0.002, z - 0.002))
    b.fill = 1.0


def _industrial(kit: Kit, wood: str, z: float) -> None:
    b, s = kit.base, 0.05
    b.fill = 0.2
    for y in (kit.y[0] + 0.12, kit.y[1] - 0.12 - s):
        for x in (kit.x[0] + 0.06, kit.x[1] - 0.06 - s):
            b.box("black_metal", (x, x + s), (y, y + s), (s, z))
        for low in (0.0, z - s):
            b.box("black_metal", (kit.x[0] + 0.06, kit.x[1] - 0.06), (y + 0.001, y + s - 0.001), (low, low + s - 0.001))
    b.fill = 1.0


def _tulips(kit: Kit, wood: str, z: float) -> None:
    places = [0.0] if kit.w < 1.5 else [-0.24 * kit.w, 0.24 * kit.w]
    for y in places:
        tulip(kit, kit.pick("white_metal", "black_metal"), (0, y), z, min(0.3, 0.36 * kit.d))


def tulip(kit: Kit, material: str, at: tuple[float, float], z: float, r: float) -> None:
    """A trumpet foot."""
    kit.base.fill = 0.15
    profile = [
        (r, 0),
        (r, 0.012),
        (0.6 * r, 0.03),
        (0.28 * r, 0.1),
        (0.036, 0.25 * z + 0.05),
        (0.036, 0.7 * z),
        (0.06, z - 0.04),
        (0.12, z),
    ]
    kit.base.turned(material, profile, (*at, 0), 24)
    kit.base.fill = 1.0


@design("round_table", "tulip", "scandi", "drum", "tripod")
def round_table(kit: Kit) -> None:
    """A round or oval table."""
    b, h = kit.base, kit.h
    wood = kit.pick("oak", "walnut", "white", "light_oak")
    top = kit.pick("marble", "white", wood) if kit.style == "tulip" else wood
    b.prism(top, ellipse(kit, n=48), h - 0.03, h, smooth=True)
    z = h - 0.03
    r = min(kit.d, kit.w) / 2
    if kit.style == "tulip":
        tulip(kit, kit.pick("white_metal", "black_metal"), (0, 0), z, 0.62 * r)
    elif kit.style == "scandi":
        k = 0.69
        splayed(kit, wood, z, (k * kit.x[0], k * kit.x[1]), (k * kit.y[0], k * kit.y[1]), 0.015, 0.028)
    elif kit.style == "drum":
        n = 28
        b.fill = 0.5
        b.turned(wood, [(0.5 * r, 0), (0.5 * r, 0.02)], n=32)
        for i in range(n):
            a = 2 * np.pi * i / n
            b.rod(
                wood,
                (0.46 * r * np.cos(a), 0.46 * r * np.sin(a), 0.018),
                (0.46 * r * np.cos(a), 0.46 * r * np.sin(a), z),
                0.035 * r + 0.006,
                n=8,
            )
    else:
        b.turned(wood, [(0.05, 0.2), (0.06, 0.3), (0.035, 0.45 * h), (0.05, z - 0.1), (0.09, z)], n=16)
        tripod(kit, wood, 0.7 * r, 4)


def tripod(kit: Kit, wood: str, r: float, n: int) -> None:
    for i in range(n):
        a = 2 * np.pi * (i + 0.5) / n
        c, s = np.cos(a), np.sin(a)
        kit.base.rod(wood, (0.02 * c, 0.02 * s, 0.26), (r * c, r * s, 0.03), 0.028, 0.02, 8)
        k = min(0.03, 0.2 * r)
        kit.base.pillow(wood, (r * c - k, r * c + k), (r * s - k, r * s + k), (0, 0.05), 3, 4)
