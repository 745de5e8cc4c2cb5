"""The building of the picture from above: cut off, so that what stands in its rooms can be seen."""

import numpy as np
from export import sample

from apartgen.stages.export._lowered import HEIGHT, lowered
from apartgen.stages.export._section import section
from apartgen.stages.scene.scene import Scene


def tops(bodies):
    """Highest visible point of each body by name, m."""
    return {
        body.name: max(mesh.vertices[:, 2].max() for link in body.links for mesh in link.visuals) + body.position[2]
        for body in bodies if any(link.visuals for link in body.links)
    }


def test_the_building_ends_where_it_is_cut_and_furniture_stays_whole():
    scene = Scene(sample.home(), sample.load)
    before, after = tops(scene.bodies), tops(lowered(scene.bodies))
    kinds = {body.name: body.kind for body in scene.bodies}
    for name, top in after.items():
        assert top <= HEIGHT + 1e-6 if kinds.get(name, "wall") != "object" else top == before[name]
    assert {name.rsplit("_", 1)[0] for name in after} >= {"display_cabinet", "sofa", "tv"}


def test_what_hangs_high_is_taken_off():
    left = {body.category for body in lowered(Scene(sample.home(), sample.load).bodies)}
    assert not {"ceiling_lamp", "wall_lamp"} & left and "tv" in left


def test_what_is_cut_through_is_covered():
    """Seen from above, the cut's faces are as large as the walls that it goes through."""
    scene = Scene(sample.home(), sample.load)
    face = lowered(scene.bodies)[0].links[0].visuals[0]
    corners = face.vertices[face.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    upward = normals[np.isclose(corners[..., 2], HEIGHT).all(1), 2].sum()
    building = [body for body in scene.bodies if body.kind in ("wall", "lining", "trim", "door", "window")]
    assert np.isclose(upward, section(building, HEIGHT, HEIGHT).area, rtol=1e-3)
