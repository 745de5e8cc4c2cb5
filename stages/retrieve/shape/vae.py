"""The variational autoencoder: fields → 32 latent dimensions → fields."""

from typing import NamedTuple

from torch import Tensor, nn
from torch.nn import functional as F

from apartgen.stages.retrieve.shape.fields import FEATURES, SHAPE

LATENT = 32


class ShapeVAE(nn.Module):
    """Two small perceptrons; the posterior is a diagonal Gaussian.

    `style` tells the `styles` of the library apart from the latent alone, which draws each style together.
    """

    def __init__(self, styles: int, hidden: tuple[int, int] = (160, 128)) -> None:
        super().__init__()
        wide, narrow = hidden
        self.encoder = nn.Sequential(
            nn.Linear(FEATURES, wide), nn.SiLU(), nn.Linear(wide, narrow), nn.SiLU(), nn.Linear(narrow, 2 * LATENT)
        )
        self.decoder = nn.Sequential(
            nn.Linear(LATENT, narrow), nn.SiLU(), nn.Linear(narrow, wide), nn.SiLU(), nn.Linear(wide, FEATURES)
        )
        self.style = nn.Linear(LATENT, styles)

    def posterior(self, x: Tensor) -> tuple[Tensor, Tensor]:
        """Mean and log variance, (b, 32) each, of fields (b, FEATURES)."""
        mean, log_var = self.encoder(x).chunk(2, -1)
        return mean, log_var.clamp(-10, 5)

    def decode(self, z: Tensor) -> Tensor:
        """Fields in [0, 1] of raw (not standardised) latents."""
        out: Tensor = self.decoder(z).sigmoid()
        return out


class Batch(NamedTuple):
    """Fields (b, FEATURES), style (b), and which styles are of the same category (b, styles)."""

    fields: Tensor
    style: Tensor
    rivals: Tensor


class Weights(NamedTuple):
    """What the terms of the loss count beside the shape's reconstruction."""

    divergence: float
    color: float
    style: float


def loss(model: ShapeVAE, batch: Batch, weights: Weights, noise: Tensor) -> tuple[Tensor, dict[str, float]]:
    """Negative evidence lower bound per sample, its terms weighted; `noise` (b, 32) is standard normal."""
    x, n = batch.fields, len(batch.fields)
    mean, log_var = model.posterior(x)
    z = mean + noise * (0.5 * log_var).exp()
    logits = model.decoder(z)
    shape = F.binary_cross_entropy_with_logits(logits[:, :SHAPE], x[:, :SHAPE], reduction="sum") / n
    color = F.mse_loss(logits[:, SHAPE:].sigmoid(), x[:, SHAPE:], reduction="sum") / n
    divergence = 0.5 * (mean.square() + log_var.exp() - 1 - log_var).sum() / n
    style = F.cross_entropy(model.style(z).masked_fill(~batch.rivals, -1e4), batch.style)
    total = shape + weights.color * color + weights.divergence * divergence + weights.style * style
    terms = {"shape": shape, "color": color, "divergence": divergence, "style": style}
    return total, {name: term.item() for name, term in terms.items()}
