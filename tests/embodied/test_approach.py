"""How the manipulator gets to its work: driven, parked, planned from where it rests, against friction."""

from types import SimpleNamespace

import numpy as np
import pytest
from embodied.test_interact import CARCASS, HIGH, block, chest, drawer, flat, link, opened  # noqa: F401 (a fixture)

from apartgen.schemas.retrieve import Joint
from apartgen.stages.embodied import base, drive, floor, interact, world
from apartgen.stages.embodied.interact import act, ground, stand
from apartgen.stages.embodied.interact.ground import Ground
from apartgen.stages.embodied.interact.plan import Planner


def test_the_arm_begins_where_the_drive_has_ended(flat):  # noqa: F811
    (outcome,) = interact.run(flat(drawer(), chest(3.7, 2.0, np.pi, id="one")), only="one")
    assert outcome.success and outcome.numbers["drives"] == 1 and outcome.numbers["metres"] > 1.5
    assert outcome.numbers["driving"] > outcome.numbers["metres"] / base.SPEED
    times, poses = np.array(outcome.trace.times), np.array(outcome.trace.qpos)[:, :3]
    arrived = np.searchsorted(times, 0.0)
    assert times[0] == pytest.approx(-interact.ARRIVES, abs=0.05) and arrived > 20
    assert np.hypot(*np.diff(poses[: arrived + 1, :2], axis=0).T).max() <= base.SPEED * np.diff(times).max() + 1e-3
    assert np.hypot(*(poses[0] - poses[arrived])[:2]) > 0.05
    assert np.ptp(poses[arrived:, :2], axis=0).max() < 0.01


def test_it_parks_where_it_was_sent(flat):  # noqa: F811
    here = Ground(flat(drawer(), chest(0.3, 2.6), block("sofa", 2.5, 2.4, id="sofa")))
    some = here.cells[np.random.default_rng(0).permutation(len(here.cells))[:12]]
    for k, (x, y) in enumerate(some):
        came = here.drive(np.array([x, y, k - 6.0]))
        assert came.reason == "" and came.push == 0
        # Turning on the spot takes it some centimetres off.
        assert np.hypot(came.pose[0] - x, came.pose[1] - y) < 0.07
        assert np.cos(came.pose[2] - (k - 6.0)) > np.cos(ground.FACING + 0.02)


def test_what_is_run_against_on_the_way_fails_the_episode(flat, monkeypatch):  # noqa: F811
    survey = floor.survey
    row = [block("sofa", 2.0, y, id=f"unseen_{k}") for k, y in enumerate((0.5, 1.45, 2.4))]
    apartment = flat(drawer(), chest(3.7, 1.45, np.pi, id="one"), *row)
    blind = [name for name in floor.standing(apartment) if name.startswith("unseen")]
    assert opened(apartment).reason == "no way from the entrance" and blind
    monkeypatch.setattr(drive, "_CLEAR", np.inf)  # simulate it all, whatever the map says
    monkeypatch.setattr(floor, "survey", lambda world, radius, without: survey(world, radius, without=blind))
    (outcome,) = interact.run(apartment, only="one")
    assert outcome.failure == "controller" and outcome.reason == "ran against unseen_1 on its way there"
    assert outcome.numbers["push"] > 15
    # The trace is the drive, which has not got there.
    assert outcome.trace.qpos[0][0] < 0.7 and outcome.trace.qpos[-1][0] < 2.0


def test_parts_of_an_object_are_opened_from_one_place_where_that_does(flat):  # noqa: F811
    x = HIGH[0]
    made = [CARCASS]
    for k, z in enumerate((-0.3, 0.1)):
        boxes = [((x - 0.06, -0.35, z), (x - 0.03, 0.35, z + 0.2)), ((x - 0.01, -0.15, z + 0.09), (x, 0.15, z + 0.11))]
        joint = Joint(name=f"drawer_{k}", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, 0.3), part="drawer")
        made.append(link(f"drawer_{k}", boxes, 5.0, joint, np.array([x, 0.0, z + 0.1])))
    first, second = interact.run(flat(made, chest(0.3, 2.0)))
    assert first.success and second.success
    assert first.numbers["drives"] >= 1 and second.numbers["drives"] == 0
    assert first.numbers["metres"] == second.numbers["metres"]


def test_where_the_base_rests_badly_another_place_is_driven_to(flat, monkeypatch):  # noqa: F811
    plan, asked = Planner.plan, []

    def once_astray(self, pose, *ways):
        asked.append(tuple(pose))
        rests = [pose for pose in asked if not round(pose[0] / 0.0125, 6).is_integer()]
        return None if tuple(pose) in rests and rests[0] == tuple(pose) else plan(self, pose, *ways)

    monkeypatch.setattr(Planner, "plan", once_astray)
    outcome = opened(flat(drawer(), chest(0.3, 2.0)))
    assert outcome.success and outcome.numbers["drives"] >= 2
    monkeypatch.setattr(Planner, "plan", plan)
    monkeypatch.setattr(stand, "DRIVES", 1)
    monkeypatch.setattr(stand._Search, "_fitting", lambda self, some: iter([s for s in some if s.came is None]))
    outcome = opened(flat(drawer(), chest(0.3, 2.0)))
    assert outcome.failure == "planner" and "where the base rests" in outcome.reason


def test_places_that_an_open_leaf_takes_are_driven_to_without_it(flat):  # noqa: F811
    apartment = flat(drawer(), chest(0.3, 2.6))
    leaves = interact.room_doors(apartment)
    open_ = Ground(apartment)
    shut = Ground(apartment, leaves, open_)
    known = {tuple(np.round(cell, 6)) for cell in open_.cells}
    assert leaves and len(shut.cells) and not any(tuple(np.round(cell, 6)) in known for cell in shut.cells)
    # The leaf is 0.9 m long and stands open along y = 1 or y = 1.9 in the bedroom.
    x, y = shut.cells[np.argmax(shut.floor.beside(shut.cells))]
    assert 4.1 < x < 5.3 and 0.5 < y < 2.4
    came = shut.drive(np.array([x, y, 0.0]))
    assert came.reason == "" and np.hypot(came.pose[0] - x, came.pose[1] - y) < 0.07


def test_the_joint_is_opened_against_friction(flat, monkeypatch):  # noqa: F811
    force = {}
    for least in (1.0, 21.0):
        monkeypatch.setattr(act, "LEAST_FRICTION", least)
        outcome = opened(flat(drawer(), chest(0.3, 2.0)))
        assert outcome.success
        force[least] = outcome.numbers["force"]
    assert force[21.0] - force[1.0] == pytest.approx(20, abs=2)
    assert force[1.0] > 1.0 + act.FRICTION * 5.0 * 9.81
    monkeypatch.setattr(act, "LEAST_FRICTION", 70.0)
    assert "slipped" in opened(flat(drawer(), chest(0.3, 2.0))).reason


def test_a_heavier_base_drives_the_same_ways(flat):  # noqa: F811
    apartment = flat(drawer(), chest(0.3, 2.6))
    light, heavy = Ground(apartment), Ground(apartment)
    light.__dict__["_worlds"] = tuple(
        world.build(apartment.scene, apartment.mjcf, base.mjcf(), moving=(), fused=True, without=without)
        for without in ((), floor.above_ground(apartment))
    )
    models = [here._worlds[0].model for here in (light, heavy)]
    masses = [float(model.body_subtreemass[model.body("robot_base").id]) for model in models]
    assert masses == pytest.approx([base.MASS, interact.robot.MASS])
    at = np.array([*heavy.cells[len(heavy.cells) // 2], 1.0])
    a, b = light.drive(at), heavy.drive(at)
    assert a.reason == b.reason == "" and b.metres == pytest.approx(a.metres, rel=1e-3)
    assert b.seconds == pytest.approx(a.seconds, rel=0.02)


@pytest.mark.parametrize("met, fits", [
    ((-1, -1, -1), True), ((-1, -1, 0), False), ((0, 0, 0), False), ((7, -1, -1), False)])
def test_where_anything_is_met_while_the_part_moves_the_robot_does_not_stand(met, fits):
    """Geoms are numbered from 0; -1 is none."""
    probe = SimpleNamespace(hit=lambda posture, part, value: met[round(value * 2)])
    planner = SimpleNamespace(probe=probe, part=None, values=np.array([0.0, 0.5, 1.0]))
    search = stand._Search.__new__(stand._Search)
    search.planner, search.part = planner, None
    place = stand.Stand(np.zeros(3))
    assert list(search._fitting([place])) == ([place] if fits else [])
