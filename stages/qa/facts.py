"""What is known of a home and its pictures: names that mean one thing only, what each view shows, distances."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import hypot
from typing import Any

from shapely.geometry import Polygon

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Opening, Room
from apartgen.schemas.render import Render, View
from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.qa.drafts import Draft
from apartgen.stages.qa.marks import MARKED, Marks
from apartgen.stages.qa.whole import WHOLE, before_front, whole
from apartgen.stages.space import boxes, polygons
from apartgen.stages.things import names
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import SMALL, meanings, spoken

CLEARLY = 0.004
"""Share of a picture that a thing must cover to be asked about."""
MOSTLY = 0.6
"""Share of its width and height of which a thing shows at least where one knows it and sees how far it reaches."""
LARGE = 0.025
"""Share of a picture from which one sees into what parts a front is divided."""
LARGER = 0.04
"""The same of a kitchen's units, which stand in line."""
ABOVE = "above"


@dataclass(frozen=True)
class Marked:
    """An object, its number, and the view that it has it in; as text, what it is called there."""

    id: str
    number: int
    view: str

    def __str__(self) -> str:
        return marked(self.number)


def marked(number: int) -> str:
    """What a thing with a number is called."""
    return f"the thing marked {number}"


@dataclass(frozen=True)
class Facts:
    """A furnished home, and views of it."""

    home: Layout
    render: Render
    marks: Marks = field(default_factory=dict)

    @cached_property
    def objects(self) -> dict[str, Box]:
        """Objects by id."""
        return {o.id: o for o in self.home.objects}

    @cached_property
    def rooms(self) -> dict[str, Room]:
        """Rooms by id."""
        return {room.id: room for room in self.home.rooms}

    @cached_property
    def views(self) -> dict[str, View]:
        """Views by name."""
        return {view.name: view for view in self.render.views}

    @cached_property
    def shares(self) -> dict[str, dict[str, float]]:
        """By view, the share of the picture that each object, door and window covers."""
        ids = {thing.number: thing.id for thing in self.render.instances}
        return {name: {ids[part.number]: part.pixels / view.width / view.height for part in view.visible}
                for name, view in self.views.items()}

    @cached_property
    def eyes(self) -> list[View]:
        """Views at the height of eyes."""
        return [view for view in self.render.views if view.kind == "eye"]

    def clear(self, view: str) -> list[Box]:
        """Objects that a view shows clearly."""
        return [self.objects[id] for id, share in self.shares[view].items() if share > CLEARLY and id in self.objects]

    def alone(self, view: str) -> dict[str, Box]:
        """Those of them that nothing else of their name is seen beside, by their name in that picture."""
        meant, known = meanings([self.objects[id] for id in self.shares[view] if id in self.objects]), self.known(view)
        return {f"the {spoken(o.category)}": o for o in self.clear(view) if meant[o.category] == 1 and o.id in known}

    def known(self, view: str) -> set[str]:
        """Ids of objects that are large enough to be named and of which a view shows most."""
        return {id for id in self.uncut(view, MOSTLY) if max(self.objects[id].size) > SMALL
                and not names.hidden(self.objects[id])}

    @cached_property
    def room_names(self) -> dict[str, str]:
        """Rooms that can be spoken of."""
        return names.of_rooms(self.home)

    def type_of(self, room: str) -> str:
        """A room's type in sentences."""
        return names.type_of(self.rooms[room])

    def joined(self, types: Sequence[str]) -> bool:
        """Whether rooms of two of these types lie open to each other, so that it is hard to say where one is."""
        pairs = ({self.type_of(room) for room in o.rooms} for o in self.home.openings
                 if o.kind == "opening" and all(room in self.rooms for room in o.rooms))
        return any(len(pair) == 2 and pair <= set(types) for pair in pairs)

    @cached_property
    def names(self) -> dict[str, str]:
        """Larger objects that can be spoken of."""
        return names.of_objects(self.home, self.room_names)

    @cached_property
    def meanings(self) -> dict[str, int]:
        """By category, how many things of the home its name could mean."""
        return meanings(self.home.objects)

    def stands(self, id: str) -> bool:
        """Whether it stands on the floor and does not lie flat on it, as a rug does."""
        return names.stands(self.objects[id])

    def faces(self, id: str) -> bool:
        """Whether everybody sees where its front is: a bin has none, a bed may have it at either end, and the unit in
        the corner of a kitchen on either side.
        """
        o, kind = self.objects[id], TABLE.get(self.objects[id].category)
        opens = isinstance(o, Furnishing) and bool(o.joints)
        return kind is not None and kind.faces and "sleep" not in kind.uses and (opens or not kind.run)

    def named_in(self, room: str) -> list[str]:
        """Ids of what can be spoken of in a room."""
        return [id for id in self.names if self.objects[id].room == room]

    def pictures(self, ids: Iterable[str], most: int = 4, least: float = CLEARLY) -> list[str]:
        """Fewest views, eyes before others, that show all of these; none where that takes more than `most`."""
        left, chosen = set(ids), list[str]()
        usable = [view.name for view in self.render.views if view.kind in ("eye", "panorama")]
        floor = {name: least if self.views[name].kind == "eye" else least / 4 for name in usable}
        while left and len(chosen) < most:
            shown = {name: {id for id in left if self.shares[name].get(id, 0) > floor[name]} for name in usable}
            best = max(usable, key=lambda name: len(shown[name]), default="")
            if not best or not shown[best]:
                return []
            chosen.append(best)
            left -= shown[best]
        return chosen if not left else []

    def uncut(self, view: str, share: float = WHOLE) -> set[str]:
        """Ids of objects of which a view shows nearly all, or this share, from side to side and from end to end."""
        boxes_of = {thing.number: thing for thing in self.render.instances if thing.box}
        found = set()
        for part in (part for part in self.views[view].visible if part.number in boxes_of):
            o = self.objects.get(boxes_of[part.number].id)
            if o is not None and whole(self.views[view], o, part.rectangle, share):
                found.add(o.id)
        return found

    @cached_property
    def marked(self) -> list["Marked"]:
        """Each object with a number, in the view that shows most of it, of those that show it nearly whole and, of what
        opens, its front.
        """
        best: dict[str, Marked] = {}
        for view, numbers in self.marks.items():
            uncut = {id for id in self.uncut(view) if before_front(self.views[view], self.objects[id])}
            for id, number in ((id, number) for id, number in numbers.items() if id in uncut):
                if id not in best or self.shares[view][id] > self.shares[best[id].view][id]:
                    best[id] = Marked(id, number, view)
        return list(best.values())

    def fine(self, it: "Marked") -> bool:
        """Whether a thing is seen large enough to tell its parts."""
        kind = TABLE.get(self.objects[it.id].category)
        return self.shares[it.view][it.id] > (LARGER if kind is not None and kind.run else LARGE)

    def numbered(self, view: str, text: str, answer: str, evidence: dict[str, Any], wrong: tuple[str, ...] = (), *,
                 number: float | None = None, hard: int = 0, more: Sequence[str] = ()) -> Draft:
        """A question about a view with numbers in it, and about `more` views."""
        return Draft(text, answer, [view + MARKED, *more], evidence, wrong, number, hard, marks=self._pixels(view))

    def _pixels(self, view: str) -> dict[str, tuple[int, int]]:
        """Where in a view the numbers of things are."""
        ids = {thing.number: thing.id for thing in self.render.instances}
        at = {ids[part.number]: part.inmost[:2] for part in self.views[view].visible}
        return {str(number): at[id] for id, number in sorted(self.marks[view].items(), key=lambda one: one[1])}

    def room_pictures(self, room: str) -> list[str]:
        """The panorama of a room."""
        return [view.name for view in self.render.views if view.kind == "panorama" and view.room == room]

    def above(self) -> list[str]:
        """The view from above."""
        return [view.name for view in self.render.views if view.kind == ABOVE]

    def print(self, id: str) -> Polygon:
        """An object's footprint."""
        return boxes.footprints(boxes.of([self.objects[id]]))[0]

    def apart(self, a: str, b: str) -> float:
        """Distance between the nearest points of two objects' boxes, m."""
        flat = float(self.print(a).distance(self.print(b)))
        one, other = self.objects[a], self.objects[b]
        up = abs(one.center[2] - other.center[2]) - (one.size[2] + other.size[2]) / 2
        return hypot(flat, max(0.0, up))

    def passages(self, room: str) -> list[Opening]:
        """Doors and openings of a room."""
        return [o for o in self.home.openings if room in o.rooms and o.kind in polygons.PASSAGES]

    def way(self, start: str, end: str) -> list[Opening] | None:
        """Doors and openings of the only way with fewest of them between two rooms; None where there are several."""
        ways: list[tuple[str, list[Opening]]] = [(start, [])]
        seen = {start}
        while ways:
            done = [way for room, way in ways if room == end]
            if done:
                return done[0] if len(done) == 1 else None
            following = [(next(r for r in o.rooms if r != room), [*way, o]) for room, way in ways
                         for o in self.passages(room) if len(o.rooms) == 2]
            ways = [(room, way) for room, way in following if room not in seen]
            seen |= {room for room, _ in ways}
        return None


def metres(value: float) -> str:
    """A length as it is said."""
    return f"{value:.1f} m"


def centimetres(value: float) -> str:
    """A length below a metre or so as it is said."""
    return f"{5 * round(value * 20)} cm"
