"""The film of the robot's way: doors open before it comes, the camera turns slowly, frames are what is written."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from export import sample

from apartgen.schemas.errors import BadInput
from apartgen.stages.render import TILT, film, route
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import ajar_world, world

CONFIG = RenderConfig(width=64, height=48, rate=4, speed=1.5)


@pytest.fixture(scope="module")
def seen():
    scene = Scene(sample.home(), sample.load)
    return scene, world(scene)


@pytest.fixture(scope="module")
def some(seen):
    return film.moments(seen[1], CONFIG)


def test_the_camera_goes_at_an_even_speed_and_turns_slowly(seen, some):
    places = np.array([moment.stand.place[:2] for moment in some])
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert len(some) == pytest.approx(route.length(seen[1]) / 1.5 * 4, abs=1)
    assert steps.max() < 1.5 / 4 * 1.1 and steps[1:-1].min() > 0
    turns = np.diff([moment.stand.yaw for moment in some])
    assert np.abs(turns).max() <= film.TURN / 4 + 1e-9
    wanted = np.array([stand.yaw for stand in route.along(seen[1], len(some), CONFIG.robot)])
    off = np.abs((np.array([moment.stand.yaw for moment in some]) - wanted + np.pi) % (2 * np.pi) - np.pi)
    assert np.median(off) < 0.1 < np.abs(turns).max()


def test_doors_open_once_before_the_camera_is_there(seen, some):
    middles = film.doors(seen[1])
    assert middles and not some[0].doors or len(dict(some[0].doors)) < len(middles)
    for name, middle in middles.items():
        shares = [dict(moment.doors).get(name, 0.0) for moment in some]
        far = [float(np.linalg.norm(moment.stand.place[:2] - middle)) for moment in some]
        assert (np.diff(shares) >= 0).all()
        assert all(share == 1 for share, d in zip(shares, far) if d < 1.0)
        assert all(share == 0 for k, share in enumerate(shares) if min(far[: k + 1]) > film.NEAR)


def test_a_shut_door_is_met_and_an_open_one_is_not(seen):
    scene, home = seen
    name, middle = next(iter(film.doors(home).items()))
    opening = next(o for o in home.plan.openings if o.id == next(b.id for b in home.bodies if b.name == name))
    a, b = np.array(opening.segment)
    across = np.array([-(b - a)[1], (b - a)[0]]) / np.linalg.norm(b - a)
    start, way = np.array([[*(middle - 0.3 * across), 1.0]], np.float32), np.array([[*across, 0.0]], np.float32)
    shut = ajar_world(home, scene, {}).every.first(start, way).distance[0]
    open_ = ajar_world(home, scene, {name: 1.0}).every.first(start, way).distance[0]
    assert shut < 0.6 < open_


def test_the_film_has_the_frames_that_are_listed(seen, some, tmp_path):
    av = pytest.importorskip("av")
    few = RenderConfig(width=64, height=48, rate=1, speed=2.0)
    shown = film.filmed(*seen, few, TILT, tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {film.FILE, film.WAY} and shown.file == film.FILE
    told = json.loads((tmp_path / film.WAY).read_text())
    with av.open(str(tmp_path / film.FILE)) as container:
        frames = [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]
    assert len(frames) == len(told["frames"]) and frames[0].shape == (48, 64, 3)
    first, last = (np.array(told["frames"][k]["pose"]) for k in (0, -1))
    assert first[2, 3] == last[2, 3] == pytest.approx(few.robot)
    assert np.abs(frames[0].astype(int) - frames[-1]).mean() > 5


def test_without_an_encoder_it_is_said_what_to_install(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(BadInput, match=r"apartgen\[video\]"):
        film.encoder()


def test_a_straight_way_of_two_points_is_gone_along_too(monkeypatch):
    monkeypatch.setattr(route, "_through", lambda world: np.array([[0.0, 1.0], [2.0, 1.0]]))
    found = route.along(SimpleNamespace(room_at=lambda place: np.zeros(len(place))), 3, 1.2)
    assert [(*stand.place, stand.yaw) for stand in found] == [(0, 1, 1.2, 0), (1, 1, 1.2, 0), (2, 1, 1.2, 0)]
