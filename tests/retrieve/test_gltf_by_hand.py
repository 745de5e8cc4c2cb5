"""glTF in every type of number that it allows, strided and shifted, and where its nodes put things."""

import base64
import json

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from apartgen.stages.retrieve.reading import gltf
from apartgen.stages.retrieve.reading.limits import Broken

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
NUMBERS = {5120: np.int8, 5121: np.uint8, 5122: np.int16, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}


def body(corners, faces, points=5126, indices=5123, gap=0, lead=0, normalized=False, nodes=None):
    """A tetrahedron whose corners lie `gap` bytes apart, `lead` bytes into the buffer."""
    rows = [corner.astype(NUMBERS[points]).tobytes() for corner in corners]
    begin = b"\x7f" * lead + b"".join(row + b"\x7f" * gap for row in rows)
    data = begin + faces.astype(NUMBERS[indices]).tobytes()
    stride = {"byteStride": len(rows[0]) + gap} if gap else {}
    about = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteOffset": lead, "byteLength": len(begin) - lead, **stride},
                        {"buffer": 0, "byteOffset": len(begin), "byteLength": len(data) - len(begin)}],
        "accessors": [{"bufferView": 0, "componentType": points, "count": len(corners), "type": "VEC3",
                       **({"normalized": True} if normalized else {})},
                      {"bufferView": 1, "componentType": indices, "count": faces.size, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "nodes": nodes or [{"mesh": 0}]}
    return json.dumps(about).encode()


def read(data):
    return gltf.parse(data, "a.gltf", lambda _: None)


@pytest.mark.parametrize("points", NUMBERS)
@pytest.mark.parametrize(("gap", "lead"), [(0, 0), (4, 0), (0, 12), (8, 4)])
def test_corners_are_the_same_in_every_type(points, gap, lead):
    corners = CORNERS * [2, 3, 5] + (0 if np.dtype(NUMBERS[points]).kind == "u" else -2)
    (piece,) = read(body(corners, FACES, points, gap=gap, lead=lead))[0].all()
    assert (piece.vertices == corners).all() and (piece.faces == FACES).all()


@pytest.mark.parametrize("points", [5120, 5121, 5122, 5123])
def test_normalized_numbers_are_shares_of_the_largest(points):
    """c / (2^b - 1) without a sign, max(c / (2^(b - 1) - 1), -1) with one (glTF 2.0, 3.11)."""
    most = np.iinfo(NUMBERS[points]).max
    least = np.iinfo(NUMBERS[points]).min
    corners = np.array([[0, 0, 0], [most, 0, 0], [0, most // 3, 0], [0, 0, least or most]])
    (piece,) = read(body(corners, FACES, points, normalized=True))[0].all()
    assert piece.vertices == pytest.approx(np.array(
        [[0, 0, 0], [1, 0, 0], [0, (most // 3) / most, 0], [0, 0, -1 if least else 1]]))


@pytest.mark.parametrize("indices", [5121, 5123, 5125])
def test_faces_are_the_same_in_every_type(indices):
    (piece,) = read(body(CORNERS, FACES, indices=indices))[0].all()
    assert (piece.faces == FACES).all() and (piece.vertices == CORNERS).all()


def test_nodes_turn_scale_and_shift_what_is_in_them():
    """A node's scale first, then its rotation (x, y, z, w), then its shift; then those of the node that it is in.

    A matrix is told column by column.
    """
    turns = Rotation.from_quat(np.random.default_rng(3).normal(size=(2, 4)))
    scale, shift, outer = np.array([1.5, 0.5, 2.0]), np.array([0.2, -1.0, 3.0]), np.array([-4.0, 0.5, 1.0])
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turns[1].as_matrix(), outer
    inner = {"mesh": 0, "rotation": turns[0].as_quat().tolist(), "scale": scale.tolist(), "translation": shift.tolist()}
    nodes = [{"children": [1], "matrix": matrix.T.ravel().tolist(), "name": "door"}, inner]
    data = json.loads(body(CORNERS, FACES, nodes=nodes))
    (root,) = read(json.dumps(data | {"scenes": [{"nodes": [0]}]}).encode())
    (piece,) = root.all()
    assert root.name == "door" and root.children[0].name == "node_1"
    assert piece.vertices == pytest.approx(turns[1].apply(turns[0].apply(CORNERS * scale) + shift) + outer, abs=1e-6)


def test_numbers_beyond_the_buffer_are_refused_to_the_byte():
    data = json.loads(body(CORNERS, FACES))
    assert read(json.dumps(data).encode())
    for edit in ({"count": 13}, {"byteOffset": 1}, {"count": 0}, {"byteOffset": -1000}):
        more = json.loads(json.dumps(data))
        more["accessors"][1] |= edit
        with pytest.raises(Broken):
            read(json.dumps(more).encode())
