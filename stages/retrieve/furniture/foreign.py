"""What another package's builder makes is held to what ours are, and whatever goes wrong is told with the package."""

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from apartgen.schemas import plugins
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.stages import registry
from apartgen.stages.registry import contract
from apartgen.stages.space import sweeps
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Array, Asset

if TYPE_CHECKING:
    from apartgen.stages.retrieve.furniture.designs import Builder
    from apartgen.stages.retrieve.furniture.kit import Kit

OWN = __name__.rpartition(".")[0]
NEAR, OPEN = 0.001, 0.01
"""So far outside the box anything may be, m, and what opens: an edge of its thickness goes round its corner."""
BROAD, SUNK = 0.3, 0.02
"""Share of its floor that the top of what things stand on has at least, and how far below its box's that may be, m."""
_SIDES = ("at the back", "on the right (−y)", "below the floor", "at the front", "on the left (+y)", "at the top")


def is_foreign(builder: "Builder") -> bool:
    """Whether another package brings it."""
    return not f"{builder.__module__}.".startswith(f"{OWN}.")


def told(builder: "Builder", fault: str) -> str:
    """The fault in words that say whose it is."""
    plugin = plugins.bringer(registry.group(OWN), builder.__module__)
    return plugin.told(fault) if plugin else f"{builder.__module__}: {fault}"


def made(builder: "Builder", kit: "Kit", id: str) -> Asset:
    """What it makes of the kit; BadInput where it fails, or draws or opens outside the kit's box."""
    try:
        builder(kit)
        asset = kit.finish(id)
        wrong = next(_faults(asset, kit.reach), "")
    except ApartgenError as error:
        wrong = str(error)
    except contract.ANYTHING as error:  # a stranger's function may do anything
        home = Path(getattr(sys.modules.get(builder.__module__), "__file__", None) or "").parent
        wrong = f"failed, {contract.at(error, str(home))}"
    if wrong:
        raise BadInput(told(builder, f"{id}: {wrong}"))
    return asset


def _faults(asset: Asset, reach: float) -> Iterator[str]:
    half, drawn = np.array(asset.size) / 2, [mesh.vertices for link in asset.links for mesh in link.visuals]
    if not drawn:
        yield "draws nothing"
        return
    points = np.concatenate(drawn)
    yield from _outside("draws", points.min(0), points.max(0), half, half, NEAR)
    if asset.category in categories.carriers() and (sunk := _sunk(asset, half)) > SUNK:
        yield (f"has its top {sunk * 1000:.0f} mm below that of its box, where things stand that are put on a "
               f"{asset.category}; draw a board up there, or give the category less height")
    further = half + [reach, 0.0, np.inf]
    for joint in asset.joints:
        yield from _outside(f"its part {joint.name} comes, when it opens,", *sweeps.swept(joint), half, further, OPEN)


def _sunk(asset: Asset, half: Array) -> float:
    """How far below its box's top the highest level is at or above which faces that look up are broad enough, m."""
    faces = np.concatenate([mesh.vertices[mesh.faces] for link in asset.links for mesh in link.visuals])
    normals = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0]) / 2
    up = normals[:, 2] > 0.95 * np.linalg.norm(normals, axis=1)
    depths, areas = half[2] - faces[up, :, 2].mean(1), normals[up, 2]
    order = np.argsort(depths)
    broad = np.cumsum(areas[order]) >= BROAD * 4 * half[0] * half[1]
    return float(depths[order][broad.argmax()]) if broad.any() else 2 * float(half[2])


def _outside(what: str, low: Array, high: Array, half: Array, further: Array, least: float) -> Iterator[str]:
    over = np.concatenate([-half - low, high - further])
    if not np.isfinite(np.concatenate([low, high])).all():
        yield f"{what} where there are no numbers (nan)"
    elif over.max() > least:
        more = f", and may come out {further[0] - half[0]:.3g} m at the front" if further[0] > half[0] else ""
        yield (f"{what} {over.max() * 1000:.0f} mm outside its box {_SIDES[int(over.argmax())]}; the box is "
               f"{' x '.join(f'{2 * side:.3g}' for side in half)} m deep, wide and high{more}")
