"""What a film shows when, as far as that is beyond doubt."""

from typing import NamedTuple

from apartgen.schemas.render import Film
from apartgen.stages.qa.facts import Facts

FAINT, CLEAR = 0.0005, 0.006
"""Shares of a frame: below the first nobody sees a thing, above the second everybody does."""
HELD = 0.6
"""How long it is clear before it counts as seen, s."""
APART = 0.4
"""Between that and the first glimpse of what comes after, s."""


class Sight(NamedTuple):
    """Seconds in a film: of the first glimpse of a thing, and when it has been seen clearly for `HELD`."""

    since: float
    clear: float


def sights(facts: Facts, film: Film) -> dict[str, Sight]:
    """When each thing that can be spoken of is first seen; those that never are clearly are left out."""
    numbers = {thing.number: thing.id for thing in facts.render.instances if thing.id in facts.names}
    shares: dict[str, list[float]] = {id: [0.0] * len(film.frames) for id in numbers.values()}
    for k, frame in enumerate(film.frames):
        for number, pixels in frame.visible:
            if number in numbers:
                shares[numbers[number]][k] = pixels / film.width / film.height
    held = max(1, round(HELD * film.rate))
    found = {}
    for id, row in shares.items():
        clear = next((k for k in range(len(row) - held) if min(row[k:k + held + 1]) > CLEAR), None)
        if clear is not None:
            since = next(k for k, share in enumerate(row) if share > FAINT)
            found[id] = Sight(film.frames[since].seconds, film.frames[clear + held].seconds)
    return found


def in_order(sights: list[Sight]) -> bool:
    """Whether each is clear before there is a glimpse of the next."""
    return all(a.clear + APART <= b.since for a, b in zip(sights, sights[1:]))


def stays(film: Film) -> list[tuple[str, float, float]]:
    """Rooms in the order in which the camera is in them, with the seconds from which and to which it is."""
    found: list[tuple[str, float, float]] = []
    for frame in film.frames:
        if found and found[-1][0] == frame.room:
            found[-1] = (frame.room, found[-1][1], frame.seconds)
        else:
            found.append((frame.room, frame.seconds, frame.seconds))
    return found
