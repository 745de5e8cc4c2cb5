"""Which room `the smallest bedroom`, `the larger one`, `the big room` is, of several of its type."""

from apartgen.stages.plan.reader.entity import DISTINCT, Entity
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def rank(quantifier: Det, factor: float, several: bool = False) -> str:
    """What a size tells of a room that is known: `the big one` is the largest, whatever the degree of the word."""
    if not (quantifier in (Det.THE, Det.BOTH) or (quantifier == Det.EACH and several)) or factor == 1.0:
        return ""
    return "largest" if factor > 1 else "smallest"


def ranked(phrase: RoomPhrase, pool: list[Entity]) -> list[Entity]:
    """The room of `pool` that a size tells from the others; [] where none is meant or there is nothing to tell."""
    if not phrase.rank or len(pool) < 2:
        return []
    if phrase.plural or (phrase.count or 1) > 1:
        return _several(phrase, pool)
    told = [e for e in pool if e.rank == phrase.rank][:1]
    found = told or [_by_size(phrase.rank, [e for e in pool if not e.rank] or pool)]
    found[0].rank, found[0].picked = phrase.rank, True
    phrase.factor = 1.0 if told and told[0].factor != 1.0 else phrase.factor  # how small it is was said before
    return found


def _several(phrase: RoomPhrase, pool: list[Entity]) -> list[Entity]:
    """`the two smallest bedrooms`; `the smaller bedrooms` of three or more are all but one, if no others were told."""
    alike = [e for e in pool if (e.factor - 1) * (phrase.factor - 1) > 0]
    count = int(phrase.count or (2 if phrase.quantifier == Det.BOTH else len(alike) or len(pool) - 1))
    if count < 2 or not (phrase.count or alike or phrase.whole or phrase.quantifier == Det.BOTH):
        return []  # "the large bedrooms face south" may speak of all
    if len(alike) == count:
        found, phrase.factor = alike, 1.0  # how small they are was said before
    else:
        areas = {id(e): e.area for e in pool if e.area is not None}
        ordered = sorted(pool, key=lambda e: -areas[id(e)]) if len(areas) == len(pool) else pool
        found = ordered[:count] if phrase.rank == "largest" else ordered[-count:]
    for room in found:
        room.rank = room.rank or phrase.rank
    return found


def _by_size(which: str, free: list[Entity]) -> Entity:
    """By stated areas, else by what is usual: the main bedroom is the largest, rooms are told from large to small."""
    fitting = [e for e in free if (e.factor >= 1.0 if which == "largest" else e.factor <= 1.0)]
    free = fitting or free  # "one of them is tiny … the larger bedroom" is another one
    areas = [e.area for e in free if e.area is not None]
    if len(areas) == len(free) and len(set(areas)) > 1:
        most = max(areas) if which == "largest" else min(areas)
        return next(e for e in free if e.area == most)
    main = [e for e in free if Trait.MASTER in e.labels]
    if which == "largest":
        return (main or free)[0]
    plain = [e for e in free if not e.labels & set(DISTINCT) and e.area is None]
    return (plain or [e for e in free if e not in main] or free)[-1]


def index_of(ordinal: int) -> int:
    """Of `first`, `second`, `last` (-1) in a list."""
    return ordinal - 1 if ordinal > 0 else ordinal


def counted_off(rooms: list[Entity], ordinals: tuple[int, ...]) -> list[Entity]:
    """The first, the third of some rooms; a home that is full has not all of them."""
    return [rooms[k] for n in ordinals if (k := index_of(n)) < len(rooms)]


def sized_otherwise(phrase: RoomPhrase, rooms: list[Entity], total: int | None) -> bool:
    """Whether one is said to be large and the other small: `two small bedrooms and a big one`, where no total is."""
    new = phrase.quantifier in (Det.A, Det.BARE, Det.THE) and not phrase.ordinals
    one = len(rooms) == 1 or (total is None and phrase.quantifier == Det.A)
    return new and one and all((phrase.factor - 1) * (room.factor - 1) < 0 for room in rooms)


def rest_of(phrase: RoomPhrase, known: list[Entity]) -> list[Entity]:
    """Of rooms counted before, those that `two further bedrooms` are: as many as were not told apart yet."""
    free = [e for e in known if e.counted and not (e.picked or e.labels & set(DISTINCT) or e.owner)]
    told = any(e.counted and (e.picked or e.labels & set(DISTINCT)) for e in known)
    return free if told and phrase.count == len(free) else []


def other_than(phrase: RoomPhrase, pool: list[Entity], known: list[Entity]) -> bool:
    """Whether `the other` is said where but one bedroom was spoken of."""
    other = phrase.quantifier == Det.OTHER and phrase.count is None and phrase.text == "the other"
    return other and known == pool and len(pool) == 1 and phrase.type == "bedroom" and not pool[0].counted


def another_one(phrase: RoomPhrase, pool: list[Entity]) -> bool:
    """`she has the bigger bedroom, I have the one with the balcony`: not the one bedroom spoken of before."""
    single = len(pool) == 1 and pool[0].type == "bedroom"
    return single and phrase.text == "the one" and not phrase.among
