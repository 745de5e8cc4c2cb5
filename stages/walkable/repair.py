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
from stages.walkable.blocking import View, blockers, missed, rooms, view
from stages.walkable.changes import Change, Repair, applied, dropped, merged, nudged, replaced
from stages.walkable.insist import making_room
from stages.walkable.nudge import nudges
from stages.walkable.places import places
from stages.walkable.site import Scene, Site, fits, swapped
from stages.walkable.smaller import candidate, limits

SHARES = (0.9, 0.8, 0.7, 0.6)
"""Sizes tried for a blocking object."""


def connect(site: Site, scene: Scene) -> tuple[Scene, list[Step], list[str]]:
    """Repair until all is reached that can be; returns the scene, the steps, and the ids still not reached.

    What a room does not do without is left out only when nothing else is left to try.
    """
    steps: list[Step] = []
    out, shut = missed(site, scene), set(missed(site, ()))
    for essential in (False, True):
        # What not even an empty home lets the robot get to, furniture can't help.
        given_up = [target for target in out if target in shut or rooms(site, scene, target) <= shut]
        hopeless = list(given_up)
        while todo := [target for target in out if target not in given_up]:
            target = _nearest(site, scene, todo)
            repair, left = _repaired(site, scene, target, set(out), essential)
            if not repair:
                given_up.append(target)
                continue
            for change in repair:
                scene, step = applied(scene, change)
                steps.append(step)
            # What could not be got to before may be possible now.
            out, given_up = left, list(hopeless)
    return scene, steps, out


def _nearest(site: Site, scene: Scene, todo: list[str]) -> str:
    """The first of what is not reached in a room that is; what lies beyond may come with it."""
    if len(todo) == 1:
        return todo[0]
    got = reach.survey(site.world, scene, site.config.reach, only=()).cells
    entered = {site.world.plan.rooms[i].id for i in np.unique(site.world.rooms[got]).tolist() if i >= 0}
    return next((target for target in todo if not entered.isdisjoint(rooms(site, scene, target))), todo[0])


def _repaired(
    site: Site, scene: Scene, target: str, out: set[str], essential: bool
) -> tuple[Repair, list[str]]:
    """The first changes that let the robot get to `target` and to all it got to before, and what is missed then.

    Where several objects block together and no single change helps, the least important of them goes, as a step on
    the way. With `essential`, what must stay may become another kind, and what matters less makes room for it.
    """
    here = view(site, scene, target)
    single, joint = blockers(site, scene, here)
    loose = importance.droppable(site, scene, 2 if essential else 1) if site.config.drop else []
    able = [*single, *(o for o in scene if o.id == target)]
    gone = [(dropped(o, placing.carried(o, scene), target),) for o in loose]
    whole = chain(((change,) for change in _changes(site, scene, here, able)),
                  making_room(site, scene, here, able, out) if essential else ())
    steps = (repair for repair in gone if repair[0].object in joint and not single)
    final = (repair for repair in gone if repair[0].object in able)
    for repairs, reaches in ((whole, True), (steps, False), (final, True)):
        for repair in repairs:
            left = missed(site, swapped(scene, merged(repair)))
            if set(left) < out or (not reaches and set(left) == out):
                return repair, left
    return (), []


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
