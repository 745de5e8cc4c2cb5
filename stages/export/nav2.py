"""Maps for Nav2: what a robot must go around, what its lidar sees, a keep-out mask, and waypoints.

`map` is for planning: walls and the whole box of every obstacle. `lidar` is for localisation: what is solid at the
lidar's height. `keepout` masks what the robot must avoid though the lidar does not see it, and the way out.
Waypoints are poses that a robot of the given radius reaches from the entrance.
"""

from pathlib import Path

import numpy as np
from shapely.ops import unary_union

from schemas.layout import Layout
from schemas.retrieve import Furnishing, Retrieve
from stages import footprints, grid, polygons, reach, sweeps
from stages.boxes import Array, Mask
from stages.export._section import section
from stages.export._xml import number
from stages.grid import Grid
from stages.scene import Scene

FOLDER = "nav2"
RESOLUTION = 0.05
LIDAR = (0.18, 0.22)
"""Heights between which the lidar sees, m."""
FREE, UNKNOWN, OCCUPIED = 254, 205, 0
"""Grey values that map_server's trinary mode reads so."""


def write(scene: Scene, out: Path) -> list[Path]:
    """Three maps (pgm and yaml) and waypoints.yaml, in the folder nav2."""
    folder = out / FOLDER
    folder.mkdir()
    home = scene.home
    shell, inside = polygons.shell(home), polygons.free_floor(home)
    cells = grid.over(shell, RESOLUTION)
    floor = grid.raster(inside, cells)
    covered = footprints.covered(home.objects if isinstance(home, Layout) else [])
    blocked = grid.raster(covered, cells) & floor
    solid = section((b for b in scene.bodies if b.kind in ("wall", "object", "window")), *LIDAR)
    seen = grid.raster(solid, cells) & floor
    ways_out = unary_union([polygons.threshold(o, home) for o in home.openings if o.kind == "entrance"])
    house = grid.raster(shell, cells)
    files = [
        *_map(folder, "map", cells, _trinary(house, floor, blocked)),
        *_map(folder, "lidar", cells, _trinary(house, floor, seen)),
        *_map(folder, "keepout", cells, np.where((blocked & ~seen) | grid.raster(ways_out, cells), OCCUPIED, FREE)),
    ]
    return [*files, _waypoints(scene, folder)]


def _trinary(house: Mask, floor: Mask, blocked: Mask) -> Array:
    return np.where(floor & ~blocked, FREE, np.where(house, OCCUPIED, UNKNOWN))


def _map(folder: Path, name: str, cells: Grid, grey: Array) -> list[Path]:
    """A binary PGM, first row northernmost, and the YAML that map_server reads."""
    rows, columns = cells.shape
    image, about = folder / f"{name}.pgm", folder / f"{name}.yaml"
    image.write_bytes(f"P5\n{columns} {rows}\n255\n".encode() + grey[::-1].astype(np.uint8).tobytes())
    x, y = cells.origin
    about.write_text(
        f"image: {image.name}\nmode: trinary\nresolution: {cells.resolution}\norigin: [{number(x)}, {number(y)}, 0.0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.19\n"
    )
    return [image, about]


def _waypoints(scene: Scene, folder: Path) -> Path:
    """Where to stand in each room, before each object that opens, and inside the entrance."""
    home = scene.home
    objects = home.objects if isinstance(home, Layout) else []
    world = reach.space(home)
    reached = reach.survey(world, objects)
    lines = [f"frame_id: map\nrobot_radius: {world.radius}\n", "entrance:\n"]
    lines += _pose("  ", world.grid, reached.cells & world.entry, reached.cells, None)
    lines.append("rooms:\n")
    for i, room in enumerate(home.rooms):
        here = reached.cells & (world.rooms == i)
        lines += [f"  {room.id}:\n", *_pose("    ", world.grid, here, reached.cells, None)] if here.any() else []
    lines.append("objects:\n")
    for o in home.objects if isinstance(home, Retrieve) else []:
        before = _before(world, o, reached.cells)
        if before.any():
            lines += [f"  {o.id}:\n", *_pose("    ", world.grid, before, reached.cells, np.array(o.center[:2]))]
    path = folder / "waypoints.yaml"
    path.write_text("".join(lines))
    return path


def _before(world: reach.Space, o: Furnishing, cells: Mask) -> Mask:
    """Cells reached from which an object that opens is used."""
    found = np.zeros_like(cells)
    if sweeps.articulated([o])[0] and footprints.is_obstacle(o):
        window, zone = reach.standing(o, world.grid, reach.REACH, world.radius)
        found[window] = zone & cells[window]
    return found


def _pose(indent: str, cells: Grid, among: Mask, free: Mask, towards: Array | None) -> list[str]:
    """The cell with most room about it, facing a point, or else where the room about is longest."""
    from scipy import ndimage

    if not among.any():
        return [f"{indent}{{}}\n"]
    clear = np.where(among, ndimage.distance_transform_edt(free), -1.0)
    row, column = np.unravel_index(int(clear.argmax()), clear.shape)
    x, y = float(cells.x[column]), float(cells.y[row])
    middle = np.array([cells.x[np.nonzero(among)[1]].mean(), cells.y[np.nonzero(among)[0]].mean()])
    away = (middle if towards is None else towards) - [x, y]
    yaw = float(np.arctan2(away[1], away[0])) if np.hypot(*away) > 0.05 else 0.0
    return [f"{indent}{name}: {number(round(value, 4))}\n" for name, value in (("x", x), ("y", y), ("yaw", yaw))]
