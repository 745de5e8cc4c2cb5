"""Segments that cross, against shapely: on a coarse raster, so that many only touch or lie in one line."""

import numpy as np
import pytest
import shapely

from apartgen.stages.use.rules import neighbours


@pytest.mark.parametrize("seed", range(4))
def test_segments_cross_where_their_insides_meet_in_a_point(seed):
    rng, found = np.random.default_rng(seed), []
    for a, b, p, q in rng.integers(0, 5, (400, 4, 2)).astype(float):
        if (a == b).all() or (p == q).all():
            continue
        one, other = shapely.LineString([a, b]), shapely.LineString([p, q])
        found.append(one.crosses(other))
        assert neighbours._cross(a, b, p, q) is neighbours._cross(p, q, b, a) is found[-1], (a, b, p, q)
    assert 0.1 < np.mean(found) < 0.6
