"""Bookshelves, shelving, wall shelves, racks and rails."""

import numpy as np

from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.looks import look

_BOOKS = ("rust_fabric", "navy", "sage", "cream", "graphite", "mustard_fabric", "cherry", "dusk_blue", "white")


def books(kit: Kit, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> None:
    """A row of books, standing from the right; they only show, and collide as one block."""
    at, tall = y[0] + 0.004, z[1] - z[0]
    end = y[0] + (y[1] - y[0]) * kit.rng.uniform(0.3, 0.85)
    start, peak = at, 0.0
    deep = min(x[1] - x[0] - 0.03, 0.22)
    height = min(tall - 0.03, 0.21)
    while at < end - 0.05:
        wide = float(kit.rng.uniform(0.024, 0.05))
        own = height - float(kit.rng.uniform(0, 0.008))
        kit.base.fill = 0.8
        kit.base.box(
            kit.pick(*_BOOKS), (x[0] + 0.002, x[0] + deep), (at, at + wide - 0.001), (z[0] + 0.0005, z[0] + own), False
        )
        at, peak = at + wide, max(peak, own)
    kit.base.fill = 1.0
    if at > start:
        kit.base.block((x[0] + 0.002, x[0] + deep), (start, at - 0.001), (z[0], z[0] + peak))


def _levels(kit: Kit, low: float, high: float, pitch: float, t: float) -> list[float]:
    n = max(2, round((high - low) / pitch) + 1)
    return [float(z) for z in np.linspace(low, high - t, n)]


@design("bookshelf", "modern", "scandi", "shaker", "classic", "cube")
def bookshelf(kit: Kit) -> None:
    """A case of open shelves on sides that reach the floor."""
    own = look(
        kit.style if kit.style != "cube" else "modern", kit.taste(kit.style if kit.style != "cube" else "modern")
    )
    t, b = (0.032, kit.base) if kit.style == "cube" else (0.02, kit.base)
    cap = own.overhang
    y, x, top = (kit.y[0] + cap, kit.y[1] - cap), (kit.x[0], kit.x[1] - cap), kit.h - (0.025 if cap else 0)
    bays = max(1, round(kit.w / (0.38 if kit.style == "cube" else 0.85)))
    for i in range(bays + 1):
        at = y[0] + i * (y[1] - y[0] - t) / bays
        b.box(own.body, x, (at, at + t), (0, top))
    if cap:
        b.box(own.top, kit.x, kit.y, (top, kit.h))
        b.box(own.body, (x[1] - 0.03, x[1] - 0.012), (y[0] + t, y[1] - t), (0, 0.07))
    if kit.style != "cube" and kit.style != "scandi":
        b.box(own.body, (x[0], x[0] + 0.006), (y[0] + t, y[1] - t), (0.07, top - 0.001))
    levels = _levels(kit, 0.07 if kit.style != "cube" else 0.0, top, 0.36, t)
    for i in range(bays):
        lo = y[0] + i * (y[1] - y[0] - t) / bays + t
        hi = y[0] + (i + 1) * (y[1] - y[0] - t) / bays
        for k, z in enumerate(levels):
            b.box(own.top, (x[0] + 0.007, x[1] - 0.002), (lo, hi), (z, z + t))
            if k < len(levels) - 1 and kit.rng.random() < 0.55:
                books(kit, (x[0] + 0.01, x[1]), (lo, hi), (z + t, levels[k + 1]))


@design("bookshelf", "industrial", "ladder")
def frame_shelf(kit: Kit) -> None:
    """Shelves between metal or wooden ladders, open all round."""
    own = look(
        "industrial" if kit.style == "industrial" else "scandi",
        kit.taste("industrial" if kit.style == "industrial" else "scandi"),
    )
    post, s, t, b = own.leg, 0.025, 0.025, kit.base
    bays = max(1, round(kit.w / 1.1))
    for i in range(bays + 1):
        at = kit.y[0] + i * (kit.w - s) / bays
        for px in (kit.x[0], kit.x[1] - s):
            b.box(post, (px, px + s), (at, at + s), (0, kit.h))
        for z in (0.06, kit.h / 2, kit.h - s - 0.001):
            b.box(post, (kit.x[0] + s, kit.x[1] - s), (at + 0.002, at + s - 0.002), (z, z + s))
    levels = _levels(kit, 0.1, kit.h - 0.03, 0.38, t)
    for k, z in enumerate(levels):
        b.box(own.top, (kit.x[0] + 0.002, kit.x[1] - 0.002), (kit.y[0] + s, kit.y[1] - s), (z, z + t))
        if k < len(levels) - 1 and kit.rng.random() < 0.6:
            books(
                kit,
                (kit.x[0] + 0.03, kit.x[1] - 0.02),
                (kit.y[0] + s, kit.y[1] - s - 0.3 * kit.w),
                (z + t, levels[k + 1]),
            )


@design("shelving", "metal", "wood", "chrome", "heavy_duty")
def shelving(kit: Kit) -> None:
    """A storage rack: posts, edge beams and boards."""
    post, board = {"metal": ("graphite", "graphite"), "wood": ("pine", "pine"), "chrome": ("chrome", "chrome"),
                   "heavy_duty": ("rust_fabric", "chipboard")}[kit.style]  # fmt: skip
    post = "dusk_blue" if kit.style == "heavy_duty" else post
    s, b = 0.04 if kit.style in ("wood", "heavy_duty") else 0.028, kit.base
    b.fill = 0.25 if post in ("chrome", "graphite") else 1.0
    for px in (kit.x[0], kit.x[1] - s):
        for py in (kit.y[0], kit.y[1] - s):
            if kit.style == "chrome":
                b.rod(post, (px + s / 2, py + s / 2, 0), (px + s / 2, py + s / 2, kit.h), s / 2, n=12)
            else:
                b.box(post, (px, px + s), (py, py + s), (0, kit.h))
    for z in _levels(kit, 0.1, kit.h - 0.06, 0.45, 0.035):
        _rack_level(kit, post, board, s, z)
    b.fill = 1.0


def _rack_level(kit: Kit, post: str, board: str, s: float, z: float) -> None:
    b, x, y = kit.base, (kit.x[0] + s, kit.x[1] - s), (kit.y[0] + s, kit.y[1] - s)
    if kit.style == "wood":
        n = max(3, round(kit.d / 0.1))
        for i in range(n):
            at = kit.x[0] + s + i * (kit.d - 2 * s) / n
            b.box(
                board,
                (at, at + (kit.d - 2 * s) / n - 0.012),
                (kit.y[0] + 0.002, kit.y[1] - 0.002),
                (z + 0.016, z + 0.034),
            )
        for py in (kit.y[0], kit.y[1] - s):
            b.box(post, x, (py + 0.002, py + s - 0.002), (z - 0.03, z + 0.015))
        return
    b.box(board, x, y, (z + 0.012, z + 0.03))
    for py in (kit.y[0] + 0.002, kit.y[1] - s + 0.002):
        b.box(post, x, (py, py + s - 0.004), (z, z + 0.034))
    for px in (kit.x[0] + 0.002, kit.x[1] - s + 0.002):
        b.box(post, (px, px + s - 0.004), y, (z, z + 0.034))


@design("wall_shelf", "floating", "bracket", "box")
def wall_shelf(kit: Kit) -> None:
    """A board on the wall, on brackets, or a set of open boxes when it is tall."""
    b, wood = kit.base, kit.pick("oak", "walnut", "white", "light_oak")
    t = min(0.03, kit.h)
    levels = max(1, round(kit.h / 0.3)) if kit.h > 0.12 else 1
    if kit.style == "box" and kit.h > 0.12:
        for y in ((kit.y[0], kit.y[0] + t), (kit.y[1] - t, kit.y[1])):
            b.box(wood, kit.x, y, (0, kit.h))
        for i in range(levels + 1):
            z = i * (kit.h - t) / levels
            b.box(wood, (kit.x[0], kit.x[1] - 0.001), (kit.y[0] + t, kit.y[1] - t), (z, z + t))
        return
    if kit.h <= 0.06:
        b.box(wood, kit.x, kit.y, (0, kit.h))
        return
    if kit.style != "bracket":
        _ledges(kit, wood, t, levels)
        return
    metal = kit.pick("black_metal", "brass")
    for py in (kit.y[0] + 0.1 * kit.w, kit.y[1] - 0.1 * kit.w - 0.02):
        b.box(metal, (kit.x[0], kit.x[0] + 0.006), (py, py + 0.02), (0, kit.h - t))
        for i in range(levels):
            z = kit.h - t - i * (kit.h - t) / levels
            b.box(metal, (kit.x[0] + 0.006, kit.x[1] - 0.02), (py, py + 0.02), (z - 0.006, z))
    for i in range(levels):
        z = kit.h - t - i * (kit.h - t) / levels
        b.box(wood, (kit.x[0] + (0.006 if i else 0), kit.x[1]), kit.y, (z, z + t))


def _ledges(kit: Kit, wood: str, t: float, levels: int) -> None:
    """Boards with a low lip before a back board, whose fixings do not show."""
    b, thin = kit.base, min(0.015, 0.2 * kit.d)
    b.box(wood, (kit.x[0], kit.x[0] + thin), kit.y, (0, kit.h))
    for i in range(levels):
        z = i * kit.h / levels
        b.box(wood, (kit.x[0] + thin, kit.x[1]), (kit.y[0] + 0.001, kit.y[1] - 0.001), (z, z + t))
        lip = (z + t, min(z + t + 0.025, kit.h))
        b.box(wood, (kit.x[1] - 0.011, kit.x[1] - 0.001), (kit.y[0] + 0.001, kit.y[1] - 0.001), lip)


@design("coat_rack", "turned", "branch", "metal")
def coat_rack(kit: Kit) -> None:
    """A post on feet with arms at two heights."""
    b, r = kit.base, min(kit.d, kit.w) / 2
    material = {"turned": kit.pick("walnut", "cherry"), "branch": "birch", "metal": "black_metal"}[kit.style]
    thick = 0.013 if kit.style == "metal" else 0.02
    if kit.style == "turned":
        b.turned(
            material,
            [
                (thick, 0.08),
                (thick * 1.5, 0.3),
                (thick, 0.5),
                (thick, kit.h - 0.1),
                (thick * 1.6, kit.h - 0.05),
                (0.008, kit.h),
            ],
            n=12,
        )
    else:
        b.rod(material, (0, 0, 0.03), (0, 0, kit.h), thick)
    _star(kit, material, thick, r)
    for z, n, out in ((kit.h - 0.22, 4, 0.75), (kit.h - 0.45, 4, 0.6)):
        for i in range(n):
            angle = (i + (0.5 if z > kit.h - 0.3 else 0.0)) * np.pi / 2
            c, s = np.cos(angle), np.sin(angle)
            tip = (out * kit.d / 2 * c, out * kit.w / 2 * s, z + 0.1)
            b.rod(material, (0.3 * thick * c, 0.3 * thick * s, z), tip, 0.009, n=8)
            x, y, up = ((at - 0.016, at + 0.016) for at in tip)
            b.pillow(material, x, y, up, 2, 4)


def _star(kit: Kit, material: str, thick: float, r: float) -> None:
    b = kit.base
    if kit.style == "metal":
        b.fill = 0.3
        b.prism(
            material,
            np.stack([kit.d / 2 * np.cos(t := np.arange(32) * np.pi / 16), kit.w / 2 * np.sin(t)], 1),
            0,
            0.025,
            smooth=True,
        )
        return
    for ax, half in ((0, kit.d / 2), (1, kit.w / 2)):
        for s in (-1, 1):
            lo, hi = sorted((s * thick * 0.5, s * half))
            span = [(lo, hi), (-0.018, 0.018)] if ax == 0 else [(-0.018, 0.018), (lo, hi)]
            b.box(material, span[0], span[1], (0, 0.03) if ax else (0, 0.031))
    b.box(material, (-0.03, 0.03), (-0.03, 0.03), (0.03, 0.09))


@design("clothes_rail", "metal", "wood")
def clothes_rail(kit: Kit) -> None:
    """Two A-frames or posts with a hanging bar and a low shelf."""
    b = kit.base
    if kit.style == "metal":
        metal, r = kit.pick("black_metal", "chrome", "brass"), 0.0125
        b.fill = 0.2
        for s in (-1, 1):
            y = s * (kit.w / 2 - r)
            b.tube(metal, [(kit.x[0], y, r), (kit.x[1], y, r)], r)
            b.rod(metal, (0, y, r), (0, y, kit.h - r), r)
        b.rod(metal, (0, kit.y[0], kit.h - r), (0, kit.y[1], kit.h - r), r)
        for x in (-kit.d / 4, kit.d / 4):
            b.rod(metal, (x, kit.y[0] + 2 * r, 0.1), (x, kit.y[1] - 2 * r, 0.1), 0.008)
            for s in (-1, 1):
                b.rod(metal, (x, s * (kit.w / 2 - 2 * r), 0.02), (x, s * (kit.w / 2 - 2 * r), 0.108), 0.008)
        b.fill = 1.0
        return
    wood = kit.pick("birch", "oak", "walnut")
    for s in (-1, 1):
        lo, hi = sorted((s * kit.w / 2, s * (kit.w / 2 - 0.03)))
        for front in (-1, 1):
            foot, top = front * (kit.d / 2 - 0.02), front * 0.012
            outline = [(0.0, foot - 0.02), (0.0, foot + 0.02), (kit.h, top + 0.02), (kit.h, top - 0.02)]
            inner = (lo, hi) if front < 0 else (lo + 0.001, hi - 0.001)
            b.prism(wood, outline, *inner, axis=1)
    b.rod(wood, (0, kit.y[0] + 0.03, kit.h - 0.07), (0, kit.y[1] - 0.03, kit.h - 0.07), 0.014)
    b.box(wood, (-kit.d / 2 + 0.08, kit.d / 2 - 0.08), (kit.y[0] + 0.03, kit.y[1] - 0.03), (0.14, 0.158))
