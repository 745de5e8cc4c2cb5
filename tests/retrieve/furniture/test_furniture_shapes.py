"""The shape kernel against volumes known by formula, and the palette's textures."""

import tracemalloc

import numpy as np
import pytest
import trimesh

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.furniture import mesh
from apartgen.stages.things import materials

CONE = np.pi * 0.1**2 * 0.3 * (1 + 0.5 + 0.25) / 3
CIRCLE = 32 / 2 * np.sin(2 * np.pi / 32) / np.pi
"""Area of the 32-gon to its circle's."""
SHAPES = {
    "cone": (mesh.rod((0, 0, 0), (0.1, 0.2, 0.2), 0.1, 0.05, 32), CONE * CIRCLE),
    "pipe": (mesh.lathe([(0.1, 0), (0.1, 0.3), (0.08, 0.3), (0.08, 0)], 32, caps=False), np.pi * 0.0036 * 0.3 * CIRCLE),
    "bend": (mesh.tube([(0, 0, 0), (0, 0, 0.5), (0.5, 0, 0.5)], 0.02, 32), np.pi * 0.0004 * 1.0 * CIRCLE),
    "box": (mesh.pillow((0, 0, 0), (1, 2, 3), 60, 12), 6.0),
    "ball": (mesh.pillow((-1, -1, -1), (1, 1, 1), 2, 24), 4 / 3 * np.pi),
    "wedge": (mesh.prism([(0, 0), (1, 0), (0, 1)], 0, 0.2), 0.1),
    "facets": (
        mesh.facets(
            np.array(
                [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 0, 2), (1, 0, 2), (1, 1, 2), (0, 1, 2)]], float
            )
        ),
        2.0,
    ),
}


@pytest.mark.parametrize("name", SHAPES)
def test_shapes_are_closed_and_hold_what_the_formula_says(name):
    shape, volume = SHAPES[name]
    solid = trimesh.Trimesh(shape.vertices, shape.faces)
    assert solid.is_watertight and solid.is_winding_consistent
    assert shape.volume == pytest.approx(solid.volume) == pytest.approx(volume, rel=0.02)
    assert len(shape.uv) == len(shape.vertices)


def test_a_rounded_box_loses_its_edges_and_keeps_its_sides():
    a, r = 1.0, 0.2
    shape = mesh.rounded((0, 0, 0), (a, a, a), r, 8)
    inner = a - 2 * r
    exact = inner**3 + 6 * inner**2 * r + 3 * np.pi * r**2 * inner + 4 / 3 * np.pi * r**3
    assert shape.volume == pytest.approx(exact, rel=0.01)
    assert np.allclose([shape.vertices.min(0), shape.vertices.max(0)], [[0] * 3, [a] * 3])


def test_a_slab_of_a_curved_sheet_is_closed():
    u, v = np.meshgrid(np.linspace(0, 1, 9), np.linspace(-1, 1, 5), indexing="ij")
    upper = np.stack([u, v, 0.2 * u**2 + 0.1 * v**2], -1)
    shape = mesh.slab(upper, upper - [0, 0, 0.01])
    assert trimesh.Trimesh(shape.vertices, shape.faces).is_watertight
    assert shape.volume == pytest.approx(0.02, rel=1e-6)


def test_smooth_surfaces_share_vertices_and_hard_edges_do_not():
    cylinder = mesh.rod((0, 0, 0), (0, 0, 1), 0.1, points=16)
    assert len(cylinder.vertices) == 2 * 16 + 2 * 17
    assert len(mesh.lathe([(0.1, 0), (0.11, 0.5), (0.1, 1)], 16).vertices) == 3 * 16 + 2 * 17
    assert len(mesh.lathe([(0.1, 0), (0.3, 0.1), (0.1, 1)], 16).vertices) == 4 * 16 + 2 * 17


@pytest.mark.parametrize("name", materials.textures())
def test_textures_tile_and_have_their_materials_colour(name):
    image = materials.texture(name, 64)
    assert image.shape == (64, 64, 3) and image.dtype == np.uint8
    mean = image.reshape(-1, 3).mean(0) / 255
    assert np.abs(mean - materials.PALETTE[name].color[:3]).max() < 0.13
    assert image.std() > 0.5
    assert materials.texture.__wrapped__(name, 64).tobytes() == image.tobytes()


@pytest.mark.parametrize("name", ["oak", "marble", "linen", "rug_berber"])
def test_texture_edges_meet(name):
    image = materials.texture(name, 128).astype(float)
    seam = np.abs(image[:, 0] - image[:, -1]).mean()
    inside = np.abs(np.diff(image, axis=1)).mean()
    assert seam < 2.5 * inside + 4


def test_a_plain_material_has_no_texture():
    assert materials.PALETTE["white"].texture is None
    with pytest.raises(BadInput):
        materials.texture("white")


def test_shapes_that_nobody_needs_are_let_go():
    """However many homes a worker makes, each of whose legs and pots are of other sizes."""
    held = []
    tracemalloc.start()
    for first in (1, 2, 3):
        for i in range(mesh.LATELY):
            mesh.rod((0, 0, 0), (0, 0, first + i / mesh.LATELY), 0.02)
        held.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    assert held[2] - held[0] < 0.1 * held[0]
