"""Swept volumes against hand-computed cases and against many sampled joint positions."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from apartgen.schemas.layout import Box
from apartgen.schemas.retrieve import AssetKey, Furnishing, Joint
from apartgen.stages.space import boxes, sweeps
from apartgen.stages.things import categories

KEY = AssetKey(library="test", id="x")


def drawer() -> Joint:
    """A drawer filling a 0.6 × 0.8 × 0.5 chest that comes out by 0.4."""
    return Joint(
        name="drawer", type="slide", axis=(1, 0, 0), origin=(0, 0, 0), range=(0, 0.4), part="slider_drawer",
        extent=((-0.28, -0.38, -0.2), (0.30, 0.38, 0.2)),
    )


def leaf() -> Joint:
    """A 0.8 m leaf, 2 cm thick, on the front of the chest, hung on the left, opening to the front by 90°."""
    return Joint(
        name="door", type="hinge", axis=(0, 0, 1), origin=(0.30, 0.40, 0), range=(0, np.pi / 2), part="hinge_door",
        extent=((0.28, -0.40, -0.2), (0.30, 0.40, 0.2)),
    )


def chest(*joints: Joint, yaw: float = 0.0) -> Furnishing:
    return Furnishing(
        id="a", room="r_1", category="chest", center=(1, 2, 0.25), size=(0.6, 0.8, 0.5), yaw=yaw, asset=KEY,
        joints=list(joints),
    )


def test_a_drawer_sweeps_its_travel() -> None:
    grown = sweeps.extended([chest(drawer())])
    assert grown.size[0] == pytest.approx([1.0, 0.8, 0.5])
    assert grown.center[0] == pytest.approx([1.2, 2, 0.25])


def test_a_leaf_sweeps_a_quarter_disc() -> None:
    lo, hi = sweeps.swept(leaf())
    # The outer edge is farthest to the right when its inner corner passes the hinge's line.
    assert lo == pytest.approx([0.28, 0.40 - np.hypot(0.8, 0.02), -0.2])
    assert hi == pytest.approx([0.30 + 0.80, 0.40, 0.2])
    grown = sweeps.extended([chest(leaf(), yaw=np.pi / 2)])
    assert grown.size[0, 0] == pytest.approx(0.6 + 0.8)
    assert grown.center[0, 1] == pytest.approx(2.4)


def test_an_open_leaf_stands_at_its_hinge() -> None:
    parts, owner = sweeps.opened([chest(), chest(leaf())])
    assert owner.tolist() == [1]
    assert parts.size[0] == pytest.approx([0.8, 0.02, 0.4])
    assert parts.center[0, :2] == pytest.approx([1 + 0.30 + 0.40, 2 + 0.39])


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6))
def test_swept_bounds_are_those_of_all_positions(seed: int) -> None:
    rng = np.random.default_rng(seed)
    lo = rng.uniform(-1, 0.5, 3)
    span = sorted(rng.uniform(-3, 3, 2))
    joint = Joint(
        name="j", type="hinge", axis=tuple(rng.normal(size=3)), origin=tuple(rng.normal(size=3)), range=tuple(span),
        part="hinge_door", extent=(tuple(lo), tuple(lo + rng.uniform(0.05, 1, 3))),
    )
    low, high = sweeps.swept(joint)
    sampled = [sweeps.moved(joint, t) for t in np.linspace(*span, 400)]
    assert low == pytest.approx(np.min([s[0] for s in sampled], axis=0), abs=2e-4)
    assert high == pytest.approx(np.max([s[1] for s in sampled], axis=0), abs=2e-4)


@pytest.mark.parametrize("name", categories.CATEGORIES)
def test_before_an_asset_is_chosen_the_category_says_how_far(name: str) -> None:
    kind = categories.TABLE[name]
    box = Box(id="a", room="r_1", category=name, center=(0, 0, 1), size=kind.size, yaw=0)
    grown = sweeps.extended([box])
    assert grown.size[0] == pytest.approx(np.array(kind.size) + [categories.reach(name, kind.size), 0, 0])
    assert grown.center[0, 0] - grown.size[0, 0] / 2 == pytest.approx(-kind.size[0] / 2)
    assert sweeps.articulated([box])[0] == kind.articulated
    third = sweeps.published([box]).size[0, 0]
    assert third == pytest.approx(kind.size[0] * (4 / 3 if kind.articulated else 1))


def test_an_asset_without_joints_does_not_open() -> None:
    assert sweeps.extended([chest()]).size == pytest.approx(boxes.of([chest()]).size)
    assert not sweeps.articulated([chest()])[0]


def test_unknown_extents_fall_back_to_the_category() -> None:
    blind = drawer().model_copy(update={"extent": None})
    assert sweeps.extended([chest(blind)]).size[0, 0] == pytest.approx(0.6 * 1.75)
    parts, owner = sweeps.opened([chest(blind)])
    assert owner.tolist() == [0] and parts.size[0, 0] == pytest.approx(0.6 * 0.75)
