"""What was said as a programme: rooms with ids, links, areas, furniture, weights."""

import math
from dataclasses import dataclass, field
from typing import Any

from schemas.base import ROOM_TYPES
from schemas.errors import BadInput
from schemas.plan import AskedObjects, AskedRoom, Envelope, Link, Program
from stages.categories import TABLE
from stages.plan.reader.areas import fill, typical
from stages.plan.reader.household import MOST, Entity, Household
from stages.plan.reader.links import complete_links, edge
from stages.plan.reader.parse import mentions, parse
from stages.plan.reader.phrases import OPEN_TYPES, RoomPhrase
from stages.plan.reader.sense import sense
from stages.plan.reader.statements import Said, Statement

LONGEST = 8000
"""Characters of a prompt."""

Pair = tuple[Entity, Entity]


@dataclass
class _Doors:
    """Doors said and doors forbidden, between entities."""

    links: list[Pair] = field(default_factory=list)
    open: list[Pair] = field(default_factory=list)
    forbidden: list[Pair] = field(default_factory=list)
    near: list[Pair] = field(default_factory=list)


def read(prompt: str) -> Program:
    """The programme a prompt asks for, gaps filled by architectural common sense. Pure; no network.

    BadInput when no room can be read or the request is absurd.
    """
    said = bounded(prompt)
    home = Household(mentions(said.statements))
    for phrase in _introduced_first(said.rooms):
        home.resolve(phrase)
    if not home.rooms and not said.dwelling and not said.main_rooms:
        raise BadInput(f"no room could be read from the prompt {_quoted(prompt)}; name rooms, e.g. \"two-bedroom flat with a study\"")
    doors = _doors(said.statements, home)
    complete = said.only or _full_graph(said, home, doors)
    if not complete:
        _missing(said, home, doors)
    _every_room(said.statements, home, doors)
    _ensuites(home, doors)
    if len(home.rooms) > MOST:
        raise BadInput(f"the prompt asks for more than {MOST} rooms; ask for fewer")
    return _program(said, home, doors, complete)


def bounded(prompt: str) -> Said:
    """What a prompt says; BadInput when it is empty, asks for more rooms than a home has, for areas out of range."""
    if not prompt.strip():
        raise BadInput('the prompt is empty; name rooms, e.g. "two-bedroom flat"')
    if len(prompt) > LONGEST:
        raise BadInput(f"the prompt has {len(prompt)} characters; keep it below {LONGEST}")
    said = parse(prompt)
    _counts_in_bounds(said)
    return said


def _introduced_first(phrases: list[RoomPhrase]) -> list[RoomPhrase]:
    """Totals first; `each bedroom … three bedrooms` is read the other way round."""
    early: set[int] = set()
    for k, phrase in enumerate(phrases):
        universal = phrase.quantifier in ("each", "all", "both") and phrase.count is None
        known = any(p.type == phrase.type for p in phrases[:k])
        if universal and not known and any(p.type == phrase.type and p.count for p in phrases[k:]):
            early.add(id(phrase))
    return sorted(phrases, key=lambda p: 0 if p.headline else 2 if id(p) in early else 1)


def _quoted(prompt: str) -> str:
    text = " ".join(prompt.split())
    return f'"{text[:60]}…"' if len(text) > 60 else f'"{text}"'


def _counts_in_bounds(said: Said) -> None:
    """Absurd requests end here rather than in the solver."""
    asked = sum(int(p.count or 1) for p in said.rooms if not p.negated)
    most = max([p.count or 0 for p in said.rooms if not p.negated] + [said.main_rooms or 0], default=0)
    if most > MOST or asked > 3 * MOST:
        raise BadInput(f"the prompt asks for {int(max(most, asked))} rooms; a home of at most {MOST} rooms can be planned")
    for phrase in said.rooms:
        for area in phrase.areas:
            if not 0.5 <= area <= 1000:
                raise BadInput(f"an area of {area:g} m² for a {phrase.type or 'room'} is out of range; give 0.5 to 1000 m²")
    if said.total_area is not None and not 5 <= said.total_area <= 5000:
        raise BadInput(f"a total area of {said.total_area:g} m² is out of range; give 5 to 5000 m²")


def _doors(statements: list[Statement], home: Household) -> _Doors:
    out = _Doors()
    for s in statements:
        left = _entities(s.left, home)
        right = _entities(s.right, home)
        pairs = [(a, b) for a in left for b in right if a is not b and not _served(a, b)]
        match s.kind:
            case "open":
                out.open += pairs
                out.links += pairs
            case "not":
                out.forbidden += pairs
            case "near":
                out.near += [(a, b) for a, b in pairs if a.type in (*OPEN_TYPES, "balcony") and b.type in (*OPEN_TYPES, "balcony")]
            case "share":
                _share(left, right, out, home)
            case "compare" | "equal":
                continue
            case _:
                out.links += pairs
    out.links += out.near
    for e in home.rooms:
        if e.owner is not None:
            out.links.append((e.owner, e))
            if {e.type, e.owner.type} <= set(OPEN_TYPES) and not e.labels & {"adjoining", "separate"}:
                out.open.append((e.owner, e))
    _open_labels(home, out)
    return out


def _served(a: Entity, b: Entity) -> bool:
    """A family bathroom that serves a bedroom has no door to it."""
    bath = a if a.type == "bathroom" else b
    return {a.type, b.type} == {"bathroom", "bedroom"} and bool(bath.labels & {"family", "shared", "guest"})


def _entities(phrases: list[Any], home: Household) -> list[Entity]:
    out: list[Entity] = []
    for phrase in phrases:
        out += [e for e in home.refs.get(id(phrase), []) if e not in out]
    return out


def _every_room(statements: list[Statement], home: Household, doors: _Doors) -> None:
    """`every room opens onto the hallway`, once all rooms are known."""
    for s in statements:
        for some, others in ((s.left, s.right), (s.right, s.left)):
            if s.kind in ("door", "only") and any(p.type == "any" for p in some):
                hubs = _entities(others, home)
                linked = {id(e) for pair in doors.links for e in pair} if any(p.quantifier == "other" for p in some) else set()
                rooms = [e for e in home.rooms if e not in hubs and e.owner is None and e.type not in ("balcony", "closet") and "ensuite" not in e.labels and id(e) not in linked]
                doors.links += [(hub, e) for hub in hubs for e in rooms]


def _share(users: list[Entity], shared: list[Entity], out: _Doors, home: Household) -> None:
    """Bedrooms that share a bathroom: between them where the flat has another one, else off the hallway."""
    if shared and shared[0].type == "bedroom":
        users, shared = shared, users
    users = [u for u in users if u.type == "bedroom"] if shared and shared[0].type == "bathroom" else users
    for room in shared:
        others = [e for e in home.of("bathroom") if e is not room and e.owner is None]
        if room.type == "bathroom" and ("shared_pair" not in room.labels and not others or len(shared) > 1 or len(users) > 3):
            room.labels.add("shared")
            continue
        out.links += [(u, room) for u in users]


def _open_labels(home: Household, out: _Doors) -> None:
    """`open kitchen`, `jack-and-jill bathroom` with nothing more said."""
    opened = [e for e in home.rooms if "open" in e.labels and e.type in OPEN_TYPES]
    if home.open_kitchen:
        opened += home.of("kitchen")
    for entity in opened:
        if any(entity in pair for pair in out.open):
            continue
        order = ("living_room", "dining_room", "kitchen")
        partner = next((e for kind in order for e in home.rooms if e.type == kind and e.type != entity.type), None)
        entity.labels.add("open")
        if partner is not None:
            out.open.append((entity, partner))
            out.links.append((entity, partner))
    for entity in home.rooms:
        if "shared_pair" in entity.labels and not any(entity in pair for pair in out.links):
            beds = [e for e in home.of("bedroom") if "master" not in e.labels]
            beds = (beds if len(beds) > 1 else home.of("bedroom"))[-2:]
            out.links += [(bed, entity) for bed in beds]


def _full_graph(said: Said, home: Household, doors: _Doors) -> bool:
    """Whether the doors said connect all rooms named and make a home of them."""
    if len(home.rooms) < (3 if not said.graph else 2) or not doors.links:
        return _lone(said, home)
    seen, queue = {id(home.rooms[0])}, [home.rooms[0]]
    while queue:
        here = queue.pop()
        for a, b in doors.links:
            there = b if a is here else a if b is here else None
            if there is not None and id(there) not in seen:
                seen.add(id(there))
                queue.append(there)
    kinds = {e.type for e in home.rooms}
    home_like = {"living_room", "kitchen", "bathroom"} <= kinds or not (said.dwelling or home.totals)
    met = all(len(home.of(kind)) == n for kind, n in home.totals.items())
    return len(seen) == len(home.rooms) and home_like and met


def _lone(said: Said, home: Household) -> bool:
    """One or two rooms and no word of a dwelling: exactly those."""
    homely = said.dwelling or home.totals or said.main_rooms or said.total_area or home.banned or len(home.of("bedroom")) > 1
    return len(home.rooms) < 3 and not homely


def _missing(said: Said, home: Household, doors: _Doors) -> None:
    """Rooms a home has even when nobody says so."""
    data = sense()["missing"]
    banned = {kind for kind, label in home.banned if not label}
    if said.dwelling == "studio" and not home.of("bedroom"):
        banned.add("bedroom")
    if said.main_rooms and not home.totals.get("bedroom") and not home.of("bedroom"):
        others = len(home.of("dining_room")) + len(home.of("study"))
        home.add("bedroom", max(said.main_rooms - 1 - others, 0))
        if said.main_rooms == 1:
            said.dwelling = "studio"
            banned.add("bedroom")
    if not home.of("bedroom") and "bedroom" not in banned:
        home.add("bedroom", _bedrooms(said, data))
    for kind in data["always"]:
        if kind not in banned and not (home.of(kind) and kind != "bathroom"):
            _add_missing(kind, home, data)
    if home.of("bedroom") and "hallway" not in banned and not home.of("hallway") and not _around_living(said, home, doors):
        home.add("hallway")
    if not home.of("bedroom"):
        _studio(home)


def _around_living(said: Said, home: Household, doors: _Doors) -> bool:
    """Whether all private rooms have doors to lived-in rooms, so that no hallway is wanted."""
    if said.dwelling == "studio":
        return True
    hubs = [e for s in said.statements for p in (*s.left, *s.right) for e in home.refs.get(id(p), []) if any(q.type == "any" for q in (*s.left, *s.right))]
    if hubs:
        return True

    def served(e: Entity) -> bool:
        near = [b if a is e else a for a, b in doors.links if e in (a, b)]
        return any(n.type in OPEN_TYPES for n in near) or any(n.type == "bedroom" and e.type == "bathroom" for n in near)

    return all(served(e) for kind in ("bedroom", "bathroom") for e in home.of(kind))


def _bedrooms(said: Said, data: dict[str, Any]) -> int:
    if said.total_area is None:
        return int(data["bedrooms"])
    return next(n for most, n in data["bedrooms_from_area"] if said.total_area < most)


def _add_missing(kind: str, home: Household, data: dict[str, Any]) -> None:
    if kind != "bathroom":
        home.add(kind)
        return
    beds = len(home.of("bedroom"))
    have = home.of("bathroom")
    full = [e for e in have if "half" not in e.labels]
    common = [e for e in full if e.owner is None]
    if not have:
        home.add("bathroom", data["bathrooms"][min(beds, len(data["bathrooms"]) - 1)])
    elif "bathroom" not in home.totals and not common and (not full or beds > len({id(e.owner) for e in full})):
        home.add("bathroom")


def _studio(home: Household) -> None:
    """One room to live and sleep in, the kitchen open to it."""
    for living in home.of("living_room")[:1]:
        if not any(c in ("double_bed", "single_bed", "bunk_bed") for c, _ in living.objects) and home.of("bathroom"):
            living.objects.append(("double_bed", 1))
    for kitchen in home.of("kitchen"):
        if "separate" not in kitchen.labels:
            kitchen.labels |= {"open", "small"}


def _ensuites(home: Household, doors: _Doors) -> None:
    """One bathroom serves the home; further full ones, where nothing is said of them, open off bedrooms."""
    def linked(e: Entity) -> bool:
        return any(e in pair for pair in doors.links)

    _open_labels(home, doors)
    beds = [e for e in home.of("bedroom") if not any(r.type == "bathroom" and (r.owner is e or (e, r) in doors.links) for r in home.rooms)]
    beds.sort(key=lambda e: "master" not in e.labels)
    if ("bathroom", "ensuite") in home.banned:
        beds = []
    plain = [e for e in home.of("bathroom") if "half" not in e.labels and e.owner is None and not linked(e)]
    named = [e for e in plain if "ensuite" in e.labels]
    others = [e for e in plain if e not in named and not e.labels & {"family", "shared", "guest", "separate"}]
    serves = len(plain) - len(others) - len(named) + sum(_serves(e, doors) for e in home.of("bathroom"))
    spare = others if serves else others[: len(others) - 1] if len(beds) > 0 else []
    if len(home.of("bedroom")) < 2 and not home.totals.get("bathroom") and not named:
        spare = others[1:] if not serves else others
    for bath, bed in zip([*named, *spare], beds, strict=False):
        bath.owner = bed
        doors.links.append((bed, bath))
    for closet in home.of("closet"):
        if closet.owner is None and not linked(closet) and home.of("bedroom"):
            closet.owner = min(home.of("bedroom"), key=lambda e: "master" not in e.labels)
            doors.links.append((closet.owner, closet))


def _serves(bath: Entity, doors: _Doors) -> bool:
    """Whether a bathroom is entered from elsewhere than a bedroom."""
    near = [b if a is bath else a for a, b in doors.links if bath in (a, b)]
    return "half" not in bath.labels and any(e.type != "bedroom" for e in near)


def _program(said: Said, home: Household, doors: _Doors, complete: bool) -> Program:
    ids = _ids(home)
    rooms = [AskedRoom(id=ids[id(e)], type=e.type, area=None, private_to=_private(e, ids)) for e in _ordered(home)]  # type: ignore[arg-type]

    def pairs(found: list[Pair]) -> list[Link]:
        return sorted({edge(ids[id(a)], ids[id(b)]) for a, b in found})

    banned = set(pairs(doors.forbidden))
    links = [link for link in pairs(doors.links) if link not in banned]
    links = complete_links(rooms, links, banned, set(pairs(doors.near)))
    areas = _areas(said, home, rooms, links, ids)
    style = _style(said)
    return Program(
        rooms=[r.model_copy(update={"area": areas[r.id]}) for r in rooms],
        links=links,
        open_links=[link for link in pairs(doors.open) if link in links],
        weights=style["weights"],
        objects=_objects(said, home, ids),
        counts={ids[id(e)]: e.object_count for e in _ordered(home) if e.object_count is not None},
        total_area=None if said.total_area is None else round(said.total_area, 2),
        regularity=style["regularity"],
        envelope=_envelope(said),
        complete=complete,
        unread=list(dict.fromkeys(said.unread)),
    )


def _ordered(home: Household) -> list[Entity]:
    return sorted(home.rooms, key=lambda e: (ROOM_TYPES.index(e.type), e.type == "bedroom" and "master" not in e.labels))  # type: ignore[arg-type]


def _ids(home: Household) -> dict[int, str]:
    seen: dict[str, int] = {}
    out: dict[int, str] = {}
    for entity in _ordered(home):
        seen[entity.type] = seen.get(entity.type, 0) + 1
        out[id(entity)] = f"{entity.type}_{seen[entity.type]}"
    return out


def _private(entity: Entity, ids: dict[int, str]) -> str | None:
    owner = entity.owner
    return ids[id(owner)] if owner is not None and owner.type == "bedroom" else None


def _areas(said: Said, home: Household, rooms: list[AskedRoom], links: list[Link], ids: dict[int, str]) -> dict[str, float]:
    labels = {ids[id(e)]: e.labels for e in home.rooms}
    base = typical(rooms, links, labels)
    style = _style(said)
    for e in home.rooms:
        base[ids[id(e)]] *= e.factor * (style["hallway"] if e.type == "hallway" else 1.0)
        base[ids[id(e)]] *= style["scale"] * said.flat_size if said.total_area is None else 1.0
    stated = {ids[id(e)]: e.area for e in home.rooms if e.area is not None}
    shares = {ids[id(e)]: e.share for e in home.rooms if e.share is not None and e.area is None}
    _equalise(base, home, ids)
    for statement in said.statements:
        _compare(statement, home, ids, base, stated)
    filled = fill(rooms, base, stated, shares, said.total_area)
    for statement in said.statements:
        if statement.kind == "compare" and said.total_area is not None:
            filled = _compared(statement, home, ids, filled, rooms, stated, shares, said.total_area)
    return filled


def _equalise(base: dict[str, float], home: Household, ids: dict[int, str]) -> None:
    for kind in ROOM_TYPES:
        same = [ids[id(e)] for e in home.of(kind) if "equal" in e.labels]
        base.update(dict.fromkeys(same, sum(base[j] for j in same) / max(len(same), 1)))


def _compare(s: Statement, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]) -> None:
    """`left = number × right`, whichever side is known."""
    left = [ids[id(e)] for e in _entities(s.left, home)]
    right = [ids[id(e)] for e in _entities(s.right, home)]
    if s.kind == "equal":
        base.update(dict.fromkeys(left, sum(base[j] for j in left) / max(len(left), 1)))
    if s.kind != "compare" or not left or not right or s.number <= 0:
        return
    reference = sum(stated.get(j, base[j]) for j in right) / len(right)
    for i in left:
        if i in stated:
            for j in right:
                stated.setdefault(j, stated[i] / s.number)
        elif right[0] in stated:
            stated[i] = reference * s.number
        elif not _holds(base[i] / base[right[0]], s.number):
            _meet(base, left, right, s.number)


def _holds(ratio: float, number: float) -> bool:
    """`larger than` holds for any larger ratio; `twice as large as` only for its own."""
    if number in (1.15, 1.3, 1.6):
        return ratio >= 1.15
    return number in (0.6, 0.75, 0.9) and ratio <= 0.9


def _meet(base: dict[str, float], left: list[str], right: list[str], number: float) -> None:
    """Both sides give way so that their sum stays."""
    a = sum(base[i] for i in left) / len(left)
    b = sum(base[j] for j in right) / len(right)
    small = math.sqrt(a * b / number)
    for j in right:
        base[j] = small if j not in left else base[j]
    for i in left:
        base[i] = small * number


def _compared(
    s: Statement, home: Household, ids: dict[int, str], filled: dict[str, float], rooms: list[AskedRoom],
    stated: dict[str, float], shares: dict[str, float], total: float,
) -> dict[str, float]:  # fmt: skip
    """Unequal stretching must not spoil a comparison: its two sides are fixed to their ratio, the rest refilled."""
    left = [ids[id(e)] for e in _entities(s.left, home)]
    right = [ids[id(e)] for e in _entities(s.right, home)]
    if not left or not right or s.number <= 0 or set(left + right) & set(stated):
        return filled
    both = sum(filled[i] for i in {*left, *right})
    unit = both / (len(left) * s.number + len([j for j in right if j not in left]))
    fixed = dict(stated) | {j: unit for j in right} | {i: unit * s.number for i in left}
    return fill(rooms, filled, fixed, shares, total)


def _style(said: Said) -> dict[str, Any]:
    out: dict[str, Any] = {"weights": {}, "regularity": 0.7, "scale": 1.0, "hallway": 1.0}
    for name in dict.fromkeys(said.styles):
        style = sense()["style"][name]
        for term, factor in style["weights"].items():
            out["weights"][term] = round(out["weights"].get(term, 1.0) * factor, 4)
        out["regularity"] = style.get("regularity", out["regularity"])
        out["scale"] *= style.get("scale", 1.0)
        out["hallway"] *= style.get("hallway", 1.0)
    return out


def _objects(said: Said, home: Household, ids: dict[int, str]) -> list[AskedObjects]:
    wanted: dict[tuple[str, str], int] = {}
    for e in _ordered(home):
        for category, count in e.objects:
            wanted[ids[id(e)], category] = wanted.get((ids[id(e)], category), 0) + count
    for category, count in said.loose_objects:
        homes = [e for kind in (TABLE[category].rooms if category else ()) for e in home.of(kind)]
        if homes:
            key = ids[id(homes[0])], category
            wanted[key] = wanted.get(key, 0) + count
        else:
            said.unread.append(category.replace("_", " ") or f"{count} objects")
    return [AskedObjects(room=room, category=category, count=min(count, 100)) for (room, category), count in wanted.items()]


def _envelope(said: Said) -> Envelope:
    party = [side for role, side in said.sides if role == "party_wall"]
    entrance = next((side for role, side in said.sides if role == "entrance"), None)
    return Envelope(shape=said.shape or "auto", party_walls=list(dict.fromkeys(party)), entrance=entrance)  # type: ignore[arg-type]


def complete_program(program: Program) -> Program:
    """A hand-written programme with its missing areas and, unless it is `complete`, its missing links filled."""
    known = {r.id for r in program.rooms}
    for a, b in [*program.links, *program.open_links]:
        if {a, b} - known:
            raise BadInput(f"program.links names {sorted({a, b} - known)[0]!r}, which is no room of program.rooms; correct the id")
    links = sorted({edge(a, b) for a, b in [*program.links, *program.open_links]})
    rooms = [r.model_copy() for r in program.rooms]
    if not program.complete or (not links and len(rooms) > 1):
        links = complete_links(rooms, links, set())
    base = typical(rooms, links, {})
    stated = {r.id: r.area for r in rooms if r.area is not None}
    areas = fill(rooms, base, stated, {}, program.total_area)
    rooms = [r.model_copy(update={"area": areas[r.id]}) for r in rooms]
    return program.model_copy(update={"rooms": rooms, "links": links})
