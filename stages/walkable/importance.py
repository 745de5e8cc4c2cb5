"""Which objects a home misses least."""

from collections import Counter
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from apartgen.schemas.plan import Room
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.schemas.rooms import kinds
from apartgen.stages.space import footprints
from apartgen.stages.things import categories
from apartgen.stages.things.carrying import carried
from apartgen.stages.things.rooms import furnishing
from apartgen.stages.walkable.site import Need, Scene, Site

KEPT = ("sleep", "relieve", "wash", "bathe", "rinse", "cook", "fry", "cool")
"""Uses of furniture of which the last is given up in no room; `rooms.toml` has more for some types of room."""
DECORATION = categories.those(lambda kind: kind.matters == "little")
ESSENTIAL = categories.those(lambda kind: kind.matters == "much")
"""Without the only one of these a room does not do what it is for."""
MAIN = categories.those(lambda kind: kind.is_for("sleep", "lounge") and kind.matters == "much")
"""What a home is furnished around: made smaller only after what it can spare has gone."""
CABINETS = categories.those(lambda kind: kind.is_for("store") and not kind.run and kind.place == "floor")
STANDARD = categories.those(lambda kind: kind.standard)
"""Comes in few sizes, or in those of what it belongs to: changed last."""


def easily_smaller(o: Furnishing) -> bool:
    """Whether people would readily have a smaller one: what stands on the floor and has no standard size."""
    upright = o.category not in categories.TABLE or categories.TABLE[o.category].place == "floor"
    return upright and o.category not in STANDARD


def anything(scene: Scene) -> frozenset[str]:
    """Every object of a scene, by id."""
    return frozenset(o.id for o in scene)


def decoration(scene: Scene) -> frozenset[str]:
    """What is missed least: lamps, plants, pouffes, side tables, benches."""
    return frozenset(o.id for o in scene if o.category in DECORATION)


def surplus_cabinets(scene: Scene) -> frozenset[str]:
    """All that stores things on the floor of a room but its largest piece."""
    own: dict[str, list[Furnishing]] = {}
    for o in scene:
        if o.category in CABINETS:
            own.setdefault(o.room, []).append(o)
    ordered = (sorted(some, key=lambda o: (-footprints.area(o), o.id)) for some in own.values())
    return frozenset(o.id for some in ordered for o in some[1:])


def needs(home: Retrieve) -> tuple[Need, ...]:
    """What the rooms of a home keep; of what it does not have, nothing."""
    found = []
    for room in home.rooms:
        own = [o.category for o in home.objects if o.room == room.id]
        for use, count in (*((use, 1) for use in KEPT), *_keeps(room)):
            of = categories.used_for(use)
            if has := sum(category in of for category in own):
                found.append(Need(room.id, of, min(has, count)))
    return tuple(found)


def _keeps(room: Room) -> Iterable[tuple[str, int]]:
    """Uses that the room's type is for, with how many things of each it keeps."""
    return furnishing(room.type if room.type in kinds() else room.base).keeps.items()


@dataclass(frozen=True)
class Ranks:
    """How much each object of a scene matters: 0 decoration, 1 comfort, 2 essential, 3 vital.

    Of several alike, each is comfort at most.
    """

    site: Site
    scene: Scene

    @cached_property
    def _alike(self) -> Counter[tuple[str, str]]:
        """How many of each category stand in each room, with what does for it."""
        return Counter((o.room, _serves(o)) for o in self.scene)

    @cached_property
    def _short(self) -> frozenset[tuple[str, str]]:
        """Rooms and categories of which none can be spared."""
        count = Counter((o.room, o.category) for o in self.scene)
        return frozenset((need.room, category) for need in self.site.needs for category in need.of
                         if sum(count[need.room, one] for one in need.of) <= need.least)

    def of(self, o: Furnishing) -> int:
        """The rank of an object."""
        if (o.room, o.category) in self._short:
            return 3
        if o.category in DECORATION:
            return 0
        alone = self._alike[o.room, _serves(o)] <= 1
        return 1 + alone if o.category in ESSENTIAL else int(alone)


def _serves(o: Furnishing) -> str:
    return categories.TABLE[o.category].serves if o.category in categories.TABLE else o.category


def asked(some: Collection[Furnishing], scene: Scene, site: Site) -> bool:
    """Whether the prompt asked for some of these: their rooms' numbers of objects, or so many of a category that the
    others do not make up.
    """
    gone = Counter((o.room, o.category) for o in some)
    if any(room in site.program.counts for room, _ in gone):
        return True
    wishes = [wish for wish in site.program.objects if gone[wish.room, wish.category]]
    left = Counter((o.room, o.category) for o in scene) - gone if wishes else gone
    return any(left[wish.room, wish.category] < wish.count for wish in wishes)


def _spared(o: Furnishing, scene: Scene, site: Site) -> bool:
    """Whether nobody asked for it, nor for what stands on it and would go along."""
    return not asked([o, *carried(o, scene)], scene, site)


def at_once(loose: Sequence[Furnishing], scene: Scene, site: Site) -> list[Furnishing]:
    """Of what may go each by itself the first that may go together: of two lamps of which one was asked for, one."""
    gone: dict[str, Furnishing] = {}
    kept = []
    for o in loose:
        more = gone | {p.id: p for p in (o, *carried(o, scene))}
        if not asked(more.values(), scene, site):
            gone = more
            kept.append(o)
    return kept


def droppable(site: Site, scene: Scene, most: int = 1) -> list[Furnishing]:
    """Obstacles up to a rank that may be left out, the least important first, large before small.

    What the prompt asked for never is, nor what carries it, nor what is vital.
    """
    ranks, most = Ranks(site, scene), min(most, 2)
    loose = [o for o in scene if footprints.is_obstacle(o) and ranks.of(o) <= most and _spared(o, scene, site)]
    return sorted(loose, key=lambda o: (ranks.of(o), -footprints.area(o), o.id))


def sparable(some: Sequence[Furnishing], scene: Scene, site: Site) -> list[Furnishing]:
    """Of some objects those that a room does without and nobody asked for, the least important first.

    A seat goes before the table that it belongs to, but after anything else that matters as little.
    """
    ranks, pair = Ranks(site, scene), len(some) == 2 and categories.tucks(*(o.category for o in some))
    loose = [o for o in some if ranks.of(o) <= 1 and _spared(o, scene, site)]
    return sorted(loose, key=lambda o: (
        0 if pair else ranks.of(o), (o.category in categories.SEATS) != pair, footprints.area(o), o.id))
