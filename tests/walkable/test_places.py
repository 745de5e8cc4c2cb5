"""Other places of an object and its company along walls, and what reaches into a wall: against shapely."""

from typing import Any

import handmade as h
import numpy as np
import pytest
import shapely
from shapely.affinity import rotate, translate
from shapely.geometry import Polygon

from apartgen.stages.space import convex
from apartgen.stages.things.solids import slab
from apartgen.stages.walkable import places
from apartgen.stages.walkable.leaves import INTO_WALL, building

FLOOR = Polygon([(0, 0), (4, 0), (4, 2), (2.5, 2), (2.5, 3), (0, 3)])


def mark(o: Any) -> Polygon:
    d, w = o.size[0] / 2, o.size[1] / 2
    return translate(rotate(shapely.box(-d, -w, d, w), o.yaw, (0, 0), use_radians=True), *o.center[:2])


@pytest.mark.parametrize("yaw", [0.0, 0.4, -2.0])
@pytest.mark.parametrize("beside", [(), (0.9,), (0.9, -0.9), (-0.9,)])
def test_along_walls_the_group_has_its_back_to_one_from_end_to_end(yaw: float, beside: tuple[float, ...]) -> None:
    """A bed 1.2 m wide with stands of 0.4 at some of its sides: as deep in the room as the deepest, flush with a wall
    but for 2 mm, and from the wall's one end to its other."""
    bed = h.thing("double_bed", 2.0, 1.5, yaw, size=(1.6, 1.2, 0.9), id="bed")
    c, s = np.cos(yaw), np.sin(yaw)
    stands = [h.thing("nightstand", 2.0 - 0.6 * c - y * s, 1.5 - 0.6 * s + y * c, yaw, size=(0.4, 0.4, 0.5))
              for y in beside]
    group = [bed, *stands]
    spots = places._along_walls(FLOOR, bed, group)
    wide = 1.2 + 0.5 * len(beside)
    corners = shapely.get_coordinates(FLOOR.exterior)
    sides = [(a, b) for a, b in zip(corners, corners[1:]) if np.hypot(*(b - a)) >= wide + 2 * places._APART]
    found: dict[int, list[tuple[float, float]]] = {}
    for x, y, turned in spots:
        points = shapely.get_coordinates([mark(places._along(o, bed, (x, y, turned))) for o in group])
        ahead = np.array([np.cos(turned), np.sin(turned)])
        for k, (a, b) in enumerate(sides):
            length = np.hypot(*(b - a))
            along = (b - a) / length
            inward = np.array([-along[1], along[0]])
            at, off = (points - a) @ along, ((points - a) @ inward).min()
            if inward @ ahead > 0.999 and abs(off) < 0.01 and -0.1 < at.min() and at.max() < length + 0.1:
                assert off == pytest.approx(places._APART, abs=1e-6)
                found.setdefault(k, []).append((at.min(), length - at.max()))
    assert sum(map(len, found.values())) == len(spots) and len(found) == len(sides)
    for row in found.values():
        assert min(row)[0] == pytest.approx(places._APART, abs=1e-6)
        assert min(end for _, end in row) == pytest.approx(places._APART, abs=1e-6)
        assert np.diff(sorted(start for start, _ in row)).max() < 2 * places.STEP


def test_one_of_several_solids_in_a_wall_is_in_it() -> None:
    """Slabs of the living room's floor, some of which reach into its south wall; what passes a door is in none."""
    whole = building(h.plan())

    def within(*lows: float, x: float = 2.0) -> bool:
        return whole.in_wall(convex.of([slab((x, low, 0.2), (x + 0.2, low + 0.5, 0.6)) for low in lows]))

    assert not within(0.1) and not within(0.1, 1.0) and not within(-0.9 * INTO_WALL)
    assert within(-0.01) and within(0.1, -0.01) and within(-0.01, 0.1)
    assert not within(1.2, x=3.95) and within(0.4, x=3.95)
