"""Figures of scenes worked out by hand."""

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages import metrics
from apartgen.stages.metrics import articulation, collision, counts, doorways, outside, reachable, relations, walkable


def figure(values, name, version="ours", of="apartment"):
    found = [v for v in values if (v.name, v.version, v.of) == (name, version, of)]
    assert len(found) == 1, (name, version, of)
    return found[0].value


def acoll(*objects, version="ours", of="apartment"):
    return figure(articulation.measure(h.home(*objects)), "R_acoll", version, of)


DOWN, UP = -np.pi / 2, np.pi / 2


def test_a_drawer_blocked_by_two_centimetres():
    # The drawer comes out to y = 2.10, so a table edge above that is in its way.
    chest, size = h.chest(2, 2.75, DOWN), (0.6, 1.0, 0.4)
    blocking = h.thing("coffee_table", 2, 2.12 - 0.3, size=size, yaw=UP)
    assert acoll(chest, blocking) == 1 and acoll(chest, blocking, version="published") == 1
    touching = h.thing("coffee_table", 2, 2.105 - 0.3, size=size, yaw=UP)
    assert acoll(chest, touching) == 0 and acoll(chest, touching, version="strict") == 1
    assert acoll(chest, h.thing("coffee_table", 2, 2.09 - 0.3, size=size, yaw=UP), version="strict") == 0
    assert figure(collision.measure(h.home(chest, blocking)), "Col_obj") == 0


def test_success_is_asked_at_eight_shares_from_six_tenths_up():
    """A block of 3.12 m² in a living room of 12: .74 of it stay free, and 17.88 / 21 = .85 of the flat."""
    found = walkable.measure(h.home(h.thing("bookshelf", 2, 1.5, size=(1.3, 2.4, 2.0))))
    shares = [0.60, 0.65, 0.70, 0.75, 0.80, 0.85, 0.90, 0.95]
    for of, met in ((h.LIVING, 3), ("apartment", 6), (h.BEDROOM, 8)):
        for version in ("ours", "published"):
            asked = [figure(found, f"SR_{share:.2f}", version, of) for share in shares]
            assert asked == [1.0] * met + [0.0] * (8 - met)
    assert sum(v.name.startswith("SR_") for v in found) == 8 * 3 * 2


def test_physcene_grows_by_a_third_whatever_the_asset():
    chest = h.chest(2, 2.75, DOWN)
    near = h.thing("coffee_table", 2, 2.20 - 0.3, size=(0.6, 1.0, 0.4), yaw=UP)
    assert acoll(chest, near, version="physcene") == 0 and acoll(chest, near) == 1


def test_two_drawers_that_meet_only_when_both_are_open():
    size = (0.5, 1.0, 0.8)
    north = h.chest(2, 2.75, DOWN)
    south = h.thing("chest", 2, 1.5, UP, size=size, joints=(h.drawer(size, 0.5),))
    assert acoll(north, south) == 1
    assert acoll(north, h.thing("chest", 2, 1.3, UP, size=size, joints=(h.drawer(size),))) == 0


def test_members_of_a_group_are_told_apart():
    desk = h.thing("desk", 2, 2.6, DOWN, size=(0.65, 1.2, 0.75), joints=(h.drawer((0.65, 1.2, 0.75)),))
    chair = h.thing("office_chair", 2, 2.0, UP)
    assert acoll(desk, chair) == 0 and acoll(desk, chair, version="published") == 1
    tucked = h.home(desk, h.thing("office_chair", 2, 2.3, UP))
    assert figure(collision.measure(tucked), "Col_obj") == 0
    assert figure(collision.measure(tucked), "Col_obj", "grouped") == 1
    assert figure(collision.measure(tucked), "Col_scene", "grouped") == 1


def test_a_drawer_into_a_wall_or_a_door_swing():
    facing = h.chest(2, 2.65, UP)
    assert acoll(facing) == 0 and acoll(facing, version="with_walls") == 1
    # The bedroom door sweeps (4.1, 1.0) to (5.0, 1.9); this drawer reaches x = 4.9 from the right.
    into = h.chest(5.55, 1.6, np.pi, h.BEDROOM)
    assert acoll(into) == 0 and acoll(into, version="with_walls") == 1
    assert acoll(h.chest(5.75, 2.4, np.pi, h.BEDROOM), version="with_walls") == 0


def test_nothing_opens():
    values = articulation.measure(h.home(h.thing("sofa", 1, 1)))
    assert figure(values, "R_acoll") is None


def test_collisions_by_room():
    bed = h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM)
    home = h.home(h.thing("sofa", 1, 1), h.thing("coffee_table", 1, 1.2), bed)
    values = collision.measure(home)
    assert figure(values, "Col_obj") == pytest.approx(2 / 3)
    assert figure(values, "Col_obj", of=h.LIVING) == 1 and figure(values, "Col_obj", of=h.BEDROOM) == 0
    scenes = [figure(values, "Col_scene", of=of) for of in ("apartment", h.LIVING, h.BEDROOM)]
    assert scenes == [1, 1, 0]


def test_a_lamp_on_a_rug_is_no_collision():
    home = h.home(h.thing("rug", 2, 1.5), h.thing("floor_lamp", 2, 1.5), h.thing("ceiling_lamp", 2, 1.5, bottom=2.2))
    assert figure(collision.measure(home), "Col_obj", "published") == 0


def test_a_wall_through_a_cabinet():
    through = h.thing("sideboard", 4.0, 0.5, size=(0.4, 1.0, 0.8), room=h.LIVING)
    flush = h.thing("sideboard", 3.8, 2.5, size=(0.4, 1.0, 0.8), room=h.LIVING)
    values = outside.measure(h.home(through, flush))
    assert figure(values, "R_out") == 0.5 and figure(values, "R_out", "published") == 0.5
    # Five millimetres of a long, flat thing stay within both tolerances.
    skin = h.thing("sideboard", 3.805, 2.4, size=(0.6, 1.0, 0.8))
    assert figure(outside.measure(h.home(skin)), "R_out") == 1
    assert figure(outside.measure(h.home(h.thing("sideboard", 3.605, 2.4, size=(0.8, 1.0, 0.8)))), "R_out") == 0


def test_a_cabinet_through_a_wall_meets_what_stands_behind_it():
    # Collisions are between boxes, walls or no walls: the bed behind the wall is hit by 0.1 m.
    through = h.thing("sideboard", 4.0, 0.5, size=(0.4, 1.0, 0.8))
    beyond, clear = (h.thing("double_bed", x, 0.9, room=h.BEDROOM, size=(2.0, 1.6, 1.0)) for x in (5.1, 5.25))
    assert figure(collision.measure(h.home(through, beyond)), "Col_obj") == 1
    assert figure(collision.measure(h.home(through, clear)), "Col_obj") == 0
    assert figure(outside.measure(h.home(through, clear)), "R_out", of=h.LIVING) == 1


def test_walkable_by_hand():
    sofa, twin = h.thing("sofa", 1, 1, size=(1, 2, 1)), h.thing("sofa", 1, 1, size=(1, 2, 1), id="twin")
    values = walkable.measure(h.home(sofa, twin, h.thing("rug", 2, 2)))
    assert figure(values, "R_walkable") == pytest.approx(19 / 21)
    assert figure(values, "R_walkable", of=h.LIVING) == pytest.approx(10 / 12)
    assert figure(values, "R_walkable", "published") == pytest.approx(17 / 21)
    assert figure(values, "R_walkable", "published", h.LIVING) == pytest.approx(8 / 12)
    assert figure(values, "SR_0.80", "published", h.LIVING) == 0
    assert figure(values, "SR_0.65", "published", h.LIVING) == 1
    assert figure(values, "SR_0.80", of=h.LIVING) == 1 and figure(values, "SR_0.85", of=h.LIVING) == 0


def test_the_second_of_two_free_regions_is_the_larger():
    # A wall of shelves at x 1.0-1.4 leaves 1.0 m on the left, met first by a scan, and 2.6 m on the right.
    shelves = h.thing("shelving", 1.2, 1.5, size=(0.4, 3.0, 1.8))
    left, right = (1.0 - 0.3) * 2.7, (2.6 - 0.3) * 2.7
    values = walkable.measure(h.home(shelves))
    assert figure(values, "R_walkable", "physcene", h.LIVING) == pytest.approx(right / (left + right), abs=0.01)
    assert figure(values, "R_walkable", "physcene") == pytest.approx((right / (left + right) + 1) / 2, abs=0.01)
    # The entrance is on the left, so the robot gets no further than the smaller part.
    assert figure(values, "R_walkable", "connected", h.BEDROOM) == 0
    assert 0.1 < figure(values, "R_walkable", "connected", h.LIVING) < 0.3


def test_reach_weighs_parts_by_area():
    shelves = h.thing("shelving", 1.2, 1.5, size=(0.4, 3.0, 1.8))
    chair, high = h.thing("armchair", 3.5, 2.5), h.thing("wall_shelf", 0.1, 2.5, bottom=1.9)
    left, right = (1.0 - 0.3) * 2.7, (2.6 - 0.3) * 2.7 - (0.85 + 0.15 - 0.075) * (0.82 + 0.15 - 0.06)
    share = left / (left + right)
    values = reachable.measure(h.home(shelves, chair, high))
    assert figure(values, "R_reach") == pytest.approx(share * 0.5 + (1 - share), abs=0.02)
    assert figure(values, "R_reach", "published") == pytest.approx(share * 2 / 3 + (1 - share) * 2 / 3, abs=0.02)
    assert figure(values, "R_reach", "from_entrance") == 0.5


def test_reach_of_what_stands_leaves_out_what_no_floor_is_beside():
    # A mirror over a deep sideboard and a lamp in its middle hang and stand 0.3 m and more from free floor.
    board = h.thing("sideboard", 2, 2.5, DOWN, size=(1.0, 1.6, 0.8))
    mirror = h.thing("mirror", 2, 2.97, DOWN, size=(0.05, 0.6, 0.6), bottom=1.0)
    lamp = h.thing("table_lamp", 2, 2.5, bottom=0.8)
    values = reachable.measure(h.home(board, mirror, lamp))
    assert figure(values, "R_reach") == pytest.approx(1 / 3)
    assert figure(values, "R_reach", "standing") == 1
    assert figure(reachable.measure(h.home(mirror)), "R_reach", "standing") is None


def test_reach_of_fronts():
    free, turned = h.chest(2, 2.75, DOWN), h.chest(3.0, 2.72, UP)
    values = reachable.measure(h.home(free, turned))
    assert figure(values, "R_reach_front") == 0.5 and figure(values, "R_reach_front", "closed") == 0.5
    assert figure(values, "R_reach_front", of=h.LIVING) == 0.5


def blocked(version, *objects):
    return figure(doorways.measure(h.home(*objects)), "R_blocked", version)


def test_doorways_and_windows():
    assert blocked("doors") == blocked("swings") == blocked("windows") == 0
    before = h.thing("pouffe", 3.7, 1.5)
    assert blocked("doors", before) == 0.5 and blocked("swings", before) == 0
    behind = h.thing("pouffe", 4.6, 1.3, room=h.BEDROOM)
    assert blocked("swings", behind) == 0.5
    assert blocked("doors", h.thing("rug", 3.7, 1.5)) == 0
    tall = h.thing("bookshelf", 5.4, 0.16, UP, h.BEDROOM)
    assert blocked("windows", tall) == 1
    assert blocked("windows", h.thing("double_bed", 5.4, 1.0, UP, h.BEDROOM, size=(2.0, 1.6, 0.5))) == 0
    assert blocked("windows", h.thing("curtain", 5.5, 0.06, UP, h.BEDROOM)) == 0


def test_run_measures_what_applies():
    values = metrics.run(h.home(h.thing("sofa", 1, 1))).values
    assert {"R_acoll", "Col_obj", "R_out", "R_walkable", "R_reach", "N_objects"} <= {v.name for v in values}
    assert "R_acoll" not in {v.name for v in metrics.run(h.plan()).values}
    assert {v.name for v in metrics.run(h.home(), ["collision"]).values} == {"Col_obj", "Col_scene"}
    with pytest.raises(BadInput, match="did you mean"):
        metrics.run(h.home(), ["colision"])
    with pytest.raises(BadInput, match="needs objects"):
        metrics.run(h.plan(), ["collision"])


@pytest.mark.parametrize("name", metrics.names())
def test_every_metric_takes_an_empty_flat_and_is_repeatable(name):
    from apartgen.stages import registry

    member = registry.load("apartgen.stages.metrics", name)
    assert hasattr(member, "measure") or hasattr(member, "compare")
    if hasattr(member, "measure"):
        for home in (h.home(), h.home(h.thing("sofa", 1, 1), h.chest(2, 2.75, DOWN))):
            first, second = metrics.run(home, [name]), metrics.run(home, [name])
            assert first == second and all(v.name and v.version for v in first.values)
            keys = [(v.name, v.version, v.of) for v in first.values]
            assert len(keys) == len(set(keys))


def test_how_much_stands_in_each_room_by_hand():
    things = [h.chest(2, 0.25, UP), h.thing("stool", 1, 2), h.thing("stool", 3, 2),
              h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM)]
    found = counts.measure(h.home(*things))
    table = {of: [figure(found, name, of=of) for name in ("N_objects", "N_articulated", "N_categories")]
             for of in ("apartment", h.LIVING, h.BEDROOM)}
    assert table == {"apartment": [4, 1, 3], h.LIVING: [3, 1, 2], h.BEDROOM: [1, 0, 1]}
    assert {v.value for v in counts.measure(h.home())} == {0}


def test_density_by_hand():
    # Of 12 m²: a 1 × 2 m table and a 1 × 1 m one that stands half on its floor; what lies or hangs takes none.
    table = h.thing("coffee_table", 2, 1.5, size=(1.0, 2.0, 0.4))
    half = h.thing("side_table", 2.5, 1.5, size=(1.0, 1.0, 0.5))
    rug = h.thing("rug", 1, 1, size=(2.0, 2.0, 0.02))
    lamp = h.thing("ceiling_lamp", 1, 1)
    def density(*things):
        return figure(relations.measure(h.home(*things)), "density")
    # Rooms count alike: the bedroom is empty.
    assert density(table, half, rug, lamp) == pytest.approx((2 + 0.5) / 12 / 2)
    assert density(rug, lamp) == density() == 0
    bed = h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM, size=(2.0, 1.5, 0.5))
    assert density(table, bed) == pytest.approx((2 / 12 + 3 / 9) / 2)


def test_rugs_and_curtains_collide_in_no_version():
    curtain = h.thing("curtain", 2, 2.9, DOWN)
    chest = h.chest(2, 2.75, DOWN)
    flat = h.home(chest, curtain, h.thing("rug", 2, 2.4, size=(2.0, 2.0, 0.02)))
    for name, measure in (("Col_obj", collision.measure), ("R_acoll", articulation.measure)):
        assert {v.value for v in measure(flat) if v.name == name and v.version != "with_walls"} == {0}
