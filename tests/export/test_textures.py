"""Which way up textures are: a board of four colours, each file read by its own format's rule."""

import io
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh
from export import sample
from PIL import Image

from apartgen.schemas.retrieve import AssetKey, Furnishing
from apartgen.stages import export
from apartgen.stages.scene import soup
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.asset import Asset, Collider, Link, Material, Mesh

SIZE = (0.4, 2.0, 0.8)
COLORS = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 0]]], np.uint8)
"""The image: red and green in its upper row, blue and yellow below."""


def expected(points: np.ndarray) -> np.ndarray:
    """Colour of corners of the board, object's frame: rows by height, columns by its left, +y."""
    return COLORS[(points[:, 2] < 0).astype(int), (points[:, 1] > 0).astype(int)]


@pytest.fixture(scope="module")
def board(tmp_path_factory):
    """A flat whose only object is a box painted with the image, u to its left and v upwards, and how to load it."""
    path = tmp_path_factory.mktemp("image") / "four.png"
    Image.fromarray(COLORS).resize((64, 64), Image.Resampling.NEAREST).save(path)
    solid = trimesh.creation.box(SIZE)
    uv = np.where(solid.vertices[:, 1:] > 0, 0.75, 0.25)
    mesh = Mesh(solid.vertices, solid.faces, Material("painted", texture=str(path)), uv)
    base = Link("base", [mesh], [Collider("box", np.zeros(3), np.array(SIZE))], 9.0)

    def load(library: str, id: str) -> Asset:
        return Asset(library, id, "sideboard", "plain", SIZE, [base])

    thing = Furnishing(id="board", room="living_room_1", category="sideboard", center=(2.0, 1.0, 0.4), size=SIZE,
                       yaw=0.0, asset=AssetKey(library="mine", id="board"), joints=[])
    return sample.home().model_copy(update={"objects": [thing]}), load


def write(board, name: str, out: Path) -> Path:
    home, load = board
    export.run(home, [name], out, load)
    return out


def in_object(points: np.ndarray) -> np.ndarray:
    return points - [2.0, 1.0, 0.4]


def test_gltf_counts_v_from_the_top(board, tmp_path) -> None:
    """Trimesh reads the file and looks the colours up."""
    loaded = trimesh.load(write(board, "glb", tmp_path / "glb") / "apartment.glb")
    (node,) = [name for name in loaded.graph.nodes_geometry if name.startswith("board")]
    turn, geometry = loaded.graph.get(node)
    solid = loaded.geometry[geometry]
    x, y, z = trimesh.transform_points(solid.vertices, turn).T
    seen = solid.visual.to_color().vertex_colors[:, :3]
    assert len(seen) >= 8 and np.array_equal(seen, expected(in_object(np.stack([x, -z, y], -1))))


def test_usd_counts_v_from_the_bottom(board, tmp_path) -> None:
    pxr = pytest.importorskip("pxr")
    from pxr import Usd, UsdGeom

    assert pxr
    folder = write(board, "usd", tmp_path / "usd")
    (main,) = [path for path in folder.rglob("*.usd*") if path.stem == "apartment"]
    stage = Usd.Stage.Open(str(main))
    painted = [prim for prim in stage.TraverseAll() if prim.IsA(UsdGeom.Mesh)
               and UsdGeom.PrimvarsAPI(prim).HasPrimvar("st") and "board" in str(prim.GetPath())]
    assert painted
    for prim in painted:
        frame = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(prim))
        points = np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get()) @ frame[:3, :3] + frame[3, :3]
        u, v = np.array(UsdGeom.PrimvarsAPI(prim).GetPrimvar("st").ComputeFlattened()).T
        seen = COLORS[(v < 0.5).astype(int), (u > 0.5).astype(int)]
        assert np.array_equal(seen, expected(in_object(points)))


@pytest.mark.parametrize("name", ["urdf", "habitat", "sdf"])
def test_a_picture_goes_along_the_right_way_up(board, name, tmp_path) -> None:
    """In meshes by themselves, OBJ or GLB, with whatever image is beside them."""
    folder = write(board, name, tmp_path / name)
    found = 0
    for path in sorted({*folder.rglob("*.obj"), *folder.rglob("*.glb")}):
        loaded = trimesh.load(path, force="scene")
        for node in loaded.graph.nodes_geometry:
            turn, geometry = loaded.graph.get(node)
            solid = loaded.geometry[geometry]
            extents = trimesh.transform_points(solid.vertices, turn)
            size = np.ptp(extents, axis=0)
            if not np.allclose(sorted(size), sorted(SIZE), atol=1e-3) or getattr(solid.visual, "uv", None) is None:
                continue
            x, y, z = extents.T
            up = extents if np.isclose(size[2], SIZE[2]) else np.stack([x, -z, y], -1)
            seen = solid.visual.to_color().vertex_colors[:, :3]
            assert np.array_equal(seen, expected(up - (up.min(0) + up.max(0)) / 2)), path.name
            found += 1
    assert found


def test_mujoco_finds_the_colours_where_they_are(board, tmp_path) -> None:
    """As it has read them: its textures begin with the image's upper row, at v 0."""
    model = mujoco.MjModel.from_xml_path(str(write(board, "mjcf", tmp_path / "out") / "mjcf" / "apartment.xml"))
    (geom,) = np.flatnonzero((model.geom_bodyid == model.body("board").id) & (model.geom_matid >= 0))
    mesh = model.geom_dataid[geom]
    faces = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])
    u, v = model.mesh_texcoord[model.mesh_texcoordadr[mesh] + model.mesh_facetexcoord[faces].ravel()].T
    points = model.mesh_vert[model.mesh_vertadr[mesh] + model.mesh_face[faces].ravel()]
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    points = points @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
    (texture,) = {k for k in model.mat_texid[model.geom_matid[geom]] if k >= 0}
    start, height, width = model.tex_adr[texture], model.tex_height[texture], model.tex_width[texture]
    image = model.tex_data[start : start + 3 * height * width].reshape(height, width, 3)
    seen = image[(v * height).astype(int), (u * width).astype(int)]
    assert np.array_equal(seen, expected(in_object(points)))


def test_a_ray_meets_the_colour_that_is_there(board) -> None:
    home, load = board
    (body,) = [body for body in Scene(home, load).bodies if body.name == "board"]
    triangles = soup.soup([body])
    points = np.array([[3.0, 1.0 + y, 0.4 + z] for y in (-0.9, 0.9) for z in (-0.35, 0.35)], np.float32)
    ahead = np.tile(np.array([-1, 0, 0], np.float32), (4, 1))
    hits = soup.Tracer(triangles).first(points, ahead)
    light, normal = soup.colors(hits, triangles)
    assert hits.distance == pytest.approx(np.full(4, 0.8), abs=1e-5) and normal == pytest.approx(-ahead, abs=1e-6)
    assert np.array_equal(light > 0.5, expected(in_object(points)) > 128)


def test_an_image_is_written_as_it_is(board) -> None:
    from apartgen.stages.scene.pieces import image

    home, load = board
    texture = load("mine", "board").links[0].visuals[0].material.texture
    assert np.array_equal(np.asarray(Image.open(io.BytesIO(image(texture))))[::32, ::32], COLORS)
