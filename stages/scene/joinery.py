"""Doors, windows and lined passages as links in the opening's frame.

Origin on the floor in the middle of the opening, +x through the wall towards the room it serves, +y to the left seen
from there. `span` is where the wall's faces lie on x: (far face, near face). Not `shown`, what only shows is left out.
"""

import numpy as np

from apartgen.schemas.plan import Opening
from apartgen.schemas.retrieve import Joint
from apartgen.stages.space import polygons
from apartgen.stages.things import finishes, solids
from apartgen.stages.things.asset import Array, Collider, Link, Material, Mesh

Span = tuple[float, float]
Corner = tuple[float, float, float]

GAP = 0.003
"""Play between a leaf and what is about it, m."""
FLOOR_GAP = 0.008
ARCHITRAVE = (0.005, 0.06)
"""Thickness on the wall and width of a door's surround, m; so thin that it needs no collider."""
HANDLE_HEIGHT = 1.05
LINING = 0.005
"""Thickness of the boards that line a doorway, m; they leave the opening its width."""
ROD = 0.009
"""Radius of a door's handle, m."""
FRAME = 0.06
"""Width of a window's frame, m."""
_PANE_MOST = 1.1  # m, wider windows are divided
_LEAF_DENSITY = 320.0  # kg/m³, a hollow-core leaf


def door(width: float, span: Span, opening: Opening, hinge: int, shown: bool = True) -> list[Link]:
    """Frame and hinged leaf; `hinge` is +1 when it hangs on the left (+y), -1 right, 0 without a leaf."""
    visuals = [*_surround(width, span, opening.head), *_stops(width, span, opening.head)] if shown else []
    frame = Link("frame", visuals, [], 12.0)
    return [frame] if hinge == 0 else [frame, _leaf(width, span[1], opening, hinge, shown)]


def lining_of_passage(width: float, span: Span, opening: Opening, shown: bool = True) -> list[Link]:
    """A passage without a leaf shows its surround only."""
    return [Link("frame", _surround(width, span, opening.head) if shown else [], [], 8.0)]


def _surround(width: float, span: Span, head: float) -> list[Mesh]:
    """Architraves on both faces: two legs and a head each."""
    thick, wide = ARCHITRAVE
    half = width / 2
    found = []
    for x0, x1 in ((span[0] - thick, span[0]), (span[1], span[1] + thick)):
        legs = [(-half - wide, -half, 0.0), (half, half + wide, 0.0), (-half, half, head)]
        found += [solids.box((x0, y0, z0), (x1, y1, head + wide), finishes.FRAME) for y0, y1, z0 in legs]
    return found


def _stops(width: float, span: Span, head: float) -> list[Mesh]:
    """The rebate that a leaf shuts against; thin boards that line the rest of the opening."""
    x0, x1, half = span[0], span[1] - polygons.LEAF - GAP, width / 2
    return [
        solids.box((x0, -half, 0.0), (x1, -half + LINING, head), finishes.FRAME),
        solids.box((x0, half - LINING, 0.0), (x1, half, head), finishes.FRAME),
        solids.box((x0, -half + LINING, head - LINING), (x1, half - LINING, head), finishes.FRAME),
    ]


def _leaf(width: float, face: float, opening: Opening, hinge: int, shown: bool) -> Link:
    lo, hi = _slab(width, face, opening)
    material = finishes.ENTRANCE if opening.kind == "entrance" else finishes.LEAF
    colliders, joint = leaf(width, face, opening, hinge)
    grip = _grip(width, face, hinge)
    visuals = []
    if shown:
        visuals += [solids.box(lo, hi, material), *_panels(lo, hi, material)]
        for at, out in _levers(grip):
            visuals += _lever(at, out, hinge)
    mass = _LEAF_DENSITY * float(np.prod(hi - lo))
    return Link("leaf", visuals, colliders, mass, joint, grip + [0.045, hinge * 0.05, 0.0])


def leaf(width: float, face: float, opening: Opening, hinge: int) -> tuple[list[Collider], Joint]:
    """Colliders of a door's leaf and its levers, and the joint that it hangs on."""
    lo, hi = _slab(width, face, opening)
    joint = Joint(
        name="leaf", type="hinge", axis=(0.0, 0.0, float(hinge)), origin=(face, hinge * width / 2, 0.0),
        range=(0.0, float(np.pi / 2)), part="hinge_door", extent=(_vector(lo), _vector(hi)),
    )
    rods = [rod for at, out in _levers(_grip(width, face, hinge)) for rod in _rods(at, out, hinge)]
    lows = [np.minimum(a, b) - np.where(np.abs(b - a) > 0, 0.0, ROD) for a, b in rods]
    highs = [np.maximum(a, b) + np.where(np.abs(b - a) > 0, 0.0, ROD) for a, b in rods]
    return [solids.slab(lo, hi), *(solids.slab(low, high) for low, high in zip(lows, highs, strict=True))], joint


def _slab(width: float, face: float, opening: Opening) -> tuple[Array, Array]:
    """Least and greatest corners of the leaf."""
    half = width / 2 - GAP
    return np.array([face - polygons.LEAF, -half, FLOOR_GAP]), np.array([face, half, opening.head - GAP])


def _grip(width: float, face: float, hinge: int) -> Array:
    """Where the lever is on the near face."""
    return np.array([face, -hinge * (width / 2 - GAP - 0.07), HANDLE_HEIGHT])


def _levers(grip: Array) -> list[tuple[Array, int]]:
    """Where the levers of both faces are, and which way they stand out."""
    return [(grip - [polygons.LEAF, 0, 0], -1), (grip, 1)]


def _vector(v: Array) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])


def _panels(lo: Array, hi: Array, material: Material) -> list[Mesh]:
    """Two raised fields on each face, 2 mm proud, so that a leaf does not look like a slab."""
    margin, middle = 0.12, lo[2] + 0.42 * (hi[2] - lo[2])
    if hi[1] - lo[1] < 4 * margin:
        return []
    fields = ((lo[2] + 1.5 * margin, middle - margin / 2), (middle + margin / 2, hi[2] - margin))
    tone = tuple(0.94 * c for c in material.color[:3])
    raised = Material(f"{material.name}_field", (tone[0], tone[1], tone[2], 1.0), material.roughness)
    x0, y0, x1, y1 = lo[0] - 0.002, lo[1] + margin, hi[0] + 0.002, hi[1] - margin
    return [solids.box((x0, y0, z0), (x1, y1, z1), raised) for z0, z1 in fields]


def _rods(at: Array, out: int, hinge: int) -> list[tuple[Array, Array]]:
    """Neck and lever, which points to the hinge."""
    neck = at + [out * 0.045, 0, 0]
    return [(at, neck), (neck + [0, -hinge * 0.009, 0], neck + [0, hinge * 0.11, 0])]


def _lever(at: Array, out: int, hinge: int) -> list[Mesh]:
    """A lever handle: rose, neck, and lever."""
    rose = solids.cylinder(at, at + [out * 0.004, 0, 0], 0.025, finishes.METAL)
    return [rose, *(solids.cylinder(a, b, ROD, finishes.METAL, 10) for a, b in _rods(at, out, hinge))]


def window(width: float, span: Span, opening: Opening, shown: bool = True) -> list[Link]:
    """A fixed glazed window near the outer third of the wall, with a board inside."""
    at = span[0] + 0.4 * (span[1] - span[0])
    x0, x1, half = at - 0.035, at + 0.035, width / 2
    z0, z1 = opening.sill, opening.head
    panes = max(1, int(np.ceil(width / _PANE_MOST)))
    posts = np.linspace(-half, half, panes + 1)
    bars = [(-half, half, z0, z0 + FRAME), (-half, half, z1 - FRAME, z1)]
    for k, y in enumerate(posts):
        shift = {0: FRAME / 2, panes: -FRAME / 2}.get(k, 0.0)
        bars.append((y + shift - FRAME / 2, y + shift + FRAME / 2, z0 + FRAME, z1 - FRAME))
    corners = [((x0, a, b), (x1, c, d)) for a, c, b, d in bars] + _board(half, x1, span[1], z0)
    pane = (at - 0.008, -half + FRAME, z0 + FRAME), (at + 0.008, half - FRAME, z1 - FRAME)
    visuals = []
    if shown:
        visuals += [*(solids.box(lo, hi, finishes.FRAME) for lo, hi in corners), solids.box(*pane, finishes.GLASS)]
    return [Link("frame", visuals, [solids.slab(lo, hi) for lo, hi in [*corners, pane]], 20.0)]


def _board(half: float, x0: float, face: float, sill: float) -> list[tuple[Corner, Corner]]:
    """Two corners of the board inside, none where the sill is near the floor."""
    if sill < 0.3:
        return []
    return [((x0, -half, sill), (face + ARCHITRAVE[0], half, sill + 0.02))]
