"""The Habitat dataset: every name resolves, and what it places is where the artifact has it, y up."""

import json

import numpy as np
import pytest
import trimesh
from export import sample
from scipy.spatial.transform import Rotation

from stages.scene import Scene

UP = trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0])


@pytest.fixture(scope="module")
def made(exported):
    out = exported("habitat")
    return out / "habitat", Scene(sample.home(), sample.load)


def _read(folder, name):
    return json.loads((folder / name).read_text())


def test_the_dataset_names_folders_and_templates_that_are_there(made):
    folder, _ = made
    dataset = _read(folder, "apartment.scene_dataset_config.json")
    for entry in dataset.values():
        for suffix, paths in entry["paths"].items():
            assert all(any(p.name.endswith(suffix) for p in (folder / path).iterdir()) for path in paths)
    scene = _read(folder, "scenes/apartment.scene_instance.json")
    assert (folder / f"stages/{scene['stage_instance']['template_name']}.stage_config.json").exists()
    for o in scene["object_instances"]:
        config = _read(folder, f"objects/{o['template_name']}.object_config.json")
        assert (folder / "objects" / config["render_asset"]).exists()
    assert all((folder / f"urdf/{o['template_name']}.urdf").exists() for o in scene["articulated_object_instances"])


def _matrix(entry):
    w, x, y, z = entry["rotation"]
    found = np.eye(4)
    found[:3, :3] = Rotation.from_quat([x, y, z, w]).as_matrix()
    found[:3, 3] = entry["translation"]
    return found


def test_things_stand_where_the_artifact_says(made):
    folder, scene = made
    instance = _read(folder, "scenes/apartment.scene_instance.json")
    placed = [body for body in scene.bodies if body.kind in ("object", "door")]
    rigid = iter(instance["object_instances"])
    jointed = iter(instance["articulated_object_instances"])
    for body in placed:
        if len(body.links) > 1:  # its URDF is z up
            entry = next(jointed)
            assert _matrix(entry) == pytest.approx(UP @ body.pose(), abs=1e-9) and entry["fixed_base"] != body.free
        else:  # its GLB is y up
            assert _matrix(next(rigid)) @ UP == pytest.approx(UP @ body.pose(), abs=1e-9)
    assert next(rigid, None) is None and next(jointed, None) is None


def test_models_are_centred_on_their_own_frame_and_the_stage_is_whole(made):
    folder, _ = made
    chair = trimesh.load(folder / "objects" / "plain_chair.glb")
    assert chair.bounds.mean(0) == pytest.approx([0, 0, 0], abs=1e-6)
    stage = trimesh.load(folder / "stages" / "apartment.glb")
    assert stage.bounds[1][1] == pytest.approx(2.6, abs=0.03)
