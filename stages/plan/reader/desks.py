"""Where those who work at home do: a study where the rooms are open, a desk for each where there is a place for it."""

from apartgen.stages.plan.reader.about import People
from apartgen.stages.plan.reader.entity import OTHERS, Entity, whose
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.statements import Said
from apartgen.stages.plan.reader.vocabulary import Trait

DESK = "desk"
FOR_TWO = 8.0
"""Floor of a study from which two have their desks in it, m²."""
ASKED_FOR_TWO = 8.5
"""Floor of such a study where nobody gave an area, m²: what is built may be a little less than what is asked for."""
ONE_ROOM = 35.0
"""Floor of a home of one room from which two have a desk in it, m²."""
STUDY_FROM = {1: 60.0}
STUDY_FOR_MORE = 70.0
"""Floor of homes with open rooms from which one who works there has a study, and two."""
ONE_EACH_FROM = 85.0
"""Floor of homes with open rooms from which two who work there have a study each: who calls is heard in one."""
STUDY = 9.0
"""Floor of a study, m²."""
LISTED = 2
"""Rooms that a prompt may name and leave the others open."""


def add_study(said: Said, home: Household) -> None:
    """A study, or two, for those who work at home where a prompt names neither bedrooms nor a list of rooms."""
    many = said.working.count
    if not many or home.of("study") or ("study", "") in home.banned or said.only or _placed(home):
        return
    listed = [e for e in home.rooms if not e.vague and e.type != "balcony"]
    closed = home.of("bedroom") or home.totals.get("bedroom") or said.main_rooms or said.described or said.graph
    if closed or said.dwelling == "studio" or said.about.loft or len(listed) > LISTED:
        return
    if ("bedroom", "") in home.banned or (not home.rooms and not said.dwelling and said.about.people is None):
        return
    if said.total_area is None or said.total_area >= STUDY_FROM.get(many, STUDY_FOR_MORE):
        said.studies_for_work = 2 if many > 1 and (said.total_area or 0.0) >= ONE_EACH_FROM else 1
        home.add("study", said.studies_for_work)


def add_desks(said: Said, home: Household) -> None:
    """A desk for each of those who work at home; those that are asked for in words are theirs."""
    many = _working(said)
    loose = [count for category, count in said.loose_objects if category == DESK]
    if not many or _placed(home) or 0 in loose:
        return
    if loose:
        many = many if DESK in said.uncounted else sum(loose)
        said.loose_objects = [thing for thing in said.loose_objects if thing[0] != DESK]
    left = many
    for room, most in _places(said, home, many):
        here = min(left, most)
        room.objects += [(DESK, here)] if here else []
        left -= here
    if left:
        said.beyond.append((said.working.words, f"no place for {'a desk' if left == 1 else f'{left} desks'} more"))


def desks(room: Entity) -> int:
    """How many stand in a room."""
    return sum(count for category, count in room.objects if category == DESK)


def _working(said: Said) -> int:
    """How many work at home; where all of us do, as many as share the home."""
    people, many = said.about.people, said.working.count
    grown = 2 * people.pairs + people.singles if people is not None else 0
    return max(many, grown) if said.working.everybody else many


def _placed(home: Household) -> bool:
    """Whether a desk is asked for in a room, or none is; one in a child's room is the child's."""
    theirs = [e for e in home.rooms if not e.labels & {Trait.KIDS, Trait.STAFF}]
    return any(category == DESK for e in theirs for category, _ in e.objects)


def _places(said: Said, home: Household, many: int) -> list[tuple[Entity, int]]:
    """Rooms with a place for so many desks, the best first: studies, a bedroom that nobody needs, the main bedroom."""
    studies = [*home.of("study"), *_used_so(said, home)]
    found = [(room, 1 if len(studies) >= many else _holds(room)) for room in studies]
    living = home.of("living_room")
    if not home.of("bedroom"):
        floor = said.total_area or (ONE_ROOM if said.about.loft else sum(e.area or 0.0 for e in living))
        return found + [(room, 2 if floor >= ONE_ROOM else 1) for room in living]
    own = [e for e in sorted(home.of("bedroom"), key=whose) if not e.labels & (OTHERS - {Trait.GUEST})]
    guests = [e for e in own if Trait.GUEST in e.labels]
    own = [e for e in own if e not in guests and e not in studies]
    guests = [e for e in guests if e not in studies]
    people = said.about.people or People()
    if people.singles > 1 and not people.pairs:
        return found + [(room, 1) for room in [*guests, *own[people.singles :], *own[: people.singles], *living]]
    children = 0 if any(Trait.KIDS in e.labels for e in home.of("bedroom")) else people.children
    needed = max(people.pairs + people.singles, 1) + children
    rooms = [*guests, *own[needed:], *own[:1], *living, *own[1 : max(needed - children, 1)], *home.of("dining_room")]
    return found + [(room, 1) for room in rooms]


def _used_so(said: Said, home: Household) -> list[Entity]:
    """Bedrooms that also serve as a study."""
    uses = [wish for wish in said.asked if (wish.kind, wish.value) == ("use", "study")]
    return [e for wish in uses for phrase in wish.of for e in home.refs.get(id(phrase), []) if e.type == "bedroom"]


def _holds(study: Entity) -> int:
    """How many desks a study holds; one without an area becomes large enough for two."""
    return 2 if study.area is None or study.area >= FOR_TWO else 1
