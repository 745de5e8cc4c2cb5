"""A furnished home with rooms of several kinds, and what is in it by seed."""

from functools import cache
from pathlib import Path

import numpy as np

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages import populate, retrieve, seeds

HOME = Path(__file__).parent / "golden" / "v2" / "walkable.json"


@cache
def furnished():
    return artifact.read(HOME, Walkable).body


@cache
def library():
    return retrieve.open_libraries()


@cache
def lived_in(seed=0, density=1.0, walls=True):
    """What the stage makes of the home, and the things that it put there."""
    home = furnished()
    lane = seeds.drawn(seed, "populate", seeds.plan_digest(home))
    return populate.run(home, populate.PopulateConfig(density=density, walls=walls), lane, library())


def things(home):
    return [o for o in home.objects if getattr(o, "stage", "") == "populate"]


def corners(o):
    """Corners of an object's footprint (4, 2)."""
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    d, w = o.size[0] / 2, o.size[1] / 2
    return np.array([[-d, -w], [d, -w], [d, w], [-d, w]]) @ np.array([[c, s], [-s, c]]) + o.center[:2]
