"""What becomes of a target that smaller and fewer things don't meet: other kinds for the same use."""

import handmade as h
import numpy as np
import pytest
from walkable.test_run import UP, object_of, walk

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import AskedObjects
from apartgen.stages.robot import reach
from apartgen.stages.space import footprints
from apartgen.stages.things.categories import TABLE

FLOOR = 21


def corner(**more):
    return h.thing("corner_sofa", 1.6, 0.9, UP, size=(1.7, 2.6, 0.8), id="corner", **more)


def least(category):
    return TABLE[category].min[0] * TABLE[category].min[1]


def target(free):
    """The share of floor that is free with so much of it taken, m², and a little less."""
    return 1 - (free + 0.01) / FLOOR


def test_another_kind_is_taken_only_where_the_target_is_missed_without():
    assert least("corner_sofa") > least("sofa") > least("armchair")
    met = walk(h.home(corner()), target=target(least("corner_sofa") + 0.2))
    assert object_of(met, "corner").category == "corner_sofa"
    missed = walk(h.home(corner()), target=target(least("sofa") + 0.2))
    new = object_of(missed, "corner")
    assert new.category == "sofa" and missed.walkable.after >= missed.walkable.target
    step = missed.walkable.steps[-1]
    assert (step.action, step.object, step.reason) == ("replace", "corner", "ratio")
    assert step.after.asset == new.asset and footprints.area(new) < step.before.size[0] * step.before.size[1]


def test_what_was_asked_for_keeps_its_kind_and_is_named_as_before():
    wish = AskedObjects(room=h.LIVING, category="corner_sofa", count=1)
    home = h.home(corner())
    asked = home.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})
    for config in ({}, {"drop": False}):
        with pytest.raises(Unmet, match="can't be met"):
            walk(asked if not config else home, target=target(least("sofa") + 0.2), **config)


def test_the_robot_gets_no_less_far_for_it():
    # A cabinet that opens stands before the corner sofa: whatever takes its place, the robot still gets to it.
    chest = h.chest(3.7, 1.6, np.pi, travel=0.3, id="chest")
    home = h.home(corner(), chest)
    result = walk(home, target=target(least("sofa") + 0.5 + 0.2), write_anyway=True)
    assert object_of(result, "corner").category != "corner_sofa"
    assert result.walkable.unreached == [] and reach.survey(reach.space(result), result.objects).missed == []
