"""Every category and style at many sizes: the box is met, shapes are closed, open parts stay where they may."""

from types import SimpleNamespace

import numpy as np
import pytest
import shapely
import trimesh

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve import furniture, parametric
from apartgen.stages.retrieve.furniture import sofas
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.space import sweeps
from apartgen.stages.things import body, categories

LARGE = (
    "double_bed",
    "single_bed",
    "wardrobe",
    "sliding_wardrobe",
    "chest",
    "sofa",
    "corner_sofa",
    "armchair",
    "dining_table",
    "round_table",
    "coffee_table",
    "chair",
    "office_chair",
    "bookshelf",
    "kitchen_base",
    "kitchen_drawers",
    "wall_unit",
    "sideboard",
    "desk",
    "tv_stand",
    "floor_lamp",
    "table_lamp",
    "ceiling_lamp",
    "plant",
    "rug",
    "vanity",
    "fridge",
)


def sizes(category):
    """The usual size, the extremes, and one in between, in whole millimetres."""
    kind, rng = categories.TABLE[category], np.random.default_rng(len(category))
    drawn = tuple(float(side) for side in rng.uniform(kind.min, kind.max).round(3))
    return [kind.size, kind.min, kind.max, drawn]


def built(category, which=slice(None)):
    return [
        furniture.build(category, style, size, seed)
        for style in furniture.styles(category)
        for seed, size in enumerate(sizes(category)[which])
    ]


def bounds(meshes):
    points = np.concatenate([mesh.vertices for mesh in meshes])
    return points.min(0), points.max(0)


def test_every_category_comes_in_several_styles():
    counts = {name: len(furniture.styles(name)) for name in categories.CATEGORIES}
    assert min(counts.values()) >= 2
    assert not {name: counts[name] for name in LARGE if counts[name] < 4}


@pytest.mark.parametrize("category", categories.TABLE)
def test_the_box_is_met_to_a_millimetre(category):
    for asset in built(category):
        lo, hi = bounds([mesh for link in asset.links for mesh in link.visuals])
        half = np.array(asset.size) / 2
        assert np.abs(np.concatenate([lo + half, hi - half])).max() < 1e-3, asset.id


@pytest.mark.parametrize("category", categories.TABLE)
def test_every_piece_is_closed_and_faces_outward(category):
    for asset in built(category, slice(0, 2)):
        faces = 0
        assert all(c.size.min() > 0 for link in asset.links for c in link.colliders), asset.id
        for mesh in (mesh for link in asset.links for mesh in link.visuals):
            shape = trimesh.Trimesh(mesh.vertices, mesh.faces)
            assert shape.is_watertight and shape.is_winding_consistent and shape.volume > 0, (
                asset.id,
                mesh.material.name,
            )
            assert mesh.uv is not None and mesh.uv.shape == (len(mesh.vertices), 2) and np.isfinite(mesh.uv).all()
            faces += len(mesh.faces)
        assert faces <= 6500, (asset.id, faces)


@pytest.mark.parametrize("category", [c.name for c in categories.TABLE.values() if c.articulated])
def test_open_parts_keep_to_their_reach_and_between_the_sides(category):
    for asset in built(category):
        half = np.array(asset.size) / 2
        reach = float(categories.reach(category, asset.size))
        for joint in asset.joints:
            lo, hi = sweeps.swept(joint)
            assert hi[0] <= half[0] + reach + 1e-3, (asset.id, joint.name)
            assert lo[1] >= -half[1] - 1e-3 and hi[1] <= half[1] + 1e-3, (asset.id, joint.name)
            assert lo[0] >= -half[0] - 1e-3 and lo[2] >= -half[2] - 1e-3, (asset.id, joint.name)


def test_what_opens_opens_in_every_style_and_nothing_else_does():
    for kind in categories.TABLE.values():
        assert all(bool(asset.joints) == kind.articulated for asset in built(kind.name, slice(0, 1))), kind.name


def test_joints_carry_the_extent_and_part_class_of_what_they_move():
    for asset in (asset for name in categories.TABLE for asset in built(name, slice(0, 1))):
        for link in asset.links[1:]:
            lo, hi = bounds(link.visuals)
            assert np.allclose(link.joint.extent, [lo, hi], atol=2e-4)
            assert link.joint.part in {"hinge_door", "slider_drawer", "hinge_lid", "slider_door"}
            assert link.joint.range[0] == 0.0 < link.joint.range[1]
            assert link.grip in {"", "line_fixed_handle", "round_fixed_handle"}
            assert (link.handle >= lo - 0.06).all() and (link.handle <= hi + 0.06).all(), (asset.id, link.name)


@pytest.mark.parametrize("low, high, origin, axis, part", [
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (-0.3, 0, 0.72), (0, -1, 0), "hinge_lid"),
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (0, 0.5, 0.72), (-2, 0, 0), "hinge_lid"),
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (0, 0.5, 0.72), (2, 0, -0.1), "hinge_door"),
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (0, -0.5, 0.72), (2, 0, 0), "hinge_lid"),
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (0.3, 0, 0.72), (0, 1, 0), "hinge_lid"),
    ((-0.3, -0.5, 0.1), (0.3, 0.5, 0.12), (0.3, 0, 0.1), (0, -1, 0), "hinge_door"),
    ((0.28, -0.5, 0.1), (0.3, 0.5, 0.72), (0.3, 0, 0.72), (0, -1, 0), "hinge_door"),
    ((0.28, -0.5, 0.1), (0.3, 0.5, 0.72), (0.3, 0.5, 0), (0, 0, 1), "hinge_door"),
    ((-0.3, -0.5, 0.7), (0.3, 0.5, 0.72), (0.3, 0.5, 0), (0, 0, 1), "hinge_door"),
])
def test_what_lies_flat_and_is_raised_is_a_lid(low, high, origin, axis, part):
    """By whatever edge; a front that goes up is none, nor what lies flat and sinks or swings out level."""
    for given, told in (("", part), ("hinge_knob", "hinge_knob")):
        kit, moved = Kit("chest", "mine", (0.6, 1.0, 0.72), 0), Body()
        moved.box("oak", *zip(low, high))
        kit.base.box("oak", kit.x, kit.y, (0, 0.1))
        kit.hinge("it", moved, origin, axis, **({"part": given} if given else {}))
        assert kit.finish("chest/mine/0").joints[0].part == told


def test_links_weigh_what_furniture_weighs():
    for asset in (asset for name in categories.TABLE for asset in built(name, slice(0, 1))):
        total = sum(link.mass for link in asset.links)
        assert 0.2 < total < 600, (asset.id, total)
        assert all(0.2 < link.mass < 60 for link in asset.links[1:]), asset.id


def test_boards_and_legs_do_not_stretch():
    def thinnest(size):
        asset = furniture.build("wardrobe", "modern", size, 0)
        return sorted({round(float(c.size.min()), 4) for c in asset.links[0].colliders if c.kind == "box"})

    assert thinnest((0.5, 0.8, 1.8)) == thinnest((0.7, 2.9, 2.4))
    small, large = (furniture.build("bench", "upholstered", size, 0) for size in ((0.3, 0.7, 0.45), (0.5, 1.8, 0.45)))
    legs = [sorted(c.size.round(4).tolist() for c in bench.links[0].colliders[1:]) for bench in (small, large)]
    assert len(legs[0]) == 4 and legs[0] == legs[1]


def test_the_same_four_make_the_same_asset_and_its_id_makes_it_again():
    size = categories.TABLE["plant"].size
    first, second = (furniture.build("plant", "fig", size, 5) for _ in range(2))
    again = furniture.load_asset(first.id)
    for other in (second, again):
        assert other.id == first.id == "plant/fig/450x450x1100/5"
        for a, b in zip(first.links[0].visuals, other.links[0].visuals, strict=True):
            assert a.vertices.tobytes() == b.vertices.tobytes() and a.uv.tobytes() == b.uv.tobytes()
    assert furniture.build("plant", "fig", size, 6).links[0].mass != first.links[0].mass


@pytest.mark.parametrize(
    "id",
    [
        "",
        "wardrobe",
        "wardrobe/modern/600x1500/0",
        "wardrobe/gothic/600x1500x2100/0",
        "wardrobe/modern/600x1500x9100/0",
        "castle/modern/1x1x1/0",
    ],
)
def test_an_unknown_id_is_refused_with_what_to_do(id):
    with pytest.raises(BadInput):
        furniture.load_asset(id)


def test_the_library_lists_every_style_once_and_loads_it():
    sources = list(parametric.assets())
    assert (
        len({source.id for source in sources})
        == len(sources)
        == sum(len(furniture.styles(c)) for c in categories.TABLE)
    )
    assert all(source.load().id == source.id for source in sources[::25])


def test_doors_and_windows_of_the_building_come_at_any_size():
    for category, size in (("door", (0.12, 0.82, 2.03)), ("window", (0.12, 2.1, 0.6)), ("window", (0.1, 0.6, 1.9))):
        for style in furniture.styles(category):
            asset = furniture.build(category, style, size, 1)
            lo, hi = bounds(asset.links[0].visuals)
            assert np.allclose(hi - lo, size, atol=1e-3)


def test_wall_units_are_opened_from_below():
    """What hangs over a worktop is gripped in its lower half, in every style and size."""
    for asset in built("wall_unit"):
        doors = [joint for joint in asset.joints if joint.type == "hinge"]
        assert doors
        assert all(joint.origin[2] <= 1e-3 for joint in doors), asset.id


@pytest.mark.parametrize("category", ["plant", "chair", "stool", "floor_lamp", "bin", "pouffe", "table_lamp"])
def test_loose_things_stand_by_themselves(category):
    """The centre of mass lies over what touches the floor, by a centimetre at least, in every style and size."""
    for asset in built(category):
        points = np.concatenate([mesh.vertices for link in asset.links for mesh in link.visuals])
        base = shapely.multipoints(points[points[:, 2] < points[:, 2].min() + 0.003, :2]).convex_hull
        parts = [body.inertia(link) for link in asset.links]
        center = sum(part.mass * part.center for part in parts) / sum(part.mass for part in parts)
        assert base.buffer(-0.01).covers(shapely.points(*center[:2])), asset.id


@pytest.mark.parametrize("category", categories.TABLE)
def test_no_collision_piece_is_flat(category):
    pieces = [(asset.id, c) for asset in built(category) for link in asset.links for c in link.colliders]
    assert not [id for id, c in pieces if c.kind != "hull" and np.min(c.size) < 1e-4]


@pytest.mark.parametrize("tall, shelves", [(0.2, 2), (0.3, 2), (0.6, 3)])
def test_a_set_of_open_boxes_has_two_sides_of_its_height_and_a_board_for_each_level(tall, shelves):
    """Boards of 3 cm, levels of about 30."""
    pieces = np.array([piece.size for link in furniture.build("wall_shelf", "box", (0.2, 0.8, tall), 0).links
                       for piece in link.colliders])
    upright = np.isclose(pieces, [0.2, 0.03, tall]).all(1)
    lying = np.isclose(pieces, [0.199, 0.74, 0.03]).all(1)
    assert (upright.sum(), lying.sum(), len(pieces)) == (2, shelves, 2 + shelves)


@pytest.mark.parametrize("wide", [0.5, 0.9, 1.8])
def test_tufts_cover_a_back_without_gaps(wide):
    drawn = []
    kit = SimpleNamespace(base=SimpleNamespace(pillow=lambda cover, x, y, z, *rest: drawn.append((*y, *z))))
    sofas._tufts(kit, "linen", 0.0, (-wide / 2, wide / 2), (0.4, 0.8))
    tufts = [shapely.box(y0, z0, y1, z1) for y0, y1, z0, z1 in drawn]
    back = shapely.box(-wide / 2, 0.4, wide / 2, 0.8)
    assert shapely.union_all(tufts).symmetric_difference(back).area < 1e-9
    assert sum(one.area for one in tufts) == pytest.approx(back.area), "none lies on another"
