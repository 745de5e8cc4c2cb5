"""Masses, surfaces and mechanisms drawn within the ranges of the tables that name their sources."""

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from numpy.random import Generator

from apartgen.stages import seeds
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import mechanisms, small, weights
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body
from apartgen.stages.things.categories import TABLE

FILE = "physics.json"


def randomized(scene: Scene, seed: int) -> list[Body]:
    """A scene's bodies, other in nothing but in what they weigh and how they rub and move; each draws from a lane of
    its own.
    """
    rng = seeds.drawn(seed, "physics", seeds.plan_digest(scene.home))
    return [drawn(body, seeds.lane(rng, body.name)) for body in scene.bodies]


def drawn(body: Body, rng: Generator) -> Body:
    """A body with physics drawn: parts get heavier or lighter together, and rub alike."""
    scale, rubs = _heavier(body, rng), rng.uniform(*mechanisms.surface())
    links = [replace(link, mass=scale * link.mass, friction=_within(_rubbing(body.category), link.friction, rubs))
             for link in body.links]
    moving = [link for link in links if link.joint is not None]
    return replace(body, links=links, motions={
        link.name: mechanisms.motion(body.category, link, seeds.lane(rng, link.name)) for link in moving})


def _heavier(body: Body, rng: Generator) -> float:
    """How much heavier it is than usual; the whole stays between the lightest and the heaviest of its kind."""
    usual, factor = sum(link.mass for link in body.links), rng.uniform(1 - weights.SPREAD, 1 + weights.SPREAD)
    span = _span(body.category)
    if span is None or usual <= 0:
        return float(factor)
    return _within(span, usual, factor) / usual


def _within(span: mechanisms.Range, usual: float, factor: float) -> float:
    """`factor` times the usual, as far as the span goes; a library's own model may be outside as it is."""
    return float(min(max(factor * usual, min(span[0], usual)), max(span[1], usual)))


def _rubbing(category: str) -> mechanisms.Range:
    """Between what and what surfaces of such a thing rub."""
    kind = small.TABLE[category].surface if category in small.TABLE else "hard"
    return mechanisms.surfaces()[kind].friction


def _span(category: str) -> tuple[float, float] | None:
    return small.TABLE[category].mass if category in small.TABLE else (
        TABLE[category].mass if category in TABLE else None)


def told(bodies: Sequence[Body], seed: int, out: Path) -> Path:
    """Writes what was drawn, body by body."""
    found = {"seed": seed, "bodies": {body.name: _facts(body) for body in bodies}}
    path = out / FILE
    path.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    return path


def _facts(body: Body) -> dict[str, Any]:
    return {body.link_name(link): {"mass": link.mass, "friction": link.friction} | _moves(body, link)
            for link in body.links}


def _moves(body: Body, link: Link) -> dict[str, Any]:
    return {} if link.joint is None else {"joint": body.motion(link)._asdict()}

