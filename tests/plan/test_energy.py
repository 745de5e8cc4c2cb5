"""What an arrangement costs: terms by hand, and measures that belong to the state an annealing run ends with."""

import numpy as np
import pytest

from apartgen.schemas.plan import Program, Walls
from apartgen.stages.plan import PlanConfig, kernel
from apartgen.stages.plan.blocks import given
from apartgen.stages.plan.outline import draw
from apartgen.stages.plan.problem import (
    ALONE,
    LONE,
    QUIET,
    WHIM,
    Slack,
    Whim,
    copy,
    gross_area,
    problem,
    scratch,
    weighed,
    whim,
)
from apartgen.stages.plan.slicing import (
    AREA,
    ASPECT,
    CONCISE,
    LACKING,
    NEAR,
    PATH,
    PRIVACY,
    R_LEAST,
    R_WIDTH,
    WIDE,
    Floats,
    Problem,
    Scratch,
    Tree,
)
from apartgen.stages.plan.starts import known, start
from apartgen.stages.plan.study import archetypes
from apartgen.stages.plan.terms import BLIND, BROADER

BARE = Walls(inner=0.1, outer=0.3)


def energy(p: Problem, tree: Tree, steps: int = 0, seed: int = 1) -> tuple[float, Floats, Tree]:
    """Cost, terms and state at the end of a run; of no steps, so of the tree itself, unless told."""
    z = scratch(p, len(tree.share) - 1)
    best = copy(tree)
    cost = kernel.anneal(p, copy(tree), copy(tree), best, z, np.array([seed], np.uint64), steps, 20.0, 1.0)
    return float(cost), z.terms, best


def measured(p: Problem, tree: Tree) -> Scratch:
    """What a tree's rooms measure."""
    z = scratch(p, len(tree.share) - 1)
    kernel.anneal(p, copy(tree), copy(tree), copy(tree), z, np.array([1], np.uint64), 0, 20.0, 1.0)
    return z


def row_of_three() -> tuple[Problem, Tree]:
    """Rooms 3, 4 and 5 m wide, 3 m deep, side by side between wall centre lines; linked in a row."""
    rooms = [{"id": f"{kind}_1", "type": kind, "area": 10.0} for kind in ("living_room", "study", "bedroom")]
    links = [("living_room_1", "study_1"), ("living_room_1", "bedroom_1")]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 2.95), (0.05, 2.95)]
    program = Program(rooms=rooms, links=links, envelope={"outline": ring})
    nothing = Whim((1, 1, 1), [(0, 1, 2), (2, 0, 3), (0, 2, 1)], "rectangle", 1.0)
    p = problem(program, given(program.envelope, BARE.inner), nothing, BARE, Slack())
    nodes = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 1], [3, 2, 1], [4, 0, 0]])
    return p, Tree(nodes, np.array([3.0, 4.0, 5.0, 1.0]))


def corridor(cuts: list[list[int]], shares: list[float], complete: bool = False) -> Floats:
    """Terms of a hallway of two rectangles, leaves 0 and 1, and a living room in 12 x 3 m between wall centre lines."""
    rooms = [{"id": f"{kind}_1", "type": kind, "area": 10.0} for kind in ("hallway", "living_room")]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 2.95), (0.05, 2.95)]
    links, envelope = [("hallway_1", "living_room_1")], {"outline": ring}
    program = Program(rooms=rooms, links=links, envelope=envelope, complete=complete)
    p = problem(program, given(program.envelope, BARE.inner), Whim((2, 1), [], "rectangle", 1.0), BARE, Slack())
    nodes = np.array([[0, 0, 0], [0, 0, 0], [1, 0, 0], *cuts, [4, 0, 0]])
    return energy(p, Tree(nodes, np.array([*shares, 1.0])))[1]


def test_a_corridor_is_as_wide_as_its_rectangles_are_together() -> None:
    together = corridor([[0, 1, 1], [3, 2, 1]], [1.0, 1.0, 10.0])  # two of .9 x 2.9 m, side by side
    assert together[WIDE] == pytest.approx(BROADER * (1.9 - 1.3))
    apart = corridor([[1, 2, 1], [0, 3, 0]], [12.0, 2.0, 22.0])  # .9 m all along, and a stub of .9 x 1.9 m
    # one comes in across from the living room, at 6.5 m, and its door need not be farther; nothing opens off the stub
    assert apart[WIDE] == pytest.approx(0.25 * (11.9 - 9) + BLIND * (12 - 6.5 - 0.65 + 2 - 1.2))


@pytest.mark.parametrize(("ends", "blind"), [([3, 0, 1], 0.85), ([0, 3, 1], 7.8)])
def test_a_corridor_counts_where_it_leads_nowhere(ends: list[int], blind: float) -> None:
    # a bedroom of 9 m and a living room of 3 m in the east above a corridor of 10.5 m, a bathroom at its west or east
    # end; to come in across from the living room, and go to all doors, it takes 9.65 or 2.7 m of it
    rooms = [{"id": f"{kind}_1", "type": kind} for kind in ("hallway", "bedroom", "living_room", "bathroom")]
    links = [("hallway_1", room["id"]) for room in rooms[1:]]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 2.95), (0.05, 2.95)]
    program = Program(rooms=rooms, links=links, envelope={"outline": ring})
    p = problem(program, given(program.envelope, BARE.inner), Whim((1,) * 4, [], "rectangle", 1.0), BARE, Slack())
    nodes = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [1, 2, 1], ends, [5, 4, 0], [6, 0, 0]])
    terms = energy(p, Tree(nodes, np.array([10.5, 18.0, 6.0, 1.5, 1.0])))[1]
    assert terms[WIDE] == pytest.approx(0.25 * (10.4 - 9) + BLIND * blind)


@pytest.mark.parametrize(("hall", "counts"), [(4.0, 0.0), (8.0, 0.5)])
def test_a_hallway_costs_nothing_for_floor_that_rooms_have_instead(hall: float, counts: float) -> None:
    floors = np.array([2.9 * (hall - 0.1), 2.9 * (12 - hall - 0.1)])  # 10 m² of each were thought of
    ratio, other = (floors + 0.01) * 20 / (10 * floors.sum() + 0.01)
    terms = corridor([[0, 1, 1], [3, 2, 1]], [hall / 2, hall / 2, 12 - hall])
    assert terms[AREA] == pytest.approx(counts * (ratio - 1) + max(other, 1 / other) - 1, abs=1e-3)
    told = corridor([[0, 1, 1], [3, 2, 1]], [hall / 2, hall / 2, 12 - hall], complete=True)  # its area is meant
    assert told[AREA] == pytest.approx(0.5 * (max(ratio, 1 / ratio) - 1) + max(other, 1 / other) - 1, abs=1e-3)


def test_a_bent_corridor_has_as_many_corners_too_many_as_any_bent_room() -> None:
    bent = corridor([[1, 2, 1], [0, 3, 0]], [12.0, 2.0, 22.0])
    assert bent[CONCISE] == pytest.approx((6 / 4 - 1) ** 2)


@pytest.mark.parametrize(("area", "across"), [(30.0, 4.2), (60.0, 5.7735)])  # of 60 m2 and 1.8 times as long
def test_a_living_room_is_as_wide_as_one_watches_across_or_its_area_asks_for(area: float, across: float) -> None:
    rooms = [{"id": "living_room_1", "type": "living_room", "area": area}, {"id": "study_1", "type": "study"}]
    ring = [(0.05, 0.05), (9.95, 0.05), (9.95, 5.95), (0.05, 5.95)]
    program = Program(rooms=rooms, links=[("living_room_1", "study_1")], envelope={"outline": ring})
    p = problem(program, given(program.envelope, BARE.inner), Whim((1, 1), [], "rectangle", 1.0), BARE, Slack())
    tree = Tree(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 1], [2, 0, 0]]), np.array([6.0, 4.0, 1.0]))
    terms = energy(p, tree)[1]  # a square of 5.9 m, and 3.9 x 5.9 m of which any width will do
    assert terms[ASPECT] == pytest.approx(5.9 - across + 5.9 / 3.9 - 1, abs=1e-4)


@pytest.mark.parametrize(("bay", "least"), [(4.5, 3.3), (2.0, 1.9), (0.5, 0.4)])
def test_a_room_behind_a_jog_is_as_wide_as_floor_lies_on_both_sides_of_it(bay: float, least: float) -> None:
    # 5 x 3 m between centre lines, of whose upper wall so much stands out by .4 m: the bay is 3.4 m deep
    rooms = [{"id": f"{kind}_1", "type": kind} for kind in ("living_room", "study")]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 2.95), (bay - 0.05, 2.95), (bay - 0.05, 3.35), (0.05, 3.35)]
    program = Program(rooms=rooms, links=[("living_room_1", "study_1")], envelope={"outline": ring})
    p = problem(program, given(program.envelope, BARE.inner), Whim((1, 1), [], "rectangle", 1.0), BARE, Slack())
    tree = Tree(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 1], [2, 0, 0]]), np.array([15 + 0.4 * bay, 21.0, 1.0]))
    for turned in (False, True):
        z = measured(*(across(p, tree) if turned else (p, tree)))
        assert z.room[0, R_LEAST] == pytest.approx(least) and z.room[0, R_WIDTH] == pytest.approx(max(2.9, least))


def across(p: Problem, tree: Tree) -> tuple[Problem, Tree]:
    """The same with x and y exchanged."""
    nodes = tree.nodes.copy()
    nodes[len(tree.share) - 1 : -1, 2] ^= 1
    edges = p.edges.copy()
    edges[:, 0] = 1 - edges[:, 0]
    return p._replace(blocks=p.blocks[:, [1, 0, 3, 2]], edges=edges), Tree(nodes, tree.share)


def test_near_rooms_counts_metres_between_rooms_times_their_weights() -> None:
    p, tree = row_of_three()
    assert p.near.tolist() == [[0, 1, 2], [0, 2, 4]]
    assert energy(p, tree)[1][NEAR] == pytest.approx(4 * 4.0)


def test_a_weight_is_as_good_as_pairs_that_stand_many_times() -> None:
    p, tree = row_of_three()
    many = [(a, b, 1) for a, b, count in p.near.tolist() for _ in range(count)]
    assert energy(p._replace(near=np.array(many)), tree)[0] == pytest.approx(energy(p, tree)[0])


def test_each_pair_stands_once() -> None:
    assert weighed([(2, 1, 6), (1, 2, 1), (0, 3, 24)]).tolist() == [[1, 2, 7], [0, 3, 24]]
    for name, program in archetypes().items():
        near = _drawn(name, 0)[0].near
        assert len({frozenset(pair) for pair in near[:, :2].tolist()}) == len(near)
        assert near[:, 2].max() >= (24 if any(room.type == "dining_room" for room in program.rooms) else WHIM)


def test_a_bedroom_behind_the_living_room_is_private() -> None:
    p, tree = row_of_three()
    terms = energy(p, tree)[1]
    assert terms[PRIVACY] == 0


def test_without_a_common_wall_the_way_leads_between_the_rooms() -> None:
    p, tree = row_of_three()
    cost, terms, _ = energy(p, tree)
    assert terms[LACKING] > 0, "living room and bedroom do not touch"
    other = row_of_three()[1]
    other.nodes[[0, 2]] = other.nodes[[2, 0]]
    energy(p, other)
    assert energy(p, tree)[0] == cost and energy(p, tree)[1][PATH] == terms[PATH]


@pytest.mark.parametrize("name", ["one_bedroom", "four_bedroom"])
@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_measures_are_those_of_the_best_state_even_of_a_run_given_up(name: str, seed: int) -> None:
    p, tree = _drawn(name, seed)
    cost, terms, best = energy(p, tree, 3000, seed + 1)
    again, measured, _ = energy(p, best)
    assert np.isfinite(cost) and again == cost and measured.tolist() == terms.tolist()


def _drawn(name: str, seed: int) -> tuple[Problem, Tree]:
    """An archetype in a drawn outline, and a random tree."""
    program, config, rng = archetypes()[name], PlanConfig(), np.random.default_rng(seed)
    wanted = whim(program, config.walls, 0, rng)
    gross = gross_area(program, config.walls)
    outline = draw(program.envelope, gross, wanted.shape, wanted.aspect, rng)
    return (
        problem(program, outline, wanted, config.walls, Slack()),
        start(known(program), wanted.parts, outline.stretch, rng),
    )


def test_walls_between_two_bedrooms_count_in_most_draws_and_between_three_in_none() -> None:
    # 12 x 3 m: a living room in the middle parts the bedrooms; beside them it leaves them 3 m of wall, 2 of which count
    rooms = [{"id": name, "type": name[:-2], "area": 10.0} for name in ("bedroom_1", "living_room_1", "bedroom_2")]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 2.95), (0.05, 2.95)]
    links = [("living_room_1", "bedroom_1"), ("living_room_1", "bedroom_2")]
    program = Program(rooms=rooms, links=links, envelope={"outline": ring})
    drawn = [whim(program, BARE, 0, np.random.default_rng(seed)).parted for seed in range(200)]
    assert {*map(tuple, drawn)} == {(), ((0, 2),)} and 0.84 < np.mean([bool(pairs) for pairs in drawn]) < 0.96
    asked = [{"id": "asked_1", "kind": "position", "of": "bedroom_1", "value": "west"}]
    told = Program(rooms=rooms, links=links, requirements=asked)
    assert not any(whim(told, BARE, 0, np.random.default_rng(seed)).parted for seed in range(50)), "it has a place"
    another = [*rooms, {"id": "bedroom_3", "type": "bedroom"}]
    more = Program(rooms=another, envelope={"outline": ring})
    assert not any(whim(more, BARE, 0, np.random.default_rng(seed)).parted for seed in range(50))

    def costs(middle: int, last: int, parted: list[tuple[int, int]]) -> float:
        wanted = Whim((1, 1, 1), [], "rectangle", 1.0, parted=parted)
        p = problem(program, given(program.envelope, BARE.inner), wanted, BARE, Slack())
        nodes = np.array([[0, 0, 0], [middle, 0, 0], [last, 0, 0], [0, 1, 1], [3, 2, 1], [4, 0, 0]])
        return energy(p, Tree(nodes, np.array([4.0, 4.0, 4.0, 1.0])))[0]

    assert costs(1, 2, [(0, 2)]) == pytest.approx(costs(1, 2, []))
    assert costs(2, 1, [(0, 2)]) == pytest.approx(costs(2, 1, []) + 2.0 * QUIET)


@pytest.mark.parametrize(("asked", "counts"), [([], LONE), (["living_room_1"], ALONE)])
def test_a_bathroom_off_the_outline_counts_for_less_where_places_are_told(asked: list[str], counts: float) -> None:
    """Four rooms in a row south of a hallway, then the bathroom behind the bedroom, between two others."""
    kinds = ("living_room", "bathroom", "bedroom", "study", "hallway")
    rooms = [{"id": f"{kind}_1", "type": kind, "area": 10.0} for kind in kinds]
    ring = [(0.05, 0.05), (11.95, 0.05), (11.95, 7.95), (0.05, 7.95)]
    wishes = [{"id": "asked_1", "kind": "position", "of": room, "value": "west"} for room in asked]
    links = [("hallway_1", f"{kind}_1") for kind in kinds[:4]]
    program = Program(rooms=rooms, links=links, envelope={"outline": ring}, requirements=wishes)
    p = problem(program, given(program.envelope, BARE.inner), Whim((1,) * 5, [], "rectangle", 1.0), BARE, Slack())
    leaves, shares = [[room, 0, 0] for room in range(5)], np.array([6.0, 2.0, 6.0, 6.0, 4.0, 1.0])
    row = np.array([*leaves, [0, 1, 1], [5, 2, 1], [6, 3, 1], [7, 4, 0], [8, 0, 0]])
    behind = np.array([*leaves, [2, 1, 0], [0, 5, 1], [6, 3, 1], [7, 4, 0], [8, 0, 0]])
    outer, inner = (energy(p, Tree(nodes, shares))[1] for nodes in (row, behind))
    assert inner[NEAR] - outer[NEAR] == pytest.approx(counts)
