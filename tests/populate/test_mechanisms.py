"""Parts as a hand feels them: seals that hold, doors that stay where they are left, lids that stay open."""

import os
from pathlib import Path

import mujoco
import numpy as np
import physicstable
import pytest

from apartgen.schemas.retrieve import Joint
from apartgen.stages.export import mjcf
from apartgen.stages.retrieve import furniture
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import categories, mechanisms, small
from apartgen.stages.things.body import Body
from apartgen.stages.things.categories import TABLE

ARTICULATED = [name for name, kind in TABLE.items() if kind.articulated and not kind.like]


@pytest.mark.parametrize("category", [name for name, kind in TABLE.items() if kind.mass])
def test_furniture_weighs_what_such_things_weigh(category):
    """The smallest, the usual and the largest of every style."""
    kind = TABLE[category]
    for style in furniture.styles(category):
        weighed = [sum(link.mass for link in furniture.build(category, style, size, 1).links)
                   for size in (kind.min, kind.size, kind.max)]
        assert all(kind.mass[0] - 0.01 <= m <= kind.mass[1] + 0.01 for m in weighed), (style, weighed)
        assert weighed[0] <= weighed[2] + 0.01


def test_every_figure_has_a_source_that_is_known():
    known = set(mechanisms.sources())
    weighed = {name: kind for name, kind in (TABLE | small.TABLE).items()}
    assert all(kind.weighed for kind in weighed.values())
    assert all(set(kind.weighed) <= known and kind.mass[0] <= kind.mass[1] for kind in weighed.values())
    rows = [*mechanisms.table().values(), *mechanisms.surfaces().values()]
    assert {row.source for row in rows} | {row.turned for row in mechanisms.table().values()} <= known
    damped = {name for row in mechanisms.table().values() for name in row.dragged}
    assert damped <= known and all(row.turned for row in mechanisms.table().values())
    named = {name for kind in weighed.values() for name in kind.weighed} | {row.source for row in rows} | damped
    assert named | {row.turned for row in mechanisms.table().values()} | {"surfaces"} >= known, "named by nothing"


@pytest.mark.parametrize("name", sorted({name for name, kind in TABLE.items() if not kind.like} | set(small.TABLE)))
def test_weights_lie_within_what_their_sources_allow(name):
    """What is like another one may weigh otherwise than what its sources tell of."""
    kind = (TABLE | small.TABLE)[name]
    least, most = mechanisms.allowed(kind.weighed, kind.listed)
    assert least - 1e-9 <= kind.mass[0] <= kind.mass[1] <= most + 1e-9, (least, most)


def test_what_sources_allow_is_half_to_twice_an_average_and_a_range_as_it_is():
    assert mechanisms.allowed(["ycb"], (0.2, 0.3)) == (0.1, 0.6)
    assert mechanisms.allowed(["fridges"], (30.0, 130.0)) == (30.0, 130.0)


@pytest.mark.parametrize("name", sorted(mechanisms.table()))
def test_parts_are_damped_within_what_their_sources_give(name):
    row = mechanisms.table()[name]
    assert row.dragged and row.drag[0] <= row.damping[0] <= row.damping[1] <= row.drag[1]


def test_surfaces_rub_within_what_their_sources_give():
    known = mechanisms.surfaces()
    for name, kind in small.TABLE.items():
        assert known[kind.surface].friction[0] <= kind.friction <= known[kind.surface].friction[1], name
    usual = {link.friction for name in TABLE for style in furniture.styles(name)
             for link in furniture.build(name, style, TABLE[name].size, 0).links}
    usual |= {link.friction for body in building() for link in body.links}
    assert all(known["hard"].friction[0] <= friction <= known["hard"].friction[1] for friction in usual)


def building():
    """Walls, floors, doors and windows of a home."""
    from inhabited import furnished, library

    found = [body for body in Scene(furnished(), library().load_asset, shown=False).bodies if body.kind != "object"]
    assert {"wall", "floor", "door", "window"} <= {body.kind for body in found}
    return found


def test_room_doors_pull_and_turn_within_what_their_sources_give():
    row, leaves = mechanisms.table()["room_door"], [link for body in building() for link in body.links if link.joint]
    assert leaves
    for link in leaves:
        assert mechanisms.kind("door", link.joint) == "room_door"
        pulls = [row.catch[k] + row.friction[k] / mechanisms.lever(link) for k in (0, 1)]
        assert row.force[0] <= pulls[0] <= pulls[1] <= row.force[1], link.name
        assert row.turn[0] - 1e-6 <= np.degrees(np.ptp(link.joint.range)) <= row.turn[1] + 1e-6, link.name


def test_every_mechanism_is_one_that_something_has_and_no_lid_holds_open_against_a_hand():
    had = {mechanisms.kind(name, link.joint) for name in ARTICULATED for style in furniture.styles(name)
           for link in furniture.build(name, style, TABLE[name].size, 0).links[1:]}
    assert had | {"room_door"} == set(mechanisms.table())
    assert all(0 <= row.rest[0] <= row.rest[1] <= row.force[1] for row in mechanisms.table().values())


@pytest.mark.parametrize("category", ARTICULATED)
def test_parts_pull_and_turn_within_what_their_sources_give(category):
    """By the force that holds a part shut and its dry friction, at the handle; and how far it turns or slides."""
    for style in furniture.styles(category):
        asset = furniture.build(category, style, TABLE[category].size, 0)
        for link in asset.links[1:]:
            row, arm = mechanisms.table()[mechanisms.kind(category, link.joint)], mechanisms.lever(link)
            for k in (0, 1):
                friction = min(row.friction[k], mechanisms.LIGHT * link.mass * arm)
                assert row.force[0] <= row.catch[k] + friction / arm <= row.force[1], (style, link.name)
            if any(row.turn):
                turns = np.degrees(np.ptp(link.joint.range))
                assert row.turn[0] - 1e-6 <= turns <= row.turn[1], (style, link.name, turns)
            if any(row.out):
                along = int(np.abs(link.joint.axis).argmax())
                own = np.ptp(np.concatenate([mesh.vertices[:, along] for mesh in link.visuals]))
                share = np.ptp(link.joint.range) / own
                assert row.out[0] - 1e-6 <= share <= row.out[1], (style, link.name, share)


class _Alone:
    """One body and what an exporter asks for besides."""

    def __init__(self, body, home):
        self.bodies, self.lights, self.home, self.credits, self.masked = [body], [], home, [], False


@pytest.fixture(scope="module")
def simulated(tmp_path_factory):
    """The model of one piece of furniture, made once."""
    from inhabited import furnished

    made = {}

    def of(category, style=None):
        key = category, style or furniture.styles(category)[0]
        if key not in made:
            asset = furniture.build(*key, TABLE[category].size, 0)
            height = np.array([0.0, 0.0, asset.size[2] / 2])
            body = Body("thing", "object", category, "room", height, 0.0, asset.links, id="thing")
            folder = tmp_path_factory.mktemp("one")
            mjcf.write(_Alone(body, furnished()), folder)
            made[key] = mujoco.MjModel.from_xml_path(str(folder / "mjcf" / "apartment.xml")), asset
        return made[key]

    return of


def opened_by(model, force, arm, joint, seconds=1.5):
    """How far a steady pull at the handle opens a part from shut."""
    data = mujoco.MjData(model)
    dof, at = model.jnt_dofadr[joint], model.jnt_qposadr[joint]
    for _ in range(int(seconds / model.opt.timestep)):
        data.qfrc_applied[dof] = force * arm
        mujoco.mj_step(model, data)
    return data.qpos[at]


@pytest.mark.parametrize("style", furniture.styles("fridge"))
def test_a_fridge_takes_a_pull_to_open(simulated, style):
    """Ten newtons do not open it, forty do, by force at the handle."""
    model, asset = simulated("fridge", style)
    for joint, link in enumerate(asset.links[1:]):
        arm = float(np.linalg.norm(np.cross(np.subtract(link.handle, link.joint.origin), link.joint.axis)))
        assert opened_by(model, 10.0, arm, joint) < 0.01
        assert opened_by(model, 40.0, arm, joint) > 0.3


@pytest.mark.parametrize("category", ARTICULATED)
def test_parts_stay_where_they_are_left(simulated, category):
    """Half open and wide open, upright doors, drawers and lids are there still after three seconds."""
    model, asset = simulated(category)
    for share in (0.5, 1.0):
        data = mujoco.MjData(model)
        left = model.jnt_range[:, 0] + share * np.ptp(model.jnt_range, axis=1)
        data.qpos[:] = left
        for _ in range(int(3 / model.opt.timestep)):
            mujoco.mj_step(model, data)
        moved = np.abs(data.qpos - left) / np.ptp(model.jnt_range, axis=1)
        held = [k for k, link in enumerate(asset.links[1:]) if share == 1.0 or link.joint.part != "hinge_lid"]
        assert (moved[held] < 0.03).all(), (category, share, moved)


@pytest.mark.parametrize("category", ARTICULATED)
def test_a_hand_opens_everything(simulated, category):
    """No part needs more than sixty newtons at its handle."""
    model, asset = simulated(category)
    for joint, link in enumerate(asset.links[1:]):
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        span = np.ptp(model.jnt_range[joint])
        assert opened_by(model, 60.0, mechanisms.lever(link), joint, 3.0) > 0.5 * span, link.name


def test_draws_stay_within_the_ranges():
    rng = np.random.default_rng(0)
    asset = furniture.build("fridge", furniture.styles("fridge")[0], TABLE["fridge"].size, 0)
    row = mechanisms.table()["sealed_door"]
    for _ in range(50):
        link = asset.links[1]
        got = mechanisms.motion("fridge", link, rng)
        assert row.damping[0] <= got.damping <= row.damping[1]
        assert row.catch[0] <= got.catch / mechanisms.lever(link) <= row.catch[1]


def test_the_lever_is_from_axis_to_handle():
    """A handle half a metre from an upright axis, wherever along the axis its origin is."""
    from apartgen.stages.things.asset import Link

    joint = Joint(name="a", type="hinge", axis=(0, 0, 1), origin=(0.3, 0.1, 5.0), range=(0, 1.5), part="hinge_door")
    link = Link("a", [], [], 3.0, joint, np.array([0.3, 0.6, 0.2]))
    assert mechanisms.lever(link) == pytest.approx(0.5)
    assert categories.TABLE["fridge"].mechanism == "sealed_door" == mechanisms.kind("fridge", joint)


def test_the_document_has_the_tables():
    document = Path(__file__).parents[2] / "docs" / "physics.md"
    head, rest = document.read_text(encoding="utf-8").split("<!-- tables -->\n")
    anew = f"{head}<!-- tables -->\n{physicstable.text()}<!-- end -->\n"
    if os.environ.get("APARTGEN_WRITE_DOCS"):
        document.write_text(anew, encoding="utf-8")
    assert rest.endswith("<!-- end -->\n") and document.read_text(encoding="utf-8") == anew, "run `make docs`"
