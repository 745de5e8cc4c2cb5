"""The energy by which candidates are chosen: rooms in order first, then half-empty ones, then rooms out of order."""

import subprocess
import sys
from dataclasses import replace

import handmade
import numpy as np
import pytest
from lived_in import NORTH, ROOMS, SOUTH, WEST, bedroom, room, thing

from apartgen.stages import registry, use
from apartgen.stages.layout import choice
from apartgen.stages.use.site import Hole


def energy(kind: str, things: list) -> float:  # type: ignore[type-arg]
    return choice.energy(room(kind, *ROOMS[kind][:2], *things))


@pytest.mark.parametrize("kind", ROOMS)
def test_rooms_in_order_are_better_than_empty_and_shaken_ones(kind: str) -> None:
    _, _, things = ROOMS[kind]
    best = energy(kind, things())
    assert best < energy(kind, []) - 1
    for seed in range(8):
        rng = np.random.default_rng(seed)
        shifts = rng.normal(0, 0.6, (len(things()), 2))
        shaken = [o.model_copy(update={"center": tuple(np.add(o.center, [*by, 0]))})
                  for o, by in zip(things(), shifts, strict=True)]
        assert energy(kind, shaken) > best


@pytest.mark.parametrize("kind", ROOMS)
def test_the_more_is_out_of_order_the_worse(kind: str) -> None:
    """On average over many rooms: a quarter of the things at random places, a half, all."""
    width, depth, things = ROOMS[kind]
    means = []
    for share in (0.0, 0.25, 0.5, 1.0):
        found = []
        for seed in range(25):
            rng = np.random.default_rng(seed)
            out = [o.model_copy(update={"center": (*rng.uniform((0, 0), (width, depth)), o.center[2])})
                   if rng.random() < share else o for o in things()]
            found.append(energy(kind, out))
        means.append(np.mean(found))
    assert (np.diff(means) > 0).all()


def test_terms_are_never_negative_and_add_up() -> None:
    for kind, (_, _, things) in ROOMS.items():
        place = room(kind, *ROOMS[kind][:2], *things())
        parts = choice.parts(place)
        assert set(parts) == set(registry.members("apartgen.stages.layout.choice")) >= set(choice.WEIGHTS)
        assert min(parts.values()) >= 0
        assert choice.energy(place) == pytest.approx(sum(choice.WEIGHTS[name] * v for name, v in parts.items()))


def test_the_best_candidate_is_the_one_of_least_cost() -> None:
    def in_bedroom(things: list) -> list:  # type: ignore[type-arg]
        return [o.model_copy(update={"room": handmade.BEDROOM, "center": (o.center[0] + 4.1, *o.center[1:])})
                for o in things]

    good = [thing("double_bed", 1.94, 1.5, WEST), thing("nightstand", 2.78, 0.42, WEST),
            thing("nightstand", 2.78, 2.58, WEST)]
    poor = [thing("single_bed", 1.5, 1.5, SOUTH)]
    candidates = [in_bedroom(some) for some in ([], poor, good, good[:1])]
    home = handmade.plan()
    costs = [choice.cost(home, handmade.BEDROOM, some) for some in candidates]
    assert choice.best(home, handmade.BEDROOM, candidates) == int(np.argmin(costs)) == 2
    others = [thing("sofa", 1, 1)]
    elsewhere = [o.model_copy(update={"room": handmade.LIVING}) for o in others]
    assert choice.cost(home, handmade.BEDROOM, [*candidates[2], *elsewhere]) == costs[2]


def test_sets_of_one_size_are_better() -> None:
    pair = bedroom()
    unlike = [*pair[:2], pair[2].model_copy(update={"size": (0.35, 0.4, 0.5)}), pair[3]]
    assert energy("bedroom", unlike) > energy("bedroom", pair)


@pytest.mark.parametrize("screen, table, cost", [
    (2.1, 1.9, 0.0), (2.0, 3.0, 0.0), (3.1, 2.5, 0.4), (2.0, 0.9, 0.4), (2.6, 1.4, 0.4), (None, None, 0.0),
])
def test_a_far_screen_and_a_near_table_cost_more(screen: float | None, table: float | None, cost: float) -> None:
    """From a sofa .9 m deep, whose front is at 1 m; a stand .4 m deep across, a table .9 m deep beside."""
    things = [thing("sofa", 3.0, 0.55, NORTH, (0.9, 2.0, 0.8))]
    if screen is not None and table is not None:
        things += [thing("tv_stand", 3.0, 1.0 + screen + 0.2, SOUTH, (0.4, 1.6, 0.5)),
                   thing("dining_table", 4.0 + table + 0.45, 0.55, WEST, (0.9, 1.6, 0.75))]
    assert choice.parts(room("living_room", 9.0, 5.0, *things))["distances"] == pytest.approx(cost, abs=1e-3)


@pytest.mark.parametrize("aside, cost", [(0.0, 0.0), (0.25, 0.0), (0.8, 0.3 + 0.8 * 0.5), (1.6, 0.3 + 0.8 * 1.0)])
def test_a_screen_beside_the_axis_costs_more_the_farther_it_is(aside: float, cost: float) -> None:
    """From a sofa at the wall, a stand 3 m ahead of its front."""
    things = [thing("sofa", 3.0, 0.5, NORTH, (0.9, 2.0, 0.8)),
              thing("tv_stand", 3.0 + aside, 4.2, SOUTH, (0.4, 1.6, 0.5))]
    assert choice.parts(room("living_room", 9.0, 5.0, *things))["axes"] == pytest.approx(cost, abs=1e-3)


@pytest.mark.parametrize("far, cost", [(1.0, 0.0), (3.0, 0.0), (5.0, 0.5)])
def test_a_table_far_from_where_dishes_come_in_costs_more(far: float, cost: float) -> None:
    """Their door is in the middle of the south wall; where nobody knows of one, nothing is said."""
    door = Hole("door_1", "door", (4.0, 0.0), (5.0, 0.0), 0.0, 2.0, False, 0)
    table = thing("dining_table", 4.5, far, NORTH, (0.9, 1.6, 0.75))
    alone = room("living_room", 9.0, 8.0, table)
    served = use.Furnished(replace(alone.site, holes=(door,), served=("door_1",)), [table])
    assert choice.parts(alone)["distances"] == 0
    assert choice.parts(served)["distances"] == pytest.approx(cost, abs=1e-3)


def test_choosing_imports_no_torch() -> None:
    code = "import apartgen.stages.layout.choice, sys; assert 'torch' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
