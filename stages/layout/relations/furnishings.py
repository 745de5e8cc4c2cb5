"""What a room's contents get besides what the model draws: a nightstand for everyone in a bed, a desk for who sleeps
alone, a lamp in every bedroom."""

from collections import Counter
from collections.abc import Mapping, Sequence

from apartgen.stages.use import kinds

STAND, DESK, SEAT = "nightstand", "desk", "office_chair"
STUDY = 8.0
"""In a bedroom of one of so much floor there is a desk, m²."""
LAMP, LAMPS = "table_lamp", frozenset({"table_lamp", "wall_lamp", "floor_lamp"})
"""What one reads by in bed."""


def completed(names: Sequence[str], asked: Mapping[str, int], bedroom: bool, area: float) -> list[str]:
    """Contents with a nightstand for each of two who share a bed and for who has one alone, and a desk with its chair
    in a bedroom of one, and a lamp where one sleeps, if their number was not `asked` for."""
    count = Counter(map(kinds.basic, names))
    alone = count["single_bed"] == 1 and count["double_bed"] + count["bunk_bed"] == 0
    stands = 2 * count["double_bed"] + alone - sum(count[name] for name in kinds.BEDSIDE)
    more = [STAND] * max(0, stands) if STAND not in asked else []
    if bedroom and alone and area >= STUDY and not any(count[name] for name in kinds.DESKS) and DESK not in asked:
        more += [DESK] if SEAT in asked or any(count[name] for name in kinds.CHAIRS) else [DESK, SEAT]
    if bedroom and LAMPS.isdisjoint(count) and LAMPS.isdisjoint(asked):
        more.append(LAMP)
    return [*names, *more]
