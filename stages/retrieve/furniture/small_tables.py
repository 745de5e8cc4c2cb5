"""Coffee, side, console and balcony tables."""

import numpy as np

from apartgen.stages.retrieve.furniture.chairs import splayed, square_legs
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.tables import apron, ellipse, metal_frame, tripod, tulip


@design("coffee_table", "scandi", "industrial", "drum", "marble", "glass", "block")
def coffee_table(kit: Kit) -> None:
    """A low table, some with a shelf beneath."""
    b, h = kit.base, kit.h
    wood = kit.pick("oak", "walnut", "light_oak", "teak")
    if kit.style == "scandi":
        b.prism(wood, ellipse(kit, n=40, exponent=4), h - 0.025, h, smooth=True)
        k = 0.8
        splayed(kit, wood, h - 0.025, (k * kit.x[0], k * kit.x[1]), (k * kit.y[0], k * kit.y[1]), 0.012, 0.022)
        shelf = 0.62
        b.box(
            "cane",
            (shelf * kit.x[0], shelf * kit.x[1]),
            (shelf * kit.y[0], shelf * kit.y[1]),
            (0.4 * h, 0.4 * h + 0.012),
        )
    elif kit.style == "industrial":
        b.box(wood, kit.x, kit.y, (h - 0.04, h))
        metal_frame(kit, "black_metal", h - 0.04, 0.03)
        b.box(wood, (kit.x[0] + 0.081, kit.x[1] - 0.081), (kit.y[0] + 0.062, kit.y[1] - 0.062), (0.12, 0.14))
    elif kit.style == "drum":
        b.prism(kit.pick("walnut", "oak", "white"), ellipse(kit, n=48), h - 0.025, h, smooth=True)
        b.fill = 0.12
        b.prism(kit.pick(wood, wood, "brass"), ellipse(kit, 0.8, n=32), 0.0, h - 0.024, smooth=True)
        b.fill = 1.0
    elif kit.style == "marble":
        b.prism(kit.pick("marble", "dark_marble"), ellipse(kit, n=40, exponent=3), h - 0.022, h, smooth=True)
        _wire(kit, kit.pick("brass", "black_metal"), h - 0.022)
    elif kit.style == "glass":
        b.rounded("glass", kit.x, kit.y, (h - 0.012, h), 0.005)
        metal_frame(kit, kit.pick("brass", "chrome", "black_metal"), h - 0.012, 0.02)
        b.box("smoked_glass", (kit.x[0] + 0.071, kit.x[1] - 0.071), (kit.y[0] + 0.062, kit.y[1] - 0.062), (0.1, 0.108))
    else:
        b.box(wood, kit.x, kit.y, (h - 0.05, h))
        for y in (kit.y[0], kit.y[1] - 0.05):
            b.box(wood, (kit.x[0] + 0.001, kit.x[1] - 0.001), (y, y + 0.05), (0, h - 0.05))
        b.box(
            wood, (kit.x[0] + 0.02, kit.x[1] - 0.02), (kit.y[0] + 0.05, kit.y[1] - 0.05), (0.25 * h, 0.25 * h + 0.025)
        )


def _wire(kit: Kit, metal: str, z: float) -> None:
    b, k = kit.base, 0.62
    x, y = k * kit.d / 2, k * kit.w / 2
    for s in (-1, 1):
        b.tube(metal, [(-x, s * y, z), (-0.7 * x, s * y, 0.008), (0.7 * x, s * y, 0.008), (x, s * y, z)], 0.008)
        b.rod(metal, (s * 0.7 * x, -y, 0.008), (s * 0.7 * x, y, 0.008), 0.0075, n=8)


@design("side_table", "tripod", "drum", "cube", "pedestal", "rattan")
def side_table(kit: Kit) -> None:
    """A small table beside a seat."""
    b, h = kit.base, kit.h
    wood, r = kit.pick("oak", "walnut", "white", "light_oak"), min(kit.d, kit.w) / 2
    if kit.style == "cube":
        square_legs(kit, "black_metal", h - 0.02, 0.02)
        b.box(wood, kit.x, kit.y, (h - 0.02, h))
        b.box(wood, (kit.x[0] + 0.021, kit.x[1] - 0.021), (kit.y[0] + 0.001, kit.y[1] - 0.001), (0.1, 0.118))
        return
    top = {"pedestal": kit.pick("marble", "dark_marble", wood), "rattan": "rattan"}.get(kit.style, wood)
    b.prism(top, ellipse(kit, n=32), h - 0.022, h, smooth=True)
    if kit.style == "drum":
        b.prism(wood, ellipse(kit, 0.9, 32), 0, 0.02, smooth=True)
        for i in range(10):
            a = 2 * np.pi * i / 10
            p = (0.42 * kit.d * np.cos(a), 0.42 * kit.w * np.sin(a))
            b.rod("black_metal", (*p, 0.018), (*p, h - 0.02), 0.006, n=8)
    elif kit.style == "pedestal":
        tulip(kit, kit.pick("brass", "black_metal"), (0, 0), h - 0.022, 0.6 * r)
    elif kit.style == "rattan":
        b.fill = 0.4
        b.turned("rattan", [(0.7 * r, 0), (0.55 * r, 0.5 * h), (0.8 * r, h - 0.022)], n=20)
        b.fill = 1.0
    else:
        b.turned(wood, [(0.028, 0.2), (0.036, 0.28), (0.018, 0.55 * h), (0.028, h - 0.08), (0.06, h - 0.022)], n=16)
        tripod(kit, wood, 0.82 * r, 3)


@design("console_table", "classic", "industrial", "scandi", "glass")
def console_table(kit: Kit) -> None:
    """A narrow table along a wall."""
    b, h = kit.base, kit.h
    wood = kit.pick("oak", "walnut", "white")
    if kit.style == "glass":
        b.rounded("glass", kit.x, kit.y, (h - 0.012, h), 0.005)
        metal_frame(kit, "brass", h - 0.012, 0.022)
        return
    b.box(wood, kit.x, kit.y, (h - 0.025, h))
    if kit.style == "industrial":
        metal_frame(kit, "black_metal", h - 0.025, 0.025)
        b.box(wood, (kit.x[0] + 0.051, kit.x[1] - 0.051), (kit.y[0] + 0.086, kit.y[1] - 0.086), (0.16, 0.18))
        for y in (kit.y[0] + 0.06, kit.y[1] - 0.085):
            b.box("black_metal", (kit.x[0] + 0.075, kit.x[1] - 0.075), (y, y + 0.025), (0.155, 0.16))
            b.box("black_metal", (kit.x[0] + 0.055, kit.x[1] - 0.055), (y + 0.002, y + 0.026), (0.161, 0.179))
    elif kit.style == "scandi":
        splayed(
            kit, wood, h - 0.025, (kit.x[0] + 0.01, kit.x[1] - 0.01), (kit.y[0] + 0.02, kit.y[1] - 0.02), 0.011, 0.02
        )
        apron(kit, wood, 0.08, (h - 0.075, h - 0.025))
    else:
        apron(kit, wood, 0.03, (h - 0.12, h - 0.025))
        z = h - 0.025
        for x in (kit.x[0] + 0.045, kit.x[1] - 0.045):
            for y in (kit.y[0] + 0.05, kit.y[1] - 0.05):
                b.turned(
                    wood,
                    [
                        (0.014, 0),
                        (0.024, 0.06),
                        (0.013, 0.1),
                        (0.024, z - 0.22),
                        (0.016, z - 0.18),
                        (0.026, z - 0.13),
                        (0.026, z),
                    ],
                    (x, y, 0),
                    12,
                )
        b.box(wood, (kit.x[0] + 0.045, kit.x[1] - 0.045), (kit.y[0] + 0.05, kit.y[1] - 0.05), (0.13, 0.15))


@design("balcony_table", "folding", "metal", "mosaic", "slatted")
def balcony_table(kit: Kit) -> None:
    """A light table for outdoors."""
    b, h = kit.base, kit.h
    if kit.style in ("metal", "mosaic"):
        colour = kit.pick("black_metal", "sage", "white_metal")
        b.fill = 0.3
        b.prism("terrazzo" if kit.style == "mosaic" else colour, ellipse(kit, n=32), h - 0.02, h, smooth=True)
        tulip(kit, colour, (0, 0), h - 0.02, 0.3 * min(kit.d, kit.w))
        b.fill = 1.0
        return
    n = max(5, round(kit.d / 0.09))
    for i in range(n):
        x = (kit.x[0] + i * kit.d / n, kit.x[0] + (i + 1) * kit.d / n - (0.01 if i < n - 1 else 0))
        b.box("teak", x, kit.y, (h - 0.02, h))
    if kit.style == "slatted":
        square_legs(kit, "teak", h - 0.02, 0.04)
        apron(kit, "teak", 0.04, (h - 0.07, h - 0.02))
        return
    for s in (-1, 1):
        y = s * (kit.w / 2 - 0.06)
        for side, off in ((-1, 0.0), (1, 0.024)):
            at = y - s * off
            b.rod(
                "black_metal",
                (side * (kit.d / 2 - 0.06), at, 0.012),
                (-side * (kit.d / 2 - 0.06), at, h - 0.03),
                0.011,
                n=10,
            )
            b.rod(
                "black_metal",
                (side * (kit.d / 2 - 0.06), at - 0.01, 0.011),
                (side * (kit.d / 2 - 0.06), at + 0.01, 0.011),
                0.011,
                n=10,
            )
        b.box("teak", (kit.x[0] + 0.04, kit.x[1] - 0.04), (y - 0.03, y + 0.03), (h - 0.04, h - 0.02))
