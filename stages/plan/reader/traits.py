"""What a phrase says of its rooms, laid on them."""

from apartgen.stages.plan.reader.entity import Entity
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def lay(phrase: RoomPhrase, rooms: list[Entity]) -> None:
    """Areas, traits and furniture of a phrase onto its rooms."""
    anew = len(rooms) == 1 and phrase.quantifier == Det.THE  # "the kitchen is 9 m². … The kitchen should be 12 m²."
    for k, entity in enumerate(rooms):
        if phrase.areas and (entity.area is None or anew):
            entity.area = phrase.areas[min(k, len(phrase.areas) - 1)]
        entity.share = entity.share if phrase.share is None else phrase.share / (len(rooms) if phrase.together else 1)
        if phrase.together and phrase.areas:
            entity.area = phrase.areas[0] / len(rooms)
        entity.factor *= phrase.factor
        entity.exact = entity.exact or phrase.exact
        entity.labels |= phrase.labels - {Trait.SIZED, Trait.MAYBE_ENSUITE, Trait.OWN, Trait.HALLS}
        entity.object_count = phrase.object_count if phrase.object_count is not None else entity.object_count
        if len(rooms) == 1:  # "each bedroom has a wardrobe. The main bedroom has two wardrobes."
            anew_here = entity.alike & {category for category, _ in phrase.objects}
            entity.objects = [thing for thing in entity.objects if thing[0] not in anew_here]
        else:
            entity.alike |= {category for category, _ in phrase.objects}
        entity.objects += phrase.objects
