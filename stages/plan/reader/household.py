"""Room phrases resolved to rooms: which mentions are new rooms, which speak of known ones."""

import math

from apartgen.stages.plan.reader.banned import ban
from apartgen.stages.plan.reader.entity import DISTINCT, MOST, PAIRED, Entity
from apartgen.stages.plan.reader.halls import best_named, other_hall, other_study, spoken_of_before
from apartgen.stages.plan.reader.labelled import labelled, told_apart
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.owned import own
from apartgen.stages.plan.reader.ranked import (
    another_one,
    counted_off,
    index_of,
    other_than,
    ranked,
    rest_of,
    sized_otherwise,
)
from apartgen.stages.plan.reader.traits import lay
from apartgen.stages.plan.reader.vocabulary import Det, Trait

BOXES = ("box room", "boxroom")
"""A small bedroom, or in a flat of one bedroom a place for boxes."""


class Household:
    """Rooms in the order of their creation, and what each phrase refers to."""

    def __init__(self, mentions: set[int], asked: set[int] = frozenset()) -> None:  # type: ignore[assignment]
        self.rooms: list[Entity] = []
        self.refs: dict[int, list[Entity]] = {}
        self.totals: dict[str, int] = {}
        self.banned: set[tuple[str, str]] = set()
        self.open_kitchen = False
        self.closed_kitchen = False
        self.mentions, self.asked = mentions, asked
        self.last: list[Entity] = []
        self.group: list[Entity] = []

    def of(self, kind: str) -> list[Entity]:
        """Rooms of a type."""
        return [e for e in self.rooms if e.type == kind]

    def add(self, kind: str, count: int = 1, **traits: object) -> list[Entity]:
        """New rooms."""
        made = [Entity(kind, **traits) for _ in range(max(0, min(count, MOST + 1 - len(self.rooms))))]  # type: ignore[arg-type]
        self.rooms += made
        return made

    def resolve(self, phrase: RoomPhrase) -> list[Entity]:
        """Rooms the phrase refers to, made where needed, with its traits laid on them."""
        if id(phrase) in self.refs:
            return self.refs[id(phrase)]
        if phrase.negated:
            ban(self, phrase)
            self.refs[id(phrase)] = []
            return []
        if phrase.plural and phrase.count is None and len(phrase.areas) > 1:
            phrase.count = float(len(phrase.areas))  # "the bedrooms are 12, 13 and 15 m²"
            counted = [e for e in self.of(phrase.type) if e.area is None and not e.picked]
            again = phrase.quantifier == Det.BARE and not phrase.labels and len(counted) >= phrase.count
            phrase.quantifier = Det.THE if again else phrase.quantifier  # "2 bedrooms. Bedrooms 12 m² and 10 m²"
        for left_out in phrase.excluded:
            self.resolve(left_out)
        before = len(self.rooms)
        excluded = [e for p in phrase.excluded for e in self.refs[id(p)]]
        found = [e for e in self._find(phrase) if e not in excluded]
        for entity in self.rooms[before:]:
            bare, uncounted = phrase.quantifier == Det.BARE, phrase.count is None
            told = id(phrase) in self.asked or bool(phrase.areas and uncounted and not phrase.labels)
            entity.name, entity.spoken = phrase.text, bare and told and uncounted and not phrase.plural
            named = phrase.definite or (bare and (id(phrase) in self.mentions or phrase.plural))
            entity.vague = bool(phrase.ordinals) or (uncounted and named)
        lay(phrase, found)
        for entity in found if id(phrase) in self.asked else []:
            entity.placed = True
        self.refs[id(phrase)] = found
        if len(found) > 1:
            self.group = found
        elif found and phrase.quantifier == Det.THE and phrase.type in ("bedroom", "bathroom"):
            found[0].picked = found[0].picked or found[0] in self.group  # "the bathroom off the hall …, the other …"
        self.last = found or self.last
        if Trait.SUITE in phrase.labels and not any(o.type == "bathroom" for o in phrase.owned):
            phrase.owned.append(RoomPhrase("bathroom", {Trait.ENSUITE}, quantifier=Det.EACH))
        for owned in phrase.owned:
            own(self, owned, found, phrase.quantifier in PAIRED)
        return found

    def _find(self, phrase: RoomPhrase) -> list[Entity]:
        if phrase.type == "any" or phrase.quantifier == Det.NONE:
            return []
        if phrase.type == "":
            return self._ellipsis(phrase)
        if Trait.HALLS in phrase.labels:  # Chinese counts of halls: a living room, then a dining room
            made = self.ensure("living_room", min(int(phrase.count or 1), 1))
            return made + (self.ensure("dining_room", 1) if (phrase.count or 1) > 1 else [])
        if phrase.rank and phrase.whole and phrase.type not in self.totals and len(self.of(phrase.type)) < 2:
            self.ensure(phrase.type, phrase.whole)
        if found := ranked(phrase, self.of(phrase.type)):
            return found
        if phrase.headline and phrase.count is not None:
            return self._headline(phrase)
        if phrase.text in BOXES and self.totals.get("bedroom") == 1:
            phrase.type, phrase.labels = "storage", set()  # "1-bed flat with a box room": no second place to sleep
            return self.add("storage")
        if phrase.ordinals and (who := phrase.labels & {Trait.KIDS, Trait.GUEST}) and phrase.type not in self.totals:
            return self._among(phrase, who)
        if phrase.ordinals:
            self.ensure(phrase.type, max(1, *phrase.ordinals))
            return counted_off(self.of(phrase.type), phrase.ordinals)
        if phrase.quantifier in (*PAIRED, Det.ONE_OF, Det.OTHER) or (phrase.quantifier == Det.THE and phrase.count):
            return self._partitive(phrase)
        labels = phrase.labels & set(DISTINCT)
        if labels:
            return labelled(self, phrase, labels)
        return self._plain(phrase)

    def _among(self, phrase: RoomPhrase, labels: set[Trait]) -> list[Entity]:
        """`a second children's bedroom`: the second of those; `the second bedroom is a guest room`: that of all."""
        most, rooms = max(phrase.ordinals), self.of(phrase.type)
        known = [e for e in rooms if labels & e.labels]
        which = phrase.quantifier == Det.THE or phrase.text == phrase.type  # "bedroom 2 is a nursery"
        known = rooms if which and len(known) < most <= len(rooms) else known
        return counted_off(known + self.add(phrase.type, most - len(known)), phrase.ordinals)

    def _headline(self, phrase: RoomPhrase) -> list[Entity]:
        count = math.ceil(phrase.count or 0)
        self.totals |= {} if Trait.KIDS in phrase.labels and not phrase.text.isascii() else {phrase.type: count}
        found = self.ensure(phrase.type, count, counted=True)
        self._half(phrase, found)
        return found

    def _half(self, phrase: RoomPhrase, found: list[Entity]) -> None:
        if phrase.type == "bathroom" and phrase.count and phrase.count % 1 and found:
            found[-1].labels.add(Trait.HALF)

    def ensure(self, kind: str, count: int, counted: bool = False) -> list[Entity]:
        """At least `count` rooms of a type; all of them."""
        self.add(kind, count - len(self.of(kind)))
        for entity in self.of(kind):
            entity.counted = entity.counted or counted
        return self.of(kind)

    def _ellipsis(self, phrase: RoomPhrase) -> list[Entity]:
        pool = [e for p in phrase.among for e in self.refs.get(id(p), [])] or self.group or self.last
        if not pool:
            return []
        phrase.type = pool[0].type
        if sized_otherwise(phrase, self.of(phrase.type), self.totals.get(phrase.type)):
            return self.add(phrase.type, int(phrase.count or 1))  # "a big bedroom and a small one"
        if other_than(phrase, pool, self.of(phrase.type)):
            pool[0].picked = True
            return self.add(phrase.type)  # "one bedroom has a balcony, the other a closet"
        alike = any(e.rank == phrase.rank and e not in pool for e in self.of(phrase.type))
        if phrase.rank and (alike or all(e.rank and e.rank != phrase.rank for e in pool)):
            pool = self.of(phrase.type)  # "the two smaller bedrooms share a bath, the largest has its own"
        if found := ranked(phrase, pool if len(pool) > 1 else self.of(phrase.type)):
            return found
        rest = self.of(phrase.type) if phrase.count and phrase.quantifier == Det.BARE else []
        free = [e for e in pool if not e.picked] or [e for e in rest if not e.picked] or pool
        free = [e for e in free if e.owner is None or e.type != "bathroom"] or free  # "one in the bedroom, another …"
        if another_one(phrase, pool):
            return [e for e in self.of("bedroom") if e is not pool[0] and not e.picked][:1] or self.add("bedroom")
        sized = bool(phrase.areas) and pool[0].area is not None and phrase.quantifier == Det.BARE
        if len(pool) == 1 and (phrase.another or sized) and phrase.count:
            return self.add(phrase.type, int(phrase.count))  # "a bedroom for the parents and one for the kids"
        if phrase.quantifier == Det.ANOTHER and not phrase.count:
            return self.add(phrase.type)
        if phrase.quantifier == Det.OTHER and phrase.count:
            rest = [e for e in self.of(phrase.type) if not e.picked and (e not in self.last or len(pool) > 1)]
            found = (rest + self.add(phrase.type, int(phrase.count) - len(rest)))[: int(phrase.count)]
        elif phrase.quantifier in PAIRED and not phrase.count:
            found = pool
        elif phrase.quantifier == Det.OTHER and not phrase.count:
            found = free
        elif phrase.ordinals:
            several = 1 < len(pool) >= max(phrase.ordinals)
            whole = pool if several else self.ensure(phrase.type, max(phrase.ordinals))
            found = [whole[index_of(n)] for n in phrase.ordinals]
        else:
            found = free[-int(phrase.count or 1) :] if phrase.factor < 1 else free[: int(phrase.count or 1)]
        for entity in found if phrase.quantifier not in PAIRED else []:
            entity.picked = True
        if Trait.MAYBE_ENSUITE in phrase.labels:
            phrase.labels = {Trait.ENSUITE} if phrase.type == "bathroom" else set()
            phrase.owned += (
                [] if phrase.type == "bathroom" else [RoomPhrase("bathroom", {Trait.ENSUITE}, quantifier=Det.EACH)]
            )
        return found

    def _partitive(self, phrase: RoomPhrase) -> list[Entity]:
        labels = phrase.labels & {Trait.MASTER, Trait.GUEST, Trait.KIDS}
        self.ensure(phrase.type, phrase.whole or 0)
        known = [e for e in self.of(phrase.type) if not labels or labels & e.labels]
        if phrase.quantifier in (Det.ONE_OF, Det.OTHER):
            if phrase.quantifier == Det.OTHER and phrase.count:
                rest = [e for e in known if not e.picked and e not in self.last]
                self.add(phrase.type, int(phrase.count) - len(rest))
            known = known or self.of(phrase.type)
            single = len(known) == 1 and (known[0].owner is not None or phrase.type not in self.totals)
            if phrase.quantifier == Det.OTHER and not phrase.plural and single:
                known += self.add(phrase.type)  # "the main bedroom has its own bath, the other bath is off the hall"
            whole = self.ensure(
                phrase.type, int(phrase.count or 2) if phrase.quantifier == Det.ONE_OF else max(len(known), 1)
            )
            self.group = whole if phrase.quantifier == Det.ONE_OF and len(whole) > 1 else self.group
            whole = [e for e in whole if e.owner is None] or whole if phrase.type == "bathroom" else whole
            free = [e for e in whole if not e.picked and (phrase.quantifier == Det.ONE_OF or e not in self.last)]
            many = phrase.quantifier == Det.OTHER and (phrase.plural or phrase.count)
            small = not many and phrase.factor < 1
            found = free[-1:] if small and free else (free or whole[-1:])[: int(phrase.count or MOST) if many else 1]
            for entity in found:
                entity.picked = True
            return found
        count = int(phrase.count or (2 if phrase.quantifier == Det.BOTH else 0))
        if labels and not known:
            count = max(count, 2 if phrase.plural else 1)
            free = [e for e in self.of(phrase.type) if e.counted and not e.picked and not e.labels & set(DISTINCT)]
            return free[-count:] if len(free) >= count else self.add(phrase.type, count, labels=set(labels))
        if phrase.quantifier == Det.THE and len(known) > count > 0:
            free = [e for e in known if not e.picked and not e.labels & set(DISTINCT)]
            return (free if len(free) >= count else known)[:count]
        least = 2 if phrase.type == "bedroom" and phrase.quantifier in PAIRED else 1  # "each bedroom" of a home unsaid
        counted = phrase.quantifier == Det.ALL and count > 1
        return known if labels else self.ensure(phrase.type, max(count, len(known) or least), counted)

    def _plain(self, phrase: RoomPhrase) -> list[Entity]:
        known = self.of(phrase.type)
        mentioned = id(phrase) in self.mentions
        if phrase.quantifier == Det.ANOTHER:
            if rest := rest_of(phrase, known):
                return rest  # "three-bed flat: a main bedroom with ensuite, two further bedrooms"
            free = [e for e in known if e.area is None] if phrase.areas and phrase.type in self.totals else []
            found = free[:1] or self.add(phrase.type, int(phrase.count or 1))
            found[0].picked = found[0].picked or (mentioned and phrase.type == "bedroom")  # "… next to our bedroom"
            return found
        if phrase.count == len(known) > 1 and any(e.picked for e in known) and not (phrase.definite or phrase.another):
            return known  # "one bedroom has a balcony, the other a closet. Two bedrooms."
        plain = mentioned or phrase.count in (None, 1)
        spoken = [e for e in known if e.spoken and phrase.count == 1 and len(known) == 1]
        vague = spoken or [e for e in known if e.vague and not (plain and e.labels & set(DISTINCT))]
        if vague and not phrase.definite and (phrase.count is not None or not mentioned):
            for entity in vague:
                entity.vague = False
            count = math.ceil(phrase.count or 1)
            return vague[:count] + self.add(phrase.type, count - len(vague))
        if phrase.count is None:
            return self._uncounted(phrase, known, mentioned)
        count = math.ceil(phrase.count)
        of_those = id(phrase) in self.asked and len(known) > count > 1 and not any(e.placed for e in known)
        two = phrase.type == "bedroom" and id(phrase) in self.asked and all(e.placed for e in known)
        if phrase.type in self.totals or (mentioned and len(known) >= count and not two) or of_those:
            free = [e for e in known if not e.picked] or known
            if count >= len(known):
                return self.ensure(phrase.type, count)
            for entity in free[:count]:
                entity.picked = True
            return free[:count]
        if phrase.type == "bathroom" and count > 1 and any(e.owner for e in known):
            found = self.ensure(phrase.type, count, counted=True)
        else:
            found = self.add(phrase.type, count, counted=count > 1)
        self._half(phrase, found)
        return found

    def _uncounted(self, phrase: RoomPhrase, known: list[Entity], mentioned: bool) -> list[Entity]:
        if phrase.plural or phrase.quantifier == Det.SEVERAL:
            few = 3 if phrase.quantifier == Det.SEVERAL else 1 if phrase.type == "hallway" else 2
            return known if len(known) > 1 else self.ensure(phrase.type, few)
        single = phrase.type in ("living_room", "kitchen", "dining_room", "hallway")
        refers = phrase.quantifier == Det.THE or (
            mentioned and (single or phrase.quantifier == Det.BARE or phrase.type in self.totals)
        )
        refers = refers or (single and not phrase.text.isascii())  # languages without articles
        apart = bool(known) and all(e.labels & {Trait.GUEST, Trait.KIDS} for e in known)
        if phrase.type == "bedroom" and not mentioned and apart:
            return self.add(phrase.type)  # "a guest room besides our bedroom"
        if (told := told_apart(phrase, known)) is not None:
            return told or self.add(phrase.type)
        if other_hall(phrase, known, mentioned) or other_study(phrase, known):
            return self.add(phrase.type)
        known = best_named(phrase, known)
        if spoken_of_before(phrase, known):
            free = [e for e in known if not e.picked] or known
            free[0].picked = free[0].picked or phrase.type == "bedroom"
            return free[:1]
        private = bool(known) and all(e.labels & {Trait.ENSUITE, Trait.HALF} for e in known)
        if phrase.type == "bathroom" and mentioned and private:
            return self.add(phrase.type)
        if known and refers:
            free = [e for e in known if e.owner is None] or known
            free = [e for e in free if Trait.HALF not in e.labels] or free  # "the bathroom" is not the guests' WC
            last = [e for e in self.last if e in free]
            return (last or ([e for e in free if not e.picked] or free))[:1]
        if known and phrase.subset:
            return [e for e in known if not e.picked][:1] or known[:1]
        if phrase.type in self.totals and known:
            return [e for e in known if e.owner is None and not e.picked][:1] or known[:1]
        return self.add(phrase.type)
