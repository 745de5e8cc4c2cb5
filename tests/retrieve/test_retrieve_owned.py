"""Libraries people own: small fixtures in the exact form of the real ones, each with its traps."""

import json
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest

from apartgen.stages.retrieve import future3d, gapartnet, simobjects, sweethome3d
from apartgen.stages.retrieve.reading.limits import Broken

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
QUADS = [[1, 2, 4, 3], [5, 7, 8, 6], [1, 5, 6, 2], [3, 4, 8, 7], [1, 3, 7, 5], [2, 6, 8, 4]]


def obj(lo, hi, material="m", open_side=False) -> str:
    """A box between two corners as OBJ text, its last side missing if `open_side`."""
    vertices = np.asarray(lo, float) + CUBE * (np.asarray(hi, float) - np.asarray(lo, float))
    lines = [
        "mtllib model.mtl",
        *(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in vertices),
        "vt 0 0",
        f"usemtl {material}",
    ]
    quads = QUADS[:-1] if open_side else QUADS
    return "\n".join([*lines, *(f"f {' '.join(f'{i}/1' for i in quad)}" for quad in quads)]) + "\n"


def loaded(sources) -> dict:
    return {source.id: source.load() for source in sources}


# GAPartNet


@pytest.fixture
def partnet(tmp_path: Path) -> Path:
    """A cabinet in PartNet's frame (y up, front +z, unit sphere): body, door hinged left with a handle, drawer."""
    folder = tmp_path / "45661"
    (folder / "textured_objs").mkdir(parents=True)
    (folder / "images").mkdir()
    (folder / "images" / "texture_1.jpg").write_bytes(b"jpeg")
    boxes = {
        "body": ((-0.4, -0.5, -0.3), (0.4, 0.5, 0.28)),
        "door": ((-0.4, -0.5, 0.28), (0.4, 0.2, 0.3)),
        "handle": ((0.3, -0.2, 0.3), (0.33, 0.0, 0.34)),
        "drawer": ((-0.4, 0.2, -0.2), (0.4, 0.5, 0.3)),
    }
    mtl = "newmtl m\nKd 0.5 0.4 0.3\nmap_Kd ../images/texture_1.jpg\n"
    (folder / "textured_objs" / "model.mtl").write_text(mtl)
    for name, (lo, hi) in boxes.items():
        (folder / "textured_objs" / f"{name}.obj").write_text(obj(lo, hi, open_side=name == "body"))

    def link(name: str, mesh: str, shift=(0, 0, 0)) -> str:
        x, y, z = shift
        shape = f'<origin xyz="{x} {y} {z}"/><geometry><mesh filename="textured_objs/{mesh}.obj"/></geometry>'
        # Real files use the same visual name again and again.
        return f'<link name="{name}"><visual name="part-1">{shape}</visual><collision>{shape}</collision></link>'

    (folder / "mobility_annotation_gapartnet.urdf").write_text(f"""<?xml version="1.0" ?>
    <robot name="partnet_45661"><link name="base"/>
    {link("link_0", "door", (0.4, 0, -0.28))}{link("link_1", "drawer")}{link("link_2", "body")}
    {link("link_0_handle", "handle", (0.4, 0, -0.28))}
    <joint name="joint_0" type="revolute"><origin xyz="-0.4 0 0.28"/><axis xyz="0 -1 0"/><child link="link_0"/>
      <parent link="link_2"/><limit lower="0" upper="1.5707963"/></joint>
    <joint name="joint_1" type="prismatic"><origin xyz="0 0 0"/><axis xyz="0 0 1"/><child link="link_1"/>
      <parent link="link_2"/><limit lower="0" upper="0.4"/></joint>
    <joint name="joint_3" type="fixed"><child link="link_0_handle"/><parent link="link_0"/></joint>
    <joint name="joint_2" type="fixed"><origin rpy="1.570796326794897 0 -1.570796326794897" xyz="0 0 0"/>
      <child link="link_2"/><parent link="base"/></joint></robot>""")
    corners = (CUBE * 0.1).tolist()
    (folder / "link_annotation_gapartnet.json").write_text(
        json.dumps(
            [
                {"link_name": "link_0", "is_gapart": True, "category": "hinge_door", "bbox": corners},
                {"link_name": "link_1", "is_gapart": True, "category": "slider_drawer", "bbox": corners},
                {"link_name": "link_0_handle", "is_gapart": True, "category": "line_fixed_handle", "bbox": corners},
                {"link_name": "link_2", "is_gapart": False, "category": "", "bbox": []},
            ]
        )
    )
    (folder / "semantics.txt").write_text(
        "link_0 hinge rotation_door\nlink_1 slider drawer\nlink_2 heavy cabinet_frame\n"
    )
    limit = {"a": 90, "b": 0, "noLimit": False}
    (folder / "mobility_v2.json").write_text(json.dumps([{"id": 0, "joint": "hinge", "jointData": {"limit": limit}}]))
    (folder / "bounding_box.json").write_text(json.dumps({"min": [-0.4, -0.5, -0.3], "max": [0.4, 0.5, 0.3]}))
    (folder / "meta.json").write_text(json.dumps({"model_cat": "StorageFurniture", "user_id": ""}))
    return tmp_path


def test_gapartnet_frame_scale_joints_and_classes(partnet):
    asset = loaded(gapartnet.assets(partnet))["45661"]
    joints = {joint.name: joint for joint in asset.joints}
    door, drawer = joints["link_0"], joints["link_1"]
    assert (door.part, drawer.part) == ("hinge_door", "slider_drawer")
    # PartNet's 0.8 wide, 1.0 high and 0.64 deep, with its handle, keep their proportions.
    scale = asset.size[1] / 0.8
    assert np.allclose(asset.size, np.array([0.64, 0.8, 1.0]) * scale, atol=1e-6)
    assert 0.3 < asset.size[1] < 3.2
    assert drawer.axis == (1.0, 0.0, 0.0) and np.isclose(drawer.range[1], 0.4 * scale)
    assert door.type == "hinge" and np.isclose(abs(door.axis[2]), 1) and np.isclose(door.range[1], np.pi / 2)
    # PartNet's x runs to the right of one who looks at the front; the hinge is on its -x side, this frame's right.
    assert np.isclose(door.origin[1], -asset.size[1] / 2)
    free = np.array([0, asset.size[1], 0])
    assert np.cross(door.axis, free)[0] > 0, "the free edge must come forward"
    link = next(link for link in asset.links if link.name == "link_0")
    assert link.grip == "line_fixed_handle"
    assert link.handle is not None and np.isclose(link.handle[0], asset.size[0] / 2 - 0.02 * scale)
    assert {mesh.material.texture for mesh in link.visuals} == {str(partnet.resolve() / "45661/images/texture_1.jpg")}
    assert "PartNet" in asset.credit


def test_gapartnet_takes_degrees_from_mobility_v2_where_the_urdf_has_no_limits(partnet):
    file = partnet / "45661" / "mobility_annotation_gapartnet.urdf"
    file.write_text(file.read_text().replace('<limit lower="0" upper="1.5707963"/>', ""))
    door = next(j for j in loaded(gapartnet.assets(partnet))["45661"].joints if j.name == "link_0")
    assert np.isclose(door.range[1] - door.range[0], np.pi / 2)


def test_gapartnet_without_annotation_reads_semantics(partnet):
    (partnet / "45661" / "link_annotation_gapartnet.json").unlink()
    parts = {j.name: j.part for j in loaded(gapartnet.assets(partnet))["45661"].joints}
    assert parts == {"link_0": "hinge_door", "link_1": "slider_drawer"}


def test_gapartnet_names_what_is_missing(partnet):
    (partnet / "45661" / "textured_objs" / "door.obj").unlink()
    with pytest.raises(Broken, match="door.obj"):
        loaded(gapartnet.assets(partnet))


# 3D-FUTURE


@pytest.fixture
def future(tmp_path: Path) -> Path:
    models = tmp_path / "3D-FUTURE-model"
    sizes = {"aaa": (2.0, 0.8, 0.9), "bbb": (200.0, 80.0, 90.0), "ccc": (0.5, 1.1, 0.45)}
    rows = []
    for jid, (w, h, d) in sizes.items():
        (models / jid).mkdir(parents=True)
        (models / jid / "raw_model.obj").write_text(obj((-w / 2, 0, -d / 2), (w / 2, h, d / 2)))
        (models / jid / "model.mtl").write_text("newmtl m\nKd 1 1 1\n")
        (models / jid / "texture.png").write_bytes(b"png")
        row = {"model_id": jid, "super-category": "Sofa", "category": "Three-Seat / Multi-seat Sofa"}
        rows.append(row | {"style": None, "theme": None, "material": None})
    rows[2] |= {"super-category": "Chair", "category": None, "style": "Modern"}
    rows.append(rows[0] | {"model_id": "ddd"})
    (models / "model_info.json").write_text(json.dumps(rows))
    return tmp_path


def test_future3d_units_categories_and_nulls(future):
    sources = {source.id: source for source in future3d.assets(future)}
    metres, centimetres, chair = (sources[jid].load() for jid in ("aaa", "bbb", "ccc"))
    assert metres.category == centimetres.category == "sofa"
    assert np.allclose(metres.size, (0.9, 2.0, 0.8)) and np.allclose(centimetres.size, metres.size)
    assert chair.category == "chair" and chair.style == "Modern" and metres.style == ""
    assert metres.links[0].visuals[0].material.texture.endswith("aaa/texture.png")
    with pytest.raises(Broken, match="no folder"):
        sources["ddd"].load()


def test_future3d_normalised_cube_takes_its_size_from_boxes_in_centimetres(future):
    folder = future / "3D-FUTURE-model" / "aaa"
    (folder / "raw_model.obj").unlink()
    (folder / "normalized_model.obj").write_text(obj((-0.5, -0.2, -0.225), (0.5, 0.2, 0.225)))
    (future / "boxes").mkdir()
    box = {"xLen": 220.0, "yLen": 88.0, "zLen": 99.0}
    (future / "boxes" / "model_info.json").write_text(json.dumps({"aaa": {"boundingBox": box}}))
    made = {s.id: s for s in future3d.assets(future)}["aaa"].load()
    assert np.allclose(made.size, (0.99, 2.2, 0.88), atol=1e-6)


# URDF, MJCF, SDF

MJCF = """<mujoco model="cupboard"><compiler angle="degree"/>
<default><default class="seen"><geom contype="0" conaffinity="0" type="box" rgba=".5 .4 .3 1"/></default>
<default class="hit"><geom type="box" group="4"/></default></default>
<include file="parts/assets.xml"/>
<worldbody><body name="case" pos="1 2 3" childclass="seen">
  <geom size=".2 .3 .4"/><geom class="hit" size=".2 .3 .4" mass="8"/>
  <body name="leaf" pos="-.2 -.32 0"><joint axis="0 0 1" range="-90 0"/>
    <geom pos=".2 0 0" size=".2 .02 .4"/><geom class="hit" type="mesh" mesh="slab" mass="1"/>
    <geom class="hit" type="capsule" fromto=".3 -.05 -.1 .3 -.05 .1" size=".01"/></body>
</body></worldbody></mujoco>"""


def stl(lo, hi) -> bytes:
    vertices = (np.asarray(lo, float) + CUBE * (np.asarray(hi, float) - np.asarray(lo, float))).astype("<f4")
    faces = [(q[0] - 1, q[i] - 1, q[i + 1] - 1) for q in QUADS for i in (1, 2)]
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *vertices[list(face)].ravel(), 0) for face in faces)
    # Some exporters begin even binary files with "solid".
    return b"solid made by hand".ljust(80) + struct.pack("<I", len(faces)) + body


def test_mjcf_classes_includes_meshes_and_degrees(tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "slab.stl").write_bytes(stl((0, -0.02, -0.4), (0.4, 0.02, 0.4)))
    (tmp_path / "parts" / "assets.xml").write_text(
        '<mujocoinclude><asset><mesh name="slab" file="parts/slab.stl"/></asset></mujocoinclude>'
    )
    (tmp_path / "cupboard.xml").write_text(MJCF)
    found = loaded(simobjects.assets(tmp_path))
    assert list(found) == ["cupboard"], "the included fragment is no object"
    asset = found["cupboard"]
    (joint,) = asset.joints
    assert np.isclose(joint.range[1], np.pi / 2) and joint.range[0] == 0
    assert np.allclose(asset.size, (0.64, 0.4, 0.8)), "turned to face where its leaf is"
    assert joint.extent is not None and np.isclose(joint.extent[1][0], asset.size[0] / 2)
    leaf = asset.links[1]
    assert {c.kind for c in leaf.colliders} == {"hull"} and len(leaf.colliders) == 2
    assert len(leaf.visuals) == 1, "what collides is not shown where something else is"


@pytest.mark.parametrize(("bits", "collide"), [("0 0", 0), ("1 0", 1), ("0 1", 1), ("2 2", 1)])
def test_what_touches_by_either_bit_collides(tmp_path, bits, collide):
    from apartgen.stages.retrieve.reading import mjcf

    one, other = bits.split()
    (tmp_path / "box.xml").write_text(
        f"""<mujoco><worldbody><body name="box"><geom type="box" size=".2 .3 .4"/>
        <geom type="box" pos="1 0 0" size=".1 .1 .1" contype="{one}" conaffinity="{other}"/>
        </body></worldbody></mujoco>""")
    document = mjcf.document(tmp_path / "box.xml", tmp_path)
    (body,) = mjcf.bodies(document, mjcf.top_bodies(document)[0])
    assert len(body.colliders) == 1 + collide


def test_mjcf_agrees_with_mujoco(tmp_path):
    mujoco = pytest.importorskip("mujoco")
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "slab.stl").write_bytes(stl((0, -0.02, -0.4), (0.4, 0.02, 0.4)))
    (tmp_path / "parts" / "assets.xml").write_text(
        '<mujocoinclude><asset><mesh name="slab" file="parts/slab.stl"/></asset></mujocoinclude>'
    )
    (tmp_path / "cupboard.xml").write_text(MJCF)
    from apartgen.stages.retrieve.reading import mjcf

    document = mjcf.document(tmp_path / "cupboard.xml", tmp_path)
    bodies = mjcf.bodies(document, mjcf.top_bodies(document)[0])
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "cupboard.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert np.allclose(np.array([1, 2, 3]) + bodies[1].motion.origin, data.xanchor[0])
    assert np.allclose(bodies[1].motion.axis, data.xaxis[0])
    assert np.allclose(bodies[1].motion.range, model.jnt_range[0])
    centers = sorted((np.array([1, 2, 3]) + c.center).round(6).tolist() for b in bodies for c in b.colliders)
    hits = [i for i in range(model.ngeom) if model.geom_group[i] == 4]
    assert np.allclose(centers, sorted(data.geom_xpos[i].round(6).tolist() for i in hits), atol=1e-5)


def test_sdf_poses_limits_and_model_addresses(tmp_path):
    (tmp_path / "bin" / "meshes").mkdir(parents=True)
    (tmp_path / "bin" / "meshes" / "lid.stl").write_bytes(stl((-0.1, -0.15, 0), (0.1, 0.15, 0.02)))
    (tmp_path / "bin" / "model.sdf").write_text("""<sdf version="1.7"><model name="pedal_bin">
    <link name="body"><pose>0 0 0.2 0 0 0</pose><inertial><mass>2</mass></inertial>
      <visual name="v"><geometry><box><size>0.2 0.3 0.4</size></box></geometry>
        <material><diffuse>0.1 0.2 0.3 1</diffuse></material></visual>
      <collision name="c"><geometry><box><size>0.2 0.3 0.4</size></box></geometry></collision></link>
    <link name="lid"><pose relative_to="body">0 0 0.2 0 0 0</pose>
      <visual name="v"><geometry><mesh><uri>model://bin/meshes/lid.stl</uri></mesh></geometry></visual></link>
    <joint name="lid_hinge" type="revolute"><parent>body</parent><child>lid</child><pose>-0.1 0 0 0 0 0</pose>
      <axis><xyz>0 -1 0</xyz><limit><lower>0</lower><upper>1.2</upper></limit></axis></joint>
    </model></sdf>""")
    asset = loaded(simobjects.assets(tmp_path, front="x"))["bin/model"]
    assert asset.category == "bin" and np.allclose(asset.size, (0.2, 0.3, 0.42))
    (joint,) = asset.joints
    assert joint.part == "hinge_lid" and np.allclose(joint.origin, (-0.1, 0, 0.19)) and joint.axis == (0.0, -1.0, 0.0)
    assert asset.links[0].mass == 2


# Sweet Home 3D

CATALOGUE = """# a comment
id=MyLib#1
name=My furniture
license=CC-BY 3.0
provider=Somebody
id#1=me#chair
name#1=Dining chair caf\\u00e9
category#1=Living room
model#1=/me/chair.obj
width#1=45.0
depth#1 = 50
height#1:90
movable#1=true
creator#1=J. Doe
license#1=CC0
name#2=Big \\
   sofa
model#2=me/sofa.zip
multiPartModel#2=true
width#2=200
depth#2=90
height#2=80
modelRotation#2=0 0 1 0 1 0 -1 0 0
name#3=No model
width#3=10
depth#3=10
height#3=10
"""


@pytest.fixture
def sh3f(tmp_path: Path) -> Path:
    inner = tmp_path / "sofa.zip"
    with zipfile.ZipFile(inner, "w") as archive:
        archive.writestr("sofa/model.obj", obj((0, 0, 0), (9, 8, 20)))
        archive.writestr("sofa/model.mtl", "newmtl m\nKd 0.2 0.4 0.6\n")
    path = tmp_path / "mylib.sh3f"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("PluginFurnitureCatalog.properties", CATALOGUE.encode("latin-1"))
        archive.writestr("me/chair.obj", obj((0, 0, 0), (4.5, 9, 5)))
        archive.write(inner, "me/sofa.zip")
    inner.unlink()
    return path


def test_sweethome3d_dimensions_rotation_licence_and_author(sh3f):
    sources = {source.id: source for source in sweethome3d.assets(sh3f)}
    chair, sofa = sources["mylib/me#chair"].load(), sources["mylib/Big sofa"].load()
    assert chair.category == "chair" and np.allclose(chair.size, (0.5, 0.45, 0.9))
    assert chair.credit == "Dining chair café · J. Doe · CC0 · Sweet Home 3D library mylib"
    assert sofa.category == "sofa" and np.allclose(sofa.size, (0.9, 2.0, 0.8))
    assert "Somebody" in sofa.credit and "CC-BY 3.0" in sofa.credit
    assert np.allclose(sofa.links[0].visuals[0].material.color[:3], (0.2, 0.4, 0.6))
    with pytest.raises(Broken, match="names no model"):
        sources["mylib/No model"].load()


# Collision pieces


def ball(n: int, size=(1.0, 1.0, 1.0)):
    """A fine ellipsoid."""
    from apartgen.stages.retrieve.reading.pieces import Piece

    u, v = np.meshgrid(np.linspace(0, np.pi, n), np.linspace(0, 2 * np.pi, 2 * n), indexing="ij")
    points = np.stack([np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)], -1).reshape(-1, 3) * np.array(size) / 2
    i = np.arange(len(points)).reshape(n, 2 * n)
    a, b, c, d = (part.ravel() for part in (i[:-1, :-1], i[1:, :-1], i[1:, 1:], i[:-1, 1:]))
    return Piece(points, np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))


@pytest.mark.parametrize("size", [(1.0, 1.0, 1.0), (1.8, 0.6, 0.3)])
def test_a_fine_mesh_gets_a_small_hull_that_stays_within_five_millimetres(size):
    from scipy.spatial import ConvexHull

    from apartgen.stages.retrieve.reading import convex

    piece = ball(60, size)
    (hull,) = convex.colliders([piece])
    assert hull.kind == "hull" and len(hull.vertices) <= convex.CORNERS + 6
    planes = ConvexHull(hull.vertices + hull.center).equations
    outside = (piece.vertices @ planes[:, :3].T + planes[:, 3]).max(1)
    assert outside.max() < 0.0055


def test_colliders_of_a_very_fine_mesh_need_little_memory():
    import tracemalloc

    from apartgen.stages.retrieve.reading import convex

    piece = ball(70)
    tracemalloc.start()
    convex.colliders([piece])
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200 * 2**20


@pytest.mark.parametrize("flat", [0, 1, 2])
def test_a_flat_thing_collides_as_a_box_that_is_a_little_thick(flat):
    from apartgen.stages.retrieve.reading import convex

    size = np.insert(np.array([0.4, 0.6]), flat, 0.0)
    points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * size
    found = convex.hull(np.unique(points, axis=0))
    assert found.kind == "box" and np.allclose(found.center, size / 2)
    assert np.allclose(found.size, np.insert(np.array([0.4, 0.6]), flat, convex.THIN))


@pytest.mark.parametrize("shape", [(4, 5, 3), (1, 6, 6), (3, 1, 7)])
def test_filled_cells_are_covered_once_each_and_nothing_else(shape):
    from apartgen.stages.retrieve.reading import convex

    full = np.random.default_rng(sum(shape)).random(shape) < 0.6
    times = np.zeros(shape, int)
    for start, stop in convex._runs(full):
        times[tuple(slice(a, b) for a, b in zip(start, stop, strict=True))] += 1
    assert np.array_equal(times > 0, full)
    starts = [tuple(int(i) for i in start) for start, _ in convex._runs(full)]
    assert len(set(starts)) == len(starts) < full.sum(), "no cell begins two, and some hold several"
    assert convex._runs(np.ones(shape, bool))[0][1].tolist() == list(shape)


@pytest.mark.parametrize("corner", [-1, 3])
def test_faces_of_corners_that_are_not_there_are_told(corner):
    from apartgen.stages.retrieve.reading.pieces import Piece, sound

    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    assert len(sound(Piece(points, np.array([[0, 1, 2]])), "x").faces) == 1
    with pytest.raises(Broken, match="vertices that do not exist"):
        sound(Piece(points, np.array([[0, 1, corner]])), "x")
