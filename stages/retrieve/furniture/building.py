"""Doors and windows of the building; their box is the frame in the wall, [wall depth, width, height]."""

from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.fronts import Span
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.things.asset import Asset

DOOR_STYLES = ("flush", "panelled", "glazed", "boarded")
WINDOW_STYLES = ("casement", "tilt", "fixed", "grid")
_CLEAR = 0.004


def leaf(body: Body, style: str, x: Span, y: Span, z: Span, paint: str) -> None:
    """A room door's leaf in one of `DOOR_STYLES`."""
    if style == "flush":
        body.box(paint, x, y, z)
        return
    stile, mid = 0.11, z[0] + 0.95
    panes = (
        [(z[0] + 0.22, mid), (mid + 0.12, z[1] - stile)]
        if style != "boarded" and z[1] > 1.6
        else [(z[0] + 0.12, z[1] - stile)]
    )
    inner = (y[0] + stile, y[1] - stile)
    for side in ((y[0], inner[0]), (inner[1], y[1])):
        body.box(paint, x, side, z)
    edges = [z[0], *[e for pane in panes for e in pane], z[1]]
    for low, high in zip(edges[::2], edges[1::2], strict=True):
        body.box(paint, x, inner, (low, high))
    thin = ((x[0] + x[1]) / 2 - 0.004, (x[0] + x[1]) / 2 + 0.004)
    for i, pane in enumerate(panes):
        if style == "glazed" and i == len(panes) - 1:
            body.box("glass", thin, inner, pane)
        elif style == "boarded":
            n = max(3, round((inner[1] - inner[0]) / 0.11))
            step = (inner[1] - inner[0]) / n
            for k in range(n):
                body.box(
                    paint, (x[0] + 0.008, x[1] - 0.008), (inner[0] + k * step, inner[0] + (k + 1) * step - 0.003), pane
                )
        else:
            body.box(paint, (x[0] + 0.012, x[1] - 0.012), inner, pane)


def lever(body: Body, x: Span, y: float, z: float, toward: int) -> None:
    """Lever handles on both faces."""
    for side, face in ((-1, x[0]), (1, x[1])):
        out = face + side * 0.045
        body.rod("steel", (face, y, z), (face + side * 0.006, y, z), 0.024, n=16)
        body.rod("steel", (face, y, z), (out, y, z), 0.009, n=10)
        lo, hi = sorted((y, y + toward * 0.12))
        body.rounded("steel", tuple(sorted((out, out + side * 0.012))), (lo, hi), (z - 0.009, z + 0.009), 0.005)


def _frame(kit: Kit, paint: str, wide: float, sill: bool) -> tuple[Span, Span]:
    b = kit.base
    for y in ((kit.y[0], kit.y[0] + wide), (kit.y[1] - wide, kit.y[1])):
        b.box(paint, kit.x, y, (0, kit.h))
    inner = (kit.y[0] + wide, kit.y[1] - wide)
    b.box(paint, kit.x, inner, (kit.h - wide, kit.h))
    if sill:
        b.box(paint, kit.x, inner, (0, wide))
    return inner, (wide if sill else 0.006, kit.h - wide)


@design("door", *DOOR_STYLES)
def door(kit: Kit) -> None:
    """Lining and leaf; the leaf closes at the front and opens toward +x, hinged at +y."""
    paint = {
        "flush": kit.pick("white", "oak", "light_oak"),
        "panelled": kit.pick("white", "cream", "sage"),
        "glazed": kit.pick("white", "oak", "black"),
        "boarded": kit.pick("pine", "navy", "white"),
    }[kit.style]
    inner, z = _frame(kit, "white" if paint in ("oak", "light_oak", "black") else paint, 0.04, False)
    body = Body()
    body.fill = 0.5
    x = (kit.x[1] - 0.04, kit.x[1])
    y, tall = (inner[0] + _CLEAR, inner[1] - 0.002), (z[0], z[1] - _CLEAR)
    leaf(body, kit.style, x, y, tall, paint)
    # A lever stands out of the lining on both sides; it goes with the leaf.
    body.fill = 1.0
    hold = (x[1] + 0.05, y[0] + 0.07, 1.0)
    if tall[1] > 1.2:
        lever(body, x, hold[1], hold[2], 1)
    kit.hinge("leaf", body, (x[1], y[1], 1.0), (0, 0, 1), handle=hold, grip="line_fixed_handle")


@design("window", *WINDOW_STYLES)
def window(kit: Kit) -> None:
    """A frame with glazed sashes; casements turn inward (+x), a tilting one leans in from its lower edge."""
    paint = kit.pick("white", "graphite", "oak")
    inner, z = _frame(kit, paint, 0.045, True)
    if kit.style in ("fixed", "grid"):
        _pane(kit.base, paint, (-0.02, 0.02), inner, z, grid=kit.style == "grid")
        return
    n = 1 if kit.style == "tilt" or kit.w < 0.9 else 2
    x = (kit.x[1] - 0.055, kit.x[1])
    for i in range(n):
        wide = (inner[1] - inner[0]) / n
        y = (inner[0] + i * wide + _CLEAR, inner[0] + (i + 1) * wide - _CLEAR)
        body = Body()
        _pane(body, paint, x, y, (z[0] + 0.002, z[1] - 0.006))
        left = i == n - 1
        if kit.style == "tilt":
            hold = (x[1], (y[0] + y[1]) / 2, z[1] - 0.04)
            kit.hinge("sash", body, (x[1], 0, z[0] + 0.002), (0, 1, 0), "hinge_door", 0.3, hold)
        else:
            hold = (x[1], y[0] + 0.03 if left else y[1] - 0.03, (z[0] + z[1]) / 2)
            kit.hinge("sash", body, (x[1], y[1] if left else y[0], 0), (0, 0, 1 if left else -1), handle=hold)


def _pane(b: Body, paint: str, x: Span, y: Span, z: Span, grid: bool = False) -> None:
    s = 0.05
    for side in ((y[0], y[0] + s), (y[1] - s, y[1])):
        b.box(paint, x, side, z)
    inner, low = (y[0] + s, y[1] - s), (z[0] + s, z[1] - s)
    for rail in ((z[0], low[0]), (low[1], z[1])):
        b.box(paint, x, inner, rail)
    middle = (x[0] + x[1]) / 2
    b.box("glass", (middle - 0.012, middle + 0.012), inner, low)
    if grid:
        for share in (1 / 3, 2 / 3):
            at = inner[0] + share * (inner[1] - inner[0])
            b.box(paint, (x[0] + 0.004, x[1] - 0.004), (at - 0.012, at + 0.012), low)
            at = low[0] + share * (low[1] - low[0])
            b.box(paint, (x[0] + 0.006, x[1] - 0.006), inner, (at - 0.012, at + 0.012))


def door_leaf(
    width: float, height: float, thickness: float = 0.04, style: str = "flush", paint: str = "white"
) -> Asset:
    """A bare leaf with levers, closed, its box `[thickness, width, height]` (levers stand out of it)."""
    kit = Kit("door", style, (thickness, width, height), 0)
    leaf(kit.base, style, kit.x, kit.y, (0.0, height), paint)
    lever(kit.base, kit.x, kit.y[0] + 0.07, min(1.0, 0.5 * height), 1)
    return kit.finish(f"door_leaf/{style}/{round(thickness * 1000)}x{round(width * 1000)}x{round(height * 1000)}/0")
