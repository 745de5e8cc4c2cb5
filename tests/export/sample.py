"""A small furnished flat and a library of plain boxes that open, to export."""

import numpy as np

from apartgen.schemas.plan import AskedRoom, Opening, Plan, Program, Room
from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint
from apartgen.schemas.walkable import Report, Walkable
from apartgen.stages.things import categories, solids
from apartgen.stages.things.asset import Asset, Collider, Link
from apartgen.stages.things.materials import PALETTE

ROOMS = {
    "living_room_1": ("living_room", (0.0, 0.0, 5.2, 4.0)),
    "bedroom_1": ("bedroom", (5.3, 0.0, 9.0, 4.0)),
    "hallway_1": ("hallway", (2.6, 4.1, 9.0, 5.5)),
    "bathroom_1": ("bathroom", (0.0, 4.1, 2.5, 6.4)),
}


def plan() -> Plan:
    """Four rooms, three doors, an entrance, three windows."""
    rooms = [
        Room(id=id, type=kind, polygon=[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
        for id, (kind, (x0, y0, x1, y1)) in ROOMS.items()
    ]
    door = {"kind": "door", "sill": 0.0, "head": 2.05}
    window = {"kind": "window", "sill": 0.9, "head": 2.2}
    openings = [
        Opening(id="door_1", rooms=["hallway_1", "living_room_1"], segment=((3.2, 4.05), (4.1, 4.05)), hinge=1,
                into="living_room_1", **door),
        Opening(id="door_2", rooms=["hallway_1", "bedroom_1"], segment=((5.5, 4.05), (6.3, 4.05)), hinge=0,
                into="bedroom_1", **door),
        Opening(id="door_3", rooms=["hallway_1", "bathroom_1"], segment=((2.55, 4.3), (2.55, 5.1)), hinge=0,
                into="hallway_1", **door),
        Opening(id="entrance", kind="entrance", rooms=["hallway_1"], segment=((9.15, 4.3), (9.15, 5.2)), hinge=0,
                into="hallway_1", sill=0.0, head=2.1),
        Opening(id="window_1", rooms=["living_room_1"], segment=((1.2, -0.15), (3.6, -0.15)), **window),
        Opening(id="window_2", rooms=["bedroom_1"], segment=((6.2, -0.15), (8.0, -0.15)), **window),
        Opening(id="window_3", rooms=["bathroom_1"], segment=((0.8, 6.55), (1.6, 6.55)), **window),
    ]
    asked = [AskedRoom(id=id, type=kind) for id, (kind, _) in ROOMS.items()]
    return Plan(prompt="a small flat", program=Program(rooms=asked), rooms=rooms, openings=openings)


PLACED = [  # category, room, x, y, yaw in quarter turns, bottom
    ("sofa", "living_room_1", 0.46, 2.0, 0, 0.0), ("rug", "living_room_1", 2.2, 2.0, 0, 0.0),
    ("coffee_table", "living_room_1", 1.9, 2.0, 0, 0.0), ("tv_stand", "living_room_1", 4.98, 2.0, 2, 0.0),
    ("tv", "living_room_1", 4.98, 2.0, 2, 0.5), ("plant", "living_room_1", 0.3, 3.7, 0, 0.0),
    ("chair", "living_room_1", 2.6, 0.8, 0, 0.0), ("ceiling_lamp", "living_room_1", 2.6, 2.0, 0, 2.2),
    ("double_bed", "bedroom_1", 7.95, 1.9, 2, 0.0), ("nightstand", "bedroom_1", 8.79, 0.75, 2, 0.0),
    ("display_cabinet", "bedroom_1", 5.51, 1.5, 0, 0.0), ("bin", "bedroom_1", 6.0, 0.3, 0, 0.0),
    ("shoe_cabinet", "hallway_1", 7.0, 5.36, 3, 0.0), ("wall_lamp", "hallway_1", 5.0, 5.43, 3, 1.65),
    ("toilet", "bathroom_1", 0.33, 5.2, 0, 0.0), ("vanity", "bathroom_1", 1.4, 4.34, 1, 0.0),
    ("bath", "bathroom_1", 1.2, 6.02, 3, 0.0),
]  # fmt: skip


def home() -> Walkable:
    """The flat with 17 objects, seven of which open."""
    objects = []
    for k, (category, room, x, y, quarter, bottom) in enumerate(PLACED, 1):
        size, joints = categories.TABLE[category].size, load("plain", category).joints
        objects.append(
            Furnishing(
                id=f"{category}_{k}", room=room, category=category, center=(x, y, bottom + size[2] / 2), size=size,
                yaw=quarter * np.pi / 2, asset=AssetKey(library="plain", id=category), joints=joints,
            )
        )
    report = Report(target=0.2, before=0.3, after=0.3)
    return Walkable(**plan().model_dump(), objects=[o.model_dump() for o in objects], walkable=report)


def load(library: str, id: str) -> Asset:
    """A closed box for what doesn't open, else a carcass with a leaf, drawer, flap or lid."""
    kind = categories.TABLE[id]
    size = np.array(kind.size)
    half = size / 2
    make = {"leaf": _leaf, "drawer": _drawer, "flap": _flap, "lid": _lid}.get(kind.opens)
    links = make(half) if make else [_box("base", -half, half, "oak")]
    return Asset(library, id, id, "plain", kind.size, links, credit="Plain boxes, public domain")


def _box(name, lo, hi, material, joint=None) -> Link:
    lo, hi = np.asarray(lo, float), np.asarray(hi, float)
    mass = 80 * float(np.prod(hi - lo))
    return Link(name, [solids.box(lo, hi, PALETTE[material])], [solids.slab(lo, hi)], mass, joint)


def _moving(name, lo, hi, type_, axis, origin, top) -> Link:
    extent = (tuple(map(float, lo)), tuple(map(float, hi)))
    joint = Joint(name=name, type=type_, axis=axis, origin=origin, range=(0.0, top), part=name, extent=extent)
    return _box(name, lo, hi, "white", joint)


def _leaf(half) -> list[Link]:
    """Hinged about its left edge, opening outward."""
    x, y, z = half
    leaf = _moving("door", (x - 0.02, -y, -z + 0.01), (x, y, z - 0.01), "hinge", (0, 0, 1), (x, y, 0), np.pi / 2)
    hull = Collider("hull", np.zeros(3), 2 * half, vertices=np.array(
        [[a, b, c] for a in (-x, x - 0.03) for b in (-y, y) for c in (-z, z)]))
    base = _box("base", (-x, -y, -z), (x - 0.03, y, z), "oak")
    return [Link("base", base.visuals, [hull], base.mass), leaf]


def _drawer(half) -> list[Link]:
    x, y, z = half
    drawer = _moving("drawer", (0.0, -y + 0.02, 0.0), (x, y - 0.02, z - 0.03), "slide", (1, 0, 0), (0, 0, 0), x)
    return [_box("base", (-x, -y, -z), (x, y, -0.01), "oak"), drawer]


def _flap(half) -> list[Link]:
    x, y, z = half
    flap = _moving("flap", (x - 0.02, -y, -z + 0.05), (x, y, 0), "hinge", (0, 1, 0), (x, 0, -z + 0.05), np.pi / 4)
    return [_box("base", (-x, -y, -z), (x - 0.03, y, z), "oak"), flap]


def _lid(half) -> list[Link]:
    x, y, z = half
    lid = _moving("lid", (-x, -y, z - 0.02), (x, y, z), "hinge", (0, -1, 0), (-x, 0, z), np.pi / 3)
    return [_box("base", (-x, -y, -z), (x, y, z - 0.03), "porcelain"), lid]
