"""What an object would meet at every offset, how much room is left beside it, and what walls have of free stretches."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import softmax
from shapely.geometry import box

from apartgen.stages.layout.relations import clear

STEP, BINS, SLACK = 0.03, 401, 0.015
OBJECT, WALL, WAY, LIGHT = 1, 2, 3, 4


def around(solids: list[tuple[float, ...]], sorts: list[int], axis: int, other: float, half: tuple[float, float],
           low: float = 0.0, high: float = 0.8) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Depths (BINS, SORTS) and rooms (BINS, 4) among solids [x, y, half extent along x, along y, low, high]."""
    seen = np.zeros((1, len(solids), 9), np.float32)
    for k, (x, y, ex, ey, lowest, highest) in enumerate(solids):
        seen[0, k, :7] = x, y, 0, ex, ey, lowest, highest
    told = (seen, np.array([sorts]), np.array([axis]), np.array([[other, low, high]], np.float32),
            np.array([half], np.float32), BINS, STEP, SLACK)
    return clear.depths(*told)[0], clear.rooms(*told)[0]


def test_a_bed_between_a_wall_and_a_cupboard() -> None:
    """Its middle at -.3: its left side is at .5, .4 from the cupboard; its right at -1.1, .9 from the wall; nothing
    stands at its foot, and what is above or below it is not in its way."""
    cupboard, wall = (0.3, 1.2, 0.3, 0.3, 0.0, 2.0), (1.0, -5.0, 9.0, 3.0, 0.0, 2.6)
    shelf = (1.0, 0.0, 0.2, 2.0, 1.5, 1.8)
    deep, room = around([cupboard, wall, shelf], [OBJECT, WALL, OBJECT], 1, 1.0, (0.8, 1.0))
    at = BINS // 2 - 10
    assert room[at] == pytest.approx([0.4, 0.9, clear.FAR, clear.FAR], abs=1e-5)
    assert not deep[at].any()
    into = BINS // 2 + 10  # left side at 1.1: 20 cm in the cupboard
    assert room[into, 0] == 0
    assert deep[into, 0] == pytest.approx((0.2 - SLACK) / clear.DEEPEST, abs=1e-4)


def test_light_of_windows_takes_no_room_and_ways_do() -> None:
    zone = (2.0, 0.0, 0.5, 2.0, 0.0, 2.0)
    for sort, far in ((LIGHT, clear.FAR), (WAY, 0.5)):
        _, room = around([zone], [sort], 1, 0.5, (0.4, 0.5))
        assert room[BINS // 2, 2] == pytest.approx(far, abs=1e-5)


@pytest.mark.parametrize("seed", range(12))
def test_room_is_the_distance_between_rectangles_that_face_each_other(seed: int) -> None:
    rng = np.random.default_rng(seed)
    solids = [(*rng.normal(0, 1.5, 2), *rng.uniform(0.05, 0.8, 2), 0.0, 1.0) for _ in range(6)]
    axis, other, half = int(rng.integers(2)), float(rng.normal()), tuple(rng.uniform(0.1, 0.9, 2))
    _, room = around(solids, [OBJECT] * 6, axis, other, half)
    for k in rng.integers(0, BINS, 40):
        middle = np.empty(2)
        middle[axis], middle[1 - axis] = (k - BINS // 2) * STEP, other
        reach = np.array(half if axis == 0 else half[::-1])
        own = box(*(middle - reach), *(middle + reach))
        for way, (side, sign) in enumerate(((axis, 1), (axis, -1), (1 - axis, 1), (1 - axis, -1))):
            low, high = middle - reach + SLACK, middle + reach - SLACK
            low[side], high[side] = sorted((middle[side], middle[side] + sign * (reach[side] + clear.FAR)))
            lane = box(*low, *high)
            near = [own.distance(box(x - a, y - b, x + a, y + b)) for x, y, a, b, _, _ in solids
                    if lane.intersection(box(x - a, y - b, x + a, y + b)).area > 0
                    and sign * ((x, y)[side] - middle[side]) > 0]
            assert room[k, way] == pytest.approx(min([*near, clear.FAR]), abs=2 * SLACK)


def stretches(wall: tuple[float, ...], solids: list[tuple[float, ...]], sorts: list[int]) -> NDArray[np.float32]:
    """The longest free stretches (Q, D) of a wall among its first 0, 1, 2 … solids [x, y, yaw, depth, width]."""
    boxes = np.zeros((1, 1 + len(solids), 7), np.float32)
    boxes[0, 0, :5], boxes[0, :, 6] = wall, 1.0
    for k, row in enumerate(solids):
        boxes[0, 1 + k, :5] = row
    sort = np.array([[WALL, *sorts]])
    solid = boxes.copy()
    solid[0, 0, 3] = 6.0  # the wall's own body lies behind it
    solid[0, 0, :2] -= 3 * np.array([np.cos(wall[2]), np.sin(wall[2])])
    there = 1 + np.arange(len(solids) + 1)[None]
    return clear.stretches(boxes, np.arange(1 + len(solids))[None] == 0, solid, sort, there, clear.DEEP)[0, :, 0]


@pytest.mark.parametrize("turn", [0.0, 0.7, np.pi / 2, -2.5])
def test_what_a_door_a_cupboard_and_a_table_leave_of_a_wall(turn: float) -> None:
    """Of 4 m a door's way takes 1 m at one end, a cupboard 1 m at the other; a table 1.35 m off stands before the
    middle 50 cm of what is deeper; a rug and light take nothing. However the wall is turned."""
    c, s = np.cos(turn), np.sin(turn)

    def at(out: float, along: float, depth: float, width: float) -> tuple[float, ...]:
        return (out * c - along * s + 2, out * s + along * c - 1, turn, depth, width)

    solids = [at(0.45, 1.5, 0.9, 1), at(0.2, -1.5, 0.4, 1), at(1.6, 0, 0.5, 0.5), at(1, 0, 2, 4), at(1, 0, 2, 4)]
    found = stretches(at(0, 0, 0, 4), solids, [WAY, OBJECT, OBJECT, 0, LIGHT])
    assert found[0] == pytest.approx([4] * 4, abs=1e-4)
    assert found[1] == pytest.approx([3] * 4, abs=1e-4)
    assert found[2] == pytest.approx([2] * 4, abs=1e-4)
    assert found[3] == pytest.approx([2, 2, 2, 0.75], abs=1e-4)
    assert found[5] == pytest.approx([2, 2, 2, 0.75], abs=1e-4)


@pytest.mark.parametrize("offset", [0.0, 900.0, -900.0])
@pytest.mark.parametrize("sharp", [1.0, 2.5])
def test_rows_are_picked_as_often_as_their_softmax_says(offset: float, sharp: float) -> None:
    """Whatever is added to all of a row; numbers that lie evenly in [0, 1) pick each as often as its share."""
    logits = np.array([[0.0, 2.0, -1.0, 1.0, 3.0], [5.0, 5.0, -9.0, 4.0, 5.0], [-3.0, -3.0, -3.0, -3.0, -3.0]])
    chance = np.tile((np.arange(4000) + 0.5) / 4000, (3, 1))
    found = clear.picked((logits + offset).astype(np.float32), chance, sharp, 1e-4)
    for row, picks in zip(softmax(sharp * logits, axis=1), found):
        kept = np.where(row < 1e-4 * row.max(), 0, row)
        assert np.bincount(picks, minlength=5) / 4000 == pytest.approx(kept / kept.sum(), abs=6e-4)
        assert (np.diff(picks) >= 0).all()


@pytest.mark.parametrize("least, there", [(0.2, {1, 2}), (0.04, {0, 1, 2}), (0.9, {1})])
def test_what_is_below_a_share_of_the_likeliest_is_never_picked(least: float, there: set[int]) -> None:
    """e⁻³ = .0498, 1, e⁻¹ = .368, e⁻⁷ of the likeliest."""
    chance = np.linspace(0, 1 - 1e-9, 2001)[None]
    found = clear.picked(np.array([[-3.0, 0.0, -1.0, -7.0]], np.float32), chance, 1.0, least)
    assert set(found[0].tolist()) == there
