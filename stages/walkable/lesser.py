"""Where nothing else meets the target: other kinds for the same use, as a shower for a bath."""

from collections.abc import Collection

from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Step
from apartgen.stages.space import footprints
from apartgen.stages.walkable.changes import applied, replaced
from apartgen.stages.walkable.kinds import stand_ins
from apartgen.stages.walkable.optimize import EPSILON, area_ratio
from apartgen.stages.walkable.site import Changes, Scene, Site, fits
from apartgen.stages.walkable.smaller import GAIN
from apartgen.stages.walkable.ways import Ways, after


def lesser_kinds(
    site: Site, scene: Scene, rooms: Collection[str], now: Ways | None
) -> tuple[Scene, list[Step], Ways | None]:
    """Smaller things of other kinds for the largest objects of some rooms, until the target is met or there are none.

    What the prompt asked for keeps its kind, and with `now` the robot gets to no less than it does.
    """
    steps: list[Step] = []
    while area_ratio(site, scene, rooms) < site.target(rooms) - EPSILON:
        found = _first(site, scene, rooms, now)
        if found is None:
            break
        o, to, now = found
        scene, step = applied(scene, replaced(o, to, "ratio"))
        steps.append(step)
    return scene, steps, now


def _first(
    site: Site, scene: Scene, rooms: Collection[str], now: Ways | None
) -> tuple[Furnishing, Changes, Ways | None] | None:
    own = [o for o in scene if o.room in rooms and footprints.is_obstacle(o)]
    for o in sorted(own, key=lambda o: (-footprints.area(o), o.id)):
        for to in stand_ins(site, scene, o):
            new = to[o.id]
            if new is None or footprints.area(new) > GAIN * footprints.area(o) or not fits(site, scene, to):
                continue
            then = None if now is None else after(site, now, to)
            if then is None or now is None or then.missed <= now.missed:
                return o, to, then
    return None
