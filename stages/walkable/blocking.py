"""Which objects keep a robot from something."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from schemas.retrieve import Furnishing
from stages import boxes, footprints, grid, reach
from stages.walkable import importance
from stages.walkable.site import Scene, Site


@dataclass(frozen=True)
class View:
    """What decides whether the robot gets to `target`: the rooms whose furniture can be in its way, on a raster."""

    target: str
    rooms: frozenset[str]
    space: reach.Space
    reach: float

    def reaches(self, scene: Iterable[Furnishing]) -> bool:
        """Whether the robot gets to the target among the objects of a scene."""
        near = self.near(scene)
        return not reach.survey(self.space, near, self.reach, only=(self.target,)).missed

    def near(self, scene: Iterable[Furnishing]) -> list[Furnishing]:
        """The objects of the view's rooms."""
        return [o for o in scene if o.room in self.rooms]


def view(site: Site, scene: Scene, target: str) -> View:
    """The view that decides about a door, a room or an object."""
    rooms = frozenset(_rooms(site, scene, target))
    return View(target, rooms, reach.part(site.world, rooms, reach.free(site.world, scene)), site.config.reach)


def _rooms(site: Site, scene: Scene, target: str) -> set[str]:
    links = [set(o.rooms) for o in site.world.plan.openings if o.kind in ("door", "opening")]
    for opening in site.world.plan.openings:
        if opening.id == target:
            return set(opening.rooms)
    owner = next((o.room for o in scene if o.id == target), None)
    if owner is not None:
        return {owner}
    return {target}.union(*(link for link in links if target in link))


def blockers(site: Site, scene: Scene, here: View) -> tuple[list[Furnishing], list[Furnishing]]:
    """Objects each of which alone keeps the robot from the target; and, without such, a least set that does together.

    Both begin with what matters least; of the set only what may be left out is given. Nothing at all is returned when
    an empty room would not help.
    """
    near = [o for o in here.near(scene) if reach.in_the_way(o) and o.id != here.target]
    near.sort(key=lambda o: (importance.rank(o, scene), footprints.area(o), o.id))
    count = reach.count(here.space, here.near(scene))
    single = [o for o in near if _without(scene, here, count, [o])]
    if single or not _without(scene, here, count, near):
        return single, []
    least = list(near)
    for o in reversed(near):
        rest = [p for p in least if p.id != o.id]
        if _without(scene, here, count, rest):
            least = rest
    loose = {o.id for o in importance.droppable(scene, site.program)}
    return [], [o for o in least if o.id in loose]


def _without(scene: Scene, here: View, count: grid.Count, gone: list[Furnishing]) -> bool:
    """Whether the robot gets to the target when some objects are away."""
    left = count - grid.near(boxes.of(gone), here.space.grid, here.space.radius)
    ids = {o.id for o in gone}
    rest = [o for o in here.near(scene) if o.id not in ids]
    cells = np.asarray(here.space.open & (left == 0))
    return not reach.survey(here.space, rest, here.reach, cells, only=(here.target,)).missed
