"""Rooms beside the same rooms furnished otherwise: what is kept of each, and how far two sets of them are apart."""

import base64
from collections import Counter
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan, Room
from apartgen.stages.metrics import _networks, _pictures
from apartgen.stages.metrics._distances import Figure, frechet, kernel, separability
from apartgen.stages.metrics.frequencies import divergence
from apartgen.stages.use.kinds import BEDS, CASES, CHAIRS, CLOTHES, DOUBLE, SMALL_SEATS, SOFAS, TABLES
from apartgen_cli.bench._runner import SEEDS

Record = dict[str, Any]
REFERENCE, REAL, FURNISHER = "reference", "real against real", "furnisher"
LANES = (REFERENCE, REAL, FURNISHER)
"""The furnisher's: of the reference, of the other real rooms, of itself as a method; no two furnish alike."""
GROUPS = (CASES - CLOTHES, CLOTHES & {"wardrobe", "sliding_wardrobe"}, SOFAS, TABLES, CHAIRS, SMALL_SEATS,
          BEDS - DOUBLE, frozenset({"plant", "planter"}))
COMMON = 0.02
"""Share of real rooms in which a kind must stand to be among those that are compared."""
HELD_OUT = 77_000
"""Begins every seed here: no training data are made with it."""


def furnished(plans: Sequence[Plan], seed: int, lane: str) -> list[Layout]:
    """The plans as the furnisher, which made the training data, furnishes them."""
    from apartgen.stages.layout.datasets.furnisher import furnish

    lanes = [np.random.default_rng([HELD_OUT, seed, i, LANES.index(lane)]) for i in range(len(plans))]
    return [Layout(**dict(plan), objects=furnish(plan, rng)) for plan, rng in zip(plans, lanes, strict=True)]


def real_rooms(real: str, seed: int, scenes: int, other: bool = False) -> list[Layout]:
    """Rooms of SOURCE=PATH by turns: of every two, one for reference and the other to compare with it."""
    name, _, folder = real.partition("=")
    homes = _read(name, folder)
    order = np.random.default_rng(HELD_OUT).permutation(len(homes))[int(other) :: 2]
    return [homes[i] for i in order[seed % SEEDS :][:scenes]]


@cache
def _read(name: str, folder: str) -> list[Layout]:
    from apartgen.stages.layout import datasets

    return list(datasets.source(name).homes(Path(folder)))


@cache
def kinds(real: str) -> frozenset[str]:
    """What stands in a share of the real rooms, told as coarsely as descriptions of their things allow."""
    name, _, folder = real.partition("=")
    rooms = [{coarse(o.category) for o in objects} for _, objects in inside(_read(name, folder))]
    found = Counter(kind for room in rooms for kind in room)
    return frozenset(kind for kind, rooms_with in found.items() if rooms_with >= COMMON * len(rooms))


def coarse(category: str) -> str:
    """One name for all kinds that descriptions of things do not tell apart."""
    return next((min(group, key=lambda name: (len(name), name)) for group in GROUPS if category in group), category)


def bare(home: Layout) -> Plan:
    """The plan alone."""
    return Plan(**{name: getattr(home, name) for name in Plan.model_fields})


def inside(homes: Sequence[Layout]) -> list[tuple[Room, list[Box]]]:
    """Every room with its objects."""
    return [(room, [o for o in home.objects if o.room == room.id]) for home in homes for room in home.rooms]


def seen(rooms: Sequence[tuple[Room, list[Box]]], inception: str | None = None) -> list[Record]:
    """Categories of every room, and what an image network, whose name comes along, sees of it."""
    network = _network(inception)
    features = network.features([_pictures.picture(room.polygon, objects, room.base) for room, objects in rooms])
    return [
        {"of": room.type, "network": network.name, "suffix": network.suffix,
         "categories": [o.category for o in objects], "features": _packed(row)}
        for (room, objects), row in zip(rooms, features, strict=True)
    ]


@cache
def _network(inception: str | None) -> _networks.Network:
    return _networks.network(Path(inception) if inception else None)


def _packed(features: _networks.Features) -> str:
    """Half precision as text: far finer than what sets differ by."""
    return base64.b64encode(features.astype(np.float16).tobytes()).decode()


def _unpacked(records: Sequence[Record]) -> _networks.Features:
    return np.stack([np.frombuffer(base64.b64decode(r["features"]), np.float16) for r in records]).astype(np.float32)


def apart(
    mine: Sequence[Record], reference: Sequence[Record], rng: np.random.Generator, names: Sequence[str]
) -> dict[str, list[float]]:
    """The named figures (FID, KID, SCA, CKL) with their intervals, image figures bearing their network's suffix."""
    a, b, suffix = _unpacked(mine), _unpacked(reference), mine[0]["suffix"]
    image = {"FID": frechet, "KID": kernel, "SCA": separability}
    found: dict[str, Figure | None] = {name + suffix: image[name](a, b, rng) for name in names if name in image}
    if "CKL" in names:
        found["CKL"] = divergence([r["categories"] for r in mine], [r["categories"] for r in reference], rng)
    return {name: [round(v, 6) for v in figure] for name, figure in found.items() if figure}
