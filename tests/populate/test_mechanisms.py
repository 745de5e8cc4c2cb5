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


def test_every_category_has_a_weight_and_every_figure_a_source():
    known = mechanisms.sources()
    assert all(kind.mass and kind.mass[0] < kind.mass[1] and kind.weighed in known for kind in TABLE.values())
    assert all(row.source in known for row in mechanisms.table().values())
    named = [kind.weighed != "own" for kind in TABLE.values()]
    assert np.mean(named) > 0.6, "weights of lists that are named"
    assert all(0 < kind.mass[0] <= kind.mass[1] for kind in small.TABLE.values())


class _Scene:
    """One body and what an exporter asks for besides."""

    def __init__(self, body, home):
        self.bodies, self.lights, self.home, self.credits = [body], [], home, []


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
            mjcf.write(_Scene(body, furnished()), folder)
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
