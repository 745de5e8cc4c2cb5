"""Moulded sanitary ware: baths, toilets, basins."""

import numpy as np

from apartgen.stages.retrieve.furniture import cases, fronts, mesh
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.cases import Cell
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.kitchen import tap
from apartgen.stages.retrieve.furniture.looks import look
from apartgen.stages.retrieve.furniture.mesh import Array


def ring(centre: tuple[float, float], half: tuple[float, float], z: float, exponent: float, n: int = 32) -> Array:
    """A superelliptic ring (n, 3) at height z; exponent 2 is oval, 8 nearly a rectangle."""
    flat = mesh.oval(n, exponent) * np.array(half) + np.array(centre)
    return np.column_stack([flat, np.full(n, z)])


def vessel(
    b: Body, material: str, centre: tuple[float, float], rim: tuple[float, float], z: tuple[float, float],
    foot: float, lip: float, deep: float, exponent: float, inside: float, n: int = 32,
) -> None:  # fmt: skip
    """A basin of half sizes `rim` at z[1] that narrows to `foot` of them at z[0]; `deep` below a rim `lip` wide."""

    def at(scale: float, height: float, power: float, inset: float = 0.0) -> Array:
        return ring(centre, (rim[0] * scale - inset, rim[1] * scale - inset), height, power, n)

    tall = z[1] - z[0]
    outer = [
        at(foot, z[0], exponent),
        at((1 + foot) / 2 + 0.15 * (1 - foot), z[0] + 0.45 * tall, exponent),
        at(1, z[1] - 0.012, exponent),
        at(1, z[1], exponent),
    ]
    floor = z[1] - deep
    inner = [
        at(1, z[1], inside, lip),
        at(0.985, z[1] - 0.15 * deep, inside, lip),
        at(0.93, z[1] - 0.6 * deep, inside, lip),
        at(0.74, floor, inside, lip),
    ]
    b.hollow(material, np.array(outer), np.array(inner))


@design("bath", "built_in", "freestanding", "clawfoot")
def bath(kit: Kit) -> None:
    """A tub with a real cavity and a filler at one end."""
    b, rim = kit.base, kit.h - 0.09
    metal = kit.pick("chrome", "brass", "black_metal")
    if kit.style == "built_in":
        _built_in(kit, rim)
        filler = -0.5 * kit.w + 0.045
    else:
        foot = 0.12 if kit.style == "clawfoot" else 0.0
        b.fill = 0.5
        vessel(b, "acrylic", (0, 0), (kit.d / 2, kit.w / 2), (foot, rim), 0.74, 0.035, rim - foot - 0.08, 2.6, 2.6)
        b.fill = 1.0
        filler = -0.5 * kit.w + 0.02
        if kit.style == "clawfoot":
            for sx in (-1, 1):
                for sy in (-1, 1):
                    at = (sx * 0.24 * kit.d, sy * 0.26 * kit.w)
                    b.turned(metal, [(0.03, 0), (0.018, 0.05), (0.035, 0.125)], (*at, 0), 12)
    _filler(kit, metal, filler, rim)


def _built_in(kit: Kit, rim: float) -> None:
    b, n = kit.base, 32
    c = mesh.circle(n)
    square = c / np.abs(c).max(1, keepdims=True) * [kit.d / 2, kit.w / 2]
    box = [
        np.column_stack([square * s, np.full(n, z)])
        for s, z in ((0.985, 0.0), (0.985, rim - 0.03), (1.0, rim - 0.03), (1.0, rim))
    ]
    half = (kit.d / 2 - 0.06, kit.w / 2 - 0.09)
    deep = rim - 0.1
    inner = [ring((0, 0), (half[0] * s, half[1] * t), rim - deep * u, e, n) for s, t, u, e in
             ((1, 1, 0, 5), (0.97, 0.985, 0.12, 5), (0.88, 0.93, 0.7, 4), (0.66, 0.84, 1, 4))]  # fmt: skip
    b.fill = 0.1
    b.add("acrylic", mesh.loft(np.array([*box, *inner]), sharp=(1, 2, 3)), touch=False)
    b.fill = 1.0
    b.vessel_hulls(np.array(box), np.array(inner))


def _filler(kit: Kit, metal: str, y: float, rim: float) -> None:
    b, top = kit.base, kit.h
    if kit.style == "built_in":
        b.tube(metal, [(0, y, rim), (0, y, top - 0.01), (0, y + 0.14, top - 0.01), (0, y + 0.14, top - 0.035)], 0.01)
        for x in (-0.09, 0.09):
            b.turned(metal, [(0.018, 0), (0.014, 0.03), (0.02, 0.045)], (x, y, rim), 12)
        return
    b.tube(
        metal, [(0, y, rim - 0.02), (0, y, top - 0.011), (0, y + 0.16, top - 0.011), (0, y + 0.16, top - 0.04)], 0.011
    )


@design("toilet", "close_coupled", "modern", "wall_hung", "classic")
def toilet(kit: Kit) -> None:
    """Bowl, cistern (boxed in when the asset is low) and a lid that lifts."""
    b = kit.base
    low = kit.h < 0.55
    rim = kit.h - 0.035 if low else min(0.41, kit.h - 0.2)
    tank = min(0.17, 0.27 * kit.d) if not low else 0.02
    back = kit.x[0] + tank + 0.004
    half = ((kit.x[1] - back) / 2, (kit.w / 2 if low else min(0.185, kit.w / 2)))
    _bowl(kit, (back + half[0], 0.0), half, rim, hung=kit.style == "wall_hung")
    if low:
        b.box(
            "porcelain",
            (kit.x[0], back + 0.08),
            (kit.y[0] * 0.75, kit.y[1] * 0.75),
            (rim - 0.16 if kit.style == "wall_hung" else 0, rim),
        )
    else:
        _cistern(kit, tank, rim)
    cover = Body()
    z = (rim + 0.022, rim + 0.035)
    cover.prism("plastic_white", ring((back + half[0] + 0.0, 0), half, 0, 2.5)[:, :2], *z, smooth=True)
    kit.hinge("lid", cover, (back, 0, z[1]), (0, -1, 0), handle=(kit.x[1], 0, z[0]))


def _bowl(kit: Kit, centre: tuple[float, float], half: tuple[float, float], rim: float, hung: bool) -> None:
    b = kit.base
    back = centre[0] - half[0]

    def at(scale: float, z: float, shift: float = 0.0, wide: float = 1.0) -> Array:
        return ring((back + half[0] * scale + shift, 0), (half[0] * scale, half[1] * scale * wide), z, 2.5, 28)

    if hung:
        outer = [at(0.5, 0.0 if kit.h < 0.45 else rim - 0.33), at(0.86, rim - 0.22), at(0.99, rim - 0.06), at(1, rim)]
        if kit.h >= 0.55:
            b.box("white", (kit.x[0], back + 0.02), (-0.2 * kit.w, 0.2 * kit.w), (0, rim - 0.05))
    elif kit.style == "modern":
        outer = [at(0.88, 0), at(0.9, 0.5 * rim), at(0.99, rim - 0.06), at(1, rim)]
    else:
        outer = [at(0.72, 0, 0, 0.75), at(0.66, 0.35 * rim, 0, 0.72), at(0.97, rim - 0.1), at(1, rim)]
    lip = 0.035

    def inside(scale: float, z: float) -> Array:
        return ring((centre[0], 0), ((half[0] - lip) * scale, (half[1] - lip) * scale), z, 2.3, 28)

    inner = [inside(1, rim), inside(0.96, rim - 0.04), inside(0.7, rim - 0.12), inside(0.35, rim - 0.18)]
    b.fill = 0.25
    b.hollow("porcelain", np.array(outer), np.array(inner))
    b.fill = 1.0
    # The seat is a fixed ring on the rim: it could not rise before the lid.
    seat = [ring(centre, half, rim + z, 2.5, 28) for z in (0.002, 0.02)]
    hole = [ring(centre, (half[0] - 0.06, half[1] - 0.055), rim + z, 2.2, 28) for z in (0.02, 0.002)]
    b.add("plastic_white", mesh.loft(np.array([*seat, *hole]), caps=False, sharp=(1, 2, 3)), touch=False)
    for i in range(28):
        j = [i, (i + 1) % 28]
        b.hull(np.concatenate([r[j] for r in (*seat, *hole)]))


def _cistern(kit: Kit, tank: float, rim: float) -> None:
    b = kit.base
    low = rim - 0.02 if kit.style != "classic" else max(rim - 0.02, kit.h - 0.36)
    b.fill = 0.2
    b.rounded(
        "porcelain",
        (kit.x[0], kit.x[0] + tank - 0.006),
        (kit.y[0] + 0.006, kit.y[1] - 0.006),
        (low, kit.h - 0.03),
        0.02,
    )
    b.rounded("porcelain", (kit.x[0], kit.x[0] + tank), kit.y, (kit.h - 0.035, kit.h - 0.004), 0.012)
    b.box(
        "porcelain",
        (kit.x[0], kit.x[0] + tank + 0.004),
        (-0.12, 0.12),
        (0.0 if kit.style != "wall_hung" else rim - 0.3, low + 0.01),
    )
    b.fill = 1.0
    b.rod("chrome", (kit.x[0] + tank / 2, 0, kit.h - 0.005), (kit.x[0] + tank / 2, 0, kit.h), 0.022, n=16)


@design("vanity", "modern", "scandi", "shaker", "midcentury", "pedestal")
def vanity(kit: Kit) -> None:
    """A basin with a tap on a cupboard, or on a slender one that stands for a pedestal."""
    b, rim = kit.base, kit.h - 0.1
    metal = kit.pick("chrome", "brass", "black_metal")
    if kit.style == "pedestal":
        _pedestal(kit, rim, metal)
        return
    own = look(kit.style, kit.taste())
    slab = 0.03
    bowl = kit.style in ("scandi", "midcentury") and kit.d > 0.4
    top = rim - 0.11 if bowl else rim
    foot = cases.base_height(own, kit.h)
    out = fronts.projection(own)
    cases.stand(kit, own, (kit.x[0], kit.x[1] - out), kit.y, foot)
    z = (foot, top - (slab if bowl else 0.05))
    columns = [[Cell(c.kind, c.share, 0) for c in column] for column in cases.door_columns(kit, kit.w)]
    cases.cabinet(kit, own, kit.x, kit.y, z, columns, cases.door_widths(kit, kit.w), top=bowl)
    places = (0.0,) if kit.w < 1.15 else (-0.25 * kit.w, 0.25 * kit.w)
    front = kit.x[1] - out + min(out, 0.01)
    if bowl:
        b.box(kit.pick("oak", "walnut", "marble", "terrazzo"), (kit.x[0], front), kit.y, (z[1], top))
    else:
        _counter(kit, front, z[1], rim, places)
    for y in places:
        if bowl:
            half = (min(0.17, kit.d / 2 - 0.06), min(0.2, kit.w / 2 - 0.05))
            vessel(b, "porcelain", (front - half[0] - 0.02, y), half, (top, rim), 0.6, 0.012, 0.09, 2.0, 2.0, 28)
            tap(b, metal, kit.x[0] + 0.035, y, top, kit.h, 0.14)
        else:
            tap(b, metal, kit.x[0] + 0.045, y, rim, kit.h, 0.12)


def _counter(kit: Kit, front: float, low: float, rim: float, places: tuple[float, ...]) -> None:
    """A moulded top whose bowls are let into it."""
    b, x = kit.base, (kit.x[0], front)
    edges = [kit.y[0], *[(a + c) / 2 for a, c in zip(places[:-1], places[1:], strict=True)], kit.y[1]]
    b.fill = 0.5
    for y, lo, hi in zip(places, edges[:-1], edges[1:], strict=True):
        n = 32
        c = mesh.circle(n)
        flat = c / np.abs(c).max(1, keepdims=True)
        middle = np.array([(x[0] + x[1]) / 2, (lo + hi) / 2])
        square = middle + flat * [(x[1] - x[0]) / 2, (hi - lo) / 2]
        half = ((x[1] - x[0]) / 2 - 0.06, min(0.28, (hi - lo) / 2 - 0.04))
        centre = (middle[0] + 0.03, y)
        outer = np.array([np.column_stack([square, np.full(n, z)]) for z in (low, rim)])
        inner = np.array(
            [
                ring(centre, (half[0] * s, half[1] * s), rim - u, 4, n)
                for s, u in ((1, 0), (0.96, 0.012), (0.86, 0.04), (0.8, 0.044))
            ]
        )
        inner[:, :, 2] = np.maximum(inner[:, :, 2], low + 0.004)
        b.add("porcelain", mesh.loft(np.concatenate([outer, inner]), sharp=(1,)), touch=False)
        b.vessel_hulls(outer, inner)
    b.fill = 1.0


def _pedestal(kit: Kit, rim: float, metal: str) -> None:
    b = kit.base
    b.fill = 0.6
    n = 32
    c = mesh.circle(n)
    square = c / np.abs(c).max(1, keepdims=True)
    half = np.array([kit.d / 2, kit.w / 2])
    outer = np.array(
        [
            np.column_stack([square * half * s + [-(1 - s) * kit.d / 4, 0], np.full(n, z)])
            for s, z in ((0.5, rim - 0.17), (0.97, rim - 0.05), (1, rim - 0.03), (1, rim))
        ]
    )
    inside = (half[0] - 0.065, half[1] - 0.04)
    inner = np.array(
        [
            ring((0.035, 0), (inside[0] * s, inside[1] * s), rim - u, 2.6, n)
            for s, u in ((1, 0), (0.94, 0.03), (0.75, 0.1), (0.4, 0.13))
        ]
    )
    b.add("porcelain", mesh.loft(np.concatenate([outer, inner]), sharp=(2, 3, 4)), touch=False)
    b.vessel_hulls(outer, inner)
    b.fill = 1.0
    own = look("modern", kit.taste()).with_(handle="knob", metal=metal)
    half_y = 0.25 * kit.w if kit.w < 0.8 else min(0.25 * kit.w, 0.2)
    x, y = (kit.x[0], kit.x[0] + 0.64 * kit.d), (-half_y, half_y)
    cases.stand(kit, own, (x[0], x[1] - fronts.projection(own)), y, 0.06)
    side = kit.pick("left", "right")
    cases.cabinet(kit, own, x, y, (0.06, rim - 0.172), [[Cell(side)]])
    tap(b, metal, kit.x[0] + 0.05, 0, rim, kit.h, 0.11)
