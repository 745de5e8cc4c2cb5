"""Shows an episode: its trace laid over the exported apartment, ceilings off, as frames and an animated GIF."""

from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from shapely.geometry import LineString

from schemas.errors import BadInput
from stages import polygons
from stages.boxes import Array
from stages.embodied import world
from stages.embodied.outcome import Outcome, Trace
from stages.embodied.world import ROBOT, World
from stages.scene import Scene

SIZE = (640, 480)
"""Width and height of a frame, pixels."""
NEAR = (2.6, 2.0, 1.6)
"""How far off an interaction is watched, m, from where there is no wall between."""
STEEP = (-35, -50, -65)
ASIDE = (35, -35, 15, -15, 60, -60)
"""How steeply it is looked down on, and from how far to the side of its front, degrees; the first of each is best."""
_HIDDEN = (3, 4)  # geom groups of the export: colliders, ceilings
_WIDTH = {int(mujoco.mjtJoint.mjJNT_FREE): 7, int(mujoco.mjtJoint.mjJNT_BALL): 4}
_TRAIL = (0.95, 0.35, 0.1, 1.0)


def images(scene: Scene, mjcf: Path, robot: str, outcome: Outcome, size: tuple[int, int] = SIZE) -> Iterator[Array]:
    """A picture (height, width, 3) of every moment of its trace; BadInput where it has none.

    `robot` is the MJCF of the robot that made the trace.
    """
    if outcome.trace is None or not outcome.trace.times:
        raise BadInput(f"{outcome.id}: nothing moved ({outcome.reason}); there is nothing to show")
    shown = world.build(scene, mjcf, robot, visuals=True)
    width, height = size
    shown.model.vis.global_.offwidth, shown.model.vis.global_.offheight = width, height
    data = mujoco.MjData(shown.model)
    with mujoco.Renderer(shown.model, height, width) as renderer:
        option, camera = _option(), _camera(shown, outcome)
        trail: list[Array] = []
        for moment in range(len(outcome.trace.times)):
            _pose(shown, data, outcome.trace, moment)
            renderer.update_scene(data, camera, option)
            trail.append(data.body(f"{ROBOT}_base").xpos.copy())
            _draw(renderer.scene, trail)
            yield renderer.render().copy()


def save(pictures: Iterator[Array], path: Path, trace: Trace) -> Path:
    """An animated GIF as fast as the trace, and beside it the last frame as a PNG."""
    from PIL import Image

    frames = [Image.fromarray(picture) for picture in pictures]
    period = trace.times[-1] / max(1, len(trace.times) - 1)
    path.parent.mkdir(parents=True, exist_ok=True)
    frames[-1].save(path.with_suffix(".png"))
    small = [frame.quantize(64, method=Image.Quantize.FASTOCTREE) for frame in frames]
    small[0].save(path, save_all=True, append_images=small[1:], duration=int(1000 * period), loop=0)
    return path


def _option() -> Any:
    option = mujoco.MjvOption()
    for group in _HIDDEN:
        option.geomgroup[group] = 0
    option.sitegroup[:] = 0
    return option


def _camera(shown: World, outcome: Outcome) -> Any:
    """From above on the whole apartment, or near the object that is opened."""
    camera = mujoco.MjvCamera()
    found = {o.id: o for o in shown.home.objects}.get(outcome.object)
    if outcome.episode == "interaction" and found is not None:
        camera.lookat[:] = *found.center[:2], min(found.center[2], 1.2)
        camera.distance, camera.elevation, camera.azimuth = _view(shown, np.array(found.center[:2]), found.yaw)
        return camera
    points = np.concatenate([room.polygon for room in shown.home.rooms])
    lo, hi = points.min(0), points.max(0)
    camera.lookat[:] = *(lo + hi) / 2, 0.5
    camera.distance, camera.elevation, camera.azimuth = 1.25 * float(np.hypot(*(hi - lo))), -78, 90
    return camera


def _view(shown: World, at: Array, yaw: float) -> tuple[float, float, float]:
    """Distance (m), elevation and azimuth (degrees) from which nothing but furniture hides an object's front."""
    floor = polygons.free_floor(shown.home).buffer(0.02)
    for steep, far, aside in product(STEEP, NEAR, ASIDE):
        azimuth = np.degrees(yaw) + 180 + aside
        level = far * np.cos(np.radians(steep))
        eye = at - level * np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
        if floor.covers(LineString([at, eye])):
            return far, steep, azimuth
    return NEAR[0], -80.0, np.degrees(yaw) + 180


def _pose(shown: World, data: Any, trace: Trace, moment: int) -> None:
    """The joints of the trace where they were then; all else as built."""
    values, at = trace.qpos[moment], 0
    for name in trace.joints:
        joint = shown.model.joint(name)
        count = _WIDTH.get(int(joint.type[0]), 1)
        first = int(joint.qposadr[0])
        data.qpos[first : first + count] = values[at : at + count]
        at += count
    mujoco.mj_forward(shown.model, data)


def _draw(scene: Any, trail: list[Array]) -> None:
    """Where the base has been, as a line on the floor."""
    for a, b in zip(trail[:-1], trail[1:], strict=True):
        if scene.ngeom >= scene.maxgeom or np.hypot(*(b - a)[:2]) < 1e-3:
            continue
        geom = scene.geoms[scene.ngeom]
        mujoco.mjv_initGeom(geom, mujoco.mjtGeom.mjGEOM_CAPSULE, np.zeros(3), np.zeros(3), np.eye(3).ravel(),
                            np.array(_TRAIL, np.float32))
        lift = np.array([0, 0, 0.03])
        mujoco.mjv_connector(geom, mujoco.mjtGeom.mjGEOM_CAPSULE, 0.025, a + lift, b + lift)
        scene.ngeom += 1
