"""Bathrooms of bedrooms, said as what the bedrooms are: `two ensuite bedrooms`."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, rooms_of
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def merge_ensuites(items: list[Item]) -> list[Item]:
    """`two ensuite bedrooms`, `master bedroom en suite`, `one of them ensuite`."""
    out: list[Item] = []
    for item in items:
        near = [i for i in out if i.kind not in ("copula", "relative", "pronoun") and i.value != "including"]
        last = near[-1].room if near else None
        phrase = item.room
        if (
            phrase is not None
            and _is_ensuite(phrase)
            and phrase.quantifier in (Det.ALL, Det.EACH, Det.BOTH)
            and (beds := _beds(near))
        ):
            phrase.quantifier = Det.EACH
            beds.owned.append(phrase)
        elif last is None or phrase is None:
            out.append(item)
        elif _is_ensuite(last) and phrase.type == "bedroom" and phrase.count is None and not phrase.quantifier:
            last.labels -= {Trait.OWN}
            phrase.count, phrase.quantifier, phrase.areas = last.count, last.quantifier, phrase.areas or last.areas
            phrase.owned.append(RoomPhrase("bathroom", {Trait.ENSUITE}, text=last.text, quantifier=Det.EACH))
            out[out.index(near[-1])] = item
        elif (
            _is_ensuite(phrase)
            and phrase.count is None
            and last.type == "bedroom"
            and phrase.quantifier in (Det.BARE, Det.OWN)
        ):
            last.owned.append(phrase)
        elif _is_ensuite(phrase) and last.quantifier == Det.NONE:
            phrase.negated = True
            out[-1] = item
        elif _is_ensuite(phrase) and last.type == "" and phrase.quantifier == Det.BARE:
            last.labels.add(Trait.MAYBE_ENSUITE)
        elif (
            last.type == ""
            and phrase.count is None
            and phrase.labels & {Trait.HALF, Trait.MASTER, Trait.GUEST, Trait.KIDS, Trait.SMALL, Trait.SHOWER}
            and near[-1] is out[-1]
        ):
            last.labels |= phrase.labels
        elif _is_ensuite(phrase) and last.type == "bathroom" and phrase.quantifier == Det.BARE and phrase.count is None:
            last.labels.add(Trait.ENSUITE)
        else:
            out.append(item)
    return out


def _beds(items: list[Item]) -> RoomPhrase | None:
    """The bedrooms of `three bedrooms, all ensuite`."""
    found = [r for r in rooms_of(items) if r.type == "bedroom"]
    return found[-1] if found else None


def _is_ensuite(phrase: RoomPhrase) -> bool:
    return phrase.type == "bathroom" and Trait.ENSUITE in phrase.labels
