"""Articles that are part of a preposition: `vom Elternschlafzimmer`, `neben der Küche`, `au salon`, `del baño`."""

from apartgen.stages.plan.reader.mention import Item
from apartgen.stages.plan.reader.vocabulary import Det

DEFINITE = frozenset("vom zum zur am im beim ans ins dem der den du au aux del al".split())


def definite(items: list[Item]) -> list[Item]:
    """The items with the bedrooms behind such prepositions, of which there are several, as ones that are known."""
    for before, item in zip(items, items[1:], strict=False):
        room = item.room
        if room is None or room.type != "bedroom" or room.quantifier != Det.BARE or room.count is not None:
            continue
        if before.kind in ("link", "front", "beside") and before.text.rpartition(" ")[2] in DEFINITE:
            room.quantifier = Det.THE
    return items
