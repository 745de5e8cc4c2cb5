"""Shares of things by room and over the whole apartment, as artifact values."""

from collections import Counter
from collections.abc import Sequence

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan
from apartgen.stages.space import footprints
from apartgen.stages.space.boxes import Mask
from apartgen.stages.things.carrying import told

CROWD = 1500
"""More things in a room than anybody keeps; how each stands to every other would take memory with their square."""


def crowded(things: Sequence[Box]) -> set[str]:
    """Rooms with more things than `CROWD`, of which it is not told how each stands to every other."""
    return {room for room, count in Counter(o.room for o in things).items() if count > CROWD}


def objects(home: Plan) -> list[Box]:
    """All objects of an artifact, what carries them said; none of a bare plan."""
    return told(home.objects, home.height) if isinstance(home, Layout) else []


def solid(home: Plan) -> list[Box]:
    """All objects but those that give way: rugs and curtains."""
    return [o for o in objects(home) if not footprints.gives_way(o)]


def share(name: str, version: str, of: str, hit: Mask) -> Value:
    """One share; None of nothing."""
    return Value(name=name, value=float(hit.mean()) if hit.size else None, unit="share", version=version, of=of,
                 n=int(hit.size))


def shares(home: Plan, name: str, version: str, hit: Mask, things: Sequence[Box]) -> list[Value]:
    """Share of `things` that are `hit` (n,), over the apartment and in each room that has any."""
    rooms = np.array([o.room for o in things], object)
    of_rooms = [share(name, version, room.id, hit[rooms == room.id]) for room in home.rooms if (rooms == room.id).any()]
    return [share(name, version, "apartment", hit), *of_rooms]
