"""What is still to come: no unit is put where sink, hob or fridge would find no place in the run any more."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from apartgen.stages.layout.relations import order, runs
from apartgen.stages.layout.relations.standing import BROKEN, Furniture
from apartgen.stages.layout.relations.tokens import Array, Shell
from apartgen.stages.things.categories import TABLE
from apartgen.stages.use.kinds import CLOSED

Placed = frozenset[tuple[str, float, float, float]]
"""Units by name, place and yaw."""


def needed(left: Sequence[str], there: Sequence[str]) -> list[str]:
    """Units of a run that are to come and that it cannot do without, one that cooks being enough, and what can lead
    round a corner to them."""
    units = [name for name in dict.fromkeys(left) if name in order.runs() and (not runs.spare(name) or name in CLOSED)]
    cooks = [name for name in units if TABLE[name].is_for("cook")]
    enough = cooks if any(TABLE[o].is_for("cook") for o in there) else cooks[:-1]
    some = [name for name in units if name not in enough]
    return some if set(some) - CLOSED else []


class Ahead:
    """What of a run is still to come: units of `rest`, beside what stands there now."""

    def __init__(self, there: Furniture, rest: Sequence[str], shell: Shell) -> None:
        self.there, self.rest, self.shell = there, list(rest), shell

    def leaves_room(self, name: str, box: Array) -> bool:
        """Whether the rest finds places in the run, one after another, when an object stands there, or finds none
        without it either."""
        if name not in order.runs() or not self.rest or _found(self.there.besides(name, box), self.rest, self.shell):
            return True
        return self._hopeless

    @cached_property
    def _hopeless(self) -> bool:
        begun = any(o in order.runs() for o in self.there.names)
        return begun and not _found(self.there, self.rest, self.shell)


def _found(there: Furniture, rest: list[str], shell: Shell, dead: set[Placed] | None = None,
           placed: Placed = frozenset()) -> bool:
    """Whether they do, in any order; each as wide as such units are at least as a rule. What has been `placed` without
    success is not tried again in another order."""
    if not set(rest) - CLOSED:
        return True
    dead = set() if dead is None else dead
    for name in rest:
        others = [o for o in rest if o is not name]
        places = runs.further(name, runs.usual(name)[None], there.names, there.boxes, shell)
        for place in places[there.prices(name, places) < BROKEN] if len(places) else places:
            now = placed | {(name, *np.round(place[:3], 2).tolist())}
            if now in dead:
                continue
            if _found(there.besides(name, np.asarray(place)), others, shell, dead, now):
                return True
            dead.add(now)
    return False
