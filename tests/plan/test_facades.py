"""A flat is in a building: windows on one to three sides, in by a party side, balconies before glazed doors, railed.

Everything is measured on the finished plan by sides of boxes and points in polygons, with nothing of the planner.
"""

from functools import cache

import numpy as np
import pytest
from shapely.geometry import MultiPoint, Point, Polygon

from apartgen.schemas.plan import Opening, Plan, Program, Requirement
from apartgen.stages.plan import PlanConfig, build
from apartgen.stages.plan.problem import whim
from apartgen.stages.scene import shell

SEEDS = range(40)
AWAY = {"south": (0, -1), "east": (1, 0), "north": (0, 1), "west": (-1, 0)}


@cache
def flat(seed: int) -> Plan:
    """A living room with a kitchen in it and a balcony, a bedroom, a bathroom, a hallway."""
    rooms = [
        ("hallway_1", 5),
        ("living_room_1", 22),
        ("kitchen_1", 8),
        ("bedroom_1", 13),
        ("bathroom_1", 5),
        ("balcony_1", 5),
    ]
    program = Program(
        rooms=[{"id": id, "type": id[:-2], "area": area} for id, area in rooms],
        links=[("hallway_1", "living_room_1"), ("hallway_1", "bedroom_1"), ("hallway_1", "bathroom_1"),
               ("living_room_1", "balcony_1")],
        open_links=[("living_room_1", "kitchen_1")], complete=True,
    )  # fmt: skip
    return build(program, PlanConfig(processes=1), np.random.default_rng(seed))


def floor(plan: Plan, id: str) -> Polygon:
    return Polygon(next(room.polygon for room in plan.rooms if room.id == id))


def side(o: Opening, plan: Plan) -> str:
    """The side of its room that an opening is on: opposite to where the room is."""
    (ax, ay), (bx, by) = o.segment
    x, y = (ax + bx) / 2, (ay + by) / 2
    room, away = floor(plan, o.rooms[0]), plan.walls.outer
    sides = [name for name, (dx, dy) in AWAY.items() if room.contains(Point(x - away * dx, y - away * dy))]
    (found,) = [name for name in sides if (name in ("south", "north")) == (abs(by - ay) < 1e-6)]
    return found


@pytest.mark.parametrize("seed", SEEDS)
def test_windows_are_on_one_to_three_sides_and_one_comes_in_by_another(seed: int) -> None:
    plan = flat(seed)
    around = plan.program.envelope
    glazed = {side(o, plan) for o in plan.openings if o.kind == "window"}
    ways = [side(o, plan) for o in plan.openings if o.kind == "entrance"]
    assert around.facades is not None and 1 <= len(glazed) <= around.facades <= 4
    assert not glazed & set(around.party_walls) and len(around.party_walls) == 4 - around.facades
    assert len(ways) == 1 and (around.facades == 4 or ways[0] in around.party_walls)


def test_most_flats_have_neighbours() -> None:
    counts = [flat(seed).program.envelope.facades for seed in SEEDS]
    assert {1, 2, 3} >= set(counts) or counts.count(4) <= 2
    assert 1 < np.mean(counts) < 3.5 and len(set(counts)) > 1


@pytest.mark.parametrize("seed", SEEDS)
def test_a_balcony_hangs_before_a_glazed_door(seed: int) -> None:
    plan = flat(seed)
    balcony, living = floor(plan, "balcony_1"), floor(plan, "living_room_1")
    assert balcony.distance(living) == pytest.approx(plan.walls.outer, abs=2e-3)
    others = [floor(plan, room.id) for room in plan.rooms if room.id not in ("balcony_1", "living_room_1")]
    assert min(balcony.distance(other) for other in others) > plan.walls.outer - 2e-3
    (door,) = [o for o in plan.openings if "balcony_1" in o.rooms]
    assert door.kind == "door" and set(door.rooms) == {"balcony_1", "living_room_1"} and door.head > 2.15
    on = [
        name
        for name, (dx, dy) in AWAY.items()
        if balcony.contains(Point(np.mean(door.segment, axis=0) + 0.3 * np.array([dx, dy])))
    ]
    assert not set(on) & set(plan.program.envelope.party_walls)


@pytest.mark.parametrize("seed", SEEDS[:8])
def test_a_railing_keeps_one_on_the_balcony(seed: int) -> None:
    """Along the sides that are free, something stands from the floor to 1.05 m, and nothing at 1.4 m."""
    plan = flat(seed)
    balcony, living = floor(plan, "balcony_1"), floor(plan, "living_room_1")
    solids = [
        _solid(collider)
        for body in shell.bodies(plan, shown=False)
        for link in body.links
        for collider in link.colliders
        if body.kind == "wall"
    ]
    rim = balcony.buffer(0.025, join_style="mitre").exterior
    points = [rim.interpolate(share, normalized=True) for share in np.linspace(0, 0.99, 40)]
    free = [point for point in points if point.distance(living) > plan.walls.outer + 0.1]
    assert len(free) > 15
    for height, stands in ((0.05, True), (1.05, True), (1.4, False)):
        met = [any(lo <= height <= hi and mark.buffer(1e-3).contains(p) for mark, lo, hi in solids) for p in free]
        assert all(met) if stands else not any(met)


def _solid(collider) -> tuple[Polygon, float, float]:
    """What an upright convex piece stands on, and from where to where it reaches."""
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * collider.size
    corners = corners if collider.vertices is None else collider.vertices
    corners = corners @ np.asarray(collider.rotation).T + collider.center
    return MultiPoint(corners[:, :2]).convex_hull, float(corners[:, 2].min()), float(corners[:, 2].max())


def studio(seed: int) -> Plan:
    """One room to live and sleep in, with a kitchen and a bathroom at it."""
    program = Program(
        rooms=[{"id": f"{type}_1", "type": type, "area": area}
               for type, area in (("living_room", 24), ("kitchen", 6), ("bathroom", 4))],
        links=[("living_room_1", "bathroom_1")], open_links=[("living_room_1", "kitchen_1")], complete=True,
    )  # fmt: skip
    return build(program, PlanConfig(processes=1), np.random.default_rng(seed))


def test_where_one_comes_in_to_where_one_sleeps_bath_and_kitchen_are_near() -> None:
    plans = [studio(seed) for seed in range(24)]
    doors = [MultiPoint(o.segment).centroid for plan in plans for o in plan.openings if o.kind == "entrance"]
    away = [min(door.distance(floor(plan, room)) for room in ("kitchen_1", "bathroom_1"))
            for door, plan in zip(doors, plans, strict=True)]  # fmt: skip
    assert sum(a < 1.5 for a in away) >= 14 and np.mean(away) < 2.2


@pytest.mark.parametrize("place", ["north", "south_west", "east", "left"])
def test_a_balcony_has_a_facade_at_the_side_that_is_asked_for(place: str) -> None:
    """A party wall there, drawn before, was the commonest reason why it hung elsewhere."""
    plain = flat(0).program
    envelope = {"facades": None, "party_walls": [], "entrance": None}
    asked = Requirement(id="x", kind="position", of="balcony_1", value=place)
    program = plain.model_copy(update={
        "requirements": [asked], "envelope": plain.envelope.model_copy(update=envelope)})

    def walls(of: Program) -> list[set[str]]:
        drawn = (whim(of, PlanConfig().walls, 0, np.random.default_rng(seed)) for seed in range(40))
        return [set(one.envelope.party_walls) for one in drawn]

    sides = {"west"} if place == "left" else set(place.split("_"))
    assert not any(sides <= some for some in walls(program))
    assert any(sides <= some for some in walls(program.model_copy(update={"requirements": []})))
