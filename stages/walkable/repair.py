"""Connectivity: let a robot get from the entrance through every door to in front of all that opens.

For each thing it does not get to, the objects in the way are found; then, in this order, one of them is replaced by
a smaller one, nudged, or the least important are left out. A repair counts only if nothing else is lost by it.
"""

from collections.abc import Iterator, Sequence

from schemas.retrieve import Furnishing
from schemas.walkable import Step
from stages import footprints, grid, reach
from stages.boxes import of as boxes_of
from stages.walkable import importance, placing
from stages.walkable.changes import Change, applied, dropped, nudged, replaced
from stages.walkable.nudge import nudges
from stages.walkable.site import Scene, Site, swapped
from stages.walkable.smaller import smaller

SHARES = (0.9, 0.8, 0.7, 0.6)
"""Sizes tried for a blocking object."""


def connect(site: Site, scene: Scene) -> tuple[Scene, list[Step], list[str]]:
    """Repair until all is reached that can be; returns the scene, the steps, and the ids still not reached."""
    steps: list[Step] = []
    given_up: list[str] = []
    out = missed(site, scene)
    while todo := [target for target in out if target not in given_up]:
        change, left = _repaired(site, scene, todo[0], set(out))
        if change is None:
            given_up.append(todo[0])
            continue
        scene, step = applied(scene, change)
        steps.append(step)
        # What could not be got to before may be possible now.
        out, given_up = left, []
    return scene, steps, out


def missed(site: Site, scene: Scene) -> list[str]:
    """Ids of the doors, rooms and articulated objects that the robot does not get to."""
    return reach.survey(site.world, scene, site.config.reach).missed


def _repaired(site: Site, scene: Scene, target: str, out: set[str]) -> tuple[Change | None, list[str]]:
    """The first change that lets the robot get to `target` and to all it got to before, and what is missed then.

    Where several objects block together and no single change helps, the least important of them goes, as a step on
    the way.
    """
    single, joint = _blockers(site, scene, target)
    for change in _changes(site, scene, target, single):
        after = swapped(scene, change.to)
        if _reaches(site, after, target):
            left = missed(site, after)
            if set(left) < out:
                return change, left
    if not single and site.config.drop:
        for o in joint:
            change = dropped(o, placing.carried(o, scene), target)
            left = missed(site, swapped(scene, change.to))
            if set(left) <= out:
                return change, left
    return None, []


def _reaches(site: Site, scene: Scene, target: str) -> bool:
    return not reach.survey(site.world, scene, site.config.reach, only=(target,)).missed


def _rooms(site: Site, scene: Scene, target: str) -> set[str]:
    """Rooms whose furniture can be in the way of a door, a room or an object."""
    links = [set(o.rooms) for o in site.world.plan.openings if o.kind in ("door", "opening")]
    for opening in site.world.plan.openings:
        if opening.id == target:
            return set(opening.rooms)
    owner = next((o.room for o in scene if o.id == target), None)
    if owner is not None:
        return {owner}
    return {target}.union(*(link for link in links if target in link))


def _blockers(site: Site, scene: Scene, target: str) -> tuple[list[Furnishing], list[Furnishing]]:
    """Objects each of which alone keeps the robot from `target`; and, without such, a least set that does together.

    Both begin with what matters least. Nothing at all is returned when an empty room would not help.
    """
    rooms = _rooms(site, scene, target)
    near = [o for o in scene if o.room in rooms and footprints.is_obstacle(o) and o.id != target]
    near.sort(key=lambda o: (importance.rank(o, scene), footprints.area(o), o.id))
    count = reach.count(site.world, scene)
    single = [o for o in near if _without(site, scene, target, count, [o])]
    if single or not _without(site, scene, target, count, near):
        return single, []
    least = list(near)
    for o in reversed(near):
        rest = [p for p in least if p.id != o.id]
        if _without(site, scene, target, count, rest):
            least = rest
    loose = {o.id for o in importance.droppable(scene, site.program)}
    return [], [o for o in least if o.id in loose]


def _without(site: Site, scene: Scene, target: str, count: grid.Count, gone: Sequence[Furnishing]) -> bool:
    """Whether the robot gets to `target` when some objects are away."""
    left = count.copy()
    shapes = boxes_of(gone)
    for i in range(shapes.n):
        grid.change(left, shapes.take([i]), site.world.grid, site.world.radius, -1)
    ids = {o.id for o in gone}
    rest = [o for o in scene if o.id not in ids]
    cells = site.world.open & (left == 0)
    return not reach.survey(site.world, rest, site.config.reach, cells, only=(target,)).missed


def _changes(site: Site, scene: Scene, target: str, blockers: Sequence[Furnishing]) -> Iterator[Change]:
    """Repairs in order: smaller, nudged, left out; the object that can't be used may change itself, too."""
    own = [o for o in scene if o.id == target]
    for o in (*blockers, *own):
        for share in SHARES:
            found = smaller(site, scene, o, share)
            if found is not None:
                yield replaced(o, found, target)
    for o in (*blockers, *own):
        for moved in nudges(site, scene, o):
            yield nudged(o, moved, target)
    loose = {o.id for o in importance.droppable(scene, site.program)}
    for o in (*blockers, *own):
        if o.id in loose and site.config.drop:
            yield dropped(o, placing.carried(o, scene), target)
