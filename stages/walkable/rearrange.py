"""The last resort in a small room: its needed pieces take new places together, as one would plan the room anew."""

from collections.abc import Iterator
from itertools import chain, combinations, islice, product
from typing import NamedTuple

import numpy as np

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.robot import reach
from apartgen.stages.space import boxes, grid
from apartgen.stages.space.boxes import Mask
from apartgen.stages.things import categories
from apartgen.stages.walkable import importance
from apartgen.stages.walkable.blocking import View, rooms
from apartgen.stages.walkable.changes import Repair
from apartgen.stages.walkable.insist import Question, recorded
from apartgen.stages.walkable.kinds import stand_ins
from apartgen.stages.walkable.places import TURN, places
from apartgen.stages.walkable.site import SLACK, Changes, Scene, Site, swapped
from apartgen.stages.walkable.smaller import BUILT_IN
from apartgen.stages.walkable.ways import Ways

SMALL = 8.0
"""Rooms up to this size are planned anew, m²."""
TOGETHER = 3
"""So many pieces take new places at once, at most."""
FIRM = 5
"""Rooms with more needed pieces than this are left as they are."""
TRIES = 12_000
"""Arrangements of a room whose ways are looked at, at most."""
EXACT = 120
"""Those of them that are looked at in full, at most."""
INSTEAD = 2.0
"""Another size or kind counts as this many metres."""


class _Option(NamedTuple):
    """A piece in a place: the changes that bring it there, in order, how far it is, and what it does to the raster.

    `off` are cells that it keeps the robot off; of what opens, `before` are those in front of it, else all cells.
    """

    moves: list[Changes]
    it: Furnishing
    far: float
    off: Mask
    before: Mask


def rearranged(site: Site, now: Ways, here: View) -> Iterator[Repair]:
    """New places for some needed pieces of the target's room together, those that move least first.

    All else in the room stays, unless only without what matters least anything is found.
    """
    question, ranks = Question(site, now, here), importance.Ranks(site, now.scene)
    for room in sorted(rooms(site, now.scene, here.target)):
        own = [o for o in now.scene if o.room == room]
        firm = [o for o in own if ranks.of(o) >= 2 and _movable(o)]
        if site.floors[room].area > SMALL or not 2 <= len(firm) <= FIRM:
            continue
        spare = importance.droppable(site, now.scene, 1) if site.config.drop else []
        loose = importance.at_once([o for o in spare if o.room == room and o not in firm], now.scene, site)
        cases = list(product([[], loose] if loose else [[]], combinations(firm, min(TOGETHER, len(firm)))))
        for gone, some in cases:
            yield from islice(_arrangements(question, gone, some, len(cases)), 1)


def _movable(o: Furnishing) -> bool:
    at_wall = o.category in categories.TABLE and categories.TABLE[o.category].place == "floor"
    return at_wall and o.category not in BUILT_IN and reach.in_the_way(o)


def _arrangements(
    question: Question, gone: list[Furnishing], some: tuple[Furnishing, ...], cases: int
) -> Iterator[Repair]:
    """Arrangements of some pieces that let the robot get to the target, with as little away as will do.

    Of all that may be looked at, this is one case of several.
    """
    here, scene, away = question.here, question.now.scene, question.away
    choices = [_options(question, swapped(scene, away([*gone, *(p for p in some if p is not o)])), o) for o in some]
    rest = [o for o in swapped(scene, away([*gone, *some])) if o.id in here.scene]
    open_cells = here.space.open & (reach.count(here.space, rest) == 0)
    kept = [_before(question, o) for o in rest if o.id == here.target or o.id not in question.now.missed]
    walked = (each for each in _clear(choices, TRIES // cases) if _walked(here, open_cells, kept, each))
    for found in islice(walked, EXACT // cases):
        to = {name: thing for option in found for move in option.moves for name, thing in move.items()}
        if question.answered(gone, to):
            steps = (recorded(o, option.moves, here.target) for o, option in zip(some, found, strict=True))
            yield (*question.least(gone, to), *chain(*steps))


def _options(question: Question, alone: Scene, o: Furnishing) -> list[_Option]:
    """The object where it is and wherever it has room among what stays; then others of its use in other places."""
    site = question.site
    found: list[list[Changes]] = [[], *([move] for move in places(site, alone, o))]
    for other in stand_ins(site, alone, o):
        new = other[o.id]
        assert new is not None
        found += [[other, move] for move in places(site, swapped(alone, other), new)]
    return [_option(question, o, moves) for moves in found]


def _option(question: Question, o: Furnishing, moves: list[Changes]) -> _Option:
    things = {o.id: o} | {name: p for move in moves for name, p in move.items() if p is not None}
    it, space = things[o.id], question.here.space
    turn = TURN * (1 - float(np.cos(it.yaw - o.yaw)))
    far = float(np.hypot(it.center[0] - o.center[0], it.center[1] - o.center[1])) + turn
    off = reach.count(space, list(things.values())) > 0
    return _Option(moves, it, far + INSTEAD * (it.asset != o.asset), off, _before(question, it))


def _before(question: Question, o: Furnishing) -> Mask:
    """Cells in front of what opens, from which it is used; all cells for what does not."""
    space = question.here.space
    cells = np.full(space.grid.shape, not o.joints)
    if o.joints:
        window, zone = reach.standing(o, space.grid, question.site.config.reach, space.radius)
        cells[window] = zone
    return cells


def _clear(choices: list[list[_Option]], most: int) -> Iterator[tuple[_Option, ...]]:
    """One option of each piece such that none stands in another, the least moved first; an even choice of `most`."""
    stood = [boxes.of([option.it for option in options]) for options in choices]
    far = np.zeros([len(options) for options in choices])
    fine = np.ones(far.shape, bool)
    for i, options in enumerate(choices):
        far += np.expand_dims([option.far for option in options], [k for k in range(far.ndim) if k != i])
        for j in range(i):
            apart = boxes.penetration(stood[j], stood[i]) <= SLACK
            fine &= np.expand_dims(apart, [k for k in range(far.ndim) if k not in (i, j)])
    some, order = np.argwhere(fine), np.argsort(far[fine], kind="stable")
    # Near arrangements are much alike; further ones get their turn, too.
    for row in some[order[:: -(-len(order) // most) or 1]].tolist():
        yield tuple(options[k] for options, k in zip(choices, row, strict=True))


def _walked(here: View, open_cells: Mask, kept: list[Mask], some: tuple[_Option, ...]) -> bool:
    """Whether the robot gets in front of all that opens, parts shut: what takes least to look at."""
    free = open_cells.copy()
    for option in some:
        free &= ~option.off
    got = grid.from_seeds(free, here.space.entry)
    return all((got & zone).any() for zone in (*kept, *(option.before for option in some)))
