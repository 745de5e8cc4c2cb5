"""The Habitat dataset: every name resolves, and what it places is where the artifact has it, y up."""

import json

import numpy as np
import pytest
import trimesh
from export import sample
from scipy.spatial.transform import Rotation

from apartgen.stages import export
from apartgen.stages.export._hull import hull
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import categories

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
    lexicons = dataset.pop("semantic_scene_descriptor_instances")
    for entry in dataset.values():
        for suffix, paths in entry["paths"].items():
            assert all(any(p.name.endswith(suffix) for p in (folder / path).iterdir()) for path in paths)
    scene = _read(folder, "scenes/apartment.scene_instance.json")
    assert (folder / lexicons[scene["semantic_scene_instance"]]).exists()
    assert (folder / f"stages/{scene['stage_instance']['template_name']}.stage_config.json").exists()
    for o in scene["object_instances"]:
        config = _read(folder, f"objects/{o['template_name']}.object_config.json")
        assert (folder / "objects" / config["render_asset"]).exists()
    assert all((folder / f"urdf/{o['template_name']}.urdf").exists() for o in scene["articulated_object_instances"])


@pytest.mark.parametrize("name", ["sample", "flat"])
def test_every_template_has_the_semantic_id_of_its_category(request, name):
    folder = request.getfixturevalue(name).folder / "habitat"
    classes = _read(folder, "semantics/apartment.semantic_lexicon.json")["classes"]
    assert [row["id"] for row in classes] == list(range(len(classes))) and classes[0]["name"] == "unknown"
    likes = sorted(name for name, kind in categories.TABLE.items() if kind.like)
    own = sorted(set(categories.TABLE) - set(likes))
    assert [row["name"] for row in classes[1:]] == [*own, "door", "entrance", *likes], "ids stay as categories come"
    instance = _read(folder, "scenes/apartment.scene_instance.json")
    seen = set()
    for kind, placed in (("objects", "object"), ("urdf", "articulated_object")):
        for entry in instance[f"{placed}_instances"]:
            suffix = "object_config" if kind == "objects" else "ao_config"
            config = _read(folder, f"{kind}/{entry['template_name']}.{suffix}.json")
            assert classes[config["semantic_id"]]["name"] == entry["user_defined"]["category"] != "unknown"
            assert kind == "objects" or (folder / kind / config["urdf_filepath"]).exists()
            seen.add(config["semantic_id"])
    assert len(seen) > 10


def test_an_asset_that_serves_two_categories_is_two_templates(tmp_path):
    home = sample.home()
    box = next(o for o in home.objects if o.category == "coffee_table")
    twin = box.model_copy(update={"id": "side_table_99", "category": "side_table", "center": (1.0, 3.5, 0.2)})
    home.objects.append(twin)
    export.run(home, ["habitat"], tmp_path / "scene", sample.load)
    instance = _read(tmp_path / "scene" / "habitat", "scenes/apartment.scene_instance.json")
    names = {o["user_defined"]["category"]: o["template_name"] for o in instance["object_instances"]}
    assert names["coffee_table"] != names["side_table"]
    config = _read(tmp_path / "scene" / "habitat", f"objects/{names['side_table']}.object_config.json")
    assert config["user_defined"]["category"] == "side_table"


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


def _felt(folder, template):
    """An object's collision meshes in its frame, each of which Habitat takes the hull of."""
    config = _read(folder, f"objects/{template}.object_config.json")
    assert not config["join_collision_meshes"]
    if not config["is_collidable"]:
        return [], config
    scene = trimesh.load(folder / "objects" / config["collision_asset"])
    nodes = (scene.graph.get(f"collider_{k}") for k in range(len(scene.graph.nodes_geometry)))
    return [scene.geometry[shape].copy().apply_transform(pose) for pose, shape in nodes], config


def test_an_object_is_felt_where_its_colliders_are(flat):
    folder = flat.folder / "habitat"
    instance = _read(folder, "scenes/apartment.scene_instance.json")
    bodies = {body.name: body for body in flat.scene.bodies}
    kinds = set()
    for entry in instance["object_instances"]:
        body = bodies[entry["user_defined"]["name"]]
        colliders, meshes = body.links[0].colliders, _felt(folder, entry["template_name"])[0]
        assert len(meshes) == len(colliders)
        if not colliders:
            continue
        spans = np.array([mesh.apply_transform(np.linalg.inv(UP)).bounds for mesh in meshes])
        expected = np.array([[points.min(0), points.max(0)] for points in (hull(c)[0] for c in colliders)])
        assert spans == pytest.approx(expected, abs=1e-5), body.name
        assert all(mesh.volume == pytest.approx(mesh.convex_hull.volume, rel=1e-3) for mesh in meshes)
        kinds |= {c.kind for c in colliders}
    assert {"box", "cylinder", "hull"} <= kinds


def _urdf(tmp_path, name, meshes, mass, center, concave=""):
    """A body of meshes for Bullet, which is Habitat's engine."""
    shapes = []
    for k, mesh in enumerate(meshes):
        mesh.export(tmp_path / f"{name}_{k}.obj")
        shapes.append(f'<collision {concave}><geometry><mesh filename="{name}_{k}.obj"/></geometry></collision>')
    place = " ".join(map(str, center))
    weight = f'<origin xyz="{place}"/><mass value="{mass}"/><inertia ixx="0.1" iyy="0.1" izz="0.1"/>'
    path = tmp_path / f"{name}.urdf"
    lines = [f'<robot name="{name}"><link name="base">', f"<inertial>{weight}</inertial>", *shapes, "</link></robot>"]
    path.write_text("\n".join(lines))  # Bullet takes no line above 1024 characters
    return str(path)


def test_in_bullet_nothing_that_is_loose_moves(flat, tmp_path):
    bullet = pytest.importorskip("pybullet")
    folder, client = flat.folder / "habitat", bullet.connect(bullet.DIRECT)
    instance = _read(folder, "scenes/apartment.scene_instance.json")

    def load(path, entry, fixed, margin):
        w, x, y, z = entry["rotation"]
        made = bullet.loadURDF(path, entry["translation"], [x, y, z, w], useFixedBase=fixed, physicsClientId=client)
        bullet.changeDynamics(made, -1, collisionMargin=margin, physicsClientId=client)
        return made

    stage = _read(folder, "stages/apartment.stage_config.json")
    walls = trimesh.load(folder / "stages" / stage["collision_asset"]).to_geometry()
    origin = {"translation": [0, 0, 0], "rotation": [1, 0, 0, 0]}
    load(_urdf(tmp_path, "stage", [walls], 1, [0, 0, 0], 'concave="yes"'), origin, True, stage["margin"])
    loose = {}
    for k, entry in enumerate(instance["object_instances"]):
        meshes, config = _felt(folder, entry["template_name"])
        path = _urdf(tmp_path, f"object_{k}", meshes, config["mass"], config["COM"])
        free = entry["motion_type"] == "DYNAMIC"
        made = load(path, entry, not free, config["margin"])
        loose |= {entry["user_defined"]["name"]: made} if free else {}
    for entry in instance["articulated_object_instances"]:
        load(str(folder / "urdf" / f"{entry['template_name']}.urdf"), entry, entry["fixed_base"], 0.001)
    assert len(loose) == sum(body.free and len(body.links) == 1 for body in flat.scene.bodies) > 3
    bullet.setGravity(0, -9.81, 0, physicsClientId=client)

    def places():
        return np.array([bullet.getBasePositionAndOrientation(made, client)[0] for made in loose.values()])

    start = places()
    for _ in range(240):  # 1 s
        bullet.stepSimulation(client)
    moved = np.linalg.norm(places() - start, axis=1)
    bullet.disconnect(client)
    assert not {name: by for name, by in zip(loose, moved) if by > 0.02}
