"""Connectivity: let a robot get from the entrance through every door to in front of all that opens.

For each thing it does not get to, the objects in the way are found; then, in this order, one of them is replaced by
a smaller one, nudged, given another place in its room, or the least important are left out. A repair counts only if
nothing else is lost by it.
"""

from collections.abc import Iterator
from itertools import chain

import numpy as np

from schemas.retrieve import Furnishing
from schemas.walkable import Step
from stages import reach
from stages.walkable import importance, placing
from stages.walkable.blocking import View, blockers, rooms, view
from stages.walkable.changes import Change, applied, dropped, nudged, replaced
from stages.walkable.nudge import nudges
from stages.walkable.places import places
from stages.walkable.site import Changes, Scene, Site, fits, swapped
from stages.walkable.smaller import candidate, limits

SHARES = (0.9, 0.8, 0.7, 0.6)
"""Sizes tried for a blocking object."""


def connect(site: Site, scene: Scene) -> tuple[Scene, list[Step], list[str]]:
    """Repair until all is reached that can be; returns the scene, the steps, and the ids still not reached.

    What a room does not do without is left out only when nothing else is left to try.
    """
    steps: list[Step] = []
    out = missed(site, scene)
    for essential in (False, True) if site.config.drop else (False,):
        given_up: list[str] = []
        while todo := [target for target in out if target not in given_up]:
            target = _nearest(site, scene, todo)
            change, left = _repaired(site, scene, target, set(out), essential)
            if change is None:
                given_up.append(target)
                continue
            scene, step = applied(scene, change)
            steps.append(step)
            # What could not be got to before may be possible now.
            out, given_up = left, []
    return scene, steps, out


def _nearest(site: Site, scene: Scene, todo: list[str]) -> str:
    """The first of what is not reached in a room that is; what lies beyond may come with it."""
    if len(todo) == 1:
        return todo[0]
    got = reach.survey(site.world, scene, site.config.reach, only=()).cells
    entered = {site.world.plan.rooms[i].id for i in np.unique(site.world.rooms[got]).tolist() if i >= 0}
    return next((target for target in todo if not entered.isdisjoint(rooms(site, scene, target))), todo[0])


def missed(site: Site, scene: Scene) -> list[str]:
    """Ids of the doors, rooms and articulated objects that the robot does not get to."""
    return reach.survey(site.world, scene, site.config.reach).missed


def _repaired(
    site: Site, scene: Scene, target: str, out: set[str], essential: bool
) -> tuple[Change | None, list[str]]:
    """The first change that lets the robot get to `target` and to all it got to before, and what is missed then.

    Where several objects block together and no single change helps, the least important of them goes, as a step on
    the way; so does what matters less than a thing that could then go elsewhere.
    """
    here = view(site, scene, target)
    single, joint = blockers(scene, here)
    loose = importance.droppable(scene, site.program, essential) if site.config.drop else []
    able = [*single, *(o for o in scene if o.id == target)]
    gone = [dropped(o, placing.carried(o, scene), target) for o in loose]
    final = [change for change in gone if change.object in able]
    first = chain(_making_room(site, scene, here, able, out) if essential else (),
                  (change for change in gone if change.object in joint and not single))
    for changes, whole in ((_changes(site, scene, here, able), True), (first, False), (final, True)):
        for change in changes:
            left = missed(site, swapped(scene, change.to))
            if set(left) < out or (not whole and set(left) == out):
                return change, left
    return None, []


def _making_room(
    site: Site, scene: Scene, here: View, able: list[Furnishing], out: set[str]
) -> Iterator[Change]:
    """What matters less, and has to go for a thing that must stay to have another place; the first of it."""
    loose = [o for o in importance.droppable(scene, site.program) if o.room in here.rooms and o not in able]

    def finds_place(o: Furnishing, without: list[Furnishing]) -> bool:
        gone: Changes = {name: None for less in without for name in dropped(less, placing.carried(less, scene), "").to}
        rest = swapped(scene, gone)
        return any(here.reaches(gone | to) and fits(site, rest, to) and set(missed(site, swapped(rest, to))) < out
                   for to in places(site, rest, o))

    for o in able:
        if importance.rank(o, scene) < 2 or not finds_place(o, loose):
            continue
        least = loose
        for less in reversed(loose):
            rest = [p for p in least if p is not less]
            if finds_place(o, rest):
                least = rest
        if least:
            yield dropped(least[0], placing.carried(least[0], scene), here.target)


def _changes(site: Site, scene: Scene, here: View, able: list[Furnishing]) -> Iterator[Change]:
    """Repairs that reach the target and leave nothing out, in order; what can't be used may change itself, too."""
    for o in able:
        yield from _smaller(site, scene, here, o)
    for other in (nudges, places):
        for o in able:
            for moved in other(site, scene, o):
                if here.reaches(moved) and fits(site, scene, moved):
                    yield nudged(o, moved, here.target)


def _smaller(site: Site, scene: Scene, here: View, o: Furnishing) -> Iterator[Change]:
    """Smaller assets in place of an object, looked for only where a box of that size would do."""
    for share in SHARES:
        for limit in limits(o, share):
            if not here.reaches({o.id: placing.scaled(o, limit.tolist(), site)}):
                continue
            found = candidate(site, scene, o, limit)
            if found is not None and here.reaches(found) and fits(site, scene, found):
                yield replaced(o, found, here.target)
