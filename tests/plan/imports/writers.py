"""Small writers of formats that are only read, made from their definitions: Sweet Home 3D, RoomPlan, ProcTHOR."""

import io
import json
import zipfile
from xml.sax.saxutils import quoteattr

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Opening, Plan

WORDS = {"living_room": "Living room", "bedroom": "Bedroom", "kitchen": "Kitchen", "bathroom": "Bathroom",
         "hallway": "Hallway", "study": "Study", "utility": "Utility room", "storage": "Storage", "closet": "Closet",
         "dining_room": "Dining room", "balcony": "Balcony"}  # fmt: skip


def sides(plan: Plan) -> list[tuple[np.ndarray, np.ndarray, float]]:
    """Walls as axes with a thickness: an inner one midway to the room across, an outer one half of it outside."""
    floors = {room.id: Polygon(room.polygon) for room in plan.rooms}
    found = []
    for room in plan.rooms:
        ring = np.array([*room.polygon, room.polygon[0]], float)
        steps = np.diff(ring, axis=0)
        convex = np.cross(np.roll(steps, 1, axis=0), steps) > 0
        for k, (a, b) in enumerate(zip(ring, ring[1:])):
            unit = (b - a) / np.hypot(*(b - a))
            out = np.array([unit[1], -unit[0]])
            length, corner = float(np.hypot(*(b - a))), (convex[k], convex[(k + 1) % len(convex)])
            cuts = _cuts(a, b, out, floors, room.id)
            for (lo, other), (hi, _) in zip(cuts, cuts[1:]):
                thick = plan.walls.inner if other else plan.walls.outer
                if other is None or other > room.id:
                    before, beyond = lo < 0.01 and corner[0], hi > length - 0.01 and corner[1]
                    ends = a + (lo - before * plan.walls.inner) * unit, a + (hi + beyond * plan.walls.inner) * unit
                    found.append((*(end + thick / 2 * out for end in ends), thick))
    return found


def _cuts(a, b, out, floors, own):
    """Where along an edge another room, or none, begins to lie across the wall; the end closes the list."""
    length = float(np.hypot(*(b - a)))
    at = np.arange(0.005, length, 0.01)
    cuts, last = [], "?"
    for t in at:
        p = a + t / length * (b - a)
        probe = LineString([p + 0.01 * out, p + 0.45 * out])
        now = next((id for id, floor in floors.items() if id != own and floor.intersects(probe)), None)
        if now != last:
            cuts.append((float(t) - 0.005, now))
            last = now
    ends = [*(t for t, _ in cuts[1:]), length]
    return [*(cut for cut, end in zip(cuts, ends) if cut[1] or end - cut[0] > 0.15), (length, None)]


def _leaf(o: Opening, plan: Plan):
    """Hinge, free end of the open leaf."""
    ends, room = np.array(o.segment), Polygon(next(r for r in plan.rooms if r.id == o.into).polygon)
    along = ends[1 - o.hinge] - ends[o.hinge]
    normal = np.array([-along[1], along[0]])
    if Point(ends[o.hinge] + 0.5 * along + 0.5 * normal).distance(room) > Point(
        ends[o.hinge] + 0.5 * along - 0.5 * normal
    ).distance(room):
        normal = -normal
    return ends[o.hinge], ends[o.hinge] + normal


def sh3d(home: Layout, rooms: bool = True, names: dict[str, str] | None = None) -> bytes:
    """A zip with Home.xml: centimetres, y down."""
    rows = [f"<home version='7200' name='test' wallHeight='{home.height * 100:.3f}'>"]
    for k, o in enumerate(home.openings):
        (ax, ay), (bx, by) = o.segment
        width, angle = np.hypot(bx - ax, by - ay), np.arctan2(-(by - ay), bx - ax)
        name = {"window": "Window", "opening": "Door frame"}.get(o.kind, "Door")
        sash = ""
        if o.into:
            hinge, free = _leaf(o, home)
            local = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
            x = (np.array([hinge[0], -hinge[1]]) - [(ax + bx) / 2, -(ay + by) / 2]) @ local
            d = (np.array([free[0], -free[1]]) - [hinge[0], -hinge[1]]) @ local
            sash = (
                f"<sash xAxis='{x[0] / width + 0.5:.4f}' yAxis='0.5' width='1' startAngle='0' "
                f"endAngle='{np.arctan2(-d[1], d[0]):.5f}'/>"
            )
        rows.append(
            f"<doorOrWindow id='d{k}' catalogId='eTeks#{name.replace(' ', '').lower()}' name={quoteattr(name)} "
            f"x='{50 * (ax + bx):.4f}' y='{-50 * (ay + by):.4f}' angle='{angle:.6f}' width='{100 * width:.4f}' "
            f"depth='20' height='{100 * (o.head - o.sill):.3f}' elevation='{100 * o.sill:.3f}'>{sash}</doorOrWindow>"
        )
    for o in home.objects:
        d, w, h = (100 * v for v in o.size)
        angle = -o.yaw - np.pi / 2
        rows.append(
            f"<pieceOfFurniture name='{o.category.replace('_', ' ')}' x='{100 * o.center[0]:.3f}' "
            f"y='{-100 * o.center[1]:.3f}' angle='{angle:.6f}' width='{w:.3f}' depth='{d:.3f}' height='{h:.3f}' "
            f"elevation='{100 * o.center[2] - h / 2:.3f}'/>"
        )
    for k, (a, b, thick) in enumerate(sides(home)):
        rows.append(
            f"<wall id='w{k}' xStart='{100 * a[0]:.4f}' yStart='{-100 * a[1]:.4f}' xEnd='{100 * b[0]:.4f}' "
            f"yEnd='{-100 * b[1]:.4f}' height='{100 * home.height}' thickness='{100 * thick:.3f}'/>"
        )
    for room in home.rooms if rooms else []:
        name = (names or WORDS).get(room.type, "")
        rows.append(
            f"<room name={quoteattr(name)}>"
            + "".join(f"<point x='{100 * x:.4f}' y='{-100 * y:.4f}'/>" for x, y in room.polygon)
            + "</room>"
        )
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("Home.xml", "<?xml version='1.0'?>\n" + "\n".join([*rows, "</home>"]))
    return out.getvalue()


def _placed(x, y, z, across, height_first=True):
    """A RoomPlan transform, column-major, y up: own x across, own y up."""
    ux, uy = across
    x_axis, y_axis = np.array([ux, 0, -uy]), np.array([0, 1, 0])
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2] = x_axis, y_axis, np.cross(x_axis, y_axis)
    matrix[:3, 3] = x, z, -y
    return matrix.T.ravel().round(6).tolist()


LABELS = {
    "living_room": "livingRoom",
    "bedroom": "bedroom",
    "kitchen": "kitchen",
    "bathroom": "bathroom",
    "dining_room": "diningRoom",
}
APPLE = {
    "double_bed": "bed",
    "wardrobe": "storage",
    "sofa": "sofa",
    "fridge": "refrigerator",
    "chair": "chair",
    "toilet": "toilet",
}


def roomplan(home: Layout) -> bytes:
    """A CapturedStructure as JSON: floors at their clear outline, walls without thickness."""

    def surface(kind, a, b, low, high, more=()):
        a, b = np.array(a), np.array(b)
        width = float(np.hypot(*(b - a)))
        x, y = (a + b) / 2
        return {
            "identifier": f"{kind}-{x:.2f}-{y:.2f}",
            "category": {kind: dict(more)},
            "dimensions": [width, high - low, 0],
            "transform": _placed(x, y, (low + high) / 2 - 1.3, (b - a) / width),
            "story": 0,
        }

    floors, sections, walls = [], [], []
    for room in home.rooms:
        middle = Polygon(room.polygon).representative_point()
        lying = (
            np.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [middle.x, -1.3, -middle.y, 1]], float)
            .ravel()
            .tolist()
        )
        floors.append(
            {
                "category": {"floor": {}},
                "dimensions": [1, 1, 0],
                "transform": lying,
                "story": 0,
                "polygonCorners": [[x - middle.x, middle.y - y, 0] for x, y in room.polygon],
            }
        )
        sections.append(
            {"label": LABELS.get(room.type, "unidentified"), "center": [middle.x, -1.3, -middle.y], "story": 0}
        )
        for a, b in zip(room.polygon, [*room.polygon[1:], room.polygon[0]]):
            walls.append(surface("wall", a, b, 0, home.height))
    parts = {"door": [], "window": [], "opening": []}
    for o in home.openings:
        kind = {"entrance": "door"}.get(o.kind, o.kind)
        parts[kind].append(surface(kind, *o.segment, o.sill, o.head, [("isOpen", False)] if kind == "door" else []))
    objects = [
        {
            "category": {APPLE[o.category]: {}},
            "dimensions": [o.size[1], o.size[2], o.size[0]],
            "story": 0,
            "transform": _placed(o.center[0], o.center[1], o.center[2] - 1.3, (-np.sin(o.yaw), np.cos(o.yaw))),
        }
        for o in home.objects
        if o.category in APPLE
    ]
    return json.dumps(
        {
            "version": 2,
            "walls": walls,
            "floors": floors,
            "sections": sections,
            "doors": parts["door"],
            "windows": parts["window"],
            "openings": parts["opening"],
            "objects": objects,
        }
    ).encode()


def procthor(home: Layout) -> bytes:
    """A house with walls as sheets, as published ones: halfway to the room across, or on the room's own outline."""
    kinds = {"living_room": "LivingRoom", "bedroom": "Bedroom", "kitchen": "Kitchen", "bathroom": "Bathroom"}
    rooms, walls, doors, windows = [], [], [], []
    rings = {}
    half = home.walls.inner / 2
    inside = (
        unary_union([Polygon(room.polygon) for room in home.rooms])
        .buffer(half, join_style="mitre")
        .buffer(-half, join_style="mitre")
    )
    for room in home.rooms:
        grown = orient(Polygon(room.polygon).buffer(half, join_style="mitre").intersection(inside).simplify(1e-6))
        rings[room.id] = np.array(grown.exterior.coords)
        rooms.append(
            {
                "id": room.id,
                "roomType": kinds.get(room.type, room.type),
                "floorPolygon": [{"x": x, "y": 0, "z": y} for x, y in rings[room.id][:-1]],
            }
        )
        for k, (a, b) in enumerate(zip(rings[room.id], rings[room.id][1:])):
            walls.append(
                {
                    "id": f"wall|{room.id}|{k}",
                    "polygon": [{"x": float(x), "y": z, "z": float(y)} for z in (0, home.height) for x, y in (a, b)],
                }
            )
    for o in home.openings:
        ring, middle = rings[o.rooms[0]], np.mean(o.segment, axis=0)
        k = min(
            range(len(ring) - 1),
            key=lambda k: LineString(ring[k : k + 2]).distance(LineString([middle, middle + 1e-6])),
        )
        at = (middle - ring[k]) @ (ring[k + 1] - ring[k]) / np.hypot(*(ring[k + 1] - ring[k]))
        half = np.hypot(*np.subtract(*o.segment)) / 2
        row = {
            "id": o.id,
            "wall0": f"wall|{o.rooms[0]}|{k}",
            "room0": o.rooms[0],
            "room1": o.rooms[-1],
            "assetId": "Doorframe_1" if o.kind == "opening" else "Doorway_1",
            "holePolygon": [{"x": at - half, "y": o.sill, "z": 0}, {"x": at + half, "y": o.head, "z": 0}],
        }
        (windows if o.kind == "window" else doors).append(row)
    objects = [
        {
            "id": o.id,
            "assetId": f"{o.category.title()}_1",
            "children": [],
            "position": {"x": o.center[0], "y": o.center[2], "z": o.center[1]},
            "rotation": {"x": 0, "y": 90 - np.degrees(o.yaw), "z": 0},
            "boundingBox": {"x": o.size[1], "y": o.size[2], "z": o.size[0]},
        }
        for o in home.objects
    ]
    return json.dumps(
        {"rooms": rooms, "walls": walls, "doors": doors, "windows": windows, "objects": objects, "metadata": {}}
    ).encode()
