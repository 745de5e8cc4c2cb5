"""Labels against an independent ray cast in double precision, files against one another, cameras against the floor."""

import json
import re

import numpy as np
import pytest
import shapely
from export import sample
from PIL import Image

from apartgen.stages import render, seeds
from apartgen.stages.render import coco, route, stands
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world
from apartgen.stages.space import polygons

SMALL = {"width": 80, "height": 60, "views": 3, "frames": 5, "points": 500}


def run(out, **settings):
    config = RenderConfig(**(SMALL | settings))
    return render.run(sample.home(), config, seeds.drawn(1, "test"), out, sample.load)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    out = tmp_path_factory.mktemp("views") / "views"
    return out, run(out)


def image(out, view, part):
    return np.asarray(Image.open(out / f"{view.name}.{part}.png"))


@pytest.fixture(scope="module")
def triangles():
    """Corners (n, 3, 3) and number of the thing of each, doors open: places are worked out here, link by link."""
    parts, owners = [], []
    for number, body in enumerate(Scene(sample.home(), sample.load).bodies, 1):
        c, s = np.cos(body.yaw), np.sin(body.yaw)
        for link in body.links:
            for mesh in link.visuals:
                points = mesh.vertices.copy()
                if link.joint is not None and body.kind == "door" and body.category == "door":
                    arm = points - link.joint.origin
                    way = link.joint.axis[2]
                    points = np.stack([-way * arm[:, 1], way * arm[:, 0], arm[:, 2]], -1) + link.joint.origin
                points = np.stack([c * points[:, 0] - s * points[:, 1], s * points[:, 0] + c * points[:, 1],
                                   points[:, 2]], -1) + body.position
                parts.append(points[mesh.faces])
                owners.append(np.full(len(mesh.faces), number))
    return np.concatenate(parts), np.concatenate(owners)


def rays(view):
    """Origin and unnormalised directions (rows, columns, 3) with one metre of depth each, by the written camera."""
    pose = np.array(view.pose)
    u, v = np.meshgrid(np.arange(view.width) + 0.5, np.arange(view.height) + 0.5)
    if view.intrinsics is None:
        yaw, pitch = np.pi - 2 * np.pi * u / view.width, np.pi / 2 - np.pi * v / view.height
        return pose[:3, 3], np.stack([np.cos(pitch) * np.cos(yaw), np.cos(pitch) * np.sin(yaw), np.sin(pitch)], -1)
    fx, fy, cx, cy = view.intrinsics
    camera = np.stack([(u - cx) / fx, (v - cy) / fy, np.ones_like(u)], -1)
    return pose[:3, 3], camera @ pose[:3, :3].T


def cast(origin, directions, corners):
    """Nearest hit of each ray in plain double precision (Möller–Trumbore): multiple of the direction, triangle."""
    best, which = np.full(len(directions), np.inf), np.full(len(directions), -1)
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    t = origin - corners[:, 0]
    q = np.cross(t, a)
    for k, way in enumerate(directions):
        p = np.cross(way, b)
        det = np.einsum("nd,nd->n", a, p)
        with np.errstate(divide="ignore", invalid="ignore"):
            u, v = np.einsum("nd,nd->n", t, p) / det, q @ way / det
            far = np.einsum("nd,nd->n", b, q) / det
        hit = (np.abs(det) > 1e-14) & (u >= 0) & (v >= 0) & (u + v <= 1) & (far > 0)
        if hit.any():
            i = int(np.argmin(np.where(hit, far, np.inf)))
            best[k], which[k] = far[i], i
    return best, which


def off_the_mesh(points, corners):
    """Distance of points from the nearest of some triangles; all pairs."""
    from trimesh import triangles as exact

    found = []
    for point in points:
        near = exact.closest_point(corners, np.broadcast_to(point, (len(corners), 3)))
        found.append(np.linalg.norm(near - point, axis=1).min())
    return np.array(found)


def test_every_kind_of_view_is_there(made):
    _, found = made
    kinds = {view.kind for view in found.views}
    assert kinds == {"eye", "panorama", "above", "route"}
    assert {view.room for view in found.views if view.kind == "panorama"} == set(sample.ROOMS)


@pytest.mark.parametrize("size", [(160, 60), (60, 160)])
def test_the_view_from_above_shows_the_whole_home_and_half_a_metre_of_ground(tmp_path, size):
    home = sample.home()
    (view,) = run(tmp_path / "above", kind=["above"], width=size[0], height=size[1]).views
    x0, y0, x1, y1 = polygons.shell(home).bounds
    origin, ways = rays(view)
    floor = (origin + ways * (origin[2] - home.height)).reshape(-1, 3)
    lo, hi = floor.min(0), floor.max(0)
    pixel = (hi[0] - lo[0]) / (view.width - 1)
    around = np.array([x0 - lo[0], hi[0] - x1, y0 - lo[1], hi[1] - y1]) + pixel / 2
    assert around.min() == pytest.approx(0.5, abs=pixel / 4)


def test_depth_leads_back_to_the_mesh(made, triangles):
    out, found = made
    rng = np.random.default_rng(0)
    for view in [found.views[0], *(v for v in found.views if v.kind in ("panorama", "above"))][:4]:
        depth = image(out, view, "depth") / 1000
        origin, ways = rays(view)
        rows, columns = np.nonzero(depth)
        some = rng.choice(len(rows), 60, replace=False)
        points = origin + ways[rows[some], columns[some]] * depth[rows[some], columns[some], None]
        assert off_the_mesh(points, triangles[0]).max() < 1e-3


def test_instances_are_those_of_an_independent_cast(made, triangles):
    out, found = made
    corners, owners = triangles
    view = next(view for view in found.views if view.kind == "eye")
    origin, ways = rays(view)
    far, which = cast(origin, ways.reshape(-1, 3), corners)
    number = np.where(which >= 0, owners[which], 0)
    instance = image(out, view, "instance").ravel()
    expected, got = (np.bincount(a, minlength=len(found.instances) + 1) for a in (number, instance))
    assert (np.abs(expected - got) <= np.maximum(3, 0.005 * expected)).all()
    same = number == instance
    depth = image(out, view, "depth").ravel() / 1000
    assert np.abs(depth - far)[same & (which >= 0)].max() < 1e-3


def test_normals_are_unit_and_face_the_camera(made):
    out, found = made
    for view in found.views[:3]:
        depth, normal = image(out, view, "depth"), image(out, view, "normal") / 127.5 - 1
        _, ways = rays(view)
        seen = depth > 0
        assert np.abs(np.linalg.norm(normal[seen], axis=1) - 1).max() < 0.02
        assert (np.einsum("nd,nd->n", normal[seen], ways[seen]) < 0.02).all()


def test_what_is_said_to_be_visible_is_what_the_pictures_show(made):
    out, found = made
    label = {thing.number: thing.label for thing in found.instances}
    for view in found.views:
        instance, semantic = image(out, view, "instance"), image(out, view, "semantic")
        assert {part.number for part in view.visible} == set(np.unique(instance)) - {0}
        for part in view.visible:
            rows, columns = np.nonzero(instance == part.number)
            assert part.pixels == len(rows) and (semantic[rows, columns] == label[part.number]).all()
            x, y, w, h = part.rectangle
            assert (x, y, x + w - 1, y + h - 1) == (columns.min(), rows.min(), columns.max(), rows.max())
            u, v, steps = part.inmost
            about = instance[v - steps + 1:v + steps, u - steps + 1:u + steps]
            assert about.shape == (2 * steps - 1,) * 2 and (about == part.number).all()


def test_eye_views_show_things(made):
    _, found = made
    objects = {thing.number for thing in found.instances if thing.box}
    eyes = [view for view in found.views if view.kind == "eye"]
    many = [sum(part.number in objects and part.pixels > 0.01 * view.width * view.height for part in view.visible)
            for view in eyes]
    assert eyes and min(many) >= 5


def test_the_same_seed_gives_the_same_bytes(made, tmp_path):
    out, _ = made
    run(tmp_path / "again", kind=["eye", "above"])
    for file in (tmp_path / "again").glob("*.png"):
        assert file.read_bytes() == (out / file.name).read_bytes()


def test_pictures_are_neither_dark_nor_white(made):
    out, found = made
    for view in found.views:
        light = image(out, view, "rgb") @ [0.21, 0.72, 0.07]
        assert 70 < light.mean() < 235 and (light > 252).mean() < 0.35


def decoded(text, rows, columns):
    """A mask from COCO's text: five bits a character, each run but the first two less the one before the last."""
    values, k = [], 0
    while k < len(text):
        value, shift, more = 0, 0, True
        while more:
            code = ord(text[k]) - 48
            value |= (code & 31) << shift
            more, shift, k = bool(code & 32), shift + 5, k + 1
            if not more and code & 16:
                value -= 1 << shift
        values.append(value + (values[-2] if len(values) > 2 else 0))
    flat = np.repeat(np.arange(len(values)) % 2, values)
    return flat.reshape(columns, rows).T.astype(bool)


def test_coco_masks_are_the_instances(made):
    out, found = made
    whole = json.loads((out / "coco.json").read_text())
    numbers = {thing.id: thing.number for thing in found.instances}
    assert [one["file_name"] for one in whole["images"]] == [f"{view.name}.rgb.png" for view in found.views]
    for one in whole["annotations"]:
        view = found.views[one["image_id"] - 1]
        mask = decoded(one["segmentation"]["counts"], view.height, view.width)
        assert (mask == (image(out, view, "instance") == numbers[one["instance"]])).all()
        assert one["area"] == mask.sum()


@pytest.mark.parametrize("seed", range(20))
def test_masks_of_any_shape_come_back(seed):
    rng = np.random.default_rng(seed)
    mask = rng.random((rng.integers(1, 90), rng.integers(1, 70))) < rng.random()
    assert (decoded(coco.compressed(mask), *mask.shape) == mask).all()


def test_the_layout_text_tells_of_all_walls_openings_and_boxes(made):
    out, _ = made
    home = sample.home()
    rows = dict(row.split("=", 1) for row in (out / "layout.txt").read_text().splitlines())
    walls = {name: [float(v) for v in re.findall(r"[-\d.]+", row)] for name, row in rows.items() if "Wall(" in row}
    assert len(walls) == sum(len(room.polygon) for room in home.rooms)
    floors = shapely.unary_union([polygons.floor(room).exterior for room in home.rooms])
    for ax, ay, az, bx, by, bz, height, thick in walls.values():
        assert floors.buffer(1e-3).covers(shapely.LineString([(ax, ay), (bx, by)]))
        assert (az, bz, height, thick) == (0, 0, home.height, 0)
    holes = [row for row in rows.values() if row.startswith(("Door", "Window"))]
    assert len(holes) == len(home.openings)
    outlines = {room.id: polygons.floor(room).exterior for room in home.rooms}
    for row, o in zip(holes, sorted(home.openings, key=lambda o: o.kind == "window")):
        wall, *values = row[row.index("(") + 1 : -1].split(",")
        x, y, _, width, _ = map(float, values)
        middle = np.mean(o.segment, axis=0)
        off = outlines[o.into or o.rooms[0]].distance(shapely.Point(middle))
        assert np.hypot(*(middle - (x, y))) == pytest.approx(off, abs=1e-3), "on the wall that is nearest"
        ax, ay, _, bx, by, *_ = walls[wall]
        side = shapely.LineString([(ax, ay), (bx, by)])
        assert side.distance(shapely.Point(x, y)) < 1e-3 and width <= side.length + 1e-3
    boxes = [row for row in rows.values() if row.startswith("Bbox")]
    assert [row[5:].split(",")[0] for row in boxes] == [o.category for o in home.objects]


def test_points_lie_on_the_mesh(made, triangles):
    out, found = made
    head, _, data = (out / "points.ply").read_bytes().partition(b"end_header\n")
    kind = np.dtype([("place", "<f4", 3), ("color", "u1", 3), ("instance", "<u2")])
    points = np.frombuffer(data, kind)
    assert f"element vertex {len(points)}".encode() in head and len(points) > 0.9 * SMALL["points"]
    corners, owners = triangles
    for point in points[::12]:
        own = corners[owners == point["instance"]]
        assert off_the_mesh([point["place"].astype(float)], own)[0] < 1e-3


@pytest.fixture(scope="module")
def looked_at():
    return world(Scene(sample.home(), sample.load))


def test_cameras_stand_on_free_floor(looked_at):
    space, cells = stands.free_floor(looked_at)
    size = (64, 48)
    eyes = stands.best(looked_at, 5, 1.5, np.radians(80), size)
    for stand in [*eyes, *route.along(looked_at, 9, 1.2)]:
        row = int(np.argmin(np.abs(space.grid.y - stand.place[1])))
        column = int(np.argmin(np.abs(space.grid.x - stand.place[0])))
        assert cells[max(0, row - 2) : row + 3, max(0, column - 2) : column + 3].any()


def test_the_route_goes_through_all_rooms_at_even_steps(looked_at):
    way = route.along(looked_at, 400, 1.2)
    assert {stand.room for stand in way if stand.room >= 0} == set(range(len(looked_at.plan.rooms)))
    places = np.array([stand.place for stand in way])
    steps = np.linalg.norm(np.diff(places, axis=0), axis=1)
    assert steps.max() < 1.5 * np.median(steps) + 1e-6


def test_edges_from_above_are_as_smooth_as_of_nine_times_the_pixels():
    from dataclasses import replace

    from apartgen.stages.export import view
    from apartgen.stages.export._lowered import lowered
    from apartgen.stages.scene.camera import Camera
    from apartgen.stages.scene.picture import taken
    from apartgen.stages.scene.soup import soup
    from apartgen.stages.scene.world import ground, open_air

    bodies = lowered(Scene(sample.home(), sample.load).bodies)
    corners = soup(bodies).corners.reshape(-1, 3)
    outside = open_air(bodies, ground(corners.mean(0), view.GROUND, view.GRASS))
    camera = Camera.at(corners, 40_000, view.AZIMUTH, view.ELEVATION)
    one = taken(outside, camera).astype(float)
    fine = taken(outside, replace(camera, rows=3 * camera.rows, columns=3 * camera.columns)) / 255
    light = np.where(fine <= 0.04045, fine / 12.92, ((fine + 0.055) / 1.055) ** 2.4)
    mean = light.reshape(camera.rows, 3, camera.columns, 3, 3).mean((1, 3))
    wanted = 255 * np.where(mean <= 0.0031308, 12.92 * mean, 1.055 * mean ** (1 / 2.4) - 0.055)
    assert (np.abs(one - wanted).max(-1) > 32).mean() < 0.02
    corner = one[:8, :8].reshape(-1, 3)
    assert corner.mean(0)[1] > corner.mean(0)[2] and corner.std(0).max() < 20, "the ground about it is even and green"
