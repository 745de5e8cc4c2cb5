"""Sofas, loveseats, corner sofas, armchairs and pouffes: soft bodies on real legs."""

from dataclasses import dataclass, replace

import numpy as np

from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.things import chaises

_FOAM = 1.6
"""Upholstery's mass over bare foam: its wooden frame, springs and cover."""


@dataclass(frozen=True)
class Seat:
    """An upholstered seat: arm kind and width, leg kind and height, cushion softness, cover."""

    arm: str
    arm_wide: float
    leg: str
    leg_high: float
    soft: float
    covers: tuple[str, ...]
    wood: tuple[str, ...] = ("walnut", "oak")


_SEATS = {
    "modern": Seat("track", 0.16, "block", 0.06, 7, ("grey_fabric", "charcoal_fabric", "linen"), ("black_metal",)),
    "scandi": Seat("wood", 0.05, "wood", 0.2, 6, ("blue_fabric", "sage_fabric", "grey_fabric"), ("oak", "light_oak")),
    "chesterfield": Seat("roll", 0.2, "turned", 0.1, 5, ("brown_leather", "tan_leather", "green_velvet"), ("walnut",)),
    "midcentury": Seat(
        "slim", 0.08, "splay", 0.18, 7, ("mustard_fabric", "rust_fabric", "tan_leather"), ("walnut", "teak")
    ),
    "cloud": Seat("puff", 0.22, "block", 0.03, 3.4, ("cream_boucle", "linen", "rose_velvet"), ("black_metal",)),
}
_ARMCHAIR_MORE = {
    "wing": Seat("slim", 0.09, "turned", 0.16, 5, ("blue_velvet", "plum_velvet", "grey_fabric"), ("walnut",)),
}


def legs(kit: Kit, kind: str, wood: str, high: float, x: Span, y: Span) -> None:
    """Four feet (six under long ones) inside the footprint."""
    if kind == "wood":
        return
    b = kit.base
    shares = (0.0, 1.0) if y[1] - y[0] < 1.9 else (0.0, 0.5, 1.0)
    inset = 0.045 if kind != "splay" else 0.08
    inset = 0.13 if kit.style == "cloud" else inset
    for share in shares:
        py = y[0] + inset + share * (y[1] - y[0] - 2 * inset)
        for sx, px in ((-1, x[0] + inset), (1, x[1] - inset)):
            if kind == "block":
                b.box(wood, (px - 0.025, px + 0.025), (py - 0.025, py + 0.025), (0, high + 0.001))
            elif kind == "turned":
                profile = [
                    (0.014, 0),
                    (0.02, 0.02),
                    (0.03, 0.55 * high),
                    (0.016, 0.75 * high),
                    (0.03, high),
                    (0.03, high + 0.002),
                ]
                b.turned(wood, profile, (px, py, 0), 12)
            else:
                b.leg(wood, (px + 0.03 * sx, py + 0.03 * (2 * share - 1), 0), (px, py, high + 0.002), 0.012, 0.021, 10)


def _arm(kit: Kit, s: Seat, cover: str, wood: str, x: Span, y: Span, high: float, left: bool) -> None:
    b = kit.base
    if s.arm == "wood":
        _wood_arm(kit, wood, x, y, high)
    elif s.arm == "roll":
        r = (y[1] - y[0]) / 2
        b.rounded(cover, x, (y[0] + 0.03, y[1] - 0.03), (s.leg_high, high - r), 0.02)
        c = np.stack([high - r + r * np.cos(t := np.arange(16) * np.pi / 8), (y[0] + y[1]) / 2 + r * np.sin(t)], 1)
        b.prism(cover, c[:, ::-1], x[0] + 0.005, x[1], 0, smooth=True)
    elif s.arm == "puff":
        b.pillow(cover, x, y, (s.leg_high, high), 4.0)
    else:
        b.rounded(cover, x, y, (s.leg_high, high), 0.03 if s.arm == "track" else 0.025)


def _wood_arm(kit: Kit, wood: str, x: Span, y: Span, high: float) -> None:
    b = kit.base
    b.box(wood, x, y, (high - 0.025, high))
    for at in ((x[0] + 0.02, x[0] + 0.065), (x[1] - 0.075, x[1] - 0.03)):
        b.box(wood, at, (y[0] + 0.006, y[1] - 0.006), (0, high - 0.025))
    b.box(wood, (x[0] + 0.065, x[1] - 0.075), (y[0] + 0.008, y[1] - 0.008), (0.2, 0.26))


def _backs(kit: Kit, s: Seat, cover: str, x: float, y: Span, seat: float, n: int, deep: float) -> None:
    wide = (y[1] - y[0]) / n
    for i in range(n):
        own = (y[0] + i * wide + 0.002, y[0] + (i + 1) * wide - 0.002)
        if s.arm == "roll":
            continue
        kit.base.pillow(cover, (x, x + deep), own, (seat - 0.03, kit.h), max(3.2, s.soft - 1.5))


def _tufts(kit: Kit, cover: str, x: float, y: Span, z: Span) -> None:
    cols = min(7, max(3, round((y[1] - y[0]) / 0.22)))
    rows = 2 if cols > 3 else 3
    wide, tall = (y[1] - y[0]) / cols, (z[1] - z[0]) / rows
    for i in range(cols):
        for k in range(rows):
            own_y, own_z = (y[0] + i * wide, y[0] + (i + 1) * wide), (z[0] + k * tall, z[0] + (k + 1) * tall)
            kit.base.pillow(cover, (x - 0.03, x + 0.025), own_y, own_z, 3.5, 4)


@design("sofa", *_SEATS)
@design("loveseat", *_SEATS)
@design("armchair", *_SEATS, *_ARMCHAIR_MORE)
def sofa(kit: Kit) -> None:
    """Arms, a back as high as the box, seat cushions a person wide."""
    s = (_SEATS | _ARMCHAIR_MORE)[kit.style]
    b, cover, wood = kit.base, kit.pick(*s.covers), kit.pick(*s.wood)
    b.fill = _FOAM
    seat = min(0.44, 0.6 * kit.h)
    arm = min(s.arm_wide, 0.17 * kit.w)
    arm_high = kit.h - 0.04 if s.arm == "roll" else min(0.64, 0.78 * kit.h)
    inner = (kit.y[0] + arm, kit.y[1] - arm)
    frame_back = 0.14 if s.arm != "wood" else 0.06
    _shell(kit, s, cover, wood, inner, seat, frame_back)
    for left, y in ((False, (kit.y[0], inner[0])), (True, (inner[1], kit.y[1]))):
        _arm(kit, s, cover, wood, (kit.x[0] + 0.005, kit.x[1]), y, arm_high, left)
    n = 1 if kit.model == "armchair" else max(2, round((inner[1] - inner[0]) / 0.72))
    wide = (inner[1] - inner[0]) / n
    cushion = (seat - 0.17, seat + 0.01)
    for i in range(n):
        y = (inner[0] + i * wide + 0.002, inner[0] + (i + 1) * wide - 0.002)
        b.pillow(cover, (kit.x[0] + frame_back, kit.x[1] - 0.004), y, cushion, s.soft, 4 if s.arm == "roll" else 6)
    _backs(kit, s, cover, kit.x[0] + frame_back - 0.05, inner, seat, n, min(0.24, 0.26 * kit.d))
    if kit.style == "wing":
        _wings(kit, cover, arm)
    b.fill = 1.0
    if kit.model == "sofa":
        _throws(kit, inner, kit.x[0] + frame_back + 0.18, seat)
    legs(kit, s.leg, wood, s.leg_high, (kit.x[0] + 0.01, kit.x[1] - 0.01), kit.y)


def _shell(kit: Kit, s: Seat, cover: str, wood: str, inner: Span, seat: float, back: float) -> None:
    b = kit.base
    if s.arm == "wood":
        b.box(wood, (kit.x[0] + 0.02, kit.x[1] - 0.02), (inner[0], inner[1]), (seat - 0.22, seat - 0.165))
        b.box(wood, (kit.x[0], kit.x[0] + 0.03), (inner[0], inner[1]), (kit.h - 0.16, kit.h - 0.1))
        for y in ((inner[0], inner[0] + 0.04), (inner[1] - 0.04, inner[1])):
            b.box(wood, (kit.x[0], kit.x[0] + 0.03), y, (seat - 0.2, kit.h - 0.16))
        return
    b.rounded(cover, (kit.x[0] + 0.01, kit.x[1] - 0.02), inner, (s.leg_high, seat - 0.155), 0.02)
    if s.arm == "roll":
        r = back / 2
        b.rounded(cover, (kit.x[0] + 0.02, kit.x[0] + back - 0.02), inner, (s.leg_high, kit.h - r), 0.02)
        c = np.stack([kit.h - r + r * np.cos(t := np.arange(16) * np.pi / 8), kit.x[0] + r + r * np.sin(t)], 1)
        b.prism(cover, c, kit.y[0] + 0.05, kit.y[1] - 0.05, 1, smooth=True)
        _tufts(kit, cover, kit.x[0] + back, inner, (seat, kit.h - 2 * r + 0.03))
        return
    b.rounded(cover, (kit.x[0], kit.x[0] + back), (kit.y[0] + 0.01, kit.y[1] - 0.01), (s.leg_high, kit.h - 0.06), 0.035)


def _throws(kit: Kit, y: Span, x: float, seat: float) -> None:
    """A scatter cushion at each end, leaning back."""
    half = min(0.2, 0.42 * (kit.h - seat))
    cover = kit.pick("mustard_fabric", "rust_fabric", "sage_fabric", "blue_velvet", "linen", "cream_boucle")
    for side, at in ((1, y[0] + half + 0.03), (-1, y[1] - half - 0.03)):
        lean, turn = -0.28, 0.22 * side
        c, s, ct, st = np.cos(lean), np.sin(lean), np.cos(turn), np.sin(turn)
        matrix = np.array([[ct, -st, 0], [st, ct, 0], [0, 0, 1]]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        flat = mesh.pillow((-0.06, -half, -half), (0.06, half, half), 2.6, 4)
        kit.base.add(cover, flat.moved((x + 0.08, at, seat + 0.98 * half), matrix))


def _wings(kit: Kit, cover: str, arm: float) -> None:
    for y in ((kit.y[0], kit.y[0] + arm), (kit.y[1] - arm, kit.y[1])):
        kit.base.pillow(cover, (kit.x[0] + 0.02, kit.x[0] + 0.5 * kit.d), y, (0.45 * kit.h, kit.h - 0.002), 3, 6)


@design("corner_sofa", "modern", "midcentury", "cloud", "scandi")
def corner_sofa(kit: Kit) -> None:
    """A sofa along the back with a chaise running forward at its left end, as its symbol has it."""
    s = _SEATS["modern" if kit.style == "scandi" else kit.style]
    cover = kit.pick(*(_SEATS["scandi"].covers if kit.style == "scandi" else s.covers))
    b, wood = kit.base, kit.pick(*s.wood) if kit.style != "scandi" else "oak"
    high = 0.15 if kit.style == "scandi" else s.leg_high
    kind = "splay" if kit.style == "scandi" else s.leg
    b.fill = _FOAM
    seat, arm = min(0.44, 0.6 * kit.h), s.arm_wide
    deep, chaise = chaises.seat_depth(kit.d), chaises.chaise_width(kit.w)
    split = kit.w / 2 - chaise
    main_y, chaise_y = (-kit.w / 2, split), (split, kit.w / 2)
    front = kit.x[0] + deep
    back = 0.15
    for y, x in ((main_y, front), (chaise_y, kit.x[1])):
        b.rounded(cover, (kit.x[0] + 0.01, x - 0.015), (y[0] + 0.003, y[1] - 0.003), (high, seat - 0.155), 0.02)
    b.rounded(cover, (kit.x[0], kit.x[0] + back), kit.y, (high, kit.h - 0.06), 0.035)
    own = replace(s, leg_high=high, arm="puff" if s.arm == "puff" else "track")
    for ends, left in (((-kit.w / 2, arm - kit.w / 2), False), ((kit.w / 2 - arm, kit.w / 2), True)):
        _arm(kit, own, cover, wood, (kit.x[0] + 0.005, front), ends, min(0.62, 0.76 * kit.h), left)
    inner, long = (arm - kit.w / 2, split), (split, kit.w / 2 - arm)
    n = max(1, round((inner[1] - inner[0]) / 0.75))
    wide = (inner[1] - inner[0]) / n
    for i in range(n):
        y = (inner[0] + i * wide + 0.002, inner[0] + (i + 1) * wide - 0.002)
        b.pillow(cover, (kit.x[0] + back, front), y, (seat - 0.17, seat + 0.01), s.soft)
    b.pillow(cover, (kit.x[0] + back, kit.x[1]), (long[0] + 0.002, long[1] - 0.002), (seat - 0.17, seat + 0.01), s.soft)
    _backs(kit, s, cover, kit.x[0] + back - 0.04, (inner[0], inner[1]), seat, n, 0.22)
    _backs(kit, s, cover, kit.x[0] + back - 0.04, (long[0], long[1]), seat, 1, 0.22)
    b.fill = 1.0
    legs(kit, kind, wood, high, (kit.x[0] + 0.01, front - 0.02), kit.y)
    legs(kit, kind, wood, high, (kit.x[1] - 0.3, kit.x[1] - 0.02), chaise_y)


@design("pouffe", "round", "cube", "knit", "tray")
def pouffe(kit: Kit) -> None:
    """A low soft seat."""
    b = kit.base
    b.fill = 2.5
    cover = kit.pick("mustard_fabric", "rose_velvet", "grey_fabric", "cream_boucle", "tan_leather")
    if kit.style == "knit":
        b.pillow(kit.pick("cream_boucle", "grey_fabric"), kit.x, kit.y, (0, kit.h), 2.8, 8)
    elif kit.style == "cube":
        b.rounded(cover, kit.x, kit.y, (0.02, kit.h), 0.04, 3)
        b.fill = 0.1
        b.box("black_metal", (kit.x[0] + 0.05, kit.x[1] - 0.05), (kit.y[0] + 0.05, kit.y[1] - 0.05), (0, 0.02))
    else:
        t = np.arange(32) * np.pi / 16
        ring = np.stack([kit.d / 2 * np.cos(t), kit.w / 2 * np.sin(t)], 1)
        low = 0.12 if kit.style == "tray" else 0.02
        b.prism(cover, ring * 0.985, low, kit.h - 0.09, smooth=True)
        b.pillow(cover, kit.x, kit.y, (kit.h - 0.17, kit.h), 2.6, 8)
        b.fill = 1.0
        if kit.style == "tray":
            for i in range(4):
                a = np.pi / 4 + i * np.pi / 2
                c, s = 0.33 * kit.d * np.cos(a), 0.33 * kit.w * np.sin(a)
                b.leg("oak", (c * 1.15, s * 1.15, 0), (c, s, low + 0.001), 0.011, 0.02, 10)
        else:
            b.prism("black", ring * 0.9, 0, low)
    b.fill = 1.0
