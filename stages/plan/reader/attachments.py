"""What belongs to one room phrase: the rooms that open off it, its furniture."""

from apartgen.stages.plan.reader.belongings import OWNED_BY, belongs, beside_another, is_the_suite, of_the_first
from apartgen.stages.plan.reader.clausal import ahead, several_new
from apartgen.stages.plan.reader.loose import loose, never_in, with_one_another
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import Det
from apartgen.stages.things.categories import TABLE

ASIDE = ("copula", "label", "size", "relative")
"""What may stand between a room and what it has."""
PLURAL = ("have", "need", "get", "should have", "must have")


def attach_owned(items: list[Item], said: Said) -> list[Item]:
    """`bedroom with ensuite and two desks`, `master bedroom (walk-in closet)`, `two desks in the study`."""
    items = with_one_another(items)
    out: list[Item] = []
    k = 0
    while k < len(items):
        item = items[k]
        if item.value == "in" and _in_each(out, items[k + 1 : k + 2]):
            k += 1
            continue
        opens = (item.kind == "with" and not _inside(out, item, items[k + 1 : k + 2])) or is_mark(item, "(:")
        opens = opens or _without_things(out, items, k)
        owner = (
            next(
                (i.room for i in reversed(out) if not is_mark(i, ")") and i.kind not in ASIDE),
                None,
            )
            if opens
            else None
        )
        if owner is not None and owner.negated:
            owner = None  # "a house without a hallway with four bedrooms"
        if item.kind == "with" and item.value in ("has", "with") and out and out[-1].kind == "conjunction":
            owner = _subject(out) or owner
        if item.kind == "with" and item.value in ("has", "with") and (head := _headed(out)) is not None:
            owner = head
        if item.kind == "with" and item.value in ("has", "with"):
            owner = of_the_first(out, ahead(items, k)[0]) or owner
        owner = None if is_mark(item, ":") and said.graph else owner or _off_another(out, items, k)
        if owner is not None and (item.value == "including" or item.kind == "mark"):
            _mark_subset(owner, items[k + 1 :], item.value == "(")
        if owner is not None and owner.headline and (_placed(items, k + 1) or _for_others(owner, items, k + 1)):
            owner = None  # "a T3 with a sofa and a tv in the living room"
        if item.kind == "with" and item.value == "including":
            pass
        elif owner is not None and not (
            owner.headline and (item.kind == "mark" or item.value == "with") and not _only_things(items, k + 1)
        ):
            before, had = len(owner.owned), len(owner.objects)
            start = k + 1
            k = _take(owner, items, start, item.value if item.kind == "mark" else "")
            while owner.owned and items[k - 1].room is owner.owned[-1] and _has_things(items, k):
                k = _take(owner.owned[-1], items, k + 1, "")  # "a hall with a rack, an office with a desk"
            given = owner.owned[before:]
            several = bool(given) and all(r.plural and r.count is None for r in given)
            if (item.value == "has" and item.text in PLURAL) or (item.value == "with" and several and _one(owner)):
                _give_each(owner, given, owner.objects[had:], out)
            if k == start and is_mark(item, ":"):
                out.append(item)
            if (item.value == "has" or not owner.type) and (owner.plural or (owner.count or 1) > 1):
                for owned in owner.owned[before:]:
                    owned.quantifier = Det.EACH if owned.quantifier == Det.A else owned.quantifier
            out += [item] if item.kind == "with" and item.value == "has" else []
            continue
        elif item.kind in ("object", "objects"):
            loose(item, out, items[k + 1 :], said)
        if item.kind not in ("object", "objects"):
            out.append(item)
        k += 1
    return out


def _without_things(before: list[Item], items: list[Item], k: int) -> bool:
    """`two bedrooms without a desk`."""
    denies = items[k].kind == "negation" and items[k].value in ("without", "no") and bool(before)
    return denies and before[-1].room is not None and _only_things(items, k + 1)


def _inside(before: list[Item], item: Item, after: list[Item]) -> bool:
    """`a kitchenette in the living room`, `through a vestibule into the lounge`."""
    last = next((i for i in reversed(before) if i.text != "should be"), item)
    inner, outer = last.room, (after or [item])[0].room
    if inner is not None and inner.type == "any" and item.value == "in":
        return True  # "all doors in the hall"
    if item.text == "for" and after and after[0].kind == "mark":
        return True  # "a bedroom for my sister, an office"
    if item.value != "in" or inner is None or outer is None:
        return False
    return outer.type in OWNED_BY.get(inner.type, ()) or (len(before) > 1 and before[-2].kind == "front")


def _in_each(before: list[Item], after: list[Item]) -> bool:
    """`a bathroom in each bedroom`: moves the room before to those after it."""
    inner, owner = (before or [Item("mark")])[-1].room, (after or [Item("mark")])[0].room
    if inner is None or owner is None or owner.type not in OWNED_BY.get(inner.type, ()):
        return False
    if owner.quantifier not in (Det.EACH, Det.ALL, Det.BOTH):
        return False
    inner.quantifier = Det.EACH
    owner.owned.append(inner)
    before.pop()
    return True


def _headed(before: list[Item]) -> RoomPhrase | None:
    """The pantry of `a pantry off the kitchen that has two shelves`."""
    head, way, hub, which = ([Item("")] * 4 + before)[-4:]
    if which.value != "which" or way.kind not in ("link", "front") or hub.room is None or head.room is None:
        return None
    new = head.room.quantifier == Det.A and not head.room.plural
    return head.room if new and hub.room.quantifier == Det.THE and way.form == "" else None


def _off_another(before: list[Item], items: list[Item], k: int) -> RoomPhrase | None:
    """The utility room of `a utility room off the kitchen, with a washing machine`, the room that is told of alone."""
    head, way, hub, joint = ([Item("")] * 4 + before)[-4:]
    fits = items[k].kind == "with" and items[k].value == "with" and is_mark(joint, ",") and _only_things(items, k + 1)
    if fits and len(before) == 2 and hub.room is not None and hub.room.quantifier == Det.THE:
        return hub.room  # "the boys' bedroom, with a bunk bed, …"
    fits = fits and way.kind == "link" and way.form == "" and hub.room is not None and hub.room.quantifier == Det.THE
    return head.room if fits else None


def _subject(before: list[Item]) -> RoomPhrase | None:
    """The kitchen of `the kitchen is next to the living room and has a balcony`."""
    if len(before) > 2 and before[-2].kind == "copula" and before[-3].room is not None:
        return before[-3].room  # "the bedroom is large and has a balcony"
    compared = [k for k, i in enumerate(before) if i.kind == "compare"]
    if compared and (rooms := rooms_of(before[: compared[-1]])):
        return rooms[-1]  # "the kitchen is larger than the study and has an oven"
    links = [k for k, i in enumerate(before) if i.kind == "link"]
    if len(before) > 2 and is_mark(before[-2], ",") and before[-3].room is not None and not links:
        return before[-3].room  # "a bedroom of 12 m², please, and with a desk"
    if not links and len(before) > 1 and before[-2].room is not None:
        return before[-2].room  # "a bedroom of 12 m² and with a desk", once the area is taken
    rooms = rooms_of(before[: links[-1]]) if links else []
    return rooms[-1] if rooms else None


def _has_things(items: list[Item], k: int) -> bool:
    return k < len(items) and items[k].value == "with" and _only_things(items, k + 1)


def _placed(items: list[Item], k: int) -> bool:
    """Whether furniture stands at `k` that is in a room named behind it."""
    end = k
    while end < len(items) and (items[end].kind in ("object", "conjunction") or is_mark(items[end], ",")):
        end += 1
    return end > k and [i.value == "in" or i.room is not None for i in items[end : end + 2]] == [True, True]


def _for_others(owner: RoomPhrase, items: list[Item], k: int) -> bool:
    """Whether furniture at `k` is of rooms of other types: the island of `a flat of two bedrooms with an island`."""
    usual = TABLE[items[k].value].rooms if k < len(items) and items[k].kind == "object" else ()
    return bool(usual) and owner.type not in usual


def _only_things(items: list[Item], k: int) -> bool:
    return k < len(items) and items[k].kind in ("object", "objects")


def _mark_subset(owner: RoomPhrase, after: list[Item], parenthesis: bool) -> None:
    """`three bedrooms (a master with ensuite, …)`, `suite (bedroom, bath)`: rooms of the owner's type are among it."""
    for item in after:
        if parenthesis and is_mark(item, ")"):
            break
        same = item.room is not None and item.room.type in (owner.type, "")
        if item.room is not None and same and (owner.plural or (parenthesis and item.room.count is None)):
            item.room.subset = True


def _one(owner: RoomPhrase) -> bool:
    return bool(owner.type) and not owner.plural and (owner.count or 1) == 1


def _give_each(
    owner: RoomPhrase, given: list[RoomPhrase], things: list[tuple[str, int]], before: list[Item]
) -> None:
    """`the lounge and the main bedroom have balconies`, `bedroom 1, bedroom 2 and 3 with en suites`: one for each."""
    at = next((k for k, i in enumerate(before) if i.room is owner), 0)
    others: list[RoomPhrase] = []
    joint = at - 1
    while joint > 0 and (before[joint].kind == "conjunction" or (others and is_mark(before[joint], ","))):
        other = before[joint - 1].room
        led_to = joint > 1 and before[joint - 2].kind in ("link", "front")  # "next to the study and the bedrooms have"
        if other is None or not other.type or owner.quantifier != other.quantifier or led_to:
            break
        others.append(other)
        other.objects += things
        joint -= 2
    for room in given if others else []:
        room.plural, room.quantifier = False, Det.EACH
        for other in others:
            other.owned.append(RoomPhrase(room.type, set(room.labels), quantifier=Det.EACH, text=room.text))


def _take(owner: RoomPhrase, items: list[Item], k: int, bare: str) -> int:
    """Move what belongs to `owner` from `items[k:]` onto it; returns where the rest begins. `bare` is a mark's text."""
    first = True
    start = taken = k
    while k < len(items):
        item = items[k]
        if (
            item.kind == "object"
            and k + 2 < len(items)
            and items[k + 1].value == "in"
            and items[k + 2].room is not None
        ):
            break
        if item.kind == "object" and never_in(item, owner):
            break  # "a kitchen with a table, and a shower"
        if item.kind == "object":
            many = owner.plural or (owner.count or 1) > 1 or owner.quantifier in (Det.EACH, Det.ALL, Det.BOTH)
            many = many or owner.text.endswith("others")
            owner.objects.append((item.value, 1 if many and item.form == "some" and item.number else int(item.number)))
        elif item.kind == "objects":
            owner.object_count = int(item.number)
        elif item.room is not None and is_the_suite(owner, item.room, bare, first):
            pass  # "master suite (bedroom, bathroom)", "the master suite has a bedroom and a bathroom"
        elif item.room is not None and (
            belongs(owner, item, first, items[k + 1 : k + 2], bare)
            or (not bare and beside_another(owner, item.room, items[k + 1 :]))
        ):
            if not item.room.negated:
                owner.owned.append(item.room)
                if _each_after(items, k):
                    item.room.quantifier = Det.EACH
                    k += 1
                k += _beyond(item.room, items[k + 1 : k + 5])
        elif first and is_mark(item, ","):
            break  # "a bath with a window, a closet": what was with it is not known
        elif taken == start + 1 and owner.quantifier == Det.EACH and _closes_list(items[k : k + 3]):
            break  # "two guest rooms each with a bathroom, and a roof terrace"
        elif taken > start and owner.quantifier == Det.EACH and is_mark(item, ",") and several_new(ahead(items, k)[0]):
            break  # "three bedrooms each with its own bathroom, two balconies"
        elif item.kind in ("negation", "conjunction") or is_mark(item, ",") or (first and item.kind == "copula"):
            k += 1
            continue
        else:
            break
        first = False
        k += 1
        taken = k
    return taken


def _beyond(closet: RoomPhrase, after: list[Item]) -> int:
    """`a dressing room, which leads to the en suite`: the bathroom opens off it; returns how many items that takes."""
    start = int(bool(after) and is_mark(after[0], ","))
    kinds = [i.kind for i in after[start : start + 3]]
    leads = kinds in (["relative", "link", "room"], ["relative", "reach", "room"])
    bath = after[start + 2].room if leads else None
    if closet.type != "closet" or bath is None or bath.type != "bathroom" or bath.plural:
        return 0
    closet.owned.append(bath)
    return start + 3


def _closes_list(following: list[Item]) -> bool:
    """Whether `, and a terrace` ends a longer list than that of one thing."""
    comma, joint, room = (following + [Item("")] * 3)[:3]
    return is_mark(comma, ",") and joint.kind == "conjunction" and room.room is not None


def _each_after(items: list[Item], k: int) -> bool:
    following = items[k + 1].room if k + 1 < len(items) else None
    return following is not None and following.type == "" and following.quantifier == Det.EACH and not following.labels
