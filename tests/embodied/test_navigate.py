"""Navigation on floors whose answer is known beforehand."""

import handmade
import mujoco
import numpy as np
import pytest
from embodied import blocks

from apartgen.stages.embodied import base, floor, goals, navigate, planner, world
from apartgen.stages.embodied.drive import GRAZE, STEP, drive, felt
from apartgen.stages.embodied.pursuit import Pursuit


def _run(home, folder, seed=0, **more):
    apartment = world.build(*blocks.exported(home, folder), base.mjcf(), moving=(), fused=True, name="home-1")
    return navigate.run(apartment, np.random.default_rng(seed), **more)


def _beyond(gap, x=3.0, width=1.6):
    """A corridor closed but for a gap in its middle, and something to go to behind it."""
    side = (width - gap) / 2
    walls = [blocks.block("low", x, side / 2, 0.3, side), blocks.block("high", x, width - side / 2, 0.3, side)]
    return blocks.furnished(blocks.corridor(6, width), *walls, blocks.block("goal", 5.75, width / 2, 0.4, 0.6, np.pi))


def _to(id, home, folder):
    """The episode to one object, whichever the draw would choose."""
    others = [o.model_copy(update={"room": "elsewhere"}) if o.id != id else o for o in home.objects]
    found = _run(home.model_copy(update={"objects": others}), folder)
    return next(o for o in found if o.object == id)


def test_a_straight_corridor_is_driven_straight(tmp_path):
    home = blocks.furnished(blocks.corridor(7, 1.2), blocks.block("goal", 6.7, 0.6, 0.4, 0.6, np.pi))
    (outcome,) = _run(home, tmp_path)
    assert outcome.success and outcome.numbers["spl"] == pytest.approx(1.0, abs=0.01)
    assert outcome.numbers["touches"] == 0 and outcome.numbers["missed"] <= 0.25
    # 5 m and more at 0.5 m/s, with a start and a stop.
    assert outcome.numbers["metres"] / base.SPEED < outcome.numbers["seconds"] < 2.5 * outcome.numbers["metres"] / 0.5


@pytest.mark.parametrize("gap, passes", [(0.48, False), (0.60, True), (0.70, True)])
def test_gaps_wider_than_the_robot_are_passed(tmp_path, gap, passes):
    outcome = _to("goal", _beyond(gap), tmp_path)
    assert outcome.success == passes and outcome.failure == (None if passes else "planner"), outcome.reason


def test_a_chair_in_the_only_doorway_shuts_off_the_room_behind(tmp_path):
    things = [
        blocks.block("shelf", 0.3, 2.7, 0.3, 0.5, -np.pi / 2, handmade.LIVING),
        blocks.block("bed", 6.5, 0.5, 0.6, 0.6, np.pi, handmade.BEDROOM),
    ]
    chair = blocks.block("chair", 4.05, 1.45, 0.5, 0.5, 0, handmade.LIVING, category="chair")
    free = {o.object: o for o in _run(blocks.furnished(handmade.plan(), *things), tmp_path / "free")}
    assert all(o.success for o in free.values()) and set(free) == {"shelf", "bed"}
    blocked = {o.room: o for o in _run(blocks.furnished(handmade.plan(), *things, chair), tmp_path / "blocked")}
    assert blocked[handmade.BEDROOM].failure == "planner" and blocked[handmade.LIVING].success


def test_what_opens_must_be_reached_from_its_front(tmp_path):
    home = blocks.furnished(blocks.corridor(6, 2), blocks.block("cupboard", 4.0, 1.7, 0.4, 0.8, np.pi / 2))
    still = world.build(*blocks.exported(home, tmp_path), moving=())
    ground = floor.survey(still)
    o = home.objects[0]
    assert goals.goals(ground, [o], ground.free, np.random.default_rng(0))[0].cell
    opening = o.model_copy(update={"joints": [handmade.drawer(o.size)]})
    goal = goals.goals(ground, [opening], ground.free, np.random.default_rng(0))[0]
    assert goal.cell is None and goal.missing == "no standing room"


def test_a_plant_that_nobody_gets_to_is_no_goal_but_a_cupboard_is(tmp_path):
    things = [blocks.block("table", 3.0, 1.0, 0.6, 0.6), blocks.block("sofa_1", 5.3, 1.5, 0.3, 1.0),
              blocks.block("sofa_2", 5.3, 0.5, 0.3, 1.0), blocks.block("plant", 5.9, 1.0, 0.2, 0.2, np.pi)]
    home = blocks.furnished(blocks.corridor(6, 2), *things)
    ground = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=()))
    reached = ground.free & (np.arange(ground.grid.shape[1]) * ground.grid.resolution < 5.0)
    for joints, drawn in (([], False), ([handmade.drawer((0.2, 0.2, 1.0))], True)):
        objects = [o.model_copy(update={"joints": joints}) if o.id == "plant" else o for o in home.objects]
        goal = [goals.goals(ground, objects, reached, np.random.default_rng(k))[0] for k in range(20)]
        assert {g.object for g in goal} >= {"table"} and any(g.object == "plant" for g in goal) == drawn
        assert all(bool(g.missing) == (g.object == "plant") for g in goal)


def test_a_blocked_entrance_fails_every_room(tmp_path):
    home = blocks.furnished(blocks.corridor(6, 1.2), blocks.block("crate", 0.4, 0.6, 0.8, 1.2))
    (outcome,) = _run(home, tmp_path)
    assert (outcome.failure, outcome.reason) == ("planner", "the entrance is blocked")


def _unseen(home, folder, obstacle):
    """A drive by a map that lacks the obstacle."""
    blind = world.build(*blocks.exported(home, folder / "map"), moving=())
    ground = floor.survey(blind)
    cell, yaw = goals.start(ground)
    goal = goals.goals(ground, home.objects, ground.free, np.random.default_rng(0))[0]
    path = planner.roadmap(ground, cell).path(goal.cell)
    real = home.model_copy(update={"objects": [*home.objects, obstacle]})
    driven = world.build(*blocks.exported(real, folder / "real"), base.mjcf(), moving=(), fused=True)
    # Contacts are looked for where the map says that something is near: everywhere in a corridor this wide.
    assert ground.clearance.max() < base.RADIUS + 0.05
    return drive(driven, driven, Pursuit(ground, path, goal.yaw), yaw, 60.0)


def test_running_against_something_is_felt_and_ends_the_drive(tmp_path):
    home = blocks.furnished(blocks.corridor(6, 0.58), blocks.block("goal", 5.75, 0.29, 0.4, 0.5, np.pi))
    went = _unseen(home, tmp_path, blocks.block("post", 3.0, 0.29, 0.1, 0.1))
    assert went.push > GRAZE and went.reason == "ran against post" and not went.done
    assert went.touches >= 1
    assert went.pose[0] == pytest.approx(3.0 - 0.05 - base.RADIUS, abs=0.02)


def test_a_robot_that_gets_no_further_goes_from_point_to_point(tmp_path):
    home = blocks.furnished(blocks.corridor(6, 2))
    ground = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=()))
    pursuit = Pursuit(ground, np.stack([np.linspace(1, 5, 81), np.full(81, 1.0)], 1), 0.0)
    inching = [pursuit.inching for _ in range(70) if pursuit.command(1.0, 1.0, 1.0)]
    assert not any(inching[:60]) and inching[61] > 0


def test_where_contacts_are_not_looked_for_there_are_none_and_it_drives_alike(tmp_path, monkeypatch):
    home = _beyond(0.62)
    (some,) = _run(home, tmp_path, only="goal")
    monkeypatch.setattr("apartgen.stages.embodied.drive._CLEAR", 10.0)
    (fine,) = _run(home, tmp_path, only="goal")
    assert fine.success == some.success and fine.numbers["touches"] == some.numbers["touches"]
    for key, off in (("metres", 0.02), ("seconds", 0.6), ("missed", 0.02)):
        assert fine.numbers[key] == pytest.approx(some.numbers[key], abs=off)


@pytest.mark.parametrize("deep, hard", [(0.0003, False), (0.003, True)])
def test_pushes_are_felt_as_hard_as_the_skin_is_pressed(tmp_path, deep, hard):
    # A board abeam of the standing robot, so that its tyres hold it against the push.
    board = blocks.block("board", 3.0, 1.0 + base.RADIUS - deep + 0.05, 1.0, 0.1)
    scene, mjcf = blocks.exported(blocks.furnished(blocks.corridor(6, 2), board), tmp_path)
    built = world.build(scene, mjcf, base.mjcf(), moving=(), timestep=STEP)
    data = mujoco.MjData(built.model)
    data.qpos[:2] = 3.0, 1.0
    push, what = felt(built.model, data, 10, built.model.geom("robot_column").id)
    assert built.owner[what] == "board"
    # Two points of contact, less what the robot yields in that time.
    assert (push > GRAZE) == hard and 0.3 < push / (2 * base.STIFFNESS * deep) < 1.2


def test_the_same_seed_gives_the_same_episodes(tmp_path):
    things = [blocks.block(f"shelf_{k}", 2.0 + k, 1.8, 0.3, 0.5, -np.pi / 2) for k in range(3)]
    home = blocks.furnished(blocks.corridor(6, 2), *things)
    again = [_run(home, tmp_path / str(k), seed=k % 2) for k in range(4)]
    assert again[0] == again[2] and again[1] == again[3]
    drawn = {_run(home, tmp_path / "0", seed=k)[0].object for k in range(8)}
    assert len(drawn) > 1


def test_one_episode_alone_goes_as_among_the_others(tmp_path):
    scene = blocks.furnished(handmade.plan(), blocks.block("bed", 6.5, 0.5, 0.6, 0.6, np.pi, handmade.BEDROOM))
    every = {o.object: o for o in _run(scene, tmp_path)}
    (alone,) = _run(scene, tmp_path, only="bed")
    assert alone.trace is not None and alone.model_copy(update={"trace": None}) == every["bed"]
    assert alone.trace.times[0] == 0 and len(alone.trace.times) == len(alone.trace.qpos)
