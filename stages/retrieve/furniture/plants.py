"""Pot plants and planters: leaves are thin closed blades."""

from functools import lru_cache

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.mesh import Array, Shape

_STEPS = 5


@lru_cache(mesh.LATELY)
def _blade(width: float, droop: float, widest: float) -> Shape:
    """A unit leaf along +x, `width` wide, curving down by `droop` at its tip; its section is a thin diamond."""
    t = np.linspace(0.0, 1.0, _STEPS + 1)
    half = width / 2 * np.maximum(np.sin(np.pi * t ** (np.log(0.5) / np.log(widest))), 0.06)
    rings = np.empty((_STEPS + 1, 4, 3))
    rings[:, :, 0] = t[:, None]
    rings[:, :, 1] = half[:, None] * [1, 0, -1, 0]
    rings[:, :, 2] = -droop * t[:, None] ** 2 + half[:, None] * [0.12, 0.05, 0.12, -0.05]
    return mesh.loft(rings)


def leaf(
    b: Body,
    material: str,
    at: Array,
    heading: float,
    pitch: float,
    length: float,
    width: float = 0.35,
    droop: float = 0.25,
    widest: float = 0.45,
) -> None:
    """A leaf from `at` toward `heading` (yaw) rising by `pitch` radians; collides as three hulls."""
    c, s, cp, sp = np.cos(heading), np.sin(heading), np.cos(pitch), np.sin(pitch)
    turn = np.array([[c * cp, -s, -c * sp], [s * cp, c, -s * sp], [sp, 0, cp]]) * length
    shape = _blade(width, droop, widest).moved(at, turn)
    b.add(material, shape, touch=False)
    for first, last in ((0, 2), (2, 4), (4, _STEPS)):
        b.hull(shape.vertices[4 * first : 4 * last + 4])


def pot(kit: Kit, kind: str, r: float, h: float, at: tuple[float, float] = (0.0, 0.0)) -> None:
    """A pot with soil in it."""
    b = kit.base
    material = {
        "tapered": kit.pick("terracotta", "white", "graphite"),
        "bowl": kit.pick("porcelain", "sage", "concrete"),
        "basket": "rattan",
        "cylinder": kit.pick("white", "concrete", "black", "terracotta"),
    }[kind]
    foot = {"tapered": 0.7, "bowl": 0.62, "basket": 0.85, "cylinder": 1.0}[kind]
    t, p = min(0.012, 0.1 * r), (*at, 0.0)
    b.shell(material, [(foot * r, 0), (r, h)], [(foot * r - t, 0.012), (r - t, h)], p, 24)
    b.rod("soil", (*at, 0.012), (*at, 0.86 * h), foot * r - t - 0.001, n=24)


def _fit(kit: Kit, grown: Body, low: float, stretch: bool = True) -> None:
    """Scales foliage about the soil at height `low` so that it fills the box, or only keeps within its sides."""
    lo, hi = grown.bounds()
    half = np.array([kit.d, kit.w]) / 2
    scale = 2 * half / (hi - lo)[:2] if stretch else np.minimum(1.0, half / np.maximum(-lo, hi)[:2])
    shift = -half - lo[:2] * scale if stretch else np.zeros(2)
    up = (kit.h - low) / (hi[2] - low)
    down = min(1.0, (low - 0.005) / max(low - lo[2], 1e-9))

    def fitted(points: Array) -> Array:
        z = points[:, 2] - low
        return np.column_stack([points[:, :2] * scale + shift, low + z * np.where(z > 0, up, down)])

    for material, shapes in grown.shapes.items():
        for shape in shapes:
            kit.base.add(material, Shape(fitted(shape.vertices), shape.faces, shape.uv), touch=False)
    for c in grown.colliders:
        if c.vertices is not None:
            kit.base.hull(fitted(c.center + c.vertices))


@design("plant", "fig", "monstera", "snake", "palm", "olive", "cactus")
def plant(kit: Kit) -> None:
    """A plant in a pot; its crown fills the box."""
    high = min(0.32, 0.3 * kit.h)
    r = min(0.36 * min(kit.d, kit.w), 0.2, 0.62 * high + 0.02)
    pot(kit, kit.pick("tapered", "cylinder", "basket", "bowl"), r, high)
    grown = Body()
    soil = 0.86 * high
    {"fig": _fig, "monstera": _monstera, "snake": _snake, "palm": _palm, "olive": _olive, "cactus": _cactus}[kit.style](
        kit, grown, soil, 0.5 * min(kit.d, kit.w)
    )
    _fit(kit, grown, soil)


def _stem(b: Body, material: str, a: Array, c: Array, r0: float, r1: float) -> None:
    b.add(material, mesh.rod(a, c, r0, r1, 6))


def _fig(kit: Kit, b: Body, z: float, r: float) -> None:
    top = kit.h - 0.5 * r
    _stem(b, "bark", np.array([0, 0, z]), np.array([0, 0, top]), 0.014, 0.007)
    n = 30
    for i in range(n):
        t = i / (n - 1)
        at = np.array([0, 0, z + (0.2 + 0.8 * t) * (top - z)])
        leaf(b, "leaf_dark", at, 2.4 * i, 0.15 + 0.9 * t, r * (1.15 - 0.35 * t), 0.62, 0.25, 0.6)


def _monstera(kit: Kit, b: Body, z: float, r: float) -> None:
    n = 18
    for i in range(n):
        a, t = 2.4 * i, i / (n - 1)
        lift = (kit.h - z) * (0.2 + 0.7 * t)
        out = r * (0.6 - 0.5 * t)
        end = np.array([out * np.cos(a), out * np.sin(a), z + lift])
        _stem(b, "leaf_light", np.array([0, 0, z]), end, 0.007, 0.005)
        leaf(b, "leaf", end, a, 0.5 * t - 0.1, r * 0.95, 0.9, 0.4, 0.38)


def _snake(kit: Kit, b: Body, z: float, r: float) -> None:
    for i in range(14):
        a = 2.4 * i
        at = np.array([0.05 * np.cos(a), 0.05 * np.sin(a), z])
        length = (kit.h - z) * float(kit.rng.uniform(0.62, 1.0))
        leaf(b, kit.pick("leaf_dark", "leaf_light"), at, a, 1.32 + 0.1 * (i % 3), length, 0.11, 0.06, 0.4)


def _palm(kit: Kit, b: Body, z: float, r: float) -> None:
    for k, (share, off) in enumerate(((0.62, 0.0), (0.42, 0.05), (0.25, -0.05))):
        foot = np.array([off, -off, z])
        top = foot + [off, -off, share * (kit.h - z)]
        _stem(b, "bark", foot, top, 0.022, 0.014)
        for i in range(12):
            a, t = 2.4 * i + k, i / 11
            leaf(b, "leaf", top + [0, 0, 0.02 * t], a, 0.35 + 0.9 * t, r * (1.5 - 0.25 * k), 0.15, 0.7 - 0.4 * t, 0.4)


def _olive(kit: Kit, b: Body, z: float, r: float) -> None:
    top = z + 0.6 * (kit.h - z)
    _stem(b, "bark", np.array([0, 0, z]), np.array([0, 0, top]), 0.018, 0.011)
    for i in range(13):
        a, t = 2.4 * i, i / 12
        low = np.array([0, 0, z + (0.55 + 0.45 * t) * (top - z)])
        end = low + [
            r * 0.75 * np.cos(a) * (1 - 0.5 * t),
            r * 0.75 * np.sin(a) * (1 - 0.5 * t),
            0.28 * (kit.h - z) * (0.4 + 0.6 * t),
        ]
        _stem(b, "bark", low, end, 0.005, 0.003)
        for k in range(6):
            share = 0.35 + 0.65 * k / 5
            leaf(b, "leaf_grey", low + (end - low) * share, a + (1.2 if k % 2 else -1.2), 0.45, 0.45 * r, 0.34, 0.1)


def _cactus(kit: Kit, b: Body, z: float, r: float) -> None:
    thick = min(0.5 * r, 0.07)
    b.add("leaf_dark", mesh.pillow((-thick, -thick, z - 0.05), (thick, thick, kit.h), 3.0, 6))
    for s, low in ((1, 0.35), (-1, 0.5)):
        base, out = z + low * (kit.h - z), r - thick * 0.6
        b.add(
            "leaf_dark",
            mesh.pillow(
                (min(0, s * out) - 0.0, -0.5 * thick, base), (max(0, s * out), 0.5 * thick, base + thick), 3, 4
            ),
        )
        b.add(
            "leaf_dark",
            mesh.pillow(
                (s * out - 0.6 * thick, -0.6 * thick, base),
                (s * out + 0.6 * thick, 0.6 * thick, base + 0.3 * (kit.h - z)),
                3,
                4,
            ),
        )
    # Arms to both sides, at different heights, keep its weight over the pot.
    for s, at in ((-1, 0.2), (1, 0.28)):
        low, tip = z + at * (kit.h - z), sorted((s * (r - thick), s * r))
        near, far = sorted((0.0, s * r))
        b.add("leaf_dark", mesh.pillow((-0.4 * thick, near, low), (0.4 * thick, far, low + thick), 3, 4))
        up = low + 0.25 * (kit.h - z)
        b.add("leaf_dark", mesh.pillow((-0.5 * thick, tip[0], low), (0.5 * thick, tip[1], up), 3, 4))


@design("planter", "herbs", "flowers", "grasses")
def planter(kit: Kit) -> None:
    """A long box of growing things."""
    b, t = kit.base, 0.02
    box = min(0.6 * kit.h, 0.42)
    material = kit.pick("decking", "graphite", "terracotta", "white")
    for x in ((kit.x[0], kit.x[0] + t), (kit.x[1] - t, kit.x[1])):
        b.box(material, x, kit.y, (0.02, box))
    inner = (kit.x[0] + t, kit.x[1] - t)
    for y in ((kit.y[0], kit.y[0] + t), (kit.y[1] - t, kit.y[1])):
        b.box(material, inner, y, (0.02, box))
    b.box(material, inner, (kit.y[0] + t, kit.y[1] - t), (0.02, 0.04))
    b.fill = 0.4
    b.box("soil", inner, (kit.y[0] + t, kit.y[1] - t), (0.04, box - 0.03))
    b.fill = 1.0
    for px in (kit.x[0] + 0.02, kit.x[1] - 0.06):
        for py in (kit.y[0] + 0.05, kit.y[1] - 0.09):
            b.box(material, (px, px + 0.04), (py, py + 0.04), (0, 0.02))
    grown, soil = Body(), box - 0.03
    _bed(kit, grown, soil)
    _fit(kit, grown, soil, stretch=False)


def _bed(kit: Kit, b: Body, z: float) -> None:
    tall, n = kit.h - z, max(6, round(kit.w / 0.07))
    for i in range(n):
        at = np.array(
            [float(kit.rng.uniform(-0.25, 0.25)) * kit.d, kit.y[0] + 0.04 + (i + 0.5) * (kit.w - 0.08) / n, z]
        )
        green = kit.pick("leaf", "leaf_light", "leaf_dark")
        for k in range(4):
            a = 2.4 * k + i
            wide, pitch = (0.1, 1.2) if kit.style == "grasses" else (0.4, 0.75 + 0.12 * k)
            leaf(b, green, at, a, pitch, tall * float(kit.rng.uniform(0.6, 1.0)), wide, 0.2)
        if kit.style == "flowers":
            top = at + [0, 0, 0.9 * tall]
            _stem(b, "leaf", at, top, 0.004, 0.003)
            size = min(0.035, 0.25 * tall)
            b.add(
                kit.pick("flower_red", "flower_pink", "flower_yellow"),
                mesh.pillow(top - size, top + size * np.array([1, 1, 0.6]), 2, 2),
            )
