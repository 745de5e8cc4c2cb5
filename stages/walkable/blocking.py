"""Which objects keep a robot from something."""

from collections.abc import Hashable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, footprints, grid
from apartgen.stages.walkable import importance
from apartgen.stages.walkable.site import Changes, Scene, Site


@dataclass(frozen=True)
class View:
    """What decides whether the robot gets to `target`: the rooms whose furniture can be in its way, on a raster.

    `count` holds how many of the scene's objects keep the robot off each cell.
    """

    target: str
    rooms: frozenset[str]
    space: reach.Space
    reach: float
    scene: dict[str, Furnishing]
    count: grid.Count

    def reaches(self, changes: Changes) -> bool:
        """Whether the robot gets to the target when some objects of the scene are changed or, with None, away."""
        old = [self.scene[name] for name in changes if name in self.scene]
        new = [o for o in changes.values() if o is not None and o.room in self.rooms]
        count = reach.recounted(self.space, self.count, old, new)
        it = changes.get(self.target, self.scene.get(self.target))
        cells = np.asarray(self.space.open & (count == 0))
        return not reach.survey(self.space, [it] if it else [], self.reach, cells, only=(self.target,)).missed

    @property
    def key(self) -> Hashable:
        """What the view's answers depend on."""
        shapes = tuple((o.id, o.center, o.size, o.yaw) for o in self.scene.values())
        return self.target, shapes, self.space.entry.tobytes()

    def may_help(self, o: Furnishing) -> bool:
        """Whether any floor is joined to what the robot gets to when an object goes; else that can't change a thing."""
        window, hit = grid.shade(boxes.of([o]), self.space.grid, self.space.radius)
        freed = (hit > 0) & (self.count[window] == 1) & self.space.open[window]
        return bool((freed & self._beside[window]).any())

    @cached_property
    def _beside(self) -> boxes.Mask:
        """Cells that the robot gets to, those beside them, and those where it comes in."""
        got = grid.from_seeds(np.asarray(self.space.open & (self.count == 0)), self.space.entry)
        wide = got | self.space.entry
        wide[1:] |= got[:-1]
        wide[:-1] |= got[1:]
        wide[:, 1:] |= got[:, :-1]
        wide[:, :-1] |= got[:, 1:]
        return np.asarray(wide)


def view(site: Site, scene: Scene, target: str) -> View:
    """The view that decides about a door, a room or an object."""
    links = [set(o.rooms) for o in site.world.plan.openings if o.kind in ("door", "opening")]
    own = frozenset(rooms(site, scene, target)).union(*(link for link in links if target in link))
    space = reach.part(site.world, own, reach.free(site.world, scene))
    near = {o.id: o for o in scene if o.room in own}
    return View(target, own, space, site.config.reach, near, reach.count(space, list(near.values())))


def rooms(site: Site, scene: Scene, target: str) -> set[str]:
    """The rooms that a door joins, or that an object stands in; of a room itself."""
    for opening in site.world.plan.openings:
        if opening.id == target:
            return set(opening.rooms)
    return {next((o.room for o in scene if o.id == target), target)}


def missed(site: Site, scene: Scene) -> list[str]:
    """Ids of the doors, rooms and articulated objects that the robot does not get to."""
    return reach.survey(site.world, scene, site.config.reach).missed


def blockers(site: Site, scene: Scene, here: View) -> tuple[list[Furnishing], list[Furnishing]]:
    """Objects each of which alone keeps the robot from the target; and, without such, a least set that does together.

    Both begin with what matters least. Nothing at all is returned when an empty room would not help.
    """
    near = [o for o in here.scene.values() if reach.in_the_way(o) and o.id != here.target]
    ranks = importance.Ranks(site, scene)
    near.sort(key=lambda o: (ranks.of(o), footprints.area(o), o.id))
    single = [o for o in near if here.may_help(o) and here.reaches({o.id: None})]
    if single or not here.reaches({o.id: None for o in near}):
        return single, []
    least = list(near)
    for o in reversed(near):
        rest = [p for p in least if p.id != o.id]
        if here.reaches({p.id: None for p in rest}):
            least = rest
    return [], least
