"""Slicing trees, compiled: what a state is, and the rectangles it cuts an outline into.

A slicing tree cuts the outline by straight walls; each leaf is a rectangle of it and belongs to a room, so rooms
tile the outline without gaps or overlaps. Lengths are metres between wall centre lines ("gross"); floors lie half an
inner wall inside of that.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
from numba import njit
from numpy.typing import NDArray

from apartgen.stages.compiling import WITHIN

F = TypeVar("F", bound=Callable[..., Any])
Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

# Without counting references, since nothing is allocated, and without rewriting array expressions, since there are
# none: both cost much to compile.
COMPILED: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False, "no_rewrites": True}
CALLED = {**COMPILED, **WITHIN, "forceinline": True}


def inner(function: F) -> F:
    """Compiled into those that call it; not cached one by one, as `kernel.anneal` is with all it calls."""
    return cast(F, njit(**CALLED)(function))


def once(function: F) -> F:
    """What is called in one place and is all but made of calls: compiled with its caller, not before it once more."""
    return cast(F, njit(**CALLED, inline="always")(function))


EPS = 1e-6
CORNERED = 0.9
"""Least depth that a cut which follows a corner of the outline leaves on both sides, m."""
TERMS = (
    "shortest_path", "typical_area", "aspect_ratio", "convexity", "conciseness", "exterior_length", "exterior_corner",
    "collinearity", "functional_room", "narrow_passage", "staircase_occupancy", "staircase_iou", "near_rooms",
    "wide_corridor", "privacy",
)  # fmt: skip
PATH, AREA, ASPECT, CONVEX, CONCISE, OUTER, CORNER, LINES, FUNCTION, NARROW, _, _, NEAR, WIDE, PRIVACY = range(15)
LACKING = 15
SPEC = (
    "target", "loose", "width", "joint", "aspect", "form", "corners", "face", "corridor", "functional", "outer",
    "private", "shaft", "across", "lean",
)  # fmt: skip
S_TARGET, S_LOOSE, S_WIDTH, S_JOINT, S_ASPECT, S_FORM, S_CORNERS, S_FACE, S_CORRIDOR = range(9)
S_FUNCTION, S_OUTER, S_PRIVATE, S_SHAFT, S_ACROSS, S_LEAN = range(9, 15)
LIMITS = ("least_stretch", "greatest_stretch", "inner_wall", "link_wall", "entrance_wall", "jog")
L_SHORT, L_LONG, L_WALL, L_LINK, L_ENTRY, L_JOG = range(6)
R_AREA, R_X0, R_Y0, R_X1, R_Y1, R_PIECES, R_JOINTS, R_MAIN, R_WIDTH, R_LEAST, R_FACE, R_OUTER, R_GAPS, R_RIM = range(14)
R_BROAD, R_COLUMNS = 14, 15
LEFT, RIGHT, UPRIGHT = range(3)


class Problem(NamedTuple):
    """What does not change while annealing; `n` rooms, `m` links, `k` blocks, `e` edges."""

    spec: Floats  # (n, 13) of each room, by SPEC; lengths and areas net; private: 1 bedrooms, -1 the living room
    links: Ints  # (m, 2)
    near: Ints  # (q, 3) two rooms that should be close to one another, and how much that counts
    order: Ints  # (n, 3) rooms breadth first from the entrance, the room before each and their link, -1 at the start
    blocks: Floats  # (k, 4) x0 y0 x1 y1, disjoint, together the outline
    edges: Floats  # (e, 6) axis (0: x is constant), coordinate, lo, hi, window allowed, entrance allowed
    wishes: Floats  # (v, 6) kind, room, other room, x, y, what it counts; see `wished`
    weights: Floats  # (15,) by TERMS
    limits: Floats  # (6,) by LIMITS


class Tree(NamedTuple):
    """A state. Nodes 0..L-1 are leaves, L..2L-2 cuts; row 2L-1 of `nodes` holds the root."""

    nodes: Ints  # (2L, 3) left, right, upright of a cut; the room (in `left`) of a leaf
    share: Floats  # (L + 1,) gross area wanted by each leaf, any unit; then x times this, y divided by it


class Scratch(NamedTuple):
    """Measures of the state evaluated last, and the outline as far as it was stretched then."""

    box: Floats  # (2L-1, 6) x0 y0 x1 y1, area wanted, 1 where the outline is known to cover all of it
    seq: Ints  # (2L + 2,) nodes, parents first; last, the number of pieces
    cuts: Ints  # (2L,) the cuts among them
    ends: Ints  # (2L,) the leaves among them
    piece: Floats  # (P, 4) rectangles of rooms
    owner: Ints  # (P,)
    last: Ints  # (n,) last piece of each room
    before: Ints  # (P,) the piece of the same room before each, -1 for the first
    wall: Floats  # (m, 4) longest straight wall between two linked rooms, its middle, its extent along x
    room: Floats  # (n, 15) by the R_ columns
    terms: Floats  # (16,) by TERMS, then the lack
    # (7,) entrance x, y (else of its room), length of its wall, distance of its room from such a wall and of itself
    # from the living room's door, and that door's x, y
    entry: Floats
    walked: Floats  # (n, 3) distance to the room's door, x, y of it
    area: Floats  # (n,) of the state accepted last
    scale: Floats  # (1,) the stretch of the next four
    block: Floats  # (k, 4) x0 y0 x1 y1
    around: Floats  # (4,) x0 y0 x1 y1 of all blocks
    level: Floats  # (2, e + 1) lines of the inner edges where y, and where x is constant; last, how many
    edge: Floats  # (e, 3) coordinate, lo, hi
    clip: Floats  # (k, 3) of the blocks within a box along a cut's way: from, to, and their breadth across it


@inner
def _stretch(p: Problem, s: float, z: Scratch) -> None:
    # blocks and edges of the outline, stretched anew only where the stretch changed
    if z.scale[0] == s:
        return
    z.scale[0] = s
    x0, y0, x1, y1 = 1e9, 1e9, -1e9, -1e9
    for k in range(p.blocks.shape[0]):
        z.block[k, 0], z.block[k, 2] = p.blocks[k, 0] * s, p.blocks[k, 2] * s
        z.block[k, 1], z.block[k, 3] = p.blocks[k, 1] / s, p.blocks[k, 3] / s
        x0, y0 = min(x0, z.block[k, 0]), min(y0, z.block[k, 1])
        x1, y1 = max(x1, z.block[k, 2]), max(y1, z.block[k, 3])
    z.around[0], z.around[1], z.around[2], z.around[3] = x0, y0, x1, y1
    last = p.edges.shape[0]
    z.level[0, last] = z.level[1, last] = 0.0
    for e in range(last):
        edge, upright = p.edges[e], p.edges[e, 0] == 0
        across = s if upright else 1 / s
        z.edge[e, 0], z.edge[e, 1], z.edge[e, 2] = edge[1] * across, edge[2] / across, edge[3] / across
        line, lo, hi, axis = (edge[1] * s, x0, x1, 1) if upright else (edge[1] / s, y0, y1, 0)
        if line - lo > CORNERED and hi - line > CORNERED:
            z.level[axis, int(z.level[axis, last])] = line
            z.level[axis, last] += 1.0


@inner
def _clipped(z: Scratch, box: Floats, upright: int) -> tuple[int, float]:
    # the blocks that reach into a box, in `z.clip`; how many, and their area within it
    count, area, x0, y0, x1, y1 = 0, 0.0, box[0], box[1], box[2], box[3]
    for k in range(z.block.shape[0]):
        block = z.block[k]
        u0, v0, u1, v1 = max(x0, block[0]), max(y0, block[1]), min(x1, block[2]), min(y1, block[3])
        if u1 - u0 > 0 and v1 - v0 > 0:
            area += (u1 - u0) * (v1 - v0)
            clip = z.clip[count]
            if upright:
                clip[0], clip[1], clip[2] = u0, u1, v1 - v0
            else:
                clip[0], clip[1], clip[2] = v0, v1, u1 - u0
            count += 1
    return count, area


@inner
def _shared_out(z: Scratch, count: int, a: float, b: float, goal: float, first: float) -> float:
    # where a cut between two ends leaves an area of the clipped blocks before it: Newton, within bounds
    lo, hi, c = a, b, first
    for _ in range(18):
        over, slope = 0.0, 0.0
        for k in range(count):
            clip = z.clip[k]
            if c > clip[0]:
                over += clip[2] * (min(c, clip[1]) - clip[0])
                slope += clip[2] if c < clip[1] else 0.0
        over -= goal
        if abs(over) < EPS:
            break
        if over < 0:
            lo = c
        else:
            hi = c
        c -= over / (slope + 1e-12)
        if c <= lo or c >= hi:
            c = 0.5 * (lo + hi)
    return c


@inner
def _cut(p: Problem, z: Scratch, box: Floats, upright: int, share: float) -> float:
    # where a cut leaves `share` of the covered area before it
    a, b = box[1 - upright], box[3 - upright]
    c = a + share * (b - a)
    if p.blocks.shape[0] == 1:
        return float(c)
    if box[5] == 0.0:
        count, whole = _clipped(z, box, upright)
        if whole < (box[2] - box[0]) * (box[3] - box[1]) - EPS:
            c = _shared_out(z, count, a, b, share * whole, c)
        else:
            box[5] = 1.0
    lines = z.level[upright]
    for e in range(int(lines[lines.shape[0] - 1])):  # follow a nearby corner of the outline
        line = lines[e]
        if abs(line - c) < 0.45 and line - a > CORNERED and b - line > CORNERED:
            return float(line)
    return float(c)


@inner
def _part(z: Scratch, box: Floats, room: int, count: int) -> int:
    # the pieces of the outline within a leaf's box
    one = z.block.shape[0] == 1 or box[5] > 0.0
    one = one or _clipped(z, box, 1)[1] > (box[2] - box[0]) * (box[3] - box[1]) - EPS
    for k in range(1 if one else z.block.shape[0]):
        x0, y0, x1, y1 = box[0], box[1], box[2], box[3]
        if not one:
            block = z.block[k]
            x0, y0, x1, y1 = max(x0, block[0]), max(y0, block[1]), min(x1, block[2]), min(y1, block[3])
        if x1 - x0 > EPS and y1 - y0 > EPS:
            piece = z.piece[count]
            piece[0], piece[1], piece[2], piece[3] = x0, y0, x1, y1
            z.owner[count] = room
            count += 1
    return count


@inner
def _sorted(t: Tree, z: Scratch) -> None:
    # cuts and leaves of a tree, parents first; written without asking which a node is, for no one can foretell that
    leaves, nodes, seq = t.share.shape[0] - 1, t.nodes, z.seq
    seq[0], count, cuts, ends = nodes[2 * leaves - 1, 0], 1, 0, 0
    for i in range(2 * leaves - 1):
        node = seq[i]
        cut = int(node >= leaves)
        seq[count], seq[count + 1] = nodes[node, LEFT], nodes[node, RIGHT]
        z.cuts[cuts], z.ends[ends] = node, node
        count, cuts, ends = count + 2 * cut, cuts + cut, ends + 1 - cut


@inner
def lay(p: Problem, t: Tree, z: Scratch) -> int:
    # boxes of all nodes, pieces of all rooms; returns the number of pieces
    leaves = t.share.shape[0] - 1
    nodes, box = t.nodes, z.box
    _stretch(p, t.share[leaves], z)
    _sorted(t, z)
    for leaf in range(leaves):
        box[leaf, 4] = t.share[leaf]
    for i in range(leaves - 2, -1, -1):
        node = z.cuts[i]
        box[node, 4] = box[nodes[node, LEFT], 4] + box[nodes[node, RIGHT], 4]
    top = nodes[2 * leaves - 1, 0]
    for j in range(4):
        box[top, j] = z.around[j]
    box[top, 5] = 0.0
    for i in range(leaves - 1):
        node = z.cuts[i]
        left, right, upright = nodes[node, LEFT], nodes[node, RIGHT], nodes[node, UPRIGHT]
        c = _cut(p, z, box[node], upright, box[left, 4] / (box[node, 4] + 1e-12))
        for j in (0, 1, 2, 3, 5):
            box[left, j] = box[right, j] = box[node, j]
        box[left, 3 - upright] = box[right, 1 - upright] = c
    count = 0
    for i in range(leaves):
        count = _part(z, box[z.ends[i]], nodes[z.ends[i], 0], count)
    return count
