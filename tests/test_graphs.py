"""The similarities of room graphs against values worked out by hand."""

import pytest

from apartgen.stages.space.graphs import RoomGraph, constraint_satisfaction, edge_similarity, graph, node_similarity


def flat(rooms: str, links: str = "", areas: dict[str, float] | None = None) -> RoomGraph:
    """`b1 b2 h1` with links `h1-b1`; a room's type is its letter."""
    types = {r: r[0] for r in rooms.split()}
    pairs = [(a, b) for a, b in (pair.split("-") for pair in links.split())]
    return graph(types, areas or dict.fromkeys(types, 10.0), pairs)


def test_equal_graphs_score_one_under_any_naming() -> None:
    a = flat("b1 b2 w1 w2 h1", "h1-b1 h1-b2 b1-w1 h1-w2")
    b = flat("b1 b2 w1 w2 h1", "h1-b1 h1-b2 b2-w2 h1-w1")
    assert node_similarity(a, b) == edge_similarity(a, b) == constraint_satisfaction(a, b) == 1.0


def test_a_missing_and_an_extra_room_cost_the_same() -> None:
    a, b = flat("b1 b2 h1 w1"), flat("b1 h1 w1")
    assert node_similarity(a, b) == node_similarity(b, a) == 0.75


def test_a_wrong_type_is_no_match() -> None:
    assert node_similarity(flat("b1 k1"), flat("b1 s1")) == 0.5


def test_spurious_edges_are_charged() -> None:
    a, b = flat("b1 h1 w1", "h1-b1 h1-w1 b1-w1"), flat("b1 h1 w1", "h1-b1 h1-w1")
    assert edge_similarity(a, b) == edge_similarity(b, a) == pytest.approx(2 / 3)


def test_no_edges_at_all_agree() -> None:
    assert edge_similarity(flat("b1"), flat("b1")) == 1.0
    assert edge_similarity(flat("b1 h1", "h1-b1"), flat("b1 h1")) == 0.0


def test_area_shares_by_type() -> None:
    a = flat("b1 b2 l1", areas={"b1": 10, "b2": 10, "l1": 20})
    b = flat("b1 b2 l1", areas={"b1": 15, "b2": 15, "l1": 10})
    assert constraint_satisfaction(a, b) == pytest.approx(0.75)
    assert constraint_satisfaction(a, flat("b1 b2 l1", areas={"b1": 1, "b2": 1, "l1": 2})) == pytest.approx(1.0)
