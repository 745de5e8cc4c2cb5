"""An asset under construction: its box, its fixed body, its moving parts."""

import zlib
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from apartgen.schemas.retrieve import Joint
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.space.boxes import Array
from apartgen.stages.things import categories, weights
from apartgen.stages.things.asset import Asset, Collider, Link

QUARTER = float(np.pi / 2)

_Moving = tuple[str, Body, dict[str, Any], tuple[float, float, float] | None, str]


class Kit:
    """What a builder gets: size `d`, `w`, `h` in metres, `style`, `rng`, and `base`, the fixed body."""

    def __init__(
        self, category: str, style: str, size: tuple[float, float, float], seed: int, model: str = "",
        right: bool = False,
    ) -> None:  # fmt: skip
        """`model` is the category whose builder makes it, where that is another one; a single leaf hangs `right`."""
        self.category, self.style, self.seed, self.model = category, style, seed, model or category
        self.right = right
        self._seeds = [zlib.crc32(f"{category}/{style}".encode()), seed]
        self.size = size
        self.d, self.w, self.h = size
        self.base = Body()
        self.friction = 0.6
        self.roles: tuple[str, ...] = ()
        self.moving: list[_Moving] = []

    @cached_property
    def rng(self) -> np.random.Generator:
        """Chance of the category, style and seed that it was asked for."""
        return np.random.default_rng(self._seeds)

    @property
    def x(self) -> tuple[float, float]:
        """Back and front of the box."""
        return -self.d / 2, self.d / 2

    @property
    def y(self) -> tuple[float, float]:
        """Right and left of the box."""
        return -self.w / 2, self.w / 2

    @property
    def reach(self) -> float:
        """How far open parts may stand out in front, m; unbounded for what is no furniture category."""
        return float(categories.reach(self.category, self.size)) if self.category in categories.TABLE else np.inf

    def taste(self, style: str = "", seeds: int = 1) -> np.random.Generator:
        """Chance that all categories of a style share, so that pieces of one set match; `seeds` in a row agree."""
        return np.random.default_rng([zlib.crc32((style or self.style).encode()), self.seed // seeds])

    def pick(self, *options: str) -> str:
        """One of the options, by the seed."""
        return options[int(self.rng.integers(len(options)))]

    def hinge(
        self, name: str, body: Body, origin: ArrayLike, axis: ArrayLike, part: str = "",
        upto: float = QUARTER, handle: tuple[float, float, float] | None = None, grip: str = "",
    ) -> None:  # fmt: skip
        """A part that turns from 0 to `upto` radians about an axis; which `part` it is follows from how it lies."""
        joint: dict[str, Any] = {
            "type": "hinge",
            "origin": np.asarray(origin, float),
            "axis": axis,
            "range": (0.0, upto),
            "part": part or _hung(body, np.asarray(origin, float), np.asarray(axis, float)),
        }
        self._move(name, body, joint, handle, grip)

    def slide(
        self, name: str, body: Body, travel: float, axis: ArrayLike = (1, 0, 0), part: str = "slider_drawer",
        handle: tuple[float, float, float] | None = None, grip: str = "",
    ) -> None:  # fmt: skip
        """A part that slides from 0 to `travel` metres."""
        lo, hi = body.bounds()
        joint: dict[str, Any] = {
            "type": "slide",
            "origin": (lo + hi) / 2,
            "axis": axis,
            "range": (0.0, travel),
            "part": part,
        }
        self._move(name, body, joint, handle, grip)

    def _move(self, name: str, body: Body, joint: dict[str, Any], handle: tuple[float, float, float] | None, grip: str,
              ) -> None:
        """A moving part, but of a category that has none, which is built by another's builder."""
        if self.category in categories.TABLE and not categories.TABLE[self.category].articulated:
            self.base.take(body)
        else:
            self.moving.append((self._free(name), body, joint, handle, grip))

    def _free(self, name: str) -> str:
        taken = sum(other[0].rsplit("_", 1)[0] == name for other in self.moving)
        return f"{name}_{taken}"

    def _scale(self) -> float:
        """How much heavier all its parts are than their materials say, for the whole to weigh as such things do."""
        whole = self.base.mass + sum(body.mass for _, body, *_ in self.moving)
        return weights.weight(self.category, self.size, whole) / whole if whole else 1.0

    def finish(self, id: str) -> Asset:
        """The asset, in the frame whose origin is the centre of its box."""
        drop, scale = self.h / 2, self._scale()
        links = [Link("base", self.base.meshes(drop), _lowered(self.base, drop), round(scale * self.base.mass, 3),
                      friction=self.friction)]
        for name, body, joint, handle, grip in self.moving:
            hold = None if handle is None else np.array(handle) - [0, 0, drop]
            made = _joint(name, body, joint, drop)
            links.append(
                Link(name, body.meshes(drop), _lowered(body, drop), round(scale * body.mass, 3), made, hold,
                     grip=grip)
            )
        return Asset("parametric", id, self.category, self.style, self.size, links, credit="apartgen, CC0-1.0",
                     roles=self.roles)


def _hung(body: Body, origin: Array, axis: Array) -> str:
    """The class of what turns: a lid lies flat while it is shut and is raised about a level axis; else it is a door."""
    lo, hi = body.bounds()
    raised = np.cross(axis, (lo + hi) / 2 - origin)[2] > 0
    flat, level = np.argmin(hi - lo) == 2, abs(axis[2]) < 0.5 * np.linalg.norm(axis)
    return "hinge_lid" if flat and level and raised else "hinge_door"


def _lowered(body: Body, drop: float) -> list[Collider]:
    centers = np.array([c.center for c in body.colliders]).reshape(-1, 3) - [0, 0, drop]
    return [Collider(c.kind, center, c.size, c.rotation, c.vertices) for c, center in zip(body.colliders, centers)]


def _vector(values: ArrayLike) -> tuple[float, float, float]:
    x, y, z = (round(float(v), 6) for v in np.asarray(values, float))
    return x, y, z


def _joint(name: str, body: Body, joint: dict[str, Any], drop: float) -> Joint:
    lo, hi = body.bounds()
    fields = joint | {
        "name": name,
        "axis": _vector(joint["axis"]),
        "origin": _vector(np.asarray(joint["origin"]) - [0, 0, drop]),
        "extent": (_vector(lo - [0, 0, drop]), _vector(hi - [0, 0, drop])),
    }
    return Joint.model_validate(fields)
