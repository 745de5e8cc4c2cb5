"""What must stay and is in the way: another place or a stand-in for it, in the end at the cost of lesser things."""

from collections.abc import Iterator
from typing import NamedTuple

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.robot import reach
from apartgen.stages.walkable import importance
from apartgen.stages.walkable.blocking import View
from apartgen.stages.walkable.changes import Change, Repair, dropped, nudged, replaced
from apartgen.stages.walkable.kinds import stand_ins
from apartgen.stages.walkable.places import places
from apartgen.stages.walkable.site import Changes, Scene, Site, fits, swapped
from apartgen.stages.walkable.ways import Ways, after


class Question(NamedTuple):
    """Whether a repair of a scene lets the robot get to the view's target, and to no less than before."""

    site: Site
    now: Ways
    here: View

    def answered(self, gone: list[Furnishing], to: Changes) -> bool:
        """Whether `to` does it with some objects away."""
        away = self.away(gone)
        if not self.here.reaches(away | to):
            return False
        rest = swapped(self.now.scene, away)
        return fits(self.site, rest, to) and after(self.site, self.now, away | to).missed < self.now.missed

    def away(self, gone: list[Furnishing]) -> Changes:
        """The objects and what stands on them taken away."""
        return {name: None for o in gone for name in dropped(o, self.now.scene, "").to}

    def least(self, gone: list[Furnishing], to: Changes) -> Iterator[Change]:
        """What has to go for `to`: those of `gone` without whose leaving it would not do."""
        least = gone
        for less in reversed(gone):
            fewer = [p for p in least if p is not less]
            if self.answered(fewer, to):
                least = fewer
        return (dropped(p, self.now.scene, self.here.target) for p in least)


def making_room(site: Site, now: Ways, here: View, able: list[Furnishing]) -> Iterator[Repair]:
    """Repairs that keep what must stay, the fewer and lesser things go for them the earlier.

    `able`: objects that may help by themselves; others are looked at once the lesser things are away.
    """
    question, ranks, alone = Question(site, now, here), importance.Ranks(site, now.scene), {o.id for o in able}
    firm = sorted((o for o in here.scene.values() if (o.id in alone or reach.in_the_way(o)) and ranks.of(o) >= 2),
                  key=ranks.of)
    near = [o for o in importance.droppable(site, now.scene, 2) if o.room in here.rooms] if site.config.drop else []
    tried = set[tuple[str, ...]]()
    for most in (-1, 0, 1, 2):
        for o in firm:
            less = [p for p in near if ranks.of(p) <= min(most, ranks.of(o) - 1) and p.id != o.id]
            loose = importance.at_once(less, now.scene, site)
            names = (o.id, *(p.id for p in loose))
            if names in tried:
                continue
            tried.add(names)
            # What is in the way only together with what goes first may be what has to move.
            if o.id in alone or loose and here.reaches(question.away(loose) | {o.id: None}):
                yield from _first(question, o, loose)


def _first(question: Question, o: Furnishing, loose: list[Furnishing]) -> Iterator[Repair]:
    """The first stand-in or place for an object once `loose` is away, with as little of that away as will do."""
    rest = swapped(question.now.scene, question.away(loose))
    for moves in _options(question.site, rest, o, bool(loose)):
        to = {name: thing for move in moves for name, thing in move.items()}
        if question.answered(loose, to):
            yield (*question.least(loose, to), *recorded(o, moves, question.here.target))
            return


def _options(site: Site, scene: Scene, o: Furnishing, moved: bool) -> Iterator[list[Changes]]:
    """Other places for an object (unless these were tried), stand-ins where it is, and those in other places."""
    if moved:
        yield from ([move] for move in places(site, scene, o))
    for other in stand_ins(site, scene, o):
        new = other[o.id]
        assert new is not None
        yield [other]
        yield from ([other, move] for move in places(site, swapped(scene, other), new))


def recorded(o: Furnishing, moves: list[Changes], target: str) -> Iterator[Change]:
    """The changes of an object that take it through some moves, in order."""
    for to in moves:
        new = to[o.id]
        assert new is not None
        yield (nudged if new.asset == o.asset else replaced)(o, to, target)
        o = new
