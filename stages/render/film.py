"""A film of the robot's way through every room, doors opening before it, and where its camera was at each frame."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.errors import BadInput
from apartgen.schemas.render import Film, Shown
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.render.frames import pose
from apartgen.stages.render.route import along, length
from apartgen.stages.render.stands import Stand
from apartgen.stages.scene.camera import MIDDLE, Camera
from apartgen.stages.scene.looking import first
from apartgen.stages.scene.picture import metered, taken
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.soup import Array
from apartgen.stages.scene.world import HomeWorld, ajar_world

TURN = np.radians(100.0)
"""How fast the camera turns at most, rad/s."""
NEAR, PASSED = 2.0, 1.1
"""A door begins to open when the robot is so near, and stands open when it is so near, m along its way."""
STEPS = 8
"""Places of a door between shut and open."""
STEADY = 1.0
"""Seconds over which exposure is evened."""
METER = 48
"""Columns of the pictures by which exposure is found."""
ENCODING = {"crf": "20", "preset": "medium", "x264-params": "threads=1:lookahead-threads=1"}
FILE, WAY = "walk.mp4", "walk.json"

Shares = tuple[tuple[str, float], ...]


class Moment(NamedTuple):
    """A frame to be taken: where the camera is, and how far doors stand open that do not stand shut."""

    stand: Stand
    doors: Shares


class Look(NamedTuple):
    """What is known of a frame before it is taken: the exposure that suits it, and pixels by number of things."""

    meter: float
    visible: list[tuple[int, int]]


def filmed(scene: Scene, home: HomeWorld, config: RenderConfig, tilt: float, folder: Path) -> Film | None:
    """Write the film and the list of its frames; None where the robot gets nowhere. BadInput without an encoder."""
    encoder()
    some = moments(home, config)
    if not some:
        return None
    cameras = lenses(some, config, tilt)
    looked = list(looks(scene, home, some, cameras))
    size = cameras[0].columns, cameras[0].rows
    frames = developed(scene, home, some, cameras, evened([look.meter for look in looked], config.rate))
    written(folder / FILE, frames, config.rate, size)
    rooms = ["", *(room.id for room in home.plan.rooms)]
    shown = [Shown(seconds=round(k / config.rate, 3), room=rooms[m.stand.room + 1], visible=look.visible)
             for k, (m, look) in enumerate(zip(some, looked))]
    rows = [{**frame.model_dump(), "pose": pose(camera), "doors": dict(m.doors)}
            for frame, m, camera in zip(shown, some, cameras)]
    told = {"file": FILE, "rate": config.rate, "width": size[0], "height": size[1],
            "intrinsics": cameras[0].intrinsics, "frames": rows}
    (folder / WAY).write_text(json.dumps(told, separators=(",", ":")) + "\n", encoding="utf-8")
    return Film(file=FILE, rate=config.rate, width=size[0], height=size[1], frames=shown)


def lenses(some: list[Moment], config: RenderConfig, tilt: float) -> list[Camera]:
    """The camera of each moment; a film has the shape of pictures, and even sides."""
    wide = config.film or config.width
    field, size = np.radians(config.field), (wide // 2 * 2, round(wide * config.height / config.width / 2) * 2)
    return [Camera.looking(m.stand.place, m.stand.yaw, tilt, field, *size) for m in some]


def moments(home: HomeWorld, config: RenderConfig) -> list[Moment]:
    """Frames along the way at an even speed; the camera turns no faster than `TURN`, a door opens once and stays so."""
    way = along(home, 2, config.robot)
    frames = round(length(home) / config.speed * config.rate) if way else 0
    stands = along(home, max(frames, 2), config.robot, config.back) if way else []
    yaws = _slowed(np.array([stand.yaw for stand in stands]), TURN / config.rate)
    places = np.array([stand.place[:2] for stand in stands]).reshape(-1, 2)
    shares = {name: _opening(places, at) for name, at in doors(home).items()}
    return [Moment(stand._replace(yaw=float(yaw)),
                   tuple((name, float(share[k])) for name, share in shares.items() if share[k] > 0))
            for k, (stand, yaw) in enumerate(zip(stands, yaws))]


def doors(home: HomeWorld) -> dict[str, Array]:
    """The middle of each door inside the home, by its body's name."""
    segments = {o.id: np.mean(np.asarray(o.segment, float), axis=0) for o in home.plan.openings}
    return {body.name: segments[body.id] for body in home.bodies
            if body.kind == "door" and body.category == "door" and body.id in segments}


def _opening(places: Array, door: Array) -> Array:
    """How far a door is open at each place of the way, in steps: as near as one ever was, and was going to pass."""
    far = np.minimum.accumulate(np.linalg.norm(places - door, axis=1)) if len(places) else np.zeros(0)
    share = ((NEAR - far) / (NEAR - PASSED)).clip(0, 1)
    return np.round(share * STEPS) / STEPS


def _slowed(yaws: Array, most: float) -> Array:
    """Headings that follow others by no more than so much a frame, rad."""
    found = yaws.copy()
    for k in range(1, len(yaws)):
        by = (yaws[k] - found[k - 1] + np.pi) % (2 * np.pi) - np.pi
        found[k] = found[k - 1] + np.clip(by, -most, most)
    return found


def pictures(scene: Scene, home: HomeWorld, some: list[Moment], cameras: list[Camera], rate: int,
             ) -> Iterator[NDArray[np.uint8]]:
    """The frames, their exposure evened over a second."""
    meters = [look.meter for look in looks(scene, home, some, cameras)]
    yield from developed(scene, home, some, cameras, evened(meters, rate))


def looks(scene: Scene, home: HomeWorld, some: list[Moment], cameras: list[Camera]) -> Iterator[Look]:
    """What each frame shows, and how bright that is."""
    for world, camera in zip(worlds(scene, home, some), cameras):
        hits = first(world, camera, np.arange(camera.rows * camera.columns), MIDDLE).hits
        count = np.bincount(world.every.soup.owner[hits.triangle[hits.triangle >= 0]] + 1)
        visible = [(int(number), int(count[number])) for number in np.flatnonzero(count)]
        yield Look(metered(world, _small(camera)), visible)


def evened(meters: list[float], rate: int) -> Array:
    """Exposures, each that of half a second before and after it."""
    reach = max(1, round(STEADY * rate / 2))
    padded = np.pad(np.log(meters), reach, mode="edge")
    return np.asarray(np.exp(np.convolve(padded, np.ones(2 * reach + 1) / (2 * reach + 1), "valid")))


def developed(scene: Scene, home: HomeWorld, some: list[Moment], cameras: list[Camera], exposures: Array,
              ) -> Iterator[NDArray[np.uint8]]:
    """The frames at these exposures."""
    for world, camera, exposure in zip(worlds(scene, home, some), cameras, exposures):
        yield taken(world, camera, float(exposure))


def worlds(scene: Scene, home: HomeWorld, some: list[Moment]) -> Iterator[HomeWorld]:
    """The home at each moment; it is built anew where a door has moved."""
    known, world = None, home
    for moment in some:
        if moment.doors != known:
            known, world = moment.doors, ajar_world(home, scene, dict(moment.doors))
        yield world


def _small(camera: Camera) -> Camera:
    return Camera(camera.eye, camera.frame, camera.half, camera.middle,
                  max(1, round(METER * camera.rows / camera.columns)), METER)


def encoder() -> object:
    """The library that writes films; BadInput without it."""
    try:
        import av
    except ImportError:
        raise BadInput("--video: films are written by PyAV; pip install 'apartgen[video]'") from None
    return av


def written(file: Path, images: Iterator[NDArray[np.uint8]], rate: int, size: tuple[int, int]) -> None:
    """An MP4 (H.264) of pictures (rows, columns, 3)."""
    import av

    with av.open(str(file), "w", options={"movflags": "+faststart", "fflags": "+bitexact"}) as container:
        stream = container.add_stream("libx264", rate=rate, options=ENCODING)
        stream.width, stream.height, stream.pix_fmt = size[0], size[1], "yuv420p"
        stream.codec_context.thread_count = 1
        for image in images:
            frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(image), format="rgb24")
            container.mux(stream.encode(frame.reformat(format="yuv420p")))
        container.mux(stream.encode())
