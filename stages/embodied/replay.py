"""Shows an episode: its trace laid over the exported apartment, ceilings off, as frames and an animated GIF."""

import warnings
from collections.abc import Iterable, Iterator
from itertools import product
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from shapely.geometry import LineString

from apartgen.stages.embodied import base, floor, goals, interact, marks, planner, world
from apartgen.stages.embodied.outcome import Outcome, Trace
from apartgen.stages.embodied.world import ROBOT, World
from apartgen.stages.space import polygons
from apartgen.stages.space.boxes import Array

SIZE = (640, 480)
"""Width and height of a frame, pixels."""
DISTANCES = (2.6, 2.0, 1.6)
"""How far off an interaction is watched, m, from where there is no wall between."""
STEEP = (-35, -50, -65)
ASIDE = (35, -35, 15, -15, 60, -60)
"""How steeply it is looked down on, and from how far to the side of its front, degrees; the first of each is best."""
_HIDDEN = (3, 4)  # geom groups of the export: colliders, ceilings
_WIDTH = {int(mujoco.mjtJoint.mjJNT_FREE): 7, int(mujoco.mjtJoint.mjJNT_BALL): 4}
_LEGEND = "green: the robot gets there, orange: it would only fit"


def ready() -> None:
    """Find out whether MuJoCo can draw here; RuntimeError or AttributeError where it can't."""
    with warnings.catch_warnings(action="ignore"):  # the error says it
        try:
            mujoco.Renderer(mujoco.MjModel.from_xml_string("<mujoco/>"), 8, 8).close()
        except mujoco.FatalError as error:
            raise RuntimeError(str(error)) from None


def images(apartment: World, robot: str, outcome: Outcome, size: tuple[int, int] = SIZE) -> Iterator[Array]:
    """A picture (height, width, 3) of every moment of an episode; one, where the robot found no place to go.

    `robot` is the MJCF of the robot that made the trace. What the episode is about is blue, what is met red. Where
    there was no place, the floor is green as far as the robot gets and orange where it could only stand. A part that
    is blocked goes on through what blocks it.
    """
    shown = world.build(apartment.scene, apartment.mjcf, robot, visuals=True)
    width, height = size
    shown.model.vis.global_.offwidth, shown.model.vis.global_.offheight = width, height
    lost = _lost(outcome)
    if lost or outcome.trace is None:
        trace, drawn = _start(apartment, outcome)
    else:
        trace, drawn = _whole(shown, outcome, outcome.trace), []
    drawn += marks.goal(outcome) + _painted(shown, outcome, trace, lost)
    data, trail = mujoco.MjData(shown.model), list[Array]()
    with mujoco.Renderer(shown.model, height, width) as renderer:
        option, camera = _option(), _camera(shown, outcome, lost or _on_its_way(shown, outcome))
        for moment in range(len(trace.times)):
            _pose(shown, data, trace, moment)
            renderer.update_scene(data, camera, option)
            trail.append(data.body(f"{ROBOT}_base").xpos.copy())
            marks.put(renderer.scene, drawn + marks.line(trail, marks.TRAIL))
            yield renderer.render().copy()


def save(pictures: Iterable[Array], path: Path, outcome: Outcome) -> list[Path]:
    """An animated GIF as fast as the episode, with what went wrong as its caption, and the last frame as a PNG."""
    from PIL import Image, ImageDraw

    frames = [Image.fromarray(picture) for picture in pictures]
    said = f"{outcome.reason}\n{_LEGEND}" if outcome.reason and _lost(outcome) else outcome.reason
    for frame in frames if said else []:
        ImageDraw.Draw(frame).text((8, 6), said, fill="white", font_size=15, stroke_width=1, stroke_fill="black")
    times = outcome.trace.times if outcome.trace else []
    period = (times[-1] - times[0]) / (len(times) - 1) if len(times) > 1 else 1.0
    path.parent.mkdir(parents=True, exist_ok=True)
    frames[-1].save(path.with_suffix(".png"))
    small = [frame.quantize(64, method=Image.Quantize.FASTOCTREE) for frame in frames]
    small[0].save(path, save_all=True, append_images=small[1:], duration=int(1000 * period), loop=0)
    return [path, path.with_suffix(".png")]


def _away(outcome: Outcome) -> bool:
    """Whether the robot waits far off in the trace, having had no place to act from."""
    return bool(outcome.episode == "interaction" and outcome.trace and outcome.trace.qpos[0][0] >= interact.FAR)


def _lost(outcome: Outcome) -> bool:
    """Whether there was no place to go to, rather than a part that opens for nobody."""
    return outcome.trace is None or _away(outcome) and outcome.failure != "blocked part"


def _on_its_way(shown: World, outcome: Outcome) -> bool:
    """Whether the robot ended before it got to what it should open."""
    found = {o.id: o for o in shown.home.objects}.get(outcome.object)
    if outcome.trace is None or found is None or _away(outcome):
        return False
    return float(np.hypot(*np.subtract(outcome.trace.qpos[-1][:2], found.center[:2]))) > DISTANCES[0]


def _start(apartment: World, outcome: Outcome) -> tuple[Trace, list[marks.Mark]]:
    """The robot at the entrance, as it was judged, and the floor that it gets to from there."""
    if outcome.episode == "navigation":
        ground = floor.survey(apartment, base.RADIUS, base.HEIGHT)
    else:
        ground = floor.survey(apartment, interact.robot.RADIUS, without=interact.room_doors(apartment))
    began, reached = goals.start(ground), np.zeros(ground.grid.shape, bool)
    if began is not None:
        reached = planner.roadmap(ground, began[0]).reached
    # Where the entrance is blocked, the robot is shown in what blocks it.
    (row, column), yaw = began or (np.argwhere(ground.space.entry)[ground.space.entry.sum() // 2], 0.0)
    x, y = float(ground.grid.x[column]), float(ground.grid.y[row])
    drawn = [*marks.floor(ground.grid, reached, marks.REACHED),
             *marks.floor(ground.grid, ground.free & ~reached, marks.CUT_OFF)]
    if outcome.trace is not None:
        stands = [x, y, yaw, *outcome.trace.qpos[0][3:]]
        return Trace(joints=outcome.trace.joints, times=[0.0], qpos=[stands]), drawn
    stands = [x, y, 0.0, np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]
    return Trace(joints=list(base.JOINTS), times=[0.0], qpos=[stands]), drawn


def _whole(shown: World, outcome: Outcome, trace: Trace) -> Trace:
    """The trace; of a part that is blocked before anything moves, then on to where it should have come."""
    if not _away(outcome):
        return trace
    *waits, met = trace.qpos[-1]
    goes = np.linspace(met, interact.OPEN * shown.model.joint(trace.joints[-1]).range[1], interact.FRAMES)
    period = trace.times[-1] / (len(trace.times) - 1)
    times = trace.times + [trace.times[-1] + period * k for k in range(1, len(goes) + 1)]
    return Trace(joints=trace.joints, times=times, qpos=trace.qpos + [[*waits, float(value)] for value in goes])


def _painted(shown: World, outcome: Outcome, trace: Trace, lost: bool) -> list[marks.Mark]:
    """Paint what the episode is about and what was met; an outline of a room that has nothing to go to."""
    if lost or outcome.episode == "navigation":
        marks.paint(shown, [outcome.object], marks.MEANT)
    elif outcome.failure == "blocked part":
        body = shown.model.joint(trace.joints[-1]).bodyid[0]
        marks.paint(shown, [shown.model.body(body).name], marks.MEANT)
    marks.paint(shown, outcome.reason.split(), marks.MET)
    rooms = [room.polygon for room in shown.home.rooms if room.id == outcome.object]
    return [mark for points in rooms for mark in marks.line([*map(np.array, points), np.array(points[0])], marks.MEANT)]


def _option() -> Any:
    option = mujoco.MjvOption()
    for group in _HIDDEN:
        option.geomgroup[group] = 0
    option.sitegroup[:] = 0
    return option


def _camera(shown: World, outcome: Outcome, above: bool) -> Any:
    """From above on the whole apartment, or near the object that is opened."""
    camera = mujoco.MjvCamera()
    found = {o.id: o for o in shown.home.objects}.get(outcome.object)
    if outcome.episode == "interaction" and found is not None and not above:
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
    for steep, far, aside in product(STEEP, DISTANCES, ASIDE):
        azimuth = np.degrees(yaw) + 180 + aside
        level = far * np.cos(np.radians(steep))
        eye = at - level * np.array([np.cos(np.radians(azimuth)), np.sin(np.radians(azimuth))])
        if floor.covers(LineString([at, eye])):
            return far, steep, azimuth
    return DISTANCES[0], -80.0, np.degrees(yaw) + 180


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
