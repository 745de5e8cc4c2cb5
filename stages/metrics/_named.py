"""Figures that rooms have by name, over two sets: a room of which a name is not told counts as 0."""

from collections.abc import Callable, Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._sets import ALL, types
from apartgen.stages.metrics._table import averaged

Told = dict[tuple[str, str], float]
"""Figures of one room by (name, version)."""


def compared(
    told: Callable[[Layout, str], Told], unit: str, homes: Sequence[Layout], real: Sequence[Layout]
) -> list[Value]:
    """Means over the furnished rooms of each set, in all and by type, the greatest first; the version joins the name.

    `told` gives the figures of a room of a home by its id.
    """
    sides = {"generated": _rooms(told, homes), "real": _rooms(told, real)}
    values = []
    for kind in (ALL, *types(real)):
        wanted = set(types(real)) if kind == ALL else {kind}
        found = {version: [figures for type, figures in rooms if type in wanted] for version, rooms in sides.items()}
        names = {name for rooms in found.values() for figures in rooms for name in figures}
        most = {name: max(_mean(name, rooms) for rooms in found.values()) for name in names}
        for name, figure in sorted(names, key=lambda name: (-most[name], name)):
            for version, rooms in found.items():
                pairs = [(figures.get((name, figure), 0.0), 1.0) for figures in rooms]
                value = Value(name=f"{name}/{figure}", value=None, unit=unit, version=version, of=kind, n=len(pairs))
                values.append(averaged(value, pairs))
    return values


def _rooms(told: Callable[[Layout, str], Told], homes: Sequence[Layout]) -> list[tuple[str, Told]]:
    return [(room.type, told(home, room.id)) for home in homes for room in home.rooms
            if any(o.room == room.id for o in home.objects)]


def _mean(name: tuple[str, str], rooms: Sequence[Told]) -> float:
    return sum(figures.get(name, 0.0) for figures in rooms) / max(1, len(rooms))
