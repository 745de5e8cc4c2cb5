"""The glTF file read back by another library: poses, joints, materials, nothing outside the file."""

import json
import struct

import numpy as np
import pytest
import trimesh
from export import sample

from apartgen.stages.scene.scene import Scene


@pytest.fixture(scope="module")
def made(exported):
    out = exported("glb")
    return out / "apartment.glb", Scene(sample.home(), sample.load)


def _json(path):
    data = path.read_bytes()
    magic, version, length = struct.unpack("<4sII", data[:12])
    size, kind = struct.unpack("<I4s", data[12:20])
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    return json.loads(data[20 : 20 + size])


def test_y_is_up_and_the_flat_has_its_size(made):
    lo, hi = trimesh.load(made[0]).bounds
    assert hi[1] == pytest.approx(2.6, abs=0.03) and lo[1] == pytest.approx(-0.12, abs=1e-5)
    assert hi[0] - lo[0] == pytest.approx(9.6, abs=0.03) and hi[2] - lo[2] == pytest.approx(7.0, abs=0.03)


def test_every_body_and_moving_part_is_a_named_node_where_the_artifact_says(made):
    path, scene = made
    loaded = trimesh.load(path)
    up = np.linalg.inv(trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0]))
    for body in scene.bodies:
        for link in body.links:
            expected = body.pose()
            if link.joint is not None:
                expected = expected @ trimesh.transformations.translation_matrix(link.joint.origin)
            got = up @ loaded.graph.get(body.link_name(link))[0]
            assert got == pytest.approx(expected, abs=1e-6), body.link_name(link)


def test_joints_are_in_extras(made):
    path, scene = made
    nodes = {node["name"]: node for node in _json(path)["nodes"]}
    count = 0
    for body in scene.bodies:
        for joint, link in zip([part.joint for part in body.links[1:]], body.links[1:]):
            got = nodes[body.link_name(link)]["extras"]["joint"]
            assert got["range"] == pytest.approx(list(joint.range))
            assert got["axis"] == pytest.approx(list(joint.axis)) and got["type"] == joint.type
            count += 1
    assert count == sum("joint" in node.get("extras", {}) for node in nodes.values()) == 11
    assert nodes["sofa_1"]["extras"]["asset"] == "plain/sofa"


def test_geometry_is_that_of_the_assets(made):
    path, scene = made
    loaded = trimesh.load(path)
    area = sum(loaded.geometry[loaded.graph.get(node)[1]].area for node in loaded.graph.nodes_geometry)
    expected = 0.0
    for body in scene.bodies:
        for mesh in (m for link in body.links for m in link.visuals):
            solid = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
            down = solid.face_normals[:, 2] < -0.5
            expected += solid.area_faces[down].sum() if body.kind == "ceiling" else solid.area
    assert area == pytest.approx(expected, rel=1e-4)


def test_everything_is_inside_the_file_and_equal_shapes_are_stored_once(made):
    document = _json(made[0])
    assert all("uri" not in part for part in document["images"] + document["buffers"])
    doubled = [(json.dumps(m["primitives"])) for m in document["meshes"]]
    assert len(set(doubled)) == len(doubled)
    assert any(m.get("alphaMode") == "BLEND" for m in document["materials"])
    assert document["asset"]["copyright"] == "Plain boxes, public domain"
