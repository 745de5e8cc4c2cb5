"""Rooms meant by `it`, `also` and `does not`, and what stands in a room named first: short forms written out."""

from dataclasses import replace

from apartgen.stages.plan.reader.clausal import again_named, ahead, clause, last
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.particles import BUREAU
from apartgen.stages.plan.reader.vocabulary import Det, Trait


def between_it(out: list[Item], items: list[Item], k: int) -> bool:
    """`the kitchen has one door, and no door between it and the lounge`: between the kitchen and the lounge."""
    joint, room, _ = ahead(items, k)
    fits = items[k].value == "it" and last(out).value == "between" and joint.kind == "conjunction"
    told = _told_of(out) if fits and room.room is not None else None
    if told is None:
        return False
    out.append(again_named(told))
    return True


def rest_off_it(out: list[Item], items: list[Item], k: int) -> bool:
    """`the entrance is in the living room, and the other rooms open off it`: off the living room, in a new clause."""
    ends = out[:-1] if len(out) > 3 and last(out).kind == "link" else []
    ends = ends[:-1] if ends and ends[-1].room is not None and not ends[-1].room.type else ends  # "they all"
    rest = last(ends).room
    if items[k].value != "it" or rest is None or rest.type != "any" or rest.quantifier not in (Det.OTHER, Det.ALL):
        return False
    told = [i.room for i in ends if i.room is not None and _single(i.room)]
    if not told or len(ends) < 2:
        return False
    joint = len(ends) - 2
    out[joint] = Item("mark", ".", ".") if out[joint].kind in ("conjunction", "boundary") else out[joint]
    out.append(again_named(told[-1]))
    return True


def _told_of(out: list[Item]) -> RoomPhrase | None:
    """The room that the clause in `out` is about, else the one before is."""
    said = clause(out)
    before = clause(out[: len(out) - len(said) - 1])
    return next((i.room for part in (said, before) for i in part if i.room is not None and _single(i.room)), None)


def _single(room: RoomPhrase) -> bool:
    """One room of a kind; the bedroom of `a one-bedroom flat` is spoken of as a count."""
    one = not room.plural and room.count is None and room.type not in ("", "any")
    return one and not room.negated and not room.headline


def home_is_with(out: list[Item], items: list[Item], k: int) -> bool:
    """`the flat is with one bedroom`: it has one."""
    fits = items[k].text == "is with" and last(out).kind == "dwelling"
    out += [Item("with", "with", items[k].text)] * fits
    return fits


def also_off(out: list[Item], items: list[Item], k: int) -> bool:
    """`and a pantry, also off the kitchen`: the pantry is off the kitchen."""
    link = ahead(items, k)[0]
    fits = items[k].text in ("also", "likewise", "again") and link.kind in ("link", "front") and link.form == ""
    fits = fits and is_mark(last(out), ",") and len(out) > 1 and out[-2].room is not None
    if fits:
        out.pop()
    return fits


def desk_among_things(out: list[Item], items: list[Item], k: int) -> bool:
    """The French `bureau` of `dans la chambre, un lit et un bureau`, `un bureau et deux chaises`: a desk, no study."""
    room, after = items[k].room, items[k + 1 : k + 3]
    if room is None or room.text not in BUREAU or room.negated:
        return False
    before = out[:-1] if last(out).kind == "conjunction" or is_mark(last(out), ",") else []
    closes = last(out).kind == "conjunction" and last(before).kind == "object"
    fronted = last(before).room is not None and _begins(before) and all(i.kind != "conjunction" for i in after[:1])
    leads = len(after) > 1 and after[1].kind == "object" and (after[0].kind == "conjunction" or is_mark(after[0], ","))
    inside = [i.value == "in" or i.room is not None for i in after] == [True, True]
    if not (closes or (fronted and is_mark(last(out), ",")) or leads or inside):
        return False
    count = room.count or (2 if room.plural else 1)
    out.append(Item("object", "desk", items[k].text, number=count))
    return True


def _begins(said: list[Item]) -> bool:
    """Whether a known room begins the clause that `said` ends in: `dans le salon, …`."""
    room = last(said).room
    led = [i.value for i in clause(said)[:-1]] in ([], ["in"])
    return room is not None and room.quantifier == Det.THE and led


def thing_again(out: list[Item], items: list[Item], k: int) -> bool:
    """`a kitchen with an island. The island has four stools`: the kitchen has them, and one island."""
    after = ahead(items, k)[0]
    at = max((j for j, i in enumerate(out) if i.kind == "object" and i.value == items[k].value), default=0)
    inside = any(i.value == "in" or i.text.endswith(" in") for i in items[k + 1 : k + 3])
    if items[k].form == "again" and inside and _alone(out, at):
        del out[at]  # "a sofa. The sofa is in the living room"
        return False
    if items[k].form != "again" or not (after.value in ("has", "with") or after.kind in ("copula", "mark", "")):
        return False
    if after.value not in ("has", "with"):
        return True  # "the table is round"
    behind = [b.room for a, b in zip(out[at:], out[at + 1 :], strict=False) if a.value == "in"]
    room = next((r for r in (*behind, *(i.room for i in reversed(out[:at]))) if r is not None and _single(r)), None)
    out += [again_named(room)] if room is not None else []
    return room is not None


def _alone(out: list[Item], at: int) -> bool:
    """Whether a thing is all that its sentence names, so that nobody said where it is."""
    return (at == 0 or is_mark(out[at - 1], ".")) and (at + 1 == len(out) or is_mark(out[at + 1], "."))


def does_not_but_has(out: list[Item], items: list[Item], k: int) -> bool:
    """`bedroom 3 doesn't, it gets a wardrobe`, `the second does not, but has a desk`: what it has is said of it."""
    room, end = last(out).room, k + 1
    if items[k].value != "not" or room is None or not (room.ordinals or room.quantifier in (Det.THE, Det.OTHER)):
        return False
    while end < len(items) and (is_mark(items[end], ",;.") or items[end].kind == "boundary"):
        end += 1
    end += [i.value for i in items[end : end + 1]] == ["it"]
    if end < k + 2 or [i.value for i in items[end : end + 1]] != ["has"]:
        return False
    items[k + 1 : end] = [Item("stop", "", i.text) for i in items[k + 1 : end]]
    after = [n for n in range(end + 1, min(end + 3, len(items))) if items[n].value == "instead"]
    items[:] = [replace(i, kind="stop") if n in after else i for n, i in enumerate(items)]
    return True


def described_otherwise(out: list[Item], items: list[Item], k: int) -> bool:
    """`the bedroom with the bath …, the bedroom next to the kitchen …`: each is another of them; it leaves none out."""
    told = _description(items, k)
    said = clause(out)
    others = [(j, i.room) for j, i in enumerate(said) if i.room is not None and i.value == items[k].value == "bedroom"]
    apart = [r for j, r in others if Trait.MASTER in r.labels or _description(said, j) not in ("", told)]
    if told and apart:
        for room in [r for r in (*apart, items[k].room) if r is not None and not r.labels]:
            room.quantifier = Det.ONE_OF
    return False


def _description(items: list[Item], k: int) -> str:
    """The words behind a room that tell which of several it is."""
    room, (way, other, _) = items[k].room, ahead(items, k)
    plain = room is not None and bool(room.type) and not (room.labels or room.ordinals or room.plural or room.count)
    known = plain and room is not None and room.quantifier in (Det.THE, Det.ONE_OF) and not room.rank
    tells = (way.kind == "link" and way.form == "") or (way.kind == "with" and way.value == "with")
    return f"{way.text} {other.text}" if known and tells and (other.room is not None or other.kind == "object") else ""


def whose_sleep(out: list[Item], items: list[Item], k: int) -> bool:
    """`the kids sleep in the second bedroom`: that is the kids' one."""
    room, (verb, inside, bedroom) = items[k].room, ahead(items, k)
    if room is None or room.type or not room.labels or verb.text not in ("sleep", "sleeps", "stay", "stays"):
        return False
    if inside.value != "in" or bedroom.room is None or bedroom.room.type != "bedroom":
        return False
    bedroom.room.labels |= room.labels
    items[k + 1 : k + 3] = [replace(i, kind="stop") for i in (verb, inside)]
    return True


def only_from(out: list[Item], items: list[Item], k: int) -> bool:
    """`zwei Bäder, beide nur vom Flur aus`: reached only from the hall, where no verb follows."""
    front, room, end = (*items[k + 1 : k + 4], *[Item("")] * 3)[:3]
    fits = items[k].kind == "only" and items[k].value == "weak" and last(out).room is not None
    fits = fits and front.kind == "front" and front.value == "from" and room.room is not None
    if not fits or end.kind not in ("", "mark", "conjunction"):
        return False
    out.append(Item("link", "only", f"{items[k].text} {front.text}"))
    items[k + 1] = replace(front, kind="stop")
    return True


SPOKEN = (between_it, rest_off_it, home_is_with, also_off, does_not_but_has, desk_among_things, thing_again,
          described_otherwise, whose_sleep, only_from)  # fmt: skip
"""In the order in which they are tried; each tells whether it has put the item at `k` into `out`, or left it out."""
