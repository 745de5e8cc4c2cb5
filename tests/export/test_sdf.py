"""The SDFormat world: what libsdformat says of it, and the same poses and limits as every other format."""

import ctypes
import ctypes.util
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from apartgen.stages.things.body import inertia


@pytest.fixture(params=["sample", "flat"])
def made(request):
    """The file of plain boxes, and of the example flat."""
    scene, folder = request.getfixturevalue(request.param)
    return folder / "sdf" / "apartment.sdf", scene


def _library():
    found = sorted(Path("/usr/lib").glob("*/libsdformat*.so.*"))
    if not found:
        pytest.skip("libsdformat is not installed")
    return ctypes.CDLL(str(found[-1]))


def test_libsdformat_accepts_it(made, tmp_path):
    library = _library()
    assert library.cmdCheck(str(made[0]).encode()) == 0
    broken = tmp_path / "broken.sdf"
    broken.write_text(made[0].read_text().replace("<child>door_1</child>", "<child>nowhere</child>"))
    assert library.cmdCheck(str(broken).encode()) != 0


def _floats(element):
    return [float(v) for v in element.text.split()]


def test_models_stand_where_the_artifact_says_and_joints_have_its_limits(made):
    path, scene = made
    models = {model.get("name"): model for model in ElementTree.parse(path).getroot().iter("model")}
    assert set(models) == {body.name for body in scene.bodies}
    for body in scene.bodies:
        model = models[body.name]
        assert _floats(model.find("pose")) == pytest.approx([*body.position, 0, 0, body.yaw], abs=1e-6)
        still = model.find("static") is not None or model.find("joint[@type='fixed']") is not None
        assert still != body.free
        for link in body.links:
            element = model.find(f"link[@name='{body.link_name(link)}']")
            assert float(element.find("inertial/mass").text) == pytest.approx(inertia(link).mass)
            assert len(element.findall("collision")) == len(link.colliders)
            if link.joint is None:
                continue
            joint = model.find(f"joint[@name='{body.joint_name(link.joint)}']")
            limits = [float(joint.find(f"axis/limit/{end}").text) for end in ("lower", "upper")]
            assert limits == pytest.approx(link.joint.range, abs=1e-6)
            assert _floats(joint.find("axis/xyz")) == pytest.approx(link.joint.axis, abs=1e-6)
            assert _floats(joint.find("pose"))[:3] == pytest.approx(link.joint.origin, abs=1e-6)
            assert joint.get("type") == ("revolute" if link.joint.type == "hinge" else "prismatic")
    assert np.isfinite([float(m.text) for m in ElementTree.parse(path).getroot().iter("ixx")]).all()
