"""Why things are where they are, in words: what asked for them, what they stand on and by, what was changed and why."""

from collections import defaultdict
from typing import Any

import numpy as np
import shapely
from shapely.geometry import LineString

from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Populate, Thing
from apartgen.schemas.retrieve import Furnishing
from apartgen.schemas.walkable import Placement, Report, Shift, Step, Walkable
from apartgen.stages.space import boxes, polygons
from apartgen.stages.things.categories import TABLE

AT_WALL = 0.08
"""A back that is nearer to a wall stands at it, m."""
BESIDE = 0.6
"""What belongs to a thing is told if it is nearer, m."""
AHEAD = 4.0
"""How far it is looked what a thing looks at, m."""
CARRIERS = {"floor": "stands on the floor", "wall": "hangs on a wall", "ceiling": "hangs from the ceiling"}

Words = dict[str, list[str]]


def about(home: Plan, o: Box) -> list[list[str]]:
    """Facts of a thing by name."""
    found = []
    if isinstance(o, Furnishing) and o.joints:
        found.append(["opens", ", ".join(f"{joint.name} ({joint.part.replace('_', ' ')})" for joint in o.joints)])
    if isinstance(home, Populate) and o.id in home.states:
        states = home.states[o.id].items()
        found.append(["state", ", ".join(f"{name.replace('_', ' ')}: {value}" for name, value in states)])
    return found


def reasons(home: Plan) -> Words:
    """Sentences for each object, by its id."""
    if not isinstance(home, Layout):
        return {}
    found: Words = defaultdict(list)
    floors = {room.id: polygons.floor(room) for room in home.rooms}
    for o in home.objects:
        found[o.id] += _asked(home, o) + _carried(o)
        if o.category in TABLE and o.room in floors:
            found[o.id] += _placed(o, home.objects, floors[o.room])
    for step in _steps(home):
        for shift in (_own(step), *step.along):
            found[shift.object].append(f"{_changed(shift)} {_purpose(step)}")
    return dict(found)


def steps(home: Plan) -> list[dict[str, Any]]:
    """What the walkable stage did, in order: in words, and where things were before and after."""
    found = []
    for step in _steps(home):
        shifts = [{"id": s.object, "before": _place(s.before), "after": _place(s.after)}
                  for s in (_own(step), *step.along)]
        words = f"{_spoken(step.object)} {_changed(_own(step))} {_purpose(step)}"
        found.append({"words": words, "shifts": shifts})
    return found


def numbers(home: Plan) -> list[list[str]]:
    """What is told of the whole home."""
    objects = home.objects if isinstance(home, Layout) else []
    small = sum(isinstance(o, Thing) for o in objects)
    moving = sum(len(o.joints) for o in objects if isinstance(o, Furnishing))
    area = sum(polygons.floor(room).area for room in home.rooms)
    found = [["rooms", str(len(home.rooms))], ["floor", f"{area:.1f} m²"], ["furniture", str(len(objects) - small)],
             ["small things", str(small)], ["parts that move", str(moving)]]
    report = _report(home)
    if report is not None:
        found += [["free floor that a robot gets to", f"{report.before:.0%} before, {report.after:.0%} after"],
                  ["not reached", str(len(report.unreached))], ["does not open fully", str(len(report.blocked))]]
    return found


def _report(home: Plan) -> Report | None:
    return home.walkable if isinstance(home, Walkable | Populate) else None


def _steps(home: Plan) -> list[Step]:
    report = _report(home)
    return report.steps if report else []


def _own(step: Step) -> Shift:
    return Shift(object=step.object, before=step.before, after=step.after)


def _place(at: Placement | None) -> dict[str, Any] | None:
    return None if at is None else {"center": at.center, "size": at.size, "yaw": at.yaw}


def _spoken(name: str) -> str:
    return name.replace("_", " ")


def _changed(shift: Shift) -> str:
    """What became of a thing."""
    if shift.after is None:
        return "was taken away"
    moved = np.linalg.norm(np.subtract(shift.after.center[:2], shift.before.center[:2]))
    smaller = [f"{100 * a:.0f} → {100 * b:.0f} cm {side}" for a, b, side in
               zip(shift.before.size, shift.after.size, ("deep", "wide", "high")) if abs(a - b) > 5e-3]
    told = [f"moved {100 * moved:.0f} cm"] if moved > 5e-3 else []
    told += ["made " + ", ".join(smaller)] if smaller else []
    return "was " + " and ".join(told) if told else "was given another design"


def _purpose(step: Step) -> str:
    if step.reason == "ratio":
        return "for more free floor"
    if step.reason == step.object:
        return "as it could not be got to or used there"
    return f"so that {_spoken(step.reason)} can be got to and used"


def _asked(home: Plan, o: Box) -> list[str]:
    wanted = [w for w in home.program.objects if w.room == o.room and w.category == o.category]
    return [f"asked for: {w.count} × {_spoken(w.category)}" for w in wanted]


def _carried(o: Box) -> list[str]:
    if isinstance(o, Thing) and o.in_ is not None:
        return [f"kept in {_spoken(o.in_.object)} ({_spoken(o.in_.receptacle)})"]
    if o.on is None:
        return []
    return [CARRIERS.get(o.on, f"stands on {_spoken(o.on)}")]


def _placed(o: Box, objects: list[Any], floor: shapely.Polygon) -> list[str]:
    """How a thing stands to walls and others of its room."""
    kind, found = TABLE[o.category], []
    heading = np.array([np.cos(o.yaw), np.sin(o.yaw)])
    back = np.asarray(o.center[:2]) - heading * o.size[0] / 2
    if kind.back and floor.exterior.distance(shapely.Point(back)) < AT_WALL:
        found.append("its back is at a wall")
    others = [p for p in objects if p.room == o.room and p.id != o.id and p.category in TABLE
              and TABLE[p.category].place == "floor"]
    shape = _shape(o)
    near = sorted((float(shape.distance(_shape(p))), p.id) for p in others if p.category in kind.belongs)
    found += [f"belongs to {_spoken(name)}, {100 * gap:.0f} cm from it" for gap, name in near[:1] if gap < BESIDE]
    if kind.faces and kind.place == "floor":
        front = np.asarray(o.center[:2]) + heading * o.size[0] / 2
        ray = LineString([front, front + heading * AHEAD])
        met = sorted((float(shapely.Point(front).distance(part)), p.id) for p in others
                     if not (part := ray.intersection(_shape(p))).is_empty)
        found += [f"before it is {_spoken(name)}, {gap:.1f} m away" for gap, name in met[:1]]
    return found


def _shape(o: Box) -> shapely.Polygon:
    return shapely.Polygon(boxes.corners(boxes.of([o]))[0])
