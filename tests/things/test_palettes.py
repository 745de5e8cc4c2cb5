"""Homes are finished in styles drawn by seed: names that mean something, homes that differ, two woods a room."""

from itertools import combinations

import numpy as np
import pytest
import trimesh
from inhabited import furnished, library

from apartgen.schemas.plan import Finish, Room
from apartgen.stages import plan, seeds
from apartgen.stages.scene import leaves, sashes, shell
from apartgen.stages.scene.sashes import Hole
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import dressed, materials, palettes
from apartgen.stages.things import finishes as finishes_module
from apartgen.stages.things.materials import PALETTE

SQUARE = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)]
ROOMS = [Room(id=f"{kind}_1", type=kind, polygon=SQUARE) for kind in ("living_room", "kitchen", "bathroom", "bedroom")]
MATERIALS = ("floor", "wall", "joinery", "metal", "woods", "cloth", "rug", "bedding", "front", "worktop", "handles")


def finishes(seed, rooms=ROOMS):
    return palettes.drawn(rooms, seeds.drawn(seed, "finishes"))


def finished(seed):
    home = furnished()
    return home.model_copy(update={"finishes": finishes(seed, home.rooms)})


def test_names_mean_something_and_there_are_enough():
    every = palettes.styles().values()
    floors = {name for style in every for name in (*style.floors, *style.wet_floors)}
    walls = {name for style in every for name in (*style.walls, *style.wet_walls)}
    doors, windows = ({name for s in every for name in getattr(s, part)} for part in ("doors", "windows"))
    kitchens = {kitchen for style in every for kitchen in style.kitchens}
    assert len(floors) >= 8 and len(walls) >= 10 and len(doors) >= 6 and len(windows) >= 5 and len(kitchens) >= 6
    assert doors <= set(leaves.DESIGNS) and windows <= set(sashes.DESIGNS)
    others = {name for s in every for part in (s.joinery, s.metals, s.cloth, s.rugs, s.beds, *s.woods, *s.kitchens)
              for name in part}
    assert floors | walls | others <= set(PALETTE)
    assert all(1 <= len(woods) <= 2 for style in every for woods in style.woods)


def test_hardly_two_of_fifty_homes_share_floor_and_wall():
    for first in range(0, 200, 50):
        seen = [(one.floor, one.wall) for one in (finishes(seed)["living_room_1"] for seed in range(first, first + 50))]
        assert sum(a == b for a, b in combinations(seen, 2)) <= 0.03 * 50 * 49 / 2


def test_rooms_of_a_home_go_together_and_each_draws_alone():
    for seed in range(20):
        whole, fewer = finishes(seed), finishes(seed, ROOMS[1:])
        assert all(whole[id] == one for id, one in fewer.items())
        for part in ("style", "joinery", "door", "window", "metal", "woods", "front"):
            assert len({str(getattr(one, part)) for one in whole.values()}) == 1
        assert whole["living_room_1"].floor == whole["bedroom_1"].floor


def test_a_plan_is_finished_by_its_seed_and_another_paint_is_another_plan():
    from apartgen.schemas.plan import AskedRoom, Program
    from apartgen.stages.plan import PlanConfig

    program = Program(rooms=[AskedRoom(id=f"{kind}_1", type=kind) for kind in ("living_room", "bathroom")],
                      links=[("living_room_1", "bathroom_1")])
    made = [plan.build(program, PlanConfig(processes=1), np.random.default_rng(seed)) for seed in (3, 3, 4)]
    assert set(made[0].finishes) == {"living_room_1", "bathroom_1"}
    assert made[0].finishes == made[1].finishes != made[2].finishes
    bare = made[0].model_copy(update={"finishes": {}})
    assert len({seeds.plan_digest(one) for one in (bare, made[0], made[2])}) == 3


@pytest.mark.parametrize("seed", range(3))
def test_a_dressed_home_has_two_woods_a_room_at_most_and_the_same_shapes(seed):
    home = finished(seed)
    bare, shown = Scene(furnished(), library().load_asset).bodies, Scene(home, library().load_asset).bodies
    objects = [body for body in shown if body.kind == "object"]
    for room, finish in home.finishes.items():
        used = {mesh.material.name for body in objects if body.room == room
                for link in body.links for mesh in link.visuals}
        kitchen = {finish.front, finish.worktop, finish.handles}
        assert used & dressed.WOODS <= {*finish.woods, *kitchen}
    for one, other in zip(bare, shown, strict=True):
        assert one.name == other.name
        if one.kind != "window":
            for a, b in zip(one.links, other.links, strict=True):
                assert (a.mass, len(a.colliders), a.joint) == (b.mass, len(b.colliders), b.joint)


def test_units_of_a_kitchen_share_fronts_and_worktop():
    home = finished(5)
    kitchen = next(room.id for room in home.rooms if room.base == "kitchen")
    said = home.finishes[kitchen].model_copy(update={"front": "navy", "worktop": "dark_marble"})
    home.finishes[kitchen] = said
    units = [body for body in Scene(home, library().load_asset).bodies
             if body.room == kitchen and body.category in ("kitchen_base", "kitchen_drawers", "kitchen_sink", "hob")]
    assert len(units) >= 2
    for body in units:
        used = {mesh.material.name for link in body.links for mesh in link.visuals}
        assert {said.front, said.worktop} <= used


@pytest.mark.parametrize("design", leaves.DESIGNS)
def test_a_door_leaf_stays_by_its_faces_and_is_closed(design):
    lo, hi = np.array([0.06, -0.4, 0.008]), np.array([0.10, 0.4, 2.05])
    made = leaves.leaf(design, lo, hi, PALETTE["white"])
    for mesh in made:
        solid = trimesh.Trimesh(mesh.vertices, mesh.faces)
        solid.merge_vertices()
        assert solid.is_watertight and solid.volume > 0
    points = np.concatenate([mesh.vertices for mesh in made])
    assert (points.min(0) >= lo - [0.00201, 1e-9, 1e-9]).all() and (points.max(0) <= hi + [0.00201, 1e-9, 1e-9]).all()
    assert points.min(0)[1:] == pytest.approx(lo[1:]) and points.max(0)[1:] == pytest.approx(hi[1:], abs=0.003)


@pytest.mark.parametrize("design", sashes.DESIGNS)
@pytest.mark.parametrize("half", [0.3, 0.6, 1.4])
def test_a_window_stays_in_its_hole(design, half):
    made = sashes.window(design, Hole(half, 0.9, 2.2, -0.1))
    boxes = np.array([*made.bars, *made.handles])
    assert (boxes[:, 1] > boxes[:, 0]).all()
    assert np.abs(boxes[:, :, 1]).max() == pytest.approx(half)
    assert boxes[:, :, 2].min() == pytest.approx(0.9) and boxes[:, :, 2].max() == pytest.approx(2.2)


@pytest.mark.parametrize("part", ["floor", "wall", "joinery", "metal", "door", "window"])
def test_a_finish_that_is_none_is_passed_over(part, caplog):
    caplog.set_level("WARNING", logger="apartgen")
    home = furnished()
    said, usual = ({room.id: Finish(**{part: name}) for room in home.rooms} for name in ("unobtainium", ""))
    finishes_module.named.cache_clear()
    made, plain = (shell.bodies(home.model_copy(update={"finishes": finishes})) for finishes in (said, usual))
    assert ("unobtainium" in caplog.text) == (part not in ("door", "window"))
    for one, other in zip(made, plain, strict=True):
        assert [m.material for link in one.links for m in link.visuals] == [
            m.material for link in other.links for m in link.visuals]


def test_lamps_shine_from_their_bulbs():
    home = furnished()
    scene = Scene(home, library().load_asset)
    bodies = {body.id: body for body in scene.bodies}
    lights = {light.name: light for light in scene.lights}
    seen = 0
    for o in home.objects:
        light, body = lights.get(f"light_{o.id}"), bodies[o.id]
        bulbs = [mesh.vertices @ body.pose()[:3, :3].T + body.position for mesh in body.links[0].visuals
                 if mesh.material.name == "bulb"]
        if light is None or not bulbs:
            continue
        seen += 1
        lo, hi = np.concatenate(bulbs).min(0), np.concatenate(bulbs).max(0)
        assert (light.position >= lo - 1e-6).all() and (light.position <= hi + 1e-6).all()
    assert seen >= 2
    assert materials.PALETTE["bulb"].emission > 0
