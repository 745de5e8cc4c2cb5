"""The building about the furniture: where room doors turn, what is wall, and how high it is."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely
from shapely import Geometry
from shapely.ops import unary_union

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.scene import joinery, shell
from apartgen.stages.space import convex, polygons
from apartgen.stages.space.convex import Hulls

LEVER = 0.06
"""Levers of doors stand out by less than this, m."""
LEVERS = (joinery.HANDLE_HEIGHT - 0.02, joinery.HANDLE_HEIGHT + 0.02)
"""Heights between which they are, m."""
INTO_WALL = 0.0005
"""What is no deeper in a wall touches it, m."""


@dataclass(frozen=True)
class Leaf:
    """A room door: `swing` is floor that its leaf sweeps, `zone` with its levers, `ends` where they are shut and open.

    `about` is the wall's cut and what is beside it, which levers pass.
    """

    plan: Plan
    opening: Opening
    swing: Geometry
    zone: Geometry
    ends: Geometry
    about: Geometry

    @cached_property
    def _hulls(self) -> tuple[Hulls, Hulls]:
        (_, face), position, yaw = shell.frame(self.plan, self.opening)
        colliders, joint = joinery.leaf(
            polygons.width(self.opening), face, self.opening, shell.hinge(self.opening, self.plan)
        )
        solids, at = convex.of(colliders), position.tolist()
        ends = [convex.moved(solids, joint, value) for value in joint.range]
        both = Hulls(*(np.concatenate(fields) for fields in zip(*ends)))
        return convex.swept(solids, joint).placed(at, yaw), both.placed(at, yaw)

    @property
    def sweep(self) -> Hulls:
        """What the leaf passes through."""
        return self._hulls[0]

    @property
    def still(self) -> Hulls:
        """The leaf shut and the leaf open."""
        return self._hulls[1]


@dataclass(frozen=True)
class Building:
    """`free`: floors and the ways through walls, in plan; `ways`: by opening id what must stay empty to pass."""

    height: float
    free: Geometry
    leaves: dict[str, Leaf]
    ways: dict[str, Geometry]

    def in_wall(self, solids: Hulls) -> bool:
        """Whether solids reach into a wall."""
        hulls = shapely.convex_hull(shapely.multipoints(solids.points[..., :2]))
        bulge = float(solids.bulge.max(initial=0.0))
        return not bool(shapely.covers(self.free.buffer(INTO_WALL + bulge, join_style="mitre"), hulls).all())


def building(plan: Plan) -> Building:
    """Everything of a plan that moving parts may meet."""
    passages = [o for o in plan.openings if o.kind in polygons.PASSAGES]
    thresholds = {o.id: polygons.threshold(o, plan) for o in passages}
    free = unary_union([*polygons.floors(plan).values(), *thresholds.values()])
    shapely.prepare(free)
    leaves = {o.id: _leaf(o, plan) for o in passages if polygons.hinge(o, plan) is not None}
    ways = {o.id: unary_union([thresholds[o.id], polygons.swing(o, plan)]) for o in passages}
    return Building(plan.height, free, leaves, ways)


def _leaf(opening: Opening, plan: Plan) -> Leaf:
    ends = [polygons.leaf(opening, plan, turned) for turned in (0.0, np.pi / 2)]
    swing = polygons.swing(opening, plan)
    about = polygons.threshold(opening, plan).buffer(2 * LEVER, join_style="mitre")
    return Leaf(plan, opening, swing.buffer(0.002), swing.buffer(LEVER), unary_union(ends).buffer(LEVER), about)
