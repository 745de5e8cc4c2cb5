"""What is kept to be quick gives the answers it stands for."""

import boxes_library as fake
import handmade as h
import numpy as np
import pytest
from crowded import FIRST, crowded

from apartgen.stages import retrieve
from apartgen.stages.robot import reach
from apartgen.stages.space import convex
from apartgen.stages.things.categories import TABLE
from apartgen.stages.walkable import WalkableConfig, importance
from apartgen.stages.walkable.blocking import blockers, view
from apartgen.stages.walkable.kept import Kept
from apartgen.stages.walkable.optimize import area_ratio
from apartgen.stages.walkable.site import _meets_nothing, survey, swapped
from apartgen.stages.walkable.ways import after, ways


@pytest.mark.parametrize("kind", ["bedroom", "kitchen", "bathroom", "living_room"])
def test_ways_brought_up_to_date_are_those_looked_at_anew(kind):
    home = crowded(1, kind)
    site = survey(home, WalkableConfig(), fake.Boxes(), importance.needs(home))
    rng, scene = np.random.default_rng(0), tuple(home.objects)
    now = ways(site, scene)
    assert now.missed == set(reach.survey(site.world, scene).missed)
    for _ in range(25):
        o = now.scene[int(rng.integers(len(now.scene)))]
        x, y = rng.uniform(-0.5, 0.5, 2)
        moved = o.model_copy(update={"center": (o.center[0] + x, o.center[1] + y, o.center[2])})
        to = {o.id: moved if rng.random() < 0.8 else None}
        left = after(site, now, to)
        assert left.scene == swapped(now.scene, to)
        assert (left.got == reach.survey(site.world, left.scene).cells).all()
        assert left.missed == set(reach.survey(site.world, left.scene).missed)
        if to[o.id] is not None:
            now = left


@pytest.mark.parametrize("kind", list(FIRST))
def test_no_object_that_may_not_help_helps(kind):
    for seed in range(3):
        home = crowded(seed, kind)
        site, scene = survey(home, WalkableConfig(), fake.Boxes(), importance.needs(home)), tuple(home.objects)
        for target in ways(site, scene).missed:
            here = view(site, scene, target)
            alone = {o.id for o in scene if o.id != target and reach.in_the_way(o) and here.reaches({o.id: None})}
            assert {o.id for o in blockers(site, scene, here)[0]} >= alone


def test_free_floor_is_kept_by_what_stands_on_it():
    home = crowded(0, "bedroom")
    site, scene = survey(home, WalkableConfig(), fake.Boxes()), tuple(home.objects)
    first = area_ratio(site, scene, [h.BEDROOM])
    assert area_ratio(site, scene[1:], [h.BEDROOM]) > first == area_ratio(site, scene, [h.BEDROOM])


def test_a_library_gives_the_same_asset_again():
    libraries = retrieve.open_libraries()
    kept, size = Kept(libraries), np.asarray(TABLE["chest"].size)
    first = kept.nearest("chest", size, (), size)
    assert first is kept.nearest("chest", size, (), size) is kept.load_asset(first.library, first.id)
    assert first.id == libraries.nearest("chest", size, (), size).id
    assert [a.id for a in kept.alternatives("chest", size, ())] == [
        a.id for a in libraries.alternatives("chest", size, ())]


def test_nothing_meets_no_solid():
    assert not convex.meet(convex.of([]), convex.of([]), 0.001)


@pytest.mark.parametrize("into, fits", [(0.002, True), (0.006, False)])
def test_a_change_may_make_less_contact_than_half_of_what_is_collision(into, fits):
    """Collision is more than 1 cm; two shelves of 0.4 m, 5 cm apart, of which one is moved."""
    one, other = (h.thing("bookshelf", x, 1.5, size=(0.4, 1.0, 2.0), id=id) for x, id in ((1.0, "a"), (1.45, "b")))
    moved = other.model_copy(update={"center": (1.4 - into, *other.center[1:])})
    assert _meets_nothing([one, other], [one, moved], {"b"}) == fits
