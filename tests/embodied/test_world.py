"""The world holds the exported apartment, its room doors open, and nothing else but the robot."""

from xml.etree import ElementTree

import mujoco
import numpy as np
import pytest
import shapely
from embodied import blocks
from export import sample

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.embodied import base, floor, planner, world
from apartgen.stages.robot import reach
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import grid
from apartgen.stages.space.grid import Grid


@pytest.fixture(scope="module")
def flat(tmp_path_factory):
    out = tmp_path_factory.mktemp("flat") / "scene"
    export.run(sample.home(), ["mjcf"], out, sample.load)
    return Scene(sample.home(), sample.load), out / "mjcf" / "apartment.xml"


def _at(model, name):
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    return data.geom(name).xpos


def test_room_doors_stand_open_and_the_entrance_is_shut(flat):
    built = world.build(*flat)
    assert built.doors == pytest.approx(dict.fromkeys(["door_1", "door_2", "door_3"], np.pi / 2))
    leaf = built.bodies["door_1"].link_name(built.bodies["door_1"].links[1])
    # Hinged at x = 4.1 on the south face (y = 4.0) of its wall, 0.9 m wide, open into the room south of it.
    assert _at(built.model, f"{leaf}__c0") == pytest.approx([4.1 - 0.02, 4.0 - 0.45, 1.03], abs=0.03)
    entrance = built.bodies["entrance"].link_name(built.bodies["entrance"].links[1])
    assert _at(built.model, f"{entrance}__c0")[:2] == pytest.approx([9.0, 4.75], abs=0.03)


def test_every_collider_of_an_object_is_known_by_its_id(flat):
    built = world.build(*flat)
    for id, body in built.bodies.items():
        mine = [k for k, owner in built.owner.items() if owner == id]
        assert len(mine) == sum(len(link.colliders) for link in body.links)


def test_only_what_may_move_has_joints(flat):
    everything, nothing = world.build(*flat), world.build(*flat, moving=())
    one = world.build(*flat, moving=["display_cabinet_11"])
    assert nothing.model.nv == 0 < one.model.nv == 1 < everything.model.nv
    cabinet = one.bodies["display_cabinet_11"]
    assert one.model.joint(0).name == cabinet.joint_name(cabinet.links[1].joint)


def test_what_is_left_out_and_what_only_shows(flat):
    built, seen = world.build(*flat), world.build(*flat, visuals=True)
    assert built.model.ngeom == sum(built.model.geom_contype > 0) == sum(seen.model.geom_contype > 0) < seen.model.ngeom
    names = [built.model.geom(k).name for k in range(3)]
    assert world.build(*flat, without=names).model.ngeom == built.model.ngeom - 3


def test_fusing_what_is_welded_changes_no_place(flat):
    apart, fused = world.build(*flat, moving=()), world.build(*flat, moving=(), fused=True)
    assert fused.model.nbody == 1
    for k in range(apart.model.ngeom):
        name = apart.model.geom(k).name
        assert _at(fused.model, name) == pytest.approx(_at(apart.model, name), abs=1e-9)


def test_fusing_the_rest_leaves_a_cabinet_and_its_door_apart(flat):
    whole, fused = (world.build(*flat, moving=["display_cabinet_11"], fused=fused) for fused in (False, True))
    body = fused.bodies["display_cabinet_11"]
    assert {fused.model.body(k).name for k in range(1, fused.model.nbody)} == {body.link_name(li) for li in body.links}
    for built in (whole, fused):
        data = mujoco.MjData(built.model)
        mujoco.mj_step(built.model, data, 50)
        assert data.qpos == pytest.approx(0, abs=1e-3) and data.ncon == 0


def test_colliders_are_those_of_the_file(flat):
    built, exported = world.build(*flat, moving=()), mujoco.MjModel.from_xml_path(str(flat[1]))
    hulls = [k for k in range(built.model.ngeom) if built.model.geom_type[k] == mujoco.mjtGeom.mjGEOM_MESH]
    assert hulls
    for k in hulls:
        same = exported.geom(built.model.geom(k).name)
        assert built.model.geom_aabb[k] == pytest.approx(exported.geom_aabb[same.id], abs=1e-6)
        assert built.model.geom_rbound[k] == pytest.approx(exported.geom_rbound[same.id], abs=1e-6)


def test_another_apartments_file_is_refused(flat, tmp_path):
    _, other = blocks.exported(blocks.furnished(blocks.corridor(3, 1)), tmp_path)
    with pytest.raises(BadInput, match="export this apartment again"):
        world.build(flat[0], other)


def test_a_plan_has_nothing_to_act_on(flat):
    with pytest.raises(BadInput, match="apartgen retrieve"):
        world.build(Scene(sample.plan(), sample.load), flat[1])


def test_the_base_stands_still_and_is_not_the_apartment(flat):
    built = world.build(*flat, base.mjcf(), moving=())
    assert len(built.robot_bodies) == 3 and floor.standing(built) == floor.standing(world.build(*flat, moving=()))
    data = mujoco.MjData(built.model)
    data.qpos[:2] = 3.5, 2.8
    mujoco.mj_step(built.model, data, 500)
    assert data.qpos[:3] == pytest.approx([3.5, 2.8, 0.0], abs=2e-3)
    assert built.model.body_mass[list(built.robot_bodies)].sum() == pytest.approx(base.MASS)


def test_the_floor_is_free_where_the_disc_touches_nothing(tmp_path):
    home = blocks.furnished(blocks.corridor(4, 2), blocks.block("a", 2.0, 1.0, 0.4, 0.6))
    ground = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=()))
    x, y = np.meshgrid(ground.grid.x, ground.grid.y)
    gap = np.hypot((np.abs(x - 2) - 0.2).clip(0), (np.abs(y - 1) - 0.3).clip(0))
    wall = np.minimum.reduce([x, 4 - x, y, 2 - y])
    # The entrance's surround and lever stand out from the wall.
    away = (gap > 0.251) & (wall > 0.251) & (x > 0.4)
    assert ground.free[away].all() and not ground.free[np.minimum(gap, wall) < 0.249].any()
    near = (gap > 0.01) & (gap < wall - 0.1)
    assert ground.clearance[near] == pytest.approx(gap[near], abs=1e-3)


def test_cells_are_covered_that_lie_in_any_polygon():
    rng = np.random.default_rng(0)
    hulls = [shapely.convex_hull(shapely.multipoints(rng.uniform(0, 1, 2) + rng.uniform(0, 0.5, (6, 2))))
             for _ in range(12)]
    cells = Grid((-0.1, -0.1), (40, 45), 0.04)
    x, y = np.moveaxis(cells.centers(), -1, 0)
    turned = [shapely.reverse(hull) if k % 2 else hull for k, hull in enumerate(hulls)]
    assert (grid.raster(turned, cells) == shapely.contains_xy(shapely.union_all(hulls), x, y)).all()


def test_nothing_but_what_is_driven_over_is_ground(flat):
    built = world.build(*flat, base.mjcf(), moving=(), fused=True)
    alone = world.build(*flat, base.mjcf(), moving=(), fused=True, without=floor.above_ground(built))
    assert [k for k in range(alone.model.ngeom) if alone.model.geom_bodyid[k] not in alone.robot_bodies] == [0]
    data = mujoco.MjData(alone.model)
    mujoco.mj_step(alone.model, data, 100)
    assert data.qpos[2] == pytest.approx(0.0, abs=2e-3)


def test_a_lamp_overhead_is_driven_under(tmp_path):
    low = blocks.block("a", 2.0, 1.0, 0.4, 0.6)
    high = low.model_copy(update={"center": (2.0, 1.0, 2.0)})
    for thing, free in ((low, False), (high, True)):
        home = blocks.furnished(blocks.corridor(4, 2), thing)
        ground = floor.survey(world.build(*blocks.exported(home, tmp_path / str(free)), moving=()))
        row, column = np.abs(ground.grid.y - 1).argmin(), np.abs(ground.grid.x - 2).argmin()
        assert ground.free[row, column] == free


def test_the_floor_looks_where_the_walkable_stage_looks(tmp_path):
    home = blocks.furnished(blocks.corridor(4.03, 2.01), blocks.block("a", 2.0, 1.0, 0.4, 0.6))
    ground, stage = floor.survey(world.build(*blocks.exported(home, tmp_path), moving=())), reach.space(home)
    for fine, coarse in ((ground.grid.x, stage.grid.x), (ground.grid.y, stage.grid.y)):
        assert np.abs(fine[:, None] - coarse).min(0) == pytest.approx(0, abs=1e-9)
    cells = reach.free(stage, home.objects)
    row, column = planner.cell(ground, stage.grid.centers()[cells] + 1e-6).T
    inside = stage.grid.centers()[cells][:, 0] > 0.4  # the entrance's surround and lever stand out from the wall
    assert ground.free[row, column][inside].all()


def test_pairs_and_meshes_of_what_is_not_there_are_taken_away():
    root = ElementTree.fromstring(
        '<mujoco><asset><mesh name="used"/><mesh name="spare"/><material name="oak"/></asset><worldbody>'
        '<geom mesh="used"/></worldbody><contact><exclude body1="a" body2="b"/><exclude body1="a" body2="gone"/>'
        '<exclude body1="gone" body2="b"/></contact></mujoco>')
    world._drop_unused(root, {"a", "b"})
    assert [(one.tag, one.get("name")) for one in root.find("asset")] == [("mesh", "used"), ("material", "oak")]
    assert [(one.get("body1"), one.get("body2")) for one in root.find("contact")] == [("a", "b")]
