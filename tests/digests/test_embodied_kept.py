"""Episodes of robots as they were: what is asked, where they stand, what came of it, what a replay shows."""

import numpy as np
import pytest
from digests import kept
from embodied import blocks
from export import sample

from apartgen.stages import registry
from apartgen.stages.embodied import base, episodes, interact, marks, navigate, world
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import grid


@pytest.fixture(scope="module")
def apartment(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    scene = Scene(sample.home(), sample.load)
    registry.load("apartgen.stages.export", "mjcf").write(scene, folder)
    return scene, folder / "mjcf" / "apartment.xml"


@pytest.fixture(scope="module")
def shown(apartment):
    return world.build(*apartment, name="home")


def told(one):
    """What came of an episode, its figures coarse enough for any machine's rounding."""
    return [one.success, one.failure, one.reason, {name: round(float(v) * 8) for name, v in one.numbers.items()}]


def test_episodes(shown):
    kept.same("embodied", "episodes", {"listed": episodes.listed(shown, kept.lane("episodes"))})


@pytest.fixture(scope="module")
def driven(apartment):
    return navigate.run(world.build(*apartment, base.mjcf(), moving=(), fused=True, name="home"), kept.lane("ways"))


def test_ways_driven(driven):
    kept.same("embodied", "ways", {one.object: told(one) for one in driven})


def test_what_is_marked(driven):
    cells = grid.Grid((0.0, 0.0), (20, 30), 0.1)
    where = np.add.outer(np.arange(20), np.arange(30)) % 7 < 3
    kept.same("embodied", "marked", {"goals": [mark[1:] for one in driven for mark in marks.goal(one)],
                                     "floor": [mark[1:] for mark in marks.floor(cells, where, marks.REACHED)],
                                     "line": [mark[1:] for mark in marks.line(np.eye(3), marks.TRAIL)],
                                     "colours": [marks.MEANT, marks.MET, marks.GOAL, marks.CUT_OFF]})


def test_what_opens(shown):
    kept.same("embodied", "opens", {f"{k} {one.object}": told(one) for k, one in enumerate(interact.run(shown))})


def test_how_it_is_opened(shown):
    """With traces, of which the moments and the joints are told, and the places every half second."""
    found = [one for id in ("double_bed", "display_cabinet", "bin") for one in interact.run(shown, next(
        (o.id for o in shown.home.objects if o.category == id), None))]
    traces = {f"{k} {one.object}": one.trace for k, one in enumerate(found) if one.trace}
    kept.same("embodied", "opened", {name: [trace.joints, [round(at, 1) for at in trace.times[-1:]], [
        [round(float(v), 1) for v in row] for row in trace.qpos[::25]]] for name, trace in traces.items()})


def test_a_room_that_is_shut(tmp_path):
    """Blocks before what opens, and in the only way."""
    home = blocks.furnished(blocks.corridor(6, 1.3), blocks.block("shut", 3.0, 0.65, 0.3, 1.25),
                            blocks.block("goal", 5.7, 0.6, 0.4, 0.6, np.pi))
    found = navigate.run(world.build(*blocks.exported(home, tmp_path), base.mjcf(), moving=(), fused=True, name="home"),
                         np.random.default_rng(0))
    kept.same("embodied", "shut", {one.object: told(one) for one in found})
