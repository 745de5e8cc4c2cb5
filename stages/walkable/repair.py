"""Connectivity: let a robot get from the entrance through every door to in front of all that opens.

For each thing it does not get to, the objects in the way are found; then, in this order, one of them is replaced by
a smaller one, nudged, given another place in its room, or the least important are left out. A repair counts only if
nothing else is lost by it.
"""

from collections.abc import Hashable, Iterator
from itertools import chain

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Step
from apartgen.stages.walkable import importance, placing
from apartgen.stages.walkable.blocking import View, blockers, missed, rooms, view
from apartgen.stages.walkable.changes import Change, Repair, applied, dropped, merged, nudged, replaced
from apartgen.stages.walkable.insist import making_room
from apartgen.stages.walkable.nudge import nudges
from apartgen.stages.walkable.places import places
from apartgen.stages.walkable.rearrange import rearranged
from apartgen.stages.walkable.site import Scene, Site, fits
from apartgen.stages.walkable.smaller import candidate, limits
from apartgen.stages.walkable.ways import Ways, after, ways

SHARES = (0.9, 0.8, 0.7, 0.6)
"""Sizes tried for a blocking object."""


def connect(site: Site, scene: Scene) -> tuple[Ways, list[Step]]:
    """Repair until all is reached that can be; returns the ways at last, and the steps.

    What a room does not do without is left out only when nothing else is left to try.
    """
    steps: list[Step] = []
    now, failed = ways(site, scene), set[Hashable]()
    if not now.missed:
        return now, steps
    shut = set(missed(site, ()))
    while True:
        for essential in (False, True):
            now, taken = _tried(site, now, shut, essential, failed)
            steps += taken
        if not steps or set(missed(site, now.scene)) <= now.missed:
            return now, steps
        now = ways(site, now.scene)


def _tried(
    site: Site, now: Ways, shut: set[str], essential: bool, failed: set[Hashable]
) -> tuple[Ways, list[Step]]:
    """Repair all that can be.

    What not even an empty home lets the robot get to (`shut`), furniture can't help; what `failed` is not tried again
    while nothing about it changes.
    """
    steps: list[Step] = []
    given_up: set[str] = set()
    while todo := [name for name in _ordered(site, now) if name not in given_up
                   and name not in shut and not rooms(site, now.scene, name) <= shut]:
        target = _nearest(site, now, todo)
        repair, left = _repaired(site, now, target, essential, failed)
        if left is None:
            given_up.add(target)
            continue
        scene = now.scene
        for change in repair:
            scene, step = applied(scene, change)
            steps.append(step)
        # What could not be got to before may be possible now.
        now, given_up = left, set()
    return now, steps


def _ordered(site: Site, now: Ways) -> Iterator[str]:
    """What is missed, doors first, then rooms, then objects."""
    plan = site.world.plan
    every = chain((o.id for o in plan.openings), (room.id for room in plan.rooms), (o.id for o in now.scene))
    return (name for name in every if name in now.missed)


def _nearest(site: Site, now: Ways, todo: list[str]) -> str:
    """The first of what is not reached in a room that is; what lies beyond may come with it."""
    if len(todo) == 1:
        return todo[0]
    entered = {site.world.plan.rooms[i].id for i in np.unique(site.world.rooms[now.got]).tolist() if i >= 0}
    return next((target for target in todo if not entered.isdisjoint(rooms(site, now.scene, target))), todo[0])


def _repaired(
    site: Site, now: Ways, target: str, essential: bool, failed: set[Hashable]
) -> tuple[Repair, Ways | None]:
    """The first changes that let the robot get to `target` and to all it got to before, and the ways then.

    Where several objects block together and no single change helps, the least important of them goes, as a step on
    the way. With `essential`, what must stay may become another kind, and what matters less makes room for it.
    """
    scene, here = now.scene, view(site, now.scene, target)
    question = here.key
    if (question, essential) in failed:
        return (), None
    single, joint = blockers(site, scene, here)
    loose = importance.droppable(site, scene, 2 if essential else 1) if site.config.drop else []
    able = [*single, *(o for o in scene if o.id == target)]
    gone = [(dropped(o, scene, target),) for o in loose]
    # What did not help without the last resorts does not help now.
    kept = () if (question, False) in failed else _changes(site, scene, here, able)
    whole = chain(((change,) for change in kept), making_room(site, now, here, able) if essential else ())
    steps = (repair for repair in gone if repair[0].object in joint and not single)
    final = (repair for repair in gone if repair[0].object in able)
    anew = rearranged(site, now, here) if essential else ()
    for repairs, reaches in ((whole, True), (steps, False), (final, True), (anew, True)):
        for repair in repairs:
            left = after(site, now, merged(repair))
            if left.missed < now.missed or (not reaches and left.missed == now.missed):
                return repair, left
    failed.add((question, essential))
    return (), None


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
        for limit in limits(o, share, site.least(o)):
            if not here.reaches({o.id: placing.scaled(o, limit.tolist(), site)}):
                continue
            found = candidate(site, scene, o, limit)
            if found is not None and here.reaches(found) and fits(site, scene, found):
                yield replaced(o, found, here.target)
