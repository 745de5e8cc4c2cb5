"""Furniture in the materials of its room: its woods, its cloth, its rugs, the fronts of its kitchen; shapes stay."""

from dataclasses import replace

from apartgen.schemas.plan import Finish
from apartgen.stages.things.asset import Asset, Link, Material
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.finishes import named

WOODS = frozenset(("oak", "light_oak", "walnut", "birch", "pine", "cherry", "dark_oak", "teak", "bamboo"))
CLOTH = frozenset((
    "linen", "grey_fabric", "charcoal_fabric", "blue_fabric", "rust_fabric", "mustard_fabric", "sage_fabric",
    "cream_boucle", "green_velvet", "blue_velvet", "rose_velvet", "plum_velvet", "tan_leather", "brown_leather",
    "black_leather",
))  # fmt: skip
RUGS = frozenset(("rug_kilim", "rug_plain", "rug_border", "rug_stripe", "rug_berber", "rug_blue", "jute"))
BEDDING = frozenset(("duvet_blue", "duvet_sand", "duvet_green", "duvet_rose", "duvet_grey"))
LARGE = 1.2
"""What is wider has the room's first cloth, m."""
OWN = "parametric"
"""The library whose assets are dressed; models of others look as they were made."""


def dressed(asset: Asset, finish: Finish | None) -> Asset:
    """The asset in the materials of a room."""
    if finish is None or asset.library != OWN:
        return asset
    used = {mesh.material.name for link in asset.links for mesh in link.visuals}
    wanted = {name: _instead(name, asset, finish) for name in sorted(used)}
    changes = {name: new for name, other in wanted.items() if other not in ("", name) and (new := named(other))}
    return replace(asset, links=[_changed(link, changes) for link in asset.links]) if changes else asset


def _instead(name: str, asset: Asset, finish: Finish) -> str:
    """The material that takes the place of one; empty for none."""
    of_kitchen = dict(zip(asset.roles[::-1], (finish.handles, finish.worktop, finish.front)))
    if name in of_kitchen:
        return of_kitchen[name]
    if name in WOODS and finish.woods:
        return min(finish.woods, key=lambda wood: abs(_light(wood) - _light(name)))
    if name in CLOTH and finish.cloth and _is_seat(asset.category):
        return finish.cloth[0 if asset.size[1] > LARGE else -1]
    return finish.rug if name in RUGS else finish.bedding if name in BEDDING else ""


def _is_seat(category: str) -> bool:
    """Whether people sit or lie on it; curtains and lampshades keep their own cloth."""
    return category in TABLE and TABLE[category].is_for("sit", "lounge", "sleep", "dine", "work")


def _light(name: str) -> float:
    material = named(name)
    return sum(material.color[:3]) if material else 0.0


def _changed(link: Link, changes: dict[str, Material]) -> Link:
    return replace(link, visuals=[replace(mesh, material=changes.get(mesh.material.name, mesh.material))
                                  for mesh in link.visuals])
