"""Rugs and curtains."""

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.furniture.tables import ellipse


@design("rug", "persian", "kilim", "berber", "plain", "round")
def rug(kit: Kit) -> None:
    """A flat rug with its border or fringe."""
    b, t = kit.base, kit.h
    pile = {
        "persian": kit.pick("rug_border", "rug_blue"),
        "kilim": "rug_kilim",
        "berber": "rug_berber",
        "plain": kit.pick("rug_plain", "rug_stripe"),
        "round": kit.pick("jute", "rug_plain"),
    }[kit.style]
    if kit.style == "round":
        b.prism(pile, ellipse(kit, n=48), 0, t)
        return
    fringe = 0.04 if kit.style in ("persian", "kilim") else 0.0
    y = (kit.y[0] + fringe, kit.y[1] - fringe)
    edge = 0.09 if kit.style == "persian" else 0.015
    border = {"persian": "rug_stripe", "plain": "linen"}.get(kit.style, pile)
    for x in ((kit.x[0], kit.x[0] + edge), (kit.x[1] - edge, kit.x[1])):
        b.box(border, x, y, (0, t))
    inner = (kit.x[0] + edge, kit.x[1] - edge)
    for own in ((y[0], y[0] + edge), (y[1] - edge, y[1])):
        b.box(border, inner, own, (0, t))
    b.box(pile, inner, (y[0] + edge, y[1] - edge), (0, t))
    if fringe:
        _fringe(kit, y, 0.4 * t)


def _fringe(kit: Kit, y: Span, t: float) -> None:
    n = max(10, round(kit.d / 0.03))
    step = kit.d / n
    for own in ((kit.y[0], y[0]), (y[1], kit.y[1])):
        for i in range(n):
            lo = kit.x[0] + (i + 0.2) * step
            kit.base.box("fringe", (lo, lo + 0.6 * step), own, (0, t), touch=False)
        kit.base.block(kit.x, own, (0, t))


@design("curtain", "rod", "eyelet", "sheer", "track")
def curtain(kit: Kit) -> None:
    """Two gathered panels drawn to the sides of a rod or track."""
    b = kit.base
    cloth = (
        "sheer"
        if kit.style == "sheer"
        else kit.pick("linen", "grey_fabric", "blue_fabric", "sage_fabric", "rose_velvet", "duvet_sand")
    )
    metal = kit.pick("black_metal", "brass", "white_metal")
    r, rail = 0.011, kit.h - 0.03
    if kit.style == "track":
        b.box("white", (-0.02, 0.02), kit.y, (kit.h - 0.02, kit.h))
        b.box("white", (kit.x[0], -0.02), (-0.02, 0.02), (kit.h - 0.02, kit.h))
        top = kit.h - 0.021
    else:
        b.rod(metal, (0, kit.y[0] + 0.02, rail), (0, kit.y[1] - 0.02, rail), r)
        for s in (-1, 1):
            lo, hi = sorted((s * kit.w / 2, s * (kit.w / 2 - 0.04)))
            b.pillow(metal, (-0.02, 0.02), (lo, hi), (kit.h - 0.05, kit.h - 0.01), 2, 4)
            at = s * (kit.w / 2 - 0.07)
            b.box(metal, (kit.x[0], -r), (at - 0.006, at + 0.006), (rail - 0.008, rail + 0.008))
            b.box(metal, (kit.x[0], kit.x[0] + 0.006), (at - 0.015, at + 0.015), (rail - 0.05, kit.h))
        top = rail - r - 0.002 if kit.style != "eyelet" else rail + 0.02
    gather = 0.3 if kit.style != "sheer" else 0.42
    wide = gather * kit.w
    for y in ((kit.y[0], kit.y[0] + wide), (kit.y[1] - wide, kit.y[1])):
        _folds(kit, cloth, y, (0.0, top))


def _folds(kit: Kit, cloth: str, y: Span, z: Span) -> None:
    """A sheet in folds across the whole depth, 4 mm thick; cloth gives way, so it has no collision pieces."""
    folds = max(3, round((y[1] - y[0]) / 0.1))
    n = folds * 8
    t = np.arange(n + 1) / n
    wave = (kit.d / 2 - 0.002) * np.cos(2 * np.pi * folds * t)
    at = y[0] + t * (y[1] - y[0])
    front = np.column_stack([wave + 0.002, at])
    back = np.column_stack([wave - 0.002, at])
    outline = np.concatenate([front, back[::-1]])
    kit.base.fill = 0.6
    kit.base.add(cloth, mesh.ribbon(outline, *z), touch=False)
    kit.base.fill = 1.0
