"""Pieces of one room go together."""

import pytest

from apartgen.schemas.layout import Box
from apartgen.stages.retrieve.matching import sets
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.embedded import Embedded


@pytest.fixture(scope="module")
def embedded() -> Embedded:
    return Embedded(RetrieveConfig())


def unit(category: str, height: float = 0.9) -> Box:
    return Box(id=f"kitchen_1_{category}_1", room="kitchen_1", category=category, center=(0, 0, height / 2),
               size=(0.6, 0.6, height), yaw=0.0, latent=[0.0] * 32)  # fmt: skip


@pytest.mark.parametrize("height", [0.88, 2.1])
def test_an_oven_beside_a_hob_is_fitted_into_the_kitchen(embedded: Embedded, height: float) -> None:
    objects = [unit("hob"), unit("kitchen_base"), unit("oven", height)]
    styles = {style for style, _ in sets.designs(objects, sets.wishes(objects, 2.6), embedded)}
    assert len(styles) == 1 and styles <= embedded.styles("hob")


def test_an_oven_without_a_hob_is_a_cooker(embedded: Embedded) -> None:
    objects = [unit("kitchen_base"), unit("oven")]
    style = sets.designs(objects, sets.wishes(objects, 2.6), embedded)[1][0]
    assert style in embedded.styles("oven") - embedded.styles("hob")


def test_units_under_one_worktop_are_as_high_and_deep(embedded: Embedded) -> None:
    objects = [unit("hob", 0.9), unit("kitchen_base", 0.88), unit("oven", 0.86), unit("fridge", 1.8)]
    sizes = [wish.size for wish in sets.wishes(objects, 2.6)]
    assert len({(size[0], size[2]) for size in sizes[:3]}) == 1 and sizes[3][2] == 1.8


@pytest.mark.parametrize(("deeper", "kept"), [(0.017, False), (0.08, True)])
def test_what_fills_a_corner_reaches_the_units_round_it(deeper: float, kept: bool) -> None:
    corner = unit("kitchen_corner").model_copy(update={"size": (0.6 + deeper, 1.2, 0.9)})
    depth = sets.wishes([unit("kitchen_sink"), corner, unit("kitchen_base")], 2.6)[1].size[0]
    assert depth == pytest.approx(0.6 + deeper if kept else 0.6)
