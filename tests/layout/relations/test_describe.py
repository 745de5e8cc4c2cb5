"""What an object is in its reference's frame, and that this says where it stands."""

import numpy as np
import pytest

from apartgen.stages.layout.relations import describe, tokens
from apartgen.stages.layout.relations.tokens import OBJECT, WALL


def boxes(rng: np.random.Generator, n: int) -> tokens.Array:
    """Objects that stand near the origin, turned by any multiple of 15 degrees."""
    size, low = rng.uniform(0.2, 2.2, (n, 3)), rng.uniform(0, 1.5, n)
    yaw = rng.integers(24, size=n) * np.pi / 12
    return np.column_stack([rng.uniform(-2, 2, (n, 2)), yaw, size[:, :2], low, low + size[:, 2]])


def described(objects: tokens.Array, references: tokens.Array, kind: int) -> describe.Attributes:
    view = tokens.seen(objects[:, None], references)[:, 0]
    return describe.describe(view, references[:, 3:5] / 2, np.full(len(objects), kind))


@pytest.mark.parametrize("seed", range(5))
def test_a_description_says_where_an_object_stands(seed: int) -> None:
    rng = np.random.default_rng(seed)
    objects, references = boxes(rng, 400), boxes(rng, 400)
    said = described(objects, references, OBJECT)
    back = describe.placed(references, said)
    gap = np.hypot(*(back[:, :2] - objects[:, :2]).T)
    beside = said.fit & (describe.GAPS[said.gap] < 0.6) & (said.side != describe.OVER)
    over = said.fit & (said.side == describe.OVER)
    assert beside.sum() > 50 and over.sum() > 20
    assert gap[beside].max() <= 0.0105
    assert gap[over].max() < 1e-6
    turn = (back[:, 2] - objects[:, 2] + np.pi) % (2 * np.pi) - np.pi
    assert np.abs(turn).max() <= np.radians(2.5) + 1e-6
    assert np.allclose(back[:, 3:], objects[:, 3:])


def test_a_nightstand_is_to_the_left_of_its_bed_at_its_head() -> None:
    bed = np.array([[1.0, 1.0, np.pi / 2, 2.0, 1.6, 0.0, 0.5]])  # looks along y
    nightstand = np.array([[1.0 - 0.8 - 0.04 - 0.25, 0.2, np.pi / 2, 0.4, 0.5, 0.0, 0.5]])
    said = described(nightstand, bed, OBJECT)
    assert said.heading[0] == 0 and said.side[0] == describe.LEFT
    assert describe.GAPS[said.gap[0]] == pytest.approx(0.04)
    assert said.along[0] == pytest.approx(-0.8)  # both backs on one line: -1.0 + 0.4 / 2
    view = tokens.seen(bed[:, None], bed)
    lines = describe.aligned(view, np.array([0]), np.array([0.2]))
    assert lines[0, 0, 1] == pytest.approx(-0.8)


def test_what_stands_at_a_wall_is_before_it_however_deep_the_gap() -> None:
    wall = np.array([[0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 2.6]])
    shelf = np.array([[0.14, 1.2, 0.0, 0.3, 0.8, 0.0, 1.8]])  # one centimetre into the plaster
    said = described(shelf, wall, WALL)
    assert said.side[0] == describe.FRONT and abs(describe.GAPS[said.gap[0]]) <= 0.01
    assert said.along[0] == pytest.approx(1.2)


@pytest.mark.parametrize("quarter", range(4))
def test_a_description_does_not_hang_on_how_the_room_is_turned(quarter: int) -> None:
    rng = np.random.default_rng(quarter)
    objects, references = boxes(rng, 200), boxes(rng, 200)
    one = described(objects, references, OBJECT)
    two = described(tokens.turned(objects, quarter), tokens.turned(references, quarter), OBJECT)
    assert (one.side == two.side).mean() > 0.99
    same = one.side == two.side
    assert np.abs(one.along - two.along)[same].max() < 1e-5
    assert np.abs(describe.GAPS[one.gap] - describe.GAPS[two.gap])[same & one.fit].max() < 0.151


def test_mirrored_rooms_have_left_and_right_exchanged() -> None:
    rng = np.random.default_rng(3)
    objects, references = boxes(rng, 300), boxes(rng, 300)
    one, two = described(objects, references, OBJECT), described(
        tokens.mirrored(objects), tokens.mirrored(references), OBJECT)
    swapped = np.array([describe.FRONT, describe.BACK, describe.RIGHT, describe.LEFT, describe.OVER])
    assert (swapped[one.side] == two.side).mean() > 0.99


@pytest.mark.parametrize("axis, expected", [(0, [1.0, 0.7, 1.3, 1.7, 0.3]), (1, [5.0, 4.0, 6.0, 6.4, 3.6])])
def test_five_ways_to_be_aligned_with_something(axis: int, expected: list[float]) -> None:
    """Something .4 m long, with what reaches .5 m from 1.0 ahead and 1.2 m from 5.0 to the left: middles, low edges,
    high edges, at its high edge, at its low edge."""
    token = np.array([[1.0, 5.0, 0.0, 0.5, 1.2, 0.0, 0.0, 0.0, 0.0]])
    found = describe.aligned(token, np.array(axis), np.array(0.2))
    assert found[0] == pytest.approx(expected)
