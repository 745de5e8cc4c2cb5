"""What is told of furnished rooms beside those of people: relations, faults, lacks, looks; and tables of it."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Room
from apartgen.stages import use
from apartgen.stages.layout import choice
from apartgen.stages.metrics.faults import VERSIONS, version
from apartgen.stages.use import habits
from apartgen_cli.bench import _compared

Record = dict[str, Any]
Moves = dict[str, list[float]]
"""How far the things of each room went, m."""
By = dict[tuple[str, str], list[Record]]
"""Records by room type and setting."""
REAL, OTHER = "real", "real, other half"
CORPUS, AGAIN, ON_REAL = "corpus", "corpus again", "corpus, floors of real rooms"
TYPES = ("living_room", "bedroom", "kitchen", "bathroom", "hallway", "dining_room")
SEEN = ("living_room", "bedroom")
"""Types of which there are real rooms."""
FAR = 0.5
"""What is moved further is elsewhere, m."""
MOVED = "moved, m"
LEAST, FEW = 20, 10
"""Rooms a side below which a classifier is not asked, and cases below which nothing is said."""
RESAMPLES = 400


def records(home: Layout, real: str | None, moves: Moves, alone: bool = False) -> list[Record]:
    """A record of every room that has furniture, of the types that are compared; `alone` where no plan is known."""
    rooms = [(room, objects) for room, objects in _compared.inside([home]) if objects and room.base in TYPES]
    found = [_of_room(home, room, objects, real, alone) | {"moves": moves.get(room.id, [])} for room, objects in rooms]
    seen = [k for k, (room, _) in enumerate(rooms) if room.base in SEEN]
    if seen:
        whole = [rooms[k] for k in seen]
        _look(found, seen, whole, "whole")
        if real:
            _look(found, seen, [(room, _coarse(objects, real)) for room, objects in whole], "common")
            _look(found, seen, [(room, []) for room, _ in whole], "bare")
    return found


def _common(objects: Sequence[Box], real: str) -> list[Box]:
    """Those of kinds that the real rooms have."""
    return [o for o in objects if _compared.coarse(o.category) in _compared.kinds(real)]


def _coarse(objects: Sequence[Box], real: str) -> list[Box]:
    """The same, told no finer than what is known of the real ones."""
    return [o.model_copy(update={"category": _compared.coarse(o.category)}) for o in _common(objects, real)]


def _look(found: list[Record], seen: list[int], rooms: list[tuple[Room, list[Box]]], name: str) -> None:
    for k, look in zip(seen, _compared.seen(rooms), strict=True):
        found[k][name] = look


def _of_room(home: Layout, room: Room, objects: Sequence[Box], real: str | None, alone: bool) -> Record:
    site = use.alone(room) if alone else use.site(home, room.id)
    whole = use.Furnished(site, objects)
    common = use.Furnished(site, _common(objects, real)) if real and room.base in SEEN else whole
    versions = [version(fault) for fault in use.faults(whole)]
    lacks = list(use.lacks(whole))
    return {
        "of": room.base, "habits": habits.cases(common), "faults": {name: versions.count(name) for name in VERSIONS},
        "lacks": {"number": len(lacks), "cost": sum(lack.cost for lack in lacks)}, "energy": choice.energy(whole),
        "objects": len(objects),
    }


def rows(found: list[Record], rng: np.random.Generator) -> list[Record]:
    """A row for every figure of every type of room, a column for every setting."""
    by: By = {}
    for record in found:
        by.setdefault((record["of"], record["setting"]), []).append(record)
    out = []
    for kind in TYPES:
        columns = {setting: _figures(mine, by, rng) for (of, setting), mine in by.items() if of == kind}
        names = dict.fromkeys(name for column in columns.values() for name in column)
        out += [{"room": kind, "figure": name} | {setting: column[name] for setting, column in columns.items()
                                                  if name in column} for name in names]
    return out


def _figures(mine: list[Record], by: By, rng: np.random.Generator) -> dict[str, Any]:
    """Every figure of the rooms of one type and setting, with its interval."""
    samples = {f"faults, {name}": [[r["faults"][name]] for r in mine] for name in VERSIONS}
    samples |= {f"lacks, {name}": [[r["lacks"][name]] for r in mine] for name in ("number", "cost")}
    samples |= {"energy": [[r["energy"]] for r in mine], "objects": [[r["objects"]] for r in mine]}
    for name in dict.fromkeys(name for r in mine for name in r["habits"]):
        samples[name] = [r["habits"][name] for r in mine if name in r["habits"]]
    if moves := [r["moves"] for r in mine if r["moves"]]:
        samples |= {"moved over .5 m": [[float(m > FAR) for m in room] for room in moves], MOVED: moves}
    if "seconds" in mine[0]:
        samples["CPU seconds a room"] = [[r["seconds"]] for r in mine]
    said = {name: rooms for name, rooms in samples.items() if sum(map(len, rooms)) >= FEW}
    return {"rooms": len(mine), **{name: summed(name, rooms, rng) for name, rooms in said.items()},
            **_apart(mine, by, rng)}


def summed(name: str, rooms: Sequence[Sequence[float]], rng: np.random.Generator) -> list[float]:
    """Cases of many rooms as one figure, with the interval of a bootstrap over rooms."""
    values = [np.asarray(room, float) for room in rooms]
    pick = rng.integers(len(values), size=(RESAMPLES, len(values)))
    if name in habits.MEDIANS or name == MOVED:
        middle = float(np.median(np.concatenate(values)))
        drawn = np.array([np.median(np.concatenate([values[k] for k in row])) for row in pick])
    else:
        sums, counts = np.array([v.sum() for v in values]), np.array([len(v) for v in values])
        middle, drawn = float(sums.sum() / counts.sum()), sums[pick].sum(1) / counts[pick].sum(1)
    low, high = np.quantile(drawn, [0.025, 0.975])
    return [round(middle, 5), round(float(low), 5), round(float(high), 5)]


def _apart(mine: list[Record], by: By, rng: np.random.Generator) -> dict[str, list[float]]:
    """SCA and CKL against as many rooms of the same type of the corpus, and of real ones."""
    out, kind, setting = dict[str, list[float]](), mine[0]["of"], mine[0]["setting"]
    for name, look, reference, never in (("corpus", "whole", CORPUS, (CORPUS, REAL, OTHER)),
                                         ("real rooms", "common", REAL, (REAL,)),
                                         ("real rooms, bare floors", "bare", REAL, (REAL,))):
        sides = [[r[look] for r in side if look in r] for side in (mine, by.get((kind, reference), []))]
        n = min(map(len, sides))
        if setting not in never and n >= LEAST:
            figures = ("SCA",) if look == "bare" else ("SCA", "CKL")
            found = _compared.apart(sides[0][:n], sides[1][:n], rng, figures)
            out |= {f"{figure} against {name}": value for figure, value in found.items()}
    return out
