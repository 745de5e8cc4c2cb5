"""What parts hang on and run in: friction, damping and what holds them shut, by the kind of mechanism; the data is
`mechanisms.toml`, where every figure names its source.
"""

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.random import Generator
from pydantic import ConfigDict, TypeAdapter

from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.asset import Link
from apartgen.stages.things.categories import TABLE

Range = tuple[float, float]
LIGHT = 1.0
"""Friction is at most what gives the part at its handle this acceleration, m/s²: light lids stay easy to move."""


@dataclass(frozen=True, kw_only=True)
class Mechanism:
    """One kind; `mechanisms.toml` says what each range is."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    friction: Range
    damping: Range
    catch: Range = (0.0, 0.0)
    rest: Range = (0.0, 0.0)
    travel: float = 0.0
    source: str
    force: Range
    turn: Range = (0.0, 0.0)
    out: Range = (0.0, 0.0)
    turned: str
    drag: Range
    dragged: tuple[str, ...]
    drags: str = ""


@dataclass(frozen=True, kw_only=True)
class Surface:
    """What one kind of surface rubs at rest, and where that is from."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    friction: Range
    source: str


class Motion(NamedTuple):
    """Of one joint: damping, dry friction, and what force or torque holds it shut, and wide open; gone at `travel`."""

    damping: float
    friction: float
    catch: float
    rest: float
    travel: float


@cache
def _rows() -> dict[str, Any]:
    return tomllib.loads((Path(__file__).parent / "mechanisms.toml").read_text(encoding="utf-8"))


@cache
def table() -> dict[str, Mechanism]:
    """Every mechanism by its name."""
    return TypeAdapter(dict[str, Mechanism]).validate_python(_rows()["mechanisms"])


def surface() -> Range:
    """By what share of the usual the friction of a surface may differ."""
    least, most = _rows()["surface"]["friction"]
    return float(least), float(most)


@cache
def surfaces() -> dict[str, Surface]:
    """Every kind of surface by its name."""
    return TypeAdapter(dict[str, Surface]).validate_python(_rows()["surfaces"])


def sources() -> dict[str, str]:
    """Where figures are from, by the names that tables give."""
    return dict(_rows()["sources"])


def allowed(names: Sequence[str], listed: Range) -> Range:
    """Between what and what a thing may weigh, kg, by what its sources list: from half to twice that where they give
    averages or single things.
    """
    alone = set(names) <= set(_rows()["average"])
    return (listed[0] / 2, listed[1] * 2) if alone else listed


def kind(category: str, joint: Joint) -> str:
    """The mechanism of a part of something; what is no furniture is a door of the building."""
    if category not in TABLE:
        return "room_door"
    if joint.type == "slide":
        return "drawer" if abs(joint.axis[0]) > 0.5 else "sliding_door"
    return "lid" if joint.part == "hinge_lid" else TABLE[category].mechanism or "cabinet_door"


def motion(category: str, link: Link, rng: Generator | None = None) -> Motion:
    """How a part moves: the middle of its mechanism's ranges, or drawn from them."""
    assert link.joint is not None
    own, arm = table()[kind(category, link.joint)], lever(link)

    def value(span: Range) -> float:
        return float(np.mean(span) if rng is None else rng.uniform(*span))

    damping, friction = value(own.damping), value(own.friction)
    return Motion(damping, min(friction, LIGHT * link.mass * arm), value(own.catch) * arm, value(own.rest) * arm,
                  own.travel)


def lever(link: Link) -> float:
    """How far from its axis a part is pulled, m; 1 for what slides."""
    joint = link.joint
    assert joint is not None
    if joint.type == "slide":
        return 1.0
    axis = np.asarray(joint.axis, float) / np.linalg.norm(joint.axis)
    if link.handle is not None:
        points = np.asarray(link.handle, float)[None]
    else:
        lo, hi = np.asarray(joint.extent, float) if joint.extent else np.zeros((2, 3))
        points = np.array([[x, y, z] for x in (lo[0], hi[0]) for y in (lo[1], hi[1]) for z in (lo[2], hi[2])])
    away = np.cross(points - np.asarray(joint.origin, float), axis)
    return max(float(np.linalg.norm(away, axis=1).max()), 0.05)
