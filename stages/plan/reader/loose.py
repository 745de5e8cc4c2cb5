"""Furniture that no room has been found for yet: of a room named behind it or before it, or of the home."""

from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.shared_out import usual_in
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.things.categories import TABLE

DRY = ("kitchen", "living_room", "dining_room", "study", "hallway", "balcony", "storage", "closet")
"""Rooms that have no bath, shower or toilet, though they are named before one."""


def with_one_another(items: list[Item]) -> list[Item]:
    """`I need a dining table with four chairs`: things that go together, and none is of a room named before them."""
    out = list(items)
    for k in range(1, len(items) - 1):
        things = items[k - 1].kind == items[k + 1].kind == "object"
        if things and (items[k].kind, items[k].value) == ("with", "with"):
            out[k] = Item("conjunction", "and", items[k].text)
    return out


def never_in(item: Item, room: RoomPhrase) -> bool:
    """Whether a thing is of bathrooms alone, and the room is none (`a kitchen with a table, and please no bathtub`), or
    a bed is to be where nobody sleeps."""
    if item.kind != "object":
        return False
    slept_in = TABLE[item.value].is_for("sleep") and room.type in ("bathroom", "kitchen")
    return slept_in or (room.type in DRY and TABLE[item.value].rooms == ("bathroom",))


def bathed(said: Said) -> bool:
    """Whether a bath, a shower or a toilet is asked for that no room is told to have: there is a bathroom for it."""
    return any(count and TABLE[category].rooms == ("bathroom",) for category, count in said.loose_objects if category)


def loose(item: Item, before: list[Item], after: list[Item], said: Said) -> None:
    """Furniture named before its room (`flat with a desk, a chair and a lamp in the study`), or with no room at all."""
    holder = None
    after = after[1:] if after and after[0].kind == "copula" else after  # "a wardrobe must be in every bedroom"
    lists = bool(after) and is_mark(after[0], ",") and all(r.headline for r in rooms_of(before))
    if lists or (after and after[0].kind in ("with", "conjunction", "object", "link")):
        inside = next((j for j, x in enumerate(after) if x.kind == "with" and x.value == "in"), None)
        if (
            inside is not None
            and inside + 1 < len(after)
            and all(x.kind in ("object", "conjunction", "mark", "objects") or x.value == "with" for x in after[:inside])
        ):
            holder = after[inside + 1].room
            holder = None if lists and not usual_in(item, holder) else holder
    known = [i.room for i in before if i.room is not None]
    end = next((j for j, x in enumerate(after) if x.kind not in ("object", "conjunction", "objects")), len(after))
    in_it = [i.value for i in after[end : end + 1]] == ["in"]
    in_it = in_it and (len(after) == end + 1 or after[end + 1].kind in ("mark", "conjunction"))
    if holder is None and in_it and known:
        holder = known[0]  # "the baby's room is small, and we need a cot in it"
    if holder is None and not (after and after[0].kind == "with"):
        holder = known[-1] if known and (item.kind == "objects" or known[-1].objects) else None
        fits = usual_in(item, holder) if item.number else holder is None or not never_in(item, holder)
        holder = holder if fits else None  # "the bathroom has …, and I need a dining table"
    if holder is None:
        said.loose_objects.append((item.value if item.kind == "object" else "", int(item.number)))
        said.uncounted |= {item.value} if item.form == "some" else set()
    elif item.kind == "objects":
        holder.object_count = int(item.number)
    else:
        holder.objects.append((item.value, int(item.number)))
