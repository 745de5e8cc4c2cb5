"""How things are when one comes in: what is on, what stands open; what switches switch, and what things afford."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.random import Generator

from apartgen.schemas.layout import Box
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Thing
from apartgen.schemas.retrieve import Furnishing, Joint
from apartgen.stages import seeds
from apartgen.stages.populate.config import PopulateConfig
from apartgen.stages.space import sweeps
from apartgen.stages.things import affordances, categories, small
from apartgen.stages.things.receptacles import Receptacle

State = dict[str, bool | float]

AJAR = 0.15
"""Share of parts that stand open where these are drawn."""


def _lamps_at(place: str) -> frozenset[str]:
    return categories.those(lambda kind: kind.is_for("light") and kind.place == place)


LAMPS = [_lamps_at(place) for place in ("ceiling", "wall", "floor", "top")]
"""What a switch at the door switches: the lamps of the first of these kinds that the room has."""


class Said(NamedTuple):
    """By object: its state, what it affords, and for switches what they switch."""

    states: dict[str, State]
    affordances: dict[str, list[str]]
    switches: dict[str, list[str]]


def said(home: Plan, objects: Sequence[Furnishing], offered: dict[str, tuple[Receptacle, ...]],
         config: PopulateConfig, rng: Generator) -> Said:
    """What is to be said of a home's things; each draws from a lane of its own."""
    afforded = {o.id: found for o in objects if (found := affordances.affordances(
        o, [place.kind for place in offered.get(o.id, ())], bool(isinstance(o, Thing) and o.grasps)))}
    switches = {o.id: lamps for o in objects if o.category == "light_switch" and (lamps := _lamps(o, objects))}
    states: dict[str, State] = {o.id: {"on": _is_on(o, rng)} for o in objects
                                if "switchable" in afforded.get(o.id, ())}
    for switch, lamps in switches.items():
        states[switch] = {"on": bool(any(states[lamp]["on"] for lamp in lamps))}
    for id, name, share in [*_doors(home, config), *(_parts(objects, rng) if config.parts == "random" else ())]:
        states.setdefault(id, {})[f"open.{name}"] = share
    return Said(states, afforded, switches)


def _is_on(o: Box, rng: Generator) -> bool:
    kind = small.TABLE.get(o.category) or categories.TABLE.get(o.category)
    return bool(seeds.lane(rng, f"on {o.id}").random() < (kind.on if kind else 0.0))


def _lamps(switch: Box, objects: Sequence[Box]) -> list[str]:
    for kinds in LAMPS:
        found = [o.id for o in objects if o.room == switch.room and o.category in kinds]
        if found:
            return found
    return []


def _doors(home: Plan, config: PopulateConfig) -> Iterator[tuple[str, str, float]]:
    """Doors between rooms stand open where that is asked for; the entrance is shut."""
    for o in home.openings:
        if o.kind == "door" and o.into is not None and config.doors_open:
            yield o.id, "leaf", 1.0


def _parts(objects: Sequence[Furnishing], rng: Generator) -> Iterator[tuple[str, str, float]]:
    """Some parts stand open, none where another does; what things lie in is pulled out by hand only."""
    full = {(o.in_.object, o.in_.receptacle) for o in objects if isinstance(o, Thing) and o.in_}
    taken: list[np.ndarray[tuple[int, ...], np.dtype[np.float64]]] = []
    for o in (o for o in objects if o.joints and not isinstance(o, Thing)):
        own = seeds.lane(rng, f"parts {o.id}")
        for joint in o.joints:
            share = float(own.uniform(0.1, 1.0))
            if own.random() >= AJAR or (joint.type == "slide" and any(id == o.id for id, _ in full)):
                continue
            box = _swept(o, joint)
            if not any((box[0] < b[1]).all() and (box[1] > b[0]).all() for b in taken):
                taken.append(box)
                yield o.id, joint.name, round(share, 3)


def _swept(o: Furnishing, joint: Joint) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Bounds in the world of all that a part passes through, (2, 3)."""
    lo, hi = np.asarray(sweeps.swept(joint), float)
    points = np.array([[x, y, z] for x in (lo[0], hi[0]) for y in (lo[1], hi[1]) for z in (lo[2], hi[2])])
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    turned = points @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) + o.center
    return np.stack([turned.min(0), turned.max(0)])
