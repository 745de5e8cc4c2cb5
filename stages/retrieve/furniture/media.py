"""Televisions, monitors, pianos."""

from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit


@design("tv", "pedestal", "feet", "soundbar")
def tv(kit: Kit) -> None:
    """A flat panel on its stand, the screen to the front."""
    b, low = kit.base, 0.06 if kit.style != "soundbar" else 0.1
    thin = min(0.035, 0.6 * kit.d)
    x = (-thin / 2, thin / 2)
    b.fill = 0.35
    b.rounded("plastic_black", x, kit.y, (low, kit.h), 0.005)
    b.box(
        "screen",
        (x[1] - 0.001, x[1] + 0.0015),
        (kit.y[0] + 0.008, kit.y[1] - 0.008),
        (low + 0.015, kit.h - 0.008),
        False,
    )
    b.box(
        "plastic_black",
        (max(kit.x[0], -thin / 2 - 0.03), x[0]),
        (-0.3 * kit.w, 0.3 * kit.w),
        (low + 0.08 * kit.h, 0.55 * kit.h),
    )
    if kit.style == "feet":
        for y in (-0.36 * kit.w, 0.36 * kit.w):
            for s in (-1, 1):
                b.rod("black_metal", (0, y, low), (s * (kit.d / 2 - 0.01), y, 0.006), 0.007, 0.005, 8)
                b.box(
                    "black_metal",
                    (kit.x[0], kit.x[0] + 0.02) if s < 0 else (kit.x[1] - 0.02, kit.x[1]),
                    (y - 0.008, y + 0.008),
                    (0, 0.011),
                )
    else:
        b.box("black_metal", kit.x, (-0.18 * kit.w, 0.18 * kit.w), (0, 0.012))
        b.box("black_metal", (x[0] * 0.7, x[1] * 0.7), (-0.05 * kit.w, 0.05 * kit.w), (0.012, low + 0.002))
        if kit.style == "soundbar":
            front = min(kit.x[1] - 0.004, 0.06)
            b.rounded(
                "charcoal_fabric",
                (min(x[1] + 0.001, front - 0.02), front),
                (-0.4 * kit.w, 0.4 * kit.w),
                (0.015, 0.08),
                0.005,
            )
    b.fill = 1.0


@design("monitor", "office", "curved")
def monitor(kit: Kit) -> None:
    """A screen on a post and foot."""
    b = kit.base
    b.fill = 0.25
    low, dark = 0.32 * kit.h, kit.pick("plastic_black", "aluminium")
    b.box(dark, (-kit.d / 2, kit.d / 2 - 0.02), (-0.2 * kit.w, 0.2 * kit.w), (0, 0.012))
    b.box(dark, (-kit.d / 2 + 0.02, -kit.d / 2 + 0.05), (-0.035, 0.035), (0.012, 0.7 * kit.h))
    b.box(dark, (-kit.d / 2 + 0.05, kit.d / 2 - 0.05), (-0.04, 0.04), (0.6 * kit.h, 0.6 * kit.h + 0.05))
    front, n = kit.x[1], 6 if kit.style == "curved" else 1
    wide = kit.w / n
    for i in range(n):
        y0, y1 = kit.y[0] + i * wide, kit.y[0] + (i + 1) * wide
        x0, x1 = (front - 0.05 * (1 - abs(2 * y / kit.w) ** 2) * (n > 1) for y in (y0, y1))
        for material, back, face, m in ((dark, 0.045, 0.0015, 0.0), ("screen", 0.003, 0.0, 0.006)):
            ya, yb = (y0 + (m if i == 0 else 0), y1 - (m if i == n - 1 else 0))
            outline = [(x0 - back, ya), (x0 - face, ya), (x1 - face, yb), (x1 - back, yb)]
            b.prism(material, outline, low + m, kit.h - m)
    b.fill = 1.0


@design("piano", "upright", "console")
def piano(kit: Kit) -> None:
    """An upright piano; its fall board lifts off the keys."""
    b, h = kit.base, kit.h
    case = kit.pick("piano_black", "walnut") if kit.style == "upright" else kit.pick("cherry", "white")
    key, deep = 0.68, 0.3
    back = kit.x[1] - deep
    for y in ((kit.y[0], kit.y[0] + 0.035), (kit.y[1] - 0.035, kit.y[1])):
        b.box(case, (kit.x[0], back), y, (0.05, h - 0.03))
        b.box(case, (back, kit.x[1]), y, (key - 0.1, key + 0.085))
        b.box(case, (kit.x[1] - 0.07, kit.x[1] - 0.02), y, (0, key - 0.1))
        b.box(case, (kit.x[0] + 0.05, kit.x[1] - 0.071), y, (0, 0.05))
    inner = (kit.y[0] + 0.035, kit.y[1] - 0.035)
    b.fill = 0.3
    b.box(case, (kit.x[0], kit.x[0] + 0.06), inner, (0.05, h - 0.03))
    b.box(case, (back - 0.03, back), inner, (0.05, key - 0.1))
    b.box(case, (back - 0.03, back), inner, (key + 0.09, h - 0.03))
    b.fill = 1.0
    b.box(case, (kit.x[0], back), kit.y, (h - 0.03, h))
    b.box("black_metal", (kit.x[0] + 0.06, kit.x[0] + 0.12), inner, (0.1, key - 0.15))
    b.box(case, (back, kit.x[1]), inner, (key - 0.1, key - 0.02))
    _keys(kit, key, back, inner)
    _pedals(kit, back)
    lid = Body()
    lid_x, z = (back + 0.003, kit.x[1] - 0.01), (key + 0.05, key + 0.07)
    lid.box(case, lid_x, (inner[0] + 0.003, inner[1] - 0.003), z)
    lid.box(case, (lid_x[1] - 0.018, lid_x[1]), (inner[0] + 0.003, inner[1] - 0.003), (key + 0.02, z[0]))
    kit.hinge("lid", lid, (lid_x[0], 0, z[1]), (0, -1, 0), handle=(lid_x[1], 0, key + 0.035))


def _keys(kit: Kit, key: float, back: float, y: tuple[float, float]) -> None:
    b, n = kit.base, 52
    cheek, front = 0.06, kit.x[1] - 0.04
    b.box("ash_black", (back, front), (y[0], y[0] + cheek), (key - 0.02, key + 0.02))
    b.box("ash_black", (back, front), (y[1] - cheek, y[1]), (key - 0.02, key + 0.02))
    run = (y[0] + cheek, y[1] - cheek)
    pitch = (run[1] - run[0]) / n
    for i in range(n):
        at = run[0] + i * pitch
        b.box("keys_white", (back + 0.02, front), (at + 0.0006, at + pitch - 0.0006), (key - 0.019, key), touch=False)
        if i < n - 1 and i % 7 not in (1, 4):
            b.box(
                "piano_black",
                (back + 0.02, front - 0.05),
                (at + 0.7 * pitch, at + 1.3 * pitch),
                (key, key + 0.011),
                touch=False,
            )
    b.block((back + 0.02, front), run, (key - 0.019, key))
    b.block((back + 0.02, front - 0.05), run, (key, key + 0.006))


def _pedals(kit: Kit, back: float) -> None:
    for i in (-1, 0, 1):
        kit.base.rounded("brass", (back, back + 0.1), (i * 0.07 - 0.012, i * 0.07 + 0.012), (0.055, 0.067), 0.005)
