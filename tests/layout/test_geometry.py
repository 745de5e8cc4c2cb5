"""Differentiable geometry against the exact one, and gradients against finite differences."""

import numpy as np
import pytest
import torch

from apartgen.stages.layout import geometry
from apartgen.stages.layout.geometry import Boxes
from apartgen.stages.space import boxes as exact
from apartgen.stages.things.categories import CATEGORIES, TABLE
from apartgen.stages.things.categories import reach as exact_reach


def random_boxes(rng: np.random.Generator, n: int = 12, rooms: int = 2) -> Boxes:
    yaw = torch.from_numpy(rng.uniform(-3, 3, (rooms, n)))
    size = torch.from_numpy(rng.uniform(0.3, 2.0, (rooms, n, 3)))
    category = torch.from_numpy(rng.integers(len(CATEGORIES), size=(rooms, n)))
    return Boxes(
        torch.from_numpy(rng.uniform(-1.5, 1.5, (rooms, n, 3))),
        size,
        torch.stack([yaw.cos(), yaw.sin()], -1),
        category,
        torch.ones(rooms, n),
        geometry.reach(category, size).double(),
        torch.zeros(rooms, n),
    )


def as_exact(boxes: Boxes) -> exact.Boxes:
    yaw = torch.atan2(boxes.heading[..., 1], boxes.heading[..., 0])
    return exact.Boxes(boxes.center.numpy(), boxes.size.numpy(), yaw.numpy())


@pytest.mark.parametrize("seed", range(6))
def test_iou_equals_exact_clipping(seed: int) -> None:
    boxes = random_boxes(np.random.default_rng(seed))
    wanted = exact.iou(as_exact(boxes), as_exact(boxes))
    found = np.zeros_like(wanted)
    pairs = geometry.close_pairs(boxes, boxes)
    found[tuple(pairs.T.numpy())] = geometry.iou(boxes, boxes, pairs).numpy()
    diagonal = np.arange(wanted.shape[-1])
    wanted[:, diagonal, diagonal] = 0
    np.testing.assert_allclose(found, wanted, atol=1e-5)
    assert (wanted > 0.01).sum() > 10


def test_places_that_nothing_fills_meet_nothing() -> None:
    boxes = random_boxes(np.random.default_rng(1))
    filled = torch.ones_like(boxes.filled)
    filled[:, ::3] = 0
    bare = Boxes(boxes.center, boxes.size, boxes.heading, boxes.category, filled, boxes.reach, boxes.empty)
    met = {tuple(pair) for pair in geometry.close_pairs(boxes, boxes).tolist()}
    left = {tuple(pair) for pair in geometry.close_pairs(bare, bare).tolist()}
    assert left == {(r, i, j) for r, i, j in met if i % 3 and j % 3} and len(left) < len(met)


def test_iou_gradient_equals_finite_difference() -> None:
    boxes = random_boxes(np.random.default_rng(3), n=4, rooms=1)
    pairs = geometry.close_pairs(boxes, boxes)

    def total(center: torch.Tensor, heading: torch.Tensor) -> torch.Tensor:
        unit = heading / heading.norm(dim=-1, keepdim=True)
        moved = Boxes(center, boxes.size, unit, boxes.category, boxes.filled, boxes.reach, boxes.empty)
        return geometry.iou(moved, moved, pairs).sum()

    assert len(pairs) >= 4
    assert torch.autograd.gradcheck(
        total, (boxes.center.requires_grad_(), boxes.heading.clone().requires_grad_()), eps=1e-6, atol=1e-4
    )


def test_reach_equals_vocabulary() -> None:
    for i, name in enumerate(CATEGORIES):
        sizes = np.random.default_rng(i).uniform(TABLE[name].min, TABLE[name].max, (20, 3))
        found = geometry.reach(torch.full((20,), i), torch.from_numpy(sizes).float())
        np.testing.assert_allclose(found.numpy(), exact_reach(name, sizes), atol=1e-4)


def test_outside_of_an_l_shaped_room() -> None:
    corners = np.array([[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]], float)
    ends = np.roll(corners, -1, 0)
    room = geometry.Floor(
        *(torch.from_numpy(a)[None] for a in (corners, ends)),
        torch.ones(1, 6, dtype=torch.bool),
        torch.zeros(1, 0, 4, 2),
        torch.zeros(1, 0),
        torch.tensor([2.6]),
        torch.zeros(1, 0),
    )
    points = torch.tensor([[[1, 1], [3, 3], [2.5, 2.1], [-0.5, 1], [5, 3], [1.9, 3.9]]], dtype=torch.float64)
    far = geometry.outside(points, room)[0]
    np.testing.assert_allclose(far.numpy(), [0, 1, 0.1, 0.5, np.sqrt(2), 0], atol=1e-6)


def test_extended_box_keeps_its_back() -> None:
    boxes = random_boxes(np.random.default_rng(1))
    grown = boxes.extended()
    back = boxes.center[..., :2] - boxes.heading * boxes.size[..., :1] / 2
    kept = grown.center[..., :2] - grown.heading * grown.size[..., :1] / 2
    torch.testing.assert_close(back, kept)
    torch.testing.assert_close(grown.size[..., 0], boxes.size[..., 0] + boxes.reach)
