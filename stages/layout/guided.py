"""Guidance as wrappers: each takes a denoiser and returns a denoiser, so that samplers never know of it."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import torch
from torch import Tensor

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
from apartgen.stages.layout.config import LayoutConfig, ModelConfig, T, TrainConfig
from apartgen.stages.layout.diffusion import Denoise, Prediction
from apartgen.stages.layout.features import CLASS, EMPTY
from apartgen.stages.layout.geometry import Boxes, Floor, boxes_of, floor_of
from apartgen.stages.layout.rooms import Rooms
from apartgen.stages.layout.samplers import posterior
from apartgen.stages.layout.schedule import ALPHA_BAR
from apartgen.stages.layout.sense import BARRED, at_home, settle

TRUST = 0.05
"""Longest shift of an object in one step without Σ, in units of the state; 10 cm where it is all of place."""
SETTLED = 0.15
"""Below this share of the schedule a slot's likeliest class means something; rules earlier would shift frequencies."""
Energy = Callable[[Boxes, Floor], Tensor]
PACKAGE = "apartgen.stages.layout.guidance"
ROUNDING = 1e-5
"""An energy that is less below 0 is 0."""


def energies(weights: dict[str, float]) -> list[tuple[float, Energy]]:
    """The guidance functions φ of weight γ > 0, found by name under `guidance/`; BadInput for one that is not there."""
    found = [(gamma, _energy(name)) for name, gamma in weights.items()]
    return [(gamma, energy) for gamma, energy in found if gamma]


@cache
def _energy(name: str) -> Energy:
    """One by name; another package's is looked after, as it is at least 0 and one for each room."""
    found: Energy = registry.load(PACKAGE, name).energy
    plugin = registry.bringer(PACKAGE, name)
    if plugin is None:
        return found
    say = plugin.told

    def watched(boxes: Boxes, room: Floor) -> Tensor:
        phi = found(boxes, room)
        if phi.shape != boxes.filled.shape[:1]:
            raise BadInput(say(f"energy gave shape {tuple(phi.shape)}; there is to be one for each of "
                               f"{len(boxes.filled)} rooms, shape {tuple(boxes.filled.shape[:1])}"))
        if not phi.isfinite().all():
            raise BadInput(say("energy gave no number (nan or infinite)"))
        if phi.min() < -ROUNDING:
            raise BadInput(say(f"energy gave {phi.min():.3g}; it is to be at least 0, and 0 where there is nothing to "
                               "wish for"))
        if phi.max() > ROUNDING and boxes.center.requires_grad and not phi.requires_grad:
            raise BadInput(say(f"energy gave {phi.max():.3g} without a gradient, which moves nothing; make it of the "
                               "boxes' tensors as they are, without detach() or item()"))
        return phi

    return watched


def gradient(terms: list[tuple[float, Energy]], x: Tensor, logits: Tensor, room: Floor, model: ModelConfig) -> Tensor:
    """∇φ(x) of φ = Σ γ φ_k, (B, N, D)."""
    return energy_and_gradient(terms, x, logits, room, model)[1]


def energy_and_gradient(
    terms: list[tuple[float, Energy]], x: Tensor, logits: Tensor, room: Floor, model: ModelConfig
) -> tuple[Tensor, Tensor]:
    """φ (B,) and ∇φ (B, N, D)."""
    with torch.enable_grad():
        x = x.detach().requires_grad_()
        boxes = boxes_of(Prediction(x, logits), model.class_scale)
        phi = torch.stack([gamma * energy(boxes, room) for gamma, energy in terms]).sum(0)
        total = phi.sum()
    grad = torch.autograd.grad(total, x, materialize_grads=True)[0] if total.requires_grad else torch.zeros_like(x)
    return phi.detach(), grad


def descended(
    terms: list[tuple[float, Energy]], x0: Tensor, logits: Tensor, room: Floor, model: ModelConfig, config: LayoutConfig
) -> Tensor:
    """x_0 after gradient steps without Σ; a room where every energy has reached 0 is done with."""
    x0, left = x0.clone(), torch.arange(len(x0))
    for _ in range(config.gradient_steps):
        phi, grad = energy_and_gradient(terms, x0[left], logits[left], room.take(left), model)
        x0[left] -= trusted(config.guidance_scale * grad)
        left = left[phi > 0]
        if not len(left):
            break
    return x0


def guided(
    denoise: Denoise,
    terms: list[tuple[float, Energy]],
    room: Floor,
    model: ModelConfig,
    config: LayoutConfig,
    below: float,
) -> Denoise:
    """A denoiser whose posterior mean is shifted by -λΣ∇φ for t < `below`·T (Eq. 2).

    `scaling="sigma"` is Eq. 2 as written, the gradient taken at x_t = μ (Algorithm 1, line 12) of one step of the
    1000-step schedule. `scaling="plain"` leaves Σ out and takes the gradient at the predicted x_0, which few-step
    samplers need because their μ is still noisy.
    """

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made, step = denoise(x, t), int(t[0])
        if not terms or step > below * T or step == 0:
            return made
        if config.scaling == "plain":
            return Prediction(descended(terms, made.x0, made.logits, room, model, config), made.logits)
        mean, variance = posterior(x, made.x0, step, step - 1)
        share = posterior(torch.zeros_like(x), torch.ones_like(x), step, step - 1)[0]
        shift = config.guidance_scale * variance * gradient(terms, mean, made.logits, room, model) / share
        return Prediction(made.x0 - shift, made.logits)

    return wrapped


def trusted(shift: Tensor) -> Tensor:
    """The shift (B, N, D), no object's longer than `TRUST`: an IoU's gradient grows as 1 over a box's thickness.

    Class channels, which only quantity moves, have a bounded gradient.
    """
    moves, classes = shift[..., : CLASS.start], shift[..., CLASS.start :]
    length: Tensor = moves.norm(dim=-1, keepdim=True)
    return torch.cat([moves * (TRUST / length.clamp_min(TRUST)), classes], -1)


def quantity_guided(
    denoise: Denoise,
    count: Tensor,
    wanted: Tensor,
    terms: list[tuple[float, Energy]],
    room: Floor,
    model: ModelConfig,
    config: LayoutConfig,
    below: float,
) -> Denoise:
    """Eq. 3: from the first step under `below`·T on, the `count` (B,) slots of lowest empty logit are to be filled.

    Slots that hold what is `wanted` (B, C) by category come before others.
    """
    state: dict[str, Tensor] = {}

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        if int(t[0]) > below * T:
            return denoise(x, t)
        if not state:
            logits = denoise(x, t).logits
            given = (wanted > 0).gather(1, logits.argmax(-1).clamp_max(EMPTY - 1)) & (logits.argmax(-1) < EMPTY)
            empty = logits[..., EMPTY].masked_fill(given, -torch.inf)
            state["T"] = (empty.argsort(-1).argsort(-1) >= count[:, None]).float()
        there = replace(room, empty=state["T"])
        return guided(denoise, terms, there, model, config, below)(x, t)

    return wrapped


def fixed_categories(denoise: Denoise, wanted: Tensor, filled: Tensor, model: ModelConfig) -> Denoise:
    """Objects asked for by category: `wanted` (B, C), -1 where free; `filled` (B,) objects in all.

    Slots are given to wanted categories greedily by their logits at every step, so that the finished sample holds
    at least as many of each as asked (exactly as many, where the count leaves room for no others).
    """

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made = denoise(x, t)
        logits = made.logits.clone()
        for b in range(len(wanted)):
            assign(logits[b, : int(filled[b])], wanted[b])
        x0 = made.x0.clone()
        x0[..., CLASS] = logits.softmax(-1) * model.class_scale
        return Prediction(x0, logits)

    return wrapped


def assign(logits: Tensor, wanted: Tensor) -> None:
    """Raise or bar classes in one room's logits (N, C+1) until each wanted class wins exactly its number of slots."""
    asked = [(int(c), int(wanted[c])) for c in (wanted >= 0).nonzero().flatten()]
    if not asked:
        return
    free = torch.ones(len(logits), dtype=torch.bool)
    best = logits.clone()
    for category, _ in asked:
        best[:, category] = -torch.inf
    rival = best.amax(-1)
    for category, number in sorted(asked, key=lambda row: -row[1]):
        margin = torch.where(free, logits[:, category] - rival, -torch.inf)
        chosen = margin.argsort(descending=True)[:number]
        chosen = chosen[free[chosen]]
        free[chosen] = False
        keep = logits[chosen, category]
        logits[:, category] = -30.0
        logits[chosen, category] = torch.maximum(keep, logits[chosen].amax(-1) + 3.0)


def anticipation(rooms: Rooms, config: TrainConfig) -> Callable[[Prediction, Tensor], Tensor]:
    """λΣg of Eq. 1: g = -∇φ at the network's own one-step prediction x̃_0, no gradient through it."""
    terms, room = energies({"articulation": 1.0, "inside": 1.0, "openings": 1.0}), floor_of(rooms)

    def shift(made: Prediction, t: Tensor) -> Tensor:
        device, t = t.device, t.cpu()  # where the floor is, and the compiled kernels of energies run
        g = -gradient(terms, made.x0.cpu(), made.logits.detach().cpu(), room, config.model)
        beta = 1 - ALPHA_BAR[t] / ALPHA_BAR[t - 1]
        variance = (1 - ALPHA_BAR[t - 1]) / (1 - ALPHA_BAR[t]) * beta
        return (config.anticipate * variance[:, None, None] * g).to(device)

    return shift


def biased(denoise: Denoise, bias: Tensor) -> Denoise:
    """The denoiser with a bias (B, 1, C+1) on its class logits; wrappers around it make x_0 of them."""

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made = denoise(x, t)
        return Prediction(made.x0, made.logits + bias)

    return wrapped


def without_empty(denoise: Denoise, filled: Tensor) -> Denoise:
    """Exact by construction: the first `filled` (B,) slots never take the empty class, the rest always do."""

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made = denoise(x, t)
        there = torch.arange(x.shape[1])[None] < filled[:, None]
        logits = made.logits.clone()
        logits[..., EMPTY] = torch.where(there, -30.0, 30.0)
        return Prediction(made.x0, logits)

    return wrapped


def sensible(denoise: Denoise, rooms: Rooms, filled: Tensor, scale: float) -> Denoise:
    """The denoiser with classes that break a rule made unlikely; `filled` (B,) slots take part."""

    foreign = torch.from_numpy(~at_home()[rooms.type] & np.pad(rooms.wanted < 0, ((0, 0), (0, 1))))

    def wrapped(x: Tensor, t: Tensor) -> Prediction:
        made = denoise(x, t)
        logits = made.logits.masked_fill(foreign[:, None], BARRED)
        for b, kind in enumerate(rooms.type if int(t[0]) <= SETTLED * T else ()):
            settle(logits[b, : int(filled[b])].numpy(), int(kind), rooms.wanted[b])
        x0 = made.x0.clone()
        x0[..., CLASS] = logits.softmax(-1) * scale
        return Prediction(x0, logits)

    return wrapped
