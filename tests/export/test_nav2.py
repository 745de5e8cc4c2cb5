"""Nav2's maps: read as map_server reads them, free space is what the metrics call walkable."""

import numpy as np
import pytest
import yaml
from export import nav2maps, sample
from shapely.geometry import Point

from stages import footprints, polygons


@pytest.fixture(scope="module")
def folder(exported):
    out = exported("nav2")
    return out / "nav2"


def test_free_space_agrees_with_the_walkable_ratio(folder):
    measured, wanted = nav2maps.free_ratios(folder, sample.home())
    assert measured == pytest.approx(wanted, abs=0.01)


def test_all_maps_lie_on_the_same_cells(folder):
    maps = [nav2maps.read(folder, name) for name in ("map", "lidar", "keepout")]
    for cells, _, _, about in maps:
        assert cells.shape == maps[0][0].shape and about["origin"] == maps[0][3]["origin"]
        assert about["resolution"] == maps[0][3]["resolution"]
    assert set(np.unique(maps[2][0])) == {0, 100}  # a mask knows no unknown


def _value(found, x, y):
    cells, xs, ys, _ = found
    return cells[int(np.abs(ys - y).argmin()), int(np.abs(xs - x).argmin())]


def test_walls_doors_furniture_and_outside(folder):
    found, lidar, keepout = (nav2maps.read(folder, name) for name in ("map", "lidar", "keepout"))
    assert _value(found, 5.25, 1.0) == 100 and _value(found, 3.6, 4.05) == 0  # inner wall, door
    assert _value(found, -0.15, 2.0) == 100 and _value(found, 8.0, 6.5) == -1  # outer wall, open air
    assert _value(found, 0.46, 2.0) == 100 and _value(lidar, 0.46, 2.0) == 100  # sofa
    assert _value(found, 2.6, 2.0) == 0 and _value(lidar, 2.2, 2.9) == 0  # under a ceiling lamp, on a rug
    assert _value(keepout, 9.15, 4.7) == 100 and _value(keepout, 2.6, 3.0) == 0  # the way out, open floor


def test_waypoints_are_free_and_in_their_rooms(folder):
    home, points = sample.home(), yaml.safe_load((folder / "waypoints.yaml").read_text())
    assert set(points["rooms"]) == {room.id for room in home.rooms}
    floors = polygons.floors(home)
    standing = footprints.covered(home.objects)
    for name, pose in points["rooms"].items():
        spot = Point(pose["x"], pose["y"])
        assert floors[name].contains(spot) and standing.distance(spot) > points["robot_radius"] - 0.05
    assert floors["hallway_1"].contains(Point(points["entrance"]["x"], points["entrance"]["y"]))
    assert len(points["objects"]) >= 5
    for name, pose in points["objects"].items():
        o = next(o for o in home.objects if o.id == name)
        to = np.array(o.center[:2]) - [pose["x"], pose["y"]]
        front = np.array([np.cos(o.yaw), np.sin(o.yaw)])
        assert to @ front < -o.size[0] / 2  # stands before its front
        assert np.cos(pose["yaw"]) * to[0] + np.sin(pose["yaw"]) * to[1] == pytest.approx(np.hypot(*to), abs=1e-3)
