"""How near others of the category asked for stand, against distances that shapely finds."""

import numpy as np
import pytest
from shapely import Point
from shapely.affinity import rotate, translate
from shapely.geometry import box

from apartgen.stages.layout.relations import around
from apartgen.stages.layout.relations.tokens import seen


@pytest.mark.parametrize("seed", range(4))
def test_the_nearest_of_the_category_counts_as_far_as_its_middle_is(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n, asked, there = 6, np.array([[0, 1, 2, -1, 0]]), np.array([[6, 6, 6, 6, 3]])
    boxes = np.column_stack([rng.uniform(-1, 1, (n, 2)), rng.uniform(-3, 3, n), rng.uniform(0.2, 1.0, (n, 2)),
                             np.zeros(n), np.ones(n)])[None]
    category = rng.integers(2, size=(1, n))
    found = around.alike(seen(boxes[:, None], boxes), boxes, category, asked, there)
    floor = [translate(rotate(box(-d / 2, -w / 2, d / 2, w / 2), yaw, use_radians=True, origin=(0, 0)), x, y)
             for x, y, yaw, d, w, *_ in boxes[0]]
    far = np.array([[one.distance(Point(o[:2])) for o in boxes[0]] for one in floor])
    assert found.shape == (1, 5, n)
    for q, (wanted, count) in enumerate(zip(asked[0], there[0])):
        same = (category[0, :count] == wanted) & (wanted >= 0)
        true = np.exp(-far[:, :count][:, same] / around.NEAR).max(1, initial=0.0)
        assert found[0, q] == pytest.approx(true, abs=1e-5)
