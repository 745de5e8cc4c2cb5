"""Replays look from where something can be seen, and show why an episode failed."""

import importlib
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from embodied import blocks
from embodied.test_interact import block, chest, drawer, load
from handmade import home
from mujoco.rendering.classic import gl_context
from PIL import Image
from shapely.geometry import Point

from apartgen.stages.embodied import base, interact, marks, navigate, replay, world
from apartgen.stages.embodied.outcome import Outcome, Trace
from apartgen.stages.export import mjcf
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import polygons

SMALL = (160, 120)


@pytest.fixture
def drawing(monkeypatch):
    """Draws without a display, whatever MuJoCo was told when it was imported."""
    try:
        egl = importlib.import_module("mujoco.egl")
    except (ImportError, AttributeError):
        pytest.skip("needs EGL")
    monkeypatch.setattr(gl_context, "GLContext", egl.GLContext)


@pytest.mark.parametrize("width, level", [(6.0, True), (0.9, False)])
def test_no_wall_is_between_an_object_and_the_eye_or_it_looks_from_above(width, level):
    plan = blocks.corridor(6, width)
    at, yaw = np.array([3.0, 0.3]), np.pi / 2
    far, steep, azimuth = replay._view(SimpleNamespace(home=plan), at, yaw)
    # MuJoCo's camera looks along its azimuth.
    eye = at - far * np.cos(np.radians(steep)) * np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
    assert polygons.free_floor(plan).buffer(0.03).contains(Point(eye)) and eye[1] > at[1]
    assert (steep == replay.STEEP[0]) == level and far in replay.DISTANCES


def frames(apartment, outcome, robot=None):
    return np.stack(list(replay.images(apartment, robot or base.mjcf(), outcome, SMALL))).astype(int)


def differ(some, other):
    """How many pixels of the last frames do."""
    return int((np.abs(some[-1] - other[-1]).max(-1) > 12).sum())


def coloured(picture, channel):
    """How many pixels have much more of one colour than of the others."""
    rest = np.delete(picture, channel, axis=-1).max(-1)
    return int((picture[..., channel] > rest + 60).sum())


def shut_off(folder, *more):
    """A corridor shut by a wall of boxes, with something to go to behind it, and the base in it."""
    goal = blocks.block("goal", 5.6, 0.8, 0.6, 0.8, np.pi)
    wall = blocks.block("wall", 3.0, 0.8, 0.3, 1.6)
    plan = blocks.furnished(blocks.corridor(6, 1.6), wall, goal, *more)
    return world.build(*blocks.exported(plan, folder), base.mjcf(), moving=(), fused=True, name="home-1")


def failed(failure, **more):
    fields = dict(apartment="home-1", episode="navigation", room="hallway_1", object="goal", category="bookshelf",
                  success=False, failure=failure, reason="no way", numbers={"spl": 0.0})
    return Outcome.model_validate(fields | more)


def test_a_robot_with_no_place_to_go_is_shown_at_the_entrance_with_the_floor_it_gets_to(
    tmp_path, drawing, monkeypatch
):
    apartment, outcome = shut_off(tmp_path), failed("planner")
    shown = frames(apartment, outcome)
    assert len(shown) == 1 and coloured(shown[0], 1) > 100 and coloured(shown[0], 2) > 30
    unseen = base.mjcf().replace('rgba="0.2 0.2 0.25 1"', 'rgba="0.2 0.2 0.25 0"')
    assert differ(shown, frames(apartment, outcome, unseen)) > 30
    for name, least in (("put", 200), ("paint", 30)):
        with monkeypatch.context() as bare:
            bare.setattr(marks, name, lambda *_: None)
            assert differ(shown, frames(apartment, outcome)) > least


def test_floor_beyond_what_is_shut_off_has_a_colour_of_its_own(tmp_path):
    apartment = shut_off(tmp_path)
    _, drawn = replay._start(apartment, failed("planner"))
    for colour, side in ((marks.REACHED, -1), (marks.CUT_OFF, 1)):
        ends = [point[0] for mark in drawn if mark.colour == colour for point in (mark.a, mark.b)]
        assert len(ends) > 40 and all(side * (x - 3.0) > 0.3 for x in ends)


def test_a_robot_at_a_blocked_entrance_is_shown_in_what_blocks_it(tmp_path, drawing):
    apartment = shut_off(tmp_path, blocks.block("crate", 0.4, 0.8, 0.8, 1.6))
    (outcome,) = navigate.run(apartment, np.random.default_rng(0))
    assert outcome.reason == "the entrance is blocked" and outcome.trace is None
    trace, drawn = replay._start(apartment, outcome)
    assert 0 < trace.qpos[0][0] < 0.8 and not any(mark.colour == marks.REACHED for mark in drawn)
    assert len(frames(apartment, outcome)) == 1


def test_an_empty_room_that_is_cut_off_is_outlined(tmp_path):
    apartment, outcome = shut_off(tmp_path), failed("planner", object="hallway_1")
    drawn = replay._painted(apartment, outcome, Trace(joints=[]), lost=True)
    assert {tuple(mark.a[:2]) for mark in drawn} == {(0, 0), (6, 0), (6, 1.6), (0, 1.6)}


def test_a_drive_shows_its_goal_and_what_it_ran_against(tmp_path, drawing):
    apartment = shut_off(tmp_path)
    trace = Trace(joints=list(base.JOINTS), times=[0.0, 0.2], qpos=[[x, 0.8, 0, 1, 0, 0, 0] for x in (1.0, 1.5)])
    pose = {"goal_x": 4.5, "goal_y": 0.8, "goal_yaw": 0.0}
    with_goal, without, hit = (frames(apartment, failed("controller", trace=trace, reason=reason, numbers=numbers))
                               for reason, numbers in (("stuck", pose), ("stuck", {}), ("ran against wall", pose)))
    assert len(with_goal) == 2 and differ(with_goal, with_goal[:1]) > 20
    assert coloured(with_goal[-1], 1) > coloured(without[-1], 1) + 10 and differ(with_goal, hit) > 30
    assert coloured(hit[-1], 0) > coloured(with_goal[-1], 0) + 30


JOINTS = [link.joint for link in drawer() if link.joint]


def kitchen(folder, *objects):
    scene = Scene(home(*objects), lambda library, id: load(drawer(), library, id))
    mjcf.write(scene, folder)
    return world.build(scene, folder / "mjcf" / "apartment.xml", name="home-1")


def test_a_part_that_is_blocked_from_the_start_goes_on_through_what_blocks_it(tmp_path, drawing, monkeypatch):
    apartment = kitchen(tmp_path, chest(0.3, 2.0, id="one", joints=JOINTS), block("chair", 0.805, 2.0, id="near"))
    (outcome,) = interact.run(apartment, only="one")
    assert outcome.failure == "blocked part" and outcome.reason.startswith("meets near at 5%")
    shown = frames(apartment, outcome, interact.mjcf())
    assert len({frame.tobytes() for frame in shown}) > 10
    assert coloured(shown[0], 0) > 100
    paint = marks.paint
    for colour in (marks.MEANT, marks.MET):
        with monkeypatch.context() as bare:
            bare.setattr(marks, "paint", lambda *asked, out=colour: asked[-1] == out or paint(*asked))
            first = next(replay.images(apartment, interact.mjcf(), outcome, SMALL))
            assert differ(shown[:1], [first.astype(int)]) > 50
    gif, png = replay.save(shown.astype(np.uint8), tmp_path / "shown" / "it.gif", outcome)
    assert Image.open(gif).n_frames > 10 and Image.open(png).size == SMALL
    assert differ(shown, np.asarray(Image.open(png))[None].astype(int)) > 30  # its caption


def test_a_part_that_no_robot_gets_to_is_seen_from_above(tmp_path, drawing):
    apartment = kitchen(tmp_path, chest(0.3, 2.0, id="one", joints=JOINTS))
    names = [*(interact.robot.joint(name) for name in interact.robot.NAMES),
             apartment.bodies["one"].joint_name(apartment.bodies["one"].links[1].joint)]
    waits = Trace(joints=names, times=[0.0, 0.05], qpos=[[interact.FAR] * 3 + [0.2] + [0.0] * 10] * 2)
    outcome = failed("planner", episode="interaction", object="one", room="living_room_1", joint="drawer", trace=waits)
    shown = frames(apartment, outcome, interact.mjcf())
    assert len(shown) == 1 and coloured(shown[0], 1) > 200 and coloured(shown[0], 2) > 20


def test_an_opened_part_is_seen_from_nearby_once_the_robot_comes_and_a_drive_that_failed_from_above(tmp_path, drawing):
    apartment = kitchen(tmp_path, chest(3.7, 1.45, np.pi, id="one", joints=JOINTS))
    (opened,) = interact.run(apartment, only="one")
    arrives = opened.trace.times.index(min(t for t in opened.trace.times if t >= 0))
    assert opened.success and opened.trace.times[0] < -2
    gone = opened.trace.model_copy(update={"qpos": [[0.4, *values[1:]] for values in opened.trace.qpos]})
    lost = opened.model_copy(update={"trace": gone, "success": False, "failure": "controller", "reason": "stuck"})
    shown = world.build(apartment.scene, apartment.mjcf, interact.mjcf(), visuals=True)
    near, far = (replay._camera(shown, o, replay._on_its_way(shown, o)).distance for o in (opened, lost))
    assert near <= max(replay.DISTANCES) < far
    pictures = list(replay.images(apartment, interact.mjcf(), opened, SMALL))
    gif, _ = replay.save(pictures, tmp_path / "it.gif", opened)
    assert Image.open(gif).info["duration"] == pytest.approx(1000 / interact.FRAMES, abs=10)
    assert differ(np.array(pictures[:1], int), np.array([pictures[arrives]], int)) > 100


def test_where_nothing_can_be_drawn_it_is_said(monkeypatch):
    def broken(*_):
        raise mujoco.FatalError("no context")

    monkeypatch.setattr(mujoco, "Renderer", broken)
    with pytest.raises(RuntimeError, match="no context"):
        replay.ready()


def test_colours_are_of_light_that_can_be_shown():
    """A part of more than all light is drawn as all of it, and by another renderer as none."""
    found = (marks.MEANT, marks.MET, marks.GOAL, marks.TRAIL, marks.REACHED, marks.CUT_OFF)
    assert all(0.0 <= part <= 1.0 for colour in found for part in colour)
    assert len({colour[:3] for colour in found}) == len(found), "they are told apart"
