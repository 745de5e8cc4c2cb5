"""What belongs to one room phrase: its area, its own rooms, its furniture."""

from stages.plan.reader.phrases import Item, RoomPhrase
from stages.plan.reader.sense import sense
from stages.plan.reader.statements import Said, Statement, is_mark, rooms_of, split_area

OWNED_BY = {
    "closet": ("bedroom", "hallway"),
    "bathroom": ("bedroom", "hallway"),
    "balcony": ("living_room", "bedroom", "kitchen", "dining_room", "study"),
    "storage": ("kitchen", "hallway"),
    "utility": ("kitchen", "hallway", "bathroom"),
    "study": ("bedroom", "hallway"),
    "dining_room": ("living_room", "kitchen"),
    "kitchen": ("living_room",),
    "bedroom": ("hallway",),
}
"""What `A with a B` makes B: a room that opens off A."""


def mark_headlines(items: list[Item], said: Said) -> None:
    """`80 m² two-bedroom, two-bath flat`: counts before the dwelling are totals, the area is the flat's."""
    for k, item in enumerate(items):
        phrase = item.room
        if phrase is not None and phrase.count is not None and _totals(items, k):
            phrase.headline = True
        if item.kind != "dwelling" or said.dwelling:
            continue
        j = k - 1
        while j >= 0 and (items[j].room is not None or is_mark(items[j], "/,-") or items[j].kind in ("conjunction", "style")):
            phrase = items[j].room
            if phrase is not None:
                if phrase.count is None and not phrase.headline and not item.joined and j != k - 1:
                    break
                phrase.headline = phrase.count is not None
                if phrase.areas:
                    said.total_area, phrase.areas = phrase.areas[0], ()
                if phrase.headline:
                    said.flat_size, phrase.factor = said.flat_size * phrase.factor, 1.0
            j -= 1


def _totals(items: list[Item], k: int) -> bool:
    """`piso de dos dormitorios`, `three bedrooms in total`."""
    before, after = items[max(k - 1, 0)], items[k + 1 : k + 2]
    return (k > 0 and before.kind == "dwelling") or any(i.kind == "area_word" and i.value == "total" for i in after)


def merge_ensuites(items: list[Item]) -> list[Item]:
    """`two ensuite bedrooms`, `master bedroom en suite`, `one of them ensuite`."""
    out: list[Item] = []
    for item in items:
        near = [i for i in out if i.kind not in ("copula", "relative")]
        last = near[-1].room if near else None
        phrase = item.room
        if phrase is not None and _is_ensuite(phrase) and phrase.quantifier in ("all", "each", "both") and (beds := _beds(near)):
            phrase.quantifier = "each"
            beds.owned.append(phrase)
        elif last is None or phrase is None:
            out.append(item)
        elif _is_ensuite(last) and phrase.type == "bedroom" and phrase.count is None and not phrase.quantifier:
            last.labels -= {"own"}
            phrase.count, phrase.quantifier, phrase.areas = last.count, last.quantifier, phrase.areas or last.areas
            phrase.owned.append(RoomPhrase("bathroom", {"ensuite"}, text=last.text, quantifier="each"))
            out[out.index(near[-1])] = item
        elif _is_ensuite(phrase) and phrase.count is None and last.type == "bedroom" and phrase.quantifier in ("", "own"):
            last.owned.append(phrase)
        elif _is_ensuite(phrase) and last.quantifier == "none":
            phrase.negated = True
            out[-1] = item
        elif _is_ensuite(phrase) and last.type == "" and phrase.quantifier == "":
            last.labels.add("ensuite?")
        elif last.type == "" and phrase.count is None and phrase.labels & {"half", "master", "guest", "kids", "small", "shower"} and near[-1] is out[-1]:
            last.labels |= phrase.labels
        elif _is_ensuite(phrase) and last.type == "bathroom" and phrase.quantifier == "" and phrase.count is None:
            last.labels.add("ensuite")
        else:
            out.append(item)
    return out


def _beds(items: list[Item]) -> RoomPhrase | None:
    """The bedrooms of `three bedrooms, all ensuite`."""
    found = [r for r in rooms_of(items) if r.type == "bedroom"]
    return found[-1] if found else None


def _is_ensuite(phrase: RoomPhrase) -> bool:
    return phrase.type == "bathroom" and "ensuite" in phrase.labels


def attach_areas(items: list[Item], said: Said) -> list[Item]:
    """Give every area or share to the room it speaks of, else to the flat."""
    out: list[Item] = []
    for k, item in enumerate(items):
        phrase = item.room
        if phrase is not None and phrase.areas and (phrase.headline or phrase.areas[0] > 5 * sense()["area"].get(phrase.type, 12.0)):
            said.total_area, phrase.areas = phrase.areas[0], ()
        if item.kind == "fraction":
            item = Item("share", "", item.text, values=item.values)
        if item.kind not in ("area", "share"):
            out.append(item)
            continue
        owners = [] if item.value == "total" or _total_near(items, k) else _owners(out, items, k)
        if not owners and item.kind == "area":
            said.total_area = item.values[0] if said.total_area is None else said.total_area
        elif not owners:
            said.unread.append(item.text)
        together = any(i.kind == "sum" for i in items[max(k - 3, 0) : k + 2])
        if together and len(owners) == 1 and not owners[0].plural:
            owners = _coordinated(out, owners[0])
            split_area(owners, item.values[0]) if item.kind == "area" else None
        for owner in owners:
            owner.together = together or (item.kind == "share" and item.values[0] * (owner.count or 1) > 0.9)
            if item.kind == "area":
                owner.areas = owner.areas or item.values
            else:
                owner.share = item.values[0]
    return [i for i in out if i.kind not in ("area_word", "sum")]


def _coordinated(before: list[Item], last: RoomPhrase) -> list[RoomPhrase]:
    """`the kitchen and the living room` that end in `last`."""
    at = next(j for j, i in enumerate(before) if i.room is last)
    out = [last]
    while at > 1 and before[at - 1].kind == "conjunction" and (phrase := before[at - 2].room) is not None:
        out.insert(0, phrase)
        at -= 2
    return out


def _total_near(items: list[Item], k: int) -> bool:
    before = [i for i in items[max(0, k - 3) : k] if i.kind not in ("copula",) and not is_mark(i, ":")]
    return any(i.kind == "area_word" and i.value == "total" for i in before[-1:] + items[k + 1 : k + 2])


def _owners(before: list[Item], items: list[Item], k: int) -> list[RoomPhrase]:
    if items[k].kind == "share" and k + 2 < len(items) and items[k + 1].value == "with" and (ahead := items[k + 2].room):
        return [ahead]
    j = len(before) - 1
    while j >= 0 and (is_mark(before[j], "(:,-") or before[j].kind in ("copula", "with", "area_word", "reach", "label", "size", "compare", "sum")):
        j -= 1
    if j >= 0 and before[j].room is not None and not _speaks_of_flat(before, j, items[k]):
        group = [before[j].room]
        each = any(i.room is not None and i.room.quantifier in ("each", "both") for i in items[k + 1 : k + 2])
        if before[j].room.type == "" and before[j].room.quantifier in ("each", "both") and j and (last := before[j - 1].room):
            each, group, j = True, [last], j - 1
        if each and not group[0].plural:
            while j > 1 and (before[j - 1].kind == "conjunction" or is_mark(before[j - 1], ",")) and before[j - 2].room is not None:
                j -= 2
                phrase = before[j].room
                group += [phrase] if phrase else []
        return group
    if j >= 0 and (before[j].kind == "dwelling" or before[j].room is not None):
        return []
    if items[k].kind == "share" or (k + 1 < len(items) and items[k + 1].kind in ("with", "link", "front")):
        after = rooms_of(items[k + 1 : k + 4])
        return after[:1] if not any(i.kind == "dwelling" for i in items[:k]) or items[k].kind == "share" else []
    return []


def _speaks_of_flat(before: list[Item], j: int, area: Item) -> bool:
    """`2BHK, 80 m²`, `… and a bathroom, 85 m²`: more than such a room ever has."""
    phrase = before[j].room
    if phrase is None or area.kind == "share":
        return False
    usual = sense()["area"].get(phrase.type, 12.0)
    apart = any(is_mark(i, ",") for i in before[j + 1 :])
    return phrase.headline or area.values[0] > (2.2 if apart else 5.0) * usual


def attach_owned(items: list[Item], said: Said) -> list[Item]:
    """`bedroom with ensuite and two desks`, `master bedroom (walk-in closet)`, `two desks in the study`."""
    out: list[Item] = []
    k = 0
    while k < len(items):
        item = items[k]
        opens = item.kind == "with" or is_mark(item, "(:")
        owner = next((i.room for i in reversed(out) if not is_mark(i, ")") and i.kind not in ("copula", "label", "size")), None) if opens else None
        if is_mark(item, ":") and said.graph:
            owner = None
        if owner is not None and (item.value == "including" or item.kind == "mark"):
            _mark_subset(owner, items[k + 1 :], item.value == "(")
        if item.kind == "with" and item.value == "including":
            pass
        elif owner is not None and not (owner.headline and (item.kind == "mark" or item.value == "with") and not _only_things(items, k + 1)):
            before = len(owner.owned)
            k = _take(owner, items, k + 1, bare=item.kind == "mark")
            if item.value == "has" and (owner.plural or (owner.count or 1) > 1):
                for owned in owner.owned[before:]:
                    owned.quantifier = "each" if owned.quantifier == "a" else owned.quantifier
            out += [item] if item.kind == "with" and item.value == "has" else []
            continue
        elif item.kind in ("object", "objects"):
            _loose(item, out, items[k + 1 :], said)
        if item.kind not in ("object", "objects"):
            out.append(item)
        k += 1
    return out


def _only_things(items: list[Item], k: int) -> bool:
    return k < len(items) and items[k].kind in ("object", "objects")


def _mark_subset(owner: RoomPhrase, after: list[Item], parenthesis: bool) -> None:
    """`three bedrooms (a master with ensuite, …)`: rooms of the owner's type are among it."""
    for item in after:
        if parenthesis and is_mark(item, ")"):
            break
        if item.room is not None and owner.plural and item.room.type in (owner.type, ""):
            item.room.subset = True


def _take(owner: RoomPhrase, items: list[Item], k: int, bare: bool) -> int:
    """Move what belongs to `owner` from `items[k:]` onto it; returns where the rest begins."""
    first = True
    taken = k
    while k < len(items):
        item = items[k]
        if item.kind == "object" and k + 2 < len(items) and items[k + 1].value == "in" and items[k + 2].room is not None:
            break
        if item.kind == "object":
            owner.objects.append((item.value, int(item.number)))
        elif item.kind == "objects":
            owner.object_count = int(item.number)
        elif item.room is not None and _belongs(owner, item, first, items[k + 1 : k + 2], bare):
            if not item.room.negated:
                owner.owned.append(item.room)
                if _each_after(items, k):
                    item.room.quantifier = "each"
                    k += 1
        elif item.kind == "negation" or item.kind == "conjunction" or is_mark(item, ","):
            k += 1
            continue
        else:
            break
        first = False
        k += 1
        taken = k
    return taken


def _each_after(items: list[Item], k: int) -> bool:
    following = items[k + 1].room if k + 1 < len(items) else None
    return following is not None and following.type == "" and following.quantifier == "each" and not following.labels


def _belongs(owner: RoomPhrase, item: Item, first: bool, after: list[Item], bare: bool) -> bool:
    phrase = item.room
    assert phrase is not None
    kind = owner.type or "bedroom"
    if phrase.headline or kind not in OWNED_BY.get(phrase.type, ()):
        return False
    if "adjoining" in phrase.labels and first:
        return True
    if kind == "hallway":
        return not bare and (first or phrase.type in ("bedroom", "bathroom", "study"))
    if phrase.type == "bathroom":
        own = bool(phrase.labels & {"ensuite", "own"}) and not phrase.labels & {"family", "half"}
        lone = first and not bare and phrase.count in (None, 1) and not phrase.labels & {"family", "half"} and not _listed(after)
        return own or lone or (first and _each_follows(after))
    if phrase.type in ("kitchen", "dining_room"):
        return first and not bare and phrase.count is None and (phrase.type == "dining_room" or bool(phrase.labels & {"open", "small"}))
    return first or phrase.type in ("closet", "balcony") and not bare


def _listed(after: list[Item]) -> bool:
    return bool(after) and is_mark(after[0], ",")


def _each_follows(after: list[Item]) -> bool:
    return bool(after) and after[0].room is not None and after[0].room.quantifier == "each"


def _loose(item: Item, before: list[Item], after: list[Item], said: Said) -> None:
    """Furniture named before its room (`a piano in the living room`), or with no room at all."""
    holder = None
    if after and after[0].kind in ("with", "conjunction", "object", "link"):
        inside = next((j for j, x in enumerate(after) if x.kind == "with" and x.value == "in"), None)
        if inside is not None and inside + 1 < len(after) and all(x.kind in ("object", "conjunction", "mark", "objects") for x in after[:inside]):
            holder = after[inside + 1].room
    if holder is None and not (after and after[0].kind == "with"):
        known = [i.room for i in before if i.room is not None]
        holder = known[-1] if known and (item.kind == "objects" or known[-1].objects) else None
    if holder is None:
        said.loose_objects.append((item.value if item.kind == "object" else "", int(item.number)))
    elif item.kind == "objects":
        holder.object_count = int(item.number)
    else:
        holder.objects.append((item.value, int(item.number)))


def comparisons(items: list[Item]) -> tuple[list[Item], list[Statement]]:
    """`A is twice as large as B`, `bedrooms of equal size`."""
    out: list[Item] = []
    found: list[Statement] = []
    skip = False
    for k, item in enumerate(items):
        if item.kind != "compare":
            if not skip or item.room is None:
                out.append(item)
            skip = skip and item.room is None
            continue
        before = rooms_of(out)
        after = rooms_of(items[k + 1 :])
        if item.number == -1 and before:
            clause = _clause(out)
            found.append(Statement("equal", clause, clause))
        elif before and after:
            found.append(Statement("compare", before[-1:], after[:1], item.number))
            out.append(Item("room", after[0].type, after[0].text, after[0]))
            skip = True
    return out, found


def _clause(items: list[Item]) -> list[RoomPhrase]:
    """Rooms of the last coordination."""
    out: list[RoomPhrase] = []
    for item in reversed(items):
        if item.room is not None:
            out.append(item.room)
        elif item.kind not in ("conjunction", "copula") and not is_mark(item, ","):
            break
        if out and item.room is not None and item.room.plural:
            break
    return out[::-1]


def spread_negation(items: list[Item]) -> None:
    """`no study or balcony`, `without a dining room and balcony`."""
    word, scope = "", False
    for k, item in enumerate(items):
        if item.kind == "negation":
            word = item.value
        elif item.room is not None:
            phrase = item.room
            joint = items[k - 1].value if k and items[k - 1].kind == "conjunction" else ""
            plain = phrase.count is None and phrase.quantifier in ("", "a") and not phrase.labels & {"separate"}
            if scope and not phrase.negated and plain and (joint == "or" or (joint == "and" and (word == "without" or phrase.quantifier == ""))):
                phrase.negated = True
            elif scope and not phrase.negated and plain and k and is_mark(items[k - 1], ",") and phrase.quantifier == "":
                phrase.negated = _closes_with_or(items[k:])
            scope = phrase.negated
        elif item.kind not in ("conjunction",) and not is_mark(item, ","):
            scope = False


def drop_alternatives(items: list[Item], said: Said) -> list[Item]:
    """`two bedrooms or three bedrooms`: the first is taken, the other reported."""
    out: list[Item] = []
    for item in items:
        phrase, last = item.room, out[-2].room if len(out) > 1 else None
        if phrase and last and phrase.count and last.count and phrase.type == last.type and out[-1].value == "or":
            out.pop()
            said.unread.append(f"or {phrase.count:g} {phrase.text}")
        else:
            out.append(item)
    return out


def _closes_with_or(items: list[Item]) -> bool:
    """Whether this list ends in `or`: `no study, balcony or dining room`."""
    for item in items:
        if item.kind == "conjunction":
            return item.value == "or"
        if item.room is None and not is_mark(item, ","):
            return False
    return False
