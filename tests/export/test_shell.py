"""The building: walls cut where openings are, solids closed, doors that turn, nothing left out."""

import handmade as h
import numpy as np
import pytest
import trimesh
from export import sample
from shapely.geometry import Point, box

from apartgen.stages.scene import shell
from apartgen.stages.scene.scene import Scene, identifier
from apartgen.stages.space import polygons
from apartgen.stages.things import materials, solids
from apartgen.stages.things.body import inertia
from apartgen.stages.things.materials import PALETTE


@pytest.fixture(scope="module")
def bodies():
    return {body.name: body for body in shell.bodies(sample.plan())}


def _volume(mesh):
    solid = trimesh.Trimesh(mesh.vertices, mesh.faces)
    solid.merge_vertices()
    assert solid.is_watertight and solid.is_winding_consistent
    return solid.volume


@pytest.mark.parametrize("area", [
    box(0, 0, 4, 3).difference(box(0.2, 0.2, 3.8, 2.8)).difference(box(1, -1, 1.8, 1)),
    box(0, 0, 4, 3).difference(box(1, 1, 2, 2)), Point(0, 0).buffer(1), box(0, 0, 1, 1).union(box(2, 0, 3, 1)),
])
def test_prisms_are_closed_and_their_colliders_fill_them(area):
    mesh = solids.extruded(area, 0.5, 2.5, PALETTE["plaster"])
    assert _volume(mesh) == pytest.approx(2 * area.area)
    filled = sum(c.size.prod() if c.kind == "box" else trimesh.convex.convex_hull(c.vertices).volume
                 for c in solids.convex(area, 0.5, 2.5))
    assert filled == pytest.approx(2 * area.area, rel=1e-5)


def test_a_rod_of_what_has_a_texture_says_where_it_is():
    """As programs that read OBJ warn of a texture without coordinates; they run on round the rod without a jump."""
    rod, plain = (solids.cylinder([0, 0, 0], [0, 0, 0.1], 0.02, PALETTE[name]) for name in ("steel", "black_metal"))
    assert PALETTE["steel"].texture and not PALETTE["black_metal"].texture and plain.uv is None
    metres = rod.uv * materials.span("steel")
    assert np.ptp(metres, axis=0) == pytest.approx([0.02 * np.pi, 0.1])
    edges = np.concatenate([rod.faces[:, [0, 1]], rod.faces[:, [1, 2]]])
    far = np.linalg.norm(np.diff(rod.vertices[edges], axis=1)[:, 0], axis=1)
    assert (np.linalg.norm(np.diff(metres[edges], axis=1)[:, 0], axis=1) < 3.2 * far).all()


def test_every_visual_of_the_shell_is_closed(bodies):
    for body in bodies.values():
        for link in body.links:
            for mesh in link.visuals:
                if mesh.material.name != "joinery_paint":
                    assert _volume(mesh) > 0


def test_what_only_shows_is_left_out_and_nothing_else(bodies):
    bare = {body.name: body for body in Scene(sample.home(), sample.load, shown=False).bodies}
    full = {body.name: body for body in Scene(sample.home(), sample.load).bodies}
    assert set(bare) >= {n for n, body in full.items() if body.kind in ("door", "object") or body.links[0].colliders}
    for name, body in bare.items():
        for link, whole in zip(body.links, full[name].links, strict=True):
            assert (link.joint, link.mass, link.friction) == (whole.joint, whole.mass, whole.friction)
            assert not link.visuals or not link.colliders
            for mine, other in zip(link.colliders, whole.colliders, strict=True):
                assert mine.kind == other.kind
                assert (mine.center == other.center).all() and (mine.size == other.size).all()


def _wall_depth(walls, x, y, z):
    """Whether a point is in any collider of the walls."""
    return any(np.all(np.abs(np.array([x, y, z]) - c.center) <= c.size / 2 + 1e-9) for c in walls)


def test_walls_are_solid_but_where_openings_are(bodies):
    plan = sample.plan()
    walls = bodies["walls"].links[0].colliders
    for opening in plan.openings:
        middle = np.mean(opening.segment, axis=0)
        inside = (opening.sill + opening.head) / 2
        assert not _wall_depth(walls, *middle, inside), opening.id
        assert _wall_depth(walls, *middle, opening.head + 0.05), opening.id
        assert _wall_depth(walls, *middle, opening.sill - 0.05) == (opening.sill > 0), opening.id
        beside = np.array(opening.segment[0]) - 0.1 * polygons.along(opening)
        assert _wall_depth(walls, *beside, inside), opening.id
    for room in plan.rooms:
        assert not _wall_depth(walls, *polygons.floor(room).centroid.coords[0], 1.0)


def test_walls_fill_what_is_not_room_or_opening(bodies):
    plan = sample.plan()
    volume = sum(c.size.prod() for c in bodies["walls"].links[0].colliders)
    solid = polygons.shell(plan).area - sum(f.area for f in polygons.floors(plan).values())
    holes = sum(polygons.width(o) * (0.3 if len(o.rooms) == 1 else 0.1) * (o.head - o.sill) for o in plan.openings)
    assert volume == pytest.approx(solid * plan.height - holes, rel=1e-6)


def test_each_room_has_floor_ceiling_and_lining(bodies):
    for room in sample.ROOMS:
        for part in ("floor", "ceiling", "lining"):
            assert bodies[f"{part}_{room}"].room == room
    assert "skirting_bathroom_1" not in bodies


def test_a_leaf_opens_where_the_plan_says(bodies):
    """Shut it fills the doorway; open it lies on the plan's own opened leaf."""
    plan = sample.plan()
    for opening in plan.openings:
        if opening.into is None:
            continue
        body = next(b for b in bodies.values() if b.id == opening.id)
        joint = body.links[1].joint
        corners = body.links[1].colliders[0]
        points = corners.center + (np.array(np.meshgrid(*[[-0.5, 0.5]] * 3)).reshape(3, -1).T * corners.size)
        for angle in (0.0, np.pi / 2):
            axis, origin = np.array(joint.axis), np.array(joint.origin)
            turn = trimesh.transformations.rotation_matrix(angle, axis, origin)
            world = trimesh.transform_points(trimesh.transform_points(points, turn), body.pose())
            there = polygons.leaf(opening, plan, angle)
            assert max(there.distance(Point(p[:2])) for p in world) < 1e-6
            assert there.area == pytest.approx(Point(0, 0).buffer(0).union(there).area)
        assert joint.range == (0.0, pytest.approx(np.pi / 2))


def test_the_floor_is_level_everywhere_one_walks(bodies):
    ground = bodies["ground"].links[0].colliders
    assert len(ground) == 1
    lo, hi = ground[0].center - ground[0].size / 2, ground[0].center + ground[0].size / 2
    assert hi[2] == pytest.approx(0.0)
    assert box(lo[0], lo[1], hi[0], hi[1]).buffer(1e-9).covers(polygons.free_floor(sample.plan()))


def test_a_balcony_has_a_parapet_and_no_ceiling():
    plan = sample.plan()
    plan.rooms[0].type = "balcony"
    made = {body.name: body for body in shell.bodies(plan)}
    assert "ceiling_living_room_1" not in made
    walls = made["walls"].links[0].colliders
    assert not _wall_depth(walls, 2.6, -0.03, 2.0) and _wall_depth(walls, -0.03, 2.0, 1.0)
    assert not _wall_depth(walls, -0.03, 2.0, 1.2), "the parapet ends at 1.1 m"
    assert not _wall_depth(walls, -0.15, 2.0, 1.0), "a railing is no wall"
    assert _wall_depth(walls, 7.0, -0.15, 2.4) and _wall_depth(walls, 5.25, 2.0, 2.0)


def test_names_are_unique_identifiers():
    names = [body.name for body in Scene(sample.home(), sample.load).bodies]
    assert len(set(names)) == len(names)
    assert all(name.isidentifier() and name.isascii() for name in names)
    assert identifier("2nd chair/é") == "n2nd_chair__"


def test_mass_properties_agree_with_an_independent_computation():
    """A hull in the shape of a box has the box's inertia; trimesh agrees on a skew hull."""
    from apartgen.stages.things.asset import Collider, Link

    rng = np.random.default_rng(3)
    points = rng.normal(size=(14, 3)) * [0.3, 0.5, 0.2]
    got = inertia(Link("x", [], [Collider("hull", np.array([1.0, 2, 3]), np.ones(3), vertices=points)], 5.0))
    hull = trimesh.convex.convex_hull(points)
    hull.density = 5.0 / hull.volume
    assert got.center == pytest.approx(hull.center_mass + [1, 2, 3])
    assert got.tensor == pytest.approx(hull.moment_inertia, abs=1e-3)


def test_what_hangs_is_fixed_and_what_stands_is_loose():
    home = sample.home()
    free = {body.id: body.free for body in Scene(home, sample.load).bodies}
    assert free["tv_5"] and free["chair_7"] and free["bin_12"]
    assert not free["sofa_1"] and not free["ceiling_lamp_8"] and not free["wall_lamp_14"]
    tv = next(o for o in home.objects if o.id == "tv_5")
    tv.center = (tv.center[0], tv.center[1], 1.4)
    assert not {body.id: body.free for body in Scene(home, sample.load).bodies}["tv_5"]


def test_what_stands_in_something_is_fixed():
    """A chair moved into the coffee table is not loose; one beside it, even by a hair, is."""
    home = sample.home()
    table, chair = (next(o for o in home.objects if o.id == id) for id in ("coffee_table_3", "chair_7"))
    beside = table.center[0] + (table.size[0] + chair.size[0]) / 2
    for x, free in ((beside + 0.001, True), (beside - 0.0005, True), (beside - 0.002, False), (beside - 0.03, False)):
        chair.center = (x, table.center[1], chair.center[2])
        assert {body.id: body.free for body in Scene(home, sample.load).bodies}["chair_7"] is free
    chair.center = (1.6, 3.4, chair.center[2])
    assert {body.id: body.free for body in Scene(home, sample.load).bodies}["chair_7"]


def test_a_door_belongs_to_the_room_it_opens_into_and_a_window_to_its_only_one():
    plan = h.plan()
    of = {o.id: shell._opening(plan, o, False).room for o in plan.openings}
    assert of == {"entrance_1": h.LIVING, "door_1": h.BEDROOM, "window_1": h.BEDROOM}
