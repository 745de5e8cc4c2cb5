"""Shares of things by room and over the whole apartment, as artifact values."""

from collections.abc import Sequence

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan
from apartgen.stages.space import footprints
from apartgen.stages.space.boxes import Mask
from apartgen.stages.things.carrying import told


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
