"""The home as a cloud of coloured points that were seen from within, and the text that SpatialLM writes of it."""

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.render.stands import free_air
from apartgen.stages.robot.way import spread_places
from apartgen.stages.scene.soup import Array, Hits, colors, encoded
from apartgen.stages.scene.world import HomeWorld
from apartgen.stages.space import polygons

PLACES = 6
"""Most places of a room from which points are seen."""
PROPERTIES = (*(f"property float {name}" for name in "xyz"),
              *(f"property uchar {name}" for name in ("red", "green", "blue")), "property ushort instance")
_POINT = np.dtype([("place", "<f4", 3), ("color", "u1", 3), ("instance", "<u2")])


def cloud(world: HomeWorld, count: int, height: float, rng: np.random.Generator) -> bytes:
    """A binary PLY of points with colour and number of the thing; directions are drawn evenly around each place."""
    eyes = places(world, height)
    parts = [_seen_from(world, place, share, rng) for place, share in zip(eyes, _shares(count, len(eyes)))]
    points = np.concatenate([np.zeros(0, _POINT), *parts])
    rows = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}", *PROPERTIES, "end_header"]
    return "\n".join(rows).encode() + b"\n" + points.tobytes()


def places(world: HomeWorld, height: float) -> list[Array]:
    """Where points are seen from."""
    space, cells = free_air(world, height)
    return [np.array([*at, height]) for i in range(len(world.plan.rooms))
            for at in spread_places(space, cells, i, PLACES)]


def _shares(count: int, places: int) -> list[int]:
    return [(count * (k + 1)) // places - (count * k) // places for k in range(places)]


def _seen_from(world: HomeWorld, place: Array, count: int, rng: np.random.Generator) -> NDArray[np.void]:
    way = rng.normal(size=(count, 3))
    way = (way / np.linalg.norm(way, axis=1, keepdims=True)).astype(np.float32)
    hits = world.every.first(np.broadcast_to(place.astype(np.float32), way.shape), way)
    rows = np.flatnonzero(hits.triangle >= 0)
    color, _ = colors(Hits(hits.triangle[rows], hits.distance[rows], hits.weights[rows]), world.every.soup)
    found = np.zeros(len(rows), _POINT)
    found["place"] = place + way[rows] * hits.distance[rows, None]
    found["color"] = np.rint(encoded(color) * 255)
    found["instance"] = world.every.soup.owner[hits.triangle[rows]] + 1
    return found


def written(plan: Plan) -> str:
    """Walls by room, counter-clockwise along their faces; doors and passages, windows; boxes of objects, z up, metres.

    wall_0=Wall(ax,ay,az,bx,by,bz,height,thickness)
    door_0=Door(wall_0,x,y,z,width,height) and window_0=Window(…), (x, y, z) being their middle
    bbox_0=Bbox(class,x,y,z,angle_z,length,width,height)
    """
    sides = [(room.id, np.array(a), np.array(b)) for room in plan.rooms
             for a, b in zip(room.polygon, [*room.polygon[1:], room.polygon[0]])]
    rows = [f"wall_{k}=Wall({_numbers(*a, 0, *b, 0, plan.height, 0)})" for k, (_, a, b) in enumerate(sides)]
    kinds = {"Door": [o for o in plan.openings if o.kind != "window"],
             "Window": [o for o in plan.openings if o.kind == "window"]}
    for name, some in kinds.items():
        for k, o in enumerate(some):
            wall, middle = _wall(o, sides)
            values = _numbers(*middle, (o.sill + o.head) / 2, polygons.width(o), o.head - o.sill)
            rows.append(f"{name.lower()}_{k}={name}(wall_{wall},{values})")
    objects = plan.objects if isinstance(plan, Layout) else []
    rows += [f"bbox_{k}=Bbox({o.category},{_numbers(*o.center, o.yaw, *o.size)})" for k, o in enumerate(objects)]
    return "\n".join(rows) + "\n"


def _numbers(*values: float) -> str:
    return ",".join(f"{value + 0.0:.4f}".rstrip("0").rstrip(".") for value in values)


def _wall(o: Opening, sides: list[tuple[str, Array, Array]]) -> tuple[int, Array]:
    """The side of its first room nearest to an opening, and the opening's middle on it."""
    middle = np.mean(np.asarray(o.segment, float), axis=0)
    found = []
    for k, (room, a, b) in enumerate(sides):
        if room == (o.into or o.rooms[0]):
            along = (b - a) / np.linalg.norm(b - a)
            at = a + along * float(np.clip((middle - a) @ along, 0, np.linalg.norm(b - a)))
            found.append((float(np.linalg.norm(at - middle)), k, at))
    _, wall, at = min(found, key=lambda one: one[:2])
    return wall, at
