"""An independent judge of any apartment: certifies it, or names every fault with a witness.

It shares nothing with the stages but the artifacts' types and the facts of furniture categories: what the stages get
wrong, they can't teach it.
"""

from collections.abc import Iterator
from itertools import chain, islice

from apartgen.schemas import consistency
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import without_things
from apartgen.schemas.walkable import Walkable
from apartgen.stages.check import building, furniture, opening, robot
from apartgen.stages.check.fault import WHAT, Fault

__all__ = ["MOST", "WHAT", "Fault", "quick", "run"]
MOST = 1000
"""Faults and notes beyond so many are left out, but never the only one that refuses."""

CLEAR = 0.05
"""What is no further outside, m or m², a stage may still mend."""


def run(home: Plan, strict: bool = False) -> list[Fault]:
    """All faults of an apartment, and what is worth a note; it is certified when none of them refuses.

    Whether all opens and is reached is for the walkable stage to see to: where it was never run, that is noted only.
    With `strict` whatever is noted refuses. Small things are looked at only for whether their file hangs together.
    """
    every = iter(_inconsistent(home) or _all(without_things(home)))
    found = list(islice(every, MOST))
    if not any(fault.refuses for fault in found):
        found += islice((fault for fault in every if fault.refuses), 1)
    return [fault._replace(refuses=fault.refuses or strict) for fault in found]


def _all(home: Plan) -> Iterator[Fault]:
    site = building.site(home)
    yield from building.faults(home, site)
    if isinstance(home, Layout):
        yield from furniture.placed(home, site)
        yield from furniture.faults(home, site)
        for fault in chain(opening.faults(home, site), robot.faults(home, site)):
            yield fault._replace(refuses=isinstance(home, Walkable))


def quick(home: Plan) -> list[Fault]:
    """What refuses an apartment wherever it comes from: faults of its plan, and furniture that is of no size or clearly
    outside, so that stages may ask it of everything that they read.
    """
    if found := _inconsistent(home):
        return found
    home = without_things(home)
    site = building.site(home)
    placed = furniture.placed(home, site) if isinstance(home, Layout) else []
    clear = (fault for fault in placed if fault.code == "size" or (fault.value or 0.0) > CLEAR)
    return [fault for fault in islice(chain(building.faults(home, site), clear), MOST) if fault.refuses]


def _inconsistent(home: Plan) -> list[Fault]:
    """What leaves nothing else to be asked: ids, outlines, references, numbers beyond all measure."""
    return [Fault("inconsistent", (fault.where,), more=fault.what) for fault in consistency.faults(home)]
