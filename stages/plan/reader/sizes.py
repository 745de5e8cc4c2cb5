"""Areas said, shared and compared, as target areas of all rooms."""

import math

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.plan import AskedRoom, Link
from apartgen.schemas.rooms import kinds
from apartgen.stages.plan.reader.areas import fill, typical
from apartgen.stages.plan.reader.contradict import shares_fit
from apartgen.stages.plan.reader.desks import ASKED_FOR_TWO, desks
from apartgen.stages.plan.reader.doors import entities
from apartgen.stages.plan.reader.household import Household
from apartgen.stages.plan.reader.statements import Asked, Said, Statement
from apartgen.stages.plan.reader.style import style_of
from apartgen.stages.plan.reader.vocabulary import Det, Relation, Trait

SETTLED = 1e-4
"""Part by which areas may change once comparisons hold together."""
CLEARLY = 1.3
"""How much larger than the others the largest room is."""
LIMITS = ("at_least", "at_most")
PASSES = 20
"""How often several comparisons are gone through, for each may spoil the others."""
SHARED = 11.5
"""Floor of a bedroom that two share, as it is asked for, m²: what is built may be a sixth less."""


def areas_told(said: Said, home: Household) -> bool:
    """Whether a prompt says how large rooms are, beyond large and small, or compares them."""
    compared = any(s.kind in (Relation.COMPARE, Relation.EQUAL) for s in said.statements)
    return said.equal or compared or any(e.area is not None or e.share is not None for e in home.rooms)


def room_areas(
    said: Said, home: Household, rooms: list[AskedRoom], links: list[Link], ids: dict[int, str]
) -> dict[str, float]:
    labels = {ids[id(e)]: e.labels for e in home.rooms}
    base = typical(rooms, links, labels) | {ids[id(e)]: area for e in home.rooms if (area := kinds()[e.type].area)}
    style = style_of(said)
    for e in home.rooms:
        base[ids[id(e)]] *= e.factor * (style["hallway"] if e.type == "hallway" else 1.0)
        base[ids[id(e)]] *= style["scale"] * said.flat_size if said.total_area is None else 1.0
    stated = {ids[id(e)]: e.area for e in home.rooms if e.area is not None}
    _for_all(said, home, ids, base, stated)
    shares = {ids[id(e)]: e.share for e in home.rooms if e.share is not None and e.area is None}
    for s in said.statements:
        _share_compared(s, home, ids, shares)
    shares_fit(shares)
    _equalise(base, home, ids)
    of_all = (p.type == "any" for s in said.statements if s.kind == Relation.EQUAL for p in s.left)
    if said.equal or any(of_all):  # "all rooms of the same size": those one lives in, for a bath is no lounge
        alike = [ids[id(e)] for kind in ("living_room", "bedroom", "study") for e in home.of(kind)]
        base.update(dict.fromkeys(alike, sum(base[i] for i in alike) / max(len(alike), 1)))
    _all_compared(said, home, ids, base, stated)
    _extremes(said, home, ids, base, stated)
    filled = _filled(said, rooms, base, stated, shares, [ids[id(e)] for e in home.of("study") if desks(e) > 1])
    for statement in said.statements:
        if statement.kind == Relation.COMPARE and said.total_area is not None:
            filled = _compared(statement, home, ids, filled, rooms, stated, shares, said.total_area)
    return filled


def _filled(
    said: Said, rooms: list[AskedRoom], base: dict[str, float], stated: dict[str, float], shares: dict[str, float],
    for_two: list[str],
) -> dict[str, float]:  # fmt: skip
    """All areas; studies with two desks are large enough for them, unless somebody says how large they are."""
    open_ = [i for i in for_two if i not in stated and i not in shares]
    base |= {i: max(base[i], ASKED_FOR_TWO) for i in open_}
    filled = fill(rooms, base, stated, shares, said.total_area)
    if small := {i: ASKED_FOR_TWO for i in open_ if filled[i] < ASKED_FOR_TWO}:
        stated |= small
        return fill(rooms, base, stated, shares, said.total_area)
    return filled


def _all_compared(
    said: Said, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]
) -> None:
    """All comparisons, again and again where several can hold together; once where they cannot."""
    for statement in said.statements:
        _compare(statement, home, ids, base, stated)
    together = dict(base)
    for k in range(PASSES if sum(s.kind == Relation.COMPARE for s in said.statements) > 1 else 0):
        before = dict(together)
        for statement in said.statements:
            _compare(statement, home, ids, together, stated)
        if all(math.isclose(together[i], before[i], rel_tol=SETTLED) for i in together):
            base.update(together if k else {})
            return


def _for_all(
    said: Said, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]
) -> None:
    """Where more people live than there are bedrooms, so many of these have floor for two, the largest first."""
    people = said.about.people
    if people is None:
        return
    beds = sorted((ids[id(e)] for e in home.of("bedroom")), key=lambda i: -stated.get(i, base[i]))
    for room in beds[: max(people.count - len(beds), people.pairs)]:
        base[room] = max(base[room], SHARED)


def _extremes(
    said: Said, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]
) -> None:
    """`the kitchen should be the largest room`: clearly larger than the others, so that a plan may differ a little."""
    for wish in said.asked:
        rooms = [ids[id(e)] for e in entities(wish.of, home)] if wish.kind == "order" and not wish.to else []
        for room in (r for r in rooms if r not in stated):
            others = [stated.get(i, area) for i, area in base.items() if i not in rooms]
            if wish.value == "largest":
                base[room] = max(base[room], CLEARLY * max(others, default=0.0))
            elif wish.value == "smallest":
                base[room] = min(base[room], min(others, default=base[room]) / CLEARLY)
        if wish.kind == "order" and not isinstance(wish.to, str) and any(p.quantifier == Det.OTHER for p in wish.to):
            _of_its_kind(wish, home, ids, base, stated)


def _of_its_kind(
    wish: Asked, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]
) -> None:
    """`the second bedroom is the largest`: of the bedrooms, with which it changes its usual size."""
    for room in entities(wish.of, home)[:1]:
        own, alike = ids[id(room)], [ids[id(e)] for e in home.of(room.type)]
        most = (max if wish.value == "larger" else min)(alike, key=base.__getitem__)
        if not stated.keys() & {own, most}:
            base[own], base[most] = base[most], base[own]


def _equalise(base: dict[str, float], home: Household, ids: dict[int, str]) -> None:
    for kind in ROOM_TYPES:
        same = [ids[id(e)] for e in home.of(kind) if Trait.EQUAL in e.labels]
        base.update(dict.fromkeys(same, sum(base[j] for j in same) / max(len(same), 1)))


def _share_compared(s: Statement, home: Household, ids: dict[int, str], shares: dict[str, float]) -> None:
    """A room compared with one whose share of the floor is known has a share itself."""
    left = [ids[id(e)] for e in entities(s.left, home)]
    right = [ids[id(e)] for e in entities(s.right, home)]
    if s.kind == Relation.COMPARE and s.number > 0 and len(right) == 1 and right[0] in shares:
        shares |= {i: shares[right[0]] * s.number for i in left if i not in shares}


def _compare(
    s: Statement, home: Household, ids: dict[int, str], base: dict[str, float], stated: dict[str, float]
) -> None:
    """`left = number × right`, whichever side is known."""
    left = [ids[id(e)] for e in entities(s.left, home)]
    right = [ids[id(e)] for e in entities(s.right, home)]
    if s.kind == Relation.EQUAL:
        base.update(dict.fromkeys(left, sum(base[j] for j in left) / max(len(left), 1)))
    if s.kind != Relation.COMPARE or not left or not right or s.number <= 0:
        return
    together = any(p.together for p in s.right)
    reference = sum(stated.get(j, base[j]) for j in right) / (1 if together else len(right))
    for i in left:
        if i in stated:
            for j in right:
                part = base[j] / sum(base[k] for k in right) if together else 1
                if not (s.relation and _holds(stated[i] / reference, s)):
                    stated.setdefault(j, part * stated[i] / s.number)
        elif stated.keys() >= set(right if together else right[:1]):
            stated |= {} if s.relation and _holds(base[i] / reference, s) else {i: reference * s.number}
        elif not _holds(base[i] / (reference if together else base[right[0]]), s):
            _meet(base, left, right, s.number, together)


def _holds(ratio: float, s: Statement) -> bool:
    """`larger than` and `at least twice as large as` hold for any larger ratio; `twice as large as` for none but it."""
    number = s.number
    if s.relation in LIMITS:
        return ratio >= number if s.relation == "at_least" else ratio <= number
    if number in (1.15, 1.3, 1.6):
        return ratio >= 1.15
    return number in (0.6, 0.75, 0.9) and ratio <= 0.9


def _meet(base: dict[str, float], left: list[str], right: list[str], number: float, together: bool) -> None:
    """Both sides give way so that their product stays; rooms that are meant together keep their shares."""
    a = sum(base[i] for i in left) / len(left)
    b = sum(base[j] for j in right) / (1 if together else len(right))
    small = math.sqrt(a * b / number)
    for j in right:
        size = base[j] * small / b if together else small
        base[j] = size if j not in left else base[j]
    for i in left:
        base[i] = small * number


def _compared(
    s: Statement, home: Household, ids: dict[int, str], filled: dict[str, float], rooms: list[AskedRoom],
    stated: dict[str, float], shares: dict[str, float], total: float,
) -> dict[str, float]:  # fmt: skip
    """Unequal stretching must not spoil a comparison: its two sides are fixed to their ratio, the rest refilled."""
    left = [ids[id(e)] for e in entities(s.left, home)]
    right = [ids[id(e)] for e in entities(s.right, home)]
    if not left or not right or s.number <= 0 or set(left + right) & set(stated):
        return filled
    if s.relation in LIMITS and _holds(filled[left[0]] / filled[right[0]], s):
        return filled
    if any(p.together for p in s.right):
        a, b = sum(filled[i] for i in left), sum(filled[j] for j in right)
        small = (a + b) / (len(left) * s.number + 1)
        fixed = dict(stated) | {j: filled[j] * small / b for j in right} | {i: small * s.number for i in left}
        return fill(rooms, filled, fixed, shares, total)
    both = sum(filled[i] for i in dict.fromkeys([*left, *right]))
    unit = both / (len(left) * s.number + len([j for j in right if j not in left]))
    fixed = dict(stated) | {j: unit for j in right} | {i: unit * s.number for i in left}
    return fill(rooms, filled, fixed, shares, total)
