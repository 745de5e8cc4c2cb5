"""Doors, drawers, flaps and their handles.

Everything that opens keeps within the width of its own front: a door turns about the vertical line where the
box's front plane (which its handle touches) meets the door's outer edge, so that even an open handle stays inside.
"""

from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.kit import QUARTER, Kit
from apartgen.stages.retrieve.furniture.looks import Look

Span = tuple[float, float]

LEAF = 0.018
"""Thickness of a cabinet door, m."""
GAP = 0.0015
"""Half the gap between two fronts, m."""
PROJECTION = {"bar": 0.028, "knob": 0.024, "cup": 0.024, "edge": 0.012, "tab": 0.014, "none": 0.0}
"""How far each handle stands out in front of its leaf, m."""
GRIP = {"bar": "line_fixed_handle", "cup": "line_fixed_handle", "edge": "line_fixed_handle",
        "knob": "round_fixed_handle", "tab": "line_fixed_handle", "none": ""}  # fmt: skip
_TRAVEL = 0.74
"""Drawers come out by at most this share of the unit's depth (categories.DRAWER_TRAVEL is the bound)."""
_SIDE = 0.012
"""Thickness of a drawer's boards, m."""


def projection(look: Look) -> float:
    """How far the look's handles stand out, m."""
    return PROJECTION[look.handle]


def handle(body: Body, look: Look, x: float, y: float, z: float, length: float, upright: bool) -> None:
    """A handle in front of the leaf's face at x, centred on (y, z)."""
    out = x + PROJECTION[look.handle]
    half = length / 2
    match look.handle:
        case "bar":
            for s in (-1, 1):
                at = (y, z + s * (half - 0.02)) if upright else (y + s * (half - 0.02), z)
                body.box(look.metal, (x, out - 0.008), (at[0] - 0.004, at[0] + 0.004), (at[1] - 0.004, at[1] + 0.004))
            span_y, span_z = ((y - 0.005, y + 0.005), (z - half, z + half))
            if not upright:
                span_y, span_z = (y - half, y + half), (z - 0.005, z + 0.005)
            body.box(look.metal, (out - 0.01, out), span_y, span_z)
        case "knob":
            profile = [(0.007, 0.0), (0.006, 0.009), (0.0145, 0.015), (0.0145, 0.02), (0.009, 0.024)]
            body.turned(look.metal, profile, (x, y, z), 10, along=(1, 0, 0))
        case "cup":
            arch = [(z - 0.018, x), (z - 0.018, x + 0.018), (z - 0.007, out), (z + 0.009, out - 0.005), (z + 0.018, x)]
            body.prism(look.metal, arch, y - min(half, 0.045), y + min(half, 0.045), 1)
        case "edge":
            width = (y - half, y + half) if not upright else (y - 0.007, y + 0.007)
            height = (z - half, z + half) if upright else (z - 0.007, z + 0.007)
            body.box(look.metal, (x, out), width, height)
        case "tab":
            body.box(look.metal, (x, out), (y - 0.014, y + 0.014), (z - 0.03, z + 0.012))


def leaf(body: Body, look: Look, x: Span, y: Span, z: Span) -> None:
    """A front board in the look's profile; its relief is at most 5 mm, so one box collides for it."""
    wide, tall = y[1] - y[0], z[1] - z[0]
    profile = look.profile if min(wide, tall) > 0.1 else "slab"
    if profile == "plank" and wide > tall:
        profile = "slab"
    if profile in ("shaker", "raised", "woven", "glass"):
        _framed(body, look, profile, x, y, z)
    elif profile in ("fluted", "plank"):
        _ribbed(body, look, 0.026 if profile == "fluted" else 0.1, x, y, z)
    else:
        body.box(look.front, x, y, z, touch=False)
    body.block(x, y, z)


def _framed(body: Body, look: Look, profile: str, x: Span, y: Span, z: Span) -> None:
    stile = min(0.07, 0.22 * min(y[1] - y[0], z[1] - z[0]))
    frame = look.body if profile == "woven" else look.front
    inner_y, inner_z = (y[0] + stile, y[1] - stile), (z[0] + stile, z[1] - stile)
    for side in ((y[0], inner_y[0]), (inner_y[1], y[1])):
        body.box(frame, x, side, z, touch=False)
    for rail in ((z[0], inner_z[0]), (inner_z[1], z[1])):
        body.box(frame, x, inner_y, rail, touch=False)
    recess = (x[0] + 0.003, x[1] - 0.005)
    if profile == "glass":
        recess = (x[0] + 0.004, x[0] + 0.008 if x[1] - x[0] > 0.03 else x[1] - 0.005)
    panel = {"woven": "cane", "glass": "glass"}.get(profile, look.front)
    body.box(panel, recess, inner_y, inner_z, touch=False)
    if profile == "raised":
        b = min(0.035, 0.2 * (inner_y[1] - inner_y[0]), 0.3 * (inner_z[1] - inner_z[0]))
        field = (inner_y[0] + b, inner_y[1] - b), (inner_z[0] + b, inner_z[1] - b)
        body.box(look.front, (recess[1], x[1] - 0.001), *field, touch=False)


def _ribbed(body: Body, look: Look, pitch: float, x: Span, y: Span, z: Span) -> None:
    count = max(2, round((y[1] - y[0]) / pitch))
    step = (y[1] - y[0]) / count
    body.box(look.front, (x[0], x[1] - 0.004), y, z, touch=False)
    groove = 0.004 if pitch < 0.05 else 0.0015
    for i in range(count):
        rib = (y[0] + i * step + (groove if i else 0), y[0] + (i + 1) * step - (groove if i < count - 1 else 0))
        body.box(look.front, (x[1] - 0.004, x[1]), rib, z, touch=False)


def door(
    kit: Kit, look: Look, front: float, y: Span, z: Span, left: bool, thick: float = LEAF, behind: float = 0.0
) -> Body:
    """A hinged leaf over the cell (y, z); `front` is the plane its handle touches, `left` the side of its hinge.

    `behind` is how deep what will be put on the leaf's back is.
    """
    if look.handle == "cup":
        look = look.with_(handle="knob")
    out = projection(look)
    slack = (out + thick + behind) ** 2 / (2 * (y[1] - y[0]))
    tip = GAP + slack
    own_y = (y[0] + tip, y[1] - GAP / 2) if left else (y[0] + GAP / 2, y[1] - tip)
    own_z = (z[0] + GAP, z[1] - GAP)
    body = Body()
    face = front - out
    leaf(body, look, (face - thick, face), own_y, own_z)
    inset = 0.03 if look.handle == "edge" else 0.045
    at_y = own_y[0] + inset if left else own_y[1] - inset
    length = min(0.5, max(0.12, 0.3 * (own_z[1] - own_z[0]))) if look.handle in ("bar", "edge") else 0.09
    length = min(length, own_z[1] - own_z[0] - 0.04)
    inset = length / 2 + 0.05
    at_z = min(own_z[0] + inset, sum(own_z) / 2) if look.hung else _handle_height(own_z, inset)
    handle(body, look, face, at_y, at_z, length, upright=True)
    pivot, axis = (y[1], (0, 0, 1)) if left else (y[0], (0, 0, -1))
    kit.hinge("door", body, (front, pivot, at_z), axis, handle=(front, at_y, at_z), grip=GRIP[look.handle])
    return body


def _handle_height(z: Span, inset: float) -> float:
    """At hand height where the door has it, else `inset` from the near end."""
    if z[1] - z[0] > 1.2:
        return min(max(1.02, z[0] + 0.3), z[1] - 0.3)
    return max(z[1] - inset, (z[0] + z[1]) / 2) if z[0] + z[1] < 2.0 else min(z[0] + inset, (z[0] + z[1]) / 2)


def drawer(
    kit: Kit, look: Look, front: float, y: Span, z: Span, opening: Span, depth: float, thick: float = LEAF,
    inside: str = "drawer_board", lip: float = 0.03,
) -> Body:  # fmt: skip
    """A drawer over the cell (y, z) whose tray of five boards runs inside `opening` (y), `depth` behind the front."""
    body = Body()
    own_y, own_z = (y[0] + GAP, y[1] - GAP), (z[0] + GAP, z[1] - GAP)
    face = front - projection(look)
    leaf(body, look, (face - thick, face), own_y, own_z)
    _tray(body, inside, (face - thick - depth, face - thick), (opening[0] + 0.012, opening[1] - 0.012),
          (z[0] + 0.02, z[1] - lip))  # fmt: skip
    middle_y, at_z = (own_y[0] + own_y[1]) / 2, (own_z[0] + own_z[1]) / 2
    wide = own_y[1] - own_y[0]
    if look.handle == "edge":
        at_z = own_z[1] - 0.02
    places = (-0.25, 0.25) if look.handle in ("knob", "cup") and wide > 0.7 else (0.0,)
    for share in places:
        handle(body, look, face, middle_y + share * wide, at_z, min(0.32, 0.45 * wide), upright=False)
    travel = min(_TRAVEL * kit.d, 0.92 * depth, kit.reach)
    hold = (front, middle_y + places[0] * wide, at_z)
    kit.slide("drawer", body, travel, handle=hold, grip=GRIP[look.handle])
    return body


def _tray(body: Body, material: str, x: Span, y: Span, z: Span) -> None:
    t = _SIDE if z[1] - z[0] > 0.05 else 0.008
    body.box(material, x, y, (z[0], z[0] + t))
    for side in ((y[0], y[0] + t), (y[1] - t, y[1])):
        body.box(material, x, side, (z[0] + t, z[1]))
    across = (y[0] + t, y[1] - t)
    for wall in ((x[0], x[0] + t), (x[1] - t, x[1])):
        body.box(material, wall, across, (z[0] + t, z[1]))


def flap(
    kit: Kit, look: Look, front: float, y: Span, z: Span, thick: float = LEAF, upto: float = QUARTER, bar: float = 0.6
) -> Body:
    """A leaf hinged along its lower edge; the handle is along its upper edge."""
    body = Body()
    out = projection(look)
    slack = (out + thick) ** 2 / (2 * (z[1] - z[0]))
    own_y, own_z = (y[0] + GAP, y[1] - GAP), (z[0] + GAP, z[1] - GAP - slack)
    face = front - out
    leaf(body, look, (face - thick, face), own_y, own_z)
    at_y, at_z = (own_y[0] + own_y[1]) / 2, own_z[1] - min(0.05, 0.25 * (own_z[1] - own_z[0]))
    handle(body, look, face, at_y, at_z, bar * (own_y[1] - own_y[0]), upright=False)
    kit.hinge("flap", body, (front, at_y, own_z[0]), (0, 1, 0), upto=upto, handle=(front, at_y, at_z),
              grip=GRIP[look.handle])  # fmt: skip
    return body


def sliding(kit: Kit, look: Look, x: Span, y: Span, z: Span, travel: float, sign: int) -> None:
    """A door that slides sideways along y inside the box."""
    body = Body()
    body.fill = 0.35 if look.front in ("mirror", "smoked_glass") else 1.0
    leaf(body, look.with_(handle="none"), x, y, z)
    at_y = y[0] + 0.05 if sign > 0 else y[1] - 0.05
    middle = (z[0] + z[1]) / 2
    kit.slide("door", body, travel, (0, sign, 0), "slider_door", handle=(x[1], at_y, middle))
