"""Doors, windows and lined passages as links in the opening's frame.

Origin on the floor in the middle of the opening, +x through the wall towards the room it serves, +y to the left seen
from there. `span` is where the wall's faces lie on x: (far face, near face). Not `shown`, what only shows is left out.
"""

import numpy as np

from apartgen.schemas.plan import Opening
from apartgen.schemas.retrieve import Joint
from apartgen.stages.scene import leaves, sashes
from apartgen.stages.scene.sashes import Box, Hole
from apartgen.stages.space import polygons
from apartgen.stages.things import finishes, solids
from apartgen.stages.things.asset import Array, Collider, Link, Material, Mesh
from apartgen.stages.things.finishes import Joinery

Span = tuple[float, float]

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
_LEAF_DENSITY = 320.0  # kg/m³, a hollow-core leaf


def door(width: float, span: Span, opening: Opening, look: Joinery, hinge: int, shown: bool = True) -> list[Link]:
    """Frame and hinged leaf; `hinge` is +1 when it hangs on the left (+y), -1 right, 0 without a leaf."""
    about = (width, span, opening.head, look.frame)
    frame = Link("frame", [*_surround(*about), *_stops(*about)] if shown else [], [], 12.0)
    return [frame] if hinge == 0 else [frame, _leaf(width, span[1], opening, look, hinge, shown)]


def lining_of_passage(width: float, span: Span, opening: Opening, look: Joinery, shown: bool = True) -> list[Link]:
    """A passage without a leaf shows its surround only."""
    return [Link("frame", _surround(width, span, opening.head, look.frame) if shown else [], [], 8.0)]


def _surround(width: float, span: Span, head: float, paint: Material) -> list[Mesh]:
    """Architraves on both faces: two legs and a head each."""
    thick, wide = ARCHITRAVE
    half = width / 2
    found = []
    for x0, x1 in ((span[0] - thick, span[0]), (span[1], span[1] + thick)):
        found += [leaves.upright((x0, y0, 0.0), (x1, y0 + wide, head + wide), paint) for y0 in (-half - wide, half)]
        found.append(solids.box((x0, -half, head), (x1, half, head + wide), paint))
    return found


def _stops(width: float, span: Span, head: float, paint: Material) -> list[Mesh]:
    """The rebate that a leaf shuts against; thin boards that line the rest of the opening."""
    x0, x1, half = span[0], span[1] - polygons.LEAF - GAP, width / 2
    return [
        leaves.upright((x0, -half, 0.0), (x1, -half + LINING, head), paint),
        leaves.upright((x0, half - LINING, 0.0), (x1, half, head), paint),
        solids.box((x0, -half + LINING, head - LINING), (x1, half - LINING, head), paint),
    ]


def _leaf(width: float, face: float, opening: Opening, look: Joinery, hinge: int, shown: bool) -> Link:
    lo, hi = _slab(width, face, opening)
    colliders, joint = leaf(width, face, opening, hinge)
    grip = _grip(width, face, hinge)
    visuals = []
    if shown:
        visuals += leaves.leaf("panelled" if opening.kind == "entrance" else look.door, lo, hi, look.leaf)
        for at, out in _levers(grip):
            visuals += _lever(at, out, hinge, look.metal)
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


def _rods(at: Array, out: int, hinge: int) -> list[tuple[Array, Array]]:
    """Neck and lever, which points to the hinge."""
    neck = at + [out * 0.045, 0, 0]
    return [(at, neck), (neck + [0, -hinge * 0.009, 0], neck + [0, hinge * 0.11, 0])]


def _lever(at: Array, out: int, hinge: int, metal: Material) -> list[Mesh]:
    """A lever handle: rose, neck, and lever."""
    rose = solids.cylinder(at, at + [out * 0.004, 0, 0], 0.025, metal)
    return [rose, *(solids.cylinder(a, b, ROD, metal, 10) for a, b in _rods(at, out, hinge))]


def window(width: float, span: Span, opening: Opening, look: Joinery, shown: bool = True) -> list[Link]:
    """A glazed window, shut, near the outer third of the wall, with a board inside."""
    at = span[0] + 0.4 * (span[1] - span[0])
    hole = Hole(width / 2, opening.sill, opening.head, at)
    made = sashes.window(look.window, hole)
    y0, y1, z0, z1 = hole.inner()
    pane = (at - 0.008, y0, z0), (at + 0.008, y1, z1)
    wood = made.bars + _board(hole.half, at + 0.035, span[1], opening.sill)
    visuals = []
    if shown:
        visuals = [*(solids.box(*box, look.frame) for box in wood), solids.box(*pane, finishes.GLASS),
                   *(solids.box(*box, look.metal) for box in made.handles)]
    return [Link("frame", visuals, [solids.slab(*box) for box in [*wood, pane, *made.handles]], 20.0)]


def _board(half: float, x0: float, face: float, sill: float) -> list[Box]:
    """Two corners of the board inside, none where the sill is near the floor."""
    if sill < 0.3:
        return []
    return [((x0, -half, sill), (face + ARCHITRAVE[0], half, sill + 0.02))]
