"""Connectivity: let a robot get from the entrance through every door to in front of all that opens.

For each thing it does not get to, the objects in the way are found; then, in this order, one of them is replaced by
a smaller one, nudged, or the least important are left out. A repair counts only if nothing else is lost by it.
"""

from collections.abc import Iterator

from schemas.retrieve import Furnishing
from schemas.walkable import Step
from stages import reach
from stages.walkable import importance, placing
from stages.walkable.blocking import View, blockers, view
from stages.walkable.changes import Change, applied, dropped, nudged, replaced
from stages.walkable.nudge import nudges
from stages.walkable.site import Scene, Site, fits, swapped
from stages.walkable.smaller import candidate, limits

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
    here = view(site, scene, target)
    single, joint = blockers(site, scene, here)
    for change in _changes(site, scene, here, single):
        left = missed(site, swapped(scene, change.to))
        if set(left) < out:
            return change, left
    if not single and site.config.drop:
        for o in joint:
            change = dropped(o, placing.carried(o, scene), target)
            left = missed(site, swapped(scene, change.to))
            if set(left) <= out:
                return change, left
    return None, []


def _changes(site: Site, scene: Scene, here: View, single: list[Furnishing]) -> Iterator[Change]:
    """Repairs that reach the target, in order: smaller, nudged, left out; what can't be used may change itself, too."""
    able = [*single, *(o for o in scene if o.id == here.target)]
    for o in able:
        yield from _smaller(site, scene, here, o)
    for o in able:
        for moved in nudges(site, scene, o):
            if here.reaches(swapped(scene, moved)) and fits(site, scene, moved):
                yield nudged(o, moved, here.target)
    loose = {o.id for o in importance.droppable(scene, site.program)}
    for o in able:
        if o.id in loose and site.config.drop:
            yield dropped(o, placing.carried(o, scene), here.target)


def _smaller(site: Site, scene: Scene, here: View, o: Furnishing) -> Iterator[Change]:
    """Smaller assets in place of an object, looked for only where a box of that size would do."""
    for share in SHARES:
        for limit in limits(o, share):
            if not here.reaches(swapped(scene, {o.id: placing.scaled(o, limit.tolist(), site)})):
                continue
            found = candidate(site, scene, o, limit)
            if found is not None and here.reaches(swapped(scene, found)) and fits(site, scene, found):
                yield replaced(o, found, here.target)
