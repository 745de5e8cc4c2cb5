"""Layout scores of graphs worked out by hand, and the matching against brute force."""

from itertools import permutations

import handmade as h
import networkx as nx
import numpy as np
import pytest

from apartgen.schemas.plan import Program
from apartgen.stages.metrics import graph
from apartgen.stages.space import graphs
from apartgen.stages.space.graph_matching import matched


def program(rooms, links):
    return Program.model_validate({
        "rooms": [{"id": f"{kind}_{i}", "type": kind, "area": area} for kind, i, area in rooms],
        "links": [[f"{a}_{i}", f"{b}_{j}"] for (a, i), (b, j) in links],
    })


def scores(against=None, home=None):
    return {v.name: v.value for v in graph.measure(home or h.plan(), against)}


def test_the_flat_is_what_was_asked_for():
    assert scores() == pytest.approx({"S_node": 1, "S_constraint": 1, "S_edge": 1})


def test_a_missing_room_and_a_missing_door():
    rooms = [("living_room", 1, 12.0), ("bedroom", 1, 9.0), ("bathroom", 1, 4.0)]
    asked = program(rooms, [(("living_room", 1), ("bedroom", 1)), (("living_room", 1), ("bathroom", 1))])
    assert scores(asked) == pytest.approx({"S_node": 2 / 3, "S_edge": 1 / 2, "S_constraint": 1 - 4 / 25})


def test_an_open_area_leaves_the_shares_undefined():
    asked = program([("living_room", 1, None), ("bedroom", 1, 9.0)], [])
    assert scores(asked)["S_constraint"] is None
    assert scores(asked)["S_edge"] == 0


def test_equal_rooms_swapped_score_the_same():
    types = ["hallway", "living_room", "bedroom", "bedroom", "bathroom"]
    edges = {(0, 1), (0, 2), (0, 3), (3, 4)}
    swapped = {(0, 1), (0, 2), (0, 3), (2, 4)}
    pairs, found = matched(types, edges, types, swapped)
    assert found == 4 and pairs == {0: 0, 1: 1, 2: 3, 3: 2, 4: 4}


def test_equal_rooms_swapped_lose_no_score_but_lost_doors_do():
    # Built: the bathroom is off bedroom_1. Asked: off bedroom_2, which is as good; off the living room is not.
    def asked(bath_off, area=9.0):
        rooms = [("living_room", 1, 12.0), ("bedroom", 1, area), ("bedroom", 2, 9.0), ("bathroom", 1, 4.0)]
        doors = [(("living_room", 1), ("bedroom", 1)), (("living_room", 1), ("bedroom", 2))]
        return graphs.of_program(program(rooms, [*doors, (bath_off, ("bathroom", 1))]))
    built = asked(("bedroom", 1))
    assert graphs.edge_similarity(built, asked(("bedroom", 2))) == graphs.node_similarity(built, built) == 1
    assert graphs.edge_similarity(built, asked(("living_room", 1))) == pytest.approx(2 / 3)
    # Shares 18/34 against 12/28 of bedrooms, 12/34 against 12/28, 4/34 against 4/28: L1 is 2 · (18/34 - 12/28).
    assert graphs.constraint_satisfaction(built, asked(("bedroom", 1), 3.0)) == pytest.approx(1 - (18 / 34 - 12 / 28))


def test_a_plan_is_its_own_reference():
    assert scores(h.plan()) == pytest.approx({"S_node": 1, "S_constraint": 1, "S_edge": 1})


def test_a_plan_as_reference_means_its_programme():
    asked = program([("living_room", 1, 12.0), ("bedroom", 1, None), ("bathroom", 1, 4.0)],
                    [(("living_room", 1), ("bedroom", 1)), (("living_room", 1), ("bathroom", 1))])
    reference = h.plan().model_copy(update={"program": asked})
    assert scores(reference) == pytest.approx({"S_node": 2 / 3, "S_edge": 1 / 2, "S_constraint": 1 - 4 / 25})
    bare = h.plan().model_copy(update={"program": program([("bathroom", 1, 4.0)], [])})
    assert scores(bare) == pytest.approx({"S_node": 1, "S_constraint": 1, "S_edge": 1})


def brute(types_a, edges_a, types_b, edges_b):
    """Most matched edges over all maximum matchings, by trying all of them."""
    size = max(len(types_a), len(types_b))
    padded_a, padded_b = ([*types, *[None] * (size - len(types))] for types in (types_a, types_b))
    both = [(sum(a is not None and a == padded_b[j] for a, j in zip(padded_a, order)), order)
            for order in permutations(range(size))]
    most = max(n for n, _ in both)
    def edges(order):
        pairs = {i: j for i, j in enumerate(order) if padded_a[i] is not None and padded_a[i] == padded_b[j]}
        mapped = {tuple(sorted((pairs[i], pairs[j]))) for i, j in edges_a if i in pairs and j in pairs}
        return len(mapped & edges_b)
    return most, max(edges(order) for n, order in both if n == most)


@pytest.mark.parametrize("seed", range(60))
def test_the_matching_is_the_best_of_all(seed):
    rng = np.random.default_rng(seed)
    def drawn():
        n = int(rng.integers(1, 6))
        edges = {tuple(sorted(e)) for e in nx.gnp_random_graph(n, 0.5, seed=int(rng.integers(1000))).edges}
        return rng.choice(["bedroom", "bathroom", "hallway"], n).tolist(), edges
    (types_a, edges_a), (types_b, edges_b) = drawn(), drawn()
    pairs, found = matched(types_a, edges_a, types_b, edges_b)
    assert (len(pairs), found) == brute(types_a, edges_a, types_b, edges_b)
    assert all(types_a[i] == types_b[j] for i, j in pairs.items()) and len(set(pairs.values())) == len(pairs)


def test_a_large_home_is_matched_in_no_time():
    types = ["hallway", *["bedroom"] * 10, *["bathroom"] * 10]
    edges = {(0, i) for i in range(1, 11)} | {(i, i + 10) for i in range(1, 11)}
    shuffled = {(0, i) for i in range(1, 11)} | {(i, 21 - i) if 21 - i > 10 else (i, i) for i in range(1, 11)}
    assert matched(types, edges, types, shuffled)[1] == 20
