"""Photographs are another program's: what it is told is right, what it makes is listed, and that it fails is said."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from apartgen.outputs import opened_libraries
from apartgen.rendering import RenderSettings, rendered
from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput
from apartgen.schemas.walkable import Walkable
from apartgen.stages.render import photo
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world
from apartgen.stages.things.categories import TABLE

HOME = Path(__file__).parent.parent / "golden/v2/walkable.json"
FAKE = '''#!{python}
"""Writes what it was told in place of a picture."""
import json, sys
job = json.load(open(sys.argv[-1]))
assert open(job["glb"], "rb").read(4) == b"glTF"
for view in job["views"][{skip}:]:
    open(f"{{job['out']}}/{{view['name']}}.photo.png", "w").write(json.dumps(job))
sys.exit({status})
'''


def program(folder, skip=0, status=0):
    path = folder / f"blender_{skip}_{status}"
    path.write_text(FAKE.format(python=sys.executable, skip=skip, status=status))
    path.chmod(0o755)
    return str(path)


def settings(photo):
    return RenderSettings(kind=["eye"], views=2, width=64, height=48, points=0, photo=photo, samples=7)


def test_photographs_are_listed_and_blender_is_told_of_cameras_windows_and_the_sun(tmp_path):
    read = artifact.read(HOME, Walkable)
    found = rendered(read, settings(program(tmp_path)), 1, tmp_path / "views")
    files = [file.path for file in found.files if file.format == "photo"]
    assert files == [f"{view.name}.photo.png" for view in found.views]
    assert all(f"  {name}\n" in (tmp_path / "views/SHA256SUMS").read_text() for name in files)
    job = json.loads((tmp_path / "views" / files[0]).read_text())
    assert [(view["name"], view["fx"]) for view in job["views"]] == [(v.name, v.intrinsics[0]) for v in found.views]
    assert job["samples"] == 7 and job["sun"][2] > 0 and np.linalg.norm(job["sun"]) == pytest.approx(1)
    windows = [o for o in read.body.openings if o.kind == "window"]
    assert len(job["panes"]) == len(windows)
    for (corner, across, up, normal), o in zip(job["panes"], windows):
        assert np.linalg.norm(across) == pytest.approx(np.hypot(*np.subtract(*o.segment)), rel=1e-4)
        assert up[2] == pytest.approx(o.head - o.sill, rel=1e-4) and abs(np.dot(normal, across)) < 1e-4
        assert corner[2] == pytest.approx(o.sill, abs=1e-4)
    plaster = {name for name, kind in job["uneven"].items() if kind == "plaster"}
    walls = {mesh.material.name for body in world(Scene(read.body, opened_libraries().load_asset)).bodies
             if body.kind == "wall" for link in body.links for mesh in link.visuals} - {"tile_white"}
    assert walls and walls <= plaster and "tile_white" not in plaster
    assert set(job["uneven"].values()) == {"plaster", "cloth", "bedding"}
    lit = {o.id for o in read.body.objects if TABLE[o.category].lumens > 0}
    assert lit and set(job["lamps"]) == lit
    rough = {material.name: material.roughness for body in world(Scene(read.body, opened_libraries().load_asset)).bodies
             if body.name in lit for link in body.links for material in (mesh.material for mesh in link.visuals)}
    assert job["shades"] and set(job["shades"]) == {name for name, value in rough.items() if value >= photo.CLOTH}


@pytest.mark.parametrize("skip, status, told", [(0, 1, "failed"), (1, 0, "without a picture")])
def test_what_goes_wrong_is_said(tmp_path, skip, status, told):
    home = artifact.read(HOME, Walkable).body
    around = world(Scene(home, opened_libraries().load_asset))
    read = artifact.read(HOME, Walkable)
    views = rendered(read, settings(""), 1, tmp_path / "views").views
    with pytest.raises(BadInput, match=told):
        photo.photographed(around, b"glTF", views, program(tmp_path, skip, status), 1, tmp_path)
    with pytest.raises(BadInput, match="cannot be run"):
        photo.photographed(around, b"glTF", views, str(tmp_path / "none"), 1, tmp_path)


def test_blender_itself_is_run_as_it_wants():
    assert photo.command("/opt/blender", Path("job"))[:2] == ["/opt/blender", "-b"]
    assert photo.command("/venv/bin/python", Path("job")) == ["/venv/bin/python", str(photo.SCRIPT), "job"]
