"""What validators made by others say of the files; each is skipped where it is not installed."""

import json
import os
import shutil
import subprocess

import pytest
from export import readers

GLTF = """
const fs = require("fs");
const { validateBytes } = require("gltf-validator");
(async () => {
  for (const file of process.argv.slice(1)) {
    const { issues } = await validateBytes(new Uint8Array(fs.readFileSync(file)), { maxIssues: 5 });
    console.log(JSON.stringify(issues));
  }
})();
"""


def _gltf(*files):
    """The issues of each file, by Khronos's validator; NODE_PATH says where npm has put it."""
    node = shutil.which("node")
    if not node or subprocess.run([node, "-e", 'require("gltf-validator")'], capture_output=True).returncode:
        pytest.skip("node with gltf-validator is not installed")
    done = subprocess.run([node, "-e", GLTF, *map(str, files)], capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_khronos_finds_nothing_in_any_glb(flat, tmp_path):
    broken = tmp_path / "broken.glb"
    data = (flat.folder / "apartment.glb").read_bytes()
    broken.write_bytes(data.replace(b'"componentType":5126', b'"componentType":5127', 1))
    files = [flat.folder / "apartment.glb", *sorted((flat.folder / "habitat").rglob("*.glb"))]
    assert len(files) > 10
    *found, fault = _gltf(*files, broken)
    assert fault["numErrors"] > 0
    for file, issues in zip(files, found):
        assert not issues["numErrors"] and not issues["numWarnings"], (file.name, issues["messages"])


def test_omniverse_finds_nothing_in_the_usd(flat):
    validator = pytest.importorskip("omni.asset_validator")
    issues = list(validator.ValidationEngine().validate(str(flat.folder / "usd" / "apartment.usd")).issues())
    assert not {f"{issue.severity.name} {issue.rule.__name__}: {issue.message}" for issue in issues}


def test_omniverse_sees_a_fault(flat, tmp_path):
    validator = pytest.importorskip("omni.asset_validator")
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.Open(str(flat.folder / "usd" / "apartment.usd"))
    UsdGeom.SetStageUpAxis(stage, "Y")
    stage.GetRootLayer().Export(str(tmp_path / "broken.usd"))
    assert list(validator.ValidationEngine().validate(str(tmp_path / "broken.usd")).issues())


def test_usd_has_no_body_in_a_body_and_no_limits_the_wrong_way_round(flat):
    """What neither validator sees."""
    pytest.importorskip("pxr")
    from pxr import Usd, UsdPhysics

    stage = Usd.Stage.Open(str(flat.folder / "usd" / "apartment.usd"))
    rigid = {prim.GetPath() for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    assert rigid and not {path for path in rigid if any(above in rigid for above in path.GetAncestorsRange()
                                                        if above != path)}
    for prim in stage.Traverse():
        if prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint):
            assert prim.GetAttribute("physics:lowerLimit").Get() < prim.GetAttribute("physics:upperLimit").Get()


def test_openusd_finds_nothing_in_the_usd(flat):
    pytest.importorskip("pxr")
    from pxr import Usd, UsdValidation

    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    stage = Usd.Stage.Open(str(flat.folder / "usd" / "apartment.usd"))
    assert not [fault.GetMessage() for fault in UsdValidation.ValidationContext(validators).Validate(stage)]


def test_check_urdf_reads_the_apartment_and_every_object(flat):
    check = shutil.which("check_urdf")
    if not check:
        pytest.skip("check_urdf is not installed")
    for file in (flat.folder / "urdf").rglob("*.urdf"):
        done = subprocess.run([check, file], capture_output=True, text=True)
        assert done.returncode == 0 and "Successfully Parsed XML" in done.stdout, (file.name, done.stderr)


def test_every_mesh_and_texture_that_usd_names_is_beside_it(flat):
    pytest.importorskip("pxr")
    from pxr import UsdUtils

    layers, assets, missing = UsdUtils.ComputeAllDependencies(str(flat.folder / "usd" / "apartment.usd"))
    assert len(layers) == 1 and len(assets) > 3 and not missing
    assert all(os.path.realpath(path).startswith(os.path.realpath(flat.folder)) for path in assets)


def test_a_glb_carries_all_it_needs(flat):
    for file in flat.folder.rglob("*.glb"):
        made = readers.document(file)
        assert all("uri" not in part for part in made.get("images", []) + made["buffers"]), file.name
