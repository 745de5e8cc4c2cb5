"""Shortest ways over cells, against networkx."""

from types import SimpleNamespace

import networkx as nx
import numpy as np
import pytest

from apartgen.stages.robot import reach, way


@pytest.mark.parametrize("seed", range(4))
def test_steps_are_the_shortest_ways_over_cells_and_their_diagonals(seed: int) -> None:
    rng = np.random.default_rng(seed)
    cells = rng.random((9, 11)) < 0.65
    start = tuple(map(int, np.argwhere(cells)[0]))
    graph = nx.Graph()
    graph.add_nodes_from(map(tuple, np.argwhere(cells)))
    for y, x in graph.nodes:
        for dy, dx in ((0, 1), (1, 0), (1, 1), (1, -1)):
            if (y + dy, x + dx) in graph:
                graph.add_edge((y, x), (y + dy, x + dx), weight=np.hypot(dy, dx))
    true = nx.single_source_dijkstra_path_length(graph, start)
    found = way._steps(cells, start, dear=0.0)
    for cell in np.ndindex(cells.shape):
        assert found[cell] == pytest.approx(true.get(cell, np.inf)), cell


def test_where_it_is_dear_to_be_near_walls_ways_keep_off_them() -> None:
    """Along a corridor seven cells wide from one cell at its wall to another, and never through what is shut."""
    cells = np.ones((7, 40), bool)
    cells[:, [0, -1]] = cells[[0, -1]] = False
    rows = {}
    for dear in (0.0, 3.0):
        steps = way._steps(cells, (1, 1), dear)
        rows[dear] = way._back(steps, (1, 38))
        assert all(cells[tuple(cell)] for cell in rows[dear]) and not np.isfinite(steps[~cells]).any()
        assert np.abs(np.diff(rows[dear], axis=0)).max() == 1
    assert set(rows[0.0][:, 0]) == {1} and rows[3.0][:, 0].max() == 3


@pytest.mark.parametrize("most", [1, 2, 5])
def test_places_of_a_room_are_few_and_far_from_one_another(most: int) -> None:
    """A room of 3 m by 2 in cells of 5 cm: the first near the middle, the second in a corner, none within .35 m."""
    axis = SimpleNamespace(x=np.arange(60) * 0.05, y=np.arange(40) * 0.05)
    rooms = np.zeros((40, 60), int)
    rooms[:, 50:] = 1
    found = way.spread_places(SimpleNamespace(grid=axis, rooms=rooms), np.ones((40, 60), bool), 0, most)
    assert len(found) == most and np.abs(found[0] - [1.225, 0.975]).max() < 0.03
    assert all(np.linalg.norm(a - b) > 0.35 for k, a in enumerate(found) for b in found[:k])
    assert most == 1 or np.linalg.norm(found[1] - found[0]) > 1.5
    few = np.zeros((40, 60), bool)
    few[3:5, 7:9] = True
    assert len(way.spread_places(SimpleNamespace(grid=axis, rooms=rooms), few, 0, most)) == 1
    assert not len(way.spread_places(SimpleNamespace(grid=axis, rooms=rooms), few, 1, most))


def cells(rows, columns, shape=(90, 90)):
    """True in such rows and columns."""
    found = np.zeros(shape, bool)
    found[rows, columns] = True
    return found


def test_a_look_at_the_surroundings_decides_only_where_one_way_leaves_them():
    """A floor of 90 by 90 cells; what is shut lies in its middle, and one comes in at a corner."""
    entry, place = cells(0, 0), cells(slice(44, 47), slice(44, 47))
    shut = cells(slice(44, 47), slice(44, 46))
    floor, island = cells(slice(0, 90), slice(0, 90)), cells(slice(40, 50), slice(40, 50))
    assert reach._locally(floor, entry, shut, place) is True
    assert reach._locally(floor, entry, place, place) is False
    assert reach._locally(island, entry, shut, place) is None, "nothing leads out: whether one gets there is unknown"
    parted = floor & ~cells(slice(0, 90), 48)
    assert reach._locally(parted, entry, shut, place) is None, "two ways lead out"
    assert reach._locally(floor, cells(45, 50), shut, place) is None, "one comes in among them"
