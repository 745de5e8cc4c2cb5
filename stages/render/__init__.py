"""What cameras in a home see: pictures, and for every pixel how far, which way up, what and which it is."""

import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from apartgen.schemas.export import File
from apartgen.schemas.plan import Plan
from apartgen.schemas.render import Render, Seeing
from apartgen.stages import seeds
from apartgen.stages.render import film, frames, points, route, stands
from apartgen.stages.render.coco import Coco
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.render.labels import classes, instances
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.folder import CONTENTS, listed, replaced
from apartgen.stages.scene.looking import Eye
from apartgen.stages.scene.scene import LoadAsset, Scene
from apartgen.stages.scene.world import HomeWorld, roofless, world
from apartgen.stages.space import polygons

TILT = np.radians(-12.0)
"""How far the robot's camera looks down."""
FROM_ABOVE = np.radians(40.0)
"""What the camera above the home sees from left to right."""
BORDER = 0.5
"""What is seen about the home from above, m."""


class Shot(NamedTuple):
    """A camera to be used: its frame's name and kind, the room it stands in, and what it looks at."""

    name: str
    kind: Seeing
    room: str
    eye: Eye
    world: HomeWorld


def run(home: Plan, config: RenderConfig, rng: np.random.Generator, out: Path, load_asset: LoadAsset) -> Render:
    """Write all pictures into the folder `out`, which appears, or is replaced, whole or not at all."""
    scene = Scene(home, load_asset)
    looked_at = world(scene)
    things, labels = instances(looked_at), classes(looked_at.bodies)
    coco, views, files = Coco(labels, things), [], []
    with replaced(out) as folder:
        for shot in shots(looked_at, config):
            pictures = frames.taken(shot.world, shot.eye, things)
            views.append(frames.view(shot.name, shot.kind, shot.room, shot.eye, pictures))
            files += [_file(path, path.name.split(".")[1]) for path in frames.saved(folder, shot.name, pictures)]
            coco.add(views[-1], f"{shot.name}.rgb.png", pictures["instance"].astype(np.uint16))
        (folder / "coco.json").write_text(coco.text(), encoding="utf-8")
        (folder / "layout.txt").write_text(points.written(home), encoding="utf-8")
        files += [_file(folder / "coco.json", "coco"), _file(folder / "layout.txt", "spatiallm")]
        if config.points:
            cloud = points.cloud(looked_at, config.points, config.eye, seeds.lane(rng, "points"))
            (folder / "points.ply").write_bytes(cloud)
            files.append(_file(folder / "points.ply", "ply"))
        shown = film.filmed(scene, looked_at, config, TILT, folder) if config.video else None
        if shown is not None:
            files += [_file(folder / name, name.partition(".")[2]) for name in (film.FILE, film.WAY)]
        (folder / CONTENTS).write_text(listed([(file.path, file.sha256) for file in files], "render"))
    return Render(views=views, film=shown, instances=things, labels=labels, files=files)


def shots(home: HomeWorld, config: RenderConfig) -> Iterator[Shot]:
    """Every camera that the settings ask for."""
    rooms = [room.id for room in home.plan.rooms]
    field, size = np.radians(config.field), (config.width, config.height)
    if "eye" in config.kind:
        for k, stand in enumerate(stands.best(home, config.views, config.eye, field, size)):
            camera = Camera.looking(stand.place, stand.yaw, stands.PITCH, field, *size)
            yield Shot(f"eye_{k:03d}", "eye", rooms[stand.room], camera, home)
    if "panorama" in config.kind:
        for stand in stands.middles(home, config.eye):
            room = rooms[stand.room]
            yield Shot(f"panorama_{room}", "panorama", room, stands.panorama(stand, config.height), home)
    if "above" in config.kind:
        yield Shot("above", "above", "", _above(home.plan, size), roofless(home))
    if "route" in config.kind:
        for k, stand in enumerate(route.along(home, config.frames, config.robot)):
            camera = Camera.looking(stand.place, stand.yaw, TILT, field, *size)
            room = rooms[stand.room] if stand.room >= 0 else ""
            yield Shot(f"route_{k:03d}", "route", room, camera, home)


def _above(plan: Plan, size: tuple[int, int]) -> Camera:
    """One that looks straight down on all of the home, north up."""
    x0, y0, x1, y1 = polygons.shell(plan).bounds
    wide, deep = x1 - x0 + 2 * BORDER, y1 - y0 + 2 * BORDER
    up = max(wide, deep * size[0] / size[1]) / 2 / np.tan(FROM_ABOVE / 2) + plan.height
    return Camera.looking(np.array([(x0 + x1) / 2, (y0 + y1) / 2, up]), np.pi / 2, -np.pi / 2, FROM_ABOVE, *size)


def _file(path: Path, format: str) -> File:
    return File(path=path.name, format=format, sha256=hashlib.sha256(path.read_bytes()).hexdigest())
