"""By which doors dishes come, against the shortest ways of a graph of rooms."""

import networkx
import pytest

import apartgen
from apartgen.stages.use.household import served_by

PROMPTS = ("studio", "two-bedroom flat", "three-bedroom house", "two-bedroom flat with an open kitchen", "loft",
           "three-bedroom flat with a dining room")


@pytest.mark.parametrize("prompt", PROMPTS)
def test_dishes_come_the_way_through_the_fewest_rooms(prompt: str) -> None:
    plan = apartgen.plan(prompt, seed=7).body
    rooms = networkx.Graph()
    rooms.add_nodes_from(room.id for room in plan.rooms)
    doors = {o.id: tuple(o.rooms) for o in plan.openings if o.kind in ("door", "opening") and len(o.rooms) == 2}
    rooms.add_edges_from(doors.values())
    kitchens = [room.id for room in plan.rooms if room.base == "kitchen"]
    for room in plan.rooms:
        ways = [way for kitchen in kitchens for way in networkx.all_shortest_paths(rooms, room.id, kitchen)]
        least = min(map(len, ways))
        first = {frozenset(way[:2]) for way in ways if len(way) == least > 1}
        assert set(served_by(plan, room)) == {id for id, both in doors.items() if frozenset(both) in first}
