"""Which colliders of what has moving parts touch what, by bits: no pair of bodies has to be listed, which takes some
solvers minutes.

All else has bit 0 in both masks. A base that parts hang on has a colour, which is a bit, and takes every colour but its
own; its parts have that colour, bit 0, by which all else takes them, and a bit by which parts take each other. Bases
that a part of another could touch have other colours.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import networkx as nx
import numpy as np

from apartgen.stages.things import solids
from apartgen.stages.things.asset import Array, Collider, Link
from apartgen.stages.things.body import Body

ALL, MOVING = 1, 2
FIRST, LAST = 2, 30
"""Bits of colours."""
SPARE = 0.05
"""What is so much further away than a part can reach is never touched, m."""
EVERY = sum(1 << bit for bit in range(FIRST, LAST + 1))


class Mask(NamedTuple):
    """MuJoCo's two masks of a collider; two touch where the first of one meets the second of the other."""

    contype: int
    conaffinity: int

    def meets(self, other: "Mask") -> bool:
        """Whether MuJoCo lets the two touch."""
        return bool(self.contype & other.conaffinity or other.contype & self.conaffinity)


def masks(bodies: Sequence[Body]) -> dict[str, Mask]:
    """By name of the link, for what has other masks than usual; a body for which no colour is left is not in."""
    jointed = {body.name: body for body in bodies if len(body.links) > 1 and not body.free}
    known = {body.name: body for body in bodies}
    together = nx.Graph([(a, b) for a, b in _within(bodies) if a in jointed or b in jointed])
    together.add_nodes_from(jointed)
    groups = [[known[name] for name in sorted(group)] for group in nx.connected_components(together)]
    groups = [group for group in groups if not any(body.free for body in group)]
    colors = nx.greedy_color(_near(groups), "largest_first")
    found = {}
    for k, group in enumerate(groups):
        if FIRST + colors[k] <= LAST:
            own = 1 << (FIRST + colors[k])
            for body in group:
                base, *parts = body.links
                found[body.link_name(base)] = Mask(ALL, EVERY & ~own)
                found |= {body.link_name(part): Mask(ALL | MOVING | own, MOVING) for part in parts}
    return found


def _within(bodies: Sequence[Body]) -> Iterator[tuple[str, str]]:
    return ((body.name, other) for body in bodies for other in body.within)


def _near(groups: Sequence[Sequence[Body]]) -> nx.Graph:
    """Groups of which one's parts could touch another's bases, by their places."""
    graph = nx.Graph()
    graph.add_nodes_from(range(len(groups)))
    rows = [(k, *body.position[:2], *_reach(body)) for k, group in enumerate(groups) for body in group]
    table = np.array(rows).reshape(-1, 5)
    far = np.linalg.norm(table[:, None, 1:3] - table[None, :, 1:3], axis=2)
    touched = table[:, None, 4] + table[None, :, 3]
    met = far < np.maximum(touched, touched.T) + SPARE
    pairs = table[np.argwhere(met), 0].astype(int)
    graph.add_edges_from((a, b) for a, b in pairs.tolist() if a != b)
    return graph


def _reach(body: Body) -> tuple[float, float]:
    """How far from its place its base is, and how far its parts get, m."""
    base, *parts = body.links
    return _furthest(base.colliders, np.zeros(3)), max((_gets(part) for part in parts), default=0.0)


def _gets(part: Link) -> float:
    assert part.joint is not None
    if part.joint.type == "slide":
        return _furthest(part.colliders, np.zeros(3)) + max(abs(end) for end in part.joint.range)
    origin = np.asarray(part.joint.origin, float)
    return float(np.hypot(*origin[:2])) + _furthest(part.colliders, origin, 3)


def _furthest(colliders: Sequence[Collider], at: Array, over: int = 2) -> float:
    points = [(solids.corners(c) - at)[:, :over] for c in colliders]
    return max((float(np.linalg.norm(own, axis=1).max()) for own in points), default=0.0)
