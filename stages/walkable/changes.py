"""Changes to a scene and how they are recorded."""

from typing import Literal, NamedTuple

from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Placement, Shift, Step
from apartgen.stages.things.carrying import carried
from apartgen.stages.walkable.site import Changes, Scene, swapped

Action = Literal["replace", "nudge", "drop"]


class Change(NamedTuple):
    """What is done to `object` and why; `to` has every object that changes with it, None where one goes."""

    action: Action
    object: Furnishing
    to: Changes
    reason: str


Repair = tuple[Change, ...]
"""Changes that only make sense together, in order."""


def merged(repair: Repair) -> Changes:
    """All that several changes do."""
    return {name: new for change in repair for name, new in change.to.items()}


def replaced(o: Furnishing, to: Changes, reason: str) -> Change:
    """Another asset for an object, what it carries included."""
    return Change("replace", o, to, reason)


def nudged(o: Furnishing, to: Changes, reason: str) -> Change:
    """Another place for an object and its company."""
    return Change("nudge", o, to, reason)


def dropped(o: Furnishing, scene: Scene, reason: str) -> Change:
    """An object left out, and what stands on it."""
    return Change("drop", o, {p.id: None for p in (o, *carried(o, scene))}, reason)


def placement(o: Furnishing) -> Placement:
    """Where an object stands and what it is, for the record."""
    return Placement(center=o.center, size=o.size, yaw=o.yaw, asset=o.asset)


def applied(scene: Scene, change: Change) -> tuple[Scene, Step]:
    """The scene after a change, and the record of it."""
    along = [_shift(o, change.to[o.id]) for o in scene if o.id in change.to and o.id != change.object.id]
    own = _shift(change.object, change.to[change.object.id])
    step = Step(action=change.action, object=own.object, reason=change.reason, before=own.before, after=own.after,
                along=along)
    return swapped(scene, change.to), step


def _shift(old: Furnishing, new: Furnishing | None) -> Shift:
    return Shift(object=old.id, before=placement(old), after=placement(new) if new else None)
