"""Opening: let every part of furniture and every room door move through its whole range, by true geometry.

For each thing that does not, in this order: what it meets, or it itself, is nudged; it, or what it meets, gets another
design that opens otherwise, or a smaller one; one of the two gets another place in its room; the less important one is
left out. A repair counts only if nothing else is lost by it. A seat that stands in its table is drawn back, or stays.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Step
from apartgen.stages.space import boxes
from apartgen.stages.things import categories
from apartgen.stages.things.carrying import carried
from apartgen.stages.walkable import importance, placing
from apartgen.stages.walkable.blocking import missed
from apartgen.stages.walkable.changes import Change, applied, dropped, nudged, replaced
from apartgen.stages.walkable.designs import redesigned
from apartgen.stages.walkable.nudge import nudges
from apartgen.stages.walkable.optimize import EPSILON, area_ratio
from apartgen.stages.walkable.parts import PLACE, Check, Fault, stuck_doors
from apartgen.stages.walkable.places import places
from apartgen.stages.walkable.site import Changes, Scene, Site, fits, swapped
from apartgen.stages.walkable.smaller import candidate, limits
from apartgen.stages.walkable.ways import Ways, after, ways

SLIGHT = (0.003, 0.006, 0.012, 0.025)
"""Shifts in any direction tried first, even away from a wall, m."""
UP = (0.1, -0.1, 0.05, -0.05, 0.2, -0.2, 0.3, -0.3)
"""Shifts in height of what hangs on a wall, m."""
BACK = (0.35, 0.4, 0.45, 0.5, 0.55)
"""How far a seat is drawn back where less does not do, m."""
OUT = (0.01, 0.03, 0.06, 0.1, 0.15, 0.2, 0.25, 0.3)
"""How far a seat is drawn out of what it stands in, m."""
ASIDE = 8
"""How many of the shortest shifts it is tried with otherwise."""
TRIMMED = (0.004, 0.008, 0.016)
"""By how much sides get shorter of what stands wedged in, m."""
SHARES = (0.95, 0.9, 0.8, 0.7)
"""Sizes tried for what is met."""


@dataclass
class _State:
    """The scene so far, what is blocked in it, and, where that counts, the ways in it and what may stay unreached."""

    scene: Scene
    faults: set[Fault]
    ways: Ways | None
    out: frozenset[str]


def unblock(
    site: Site, scene: Scene, check: Check, now: Ways | None = None, exact: bool = False
) -> tuple[Scene, list[Step], list[Fault]]:
    """Repair until all opens that can; returns the scene, the steps, and what is still blocked.

    Nothing may become unreached that is not in `now`, the ways in that scene; with `exact`, all is looked at anew after
    every change.

    Room doors that meet walls or one another are named, too; no furniture can help them.
    """
    faults, fixed = check.blocked(scene), stuck_doors(check.building)
    if not faults:
        return scene, [], sorted(fixed)
    state = _State(scene, faults, now, now.missed if now else frozenset())
    steps: list[Step] = []
    given_up: set[Fault] = set()
    while todo := sorted(state.faults - given_up):
        change = _repaired(site, check, state, todo[0], exact)
        if change is None:
            given_up.add(todo[0])
            continue
        state.scene, step = applied(state.scene, change)
        steps.append(step)
        given_up = {other for other in given_up if other.part == PLACE}
    if steps and state.ways and not exact and not set(missed(site, state.scene)) <= state.out:
        return unblock(site, scene, check, now, exact=True)
    return state.scene, steps, sorted(f for f in state.faults | fixed if f.part != PLACE)


def _repaired(site: Site, check: Check, state: _State, fault: Fault, exact: bool) -> Change | None:
    """The first change that frees the pair and breaks nothing; the state's faults follow it."""
    known = {o.id: o for o in state.scene}
    owner, by = known.get(fault.owner), known.get(fault.by)
    pair = {f for f in state.faults if (f.owner, f.by) == (fault.owner, fault.by)}
    for change in _changes(site, state.scene, fault, owner, by):
        both = [o for o in (change.to.get(o.id, o) for o in (owner, by) if o) if o]
        if check.still(pair, both) or (change.action != "drop" and not fits(site, state.scene, change.to)):
            continue
        left = _left(check, state, change)
        if not left & pair and left <= state.faults and _keeps_target(site, state, change):
            walked = _walked(site, state, change, exact)
            if walked is None or walked.missed <= state.out:
                state.faults, state.ways = left, walked
                return change
    return None


def _left(check: Check, state: _State, change: Change) -> set[Fault]:
    """What is blocked after a change."""
    rooms = {o.room for o in state.scene if o.id in change.to}
    near = [o for o in swapped(state.scene, change.to) if o.room in rooms]
    rest = {f for f in state.faults if f.owner not in change.to and f.by not in change.to}
    return rest | check.blocked(near, set(change.to))


def _walked(site: Site, state: _State, change: Change, exact: bool) -> Ways | None:
    """The ways after a change."""
    if state.ways is None:
        return None
    return ways(site, swapped(state.scene, change.to)) if exact else after(site, state.ways, change.to)


def _keeps_target(site: Site, state: _State, change: Change) -> bool:
    """Whether as much floor is free as before, or as is wanted."""
    scene = swapped(state.scene, change.to)
    rooms = list(site.floors) if site.config.scope == "apartment" else [change.object.room]
    ratio = area_ratio(site, scene, rooms)
    return ratio >= min(site.target(rooms), area_ratio(site, state.scene, rooms)) - EPSILON


def _changes(
    site: Site, scene: Scene, fault: Fault, owner: Furnishing | None, by: Furnishing | None
) -> Iterator[Change]:
    """Repairs in order, of what is met and of what is blocked."""
    both = [o for o in (by, owner) if o is not None]
    names = {o.id for o in both}

    def shifted(o: Furnishing, shifts: Iterable[Changes]) -> Iterator[Change]:
        # Companions that move along stay where they were to one another.
        return (nudged(o, to, fault.owner) for to in shifts if len(names) < 2 or names - set(to))

    if fault.part == PLACE:
        yield from shifted(both[-1], _drawn_back(scene, both[-1], both, OUT))
        yield from shifted(both[-1], islice(nudges(site, scene, both[-1]), ASIDE))
        return
    for o in both:
        yield from shifted(o, _slight(scene, o))
    for o in both:
        yield from (replaced(o, to, fault.owner) for to in _trimmed(site, scene, o))
    for o in both:
        yield from shifted(o, nudges(site, scene, o))
        yield from shifted(o, _raised(site, scene, o))
    for o in both[::-1]:
        yield from (replaced(o, to, fault.owner) for to in redesigned(site, scene, o))
    for o in both:
        yield from (replaced(o, to, fault.owner) for to in _smaller(site, scene, o))
    for o in both:
        yield from shifted(o, _drawn_back(scene, o, both, BACK))
        yield from shifted(o, places(site, scene, o))
    if site.config.drop:
        loose = importance.sparable(both, scene, site)
        yield from (dropped(o, scene, fault.owner) for o in loose)


def _slight(scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """Shifts that nobody sees, which part what stands pressed together."""
    axes = boxes.axes(boxes.of([o]))[0]
    for length in SLIGHT:
        for way in (axes[1], -axes[1], axes[0], -axes[0]):
            yield _shifted(scene, o, [*(length * way), 0.0])


def _raised(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """What hangs on a wall, higher or lower."""
    if o.category not in categories.TABLE or categories.TABLE[o.category].place != "wall":
        return
    for up in UP:
        low, high = o.center[2] - o.size[2] / 2 + up, o.center[2] + o.size[2] / 2 + up
        if low >= 0 and high <= site.world.plan.height:
            yield _shifted(scene, o, [0.0, 0.0, up])


def _drawn_back(scene: Scene, o: Furnishing, both: list[Furnishing], by: Iterable[float]) -> Iterator[Changes]:
    """A seat further from its table."""
    table = next((p for p in both if p is not o and categories.tucks(o.category, p.category)), None)
    if table is None or o.category not in categories.SEATS:
        return
    at = boxes.local([o.center[:2]], boxes.of([table]))[0, 0]
    side = int(np.argmax(np.abs(at) - np.asarray(table.size[:2]) / 2))
    way = boxes.axes(boxes.of([table]))[0, side] * np.sign(at[side])
    for back in by:
        yield _shifted(scene, o, [*(back * way), 0.0])


def _shifted(scene: Scene, o: Furnishing, by: list[float]) -> Changes:
    return {p.id: placing.moved(p, by) for p in (o, *carried(o, scene))}


def _trimmed(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    """The object a little narrower or shallower, which nobody sees."""
    for by in TRIMMED:
        for sides in ((0.0, by, 0.0), (by, 0.0, 0.0)):
            to = candidate(site, scene, o, np.asarray(o.size) - sides, gain=1.0)
            if to is not None:
                yield to


def _smaller(site: Site, scene: Scene, o: Furnishing) -> Iterator[Changes]:
    for share in SHARES:
        for limit in limits(o, share, site.least(o)):
            to = candidate(site, scene, o, limit)
            if to is not None:
                yield to
