"""Figures of single rooms over two sets, side by side: of generated rooms, and of real ones as their floor."""

from collections.abc import Callable, Sequence

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.stages.metrics._sets import ALL, types
from apartgen.stages.metrics._table import POOLED, averaged

Key = tuple[str, str, str]


def beside(measure: Callable[[Layout], list[Value]], homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
    """Means over all rooms of types that the real set has; a figure's version becomes part of its name.

    Versions: generated · real. Figures of whole apartments alone are left out: real sets are mostly of single rooms.
    """
    wanted = set(types(real))
    sides = {"generated": _by_figure(measure, homes, wanted), "real": _by_figure(measure, real, wanted)}
    names = dict.fromkeys([*sides["generated"], *sides["real"]])
    return [_value(key, version, side.get(key, [])) for key in names for version, side in sides.items()]


def _by_figure(
    measure: Callable[[Layout], list[Value]], homes: Sequence[Layout], wanted: set[str]
) -> dict[Key, list[tuple[float, float]]]:
    """(value, weight) of every room, by (name, version, unit)."""
    found: dict[Key, list[tuple[float, float]]] = {}
    for home in homes:
        inside = {room.id for room in home.rooms if room.type in wanted}
        for v in measure(home):
            if v.of in inside and v.value is not None:
                weight = float(v.n) if v.name in POOLED and v.n else 1.0
                found.setdefault((v.name, v.version, v.unit), []).append((v.value, weight))
    return found


def _value(key: Key, version: str, pairs: list[tuple[float, float]]) -> Value:
    name, variant, unit = key
    figure = Value(name=f"{name}/{variant}", value=None, unit=unit, version=version, of=ALL, n=len(pairs))
    return averaged(figure, pairs)
