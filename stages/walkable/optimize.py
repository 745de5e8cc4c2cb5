"""Algorithm 2: replace the largest objects by smaller ones until enough floor is free; then leave some out."""

from collections.abc import Callable, Collection

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Step
from apartgen.stages.space import footprints
from apartgen.stages.space.boxes import Array
from apartgen.stages.walkable import importance
from apartgen.stages.walkable.changes import applied, dropped, replaced
from apartgen.stages.walkable.site import Scene, Site, in_room
from apartgen.stages.walkable.smaller import smaller

EPSILON = 1e-9
Among = Callable[[Scene], Collection[str]]
"""Ids of some objects of a scene."""


def area_ratio(site: Site, scene: Scene, rooms: Collection[str]) -> float:
    """AreaRatio(S): free share of the rooms' floors, footprints as a union."""
    floors = {room: site.floors[room] for room in rooms}
    free = [_free(site, room, in_room(scene, room)) for room in floors]
    return float(sum(free) / sum(floor.area for floor in floors.values()))


def _free(site: Site, room: str, objects: list[Furnishing]) -> float:
    """Free floor of a room, m²; kept, because the same rooms are asked about again and again."""
    key = (room, *((o.center, o.size, o.yaw, o.category) for o in objects))
    if key not in site.free:
        floor = site.floors[room]
        site.free[key] = footprints.walkable_ratio(floor, objects) * floor.area
    return site.free[key]


class _Ratios:
    """AreaRatio of some rooms, kept up to date room by room."""

    def __init__(self, site: Site, scene: Scene, rooms: Collection[str]) -> None:
        self._site = site
        self._free = {room: area_ratio(site, scene, [room]) * site.floors[room].area for room in rooms}
        self._area = sum(site.floors[room].area for room in rooms)

    def update(self, scene: Scene, room: str) -> None:
        """Take in what changed in a room."""
        self._free[room] = area_ratio(self._site, scene, [room]) * self._site.floors[room].area

    @property
    def whole(self) -> float:
        """Free share of all the rooms' floors."""
        return float(sum(self._free.values()) / self._area)


def optimize(
    site: Site, scene: Scene, rooms: Collection[str], start: Scene | None = None, least: float = 0.0,
    kept: Collection[str] = (),
) -> tuple[Scene, list[Step]]:
    """The loop of Algorithm 2 over the objects of some rooms.

    Valid objects are obstacles not yet found to have no smaller candidate, of no category in `kept`. Where `least` is
    given, no object gets smaller than that share of its sides in `start`, and what has a standard size stays as it is.
    """
    config = site.config
    first = {o.id: np.asarray(o.size) * least for o in start or scene}
    r, target = _Ratios(site, scene, rooms), site.target(rooms)
    spent: set[str] = set()
    steps: list[Step] = []
    iteration = 0
    while r.whole < target - EPSILON and iteration < config.max_iterations:
        valid = [o for o in scene if o.room in rooms and o.id not in spent and footprints.is_obstacle(o)
                 and o.category not in kept and (least == 0 or importance.easily_smaller(o))]
        top = sorted(valid, key=lambda o: (-footprints.area(o), o.id))[: config.top_k]
        if not top:
            break
        for o in top:
            # An earlier replacement of the same iteration may have moved it with its support.
            o = next(p for p in scene if p.id == o.id)
            found = smaller(site, scene, o, config.share)
            if found is None or not _within(found[o.id], first[o.id]):
                spent.add(o.id)
                continue
            scene, step = applied(scene, replaced(o, found, "ratio"))
            steps.append(step)
            r.update(scene, o.room)
        iteration += 1
    return scene, steps


def _within(new: Furnishing | None, low: Array) -> bool:
    return new is not None and bool((np.asarray(new.size) >= low - EPSILON).all())


def thin_out(
    site: Site, scene: Scene, rooms: Collection[str], most: int = 1, among: Among = importance.anything
) -> tuple[Scene, list[Step]]:
    """Leave out the least important objects of some rooms until the target is met or only needed ones are left.

    Only objects of up to a rank (see `importance.Ranks`) and those that `among(scene)` names.
    """
    steps: list[Step] = []
    r = _Ratios(site, scene, rooms)
    while r.whole < site.target(rooms) - EPSILON:
        loose = [o for o in importance.droppable(site, scene, most) if o.room in rooms and o.id in among(scene)]
        gone = next((o for o in loose if _frees(site, scene, o)), None)
        if gone is None:
            break
        scene, step = applied(scene, dropped(gone, scene, "ratio"))
        steps.append(step)
        r.update(scene, gone.room)
    return scene, steps


def _frees(site: Site, scene: Scene, o: Furnishing) -> bool:
    without = tuple(p for p in scene if p.id != o.id)
    return area_ratio(site, without, [o.room]) > area_ratio(site, scene, [o.room]) + EPSILON
