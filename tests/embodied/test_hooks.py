"""The files for Isaac Sim, Nav2 and policies: the same episodes, the exported names, the benchmark's numbers.

Neither simulator nor ROS 2 is needed: what they would run is read, and what of it is plain Python is run.
"""

import ast
import importlib.util
import json
import sys
from pathlib import Path
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from embodied import blocks
from syntax import tree_of

from apartgen.schemas import artifact
from apartgen.schemas.plan import Room
from apartgen.schemas.retrieve import Joint, Retrieve
from apartgen.stages import export
from apartgen.stages.embodied import base, episodes, navigate, planner, pursuit
from apartgen.stages.embodied.instructions import instruction
from apartgen.stages.export import nav2
from apartgen.stages.space import grid
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Link
from apartgen.stages.things.body import Body
from apartgen_cli.bench import embodied as bench

yaml = pytest.importorskip("yaml")
EXAMPLES = Path(__file__).parents[2] / "examples"
HOOKS = EXAMPLES / "isaac_nav2_vla"
SEED = 7


def hook(name):
    """A hook file as a module, its neighbours beside it as when it is run."""
    spec = importlib.util.spec_from_file_location(name, HOOKS / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(autouse=True)
def beside(monkeypatch):
    monkeypatch.syspath_prepend(str(HOOKS))
    yield
    for name in [name for name, module in sys.modules.items()
                 if str(getattr(module, "__file__", None) or "").startswith(str(HOOKS))]:
        del sys.modules[name]


@pytest.fixture(scope="module")
def home():
    """Some furniture of the example flat, an armchair pushed before a cabinet so that it can't open."""
    whole = artifact.read(EXAMPLES / "two-bedroom-flat" / "walkable.json", Retrieve).body
    kept = ("kitchen_drawers", "tv_stand", "laundry_basket", "shoe_cabinet", "armchair")
    things = {o.id: o for o in whole.objects if o.category in kept}
    stand, chair = things["living_room_1_tv_stand_1"], things["living_room_1_armchair_1"]
    ahead = (stand.size[0] + chair.size[0]) / 2 + 0.1
    x, y = stand.center[0] + ahead * np.cos(stand.yaw), stand.center[1] + ahead * np.sin(stand.yaw)
    things[chair.id] = chair.model_copy(update={"center": (x, y, chair.center[2]), "yaw": stand.yaw})
    return whole.model_copy(update={"objects": list(things.values())})


@pytest.fixture(scope="module")
def scene(home, tmp_path_factory):
    """The apartment as an artifact, its exports, and its episodes."""
    folder = tmp_path_factory.mktemp("hooks")
    text, _ = artifact.finish(home, artifact.Made(by="test", seed=SEED))
    (folder / "flat.json").write_text(text)
    pytest.importorskip("pxr")
    export.run(home, ["usd", "mjcf", "nav2"], folder / "scene", bench._library().load_asset)
    hook("write_episodes").written(folder / "flat.json", folder / "flat.episodes.json", None, [])
    return folder, json.loads((folder / "flat.episodes.json").read_text())


@pytest.fixture(scope="module")
def records(home):
    """What the benchmark makes of the same apartment and seed, with traces."""
    with bench._exported(home, bare=True) as (made, mjcf):
        apartment = bench.simulated(made, mjcf, f"flat-{SEED}")
        driven = bench._navigation(apartment, None)
        things = dict.fromkeys(o.id for o in home.objects)
        return driven, [o for thing in things for o in bench._interaction(apartment, thing)]


def test_goals_are_those_that_the_benchmark_drives_to(scene, records):
    episodes = scene[1]["navigation"]
    assert [e["object"] for e in episodes] == [o.object for o in records[0]] and len(episodes) >= 5
    for e, o in zip(episodes, records[0]):
        assert e["id"].removeprefix("flat:") == o.id.removeprefix(f"flat-{SEED}:")
        goal = [o.numbers[key] for key in ("goal_x", "goal_y", "goal_yaw")]
        assert list(e["goal"].values()) == pytest.approx(goal, abs=1e-4)
        assert e["shortest"] == pytest.approx(o.numbers["shortest"], abs=1e-4)
        assert o.numbers["seconds"] <= e["seconds"] and e["within"] == pursuit.XY_TOLERANCE == 0.25


def test_bases_stand_where_the_benchmark_puts_them(scene, records):
    episodes = {e["id"].removeprefix("flat:"): e for e in scene[1]["interaction"]}
    found = {o.id.removeprefix(f"flat-{SEED}:"): o for o in records[1]}
    assert set(episodes) == set(found) and len(found) > 10
    planned = blocked = 0
    for id, o in found.items():
        e = episodes[id]
        assert (e["base"] is None) == (o.failure in ("blocked part", "no standing room", "planner"))
        if e["base"] is not None and not o.numbers["retries"]:
            planned += 1
            arrived = np.searchsorted(o.trace.times, 0.0)
            x, y, yaw = o.trace.qpos[arrived][:3]
            assert [e["base"]["x"], e["base"]["y"]] == pytest.approx([x, y], abs=1e-4)
            assert np.cos(e["base"]["yaw"] - yaw) == pytest.approx(1.0, abs=1e-6)
        elif e["base"] is None:
            blocked += 1
            assert (e["failure"], e["reason"]) == (o.failure, o.reason)
    assert planned > 10 and blocked


@pytest.mark.parametrize("gap, blocked", [(0.48, False), (0.7, False), (0.7, True)])
def test_what_can_not_be_driven_to_is_told_as_the_benchmark_tells_it(tmp_path, gap, blocked):
    side = (1.6 - gap) / 2
    things = [blocks.block("low", 3.0, side / 2, 0.3, side), blocks.block("high", 3.0, 1.6 - side / 2, 0.3, side),
              blocks.block("goal", 5.75, 0.8, 0.4, 0.6, np.pi, category="chair")]
    # What stands before the entrance leaves no cell to start from.
    things += [blocks.block("mat", 0.5, 0.8, 1.0, 1.6)] if blocked else []
    flat = blocks.furnished(blocks.corridor(6, 1.6), *things)
    apartment = bench.simulated(*blocks.exported(flat, tmp_path), "a-1")
    found = episodes.listed(apartment, bench.lane("a-1"))
    for e, o in zip(found.navigation, navigate.run(apartment, bench.lane("a-1")), strict=True):
        assert e.id == o.id and (e.failure, e.reason) == (o.failure, o.reason)
        assert (e.goal is None) == (not o.success) == bool(e.failure)
    assert not found.interaction and any(e.goal is None for e in found.navigation) == blocked


def test_names_and_limits_are_those_of_the_exported_stage_and_model(scene):
    from pxr import Usd, UsdPhysics

    folder, whole = scene
    stage = Usd.Stage.Open(str(folder / "scene" / "usd" / "apartment.usd"))
    model = mujoco.MjModel.from_xml_path(str(folder / "scene" / "mjcf" / "apartment.xml"))
    for e in whole["interaction"]:
        prim = stage.GetPrimAtPath(e["usd_joint"])
        hinge = e["type"] == "hinge"
        assert prim.IsA(UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint), e["usd_joint"]
        joint = (UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint)(prim)
        limits = np.array([joint.GetLowerLimitAttr().Get(), joint.GetUpperLimitAttr().Get()])
        assert (np.radians(limits) if hinge else limits) == pytest.approx(e["range"], abs=1e-5)
        top = stage.GetPrimAtPath(e["usd_object"])
        assert top.HasAPI(UsdPhysics.ArticulationRootAPI)
        assert top.GetCustomDataByKey("apartgen")["id"] == e["object"]
        assert model.joint(e["mjcf_joint"]).range == pytest.approx(e["range"], abs=1e-6)
        assert model.body(e["mjcf_body"]).id > 0
        assert e["open_at"] == pytest.approx(0.8 * max(e["range"], key=abs), abs=1e-4)


def test_handles_and_axes_are_in_the_world(scene):
    folder, whole = scene
    model = mujoco.MjModel.from_xml_path(str(folder / "scene" / "mjcf" / "apartment.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    for e in whole["interaction"]:
        assert e["axis"] == pytest.approx(data.joint(e["mjcf_joint"]).xaxis, abs=1e-4)
        part = model.body(model.joint(e["mjcf_joint"]).bodyid[0]).name
        # Fingers take hold some millimetres behind a handle's foremost point, the cup some way in from a lid's edge.
        assert np.linalg.norm(data.site(f"{part}__handle").xpos - e["handle"]["point"]) < 0.05
        assert np.linalg.norm(e["handle"]["normal"]) == pytest.approx(1, abs=1e-4)


def test_the_seed_and_whether_there_is_furniture_count(scene, tmp_path, monkeypatch, capsys):
    folder, whole = scene
    hook("write_episodes").written(folder / "flat.json", tmp_path / "other.json", SEED + 1, [])
    other = json.loads((tmp_path / "other.json").read_text())
    assert [e["goal"] for e in other["navigation"]] != [e["goal"] for e in whole["navigation"]]
    assert other["interaction"] == whole["interaction"]
    monkeypatch.setattr(sys, "argv", ["write_episodes.py", str(folder / "none.json"), "-o", str(tmp_path / "x.json")])
    with pytest.raises(SystemExit, match="none.json"):
        hook("write_episodes").main()
    assert not (tmp_path / "x.json").exists()


def board(name, part, lo, hi, axis=(0, 0, 1)):
    joint = Joint(name=name, type="slide" if part.startswith("slider") else "hinge", axis=axis, origin=(0, 0, 0),
                  range=(0, 1), part=part)
    return Link(name, [], [solids.slab(np.array(lo, float), np.array(hi, float))], 1.0, joint)


def said(category, *links, room="living_room"):
    body = Body("it", "object", category, "r", np.zeros(3), 0.0, [Link("base", [], [], 1.0), *links], id="it")
    place = Room(id="r", type=room, polygon=[(0, 0), (4, 0), (4, 4), (0, 4)])
    return [instruction(body, link, place) for link in links]


def test_instructions_say_which_part_in_plain_words():
    drawers = [board(f"d{k}", "slider_drawer", (0, -1, k), (1, 1, k + 0.9), (1, 0, 0)) for k in range(4)]
    assert said("chest", *drawers[::-1]) == [
        "open the top drawer of the chest in the living room",
        "open the second drawer from the top of the chest in the living room",
        "open the third drawer from the top of the chest in the living room",
        "open the bottom drawer of the chest in the living room",
    ]
    # Seen from before it, what is at +y is on the right.
    doors = [board("a", "hinge_door", (0, 0, 0), (1, 1, 1)), board("b", "hinge_door", (0, -1, 0), (1, 0, 1))]
    assert said("wardrobe", *doors, room="bedroom") == [
        "open the right door of the wardrobe in the bedroom", "open the left door of the wardrobe in the bedroom"]
    assert said("bin", board("a", "hinge_lid", (0, 0, 0), (1, 1, 1), (0, -1, 0)), room="kitchen") == [
        "open the lid of the bin in the kitchen"]
    flap = board("a", "hinge_door", (0, 0, 0), (1, 1, 1), (0, 1, 0))
    assert said("shoe_cabinet", flap) == ["open the flap of the shoe cabinet in the living room"]
    assert said("oven", flap) == ["open the door of the oven in the living room"]
    assert said("sliding_wardrobe", board("a", "slider_door", (0, 0, 0), (1, 1, 1), (0, 1, 0))) == [
        "open the door of the sliding wardrobe in the living room"]


def test_every_instruction_is_told_apart_within_its_object(scene):
    words = [(e["object"], e["instruction"]) for e in scene[1]["interaction"]]
    assert len(set(words)) == len(words) and not [text for _, text in words if "_" in text]


PYTHON = sorted(file.name for file in HOOKS.glob("*.py"))
ELSEWHERE = ("isaacsim", "omni", "rclpy", "nav2_simple_commander", "launch", "launch_ros", "openpi_client",
             "geometry_msgs", "nav_msgs", "std_msgs", "tf2_msgs", "rosgraph_msgs", "builtin_interfaces")


@pytest.mark.parametrize("name", PYTHON)
def test_what_is_not_installed_everywhere_is_imported_when_it_is_needed(name):
    tree = tree_of((HOOKS / name).read_text())
    top = [alias.name for node in tree.body if isinstance(node, ast.Import) for alias in node.names]
    top += [node.module for node in tree.body if isinstance(node, ast.ImportFrom)]
    assert not [word for word in top if word.split(".")[0] in ELSEWHERE]
    compile(tree, name, "exec")
    assert ast.get_docstring(tree)
    if name.endswith((".launch.py",)) or name in ("isaac_load.py", "run_vla.py", "run_navigation.py"):
        assert "run" in ast.get_docstring(tree).lower() and "Isaac Sim" in ast.get_docstring(tree)


def test_python_files_can_be_read_without_simulator_and_ros():
    for name in PYTHON:
        hook(name.removesuffix(".py"))


PARAMETERS = yaml.safe_load((HOOKS / "nav2_params.yaml").read_text())


def parameters(node):
    return PARAMETERS[node].get(node, PARAMETERS[node])["ros__parameters"]


@pytest.mark.parametrize("costmap", ["global_costmap", "local_costmap"])
def test_costmaps_are_those_of_the_benchmarks_planner(costmap):
    found = parameters(costmap)
    assert found["robot_radius"] == base.RADIUS and found["resolution"] == grid.RESOLUTION / nav2.FINER
    inflated = found["inflation_layer"]
    assert (inflated["inflation_radius"], inflated["cost_scaling_factor"]) == (planner.INFLATION, planner.SCALING)
    # Nothing inflates what a filter marks but an inflation that comes after it.
    assert found["filters"] == ["keepout_filter", "inflation_layer"]
    info = parameters("keepout_costmap_filter_info_server")
    assert found["keepout_filter"]["filter_info_topic"] == "/" + info["filter_info_topic"]
    assert info["mask_topic"] == parameters("keepout_filter_mask_server")["topic_name"]
    assert (info["type"], info["base"], info["multiplier"]) == (0, 0.0, 1.0)


def test_the_controller_has_the_benchmarks_speeds_and_lookahead():
    server = parameters("controller_server")
    follow, arrive = server["FollowPath"], server["goal_checker"]
    assert follow["desired_linear_vel"] == base.SPEED
    assert (follow["rotate_to_heading_angular_vel"], follow["max_angular_accel"]) == (base.TURN, base.TURN_ACCELERATION)
    assert (follow["min_lookahead_dist"], follow["max_lookahead_dist"]) == pursuit.LOOKAHEAD
    assert follow["lookahead_time"] == pursuit.LOOKAHEAD_TIME
    assert follow["rotate_to_heading_min_angle"] == pursuit.ROTATE_ANGLE
    assert follow["regulated_linear_scaling_min_radius"] == pursuit.MIN_RADIUS
    assert follow["regulated_linear_scaling_min_speed"] == pursuit.MIN_SPEED
    assert follow["cost_scaling_dist"] == pursuit.COST_DISTANCE
    assert follow["approach_velocity_scaling_dist"] == pursuit.APPROACH
    assert follow["min_approach_linear_velocity"] == pursuit.APPROACH_SPEED
    assert follow["max_allowed_time_to_collision_up_to_carrot"] == pursuit.TIME_TO_COLLISION
    assert follow["inflation_cost_scaling_factor"] == planner.SCALING
    assert arrive["xy_goal_tolerance"] == pytest.approx(pursuit.WITHIN)
    assert arrive["yaw_goal_tolerance"] == pursuit.YAW_TOLERANCE
    assert server["controller_frequency"] == pytest.approx(1 / pursuit.PERIOD)


def test_the_smoother_has_the_benchmarks_limits():
    smoother = parameters("velocity_smoother")
    assert smoother["max_velocity"] == [base.SPEED, 0.0, base.TURN]
    assert smoother["max_accel"] == [base.ACCELERATION, 0.0, base.TURN_ACCELERATION]
    for least, most in (("min_velocity", "max_velocity"), ("max_decel", "max_accel")):
        assert smoother[least] == [-v for v in smoother[most]]


def test_the_launch_file_serves_the_exporters_maps(scene):
    launch = hook("navigation.launch")
    folder = scene[0] / "scene" / "nav2"
    assert all((folder / file).is_file() for file in launch.MAPS.values())
    assert launch.MAPS[{"lidar_map": "lidar_map_server"}[parameters("amcl")["map_topic"]]] == "lidar.yaml"
    assert launch.MAPS["map_server"] == "map.yaml" and launch.MAPS["keepout_filter_mask_server"] == "keepout.yaml"
    assert parameters("lidar_map_server")["topic_name"] == parameters("amcl")["map_topic"]
    assert parameters("map_server")["topic_name"] == parameters("global_costmap")["static_layer"]["map_topic"]
    assert set(PARAMETERS) - {"amcl", "global_costmap", "local_costmap"} == {*launch.MAPS, *launch.SERVERS}


def test_doors_are_held_open_and_the_entrance_shut(scene):
    from pxr import Usd, UsdPhysics

    stage = Usd.Stage.Open(str(scene[0] / "scene" / "usd" / "apartment.usd"))
    opened = hook("stage").open_doors(stage)
    home = artifact.read(scene[0] / "flat.json", Retrieve).body
    assert len(opened) == sum(o.kind == "door" for o in home.openings)
    held = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.RevoluteJoint)
            and UsdPhysics.DriveAPI(prim, "angular").GetStiffnessAttr().Get() > 0]
    assert len(held) == len(opened) + sum(o.kind == "entrance" for o in home.openings)
    for prim in held:
        target = UsdPhysics.DriveAPI(prim, "angular").GetTargetPositionAttr().Get()
        upper = UsdPhysics.RevoluteJoint(prim).GetUpperLimitAttr().Get()
        assert target == pytest.approx(upper if str(prim.GetPath()) in opened else 0.0) and upper > 80


def test_openusd_finds_nothing_in_the_stage_made_ready(scene):
    from pxr import Usd

    validation = pytest.importorskip("pxr.UsdValidation")
    stage, module = Usd.Stage.Open(str(scene[0] / "scene" / "usd" / "apartment.usd")), hook("stage")
    module.open_doors(stage)
    module.add_base(stage, 1.0, 1.0, 0.0)
    validators = validation.ValidationRegistry().GetOrLoadAllValidators()
    assert not [fault.GetMessage() for fault in validation.ValidationContext(validators).Validate(stage)]


def test_the_base_is_the_benchmarks():
    pytest.importorskip("pxr")
    from pxr import Gf, Usd, UsdGeom, UsdPhysics

    module = hook("stage")
    same = ("RADIUS", "HEIGHT", "MASS", "WHEEL", "TRACK", "TYRE", "TORQUE")
    assert {name: getattr(module, name) for name in same} == {name: getattr(base, name) for name in same}
    assert module.LIDAR == pytest.approx(sum(nav2.LIDAR) / 2)
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, "Z")
    top = stage.GetPrimAtPath(module.add_base(stage, 1.0, 2.0, np.pi / 2))
    masses = [UsdPhysics.MassAPI(prim).GetMassAttr().Get() for prim in Usd.PrimRange(top)
              if prim.HasAPI(UsdPhysics.MassAPI)]
    assert sum(masses) == pytest.approx(base.MASS)
    cache = UsdGeom.BBoxCache(Usd.TimeCode.Default(), ["default"], useExtentsHint=False)
    UsdGeom.Imageable(stage.GetPrimAtPath(module.COLUMN)).MakeVisible()
    box = cache.ComputeWorldBound(top).ComputeAlignedRange()
    size = box.GetMax() - box.GetMin()
    assert Gf.Vec3d(0.5, 0.5, base.HEIGHT) == pytest.approx(list(size), abs=0.01)
    assert list(box.GetMidpoint())[:2] == pytest.approx([1.0, 2.0], abs=1e-6)
    left = UsdGeom.XformCache().GetLocalToWorldTransform(stage.GetPrimAtPath(f"{module.ROBOT}/left_wheel"))
    assert list(left.ExtractTranslation()) == pytest.approx([1 - base.TRACK / 2, 2.0, base.WHEEL], abs=1e-6)
    for name in module.DRIVES:
        drive = UsdPhysics.DriveAPI(stage.GetPrimAtPath(f"{module.ROBOT}/{name}"), "angular")
        assert drive.GetMaxForceAttr().Get() == base.TORQUE
        assert drive.GetDampingAttr().Get() == pytest.approx(20 * np.pi / 180)


def test_drives_are_judged_as_the_benchmark_judges(scene, records):
    judge = hook("judge")
    for e, o in zip(judge.episodes(scene[0] / "flat.episodes.json", "navigation"), records[0]):
        pose = (o.trace.qpos[-1][:2] if o.trace else [e["goal"]["x"] + o.numbers["missed"], e["goal"]["y"]])
        ours = judge.arrived(e, (*pose, e["goal"]["yaw"]), o.numbers["seconds"], o.numbers["metres"], o.numbers["push"])
        theirs = {"id": e["id"], **o.model_dump(exclude={"trace", "course"}), "apartment": "flat"}
        assert ours["numbers"].pop("missed") == pytest.approx(o.numbers["missed"], abs=2e-4)
        del theirs["numbers"]["missed"], theirs["numbers"]["touches"]
        assert set(ours) == set(theirs)
        assert ours.pop("numbers") == pytest.approx(theirs.pop("numbers"), abs=2e-4) and ours == theirs


NAVIGATION = {
    "id": "a:navigation:o", "apartment": "a", "episode": "navigation", "room": "r", "object": "o", "category": "chest",
    "goal": {"x": 1.0, "y": 2.0, "yaw": 3.1}, "within": 0.25, "facing": 0.25, "seconds": 60.0, "shortest": 4.0,
    "push": 15.0,
}


@pytest.mark.parametrize("change, reason", [
    ({}, ""), ({"pose": (1.2, 2.0, -3.1)}, ""), ({"pose": (1.3, 2.0, 3.1)}, "did not stop at the goal"),
    ({"pose": (1.0, 2.0, 2.8)}, "did not stop at the goal"), ({"seconds": 61.0}, "too slow"),
    ({"push": 16.0}, "ran against something"), ({"push": None}, ""),
])
def test_a_drive_fails_where_it_ends_elsewhere_late_or_with_a_push(change, reason):
    asked = {"pose": (1.0, 2.0, 3.1), "seconds": 50.0, "metres": 5.0, "push": 3.0, **change}
    record = hook("judge").arrived(NAVIGATION, **asked)
    assert record["reason"] == reason and record["success"] == (not reason)
    assert record["numbers"]["spl"] == (0.0 if reason else 0.8)
    assert ("push" in record["numbers"]) == (asked["push"] is not None)


@pytest.mark.parametrize("limits, value, success", [
    ((0.0, 1.5), 1.2, True), ((0.0, 1.5), 1.19, False), ((-1.5, 0.0), -1.3, True), ((-1.5, 0.0), 1.3, False),
])
def test_a_part_is_open_at_four_fifths_of_its_range(limits, value, success):
    episode = {**NAVIGATION, "episode": "interaction", "joint": "door", "range": limits, "share": 0.8}
    assert hook("judge").opened(episode, value, 3.0)["success"] == success


def test_episodes_that_failed_before_they_began_are_counted(tmp_path):
    judge = hook("judge")
    record = judge.impossible({**NAVIGATION, "goal": None, "failure": "planner", "reason": navigate.WHY["planner"]})
    assert not record["success"] and record["failure"] == "planner" and record["numbers"] == {"spl": 0.0}
    judge.append(record, tmp_path / "out.jsonl")
    judge.append(record, tmp_path / "out.jsonl")
    assert [json.loads(line) for line in (tmp_path / "out.jsonl").read_text().splitlines()] == [record, record]
    assert judge.summary([record]).startswith("0 of 1 succeeded")


def test_a_policy_comes_from_a_module_and_is_told_the_task(tmp_path, monkeypatch):
    vla = hook("run_vla")
    (tmp_path / "still.py").write_text("class Still:\n    def infer(self, obs):\n        return {'actions': obs}\n"
                                       "def make():\n    return Still()\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    seen = vla.observation("image", "joints", "open it")
    assert vla.policy("still:make").infer(seen)["actions"]["prompt"] == "open it"
    assert vla.policy("still").infer(seen)["actions"]["observation/image"] == "image"


@pytest.mark.parametrize("pace, success", [(0.1, True), (0.001, False)])
def test_a_policy_acts_until_the_part_is_open_or_time_is_up(monkeypatch, pace, success):
    vla, acted, reset = hook("run_vla"), [], []
    part = SimpleNamespace(value=lambda: pace * len(acted))
    monkeypatch.setattr(vla, "Part", lambda episode: part)
    robot = SimpleNamespace(put=lambda x, y, yaw: reset.append((x, y, yaw)), image=lambda: "image",
                            joints=lambda: "joints", act=acted.append)
    world = SimpleNamespace(reset=lambda: reset.append("world"), step=lambda: None)
    policy = SimpleNamespace(reset=lambda: reset.append("policy"),
                             infer=lambda seen: {"actions": np.full((3, 2), float(seen["prompt"] == "open it"))})
    episode = {**NAVIGATION, "episode": "interaction", "joint": "door", "range": (0.0, 1.0), "share": 0.8,
               "open_at": 0.8, "instruction": "open it", "base": {"x": 1.0, "y": 2.0, "yaw": 3.0}}
    record = vla.opened(world, robot, policy, episode, limit=2.0)
    assert reset == ["world", (1.0, 2.0, 3.0), "policy"] and record["success"] == success
    # 0.8 at 0.1 a step, or 2 s at 20 steps a second; every action of a chunk is taken until then.
    assert len(acted) == (8 if success else 40) and all((a == [1.0, 1.0]).all() for a in acted)
    assert record["numbers"]["seconds"] == pytest.approx(len(acted) * vla.CONTROL)


class Message:
    def __init__(self, **fields):
        self.__dict__.update(fields)


def test_way_and_push_are_counted_from_the_start_of_an_episode():
    watch = hook("run_navigation").Watch()

    def at(x, y):
        pose = Message(position=Message(x=x, y=y), orientation=Message(z=np.sin(0.25), w=np.cos(0.25)))
        watch.moved(Message(pose=Message(pose=pose)))

    at(5, 5)
    watch.begin()
    assert watch.push is None
    at(5, 6)
    at(6, 6)
    watch.pushed(Message(data=4.0))
    watch.pushed(Message(data=2.0))
    assert watch.metres == 2 and watch.push == 4.0 and watch.pose == pytest.approx((6, 6, 0.5))
    watch.begin()
    assert watch.metres == 0 and watch.push == 0.0
