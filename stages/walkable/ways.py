"""Where the robot gets to in a scene, brought up to date when some objects change."""

from dataclasses import dataclass

import numpy as np

from apartgen.stages.robot import reach
from apartgen.stages.space import grid
from apartgen.stages.space.boxes import Mask
from apartgen.stages.walkable.site import Changes, Scene, Site, swapped


@dataclass(frozen=True)
class Ways:
    """A scene, how many of its objects keep the robot off each cell, where it gets to, and the ids that it misses."""

    scene: Scene
    count: grid.Count
    got: Mask
    missed: frozenset[str]


def ways(site: Site, scene: Scene) -> Ways:
    """The ways in a scene, everything looked at."""
    count = reach.count(site.world, scene)
    found = reach.survey(site.world, scene, site.config.reach, site.world.open & (count == 0))
    return Ways(scene, count, found.cells, frozenset(found.missed))


def after(site: Site, before: Ways, changes: Changes) -> Ways:
    """The ways once some objects are changed.

    Only objects in rooms where something changed, or where the robot gets elsewhere than before, are looked at anew;
    that another way round to a distant one is lost would go unseen.
    """
    world = site.world
    scene = swapped(before.scene, changes)
    old = [o for o in before.scene if o.id in changes]
    new = [o for o in changes.values() if o is not None]
    count = reach.recounted(world, before.count, old, new)
    cells = np.asarray(world.open & (count == 0))
    ways = reach.survey(world, [], site.config.reach, cells)
    names = [room.id for room in world.plan.rooms]
    other = {names[i] for i in np.unique(world.rooms[ways.cells != before.got]).tolist() if i >= 0}
    other.update(o.room for o in (*old, *new))
    near = [o for o in scene if o.room in other]
    found = reach.survey(world, near, site.config.reach, cells, only=[o.id for o in near])
    rest = {o.id for o in scene if o.room not in other}
    return Ways(scene, count, ways.cells, frozenset([*ways.missed, *found.missed, *(before.missed & rest)]))
