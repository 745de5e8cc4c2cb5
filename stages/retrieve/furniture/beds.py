"""Double, single and bunk beds, and cots; the head is at the back."""

import numpy as np

from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit

_DUVETS = ("duvet_blue", "duvet_sand", "duvet_green", "duvet_rose", "duvet_grey", "bedding")
STYLES = ("platform", "upholstered", "scandi", "classic", "metal")


@design("double_bed", *STYLES)
@design("single_bed", *STYLES)
def bed(kit: Kit) -> None:
    """Frame, headboard as high as the box, mattress, duvet and pillows."""
    soft_top = min(0.56, kit.h - 0.02)
    pillow = 0.12
    top = min(soft_top - pillow, 0.48)
    board, rail = {"platform": (0.05, 0.05), "upholstered": (0.1, 0.06), "scandi": (0.04, 0.03),
                   "classic": (0.06, 0.035), "metal": (0.03, 0.03)}[kit.style]  # fmt: skip
    inner_x = (kit.x[0] + board, kit.x[1] - rail - 0.005)
    inner_y = (kit.y[0] + rail + 0.005, kit.y[1] - rail - 0.005)
    frame = max(0.1, top - 0.18)
    {"platform": _platform, "upholstered": _upholstered, "scandi": _scandi, "classic": _classic, "metal": _metal}[
        kit.style
    ](kit, board, rail, frame)
    bedding(kit, inner_x, inner_y, frame - 0.02, top, pillow, 2 if kit.w > 1.35 else 1)


def bedding(kit: Kit, x: Span, y: Span, low: float, top: float, pillow: float, sleepers: int) -> None:
    """Mattress from `low` to `top`, a duvet turned back below the pillows."""
    b, duvet = kit.base, kit.pick(*_DUVETS)
    b.rounded("mattress", x, y, (low, top), 0.05)
    fold = x[0] + 0.62
    b.rounded(duvet, (fold, x[1] - 0.002), (y[0] - 0.004, y[1] + 0.004), (top - 0.1, top + 0.05), 0.045)
    b.rounded("bedding", (fold - 0.16, fold + 0.12), (y[0] - 0.002, y[1] + 0.002), (top - 0.08, top + 0.06), 0.05)
    wide = (y[1] - y[0]) / sleepers
    for i in range(sleepers):
        middle = y[0] + (i + 0.5) * wide
        half = min(0.36, wide / 2 - 0.03)
        b.pillow("bedding", (x[0] + 0.03, x[0] + 0.45), (middle - half, middle + half), (top - 0.01, top + pillow), 3.0)


def _platform(kit: Kit, board: float, rail: float, frame: float) -> None:
    b, wood = kit.base, kit.pick("oak", "walnut", "light_oak", "ash_black")
    b.box(wood, (kit.x[0], kit.x[0] + board), kit.y, (0.0, kit.h))
    _rails(kit, wood, rail, board, 0.08, frame + 0.04)
    b.fill = 0.15
    b.box("graphite", (kit.x[0] + 0.2, kit.x[1] - 0.25), (kit.y[0] + 0.2, kit.y[1] - 0.2), (0, 0.08))
    b.fill = 1.0


def _rails(kit: Kit, material: str, rail: float, board: float, low: float, high: float) -> None:
    b = kit.base
    for y in ((kit.y[0], kit.y[0] + rail), (kit.y[1] - rail, kit.y[1])):
        b.box(material, (kit.x[0] + board, kit.x[1] - rail), y, (low, high))
    b.box(material, (kit.x[1] - rail, kit.x[1]), kit.y, (low, high))
    slats = max(low, high - 0.09)
    b.box("pine", (kit.x[0] + board, kit.x[1] - rail), (kit.y[0] + rail, kit.y[1] - rail), (slats, slats + 0.02))


def _upholstered(kit: Kit, board: float, rail: float, frame: float) -> None:
    b, cloth = kit.base, kit.pick("grey_fabric", "linen", "green_velvet", "blue_velvet", "rose_velvet", "cream_boucle")
    b.fill = 3.0
    n = max(2, round(kit.w / 0.28))
    wide = kit.w / n
    b.box(cloth, (kit.x[0], kit.x[0] + 0.04), kit.y, (0.0, kit.h - 0.02))
    for i in range(n):
        y = (kit.y[0] + i * wide, kit.y[0] + (i + 1) * wide)
        b.pillow(cloth, (kit.x[0] + 0.005, kit.x[0] + board), y, (max(0.2, frame - 0.05), kit.h), 6, 4)
    for y in ((kit.y[0], kit.y[0] + rail), (kit.y[1] - rail, kit.y[1])):
        b.rounded(cloth, (kit.x[0] + 0.04, kit.x[1] - 0.01), y, (0.05, frame + 0.04), 0.025)
    b.rounded(cloth, (kit.x[1] - rail, kit.x[1]), kit.y, (0.05, frame + 0.04), 0.025)
    b.fill = 1.0
    b.box("pine", (kit.x[0] + 0.04, kit.x[1] - rail), (kit.y[0] + rail, kit.y[1] - rail), (frame - 0.05, frame - 0.025))
    for x in (kit.x[0] + 0.1, kit.x[1] - 0.1):
        for py in (kit.y[0] + 0.1, kit.y[1] - 0.1):
            b.rod("black_metal", (x, py, 0), (x, py, 0.055), 0.018, 0.025, 10)


def _scandi(kit: Kit, board: float, rail: float, frame: float) -> None:
    b, wood = kit.base, kit.pick("oak", "birch", "light_oak")
    _rails(kit, wood, rail, board, frame - 0.06, frame + 0.03)
    for y in ((kit.y[0], kit.y[0] + 0.045), (kit.y[1] - 0.045, kit.y[1])):
        b.box(wood, (kit.x[0], kit.x[0] + board), y, (0, kit.h - 0.03))
    b.box(wood, (kit.x[0], kit.x[0] + board), kit.y, (kit.h - 0.03, kit.h))
    b.box(
        wood,
        (kit.x[0] + 0.004, kit.x[0] + board - 0.004),
        (kit.y[0] + 0.045, kit.y[1] - 0.045),
        (frame - 0.05, frame + 0.03),
    )
    n = max(5, round(kit.w / 0.12))
    if kit.h - frame > 0.15:
        for i in range(1, n):
            at = (kit.x[0] + board / 2, kit.y[0] + 0.045 + i * (kit.w - 0.09) / n)
            b.rod(wood, (*at, frame + 0.03), (*at, kit.h - 0.03), 0.009, n=8)
    foot = kit.x[1] - 0.1
    for s in (-1, 1):
        b.leg(
            wood, (foot + 0.03, s * (kit.w / 2 - 0.06), 0), (foot, s * (kit.w / 2 - 0.07), frame - 0.06), 0.015, 0.025
        )


def _classic(kit: Kit, board: float, rail: float, frame: float) -> None:
    b, wood = kit.base, kit.pick("cherry", "walnut", "cream", "dark_oak")
    foot = min(kit.h, frame + 0.22)
    _rails(kit, wood, rail, board, frame - 0.1, frame + 0.04)
    for x, tall in ((kit.x[0] + 0.03, kit.h), (kit.x[1] - 0.03, foot)):
        for s in (-1, 1):
            y = s * (kit.w / 2 - 0.035)
            knee = 0.55 * tall
            b.turned(wood, [(0.018, 0), (0.03, 0.06), (0.03, knee), (0.02, knee + 0.03), (0.03, knee + 0.08),
                            (0.026, tall - 0.05), (0.03, tall - 0.025), (0.012, tall)], (x, y, 0), 12)  # fmt: skip
    b.box(wood, (kit.x[0], kit.x[0] + 0.005), (-0.1, 0.1), (0.3 * kit.h, 0.32 * kit.h))
    for s in (-1, 1):
        ghost = sorted((s * kit.w / 2, s * (kit.w / 2 - 0.03)))
        b.box(wood, (kit.x[0] + 0.01, kit.x[1] - 0.01), (ghost[0], ghost[1]), (frame - 0.06, frame + 0.0))
    if kit.h - frame > 0.2:
        b.box(
            wood, (kit.x[0] + 0.012, kit.x[0] + 0.048), (kit.y[0] + 0.06, kit.y[1] - 0.06), (frame - 0.05, kit.h - 0.1)
        )
        b.box(
            wood,
            (kit.x[0] + 0.005, kit.x[0] + 0.055),
            (kit.y[0] + 0.055, kit.y[1] - 0.055),
            (kit.h - 0.1, kit.h - 0.06),
        )
    b.box(wood, (kit.x[1] - 0.05, kit.x[1] - 0.01), (kit.y[0] + 0.06, kit.y[1] - 0.06), (frame - 0.1, foot - 0.05))
    b.box(wood, (kit.x[1] - rail, kit.x[1]), (kit.y[0] + 0.08, kit.y[1] - 0.08), (frame - 0.1, frame + 0.02))


def _metal(kit: Kit, board: float, rail: float, frame: float) -> None:
    b, metal, r = kit.base, kit.pick("black_metal", "white_metal", "brass"), 0.015
    b.fill = 0.25
    foot = min(kit.h, frame + 0.2)
    for x, tall in ((kit.x[0] + r, kit.h), (kit.x[1] - r, foot)):
        y = kit.w / 2 - r
        b.tube(metal, [(x, -y, 0), (x, -y, tall - r), (x, y, tall - r), (x, y, 0)], r)
        n = max(4, round(kit.w / 0.16))
        low = frame - 0.04
        b.rod(metal, (x, -y + r, low), (x, y - r, low), 0.01, n=8)
        if tall - r - low > 0.12:
            for i in range(1, n):
                at = -y + i * 2 * y / n
                b.rod(metal, (x, at, low + 0.008), (x, at, tall - 2 * r + 0.002), 0.006, n=8)
    for s in (-1, 1):
        lo, hi = sorted((s * kit.w / 2, s * (kit.w / 2 - 0.03)))
        b.box(metal, (kit.x[0] + 2 * r, kit.x[1] - 2 * r), (lo, hi), (frame - 0.05, frame + 0.01))
    b.fill = 1.0
    b.box(
        "pine", (kit.x[0] + 2 * r, kit.x[1] - 2 * r), (kit.y[0] + 0.03, kit.y[1] - 0.03), (frame - 0.05, frame - 0.025)
    )


@design("bunk_bed", "pine", "white", "metal")
def bunk_bed(kit: Kit) -> None:
    """Two berths, guard rails and a ladder at the front of the foot end."""
    b = kit.base
    wood = {"pine": "pine", "white": "white", "metal": "graphite"}[kit.style]
    s = 0.04 if kit.style == "metal" else 0.06
    b.fill = 0.2 if kit.style == "metal" else 1.0
    for x in ((kit.x[0], kit.x[0] + s), (kit.x[1] - s, kit.x[1])):
        for y in ((kit.y[0], kit.y[0] + s), (kit.y[1] - s, kit.y[1])):
            b.box(wood, x, y, (0, kit.h))
        for z in (0.3, kit.h - 0.42, kit.h - 0.12, 0.62):
            b.box(wood, (x[0] + 0.005, x[1] - 0.005), (kit.y[0] + s, kit.y[1] - s), (z, z + 0.08))
    inner_x, ladder = (kit.x[0] + s, kit.x[1] - s), kit.x[1] - s - 0.42
    for z in (0.22, kit.h - 0.45):
        for y in ((kit.y[0] + 0.005, kit.y[0] + 0.03), (kit.y[1] - 0.03, kit.y[1] - 0.005)):
            b.box(wood, inner_x, y, (z, z + 0.12))
        b.box("pine", inner_x, (kit.y[0] + 0.03, kit.y[1] - 0.03), (z + 0.01, z + 0.03))
    b.box(wood, inner_x, (kit.y[0] + 0.005, kit.y[0] + 0.03), (kit.h - 0.09, kit.h - 0.01))
    b.box(wood, (inner_x[0], ladder), (kit.y[1] - 0.03, kit.y[1] - 0.005), (kit.h - 0.09, kit.h - 0.01))
    b.box(wood, (ladder, ladder + 0.035), (kit.y[1] - 0.03, kit.y[1]), (0, kit.h - 0.005))
    for z in np.arange(0.5, kit.h - 0.5, 0.26):
        b.box(wood, (ladder + 0.035, kit.x[1] - s), (kit.y[1] - 0.03, kit.y[1] - 0.004), (z, z + 0.035))
    b.fill = 1.0
    for z in (0.25, kit.h - 0.42):
        bedding(kit, (inner_x[0] + 0.01, inner_x[1] - 0.01), (kit.y[0] + 0.04, kit.y[1] - 0.04), z, z + 0.13, 0.1, 1)


@design("cot", "slatted", "turned", "modern")
def cot(kit: Kit) -> None:
    """Barred sides, solid or barred ends, a mattress."""
    b, wood = kit.base, kit.pick("white", "birch", "light_oak", "greige")
    s, rail, low = 0.04, 0.025, 0.22
    for px in (kit.x[0] + s / 2, kit.x[1] - s / 2):
        for py in (kit.y[0] + s / 2, kit.y[1] - s / 2):
            if kit.style == "turned":
                b.turned(
                    wood,
                    [
                        (0.012, 0),
                        (s / 2, 0.05),
                        (s / 2, kit.h - 0.05),
                        (0.012, kit.h - 0.03),
                        (0.018, kit.h - 0.012),
                        (0.008, kit.h),
                    ],
                    (px, py, 0),
                    12,
                )
            else:
                b.box(wood, (px - s / 2, px + s / 2), (py - s / 2, py + s / 2), (0, kit.h))
    high = kit.h - 0.08
    for y in ((kit.y[0] + 0.008, kit.y[0] + 0.008 + rail), (kit.y[1] - 0.008 - rail, kit.y[1] - 0.008)):
        x = (kit.x[0] + s, kit.x[1] - s)
        _bars(kit, wood, x, y, low, high)
    across = (kit.y[0] + s, kit.y[1] - s)
    for end in ((kit.x[0] + 0.008, kit.x[0] + 0.008 + rail), (kit.x[1] - 0.008 - rail, kit.x[1] - 0.008)):
        if kit.style == "modern":
            b.box(wood, end, across, (low, high))
        else:
            _bars(kit, wood, end, across, low, high)
    inner = (kit.x[0] + s, kit.x[1] - s), (kit.y[0] + s, kit.y[1] - s)
    b.box("birch", *inner, (low, low + 0.02))
    b.rounded("mattress", *inner, (low + 0.02, low + 0.13), 0.03)
    b.rounded(
        kit.pick("duvet_blue", "duvet_rose", "duvet_green"),
        (-0.1 * kit.d, inner[0][1] - 0.01),
        (inner[1][0] + 0.01, inner[1][1] - 0.01),
        (low + 0.11, low + 0.16),
        0.024,
    )


def _bars(kit: Kit, wood: str, x: Span, y: Span, low: float, high: float) -> None:
    b = kit.base
    for z in (low, high):
        b.box(wood, x, y, (z, z + 0.04))
    along = 0 if x[1] - x[0] > y[1] - y[0] else 1
    run = (x, y)[along]
    n = max(2, round((run[1] - run[0]) / 0.085))
    middle = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2)
    for i in range(1, n):
        at = run[0] + i * (run[1] - run[0]) / n
        p = (at, middle[1]) if along == 0 else (middle[0], at)
        b.rod(wood, (*p, low + 0.04), (*p, high), 0.008, n=8)
