"""Counts taken back by a smaller one: `I wanted three bedrooms, but two are enough`."""

from dataclasses import replace

from apartgen.stages.plan.reader.mention import Item, RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det


def sufficing(items: list[Item]) -> list[Item]:
    """The number that is enough in the place of the one counted before; where none was, nothing but a verb."""
    out: list[Item] = []
    for k, item in enumerate(items):
        if item.kind != "enough":
            out.append(item)
        elif (before := _too_many(out)) is not None:
            fewer = out.pop().room
            assert fewer is not None
            before.count, before.plural = fewer.count, (fewer.count or 1) > 1
            if out[-1].kind == "boundary":
                out.pop()
        elif _too_many([*out, *_behind(items, k)]) is not None:
            out.append(Item("anew", "anew", item.text))  # "jetzt reicht ein Bad"
        else:
            out.append(replace(item, kind="copula", value="p"))
    return out


def counts(room: RoomPhrase) -> bool:
    """Whether a phrase says no more than how many rooms there are."""
    return room.count is not None and room.quantifier == Det.BARE and not room.negated


def _behind(items: list[Item], k: int) -> list[Item]:
    """The room of `reicht ein Bad`, `basta con uno`."""
    return [i for i in items[k + 1 : k + 4] if i.kind not in ("with", "only", "stop")][:1]


def _too_many(out: list[Item]) -> RoomPhrase | None:
    """The rooms counted last of the type that the last phrase counts fewer of."""
    fewer = out[-1].room if out else None
    if fewer is None or not counts(fewer) or fewer.count is None or fewer.labels:
        return None
    if len(out) > 1 and out[-2].kind == "conjunction":
        return None  # "two bathrooms, and one bathroom is enough for the children"
    before = [i.room for i in out[:-1] if i.room is not None and fewer.type in ("", i.room.type)][-1:]
    counted = [r for r in before if (r.count or 1) > fewer.count and not r.negated and not r.labels]
    return counted[0] if counted else None
