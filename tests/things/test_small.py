"""Small things of every kind: closed, of their box, within the weights of real ones, standing by themselves."""

from dataclasses import replace

import numpy as np
import pytest
import shapely
import trimesh

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve import furniture
from apartgen.stages.things import body, small, solids

SEEDS = 3


def made(name):
    """Assets of some designs of a kind, laid down too where it may lie."""
    rng = np.random.default_rng(5)
    designs = [small.drawn(small.TABLE[name], rng) for _ in range(SEEDS)]
    lying = (False, True) if small.TABLE[name].rests else (False,)
    return [(design, furniture.load_asset(design.id(laid))) for design in designs for laid in lying]


def test_there_are_many_kinds():
    assert len(small.TABLE) >= 60


def test_what_is_deeper_than_wide_in_its_least_or_its_greatest_size_is_not_round():
    mug = next(kind for kind in small.TABLE.values() if kind.round)
    least, most = mug.min, mug.max
    assert not replace(mug, max=(most[0] * 1.1, *most[1:])).round
    assert not replace(mug, min=(least[0] * 0.9, *least[1:])).round


@pytest.mark.parametrize("name", small.TABLE)
def test_a_kind_comes_in_six_designs_and_more(name):
    looks = set()
    for style in small.TABLE[name].styles:
        for seed in range(0, 12, 2):
            size = small.TABLE[name].max
            asset = furniture.build(name, style, size, seed)
            looks.add((style, *(mesh.material.name for mesh in asset.links[0].visuals)))
    sides = {design.size for design, _ in made(name)}
    assert len(looks) * len(sides) >= 6 and len(sides) >= 2


@pytest.mark.parametrize("name", small.TABLE)
def test_shapes_are_closed_fill_their_box_and_collide_within_it(name):
    for _, asset in made(name):
        (link,) = asset.links
        half = np.array(asset.size) / 2
        points = np.concatenate([mesh.vertices for mesh in link.visuals])
        assert np.abs(np.concatenate([points.min(0) + half, points.max(0) - half])).max() < 1e-3, asset.id
        for mesh in link.visuals:
            shape = trimesh.Trimesh(mesh.vertices, mesh.faces)
            assert shape.is_watertight and shape.is_winding_consistent and shape.volume > 0, asset.id
        felt = np.concatenate([solids.corners(piece) for piece in link.colliders])
        assert (np.abs(felt) <= half + 2e-3).all(), asset.id
        assert felt[:, 2].min() == pytest.approx(-half[2], abs=1e-6), asset.id
        assert {piece.kind for piece in link.colliders} <= {"box", "cylinder"}


@pytest.mark.parametrize("name", small.TABLE)
def test_weights_are_those_of_real_ones_and_denser_than_foam(name):
    kind = small.TABLE[name]
    for _, asset in made(name):
        (link,) = asset.links
        assert kind.mass[0] - 1e-3 <= link.mass <= kind.mass[1] + 1e-3
        shadow = float(np.prod(asset.size))
        assert 5 < link.mass / shadow < 3500, (asset.id, link.mass / shadow)
        assert link.friction == kind.friction


@pytest.mark.parametrize("name", [name for name, kind in small.TABLE.items() if not kind.fixed])
def test_what_is_not_hung_stands_by_itself(name):
    for _, asset in made(name):
        (link,) = asset.links
        felt = [solids.corners(piece) for piece in link.colliders]
        low = min(points[:, 2].min() for points in felt)
        foot = np.concatenate([points[points[:, 2] < low + 1e-4][:, :2] for points in felt])
        center = body.inertia(link).center
        inside = shapely.MultiPoint(foot).convex_hull.buffer(-0.002)
        assert inside.contains(shapely.Point(center[:2])), asset.id


def test_a_thing_that_lies_is_the_same_one_turned():
    design = small.drawn(small.TABLE["book"], np.random.default_rng(1))
    standing, lying = (furniture.load_asset(design.id(laid)).links[0] for laid in (False, True))
    assert standing.mass == lying.mass
    upright, flat = (sorted(np.ptp(mesh.vertices, axis=0).round(4))
                     for mesh in (standing.visuals[0], lying.visuals[0]))
    assert upright == flat


def test_a_size_that_no_real_one_has_is_refused():
    with pytest.raises(BadInput, match="mug: width"):
        furniture.load_asset("mug/straight/115x300x95/0")
