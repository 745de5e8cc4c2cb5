"""Nav2's maps: read as map_server reads them, free space is what the metrics call walkable."""

import crowded
import numpy as np
import pytest
import yaml
from export import nav2maps, sample
from export.conftest import EXAMPLE
from scipy import ndimage
from shapely.geometry import Point

from apartgen.schemas import artifact
from apartgen.schemas.retrieve import AssetKey
from apartgen.schemas.walkable import Walkable
from apartgen.stages.export import nav2
from apartgen.stages.robot import reach
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import footprints, polygons, sweeps
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Asset, Link
from apartgen.stages.things.materials import PALETTE


@pytest.fixture(scope="module")
def folder(exported):
    out = exported("nav2")
    return out / "nav2"


def test_free_space_agrees_with_the_walkable_ratio(folder):
    measured, wanted = nav2maps.free_ratios(folder, sample.home())
    assert measured == pytest.approx(wanted, abs=0.01)


def test_what_hangs_above_the_robot_is_passed_under(tmp_path):
    """The height is the one that the walkable stage clears ways for, and the files say it."""
    shelf, homes = "wall_lamp_14", [sample.home(), sample.home()]
    for home, bottom in zip(homes, (reach.HEIGHT, reach.HEIGHT - 0.01)):
        o = next(o for o in home.objects if o.id == shelf)
        o.center = (o.center[0], o.center[1], bottom + o.size[2] / 2)
    over, under = (_written(home, sample.load, tmp_path / str(k)) for k, home in enumerate(homes))
    x, y, _ = o.center
    assert _value(nav2maps.read(over, "map"), x, y) == 0 and _value(nav2maps.read(under, "map"), x, y) == 100
    assert yaml.safe_load((over / "waypoints.yaml").read_text())["robot_height"] == reach.HEIGHT
    assert f"between {footprints.FLAT} and {reach.HEIGHT} m" in (over / "map.yaml").read_text().splitlines()[0]


def _written(home, load, out):
    out.mkdir()
    nav2.write(Scene(home, load), out)
    return out / "nav2"


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
    assert len(points["objects"]) >= 5
    for name, pose in points["objects"].items():
        o = next(o for o in home.objects if o.id == name)
        to = np.array(o.center[:2]) - [pose["x"], pose["y"]]
        front = np.array([np.cos(o.yaw), np.sin(o.yaw)])
        assert to @ front < -o.size[0] / 2  # stands before its front
        assert np.cos(pose["yaw"]) * to[0] + np.sin(pose["yaw"]) * to[1] == pytest.approx(np.hypot(*to), abs=1e-3)


def test_one_comes_in_facing_away_from_the_entrance(folder):
    """Its door is in the wall at x = 9.15, from y = 4.3 to 5.2; one comes in towards -x."""
    pose = yaml.safe_load((folder / "waypoints.yaml").read_text())["entrance"]
    assert 9.0 - 2 * reach.RADIUS - 0.15 < pose["x"] < 9.0 - reach.RADIUS
    assert 4.3 < pose["y"] < 5.2
    assert np.cos(pose["yaw"]) == pytest.approx(-1.0)


def _boxes(home):
    """The home with an asset of its own for every object, a box with its joints, and what loads them."""
    known = {o.id: o for o in home.objects}

    def load(library, id):
        o = known[id]
        half = np.array(o.size) / 2
        base = Link("base", [solids.box(-half, half, PALETTE["oak"])], [solids.slab(-half, half)], 10.0)
        moving = [Link(joint.name, base.visuals, [], 1.0, joint) for joint in o.joints]
        return Asset(library, id, o.category, "plain", o.size, [base, *moving])

    named = [o.model_copy(update={"asset": AssetKey(library="own", id=o.id)}) for o in home.objects]
    return home.model_copy(update={"objects": named}), load


HOMES = ["sample", "example", *((seed, kind) for seed in range(2) for kind in crowded.FIRST)]


@pytest.mark.parametrize("which", HOMES, ids=str)
def test_nav2_finds_every_way_that_the_walkable_stage_finds(which, library, tmp_path):
    """From the entrance to all waypoints, and to the standing places of all that opens and is reached."""
    if which == "sample":
        home, load = sample.home(), sample.load
    elif which == "example":
        home, load = artifact.read(EXAMPLE, Walkable).body, library
    else:
        home, load = _boxes(crowded.crowded(*which))
    folder = _written(home, load, tmp_path / "x")
    cells, x, y, about = nav2maps.read(folder, "map")
    # Nav2 keeps the robot's centre off cells whose centre is no further than its radius from that of an occupied one.
    away = ndimage.distance_transform_edt(cells == 0) * about["resolution"]
    points = yaml.safe_load((folder / "waypoints.yaml").read_text())
    parts, _ = ndimage.label(away > points["robot_radius"])

    def part(at_x, at_y):
        return parts[int(np.abs(y - at_y).argmin()), int(np.abs(x - at_x).argmin())]

    start = part(points["entrance"]["x"], points["entrance"]["y"])
    assert start
    for kind in ("rooms", "objects"):
        for name, pose in (points[kind] or {}).items():
            assert part(pose["x"], pose["y"]) == start, name
    world = reach.space(home)
    found = reach.survey(world, home.objects)
    opens = {o.id for o, moves in zip(home.objects, sweeps.articulated(home.objects)) if moves}
    reached = {o.id for o in home.objects if o.id in opens and footprints.is_obstacle(o)} - set(found.closed)
    assert reached <= set(points["objects"] or {})
    rows, columns = np.nonzero(found.cells)
    assert all(part(world.grid.x[c], world.grid.y[r]) == start for r, c in zip(rows[::7], columns[::7]))
