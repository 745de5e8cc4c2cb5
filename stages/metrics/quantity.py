"""Q_ratio: rooms that hold exactly as many objects as asked for (Eq. 10)."""

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program
from apartgen.stages.metrics._shares import objects, share

NEEDS = Layout


def measure(home: Plan, against: Plan | Program | None = None) -> list[Value]:
    """Versions: published = all objects of each room whose number was asked · categories = each wish for a category.

    None where the programme asks for no numbers.
    """
    program = home.program if against is None else against if isinstance(against, Program) else against.program
    things = objects(home)
    rooms = {room: sum(o.room == room for o in things) == n for room, n in sorted(program.counts.items())}
    wishes = [sum((o.room, o.category) == (wish.room, wish.category) for o in things) == wish.count
              for wish in program.objects]
    return [
        share("Q_ratio", "published", "apartment", np.array(list(rooms.values()), bool)),
        *(share("Q_ratio", "published", room, np.array([met])) for room, met in rooms.items()),
        share("Q_ratio", "categories", "apartment", np.array(wishes, bool)),
    ]
