"""Grasps are tried: a gripper of 80 mm stroke closes with 30 N, lifts by 10 cm and holds for two seconds."""

import mujoco
import numpy as np
import pytest
from inhabited import library, lived_in, things

from apartgen.stages.retrieve import furniture
from apartgen.stages.things import small
from apartgen.stages.things.asset import Collider, Link
from apartgen.stages.things.body import inertia
from apartgen.stages.things.grasps import TIP, WIDEST, _heights, holds
from apartgen.stages.things.solids import corners

STROKE, FORCE, LIFT, STEP = 0.08, 30.0, 0.1, 0.004
HEAVIEST = 1.0
"""What such a gripper is asked to lift, kg."""
SCENE = """<mujoco><option timestep="{step}" cone="elliptic" impratio="10" integrator="implicitfast"/>
<default><geom condim="4" solref="0.008 1"/></default><worldbody>
<geom type="box" size="{foot} 0.25" pos="{under} 0.25" contype="2" conaffinity="2"/>
<body name="thing" pos="0 0 {z}"><freejoint/>{mass}{geoms}</body>
<body pos="{at}"><joint name="lift" type="slide" axis="0 0 1" damping="200"/><inertial pos="0 0 0" mass="1"
diaginertia=".01 .01 .01"/>
<body quat="{turn}"><joint name="left" type="slide" axis="-1 0 0" damping="10"/>
<geom type="box" size=".004 .01 .02" pos="{open} 0 -.01" mass=".05" friction="1"/></body>
<body quat="{turn}"><joint name="right" type="slide" axis="1 0 0" damping="10"/>
<geom type="box" size=".004 .01 .02" pos="-{open} 0 -.01" mass=".05" friction="1"/></body></body></worldbody>
<equality><joint joint1="left" joint2="right"/></equality>
<actuator><position joint="lift" kp="20000" forcerange="-500 500"/><motor joint="left"/><motor joint="right"/>
</actuator></mujoco>"""


def numbers(values):
    return " ".join(f"{v:.9f}" for v in values)


def geom(piece, friction):
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.ascontiguousarray(piece.rotation).ravel())
    size = piece.size / 2 if piece.kind == "box" else piece.size[[0, 2]] * [1, 0.5]
    return (f'<geom type="{piece.kind}" size="{numbers(size)}" pos="{numbers(piece.center)}" quat="{numbers(quat)}" '
            f'friction="{friction}" contype="3" conaffinity="3" mass="0"/>')


def lifted(asset, hold):
    """Whether a thing that stands on a post comes up with the gripper and stays in it."""
    (link,) = asset.links
    mass, center, tensor = inertia(link)
    points = np.concatenate([corners(c) for c in link.colliders])
    foot = points[points[:, 2] < points[:, 2].min() + 1e-4][:, :2]
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, np.stack([hold.close, np.cross(hold.approach, hold.close), hold.approach], 1).ravel())
    full = [tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]]
    z = 0.5 + asset.size[2] / 2
    model = mujoco.MjModel.from_xml_string(SCENE.format(
        step=STEP, foot=numbers(np.maximum(np.ptp(foot, axis=0) * 0.3, 0.004)),
        under=numbers((foot.min(0) + foot.max(0)) / 2), z=z + 0.0005, turn=numbers(quat),
        mass=f'<inertial pos="{numbers(center)}" mass="{mass}" fullinertia="{numbers(full)}"/>',
        geoms="".join(geom(piece, link.friction) for piece in link.colliders),
        at=numbers(hold.at + [0, 0, z]), open=hold.width / 2 + 0.004))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.body("thing").xpos[2]
    while data.time < 3.3:
        data.ctrl[:] = LIFT * np.clip(data.time - 0.3, 0, 1), *[FORCE * min(1, data.time / 0.1)] * 2
        mujoco.mj_step(model, data)
    return data.body("thing").xpos[2] - start > 0.85 * LIFT


def test_what_one_hand_holds_is_lifted():
    rng, outcomes = np.random.default_rng(11), {}
    for name, kind in small.TABLE.items():
        asset = furniture.load_asset(small.drawn(kind, rng).id())
        if not kind.fixed and min(asset.size) <= WIDEST and asset.links[0].mass <= HEAVIEST:
            outcomes[name] = lifted(asset, holds(asset.links[0])[0])
    assert len(outcomes) > 40
    assert sum(outcomes.values()) >= 0.95 * len(outcomes), [name for name, held in outcomes.items() if not held]


@pytest.mark.parametrize("name", [name for name, kind in small.TABLE.items() if not kind.fixed])
def test_holds_are_within_the_stroke_and_across_the_thing(name):
    asset = furniture.load_asset(small.drawn(small.TABLE[name], np.random.default_rng(2)).id())
    half = np.array(asset.size) / 2
    for hold in holds(asset.links[0]):
        assert hold.width <= STROKE and (np.abs(hold.at[:2]) <= half[:2] + 1e-6).all()
        assert -half[2] - 1e-6 <= hold.at[2] <= max(half[2], TIP + 0.002 - half[2]) + 1e-6
        lowest = hold.at[2] + min(TIP * hold.approach[2], 0)
        assert hold.close[2] == 1 or lowest > -half[2], "the tips are in what it stands on"
        assert abs(hold.approach @ hold.close) < 1e-9
        assert np.isclose(np.linalg.norm([hold.approach, hold.close], axis=1), 1).all()


def test_things_in_a_home_say_how_they_are_held():
    free = [o for o in things(lived_in(0)) if o.on != "wall"]
    narrow = [o for o in free if min(o.size) <= WIDEST
              and library().load_asset(o.asset.library, o.asset.id).links[0].mass <= HEAVIEST]
    assert all(o.grasps for o in narrow) and len(narrow) > 0.5 * len(free)


def room_for_fingers(asset, hold):
    """Whether open fingers touch neither the thing nor the ground that it stands on."""
    (link,) = asset.links
    turn = np.stack([hold.close, np.cross(hold.approach, hold.close), hold.approach], 1)
    quat = np.zeros(4)
    mujoco.mju_mat2Quat(quat, turn.ravel())
    at = [hold.at + turn @ [side * (hold.width / 2 + 0.004), 0, TIP - 0.02] for side in (-1, 1)]
    fingers = "".join(f'<geom type="box" size=".004 .01 .02" pos="{numbers(a)}" quat="{numbers(quat)}"/>' for a in at)
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><worldbody><geom type="plane" size="1 1 1" pos="0 0 {-asset.size[2] / 2}"/>'
        f'{"".join(geom(piece, 1) for piece in link.colliders)}<body><freejoint/><inertial pos="0 0 0" mass="1" '
        f'diaginertia=".01 .01 .01"/>{fingers}</body></worldbody></mujoco>')
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return not any(contact.dist < -1e-5 for contact in data.contact[:data.ncon])


@pytest.mark.parametrize("name", ["plate", "cup", "mug", "game_controller", "clothes", "towel"])
def test_rims_handles_and_edges_are_held_from_a_table(name):
    rng = np.random.default_rng(3)
    for _ in range(6):
        asset = furniture.load_asset(small.drawn(small.TABLE[name], rng).id())
        assert any(room_for_fingers(asset, hold) for hold in holds(asset.links[0])), asset.id


def test_a_bar_is_held_first_above_its_middle_and_else_a_quarter_of_it_aside():
    solid = Collider("box", np.array([0.3, 0.0, 0.02]), np.array([0.2, 0.03, 0.04]))
    bar = Link("bar", [], [solid], 0.1)
    above = [hold for hold in holds(bar) if hold.approach[2] == -1 and hold.close[1]]
    assert above[0].at[:2] == pytest.approx([0.3, 0.0])
    assert sorted({round(float(hold.at[0]), 6) for hold in above}) == pytest.approx([0.25, 0.3, 0.35])


@pytest.mark.parametrize(("bottom", "middle", "heights"), [
    (0.0, 0.039, [0.09, 0.07, 0.039]), (0.0, 0.05, [0.09, 0.07]), (0.06, 0.08, [0.09, 0.07]), (0.08, 0.09, [0.09]),
    (0.095, 0.0975, [0.09])])
def test_a_thing_is_held_a_bite_below_its_top_and_never_below_its_bottom(bottom, middle, heights):
    """Bites of 1 and 3 cm of what ends at .1 m; the first always, the middle if over 6 cm below the top."""
    assert _heights(0.1, middle, bottom, 0.0) == pytest.approx(heights)
    assert min(_heights(0.1, middle, bottom, 0.08)) >= 0.08
