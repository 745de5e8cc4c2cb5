"""Shower, mirror, towel rail, water heater, radiator."""

import numpy as np

from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import GAP, Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.tables import ellipse
from apartgen.stages.things import categories, materials

_PANE = 0.008


@design("shower", "framed", "frameless", "grid")
def shower(kit: Kit) -> None:
    """A tray, glass on three sides with a hinged door in front, and the fittings on the back."""
    b = kit.base
    metal = {"framed": "chrome", "frameless": "chrome", "grid": "black_metal"}[kit.style]
    post = 0.03 if kit.style != "frameless" else 0.015
    tray = 0.05
    b.fill = 0.5
    b.box("acrylic", kit.x, kit.y, (0, 0.025))
    for x in ((kit.x[0], kit.x[0] + 0.06), (kit.x[1] - 0.06, kit.x[1])):
        b.box("acrylic", x, kit.y, (0.025, tray))
    for y in ((kit.y[0], kit.y[0] + 0.06), (kit.y[1] - 0.06, kit.y[1])):
        b.box("acrylic", (kit.x[0] + 0.06, kit.x[1] - 0.06), y, (0.025, tray))
    b.fill = 0.3
    b.rod("chrome", (0, 0, 0.025), (0, 0, 0.028), 0.045)
    front = kit.x[1] - 0.024
    for px in (kit.x[0], front - post):
        for py in (kit.y[0], kit.y[1] - post):
            b.box(metal, (px, px + post), (py, py + post), (tray, kit.h))
    b.fill = 1.0
    for py in (kit.y[0] + 0.004, kit.y[1] - 0.004 - _PANE):
        b.box("glass", (kit.x[0] + post, front - post), (py, py + _PANE), (tray, kit.h - 0.03))
        if kit.style != "frameless":
            b.box(metal, (kit.x[0] + post, front - post), (py - 0.002, py + _PANE + 0.002), (kit.h - 0.03, kit.h))
    _glass_front(kit, metal, front, post, tray)
    _fittings(kit, metal)


def _glass_front(kit: Kit, metal: str, front: float, post: float, tray: float) -> None:
    b = kit.base
    n = categories.leaves("shower", kit.w)
    wide = kit.w / n
    door = (kit.y[1] - wide, kit.y[1]) if n > 1 else (kit.y[0] + post + 0.004, kit.y[1])
    fixed = (kit.y[0] + post, door[0])
    if n > 1:
        b.box("glass", (front - _PANE - 0.004, front - 0.004), (fixed[0], fixed[1] - 0.02), (tray, kit.h - 0.03))
        b.box(metal, (front - 0.02, front), (fixed[1] - 0.02, fixed[1]), (tray, kit.h - 0.03))
    b.box(metal, (front - 0.02, front), (kit.y[0] + post, kit.y[1] - post), (kit.h - 0.03, kit.h))
    if kit.style == "grid" and n > 1:
        for z in np.linspace(tray, kit.h - 0.03, 6)[1:-1]:
            b.box(
                metal, (front - 0.018, front - 0.013), (fixed[0], fixed[1] - 0.02), (float(z) - 0.006, float(z) + 0.006)
            )
    _glass_door(kit, metal, front, (door[0], door[1]), (tray + 0.01, kit.h - 0.035), n > 1)


def _glass_door(kit: Kit, metal: str, front: float, y: Span, z: Span, free: bool) -> None:
    # The leaf lies in front of the posts; its knob touches the box's front plane, about which it turns.
    body, out = Body(), kit.x[1] - front
    back = front + 0.002
    slack = out**2 / (2 * (y[1] - y[0])) + GAP
    own = (y[0] + slack, y[1] - GAP)
    body.box("glass", (back, back + _PANE), own, z)
    if kit.style == "grid":
        for share in np.linspace(z[0], z[1], 6):
            low = min(max(float(share) - 0.006, z[0]), z[1] - 0.012)
            body.box(metal, (back + _PANE, back + _PANE + 0.003), own, (low, low + 0.012), touch=False)
    body.box(metal, (back + _PANE, kit.x[1]), (own[0] + 0.05, own[0] + 0.065), (0.95, 1.2))
    kit.hinge(
        "door",
        body,
        (kit.x[1], y[1], 1.0),
        (0, 0, 1),
        handle=(kit.x[1], own[0] + 0.058, 1.07),
        grip="line_fixed_handle",
    )


def _fittings(kit: Kit, metal: str) -> None:
    b, x = kit.base, kit.x[0] + 0.03
    top = kit.h - 0.05
    b.tube(metal, [(x, 0, 1.0), (x, 0, top), (min(x + 0.32, 0.05), 0, top)], 0.011)
    end = min(x + 0.32, 0.05)
    b.rod(metal, (end, 0, top - 0.03), (end, 0, top - 0.012), 0.1, n=20)
    b.rod(metal, (x, -0.12, 1.05), (x, 0.12, 1.05), 0.022)
    b.box(metal, (kit.x[0], x), (-0.03, 0.03), (1.03, 1.07))


_PANE = 0.004
"""Thickness of a mirror's glass, m."""
_BACK, _BOARD = 350.0, 0.03
"""What the frame and the back of a mirror weigh by their volume, kg/m³, and how thick they are at most, m."""


@design("mirror", "frame", "round", "arch", "plain")
def mirror(kit: Kit) -> None:
    """Glass in a frame, oval, arched or bare."""
    b, t = kit.base, min(0.03, 0.07 * kit.w)
    frame = kit.pick("oak", "black_metal", "brass", "walnut", "white")
    middle = np.array([0, kit.h / 2])
    glass = (kit.x[1] - min(0.012, 0.4 * kit.d), kit.x[1] - min(0.008, 0.3 * kit.d))
    if kit.style in ("round", "arch"):
        angle = 2 * np.pi * np.arange(48) / 48
        unit = np.stack([np.sin(angle), np.cos(angle)], 1)
        if kit.style == "arch":
            r = min(kit.w / 2, kit.h / 2)
            arch = unit * [kit.w / 2, r] + [0, kit.h - r]
            outline = np.array(
                [
                    [-kit.w / 2, 0],
                    [kit.w / 2, 0],
                    *arch[(arch[:, 1] >= kit.h - r - 1e-9)][np.argsort(-arch[arch[:, 1] >= kit.h - r - 1e-9][:, 0])],
                ]
            )
        else:
            outline = unit * [kit.w / 2, kit.h / 2] + middle
        shrunk = (outline - middle) * [1 - 2 * t / kit.w, 1 - 2 * t / kit.h] + middle
        b.fill = _hollow(frame, kit.d)
        b.prism(frame, outline, kit.x[0], glass[0], 0)
        b.fill = min(1.0, _PANE / (kit.x[1] - glass[0]))
        b.prism("mirror", shrunk, glass[0], kit.x[1], 0)
        b.fill = 1.0
        return
    if kit.style == "plain":
        b.box("mirror", (kit.x[1] - min(0.006, 0.3 * kit.d), kit.x[1]), kit.y, (0, kit.h))
        b.fill = _hollow("plastic_grey", kit.d)
        b.box(
            "plastic_grey",
            (kit.x[0], kit.x[1] - min(0.006, 0.3 * kit.d)),
            (kit.y[0] + 0.03, kit.y[1] - 0.03),
            (0.03, kit.h - 0.03),
        )
        b.fill = 1.0
        return
    b.fill = _hollow(frame, kit.d)
    for side in ((kit.y[0], kit.y[0] + t), (kit.y[1] - t, kit.y[1])):
        b.box(frame, kit.x, side, (0, kit.h))
    inner = (kit.y[0] + t, kit.y[1] - t)
    for z in ((0, t), (kit.h - t, kit.h)):
        b.box(frame, kit.x, inner, z)
    b.box(frame, (kit.x[0], glass[0]), inner, (t, kit.h - t))
    b.fill = min(1.0, _PANE / (glass[1] - glass[0]))
    b.box("mirror", glass, inner, (t, kit.h - t))
    b.fill = 1.0


def _hollow(frame: str, deep: float) -> float:
    """Share of a mirror's frame and back that is solid: a thin board of wood, or sheet metal before one."""
    return min(1.0, _BACK / materials.density(frame)) * min(1.0, _BOARD / deep)


@design("towel_rail", "ladder", "bars")
def towel_rail(kit: Kit) -> None:
    """A heated ladder of tubes or plain bars, a towel over one of them."""
    b, metal, r = kit.base, kit.pick("chrome", "black_metal", "white_metal"), 0.014
    b.fill = 0.3
    x = kit.x[1] - r - 0.012
    for s in (-1, 1):
        at = s * (kit.w / 2 - r)
        b.rod(metal, (x, at, 0), (x, at, kit.h), r)
        for z in (0.1 * kit.h, 0.9 * kit.h):
            b.rod(metal, (kit.x[0], at, z), (x, at, z), 0.008, n=8)
    n = max(3, round(kit.h / (0.07 if kit.style == "ladder" else 0.16)))
    towel = n - 2
    for i in range(n):
        z = 0.04 + i * (kit.h - 0.08) / (n - 1)
        b.rod(metal, (x, kit.y[0] + r, z), (x, kit.y[1] - r, z), 0.009, n=8)
        if i == towel:
            b.fill = 1.0
            half, low = 0.32 * kit.w, max(0.03, z - 0.35)
            b.box("towel", (x + 0.014, kit.x[1]), (-half, half), (low, z + 0.02))
            b.box("towel", (x - 0.0145, x + 0.014), (-half, half), (z + 0.01, z + 0.0195))
            b.fill = 0.3
    b.fill = 1.0


@design("water_heater", "tank", "slim")
def water_heater(kit: Kit) -> None:
    """A hung tank with its connections below."""
    b, low = kit.base, 0.05
    b.fill = 0.2
    if kit.style == "tank":
        b.prism("enamel", ellipse(kit, 1.0, 32), low + 0.03, kit.h - 0.03, smooth=True)
        b.prism("plastic_grey", ellipse(kit, 0.94, 32), low, low + 0.03, smooth=True)
        b.prism("plastic_grey", ellipse(kit, 0.94, 32), kit.h - 0.03, kit.h, smooth=True)
        b.box("screen", (kit.x[1] - 0.012, kit.x[1] - 0.002), (-0.04, 0.04), (low + 0.12, low + 0.17), touch=False)
    else:
        face = kit.x[1] - 0.014
        b.rounded("enamel", (kit.x[0], face), kit.y, (low + 0.07, kit.h), 0.04, 3)
        b.rounded("plastic_grey", (kit.x[0] + 0.008, face - 0.008), (kit.y[0] + 0.008, kit.y[1] - 0.008),
                  (low, low + 0.09), 0.03, 3)  # fmt: skip
        b.turned("plastic_grey", [(0.035, 0), (0.032, 0.016)], (kit.x[1] - 0.016, 0.0, low + 0.19), 24, along=(1, 0, 0))
        b.box("screen", (face - 0.004, face + 0.002), (-0.05, 0.05), (low + 0.27, low + 0.31), touch=False)
    for y in (-0.06, 0.06):
        b.rod("copper", (0, y, 0), (0, y, low + 0.005), 0.011, n=10)
    b.fill = 1.0


@design("radiator", "panel", "column", "flat")
def radiator(kit: Kit) -> None:
    """A panel radiator with its grille, or columns."""
    b, metal = kit.base, "white_metal" if kit.style != "flat" else kit.pick("graphite", "white_metal")
    b.fill = 0.12
    if kit.style == "column":
        n = max(4, round(kit.w / 0.055))
        r = min(0.02, kit.w / n / 2 - 0.001, kit.d / 4)
        for i in range(n):
            y = kit.y[0] + r + i * (kit.w - 2 * r) / (n - 1)
            for px in (kit.x[0] + r, kit.x[1] - r):
                b.rod(metal, (px, y, 0.05), (px, y, kit.h - 0.02), r, n=8)
        for z in ((0.0, 0.05), (kit.h - 0.05, kit.h)):
            b.box(metal, (kit.x[0], kit.x[1]), (kit.y[0], kit.y[1]), z)
        b.fill = 1.0
        return
    thin = min(0.02, 0.3 * kit.d)
    for x in ((kit.x[1] - thin, kit.x[1] - 0.004), (kit.x[0], kit.x[0] + thin)):
        b.box(metal, x, kit.y, (0.02, kit.h - 0.015))
    b.box(metal, (kit.x[0], kit.x[1] - 0.004), kit.y, (kit.h - 0.015, kit.h))
    n = max(6, round(kit.w / 0.045))
    if kit.style == "flat":
        b.box(
            metal,
            (kit.x[1] - 0.004, kit.x[1]),
            (kit.y[0] + 0.004, kit.y[1] - 0.004),
            (0.024, kit.h - 0.02),
            touch=False,
        )
        n = 0
    for i in range(n):
        y = kit.y[0] + (i + 0.2) * kit.w / n
        b.box(metal, (kit.x[1] - 0.004, kit.x[1]), (y, y + 0.6 * kit.w / n), (0.05, kit.h - 0.05), touch=False)
    b.rod("chrome", (0, kit.y[1] - 0.03, 0), (0, kit.y[1] - 0.03, 0.06), 0.008, n=8)
    b.rod("chrome", (0, kit.y[0] + 0.03, 0), (0, kit.y[0] + 0.03, 0.06), 0.008, n=8)
    b.fill = 1.0
