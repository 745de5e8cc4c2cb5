"""A two-room flat small enough to work out by hand, and furniture to put in it.

    living_room_1  4 × 3 m at (0, 0)       bedroom_1  3 × 3 m at (4.1, 0)
    entrance in the west wall, y 1.0-1.9   door between them, y 1.0-1.9, opening into the bedroom
    window in the bedroom's south wall, x 5-6
"""

from typing import Any

from apartgen.schemas.plan import Opening, Plan, Program
from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint, Retrieve
from apartgen.stages.things import categories

LIVING, BEDROOM = "living_room_1", "bedroom_1"


def rectangle(x: float, y: float, width: float, depth: float) -> list[tuple[float, float]]:
    return [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]


def program() -> Program:
    return Program.model_validate({
        "rooms": [{"id": LIVING, "type": "living_room", "area": 12}, {"id": BEDROOM, "type": "bedroom", "area": 9}],
        "links": [[LIVING, BEDROOM]],
    })


def openings() -> list[Opening]:
    door = {"sill": 0, "head": 2.1}
    rows: list[dict[str, Any]] = [
        {"id": "entrance_1", "kind": "entrance", "rooms": [LIVING], "segment": [[-0.15, 1.0], [-0.15, 1.9]],
         "into": LIVING, **door},
        {"id": "door_1", "kind": "door", "rooms": [LIVING, BEDROOM], "segment": [[4.05, 1.0], [4.05, 1.9]],
         "into": BEDROOM, **door},
        {"id": "window_1", "kind": "window", "rooms": [BEDROOM], "segment": [[5, -0.15], [6, -0.15]],
         "sill": 0.9, "head": 2.1},
    ]
    return [Opening.model_validate(row) for row in rows]


def plan() -> Plan:
    rooms = [
        {"id": LIVING, "type": "living_room", "polygon": rectangle(0, 0, 4, 3)},
        {"id": BEDROOM, "type": "bedroom", "polygon": rectangle(4.1, 0, 3, 3)},
    ]
    return Plan.model_validate({"program": program(), "rooms": rooms, "openings": openings()})


def thing(
    category: str, x: float, y: float, yaw: float = 0.0, room: str = LIVING, *, id: str | None = None,
    size: tuple[float, float, float] | None = None, bottom: float | None = None, joints: tuple[Joint, ...] = (),
) -> Furnishing:
    kind = categories.TABLE[category]
    size = size or kind.size
    bottom = kind.z if bottom is None else bottom
    return Furnishing(
        id=id or f"{category}@{x:g},{y:g}", room=room, category=category, center=(x, y, bottom + size[2] / 2),
        size=size, yaw=yaw, asset=AssetKey(library="test", id=category), joints=list(joints),
    )


def drawer(size: tuple[float, float, float], travel: float = 0.4) -> Joint:
    """A drawer as large as its chest that comes out to the front."""
    d, w, h = size
    return Joint(
        name="drawer", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, travel), part="slider_drawer",
        extent=((-d / 2, -w / 2, -h / 2), (d / 2, w / 2, h / 2)),
    )


def chest(x: float, y: float, yaw: float = 0.0, room: str = LIVING, travel: float = 0.4, **more: Any) -> Furnishing:
    """A 0.5 × 1.0 × 0.8 chest whose drawer comes out by `travel`."""
    size = (0.5, 1.0, 0.8)
    return thing("chest", x, y, yaw, room, size=size, joints=(drawer(size, travel),), **more)


def home(*objects: Furnishing) -> Retrieve:
    return Retrieve(**dict(plan()), objects=list(objects))
