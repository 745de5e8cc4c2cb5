"""Textures tile, have their material's colour, and the bands that their names promise."""

import numpy as np
import pytest

from apartgen.stages.things import materials
from apartgen.stages.things.materials import PALETTE
from apartgen.stages.things.prints import SHEETS


def grey(name: str) -> np.ndarray:
    return np.asarray(materials.texture(name), float).mean(-1)


def bands(profile: np.ndarray, dark: float) -> int:
    """How many dark bands a closed profile has."""
    low = profile < profile.mean() * (1 - dark)
    return int((low & ~np.roll(low, 1)).sum())


@pytest.mark.parametrize("name", materials.textures())
def test_a_texture_tiles_and_has_about_the_colour_of_its_material(name: str) -> None:
    image = np.asarray(materials.texture(name), float)
    assert image.shape == (256, 256, 3)
    assert image.mean((0, 1)) / 255 == pytest.approx(PALETTE[name].color[:3], abs=0.1)
    for axis in (1,) if name in SHEETS else (0, 1):  # a picture goes on to its sides at most
        steps = np.abs(np.diff(image, axis=axis)).mean((1 - axis, 2))
        across = np.abs(image.take(0, axis) - image.take(-1, axis)).mean()
        assert across <= 1.5 * steps.max() + 1
    assert image.std() > 1


def test_patterns_by_their_bands() -> None:
    # Two tiles a side, their joints at a quarter and three quarters of the image.
    for axis in (0, 1):
        tiles = grey("floor_tile").mean(axis)
        assert bands(tiles, 0.1) == 2
        assert {round(int(k) / 64) for k in np.argsort(tiles)[:4]} == {1, 3}
    assert bands(grey("floor_oak").mean(1), 0.15) == 10, "boards"
    assert bands(grey("rug_stripe").mean(0), 0.15) == 5 and bands(grey("rug_stripe").mean(1), 0.15) == 0


def test_a_lattice_is_the_same_from_all_sides() -> None:
    image = grey("rug_berber")
    line = image < 0.7 * np.median(image)
    assert 0.03 < line.mean() < 0.3
    for turned in (line.T, np.roll(line[::-1], 1, 0), np.roll(line[:, ::-1], 1, 1)):
        assert (turned & line).sum() > 0.8 * line.sum()


def test_veins_are_dark_in_light_marble_and_light_in_dark() -> None:
    for name, sign in (("marble", -1), ("dark_marble", 1)):
        off = grey(name) - np.median(grey(name))
        assert np.sign((off**3).mean()) == sign


def test_every_material_may_be_weighed_and_seen_through_only_where_it_is_glass() -> None:
    for name, material in PALETTE.items():
        assert 20 <= materials.density(name) <= 9000 and 0 <= material.metalness <= 1 and 0 < material.roughness <= 1
        assert (material.color[3] < 1) == (name in ("glass", "smoked_glass", "sheer"))
        assert materials.span(name) > 0 and (material.texture is None or materials.span(name) < 5)


@pytest.mark.parametrize("name", PALETTE)
def test_a_material_is_one_that_viewers_take(name: str) -> None:
    """glTF and USD: colour, roughness and metalness from 0 to 1; what is solid weighs 20 kg to 9 t a cubic metre."""
    one = PALETTE[name]
    assert all(0 <= part <= 1 for part in (*one.color, one.roughness, one.metalness))
    assert 20 <= materials.density(name) <= 9000


def test_only_metals_and_mirrors_are_metal() -> None:
    metals = {"steel", "chrome", "aluminium", "brass", "copper", "black_metal", "white_metal", "mirror"}
    assert {name for name, material in PALETTE.items() if material.metalness > 0} == metals


def test_prints_are_pictures_and_all_different() -> None:
    images = {name: np.asarray(materials.texture(name), float) for name in SHEETS}
    for name, image in images.items():
        others = [other for key, other in images.items() if key != name]
        assert min(np.abs(image - other).mean() for other in others) > 5, name
    for name in (name for name in SHEETS if SHEETS[name][0] in ("hills", "shore", "meadow")):
        sky, ground = images[name][:40], images[name][-40:]
        assert sky.mean() > ground.mean() + 10, f"{name} stands on its head"
        assert sky.mean(1).std(0).mean() < ground.std()


def test_metals_and_mirrors_alone_shine_as_metal() -> None:
    """No stone weighs three tonnes a cubic metre, and aluminium does not either."""
    metal = {name for name, material in PALETTE.items() if material.metalness}
    assert {name for name in PALETTE if materials.density(name) > 3000} | {"aluminium", "mirror"} == metal
