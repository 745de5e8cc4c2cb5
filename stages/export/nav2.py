"""Maps for Nav2: what a robot must go around, what its lidar sees, a keep-out mask, and waypoints.

`map` is for planning: walls and the whole box of everything in the robot's height. `lidar` is for localisation: what is
solid at the lidar's height. `keepout` masks what the robot must avoid though the lidar does not see it, and the way
out. Waypoints are poses that a robot of the given radius and height reaches from the entrance.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from shapely.ops import unary_union

from apartgen.schemas.layout import Box, Layout
from apartgen.stages.export._readback import Refused, read_images
from apartgen.stages.export._section import section
from apartgen.stages.export._xml import number
from apartgen.stages.robot import reach
from apartgen.stages.robot.way import before
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import footprints, grid, polygons, sweeps
from apartgen.stages.space.boxes import Array, Mask
from apartgen.stages.space.grid import Grid

FOLDER = "nav2"
FINER = 2
"""Cells are so much smaller than those of the walkable stage: gaps little wider than the robot have cells in them."""
BAND = (footprints.FLAT, reach.HEIGHT)
"""Heights between which things are in the robot's way, m: those for which the walkable stage clears ways."""
LIDAR = (0.18, 0.22)
"""Heights between which the lidar sees, m."""
FREE, UNKNOWN, OCCUPIED = 254, 205, 0
"""Grey values that map_server's trinary mode reads so."""
MAPS = {"image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}
WAYPOINTS = {"frame_id", "robot_radius", "robot_height", "entrance", "rooms", "objects"}
"""What files have to say."""
_HAIR = 1e-6  # m by which walls and boxes are thinner, so that a cell whose centre is on an edge is free


def write(scene: Scene, out: Path) -> list[Path]:
    """Three maps (pgm and yaml) and waypoints.yaml, in the folder nav2."""
    folder = out / FOLDER
    folder.mkdir()
    home = scene.home
    objects = home.objects if isinstance(home, Layout) else []
    world = reach.space(home)
    shell = polygons.shell(home)
    cells = grid.finer(world.grid, FINER, shell)
    floor = grid.raster(polygons.free_floor(home).buffer(_HAIR), cells)
    standing = footprints.covered(o for o in objects if reach.in_the_way(o))
    blocked = grid.raster(standing.buffer(-_HAIR), cells) & floor
    solid = section((b for b in scene.bodies if b.kind in ("wall", "object", "window")), *LIDAR)
    seen = grid.raster(solid, cells) & floor
    ways_out = unary_union([polygons.threshold(o, home) for o in home.openings if o.kind == "entrance"])
    house = grid.raster(shell, cells)
    keep_out = np.where((blocked & ~seen) | grid.raster(ways_out, cells), OCCUPIED, FREE)
    return [
        *_map(folder, "map", cells, _trinary(house, floor, blocked), f"what is {_between(BAND)}"),
        *_map(folder, "lidar", cells, _trinary(house, floor, seen), f"what is solid {_between(LIDAR)}"),
        *_map(folder, "keepout", cells, keep_out, "what of map is not in lidar, and the way out"),
        _waypoints(world, objects, folder),
    ]


def read_back(files: list[Path]) -> None:
    """Maps by Pillow; what is said of them line by line, since there is no parser of YAML to count on."""
    read_images(file for file in files if file.suffix == ".pgm")
    for file in files:
        lines = file.read_text(encoding="utf-8").splitlines() if file.suffix == ".yaml" else []
        said = {line.split(":")[0] for line in lines}
        if lines and not said >= (WAYPOINTS if file.name == "waypoints.yaml" else MAPS):
            raise Refused(f"{file.name} does not say all that it has to")


def _between(heights: tuple[float, float]) -> str:
    return f"between {heights[0]} and {heights[1]} m above the floor"


def _trinary(house: Mask, floor: Mask, blocked: Mask) -> Array:
    return np.where(floor & ~blocked, FREE, np.where(house, OCCUPIED, UNKNOWN))


def _map(folder: Path, name: str, cells: Grid, grey: Array, shown: str) -> list[Path]:
    """A binary PGM, first row northernmost, and the YAML that map_server reads; `shown` says what is occupied."""
    rows, columns = cells.shape
    image, about = folder / f"{name}.pgm", folder / f"{name}.yaml"
    image.write_bytes(f"P5\n{columns} {rows}\n255\n".encode() + grey[::-1].astype(np.uint8).tobytes())
    x, y = cells.origin
    about.write_text(
        f"# Occupied: {shown}.\n"
        f"image: {image.name}\nmode: trinary\nresolution: {cells.resolution}\norigin: [{number(x)}, {number(y)}, 0.0]\n"
        "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.19\n"
    )
    return [about, image]


def _waypoints(world: reach.Space, objects: Sequence[Box], folder: Path) -> Path:
    """Where to stand inside the entrance, in each room, and before each object that opens."""
    reached = reach.survey(world, objects).cells
    lines = [f"frame_id: map\nrobot_radius: {world.radius}\nrobot_height: {BAND[1]}\n", "entrance:\n"]
    lines += _pose("  ", world.grid, reached & world.entry, reached, heading=polygons.inward(world.plan))
    lines.append("rooms:\n")
    for i, room in enumerate(world.plan.rooms):
        here = reached & (world.rooms == i)
        lines += [f"  {room.id}:\n", *_pose("    ", world.grid, here, reached)] if here.any() else []
    lines.append("objects:\n")
    for o in objects:
        before = _before(world, o, reached)
        if before.any():
            lines += [f"  {o.id}:\n", *_pose("    ", world.grid, before, reached, towards=np.array(o.center[:2]))]
    path = folder / "waypoints.yaml"
    path.write_text("".join(lines))
    return path


def _before(world: reach.Space, o: Box, cells: Mask) -> Mask:
    """Cells reached from which an object that opens is used."""
    opens = sweeps.articulated([o])[0] and footprints.is_obstacle(o)
    return before(world, o, cells) if opens else np.zeros_like(cells)


def _pose(
    indent: str, cells: Grid, among: Mask, free: Mask, towards: Array | None = None, heading: float | None = None
) -> list[str]:
    """The cell with most room about it, and a yaw: as given, facing a point, or else the middle of the cells."""
    from scipy import ndimage

    if not among.any():
        return [f"{indent}{{}}\n"]
    clear = np.where(among, ndimage.distance_transform_edt(free), -1.0)
    row, column = np.unravel_index(int(clear.argmax()), clear.shape)
    x, y = float(cells.x[column]), float(cells.y[row])
    middle = np.array([cells.x[np.nonzero(among)[1]].mean(), cells.y[np.nonzero(among)[0]].mean()])
    away = (middle if towards is None else towards) - [x, y]
    yaw = float(np.arctan2(away[1], away[0])) if np.hypot(*away) > 0.05 else 0.0
    pose = (("x", x), ("y", y), ("yaw", yaw if heading is None else heading))
    return [f"{indent}{name}: {number(round(value, 4))}\n" for name, value in pose]
