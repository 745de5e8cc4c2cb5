"""What each weight is about, measured by hand on a plan of three rooms, and moved by the weight."""

import numpy as np
import pytest

from apartgen.schemas.plan import Opening, Plan, Program, Room
from apartgen.stages.plan import PlanConfig, build
from apartgen.stages.plan.seen import UNITS, UP, seen
from apartgen.stages.plan.study import archetypes
from apartgen.stages.plan.weights import WEIGHTS
from apartgen_cli.bench import weights


def three() -> Plan:
    """A corridor 6 × 1.2 m below a living room of 3.9 × 3.9 and a bathroom of 2 × 3.9, walls of 10 cm."""
    shapes = {"hallway_1": (0, 0, 6, 1.2), "living_room_1": (0, 1.3, 3.9, 5.2), "bathroom_1": (4.0, 1.3, 6, 5.2)}
    rooms, asked = [], []
    for name, (a, b, c, d) in shapes.items():
        rooms.append(Room(id=name, type=name[:-2], polygon=[(a, b), (c, b), (c, d), (a, d)]))
        asked.append({"id": name, "type": name[:-2], "area": (c - a) * (d - b)})
    links = [("hallway_1", "living_room_1"), ("hallway_1", "bathroom_1")]
    cuts = [("entrance_1", ["hallway_1"], ((-0.15, 0.1), (-0.15, 1.1))),
            ("door_1", links[0], ((2.0, 1.25), (3.0, 1.25))), ("door_2", links[1], ((5.0, 1.25), (6.0, 1.25)))]
    openings = [Opening(id=name, kind=name[:-2], rooms=list(between), segment=segment, sill=0, head=2)
                for name, between, segment in cuts]
    return Plan(program=Program(rooms=asked, links=links), rooms=rooms, openings=openings)


def test_measures_by_hand() -> None:
    found = seen(three())
    lived, total = 3.9 * 3.9, 3.9 * 3.9 + 2 * 3.9 + 6 * 1.2
    # Middles: of the entrance (-.15, .6), of the doors (2.5, 1.25), (5.5, 1.25), of the rooms (1.95, 3.25), (5, 3.25).
    ways = [(2.65 + 0.65 + 0.55 + 2.0) / (2.1 + 2.65 + 0.5), (5.65 + 0.65 + 0.5 + 2.0) / (5.15 + 2.65 + 0.5)]
    hand = {
        "shortest_path": (ways[0] - 1 + ways[1] - 1 + 0.0) / 3, "typical_area": 0.0, "aspect_ratio": (1 + 3.9 / 2) / 2,
        "convexity": 1.0, "conciseness": 4.0, "exterior_length": 100 * 7.8 / (7.8 + 5.9 + 8.4), "exterior_corner": 25.0,
        "collinearity": 6.0, "functional_room": 100 * lived / total, "narrow_passage": 7.2, "near_rooms": 0.0,
        "wide_corridor": 0.0, "privacy": 0.0,
    }  # fmt: skip
    assert {name: found[name] for name in hand} == pytest.approx(hand, rel=5e-3, abs=0.03)


@pytest.mark.parametrize(("corners", "wider"), [
    ([(0, 0), (6, 0), (6, 1.4), (1.4, 1.4), (1.4, 5), (0, 5)], 0.1), ([(0, 0), (2, 0), (2, 3), (0, 3)], 0.7),
    ([(0, 0), (6, 0), (6, 1.2), (3.2, 1.2), (3.2, 4), (2, 4), (2, 1.2), (0, 1.2)], 0.0),
])
def test_a_corridor_is_no_wider_where_it_turns(corners: list[tuple[float, float]], wider: float) -> None:
    plan = three()
    hall = plan.rooms[0].model_copy(update={"polygon": corners})
    found = seen(plan.model_copy(update={"rooms": [hall, *plan.rooms[1:]]}))
    assert found["wide_corridor"] == pytest.approx(wider, abs=2e-3)


def test_every_term_but_those_of_stairs_has_a_measure_and_a_sentence() -> None:
    moved = [name for name in WEIGHTS if not name.startswith("staircase")]
    assert list(UNITS) == moved == list(weights.SENTENCES) and set(UP) < set(moved)


@pytest.mark.parametrize("term", ["typical_area", "aspect_ratio", "shortest_path", "narrow_passage"])
def test_a_weight_moves_its_own_measure(term: str) -> None:
    program, means = archetypes()["two_bedroom"], []
    for dose in (0.0, 16.0):
        asked = program.model_copy(update={"weights": {term: dose}})
        plans = [build(asked, PlanConfig(), lane) for lane in np.random.default_rng(9).spawn(8)]
        means.append(np.mean([seen(plan)[term] for plan in plans]))
    assert means[1] < means[0]


def test_the_table_of_weights_by_hand() -> None:
    records = []
    for setting in weights.SETTINGS:
        shift = 4.0 if setting == "privacy × 16" else 0.0
        records += [{"setting": setting, "areas": 0.9, **{term: v - shift for term in UNITS}} for v in (4.0, 6.0)]
    row = next(r for r in weights.rows(records, np.random.default_rng(0)) if r["term"] == "`privacy`")
    assert (row["× 0"], row["× 1"], row["× 4"], row["× 16"]) == (5.0, 5.0, 5.0, 1.0)
    assert row["d/se"] == pytest.approx(-4 / np.sqrt(2.0)) and row["d/se with"] == 0.0 and row["areas × 16"] == 0.9
