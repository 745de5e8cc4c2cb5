"""The doors a prompt names, between rooms."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.entity import Entity, whose
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.links import ANNEXES
from apartgen.stages.plan.reader.mention import OPEN_TYPES, RoomPhrase
from apartgen.stages.plan.reader.statements import Statement
from apartgen.stages.plan.reader.told import beside_usual, in_passing
from apartgen.stages.plan.reader.vocabulary import EACH_OTHER, OPPOSITE, Det, Relation, Trait

Pair = tuple[Entity, Entity]


@dataclass
class Doors:
    """Doors said and doors forbidden, between entities; `only` are the rooms that are to have no others.

    `near` are neighbours that a door may stand for, `beside` all. A kitchen keeps its usual door beside those of
    `passing`; rooms of `reached` are entered as is said, past rooms that have doors of their own to the hall.
    """

    links: list[Pair] = field(default_factory=list)
    open: list[Pair] = field(default_factory=list)
    forbidden: list[Pair] = field(default_factory=list)
    near: list[Pair] = field(default_factory=list)
    beside: list[Pair] = field(default_factory=list)
    only: list[Entity] = field(default_factory=list)
    passing: list[Pair] = field(default_factory=list)
    reached: list[Entity] = field(default_factory=list)


def doors_said(statements: list[Statement], home: Household) -> Doors:
    out = Doors()
    owned: list[tuple[Entity, set[int]]] = []
    for s in statements:
        left = entities(s.left, home)
        right = entities(s.right, home)
        beds = [e for e in (*left, *right) if e.type == "bedroom"]
        own = s.kind in (Relation.DOOR, Relation.ONLY) and len(beds) == 1  # "the main bath off the main bedroom"
        own = own or (s.kind == Relation.DOOR and bool({"door", "doors"} & set(s.relation.split())))
        pairs = [(a, b) for a in left for b in right if a is not b and (own or not _served(a, b, s.kind))]
        if left and left == right:
            pairs = []  # "the bathroom between the bedrooms, reachable from both"
            pairs = list(zip(left, left[1:], strict=False)) if s.relation == EACH_OTHER else pairs
        in_passing(s, pairs, out)
        match s.kind:
            case Relation.OPEN:
                if {"living_room", "dining_room"} <= {e.type for e in right}:  # in the order in which food travels
                    pairs = [(a, b) for a, b in pairs if not {a.type, b.type} == {"kitchen", "living_room"}]
                out.open += [(a, b) for a, b in pairs if {a.type, b.type} <= set(OPEN_TYPES)]
                out.links += pairs
            case Relation.NOT:
                out.forbidden += pairs
            case Relation.NEAR:
                out.beside += pairs
                out.near += [
                    (a, b)
                    for a, b in pairs
                    if not s.relation.startswith(OPPOSITE)
                    and a.type in (*OPEN_TYPES, "balcony")
                    and b.type in (*OPEN_TYPES, "balcony")
                ]
            case Relation.SHARE:
                _share(left, right, out, home)
            case Relation.OWN:
                out.links += pairs
                owned += [(a, {id(x) for pair in pairs if a in pair for x in pair}) for a in left]
            case Relation.USES if len(left) > 1 and all(e.type == "bathroom" for e in right):
                for room in right:
                    room.labels.add(Trait.SHARED)
            case Relation.COMPARE | Relation.EQUAL:
                continue
            case _:
                pairs = _one_way_in(pairs, s, statements)
                out.only += left if s.kind == Relation.ONLY else []
                out.links += pairs
    for room, theirs in owned:  # "two bathrooms, one of which belongs to the main bedroom"
        out.links = [p for p in out.links if room not in p or {id(p[0]), id(p[1])} <= theirs]
    apart = {id(e) for e in out.only if e.type == "balcony"}  # next to a room, and yet off another one alone
    out.near = [pair for pair in out.near if not apart & set(map(id, pair))]
    out.links += out.near
    beside_usual(out)
    stated = {frozenset((id(a), id(b))) for a, b in out.open}
    for e in home.rooms:
        if e.owner is not None:
            out.links.append((e.owner, e))
            if {e.type, e.owner.type} <= set(OPEN_TYPES) and not e.labels & {Trait.ADJOINING, Trait.SEPARATE}:
                out.open.append((e.owner, e))
    _open_labels(home, out)
    _in_order(out, stated)
    return out


def _in_order(out: Doors, stated: set[frozenset[int]]) -> None:
    """An open kitchen beside one space to live and dine in opens onto where one dines, unless the prompt says else."""
    for a, b in list(out.open):
        kitchen, living = (a, b) if a.type == "kitchen" else (b, a)
        around = [y if x is living else x for x, y in out.open if living in (x, y)]
        dining = next((e for e in around if e.type == "dining_room"), None)
        pair = frozenset((id(a), id(b)))
        if (kitchen.type, living.type) != ("kitchen", "living_room") or dining is None or pair in stated:
            continue
        for pairs in (out.open, out.links):
            pairs[:] = [(kitchen, dining) if {id(x), id(y)} == pair else (x, y) for x, y in pairs]


def _one_way_in(pairs: list[Pair], s: Statement, statements: list[Statement]) -> list[Pair]:
    """`the hall opens into a living-dining-kitchen`: one space needs one door, that of the living room."""
    together = {id(p) for o in statements if o.kind == Relation.OPEN for p in (*o.left, *o.right)}
    joined = {p.type for p in s.right if id(p) in together} if sum(id(p) in together for p in s.right) > 1 else set()
    out = []
    for a, b in pairs:
        order = ("dining_room", "living_room") if a.type == "kitchen" else OPEN_TYPES if a.type == "hallway" else ()
        entry = next((kind for kind in order if kind in joined), b.type)
        out += [(a, b)] if b.type == entry or b.type not in joined else []
    return out


def _served(a: Entity, b: Entity, kind: Relation) -> bool:
    """A family bathroom that serves a bedroom has no door to it; a shared one that is connected to it has."""
    bath = a if a.type == "bathroom" else b
    common = (
        {Trait.FAMILY, Trait.GUEST}
        if Trait.SHARED not in bath.labels
        else {Trait.SHARED}
        if kind in (Relation.SERVE, Relation.USES)
        else set()
    )
    return {a.type, b.type} == {"bathroom", "bedroom"} and bool(bath.labels & common)


def entities(phrases: list[RoomPhrase], home: Household) -> list[Entity]:
    out: list[Entity] = []
    for phrase in phrases:
        out += [e for e in home.refs.get(id(phrase), []) if e not in out]
    return out


def every_room(statements: list[Statement], home: Household, doors: Doors) -> None:
    """`every room opens onto the hallway`, once all rooms are known."""
    for s in statements:
        for some, others in ((s.left, s.right), (s.right, s.left)):
            if s.kind in (Relation.DOOR, Relation.ONLY, Relation.SERVE) and any(p.type == "any" for p in some):
                hubs = entities(others, home)
                excluded = entities([x for p in some for x in p.excluded], home)
                linked = (
                    {id(e) for pair in doors.links for e in pair}
                    if any(p.quantifier == Det.OTHER for p in some)
                    else set()
                )
                rooms = [
                    e
                    for e in home.rooms
                    if e not in [*hubs, *excluded]
                    and e.owner is None
                    and e.type not in ("balcony", "closet")
                    and Trait.ENSUITE not in e.labels
                    and id(e) not in linked
                ]
                doors.links += [(hub, e) for hub in hubs for e in rooms]


def _share(users: list[Entity], shared: list[Entity], out: Doors, home: Household) -> None:
    """Bedrooms that share a bathroom: between them where the flat has another one, else off the hallway."""
    if shared and shared[0].type == "bedroom":
        users, shared = shared, users
    users = [u for u in users if u.type == "bedroom"] if shared and shared[0].type == "bathroom" else users
    for room in shared:
        if room.type in OPEN_TYPES and all(u.type == "bedroom" for u in users):
            continue  # "two sisters' rooms, sharing the kitchen"
        others = [e for e in home.of("bathroom") if e is not room and e.owner is None and Trait.HALF not in e.labels]
        if room.type == "bathroom" and (
            Trait.SHARED_PAIR not in room.labels and not others or len(shared) > 1 or len(users) > 3
        ):
            room.labels.add(Trait.SHARED)
            continue
        out.links += [(u, room) for u in users if u is not room]


def _open_labels(home: Household, out: Doors) -> None:
    """`open kitchen`, `jack-and-jill bathroom` with nothing more said."""
    opened = [e for e in home.rooms if Trait.OPEN in e.labels and e.type in OPEN_TYPES]
    if home.open_kitchen:
        opened += home.of("kitchen")
    for entity in opened:
        if any(entity in pair for pair in out.open):
            continue
        order = ("living_room", "dining_room", "kitchen")
        partner = next((e for kind in order for e in home.rooms if e.type == kind and e.type != entity.type), None)
        entity.labels.add(Trait.OPEN)
        if partner is not None:
            out.open.append((entity, partner))
            out.links.append((entity, partner))
    for entity in home.rooms:
        if Trait.SHARED_PAIR in entity.labels and not any(entity in pair for pair in out.links):
            beds = [e for e in home.of("bedroom") if Trait.MASTER not in e.labels]
            beds = (beds if len(beds) > 1 else home.of("bedroom"))[-2:]
            out.links += [(bed, entity) for bed in beds]


def ensuites(home: Household, doors: Doors) -> None:
    """One bathroom serves the home; further full ones, where nothing is said of them, open off bedrooms."""

    def linked(e: Entity) -> bool:
        others = [pair[pair[0] is e] for pair in doors.links if e in pair]
        return any(o.owner is not e and not _annex(o, e, doors) for o in others)

    _open_labels(home, doors)
    beds = [
        e
        for e in home.of("bedroom")
        if not any(r.type == "bathroom" and (r.owner is e or (e, r) in doors.links) for r in home.rooms)
        and not any(
            (c.owner is e or (e, c) in _ways(doors)) and b.type == "bathroom"
            for c, b in _ways(doors)
            if c.type == "closet"
        )
    ]
    beds.sort(key=whose)
    if ("bathroom", Trait.ENSUITE) in home.banned:
        beds = []
    plain = [e for e in home.of("bathroom") if Trait.HALF not in e.labels and e.owner is None and not linked(e)]
    named = [e for e in plain if Trait.ENSUITE in e.labels]
    others = [
        e for e in plain if e not in named and not e.labels & {Trait.FAMILY, Trait.SHARED, Trait.GUEST, Trait.SEPARATE}
    ]
    others.sort(key=lambda e: any(e in pair for pair in doors.beside))  # "near the bathroom": that which serves all
    serves = len(plain) - len(others) - len(named) + sum(_serves(e, doors) for e in home.of("bathroom"))
    spare = others if serves else others[: len(others) - 1] if len(beds) > 0 else []
    if len(home.of("bedroom")) < 2 and not home.totals.get("bathroom") and not named:
        spare = others[1:] if not serves else others
    for bath, bed in zip(named or spare, beds, strict=False):  # "three bathrooms, one of them ensuite": no other is
        bath.owner = bed
        doors.links.append((bed, bath))
    for closet in home.of("closet"):
        if closet.owner is None and not linked(closet) and home.of("bedroom"):
            closet.owner = min(home.of("bedroom"), key=whose)
            doors.links.append((closet.owner, closet))


def _ways(doors: Doors) -> list[Pair]:
    """Doors in both directions."""
    return [*doors.links, *((b, a) for a, b in doors.links)]


def _annex(room: Entity, bath: Entity, doors: Doors) -> bool:
    """A linen closet is no way into its bathroom; a dressing room of the bedroom's, or off it, is."""
    off = any(a is room and b.type == "bedroom" for a, b in _ways(doors))
    return bath.type == "bathroom" and room.type in ANNEXES and room.owner is None and not off


def _serves(bath: Entity, doors: Doors) -> bool:
    """Whether a bathroom is entered from elsewhere than a bedroom."""
    near = [b if a is bath else a for a, b in doors.links if bath in (a, b)]
    return Trait.HALF not in bath.labels and any(e.type not in ("bedroom", *ANNEXES) for e in near)
