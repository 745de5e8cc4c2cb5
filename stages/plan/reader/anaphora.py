"""What `both`, `each`, `the former` stand for, and what `all but` leaves out."""

from apartgen.stages.plan.reader.mention import PARTITIVE, Item, RoomPhrase, is_mark
from apartgen.stages.plan.reader.vocabulary import Det, Trait

JOINING = ("joins", "join", "connects", "connect", "links", "link", "joining", "connecting", "linking")
"""Verbs of which subject and object are joined to a third: `a hall joins the lounge to the kitchen`."""
PAIRED = (Det.ALL, Det.EACH, Det.BOTH)


def bind(items: list[Item], before: list[Item], listed: list[Item]) -> None:
    """`a study and a lounge. Both …`, `the latter`: elliptical phrases learn which coordination they speak of.

    `listed` are the sentences just before that say what there is, of which `all` speaks.
    """
    for k, item in enumerate(items):
        phrase = item.room
        if phrase is None or phrase.type != "":
            continue
        if phrase.quantifier == Det.ANOTHER:
            kinds = [
                r.type for r in _rooms(items[:k]) if r.type and (r.quantifier in (Det.A, Det.ANOTHER) or r.count == 1)
            ]
            phrase.type = kinds[-1] if kinds else ""
        if phrase.count == 1 and k and items[k - 1].value == "share":
            phrase.type = next((r.type for r in reversed(_rooms([*before, *items[:k]])) if r.type == "bathroom"), "")
            phrase.quantifier = Det.A
        which = phrase.quantifier == Det.THE and (phrase.factor != 1.0 or bool(phrase.ordinals))
        if phrase.labels == {Trait.SIZED} or which:
            phrase.among = _headed_list(items[:k]) or phrase.among
        near = next((i.room for i in reversed(items[:k]) if i.kind != "mark"), None)
        if phrase.quantifier == Det.ONE_OF and near is not None and near.type and near.plural:
            phrase.among = [near]
        whole = phrase.quantifier in PAIRED and phrase.count is None and not phrase.labels
        named = phrase.text in ("former", "the former", "latter", "the latter")
        if whole or named:
            group = _coordination(items[:k]) or _coordination(before)
            if not group and phrase.quantifier == Det.BOTH:
                told = _rooms(items[:k])
                subject = len(told) > 2 and items[k - 1].kind == "link" and items[k - 1].value in ("near", "apart")
                group = told[-3:-1] if subject else told[-2:]  # "A is next to B, but C is far from both"
            group = group[-2:] if named else group
            single = all(r.count in (None, 1) and not r.plural for r in group)
            sized = phrase.quantifier == Det.EACH and [i.kind for i in items[k + 1 : k + 2]] == ["area"]
            pair = not sized and phrase.quantifier != Det.ALL and not _at_end(items, k)
            fits = len(group) == 2 if pair else len(group) > 1
            if single and fits:
                phrase.among = group
            elif phrase.quantifier == Det.ALL and not _rooms(items[:k]):
                phrase.among = [r for r in _rooms(listed) if r.type not in ("", "any", "hallway")]
            elif named:
                phrase.quantifier = Det.NONE


def _headed_list(items: list[Item]) -> list[RoomPhrase]:
    """The bathrooms of `two bathrooms: the larger one off the hall, the smaller one …`."""
    heads = [a.room for a, b in zip(items, items[1:], strict=False) if a.room is not None and is_mark(b, ":")]
    return [r for r in heads[-1:] if r is not None and (r.count or 1) > 1]


def says_what_is_there(items: list[Item]) -> bool:
    """`there is a kitchen`, `on the left there are two bedrooms`."""
    return any(i.kind == "reach" and i.text.startswith("there") for i in items[:2])


def _rooms(items: list[Item]) -> list[RoomPhrase]:
    return [i.room for i in items if i.room is not None]


def _at_end(items: list[Item], k: int) -> bool:
    """Whether the list itself ends here: `kitchen, dining room and living room each with …`."""
    return k > 0 and items[k - 1].room is not None


def _coordination(items: list[Item]) -> list[RoomPhrase]:
    """The last `A, B and C` among items; a plural phrase after it stands nearer."""
    for k in range(len(items) - 1, 1, -1):
        room = items[k].room
        if room is None or room.type == "":
            continue
        if items[k - 1].kind != "conjunction" or items[k - 2].room is None:
            if room.plural or (room.count or 1) > 1:
                return []
            continue
        out = [room]
        j = k - 1
        while j > 0 and (items[j].kind == "conjunction" or is_mark(items[j], ",")):
            other = items[j - 1].room
            owned = j > 1 and items[j - 2].kind == "with" and not (j > 2 and items[j - 3].kind == "dwelling")
            if other is None or other.type == "" or owned:
                break  # "the master with an en suite, a kitchen and a lounge, all …"
            out.insert(0, other)
            j -= 2
        return out if len(out) > 1 else []
    return []


def exceptions(items: list[Item]) -> list[Item]:
    """`every room but the study opens onto the hall`: the study is left out of the rooms spoken of."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        item = items[k]
        whole = _whole_before(out)
        but = item.text == "but" and bool(out) and out[-1].room is not None and out[-1].room is whole
        if whole is None or not (item.value == "except" or but):
            out.append(item)
            k += 1
            continue
        end = _run(items, k + 1)
        whole.excluded += [i.room for i in items[k + 1 : end] if i.room is not None and i.room not in whole.excluded]
        whole_at = k + 1
        aside = but or (bool(out) and out[-1].room is whole)
        if not aside or end == k + 1:
            out.append(item)
            k += 1
        else:
            k = end
            if _told_on(items, end):  # "every room except the kitchen, which opens off the lounge"
                left_out = [i for i in items[whole_at:end] if i.kind in ("room", "conjunction")]
                out += [Item("boundary", "while"), *left_out]
                k = end + 2
    return out


def _told_on(items: list[Item], k: int) -> bool:
    """Whether `, which` and a verb stand at `k`."""
    comma, which, verb = (items[k : k + 3] + [Item("")] * 3)[:3]
    return is_mark(comma, ",") and which.kind == "relative" and verb.kind in ("link", "copula")


def _whole_before(items: list[Item]) -> RoomPhrase | None:
    rooms = [i.room for i in items if i.room is not None]
    return next((r for r in reversed(rooms) if r.quantifier in (*PAIRED, Det.OTHER) or r.type == "any"), None)


def _run(items: list[Item], k: int) -> int:
    """End of the list of rooms that starts at `k`."""
    end = k
    while k < len(items) and (items[k].kind == "conjunction" or items[k].room is not None):
        k += 1
        end = k if items[k - 1].room is not None else end
    return end


def counted(items: list[Item]) -> list[Item]:
    """`the bedrooms, of which there are three, …`: the count is said afterwards."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        kinds = [i.kind for i in items[k : k + 3]]
        last = next((i.room for i in reversed(out) if i.kind != "mark"), None)
        number = items[k + 2].room if kinds in (["with", "reach", "room"], ["mark", "reach", "room"]) else None
        many = last is not None and (last.plural or last.quantifier == Det.EACH)
        if number is not None and number.type == "" and number.count and many:
            assert last is not None
            last.count = number.count
            last.quantifier = Det.BARE if last.quantifier == Det.THE else last.quantifier
            k += 3
        else:
            out.append(items[k])
            k += 1
    return out


def _furnished(items: list[Item]) -> list[Item]:
    """`in the study put a desk`: the study has it."""
    inside, room = (items[:2] + [Item("")] * 2)[:2]
    thing = next((k for k in range(2, len(items)) if items[k].kind not in ("reach", "copula", "mark")), 0)
    if inside.value != "in" or room.room is None or items[thing].kind != "object":
        return items
    return [room, Item("with", "has", inside.text), *items[thing:]]


def _one_in(items: list[Item], k: int) -> bool:
    """`a desk in the study and one in each bedroom`: another of the furniture named before."""
    room, joint, ahead = items[k].room, items[k - 1], items[k + 1 : k + 3]
    kinds = (Det.ANOTHER, Det.NONE)
    counted = room is not None and room.type == "" and (room.count is not None or room.quantifier in kinds)
    inside = [i.value == "in" or i.room is not None for i in ahead] == [True, True]
    return counted and inside and (joint.kind in ("conjunction", "boundary") or is_mark(joint, ",;"))


def _is_other(items: list[Item]) -> bool:
    last = items[-1].room if items else None
    return last is not None and last.type == "" and last.quantifier == Det.OTHER


def _definite_pair(items: list[Item], k: int) -> bool:
    around = [i.room for i in (*items[max(k - 1, 0) : k], *items[k + 1 : k + 2])]
    return len(around) == 2 and all(r is not None and r.quantifier == Det.THE for r in around)


def _one_each(items: list[Item], k: int) -> bool:
    before = [i for i in items[:k] if i.kind != "side"]
    around = [i.room for i in (*before[-1:], *items[k + 1 : k + 3])]
    if len(around) < 3 or any(r is None for r in around):
        return False
    many, one, each = (r for r in around if r is not None)
    return many.plural and one.count == 1 and each.type == "" and each.quantifier == Det.EACH


def unfolded(items: list[Item]) -> list[Item]:
    """Short forms written out: `a bathroom between them`, `the other to …`, `connects the hall with the lounge`."""
    out: list[Item] = []
    for k, item in enumerate(items := _furnished(items)):
        links = [i for i in items[:k] if i.kind == "link"]
        near = [i.kind for i in items[max(0, k - 1) : k + 2]]
        thing = next((i for i in reversed(items[:k]) if i.kind == "object"), None)
        if thing is not None and _one_in(items, k):
            none = item.room is not None and item.room.quantifier == Det.NONE
            count = 0 if none else (item.room and item.room.count) or 1
            out.append(Item("object", thing.value, item.text, number=count))
        elif (
            item.kind == "sum"
            and item.text == "between them"
            and near[0] == "room"
            and not {"area", "share"} & set(near)
        ):
            shares = any(i.value == "share" for i in links)
            out += [] if shares else [Item("link", "between", item.text)]
        elif item.kind == "link" and item.text.startswith("one ") and _is_other(out):  # "the other one from the hall"
            way = item.text.split()[-1]
            out.append(Item("front", "from", way) if way == "from" else Item("link", "to", way))
        elif item.kind == "front" and [i.kind for i in items[max(k - 2, 0) : k]] == ["relative", "reach"]:
            out[-2:] = [Item("link", "door", "reached from")]  # "a utility room that you reach from the kitchen"
        elif item.kind == "with" and item.value == "in" and k and items[k - 1].value == "from_which":
            continue  # "von dem aus man in die Küche kommt"
        elif item.value == "to" and k + 1 < len(items) and items[k + 1].value == "has":
            continue  # "the master to have an en suite"
        elif is_mark(item, ",") and _one_each(items, k):
            out.append(Item("with", "with", "with"))  # "two bedrooms, one bath each"
        elif item.kind == "link" and item.text.startswith("the other ") and not _rooms(items[k + 1 : k + 2]):
            continue
        elif item.kind == "link" and item.text.startswith("the other "):
            told = any(i.text.split()[0] in ("one", "another") for i in links)
            other = RoomPhrase("", quantifier=Det.OTHER, text="the other")
            to = Item("link", "to", "to")
            out += [item] if told else [Item("room", "", other.text, other), to]
        elif item.text == "with" and links and links[-1].text.endswith(" with") and _definite_pair(items, k):
            out.append(Item("link", "to", "to"))  # "the lounge connects with the hall, the kitchen with the lounge"
        elif item.text == "with" and links and links[-1].text in JOINING and links[-1] in items[max(0, k - 3) : k]:
            out.append(Item("conjunction", "and", item.text))
        else:
            out.append(item)
    return out


def _leads(last: RoomPhrase, phrase: RoomPhrase) -> bool:
    """Whether two rooms in a row are subject and object: `…, le séjour sur la terrasse`."""
    both = last.quantifier == phrase.quantifier == Det.THE and not last.plural and last.type != phrase.type
    return last.type == "hallway" or both


def shared_verb(items: list[Item]) -> list[Item]:
    """`one has an en suite, the other a balcony`: the second verb, which is not said."""
    out: list[Item] = []
    has: Item | None = None
    verb: Item | None = None
    for k, item in enumerate(items):
        if item.kind == "give":
            has = Item("with", "has", item.text)
            continue
        phrase, last = item.room, out[-1].room if out else None
        if item.kind == "with" and item.value == "has":
            has = item
        given = k > 1 and items[k - 2].kind == "give"  # "give each bedroom a closet"
        gap = given or len(out) > 1 and (out[-2].kind in ("conjunction", "boundary") or is_mark(out[-2], ","))
        known = last is not None and (last.quantifier in PARTITIVE or bool(last.ordinals) or last.definite)
        known = known or (last is not None and last.type == "" and last.count == 1)  # "one has a desk, one a piano"
        new = phrase is not None and (phrase.quantifier in (Det.A, Det.OWN, Det.ANOTHER) or bool(phrase.count))
        new = new or item.kind == "object"  # "the second has a desk and the third one a piano"
        if has is not None and gap and known and new and k and items[k - 1].room is last:
            out.append(Item("with", "has", has.text))
        elif verb and gap and last and phrase and items[k - 1].room is last and _leads(last, phrase):
            out.append(verb)  # "the hall serves the lounge, the inner one the bedrooms"
        verb = item if item.kind == "link" and item.form in ("s", "p") else verb
        out.append(item)
    return out
