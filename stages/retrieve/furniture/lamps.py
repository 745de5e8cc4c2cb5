"""Floor, table, ceiling and wall lamps."""

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.mesh import Array

_HOLLOW = 0.06
"""Share of a lamp's outer volume that is material."""


def shade(
    kit: Kit,
    material: str,
    z: Span,
    low: float = 1.0,
    high: float = 0.7,
    at: tuple[float, float] = (0.0, 0.0),
    half: tuple[float, float] | None = None,
) -> None:
    """A thin conical shade, its wide end filling the footprint (or of half sizes `half`), open at both ends."""
    n, t = 24, 0.003
    half_ = np.array(half or (kit.d / 2, kit.w / 2))
    c = np.stack([np.cos(a := 2 * np.pi * np.arange(n) / n), np.sin(a)], 1)

    def ring(scale: float, height: float, inset: float) -> Array:
        return np.column_stack([c * (half_ * scale - inset) + at, np.full(n, height)])

    outer = np.array([ring(low, z[0], 0), ring(high, z[1], 0)])
    inner = np.array([ring(high, z[1], t), ring(low, z[0], t)])
    skin = np.concatenate([outer, inner])
    kit.base.add(material, mesh.loft(skin, caps=False, sharp=(1, 2, 3)), touch=False)
    for i in range(n):
        j = [i, (i + 1) % n]
        kit.base.hull(np.concatenate([outer[0][j], outer[1][j], inner[0][j], inner[1][j]]))
    middle, r = (z[0] + z[1]) / 2, min(0.03, 0.5 * float(half_.min()))
    kit.base.pillow("bulb", (at[0] - r, at[0] + r), (at[1] - r, at[1] + r), (middle - 1.6 * r, middle + 1.3 * r), 2, 4)


def _spider(kit: Kit, metal: str, z: float, r: float) -> None:
    """Thin arms that carry a shade at its upper rim."""
    for i in range(3):
        a = 2 * np.pi * i / 3
        kit.base.rod(metal, (0, 0, z), (r * np.cos(a), r * np.sin(a), z), 0.002, n=6)


@design("floor_lamp", "drum", "tripod", "reading", "globe", "paper")
def floor_lamp(kit: Kit) -> None:
    """A standing lamp."""
    b, h = kit.base, kit.h
    b.fill, b.mass = 4 * _HOLLOW, 0.6
    metal = kit.pick("brass", "black_metal", "chrome")
    linen = kit.pick("linen", "paper_shade", "charcoal_fabric")
    r = min(kit.d, kit.w) / 2
    if kit.style == "paper":
        _paper(kit)
        return
    if kit.style == "reading":
        _reading(kit, metal)
        return
    if kit.style == "globe":
        b.turned(metal, [(0.55 * r, 0), (0.55 * r, 0.015), (0.02, 0.025)], n=24)
        b.rod(metal, (0, 0, 0.02), (0, 0, h - 2 * r + 0.01), 0.011)
        b.pillow("bulb", kit.x, kit.y, (h - 2 * r, h), 2.0, 8)
        return
    tall = min(0.28, 0.2 * h)
    shade(kit, linen, (h - tall, h), 1.0, 0.72 if kit.style == "drum" else 0.9)
    _spider(kit, metal, h - 0.012, 0.7 * r)
    if kit.style == "drum":
        b.turned(metal, [(0.6 * r, 0), (0.6 * r, 0.018), (0.03, 0.03)], n=24)
        b.rod(metal, (0, 0, 0.025), (0, 0, h - 0.01), 0.01)
    else:
        wood, hub = kit.pick("oak", "walnut", "ash_black"), h - tall - 0.06
        b.turned(wood, [(0.03, 0), (0.03, 0.05)], (0, 0, hub), 12)
        b.rod(metal, (0, 0, hub + 0.05), (0, 0, h - 0.01), 0.008)
        for i in range(3):
            a = 2 * np.pi * i / 3
            foot = (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), 0.0)
            b.leg(wood, foot, (0.02 * np.cos(a), 0.02 * np.sin(a), hub + 0.02), 0.011, 0.015, 10)


def _reading(kit: Kit, metal: str) -> None:
    """A stem that bends over to a conical shade; the foot is an oval slab."""
    b, h = kit.base, kit.h
    t = 2 * np.pi * np.arange(32) / 32
    b.prism(
        kit.pick("marble", metal), np.stack([kit.d / 2 * np.cos(t), kit.w / 2 * np.sin(t)], 1), 0, 0.025, smooth=True
    )
    r = min(0.11, 0.25 * kit.d)
    foot, end = kit.x[0] + 0.2 * kit.d, kit.x[1] - r
    rise = min(0.3 * h, 0.6 * (end - foot))
    low, turn = h - 0.0111 - rise, np.linspace(0, np.pi, 13)
    arc = [((foot + end) / 2 - (end - foot) / 2 * np.cos(a), 0.0, low + rise * np.sin(a)) for a in turn]
    b.tube(metal, [(foot, 0.0, 0.025), *arc], 0.011)
    top = arc[-1][2]
    b.rod(metal, (end, 0, top - 0.08), (end, 0, top + 0.01), 0.013, n=10)
    shade(kit, metal, (top - 0.2, top - 0.05), 1.0, 0.3, (end, 0.0), (r, r))
    b.rod(metal, (end, 0, top - 0.06), (end, 0, top - 0.048), 0.34 * r, n=12)


def _paper(kit: Kit) -> None:
    b, wood = kit.base, kit.pick("oak", "ash_black")
    s = 0.018
    for x in (kit.x[0], kit.x[1] - s):
        for y in (kit.y[0], kit.y[1] - s):
            b.box(wood, (x, x + s), (y, y + s), (0, kit.h))
    inner = (kit.x[0] + s, kit.x[1] - s), (kit.y[0] + s, kit.y[1] - s)
    b.fill = 0.05
    b.box(
        "paper_shade", (kit.x[0] + 0.004, kit.x[1] - 0.004), (kit.y[0] + 0.004, kit.y[1] - 0.004), (0.12, kit.h - 0.02)
    )
    b.fill = 1.0
    for z in np.linspace(0.1, kit.h - s - 0.001, 5):
        for x in (kit.x[0] + 0.001, kit.x[1] - s - 0.001):
            b.box(wood, (x, x + s), inner[1], (float(z), float(z) + s))
        for y in (kit.y[0] + 0.001, kit.y[1] - s - 0.001):
            b.box(wood, inner[0], (y, y + s), (float(z), float(z) + s))


@design("table_lamp", "ceramic", "column", "mushroom", "cube")
def table_lamp(kit: Kit) -> None:
    """A small lamp to stand on furniture."""
    b, h, r = kit.base, kit.h, min(kit.d, kit.w) / 2
    b.fill, b.mass = 4 * _HOLLOW, 0.6
    linen = kit.pick("linen", "paper_shade", "cream")
    if kit.style == "mushroom":
        colour = kit.pick("cream", "rust_fabric", "sage", "mustard_fabric", "white")
        b.turned(colour, [(0.55 * r, 0), (0.5 * r, 0.02), (0.22 * r, 0.3 * h), (0.3 * r, 0.62 * h)], n=20)
        b.pillow(colour, kit.x, kit.y, (0.5 * h, h), 2.4, 8)
        return
    if kit.style == "cube":
        _cube(kit, kit.pick("oak", "walnut", "ash_black"))
        return
    neck = 0.55 * h
    if kit.style == "ceramic":
        glaze = kit.pick("sage", "dusk_blue", "porcelain", "terracotta", "navy")
        b.turned(
            glaze,
            [
                (0.4 * r, 0),
                (0.62 * r, 0.1 * h),
                (0.66 * r, 0.22 * h),
                (0.5 * r, 0.36 * h),
                (0.18 * r, 0.46 * h),
                (0.2 * r, 0.5 * h),
            ],
            n=20,
        )
    else:
        wood = kit.pick("walnut", "oak", "marble", "brass")
        b.turned(wood, [(0.5 * r, 0), (0.5 * r, 0.02), (0.14 * r, 0.03), (0.14 * r, 0.5 * h)], n=20)
    b.rod("brass", (0, 0, 0.5 * h), (0, 0, h - 0.008), 0.005, n=8)
    _spider(kit, "brass", h - 0.01, 0.62 * r)
    shade(kit, linen, (neck, h), 1.0, 0.66 if kit.style == "ceramic" else 0.9)


def _cube(kit: Kit, wood: str) -> None:
    """A paper cube in a frame of four posts between a base and a cap."""
    b, s = kit.base, 0.012
    for z in ((0.0, 0.02), (kit.h - 0.015, kit.h)):
        b.box(wood, kit.x, kit.y, z)
    for x in (kit.x[0] + 0.001, kit.x[1] - s - 0.001):
        for y in (kit.y[0] + 0.001, kit.y[1] - s - 0.001):
            b.box(wood, (x, x + s), (y, y + s), (0.02, kit.h - 0.015))
    middle = 0.45 * kit.h
    b.box(wood, (kit.x[0] + s, kit.x[1] - s), (kit.y[0] + 0.003, kit.y[0] + 0.003 + s), (middle, middle + s))
    b.box(wood, (kit.x[0] + s, kit.x[1] - s), (kit.y[1] - 0.003 - s, kit.y[1] - 0.003), (middle, middle + s))
    for x in (kit.x[0] + 0.003, kit.x[1] - 0.003 - s):
        b.box(wood, (x, x + s), (kit.y[0] + s, kit.y[1] - s), (middle, middle + s))
    inset = s + 0.006
    b.fill = 0.05
    b.box("paper_shade", (kit.x[0] + inset, kit.x[1] - inset), (kit.y[0] + inset, kit.y[1] - inset),
          (0.02, kit.h - 0.015))  # fmt: skip
    b.fill = 1.0


@design("ceiling_lamp", "pendant", "flush", "globe", "cluster", "drum")
def ceiling_lamp(kit: Kit) -> None:
    """A lamp that hangs from the ceiling, or a flush one when it is low."""
    b, h, r = kit.base, kit.h, min(kit.d, kit.w) / 2
    b.fill, b.mass = _HOLLOW, 0.6
    metal = kit.pick("black_metal", "brass", "white_metal")
    if kit.style == "flush" or h < 0.2:
        b.pillow("bulb", kit.x, kit.y, (0, min(h, 0.9 * h + 0.02)), 3.0, 8)
        b.rod(metal, (0, 0, 0.55 * h), (0, 0, h), 0.75 * r, n=24)
        return
    b.rod(metal, (0, 0, h - 0.025), (0, 0, h), min(0.06, 0.6 * r), n=20)
    body = min(0.62 * h, 1.4 * r)
    if kit.style == "globe":
        size = min(0.8 * h, 2 * r)
        b.pillow("bulb", kit.x, kit.y, (0, size), 2.0, 8)
        b.rod(metal, (0, 0, 0.97 * size), (0, 0, h - 0.024), 0.004, n=8)
    elif kit.style == "cluster":
        _cluster(kit, metal, h)
    else:
        colour = (
            kit.pick("black_metal", "sage", "white", "copper", "rattan")
            if kit.style == "pendant"
            else kit.pick("linen", "paper_shade")
        )
        tall = body if kit.style == "pendant" else min(body, 0.3)
        shade(kit, colour, (0, tall), 1.0, 0.16 if kit.style == "pendant" else 0.96)
        _spider(kit, metal, tall - 0.006, (0.15 if kit.style == "pendant" else 0.94) * r)
        b.rod(metal, (0, 0, tall - 0.01), (0, 0, h - 0.024), 0.004, n=8)


def _cluster(kit: Kit, metal: str, h: float) -> None:
    b = kit.base
    b.box(metal, (-0.012, 0.012), (-0.012, 0.012), (h * 0.45, h - 0.02))
    ball = min(0.06, 0.14 * min(kit.d, kit.w))
    for i in range(8):
        a = np.pi / 4 * i
        out = np.array([np.cos(a) * (kit.d / 2 - ball), np.sin(a) * (kit.w / 2 - ball)])
        z = ball if i % 2 == 0 else 0.45 * h
        b.rod(metal, (0, 0, 0.5 * h), (*out, z), 0.004, n=6)
        b.pillow("bulb", (out[0] - ball, out[0] + ball), (out[1] - ball, out[1] + ball), (z - ball, z + ball), 2.0, 4)


@design("wall_lamp", "cone", "globe", "up_down")
def wall_lamp(kit: Kit) -> None:
    """A plate on the wall and an arm that carries a shade, a globe, or a tube lit at both ends."""
    b, h, metal = kit.base, kit.h, kit.pick("brass", "black_metal", "white_metal")
    b.fill, b.mass = _HOLLOW, 0.6
    r = min((kit.d - 0.025) / 2, kit.w / 2)
    x, plate = kit.x[1] - r, min(0.035, 0.24 * kit.w)
    if kit.style == "up_down":
        outline = np.stack([r * np.cos(a := np.arange(24) * np.pi / 12), kit.w / 2 * np.sin(a)], 1)
        b.box(metal, (kit.x[0], kit.x[0] + 0.012), (-plate, plate), (0.3 * h, 0.7 * h))
        b.rod(metal, (kit.x[0] + 0.01, 0, 0.5 * h), (x, 0, 0.5 * h), 0.007, n=8)
        b.prism(metal, outline + [x, 0], 0.014, h - 0.014, smooth=True)
        for z in ((0.0, 0.015), (h - 0.015, h)):
            b.prism("bulb", 0.86 * outline + [x, 0], *z, smooth=True)
        return
    ball = min(0.72 * h, 2.2 * max(r, kit.w / 2))
    arm = h - ball - 0.03 * h if kit.style == "globe" else 0.24 * h
    b.box(metal, (kit.x[0], kit.x[0] + 0.012), (-plate, plate), (0, max(0.55 * h, arm + 0.02)))
    b.rod(metal, (kit.x[0] + 0.01, 0, arm), (x, 0, arm), 0.006, n=8)
    if kit.style == "globe":
        b.turned(metal, [(0.1 * r, 0), (0.3 * r, 0.02 * h), (0.42 * r, 0.08 * h)], (x, 0, arm - 0.005), 16)
        b.pillow("bulb", (x - r, x + r), kit.y, (h - ball, h), 2.0, 8)
        return
    b.rod(metal, (x, 0, arm - 0.02), (x, 0, 0.62 * h), 0.006, n=8)
    b.rod(metal, (x, -0.44 * kit.w, 0.5 * h), (x, 0.44 * kit.w, 0.5 * h), 0.0015, n=6)
    shade(kit, kit.pick("linen", "paper_shade"), (0.4 * h, h), 1.0, 0.66, (x, 0.0), (r, kit.w / 2))
