"""Storing: cabinets with their backs at walls and floor before their doors."""

from collections.abc import Iterator

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.kinds import CASES, CLOTHES, DOUBLE, HANGING, MOVED
from apartgen.stages.use.room import Furnished

OFF = 0.15
"""A back stands no further off its wall, m."""
DRESS, OPEN = 0.7, 0.45
"""Floor before wardrobes (HUD: .91 m wanted), and before other cabinets, m."""
HUNG = 0.6
"""Length of wardrobe for each who sleeps in a bedroom, m (a metre is usual)."""


def faults(room: Furnished) -> Iterator[Fault]:
    """Of wardrobes, chests, shelves and cabinets."""
    for i in room.which(CASES):
        clothes = room.names[i] in CLOTHES
        if room.back[i] >= OFF:
            yield Fault("wardrobe off the wall" if clothes else "cabinet off the wall", room.ids(i))
        depth, least = (DRESS, 0.75) if clothes else (OPEN, 0.6)
        if room.front(i, depth, 0.05, MOVED) < least:
            yield Fault("no floor before the wardrobe" if clothes else "no floor before the cabinet", room.ids(i))
    hung = room.which(HANGING)
    if room.site.kind == "bedroom" and room.which(DOUBLE) and hung and sum(
            room.width[i] for i in hung) < 2 * HUNG - 0.05:
        yield Fault("little wardrobe for two", room.ids(*hung))
