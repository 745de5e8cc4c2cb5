"""Drift and joint travel in worlds worked out by hand."""

import pytest

from apartgen.stages.metrics import _physics
from apartgen_cli.bench import physics as bench_physics

pytest.importorskip("mujoco")

FRAME = """<mujoco><compiler angle="radian"/><option timestep="0.004"/><worldbody>
<geom name="floor" type="plane" size="5 5 0.1"/>{}</worldbody></mujoco>"""
DRAWER = """<body name="chest" pos="0 0 0.3"><body name="drawer">
<joint name="slide" type="slide" axis="1 0 0" range="0 0.4"/>
<geom type="box" size="0.2 0.2 0.1" mass="3" contype="1" conaffinity="2"/></body></body>"""


def world(tmp_path, *bodies):
    path = tmp_path / "world.xml"
    path.write_text(FRAME.format("".join(bodies)))
    return _physics.mjcf_model(path)


def box(name, x, z, size=0.1):
    return (f'<body name="{name}" pos="{x} 1 {z}"><freejoint/><geom type="box" size="{size} {size} {size}" '
            f'mass="1" contype="1" conaffinity="1"/></body>')


def test_what_rests_stays_and_what_hangs_falls(tmp_path):
    found = _physics.drift(world(tmp_path, box("rests", 0, 0.1), box("hangs", 1, 0.4)))
    assert found["rests"] < 0.005 and found["hangs"] == pytest.approx(0.3, abs=0.01)


def test_things_are_left_alone_for_two_seconds(tmp_path):
    """What falls through a world without a floor falls by half of g t squared."""
    path = tmp_path / "bare.xml"
    path.write_text(FRAME.replace('<geom name="floor" type="plane" size="5 5 0.1"/>', "").format(box("falls", 0, 0)))
    assert _physics.drift(_physics.mjcf_model(path))["falls"] == pytest.approx(9.81 * 2.0**2 / 2, abs=0.1)


def test_a_drawer_comes_out_as_far_as_it_is_let(tmp_path):
    (free,) = _physics.travels(world(tmp_path, DRAWER))
    assert free.joint == "slide" and free.share == 1
    # A post whose near face is 0.1 m before the drawer's front lets it out by a quarter of its travel.
    post = '<geom type="box" pos="0.4 0 0.3" size="0.1 0.3 0.3" contype="2" conaffinity="1"/>'
    (blocked,) = _physics.travels(world(tmp_path, DRAWER, post))
    assert blocked.share == pytest.approx(0.25, abs=0.03)


def test_a_hinge_is_driven_to_the_end_farther_from_where_it_rests(tmp_path):
    door = """<body name="door" pos="0 0 1"><joint name="hinge" type="hinge" axis="0 0 1" range="-1.5 0.1"/>
    <geom type="box" pos="0.4 0 0" size="0.4 0.02 0.9" mass="8"/></body>"""
    assert _physics.travels(world(tmp_path, door))[0].share == 1


def test_joints_far_apart_are_driven_together_and_near_ones_alone(tmp_path):
    # A drawer that meets the next one's only when both come out, and a third one far away, blocked by a post.
    def chest(name, x, y, turn):
        return (f'<body name="{name}" pos="{x} {y} 0.3" euler="0 0 {turn}"><joint name="{name}" type="slide" '
                'axis="1 0 0" range="0 0.4"/><geom type="box" size="0.2 0.2 0.1" mass="3" contype="1" '
                'conaffinity="3"/></body>')
    post = '<geom type="box" pos="8.4 0 0.3" size="0.1 0.3 0.3" contype="2" conaffinity="1"/>'
    model = world(tmp_path, chest("a", 0, 0, 0), chest("b", 0.9, 0, 3.14159265), chest("far", 8, 0, 0), post)
    assert [len(batch) for batch in _physics._batches(model, [0, 1, 2])] == [2, 1]
    found = {travel.joint: travel.share for travel in _physics.travels(model)}
    assert found["a"] == found["b"] == 1 and found["far"] == pytest.approx(0.25, abs=0.03)


def test_what_is_told_of_the_bench_is_what_it_counts():
    told = bench_physics.NOTE
    for words in (f"less than {100 * _physics.DRIFT:g} cm in {_physics.SETTLE:g} s", f"{_physics.FORCE:g} N",
                  f"nothing within {_physics.APART:g} m", f"at least {100 * _physics.REACHED:g} %"):
        assert words in told, words
