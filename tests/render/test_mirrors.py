"""What mirrors does so up to its edges: pixels there are means of what is on both sides, not of something else."""

import numpy as np

from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.picture import taken
from apartgen.stages.scene.world import ground, open_air
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Link, Material
from apartgen.stages.things.body import Body

DARK = Material("dark", (0.1, 0.1, 0.1, 1.0), 1.0)
MIRROR = Material("mirror_of_test", (0.9, 0.9, 0.9, 1.0), 0.05, 1.0)


def test_edges_of_mirrors_are_between_their_two_sides():
    block = solids.box((-0.5, -0.5, 0.0), (0.5, 0.5, 0.8), MIRROR)
    body = Body("block", "object", "", "", np.zeros(3), 0.0, [Link("base", [block], [], 1.0)])
    eye = Camera.looking(np.array([3.0, 1.6, 1.2]), np.pi + 0.5, -0.25, 0.7, 160, 120)
    image = taken(open_air([body], ground(np.zeros(3), -1e-3, DARK)), eye).astype(int)
    across = image[:, 3:]
    left, right, middle = across[:, :-6], across[:, 6:], across[:, 3:-3]
    outside = np.maximum(np.minimum(left, right) - middle, middle - np.maximum(left, right)).max(-1)
    assert (outside > 40).mean() < 2e-3
