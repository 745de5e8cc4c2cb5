"""The neutral description of an apartment's bodies, shapes, joints and lights that every export format writes.

Formats read this and nothing else, so that they can't disagree.
"""

import logging
import re
from collections.abc import Callable, Container
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import count
from typing import Any

import numpy as np

from apartgen.schemas.carrying import CEILING, WALL
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Populate
from apartgen.schemas.retrieve import Furnishing, Retrieve
from apartgen.stages.robot.wedged import wedged
from apartgen.stages.scene import shell
from apartgen.stages.space import polygons
from apartgen.stages.things import placed, small
from apartgen.stages.things.asset import Array, Asset, Link
from apartgen.stages.things.body import Body, Light
from apartgen.stages.things.carrying import told
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.dressed import dressed

log = logging.getLogger("apartgen")
LoadAsset = Callable[[str, str], Asset]
OVERHEAD = next(kind.lumens for kind in TABLE.values() if kind.lumens and kind.place == "ceiling")
"""Of the light that a room without a ceiling lamp has all the same."""


@dataclass(frozen=True, eq=False)
class Scene:
    """An apartment to export; `home` is the artifact itself. Bodies are built when first asked for.

    Not `shown`, what only shows is left out, but for parts of which nothing else is known. `masked`, bits and not lists
    of pairs say what does not touch, where a format has them.
    """

    home: Plan
    load_asset: LoadAsset
    shown: bool = True
    masked: bool = False

    @cached_property
    def bodies(self) -> list[Body]:
        """The shell's bodies, then one for each object, in the artifact's order; BadInput without assets."""
        stuck = wedged(self.placed)
        for name, others in stuck.items():
            log.info("%s stands partly in %s; it is fixed where it is", name, ", ".join(others))
        return [replace(b, free=False, within=tuple(stuck[b.name])) if b.name in stuck else b for b in self.placed]

    @cached_property
    def placed(self) -> list[Body]:
        """The same to be looked at only: it is not asked what stands in others, and so can't be moved."""
        if "bodies" in vars(self):
            return self.bodies
        taken: set[str] = set()
        built = [*shell.bodies(self.home, self.shown), *(self._body(o) for o in _furnishings(self.home))]
        return [replace(_renamed(body, taken), says=_said(self.home, body.id)) for body in built]

    @cached_property
    def lights(self) -> list[Light]:
        """One for every lamp, and one under the ceiling of each room without a ceiling lamp."""
        objects = self.home.objects if isinstance(self.home, Layout) else []
        kinds = {o.id: TABLE[o.category] for o in objects if o.category in TABLE}
        off = {id for id, state in getattr(self.home, "states", {}).items() if state.get("on") is False}
        lamps = [
            Light(f"light_{identifier(o.id)}", o.room, self._bulb(o), kinds[o.id].lumens * (o.id not in off))
            for o in objects if o.id in kinds and kinds[o.id].lumens
        ]
        lit = {o.room for o in objects if o.id in kinds and kinds[o.id].lumens and kinds[o.id].place == "ceiling"}
        dark = [room for room in self.home.rooms if room.id not in lit and room.base != "balcony"]
        middles = [np.array(polygons.floor(room).representative_point().coords[0]) for room in dark]
        plain = [
            Light(f"light_{room.id}", room.id, np.array([*xy, self.home.height - 0.15]), OVERHEAD)
            for room, xy in zip(dark, middles, strict=True)
        ]
        return lamps + plain

    @cached_property
    def credits(self) -> list[str]:
        """Who made the assets used, sorted."""
        own = self.home.objects if isinstance(self.home, Retrieve) else []
        return sorted({self.load_asset(o.asset.library, o.asset.id).credit for o in own} - {""})

    def of(self, bodies: list[Body], masked: bool = False) -> "Scene":
        """The same scene of other bodies."""
        found = replace(self, masked=self.masked or masked)
        vars(found)["bodies"] = bodies
        return found

    def _bulb(self, o: Box) -> Array:
        """Where a lamp's light comes from: the middle of its bulbs, or of what glows, or of its box."""
        own = self.load_asset(o.asset.library, o.asset.id).links if isinstance(o, Furnishing) else []
        glowing = [mesh for link in own for mesh in link.visuals if mesh.material.emission > 0]
        brightest = max((mesh.material.emission for mesh in glowing), default=0.0)
        corners = [mesh.vertices for mesh in glowing if mesh.material.emission == brightest]
        bounds = np.concatenate(corners) if corners else np.zeros((1, 3))
        x, y, z = (bounds.min(0) + bounds.max(0)) / 2
        c, s = np.cos(o.yaw), np.sin(o.yaw)
        return np.asarray(np.array(o.center) + [c * x - s * y, s * x + c * y, z])

    def _body(self, o: Furnishing) -> Body:
        asset = self.load_asset(o.asset.library, o.asset.id)
        asset = dressed(asset, self.home.finishes.get(o.room))
        links = _links(placed.links(o, asset), o.category)
        links = links if self.shown else _bare(links)
        return Body(
            o.id, "object", o.category, o.room, np.array(o.center, float), o.yaw, links,
            _is_free(o), o.id, f"{o.asset.library}/{o.asset.id}",
        )


def _said(home: Plan, id: str) -> dict[str, Any]:
    """What a populated home says of one of its things or doors, but for what is empty."""
    if not isinstance(home, Populate):
        return {}
    about = {"affordances": home.affordances.get(id), "state": home.states.get(id), "switches": home.switches.get(id)}
    return {name: value for name, value in about.items() if value}


def _is_free(o: Furnishing) -> bool:
    """Whether it may be pushed about: it is light, and stands; a television on a wall does not."""
    light = small.TABLE[o.category].fixed is False if o.category in small.TABLE else (
        o.category in TABLE and TABLE[o.category].loose)
    return light and o.on not in (WALL, CEILING)


def _links(links: list[Link], category: str) -> list[Link]:
    """The links; what lies flat (a rug) only shows, as things stand through it on the floor."""
    if category in TABLE and TABLE[category].place == "flat":
        return [replace(link, colliders=[]) for link in links]
    return links


def _bare(links: list[Link]) -> list[Link]:
    return [replace(link, visuals=[]) if link.colliders or link.joint is None else link for link in links]


def _furnishings(home: Plan) -> list[Furnishing]:
    if isinstance(home, Retrieve):
        return told(home.objects, home.height)
    if isinstance(home, Layout) and home.objects:
        raise BadInput(
            "a layout has boxes and no assets yet, and what was asked for shows assets; run `apartgen retrieve` on it "
            "first, or export svg, png, elevations, dxf or ifc, which draw boxes"
        )
    return []


def identifier(text: str) -> str:
    """The text as a name that XML, USD and URDF all take: letters, digits and underscores, not a digit first."""
    plain = re.sub(r"\W", "_", text, flags=re.ASCII)
    return plain if re.match(r"[A-Za-z]", plain) else f"n{plain}"


def untaken(name: str, taken: Container[str]) -> str:
    """The name, numbered if it is taken."""
    numbered = (name if k == 1 else f"{name}_{k}" for k in count(1))
    return next(n for n in numbered if n not in taken)


def _renamed(body: Body, taken: set[str]) -> Body:
    """The body under a name not yet taken, which it then takes."""
    name = untaken(identifier(body.name), taken)
    taken.add(name)
    return replace(body, name=name)
