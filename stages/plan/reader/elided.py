"""What a sentence leaves out or says beside the point, written out before relations are looked for."""

from dataclasses import replace

from apartgen.stages.plan.reader.allotted import (
    another_of_counted,
    for_each,
    for_the_others,
    is_one,
    none_ensuite,
    one_in_bedroom,
)
from apartgen.stages.plan.reader.asides import (
    bath_each,
    beside_a_thing,
    denied_beside,
    doors_counted,
    has_itself,
    heading,
    no_such_home,
    none_off,
    nor_this,
    of_no_room,
    of_which,
)
from apartgen.stages.plan.reader.clausal import (
    again_named,
    ahead,
    beside_it,
    compared,
    in_each,
    in_every,
    is_for,
    last,
    next_one,
    none_between,
    one_of_them,
    several_areas,
    then_listed,
)
from apartgen.stages.plan.reader.gapped import (
    another_alike,
    another_door,
    goes_into,
    has_too,
    holds,
    is_not_in,
    no_wall,
    one_of_counted,
    one_per,
    taken_back,
    whose_value,
)
from apartgen.stages.plan.reader.headed import last_two, related_first
from apartgen.stages.plan.reader.journeys import journeys
from apartgen.stages.plan.reader.mention import OPEN_TYPES, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.nowhere import in_several
from apartgen.stages.plan.reader.openings import denied_doors, not_open, open_to_each_other, opening, together_with
from apartgen.stages.plan.reader.passages import (
    between_the_two,
    entered_only,
    from_there,
    inside,
    no_door_at_all,
    only_behind,
    through_passage,
    to_each_other,
    which_is_the,
    you_go_in,
)
from apartgen.stages.plan.reader.persons import floating, sleeps_in, whose
from apartgen.stages.plan.reader.resumed import has_inside, it_has, off_it, same_area, set_off, there_is_in, which_has
from apartgen.stages.plan.reader.spoken import SPOKEN
from apartgen.stages.plan.reader.subjects import ARROWS
from apartgen.stages.plan.reader.unwanted import again_without, not_ensuite, not_needed, we_do_not_need
from apartgen.stages.plan.reader.vocabulary import Det, Trait

SAID = ("link", "side", "place", "compare")
"""Kinds with which begins what is said of a room."""
FLOATING = (Det.BOTH, Det.ALL, Det.EACH)


def written_out(items: list[Item]) -> list[Item]:
    """Each short form in the place of which a longer one of the same meaning stands."""
    out: list[Item] = []
    items = journeys(denied_doors(in_several(items)))
    for k, item in enumerate(items):
        if item.kind != "stop" and not any(rule(out, items, k) for rule in RULES):
            out.append(item)
    return out


def _arrow(out: list[Item], items: list[Item], k: int) -> bool:
    """`bedroom 1 -> double bed`."""
    fits = items[k].text in ARROWS and ahead(items, k)[0].kind == "object"
    out += [Item("with", "has", items[k].text)] * fits
    return fits


def _comma(out: list[Item], items: list[Item], k: int) -> bool:
    """Two commas are one."""
    return is_mark(items[k], ",") and is_mark(last(out), ",")


def _do_not(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bathrooms share a wall and the bedrooms do not`."""
    fits = items[k].value == "not" and last(out).room is not None and _ends(items, k)
    if not fits or (said := _said_before(out)) is None:
        return False
    at, verb = said
    out[at] = Item("mark", ".", ".")
    out += [items[k], *verb]
    return True


def _also(out: list[Item], items: list[Item], k: int) -> bool:
    """`a bathroom also accessible from the hall`."""
    return items[k].text == "also" and last(out).room is not None and ahead(items, k)[0].kind in SAID


def _that_again(out: list[Item], items: list[Item], k: int) -> bool:
    """`… that A is … and that B is …`."""
    fits = items[k].text == "that" and last(out).kind == "conjunction" and ahead(items, k)[0].room is not None
    if fits:
        out[-1] = Item("boundary", "while", out[-1].text)
    return fits


def _together(out: list[Item], items: list[Item], k: int) -> bool:
    """`kitchen and dining area together`."""
    fits = items[k].text == "together" and ahead(items, k)[0].kind not in ("area", "share", "with") and _lived(out)
    out += [Item("open", "", items[k].text)] * fits
    return fits


def _between_them(out: list[Item], items: list[Item], k: int) -> bool:
    """`and between them a bathroom`: the room, then the relation."""
    if k and items[k].room is not None and _leads_in(items, k - 1):
        out += [items[k], Item("link", "between", items[k - 1].text)]
        return True
    return _leads_in(items, k)


def _leads_in(items: list[Item], k: int) -> bool:
    room = ahead(items, k)[0].room
    new = room is not None and (room.quantifier == Det.A or (room.count == 1 and room.quantifier == Det.BARE))
    return items[k].text == "between them" and new


def _own_door(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bedroom has its own door to the bathroom`."""
    if k and items[k].kind == "link" and _door_of_own(items, k - 1):
        out.append(replace(items[k], form="s"))
        return True
    fits = _door_of_own(items, k)
    if fits and last(out).value == "has":
        out.pop()
    return fits


def _door_of_own(items: list[Item], k: int) -> bool:
    room = items[k].room
    return room is not None and room.text == "own" and ahead(items, k)[0].text.startswith("door")


def _one_from(out: list[Item], items: list[Item], k: int) -> bool:
    """`a door to the hall plus one to the bedroom`."""
    named = _rooms(out)
    if items[k].text not in ("one from", "one to") or last(out).value != "plus" or not named:
        return False
    theirs = named[-1] if items[k].text == "one from" else named[0]
    out[-1:] = [Item("mark", ".", "."), again_named(theirs), replace(items[k], text="reached from", form="")]
    return True


def _bed(out: list[Item], items: list[Item], k: int) -> bool:
    """The bed of `bed and desk in the main room`."""
    room = items[k].room
    if room is None or room.text not in ("bed", "beds") or not _among_things(items, k):
        return False
    out.append(Item("object", "double_bed", items[k].text, number=2 if room.plural else 1))
    return True


def _not_just(out: list[Item], items: list[Item], k: int) -> bool:
    """`not just a kitchenette`."""
    return items[k].kind == "only" and last(out).value == "not"


def _from_again(out: list[Item], items: list[Item], k: int) -> bool:
    """`from the hall and from the lounge`."""
    fits = items[k].kind == "front" and last(out).kind == "conjunction" and _again(out, items[k])
    if fits:
        out[-1] = Item("conjunction", "and", out[-1].text)  # "as well as from the lounge"
    return fits


def _both_from(out: list[Item], items: list[Item], k: int) -> bool:
    """`enter the kitchen both from the hall and …`."""
    room, (start, hub, _) = items[k].room, ahead(items, k)
    fits = room is not None and _floats(room) and start.kind == "front" and hub.room is not None
    out += [items[k]] if fits and is_mark(last(out), ",") else []
    return fits


def _they_from(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bathrooms, both from the corridor`."""
    room = last(out).room
    fits = items[k].kind == "front" and room is not None and _floats(room) and ahead(items, k)[0].room is not None
    out += [Item("link", "door", "reached from")] * fits
    return fits


def _neither(out: list[Item], items: list[Item], k: int) -> bool:
    """`two bathrooms, neither of them en suite`."""
    room = items[k].room
    if room is None or room.quantifier != Det.NONE or Trait.ENSUITE not in room.labels:
        return False
    room.negated, room.quantifier = True, Det.BARE
    out += [Item("negation", "no", items[k].text), items[k]]
    return True


def _not_another(out: list[Item], items: list[Item], k: int) -> bool:
    """`a separate kitchen, not a kitchenette`."""
    room = items[k].room
    if room is None or last(out).value != "not" or not _contrasted(out, room):
        return False
    del out[-2:]
    return True


RULES = (*SPOKEN, related_first, last_two, another_alike, beside_a_thing, _arrow, heading, no_such_home,
         _comma, which_has, it_has, there_is_in, off_it, set_off, same_area, another_door, goes_into, has_too, holds,
         whose_value, taken_back, one_of_counted, another_of_counted, one_in_bedroom, is_one, for_each, for_the_others,
         none_ensuite, entered_only, only_behind, from_there, inside, has_inside, through_passage, between_the_two,
         you_go_in, no_door_at_all, to_each_other, which_is_the, we_do_not_need, again_without, none_off, nor_this,
         denied_beside, doors_counted, of_no_room, of_which, bath_each, has_itself, in_every, in_each, _do_not, _also,
         _that_again, _together, _between_them, _own_door, _one_from, _bed, _not_just, _from_again, _both_from,
         _they_from, _neither, not_ensuite, _not_another, not_open, compared, next_one, then_listed, no_wall,
         none_between, beside_it, several_areas, is_for, one_of_them, opening, open_to_each_other, together_with,
         not_needed, is_not_in, one_per, whose, floating, sleeps_in)  # fmt: skip
"""In the order in which they are tried; each tells whether it has put the item at `k` into `out`, or left it out."""


def _again(out: list[Item], item: Item) -> bool:
    """Whether the preposition was said of the room before."""
    named = len(out) > 2 and out[-2].room is not None
    return named and (out[-3].text == item.text or (out[-3].text == "reached from" and item.text == "from"))


def _floats(room: RoomPhrase) -> bool:
    return room.type == "" and room.quantifier in FLOATING and room.count is None and not room.labels


def _contrasted(out: list[Item], room: RoomPhrase) -> bool:
    """Whether the room is what another of its type is not, behind a comma."""
    earlier = [i.room for i in out[:-2] if i.room is not None][-1:]
    lone = len(out) > 2 and is_mark(out[-2], ",") and room.quantifier in (Det.A, Det.BARE)
    return lone and bool(earlier) and earlier[0].type == room.type and not earlier[0].negated


def _ends(items: list[Item], k: int) -> bool:
    return k + 1 >= len(items) or items[k + 1].kind in ("mark", "boundary")


def _said_before(out: list[Item]) -> tuple[int, list[Item]] | None:
    """Where the clause joins that ends `out` with its subject, and what is said of the subject before."""
    at = len(out) - 2
    while at > 0 and not (out[at].kind in ("conjunction", "boundary") or is_mark(out[at], ",.")):
        at -= 1
    start = max((j + 1 for j in range(at) if is_mark(out[j], ".")), default=0)
    verb = next((j for j in range(start, at) if out[j].kind in SAID), at)
    return (at, out[verb:at]) if 0 < verb < at else None


def _lived(out: list[Item]) -> bool:
    """Whether two rooms to live in end `out` that no area was said of."""
    first, joint, second = ([Item("")] * 3 + out)[-3:]
    pair = [i.room for i in (first, second) if i.room is not None and i.value in OPEN_TYPES]
    return len(pair) == 2 and joint.kind == "conjunction" and not any(r.areas or r.plural for r in pair)


def _rooms(out: list[Item]) -> list[RoomPhrase]:
    start = max((j + 1 for j in range(len(out)) if is_mark(out[j], ".")), default=0)
    return [i.room for i in out[start:] if i.room is not None]


def _among_things(items: list[Item], k: int) -> bool:
    """The bed of `bed and desk in the main room`."""
    room = items[k].room
    plain = room is not None and room.count is None and room.quantifier == Det.BARE and not room.labels
    j = k + 1
    while j < len(items) and (items[j].kind in ("object", "conjunction") or is_mark(items[j], ",")):
        j += 1
    listed = any(i.kind == "object" for i in items[max(k - 2, 0) : j])
    return plain and listed and j < len(items) and items[j].value == "in"
