"""Openings without a door: how wide they are, and which end of a kitchen's wall they leave to its run."""

import numpy as np
import pytest
import shapely
from shapely.geometry import box

import apartgen
from apartgen.stages.plan import faces, unwalled

KITCHEN, NOTHING = box(0.0, 0.0, 3.0, 2.7), shapely.GeometryCollection()


def opened(kitchen: shapely.Polygon, reached: shapely.Geometry, width: float = 2.7) -> tuple[float, float]:
    """The opening in the kitchen's east wall, from its south end on, to a room beyond."""
    (face,) = faces.between(kitchen, box(3.1, 0.0, 7.0, width))
    lo, hi = unwalled.span(face, kitchen, reached)
    south = face.start[1] < (face.start + face.along)[1]
    return (lo, hi) if south else (face.length - hi, face.length - lo)


@pytest.mark.parametrize(("behind", "lo", "hi"), [
    (box(0.0, 2.8, 3.0, 5.0), unwalled.RUN, 2.6),  # a door in the north wall: the run begins in the south
    (box(0.0, -3.0, 3.0, -0.1), 0.1, 2.7 - unwalled.RUN),
])
def test_units_begin_at_the_wall_without_a_door(behind: shapely.Polygon, lo: float, hi: float) -> None:
    assert opened(KITCHEN, behind) == pytest.approx((lo, hi))


def test_an_opening_is_whole_where_no_run_would_begin_beside_it() -> None:
    """Between other rooms, in a wall too short to share, where both next walls are short."""
    (face,) = faces.between(KITCHEN, box(3.1, 0.0, 7.0, 2.7))
    assert unwalled.span(face, None, NOTHING) == pytest.approx((0.1, 2.6))
    assert opened(box(0.0, 0.0, 3.0, 2.0), NOTHING, 2.0) == pytest.approx((0.1, 1.9))
    assert opened(box(1.8, 0.0, 3.0, 2.7), NOTHING) == pytest.approx((0.1, 2.6))


def test_the_widest_opening_stays_as_wide_and_leaves_the_run_its_wall() -> None:
    lo, hi = opened(box(0.0, 0.0, 3.0, 4.0), box(0.0, 4.1, 3.0, 6.0), 4.0)
    assert lo == pytest.approx(unwalled.RUN) and hi - lo == pytest.approx(unwalled.WIDEST)


def test_open_kitchens_of_plans_keep_a_run_of_wall() -> None:
    """At least one end of each opening of 2.4 m and more is .6 m from the kitchen's corner."""
    left = []
    for seed in range(12):
        plan = apartgen.plan("two-bedroom flat of 75 m2 with an open kitchen", seed=seed).body
        kitchen = next(shapely.Polygon(room.polygon) for room in plan.rooms if room.base == "kitchen")
        for o in plan.openings:
            if o.kind == "opening" and any(room.startswith("kitchen") for room in o.rooms):
                corners = shapely.MultiPoint(kitchen.exterior.coords)
                left.append(max(shapely.Point(end).distance(corners) for end in np.array(o.segment)) > 0.6)
    assert len(left) >= 10 and np.mean(left) > 0.7
