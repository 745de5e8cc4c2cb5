"""Desks, dressing tables, workbenches."""

import numpy as np

from apartgen.stages.retrieve.furniture import cases
from apartgen.stages.retrieve.furniture.cases import Cell
from apartgen.stages.retrieve.furniture.chairs import splayed
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.looks import Look, look

KNEE = 0.36
"""Depth of drawers over one's knees, which open before a chair that is drawn up, m."""
SEAT, NARROW = 0.66, 0.26
"""Between drawers beneath a desk's top a chair has so much, or a single one is so wide, m."""


def _low(own: Look) -> Look:
    """The look with the base that a table's legs give it."""
    return own.with_(base="none")


def hung_drawers(kit: Kit, own: Look, y: Span, z: Span, n: int, x: Span) -> None:
    """A shallow case under a table top with `n` drawers side by side."""
    cases.cabinet(kit, _low(own), x, y, z, [[Cell("drawer")] for _ in range(n)])


@design("desk", "modern", "scandi", "industrial", "classic", "midcentury")
def desk(kit: Kit) -> None:
    """A top on legs with a pedestal of drawers, or shallow drawers beneath the top."""
    own = look(kit.style, kit.taste())
    b, t, h = kit.base, 0.028, kit.h
    b.box(own.top, kit.x, kit.y, (h - t, h))
    front = kit.x[1] - (0.0 if own.overhang == 0 else 0.01)
    if kit.style in ("modern", "classic") or (kit.style == "industrial" and kit.rng.random() < 0.5):
        _pedestal_desk(kit, own, front, h - t)
        return
    z = (h - t - 0.12, h - t)
    inset = 0.1 if kit.style != "industrial" else 0.06
    deep = (max(kit.x[0] + 0.04, front - KNEE), front)
    for span in _beside_knees(kit, inset):
        hung_drawers(kit, own, span, z, 1, deep)
    leg, y = own.leg, (kit.y[0] + 0.01, kit.y[1] - 0.01)
    if kit.style == "industrial":
        for py in (kit.y[0] + 0.02, kit.y[1] - 0.045):
            for px in (kit.x[0] + 0.02, kit.x[1] - 0.065):
                b.box(leg, (px, px + 0.025), (py, py + 0.025), (0, h - t))
            b.box(leg, (kit.x[0] + 0.045, kit.x[1] - 0.065), (py + 0.002, py + 0.023), (0.1, 0.125))
    else:
        splayed(kit, leg, h - t, (kit.x[0] + 0.02, kit.x[1] - 0.03), y, 0.014, 0.024)


def _beside_knees(kit: Kit, inset: float) -> list[Span]:
    """Where drawers are beside a chair that is drawn up: on both sides, or on one of a short desk."""
    low, high = kit.y[0] + inset, kit.y[1] - inset
    wide = (high - low - SEAT) / 2
    if wide >= NARROW:
        return [(low, low + wide), (high - wide, high)]
    wide = max(high - low - SEAT, NARROW)
    return [(low, low + wide)] if kit.rng.random() < 0.5 else [(high - wide, high)]


def _pedestal_desk(kit: Kit, own: Look, front: float, z: float) -> None:
    b = kit.base
    left = kit.rng.random() < 0.5
    own = own.with_(base="none")
    sides = [left] if kit.style != "classic" or kit.w < 1.4 else [True, False]
    wide = min(0.42, 0.34 * kit.w, (kit.w - SEAT - 0.02) / len(sides))
    for at_left in sides:
        y = (kit.y[1] - wide - 0.01, kit.y[1] - 0.01) if at_left else (kit.y[0] + 0.01, kit.y[0] + wide + 0.01)
        b.box(
            own.leg if own.leg != "black_metal" else "black",
            (kit.x[0] + 0.05, front - 0.06),
            (y[0] + 0.01, y[1] - 0.01),
            (0, 0.05),
        )
        cases.cabinet(
            kit,
            own,
            (kit.x[0] + 0.02, front),
            y,
            (0.05, z),
            [[Cell("drawer", 0.6), Cell("drawer", 0.8), Cell("drawer", 1.2)]],
        )
    if len(sides) == 1:
        py = (kit.y[0] + 0.02, kit.y[0] + 0.045) if left else (kit.y[1] - 0.045, kit.y[1] - 0.02)
        if kit.style == "industrial":
            for px in (kit.x[0] + 0.03, kit.x[1] - 0.065):
                b.box("black_metal", (px, px + 0.03), py, (0, z))
        else:
            b.box(own.body, (kit.x[0] + 0.03, kit.x[1] - 0.04), py, (0, z))
    b.box(
        own.body,
        (kit.x[0] + 0.04, kit.x[0] + 0.058),
        (kit.y[0] + (0.045 if left else wide + 0.01), kit.y[1] - (wide + 0.01 if left else 0.045))
        if len(sides) == 1
        else (kit.y[0] + wide + 0.01, kit.y[1] - wide - 0.01),
        (0.35, z),
    )


@design("dressing_table", "scandi", "classic", "modern", "glam")
def dressing_table(kit: Kit) -> None:
    """A small table with drawers; tall boxes carry a mirror."""
    own = look(
        "classic" if kit.style == "glam" else kit.style, kit.taste("classic" if kit.style == "glam" else kit.style)
    )
    if kit.style == "glam":
        own = own.with_(body="blush", front="blush", top="marble", leg="brass", profile="slab")
    b, t = kit.base, 0.022
    table = kit.h if kit.h < 0.95 else 0.76
    b.box(own.top, kit.x, kit.y, (table - t, table))
    n = 3 if kit.w > 1.1 else 2
    tall = 0.13
    hung_drawers(
        kit, own, (kit.y[0] + 0.02, kit.y[1] - 0.02), (table - t - tall, table - t), n, (kit.x[0] + 0.01, kit.x[1])
    )
    z = table - t - tall
    for x in (kit.x[0] + 0.05, kit.x[1] - 0.085):
        for y in (kit.y[0] + 0.05, kit.y[1] - 0.05):
            if kit.style == "classic":
                b.turned(
                    own.leg, [(0.012, 0), (0.024, 0.1), (0.014, 0.16), (0.028, z - 0.1), (0.028, z)], (x, y, 0), 12
                )
            elif kit.style == "modern":
                b.box(own.leg, (x - 0.02, x + 0.02), (y - 0.02, y + 0.02), (0, z))
            else:
                b.rod(own.leg, (x, y, 0), (x, y, z), 0.011, 0.018, 10)
    if kit.h > table:
        _mirror(kit, own, table)


def _mirror(kit: Kit, own: Look, table: float) -> None:
    b, x = kit.base, kit.x[0] + 0.01
    high, half = kit.h - table - 0.06, min(0.3, 0.35 * kit.w)
    middle = table + 0.06 + high / 2
    c = np.stack([np.cos(a := np.arange(32) * np.pi / 16), np.sin(a)], 1) * [half, high / 2]
    b.prism(own.leg, c + [0, middle], x, x + 0.02, 0, smooth=True)
    b.prism("mirror", c * 0.93 + [0, middle], x + 0.02, x + 0.023, 0, smooth=True)
    b.box(own.leg, (x, x + 0.02), (-0.03, 0.03), (table, table + 0.1))


@design("workbench", "wood", "steel")
def workbench(kit: Kit) -> None:
    """A heavy top, four posts, a low shelf, drawers under the top on one side."""
    b, h, s = kit.base, kit.h, 0.08
    top, post = ("pine", "pine") if kit.style == "wood" else ("birch", "dusk_blue")
    own = Look(post, post, top, "aluminium" if kit.style == "steel" else "black_metal", "slab", "bar", "none", post)
    b.box(top, kit.x, kit.y, (h - 0.05, h))
    front = kit.x[1] - 0.01
    b.fill = 1.0 if kit.style == "wood" else 0.4
    for x in ((kit.x[0] + 0.02, kit.x[0] + 0.02 + s), (front - 0.06 - s, front - 0.06)):
        for y in ((kit.y[0] + 0.03, kit.y[0] + 0.03 + s), (kit.y[1] - 0.03 - s, kit.y[1] - 0.03)):
            b.box(post, x, y, (0, h - 0.05))
    b.fill = 1.0
    b.box(top, (kit.x[0] + 0.03, front - 0.07), (kit.y[0] + 0.03 + s, kit.y[1] - 0.03 - s), (0.15, 0.18))
    for x in ((kit.x[0] + 0.03, kit.x[0] + 0.06), (front - 0.1, front - 0.07)):
        b.box(post, x, (kit.y[0] + 0.03 + s, kit.y[1] - 0.03 - s), (0.08, 0.149))
    wide = min(0.55, 0.4 * kit.w)
    y = (kit.y[1] - 0.03 - s - wide, kit.y[1] - 0.03 - s)
    cases.cabinet(
        kit, own, (kit.x[0] + 0.11, front), y, (h - 0.05 - 0.36, h - 0.05), [[Cell("drawer", 0.8), Cell("drawer", 1.0)]]
    )
