"""N_objects, N_articulated, N_categories: how much stands in each room."""

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._shares import objects
from apartgen.stages.space import sweeps

NEEDS = Layout


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Objects, articulated objects and different categories, by room and over the apartment."""
    things = objects(home)
    moving = sweeps.articulated(things)
    values = []
    for of in ["apartment", *(room.id for room in home.rooms)]:
        here = np.array([of in ("apartment", o.room) for o in things], bool)
        kinds = {o.category for o, inside in zip(things, here, strict=True) if inside}
        counts = {"N_objects": here.sum(), "N_articulated": (here & moving).sum(), "N_categories": len(kinds)}
        values += [Value(name=name, value=float(count), unit="objects", of=of) for name, count in counts.items()]
    return values
