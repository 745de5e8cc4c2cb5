"""Common sense about what a room holds: least, most, and never without (`sense.toml`)."""

import tomllib
from collections import Counter
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages.things.categories import CATEGORIES, TABLE

RULES = Path(__file__).parent / "sense.toml"
BARRED = -30.0
ASKED = 1e3
"""What it costs, in units of logits, to take the slot of something that was asked for."""
Logits = NDArray[np.float32]


@dataclass(frozen=True)
class Sense:
    """Rules by class index: least and kept groups of every room type, (number, group) at most, class → companions,
    (class, guest, number of guests at least)."""

    least: tuple[tuple[tuple[int, ...], ...], ...]
    keep: tuple[tuple[tuple[int, ...], ...], ...]
    most: tuple[tuple[int, tuple[int, ...]], ...]
    needs: tuple[tuple[int, tuple[int, ...]], ...]
    company: tuple[tuple[int, int, int], ...]


@cache
def sense() -> Sense:
    """The rules of `sense.toml`."""
    table = tomllib.loads(RULES.read_text())

    def indices(names: list[str]) -> tuple[int, ...]:
        return tuple(CATEGORIES.index(name) for name in names)

    def by_room(rule: str) -> tuple[tuple[tuple[int, ...], ...], ...]:
        return tuple(tuple(indices(group) for group in table[rule].get(kind, [])) for kind in ROOM_TYPES)

    return Sense(
        by_room("least"),
        by_room("keep"),
        tuple((int(number), indices(group)) for number, groups in table["most"].items() for group in groups),
        tuple((CATEGORIES.index(name), indices(group)) for name, group in table["needs"].items()),
        tuple(
            (CATEGORIES.index(host), CATEGORIES.index(guest), int(number))
            for host, guests in table["company"].items()
            for guest, number in guests.items()
        ),
    )


def essentials(categories: list[str], kind: str, wishes: Counter[str]) -> frozenset[int]:
    """Indices of what a room of a type cannot be without.

    One of each least or kept group, what was wished for, and the only thing that others there are of use with.
    """
    found: set[int] = set()
    for category, number in wishes.items():
        found.update([i for i, name in enumerate(categories) if name == category][:number])
    room = ROOM_TYPES.index(kind)
    for group in sense().least[room] + sense().keep[room]:
        names = {CATEGORIES[c] for c in group}
        found.update([i for i, name in enumerate(categories) if name in names][:1])
    for dependent, companions in sense().needs:
        if CATEGORIES[dependent] in categories and TABLE[CATEGORIES[dependent]].place == "floor":
            names = {CATEGORIES[c] for c in companions}
            found.update([i for i, name in enumerate(categories) if name in names][:1])
    return frozenset(found)


@cache
def at_home() -> NDArray[np.bool_]:
    """Which classes belong in a room of each type, (types, C+1); an empty slot does anywhere."""
    never = tomllib.loads(RULES.read_text())["never"]
    table = np.array(
        [[kind in TABLE[name].rooms and name not in never.get(kind, ()) for name in CATEGORIES] for kind in ROOM_TYPES]
    )
    return np.pad(table, ((0, 0), (0, 1)), constant_values=True)


def settle(logits: Logits, kind: int, wanted: NDArray[np.int64]) -> None:
    """Change one room's logits (N, C+1) in place until their likeliest classes keep the rules.

    Categories that were asked for by number (`wanted` not -1) are left as they are.
    """
    if not len(logits):
        return
    free = np.append(wanted < 0, True)
    _at_most(logits, free)
    taken: list[int] = []
    for group in sense().least[kind]:
        if len(taken) < len(logits) and not any(wanted[c] == 0 for c in group):
            taken.append(_one_of(logits, group, taken, free))
    _companions(logits, free, taken)
    _company(logits, free, taken)


def _at_most(logits: Logits, free: NDArray[np.bool_]) -> None:
    """Bar every group from all but the slots that want it most, `free` (C+1,) classes alone."""
    number, groups = _most()
    groups = groups & free
    for _ in range(len(number)):
        over = np.flatnonzero(groups @ np.bincount(logits.argmax(-1), minlength=logits.shape[1]) > number)
        if not len(over):
            return
        members = np.flatnonzero(groups[over[0]])
        wins = np.flatnonzero(groups[over[0]][logits.argmax(-1)])
        best = logits[wins][:, members].max(-1)
        losers = wins[np.argsort(-best, kind="stable")[number[over[0]] :]]
        logits[np.ix_(losers, members)] = BARRED


def _companions(logits: Logits, free: NDArray[np.bool_], taken: list[int]) -> None:
    """Where a class lacks what it needs, turn a slot into that or bar the class, whichever is likelier by the logits.

    Classes that were asked for by number, not `free` (C+1,), are neither made nor barred, and `taken` slots stay.
    Barring alone would make tables' chairs and stands' screens rare, as both settle together.
    """
    turned = np.isin(np.arange(len(logits)), taken)
    while (lack := _lacking(logits, free)) is not None:
        row, group = lack
        classes, best = logits.argmax(-1), logits.max(-1)
        dependent = classes == row
        others = logits[dependent]
        others[:, row] = -np.inf
        price = (best[dependent] - others.max(-1)).sum()
        members = np.flatnonzero(group & free & ~_full(classes, logits.shape[1]))
        margin = logits[:, members] - best[:, None]
        margin[turned | ~free[classes] | (dependent & (dependent.sum() == 1))] = -np.inf
        if members.size and -margin.max() < price:
            slot, which = divmod(int(margin.argmax()), len(members))
            logits[slot, members[which]] = best[slot] + 3.0
            turned[slot] = True
        else:
            logits[:, row] = BARRED


def _company(logits: Logits, free: NDArray[np.bool_], taken: list[int]) -> None:
    """Turn the slots that mind least into guests that a host lacks; `taken` slots and hosts' needs stay."""
    needing, companions = _needs()
    for host, guest, number in sense().company:
        for _ in range(number):
            classes = logits.argmax(-1)
            present = np.bincount(classes, minlength=logits.shape[1])
            if not present[host] or present[guest] >= number or not free[guest]:
                break
            kept = companions[np.isin(needing, classes)].any(0) | ~free
            margin = logits[:, guest] - logits.max(-1)
            margin[kept[classes] | (classes == host) | (classes == guest)] = -np.inf
            margin[taken] = -np.inf
            slot = int(margin.argmax())
            if not np.isfinite(margin[slot]):
                break
            logits[slot, guest] = logits[slot].max() + 3.0


def _full(classes: NDArray[np.int64], n: int) -> NDArray[np.bool_]:
    """Classes of which there are as many as a room may hold, (n,)."""
    number, groups = _most()
    return np.asarray(groups[groups @ np.bincount(classes, minlength=n) >= number].any(0))


def _lacking(logits: Logits, free: NDArray[np.bool_]) -> tuple[int, NDArray[np.bool_]] | None:
    """The first class that is there without any of what it needs, and which would do, (C+1,)."""
    needing, companions = _needs()
    present = np.bincount(logits.argmax(-1), minlength=logits.shape[1]) > 0
    present &= logits.max(0) > BARRED
    lacks = present[needing] & free[needing] & ~companions[:, present].any(1)
    if not lacks.any():
        return None
    first = int(lacks.argmax())
    return int(needing[first]), companions[first]


@cache
def _most() -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """How many of every group, (G,), and its classes, (G, C+1)."""
    rules = sense().most
    return np.array([number for number, _ in rules]), _table([group for _, group in rules])


@cache
def _needs() -> tuple[NDArray[np.int64], NDArray[np.bool_]]:
    """Classes that need others (K,), and which, (K, C+1)."""
    rules = sense().needs
    return np.array([category for category, _ in rules]), _table([companions for _, companions in rules])


def _table(groups: list[tuple[int, ...]]) -> NDArray[np.bool_]:
    table = np.zeros((len(groups), len(CATEGORIES) + 1), bool)
    for row, group in zip(table, groups, strict=True):
        row[list(group)] = True
    return table


def _one_of(logits: Logits, group: tuple[int, ...], taken: list[int], free: NDArray[np.bool_]) -> int:
    """A slot that takes a class of the group, made to if none does; what was asked for, not `free`, yields last."""
    classes = logits.argmax(-1)
    holders = [i for i in np.flatnonzero(np.isin(classes, group)) if i not in taken]
    if holders:
        return int(holders[0])
    margin = logits[:, group] - logits.max(-1, keepdims=True)
    margin[~free[classes]] -= ASKED
    margin[taken] = -np.inf
    slot, which = divmod(int(margin.argmax()), len(group))
    logits[slot, group[which]] = logits[slot].max() + 3.0
    return slot
