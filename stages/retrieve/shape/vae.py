"""The variational autoencoder: fields → 32 latent dimensions → fields."""

from torch import Tensor, nn
from torch.nn import functional as F

from stages.retrieve.shape.fields import FEATURES, SHAPE

LATENT = 32


class ShapeVAE(nn.Module):
    """Two small perceptrons; the posterior is a diagonal Gaussian."""

    def __init__(self, hidden: tuple[int, int] = (160, 128)) -> None:
        super().__init__()
        wide, narrow = hidden
        self.encoder = nn.Sequential(
            nn.Linear(FEATURES, wide), nn.SiLU(), nn.Linear(wide, narrow), nn.SiLU(), nn.Linear(narrow, 2 * LATENT)
        )
        self.decoder = nn.Sequential(
            nn.Linear(LATENT, narrow), nn.SiLU(), nn.Linear(narrow, wide), nn.SiLU(), nn.Linear(wide, FEATURES)
        )

    def posterior(self, x: Tensor) -> tuple[Tensor, Tensor]:
        """Mean and log variance, (b, 32) each, of fields (b, FEATURES)."""
        mean, log_var = self.encoder(x).chunk(2, -1)
        return mean, log_var.clamp(-10, 5)

    def decode(self, z: Tensor) -> Tensor:
        """Fields in [0, 1] of raw (not standardised) latents."""
        out: Tensor = self.decoder(z).sigmoid()
        return out


def loss(model: ShapeVAE, x: Tensor, beta: float, color_weight: float, noise: Tensor) -> tuple[Tensor, dict[str, float]]:
    """Negative evidence lower bound per sample with β on the divergence; `noise` (b, 32) is standard normal."""
    mean, log_var = model.posterior(x)
    logits = model.decoder(mean + noise * (0.5 * log_var).exp())
    shape = F.binary_cross_entropy_with_logits(logits[:, :SHAPE], x[:, :SHAPE], reduction="sum") / len(x)
    color = F.mse_loss(logits[:, SHAPE:].sigmoid(), x[:, SHAPE:], reduction="sum") / len(x)
    divergence = 0.5 * (mean.square() + log_var.exp() - 1 - log_var).sum() / len(x)
    total = shape + color_weight * color + beta * divergence
    return total, {"shape": shape.item(), "color": color.item(), "divergence": divergence.item()}
