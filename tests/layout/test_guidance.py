"""Every energy is zero when satisfied, positive when not, and its gradient leads down."""

import numpy as np
import pytest
import torch
from rooms_for_tests import some_rooms

from apartgen.stages import registry
from apartgen.stages.layout import geometry, guided
from apartgen.stages.layout.config import LayoutConfig, ModelConfig
from apartgen.stages.layout.diffusion import Prediction
from apartgen.stages.layout.features import CLASS, EMPTY, N_CLASSES, PLACE, Objects, encode
from apartgen.stages.layout.geometry import Boxes, floor_of
from apartgen.stages.layout.schedule import ALPHA_BAR
from apartgen.stages.things.categories import CATEGORIES

MODEL = ModelConfig()
SPATIAL = [name for name in registry.members("apartgen.stages.layout.guidance") if name not in ("quantity",)]


def boxes(*rows: tuple[str, float, float, float]) -> Boxes:
    """One room of objects (category, x, y, yaw) 0.8 × 0.8 × 0.8 m on the floor."""
    category = torch.tensor([[CATEGORIES.index(row[0]) for row in rows]])
    center = torch.tensor([[[row[1], row[2], 0.4] for row in rows]])
    yaw = torch.tensor([[row[3] for row in rows]])
    size = torch.full_like(center, 0.8)
    n = len(rows)
    return Boxes(
        center,
        size,
        torch.stack([yaw.cos(), yaw.sin()], -1),
        category,
        torch.ones(1, n),
        geometry.reach(category, size),
        torch.zeros(1, n),
    )


def energy(name: str, found: Boxes) -> float:
    return float(registry.load("apartgen.stages.layout.guidance", name).energy(found, floor_of(some_rooms(1)))[0])


def test_articulation_sees_the_blocked_drawer_only() -> None:
    facing = boxes(("chest", 0.0, 0.0, 0.0), ("plant", 1.2, 0.0, 0.0))
    behind = boxes(("chest", 0.0, 0.0, np.pi), ("plant", 1.2, 0.0, 0.0))
    clear = boxes(("sofa", 0.0, 0.0, 0.0), ("plant", 1.2, 0.0, 0.0))
    assert energy("articulation", facing) > 0
    assert energy("articulation", behind) == 0
    assert energy("articulation", clear) == 0


def test_articulation_equals_eq_4_by_hand() -> None:
    """b′ of the chest is 0.8 + 0.6 deep; it shares 0.2 × 0.8 × 0.8 with the plant."""
    found = boxes(("chest", 0.0, 0.0, 0.0), ("plant", 1.2, 0.0, 0.0))
    shared, volume = 0.2 * 0.64, 0.8**3
    assert energy("articulation", found) == pytest.approx(shared / (1.4 * 0.64 + volume - shared), rel=1e-4)


def test_walkway_wants_gaps_flush_or_wide() -> None:
    """Two 0.8 m boxes in the middle of a room, 1.1 m from any wall: only the gap between them counts."""
    room = some_rooms(1, 3)
    room.polygon[0, :4] = [[-2.5, -2.5], [2.5, -2.5], [2.5, 2.5], [-2.5, 2.5]]
    module = registry.load("apartgen.stages.layout.guidance", "walkway")

    def value(gap: float, other: str = "sofa") -> float:
        found = boxes(("chest", -0.4 - gap / 2, 0, 0), (other, 0.4 + gap / 2, 0.1, np.pi))
        return float(module.energy(found, floor_of(room))[0])

    assert value(0.02) == value(0.6) == value(0.29, "rug") == 0
    middle = (module.FLUSH + module.PASS) / 2
    assert value(middle) == pytest.approx(1, abs=1e-4) and 0 < value(0.1) < 1
    # 0.3 m before the east wall, its sides more than a walker's width from the others.
    alone = boxes(("chest", 2.5 - 0.4 - 0.3, 0.0, 0.0))
    share = 4 * (0.3 - module.FLUSH) * (module.PASS - 0.3) / (module.PASS - module.FLUSH) ** 2
    assert float(module.energy(alone, floor_of(room))[0]) == pytest.approx(share, rel=1e-3)


def test_inside_and_openings() -> None:
    assert energy("inside", boxes(("sofa", 0, 0, 0.3))) == 0
    assert energy("inside", boxes(("sofa", 4, 0, 0.3))) > 0
    south = float(some_rooms(1).polygon[0, 0, 1])
    assert energy("openings", boxes(("sofa", 0.0, south + 0.4, 0))) == pytest.approx(0.8 * 0.8, rel=1e-4)
    assert energy("openings", boxes(("sofa", 0.0, 0.6, 0))) == 0


@pytest.mark.parametrize("name, found", [
    ("articulation", [("chest", 0.0, 0.0, 0.0), ("plant", 1.1, 0.1, 0.2)]), ("inside", [("sofa", 2.6, 0.1, 0.4)]),
    ("openings", [("sofa", 0.3, -1.27, 0.2)]), ("walkway", [("chest", -0.6, 0.0, 0.0), ("sofa", 0.5, 0.1, 0.3)]),
])
def test_gradient_descends(name: str, found: list[tuple[str, float, float, float]]) -> None:
    rooms = some_rooms(1)
    start = boxes(*found)
    objects = Objects(
        start.center,
        start.size,
        torch.atan2(start.heading[..., 1], start.heading[..., 0]),
        start.category,
        torch.zeros(1, len(found), 32),
    )
    x = encode(objects, MODEL)
    logits = x[..., CLASS] * 10
    module = registry.load("apartgen.stages.layout.guidance", name)

    def value(state: torch.Tensor) -> float:
        return float(module.energy(geometry.boxes_of(Prediction(state, logits), MODEL.class_scale), floor_of(rooms))[0])

    slope = guided.gradient([(1.0, module.energy)], x, logits, floor_of(rooms), MODEL)
    assert slope[..., PLACE].abs().sum() > 0
    assert value(x - 0.02 * slope) < value(x)


def test_paper_scaling_shifts_the_posterior_mean_by_lambda_sigma_gradient() -> None:
    """Eq. 2 for one DDPM step, whatever the sampler sees: μ′ = μ - λΣ∇φ(μ)."""
    from apartgen.stages.layout.samplers import posterior

    config = LayoutConfig(model="diffusion", scaling="sigma", guidance_scale=3.0)
    rooms, t = some_rooms(1), 9
    x = torch.randn(1, 4, 8 + N_CLASSES + 32, generator=torch.Generator().manual_seed(0))
    clean = x * 0.9
    logits = clean[..., CLASS]

    def pulled(boxes: Boxes, room: geometry.Floor) -> torch.Tensor:
        return (boxes.center[..., 0] ** 2).sum(-1)

    def denoise(x: torch.Tensor, t: torch.Tensor) -> Prediction:
        return Prediction(clean, logits)

    steered = guided.guided(denoise, [(1.0, pulled)], floor_of(rooms), MODEL, config, 0.1)(x, torch.tensor([t])).x0
    mean, variance = posterior(x, clean, t, t - 1)
    slope = guided.gradient([(1.0, pulled)], mean, logits, floor_of(rooms), MODEL)
    torch.testing.assert_close(posterior(x, steered, t, t - 1)[0], mean - 3.0 * variance * slope, atol=1e-6, rtol=1e-4)
    assert slope.abs().max() > 0


def test_quantity_energy_is_eq_3() -> None:
    found = boxes(("sofa", 0, 0, 0), ("plant", 1, 0, 0))
    found.empty = torch.tensor([[0.1, 0.9]])
    room = floor_of(some_rooms(1))
    room.empty = torch.tensor([[0.0, 1.0]])
    module = registry.load("apartgen.stages.layout.guidance", "quantity")
    logit = 0.4 * module.SHARPNESS
    assert float(module.energy(found, room)[0]) == pytest.approx(np.log1p(np.exp(-logit)), rel=1e-4)
    room.empty = torch.tensor([[1.0, 0.0]])
    assert float(module.energy(found, room)[0]) == pytest.approx(np.log1p(np.exp(logit)), rel=1e-4)


def test_wanted_categories_win_their_slots() -> None:
    generator = torch.Generator().manual_seed(0)
    for _ in range(50):
        logits = torch.randn(8, N_CLASSES, generator=generator) * 3
        logits[:, EMPTY] = -30
        wanted = torch.full((EMPTY,), -1)
        wanted[3], wanted[7], wanted[11] = 2, 0, 1
        guided.assign(logits, wanted)
        classes = logits.argmax(-1)
        assert [(classes == c).sum().item() for c in (3, 7, 11)] == [2, 0, 1]


def test_schedule_is_respected() -> None:
    calls: list[int] = []

    def counting(boxes: Boxes, room: geometry.Floor) -> torch.Tensor:
        calls.append(1)
        return (boxes.center**2).sum((-1, -2))

    x = torch.randn(1, 2, 8 + N_CLASSES + 32)
    steered = guided.guided(
        lambda x, t: Prediction(x, x[..., CLASS]),
        [(1.0, counting)],
        floor_of(some_rooms(1)),
        MODEL,
        LayoutConfig(model="diffusion"),
        0.01,
    )
    steered(x, torch.tensor([11]))
    assert not calls
    steered(x, torch.tensor([10]))
    assert calls and ALPHA_BAR[10] < 1


@pytest.mark.parametrize("wanted", [6, 13])
def test_late_quantity_guidance_makes_counts_exact(wanted: int) -> None:
    """Eq. 3 on the shipped model: the slots of lowest empty logit are filled, the rest empty, in every room."""
    from apartgen.stages.layout import weights
    from apartgen.stages.layout.sample import sample

    rooms = some_rooms(6)
    rooms.type[:] = 3
    rooms.count[:] = wanted
    network, _ = weights.load()
    lanes = [np.random.default_rng([i, 0]) for i in range(6)]
    config = LayoutConfig(model="diffusion", count="guided", guidance={}, projection=False)
    made = (sample(network, rooms, config, lanes).category >= 0).sum(1)
    assert (made == wanted).all()
    lanes = [np.random.default_rng([i, 0]) for i in range(6)]
    free = (sample(network, rooms, config.model_copy(update={"count": "free"}), lanes).category >= 0).sum(1)
    assert (free != wanted).any()


def test_guidance_goes_farther_where_nothing_comes_after_it() -> None:
    bare, projected = (LayoutConfig(model="diffusion", projection=after).gradient_steps for after in (False, True))
    assert bare > projected and LayoutConfig(model="diffusion", guidance_repeats=20).gradient_steps == 20


def test_rooms_that_need_no_guidance_are_left_alone_and_the_others_descend_as_ever() -> None:
    room, config = floor_of(some_rooms(2)), LayoutConfig(model="diffusion", guidance_repeats=5)
    terms = guided.energies({name: 1.0 for name in SPATIAL if name != "walkway"})
    category = torch.tensor([[CATEGORIES.index("wardrobe")] * 2] * 2)
    center = torch.tensor([[[-0.2, 0.1, 0.4], [0.2, 0.0, 0.4]], [[-1.0, 0.6, 0.4], [1.0, -0.6, 0.4]]])
    size = torch.tensor([0.3, 0.3, 0.8]).expand(2, 2, 3)
    x0 = encode(Objects(center, size, torch.zeros(2, 2), category, torch.zeros(2, 2, 32)), MODEL)
    logits = torch.nn.functional.one_hot(category, N_CLASSES).float() * 9
    found = guided.descended(terms, x0, logits, room, MODEL, config)
    expected = x0
    for _ in range(config.guidance_repeats):
        grad = guided.gradient(terms, expected, logits, room, MODEL)
        expected = expected - guided.trusted(config.guidance_scale * grad)
    assert torch.equal(found[1], x0[1]) and not torch.equal(found[0], x0[0])
    assert torch.allclose(found, expected, atol=1e-6)


def test_walkway_counts_every_pair_that_stands_once_and_no_other() -> None:
    """Boxes in a row, 0.3 m apart, far from any wall: of what is there, on the floor, and no partner of the next."""
    room = some_rooms(1, 3)
    room.polygon[0, :4] = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]]
    module = registry.load("apartgen.stages.layout.guidance", "walkway")
    share = 4 * (0.3 - module.FLUSH) * (module.PASS - 0.3) / (module.PASS - module.FLUSH) ** 2

    def value(*names: str, there: tuple[int, ...] = ()) -> float:
        found = boxes(*((name, 1.1 * k, 0.0, 0.0) for k, name in enumerate(names)))
        for k in there:
            found.filled[0, k] = 0
        return float(module.energy(found, floor_of(room))[0]) / share

    assert value("chest", "sofa", "chest", "wardrobe") == pytest.approx(3, rel=1e-3)
    assert value("chest", "sofa", "chest", "wardrobe", there=(1,)) == pytest.approx(1, rel=1e-3)
    assert value("chest", "rug", "chest") == value("rug", "rug") == value("chest", "chest", there=(0, 1)) == 0
    assert value("dining_table", "chair") == 0, "a chair at its table leaves no way between"
    assert value("chair", "chest") == pytest.approx(1, rel=1e-3)
