"""Lanes are told apart by name and seed alone."""

import handmade
import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.stages import seeds


def test_a_lane_hangs_on_its_name_and_seed_and_on_nothing_that_was_drawn_before():
    first, second = seeds.drawn(7, "layout", "a"), seeds.drawn(7, "layout", "a")
    second.random(100)
    second.spawn(3)
    assert seeds.lane(first, "bedroom_1").random() == seeds.lane(second, "bedroom_1").random()


def test_no_two_lanes_of_many_seeds_and_names_draw_alike():
    drawn = [seeds.lane(seeds.drawn(seed, word), room).random()
             for seed in range(40) for word in ("layout", "plan") for room in ("bedroom_1", "bedroom_2", "hallway_1")]
    assert len(set(drawn)) == len(drawn)
    assert abs(np.mean(drawn) - 0.5) < 4 * np.sqrt(1 / 12 / len(drawn))


def test_names_are_not_run_together():
    assert seeds.drawn(1, "ab", "c").random() != seeds.drawn(1, "a", "bc").random()


def test_a_home_keeps_its_plans_digest_through_all_stages():
    plan = handmade.plan()
    furnished = Layout(**plan.model_dump(), objects=[])
    other = plan.model_copy(update={"height": plan.height + 0.1})
    assert seeds.plan_digest(plan) == seeds.plan_digest(furnished) != seeds.plan_digest(other)
