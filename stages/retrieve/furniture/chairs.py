"""Chairs, stools, benches, office and balcony chairs; a sitter looks along +x."""

import numpy as np

from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit

_WOODS = ("oak", "walnut", "birch", "ash_black")


def square_legs(kit: Kit, wood: str, high: float, s: float = 0.035, back: float | None = None) -> None:
    """Four square legs at the corners of the footprint; the back ones may rise higher."""
    for px, top in ((kit.x[0], high if back is None else back), (kit.x[1] - s, high)):
        for py in (kit.y[0], kit.y[1] - s):
            kit.base.box(wood, (px, px + s), (py, py + s), (0, top))


def splayed(kit: Kit, material: str, high: float, x: Span, y: Span, r: float = 0.011, top: float = 0.018) -> None:
    """Four round legs from inside the seat out to the corners of (x, y); the bounds are met at the floor."""
    for fx in x:
        for fy in y:
            sx, sy = np.sign(fx), np.sign(fy)
            foot = (fx - sx * r, fy - sy * r, 0.0)
            kit.base.leg(material, foot, (fx - sx * (r + 0.07), fy - sy * (r + 0.06), high), r, top)


@design("chair", "ladder_back", "windsor")
def wooden_chair(kit: Kit) -> None:
    """A wooden seat with slats or spindles in the back."""
    b, wood, seat = kit.base, kit.pick(*_WOODS), 0.45
    if kit.style == "ladder_back":
        square_legs(kit, wood, seat - 0.02, 0.036, kit.h)
        b.box(wood, (kit.x[0] + 0.036, kit.x[1]), kit.y, (seat - 0.02, seat))
        inner = (kit.y[0] + 0.036, kit.y[1] - 0.036)
        for py in (kit.y[0] + 0.006, kit.y[1] - 0.03):
            b.box(wood, (kit.x[0] + 0.036, kit.x[1] - 0.036), (py, py + 0.024), (seat - 0.08, seat - 0.02))
        for z in np.linspace(seat + 0.1, kit.h - 0.07, 4):
            b.box(wood, (kit.x[0] + 0.008, kit.x[0] + 0.026), inner, (float(z), float(z) + 0.055))
        return
    b.rounded(wood, (kit.x[0] + 0.03, kit.x[1] - 0.0), kit.y, (seat - 0.035, seat), 0.017)
    splayed(kit, wood, seat - 0.03, kit.x, (kit.y[0] + 0.02, kit.y[1] - 0.02))
    n = max(6, round(kit.w / 0.065))
    for i in range(n):
        y = (i / (n - 1) - 0.5) * (kit.w - 0.08)
        b.rod(wood, (kit.x[0] + 0.06, y, seat - 0.01), (kit.x[0] + 0.02, y * 0.98, kit.h - 0.03), 0.007, n=8)
    b.rounded(wood, (kit.x[0], kit.x[0] + 0.035), (kit.y[0] + 0.01, kit.y[1] - 0.01), (kit.h - 0.055, kit.h), 0.016)


@design("chair", "upholstered", "shell", "cantilever")
def soft_chair(kit: Kit) -> None:
    """A padded or moulded seat and back on wooden or steel legs."""
    b, seat = kit.base, 0.46
    cloth = kit.pick("grey_fabric", "green_velvet", "mustard_fabric", "tan_leather", "blue_fabric")
    if kit.style == "cantilever":
        _cantilever(kit, cloth, seat)
        return
    if kit.style == "shell":
        cover = kit.pick("plastic_white", "plastic_black", "sage", "mustard_fabric")
        _moulded(kit, cover, seat)
        splayed(kit, kit.pick("oak", "walnut"), seat - 0.035, (kit.x[0], kit.x[1]), kit.y)
        return
    b.fill = 3.0
    b.rounded(cloth, (kit.x[0] + 0.03, kit.x[1]), kit.y, (seat - 0.09, seat), 0.03)
    b.pillow(cloth, (kit.x[0], kit.x[0] + 0.09), (kit.y[0] + 0.01, kit.y[1] - 0.01), (seat - 0.04, kit.h), 4.5)
    b.fill = 1.0
    splayed(
        kit,
        kit.pick("walnut", "black_metal", "oak"),
        seat - 0.08,
        (kit.x[0] + 0.03, kit.x[1] - 0.02),
        (kit.y[0] + 0.02, kit.y[1] - 0.02),
    )


def _moulded(kit: Kit, cover: str, seat: float) -> None:
    """One shell for seat and back, dished across, 12 mm thick."""
    d, h, m = kit.d, kit.h, 7
    path = np.array(
        [
            (kit.x[1], seat - 0.02),
            (kit.x[1] - 0.1 * d, seat),
            (kit.x[1] - 0.45 * d, seat - 0.015),
            (kit.x[0] + 0.3 * d, seat - 0.01),
            (kit.x[0] + 0.17 * d, seat + 0.05),
            (kit.x[0] + 0.1 * d, seat + 0.15),
            (kit.x[0] + 0.04 * d, 0.55 * seat + 0.45 * h),
            (kit.x[0] + 0.012, h - 0.05),
            (kit.x[0] + 0.012, h),
        ]
    )
    half = kit.w / 2 * np.array([0.86, 0.94, 1.0, 0.97, 0.94, 0.95, 0.92, 0.78, 0.52])
    dish = np.array([0.0, 0.005, 0.02, 0.025, 0.03, 0.035, 0.03, 0.02, 0.012])
    step = np.gradient(path, axis=0)
    normal = np.stack([step[:, 1], -step[:, 0]], 1) / np.linalg.norm(step, axis=1, keepdims=True)
    across = np.linspace(-1, 1, m)
    flat = path[:, None] + (dish[:, None] * across**2)[..., None] * np.abs(normal)[:, None]
    upper = np.stack([flat[..., 0], half[:, None] * across, flat[..., 1]], -1)
    shift = np.stack([normal[:, 0], 0 * half, normal[:, 1]], 1)
    shift[0], shift[-1] = [0, 0, -1], [-1, 0, 0]
    shift *= np.sign(shift @ np.array([-1.0, 0, -1.0]))[:, None]
    kit.base.slab(cover, upper, upper + 0.012 * shift[:, None])


def _cantilever(kit: Kit, cloth: str, seat: float) -> None:
    b, r = kit.base, 0.0125
    b.fill = 0.25
    for s in (-1, 1):
        y = s * (kit.w / 2 - r)
        x0, x1 = kit.x[0] + r, kit.x[1] - r
        back = [(x0 + 0.03, y, seat - 0.03), (x0 + 0.01, y, seat + 0.08), (x0 + 0.01, y, kit.h)]
        b.tube("chrome", [(kit.x[0], y, r), (x1, y, r), (x1, y, seat - 0.03), *back], r, 8)
    inner = (kit.y[0] + 2 * r, kit.y[1] - 2 * r)
    b.rod("chrome", (kit.x[0] + r, inner[0] - r, r), (kit.x[0] + r, inner[1] + r, r), r * 0.9)
    b.fill = 3.0
    b.rounded(cloth, (kit.x[0] + 0.05, kit.x[1] - 0.01), inner, (seat - 0.045, seat), 0.02)
    b.rounded(cloth, (kit.x[0] + 0.004, kit.x[0] + 0.045), inner, (seat + 0.1, kit.h - 0.01), 0.018)
    b.fill = 1.0


@design("stool", "round", "bar", "industrial", "upholstered")
def stool(kit: Kit) -> None:
    """A seat on four legs with a foot ring or rungs."""
    b, t = kit.base, np.arange(24) * np.pi / 12
    ring = np.stack([kit.d / 2 * np.cos(t), kit.w / 2 * np.sin(t)], 1)
    wood = kit.pick("oak", "walnut", "birch")
    metal = kit.style == "industrial"
    leg = "black_metal" if metal else wood
    thick = 0.035 if not metal else 0.025
    if kit.style == "upholstered":
        b.fill = 3.0
        b.pillow(kit.pick("green_velvet", "tan_leather", "grey_fabric"), kit.x, kit.y, (kit.h - 0.09, kit.h), 2.6)
        b.fill, thick = 1.0, 0.08
    elif kit.style == "bar":
        b.rounded(wood, kit.x, kit.y, (kit.h - thick, kit.h), 0.015)
    else:
        b.prism(wood, ring, kit.h - thick, kit.h, smooth=True)
    reach = (
        (kit.x, kit.y)
        if kit.style == "bar"
        else ((0.71 * kit.x[0], 0.71 * kit.x[1]), (0.71 * kit.y[0], 0.71 * kit.y[1]))
    )
    splayed(kit, leg, kit.h - thick, *reach, r=0.011, top=0.013 if metal else 0.017)
    if kit.h > 0.55:
        z = 0.32 * kit.h
        for s in (-1, 1):
            lean = (z / (kit.h - thick)) * 0.06 + 0.015
            x, y = reach[0][1] - lean - 0.006, reach[1][1] - lean
            b.rod(leg, (-x, s * y, z), (x, s * y, z), 0.007, n=8)
            b.rod(leg, (s * x, -y, z + 0.03), (s * x, y, z + 0.03), 0.007, n=8)


@design("bench", "plain", "upholstered", "slatted", "industrial")
def bench(kit: Kit) -> None:
    """A long seat; taller ones have a back."""
    wood = kit.pick("oak", "walnut", "pine") if kit.style != "slatted" else kit.pick("teak", "white", "sage")
    metal = kit.style == "industrial"
    # Only a plain bench has a pad, where there is height for one.
    padded = kit.style == "plain" and 0.47 <= kit.h <= 0.52
    b, seat = kit.base, kit.h if kit.h <= 0.52 and not padded else 0.45
    s, leg = (0.03, "black_metal") if metal else (0.05, wood)
    if kit.style == "upholstered":
        b.fill = 3.0
        b.rounded(kit.pick("linen", "rose_velvet", "grey_fabric"), kit.x, kit.y, (seat - 0.13, seat), 0.04)
        b.fill, thick = 1.0, 0.13
        kit_x, kit_y = (kit.x[0] + 0.03, kit.x[1] - 0.03), (kit.y[0] + 0.03, kit.y[1] - 0.03)
        splayed(kit, wood, seat - 0.1, kit_x, kit_y, 0.014, 0.02)
    else:
        thick = 0.04
        n = max(3, round(kit.d / 0.09)) if kit.style == "slatted" else 1
        for i in range(n):
            gap = 0.012 if i < n - 1 else 0.0
            x = (kit.x[0] + i * kit.d / n, kit.x[0] + (i + 1) * kit.d / n - gap)
            b.box(wood, x, kit.y, (seat - thick, seat))
        for py in (kit.y[0] + 0.06, kit.y[1] - 0.06 - s):
            for px in (kit.x[0] + 0.01, kit.x[1] - 0.01 - s):
                b.box(leg, (px, px + s), (py, py + s), (0, seat - thick))
            b.box(
                leg,
                (kit.x[0] + 0.01 + s, kit.x[1] - 0.01 - s),
                (py + 0.002, py + s - 0.002),
                (seat - thick - s, seat - thick - 0.001),
            )
    if kit.h > 0.52:
        for py in (kit.y[0] + 0.06, kit.y[1] - 0.06 - s):
            b.box(leg, (kit.x[0] + 0.01, kit.x[0] + 0.035), (py, py + s), (seat, kit.h))
        b.box(wood, (kit.x[0], kit.x[0] + 0.01), (kit.y[0] + 0.02, kit.y[1] - 0.02), (kit.h - 0.12, kit.h - 0.001))
    elif padded:
        b.rounded(
            kit.pick("linen", "mustard_fabric"),
            (kit.x[0] + 0.01, kit.x[1] - 0.01),
            (kit.y[0] + 0.01, kit.y[1] - 0.01),
            (seat, kit.h),
            (kit.h - seat) / 2,
        )


@design("office_chair", "task", "executive", "mesh", "shell")
def office_chair(kit: Kit) -> None:
    """A five-star base on castors, a gas lift, seat, back and arms."""
    b, seat = kit.base, min(0.48, 0.5 * kit.h)
    metal = "chrome" if kit.style in ("executive", "shell") else "plastic_black"
    _star_base(kit, metal)
    b.rod("black_metal", (0, 0, 0.1), (0, 0, seat - 0.08), 0.022, n=16)
    cover = {
        "task": kit.pick("charcoal_fabric", "blue_fabric", "grey_fabric"),
        "executive": kit.pick("black_leather", "tan_leather"),
        "mesh": "charcoal_fabric",
        "shell": kit.pick("cream_boucle", "rose_velvet", "sage_fabric"),
    }[kit.style]
    half_x, half_y = 0.4 * kit.d, 0.38 * kit.w
    b.fill = 4.0
    b.pillow(cover, (-half_x, half_x), (-half_y, half_y), (seat - 0.09, seat), 4.2)
    back = (-kit.d / 2 + 0.03, -kit.d / 2 + 0.11)
    if kit.style == "mesh":
        b.rounded("mesh_black", back, (-half_y, half_y), (seat + 0.06, kit.h), 0.03)
    else:
        low = seat + (0.0 if kit.style in ("executive", "shell") else 0.1)
        b.pillow(
            cover, back if kit.style != "executive" else (back[0], back[1] + 0.04), (-half_y, half_y), (low, kit.h), 4.0
        )
    b.fill = 1.0
    b.tube(
        metal, [(0.02, 0, seat - 0.085), (-half_x - 0.005, 0, seat - 0.085), (-half_x - 0.005, 0, seat + 0.16)], 0.016
    )
    if kit.style != "shell":
        for s in (-1, 1):
            y = s * (half_y + 0.03)
            b.box(metal, (-0.05, -0.01), tuple(sorted((s * half_y * 0.8, y))), (seat - 0.075, seat - 0.045))
            b.box(metal, (-0.045, -0.015), (y - 0.012, y + 0.012), (seat - 0.07, seat + 0.19))
            b.rounded("plastic_black", (-0.14, 0.12), (y - 0.025, y + 0.025), (seat + 0.19, seat + 0.215), 0.01)


def _star_base(kit: Kit, metal: str) -> None:
    """Five feet: two touch the sides, one the front, two the back of the box."""
    b, wheel = kit.base, 0.028
    b.turned(metal, [(0.035, 0.07), (0.03, 0.11)], n=12)
    ends = [(0.5 * kit.d - wheel, 0.0)]
    for s in (-1, 1):
        ends += [(0.12 * kit.d, s * (0.5 * kit.w - 0.012)), (-0.5 * kit.d + wheel, s * 0.3 * kit.w)]
    for x, y in ends:
        b.rod(metal, (0, 0, 0.09), (x, y, 0.075), 0.02, 0.013, 8)
        b.rod("plastic_black", (x, y - 0.012, wheel), (x, y + 0.012, wheel), wheel, n=16)
        b.rod("black_metal", (x, y, wheel), (x, y, 0.075), 0.006, n=8)


@design("balcony_chair", "folding", "rattan", "metal", "adirondack")
def balcony_chair(kit: Kit) -> None:
    """A light chair for outdoors."""
    b, seat = kit.base, 0.43
    if kit.style == "rattan":
        b.fill = 0.5
        for y in ((kit.y[0], kit.y[0] + 0.07), (kit.y[1] - 0.07, kit.y[1])):
            b.rounded("rattan", (kit.x[0] + 0.01, kit.x[1]), y, (0, min(0.64, kit.h - 0.05)), 0.025)
        b.rounded("rattan", (kit.x[0], kit.x[0] + 0.07), (kit.y[0] + 0.005, kit.y[1] - 0.005), (0.04, kit.h), 0.03)
        b.rounded(
            "rattan", (kit.x[0] + 0.05, kit.x[1] - 0.01), (kit.y[0] + 0.06, kit.y[1] - 0.06), (0.18, seat - 0.08), 0.02
        )
        b.fill = 1.5
        b.pillow(
            "linen",
            (kit.x[0] + 0.07, kit.x[1] - 0.01),
            (kit.y[0] + 0.07, kit.y[1] - 0.07),
            (seat - 0.085, seat + 0.01),
            6,
        )
        b.fill = 1.0
        return
    wood = {"folding": "teak", "metal": kit.pick("sage", "black_metal", "yellow"), "adirondack": "decking"}[kit.style]
    s = 0.022 if kit.style == "metal" else 0.032
    b.fill = 0.3 if kit.style == "metal" else 1.0
    square_legs(kit, wood, seat - 0.02, s, kit.h)
    n = 6 if kit.style != "adirondack" else 4
    for i in range(n):
        x = (
            kit.x[0] + s + i * (kit.d - s) / n,
            kit.x[0] + s + (i + 1) * (kit.d - s) / n - (0.012 if i < n - 1 else 0.0),
        )
        b.box(wood, x, (kit.y[0] + 0.002, kit.y[1] - 0.002), (seat - 0.018, seat))
    inner = (kit.y[0] + s, kit.y[1] - s)
    if kit.style == "folding":
        for z in np.arange(seat + 0.12, kit.h - 0.06, 0.085):
            b.box(wood, (kit.x[0] + 0.004, kit.x[0] + 0.02), inner, (float(z), float(z) + 0.06))
    else:
        m = 5
        for i in range(m):
            y = (
                inner[0] + i * (inner[1] - inner[0]) / m + 0.006,
                inner[0] + (i + 1) * (inner[1] - inner[0]) / m - 0.006,
            )
            b.box(wood, (kit.x[0] + 0.004, kit.x[0] + 0.02), y, (seat, kit.h - 0.04))
        b.box(wood, (kit.x[0], kit.x[0] + 0.024), inner, (kit.h - 0.04, kit.h - 0.001))
    if kit.style == "adirondack":
        for y in ((kit.y[0], kit.y[0] + 0.07), (kit.y[1] - 0.07, kit.y[1])):
            b.box(wood, (kit.x[0] + s, kit.x[1]), y, (0.6, 0.622))
            b.box(wood, (kit.x[1] - 0.06, kit.x[1] - 0.03), (y[0] + 0.02, y[1] - 0.02), (seat, 0.6))
    b.fill = 1.0
