"""When a joint that an artifact gives is the one that its asset has."""

import pytest

from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.placed import _same

HINGE = Joint(name="door", type="hinge", axis=(0.0, 0.0, 1.0), origin=(0.2, 0.3, 0.0), range=(0.0, 1.5), part="door")


@pytest.mark.parametrize("origin, same", [
    ((0.2, 0.3, 0.0), True), ((0.2, 0.3, 0.9), True),  # anywhere on the axis turns alike
    ((0.25, 0.3, 0.0), False), ((0.2, 0.25, 0.9), False),
])
def test_a_hinge_may_be_given_anywhere_on_its_axis(origin: tuple[float, float, float], same: bool) -> None:
    assert _same(HINGE.model_copy(update={"origin": origin}), HINGE, "origin") is same


def test_a_slide_has_no_place_but_a_direction() -> None:
    slide = HINGE.model_copy(update={"type": "slide"})
    assert _same(slide.model_copy(update={"origin": (9.0, 9.0, 9.0)}), slide, "origin")
    assert not _same(slide.model_copy(update={"axis": (1.0, 0.0, 0.0)}), slide, "axis")
