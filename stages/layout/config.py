"""What can be set in the layout stage and its training."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from apartgen.schemas.base import Record

N_MAX = 24
"""Object slots of a room."""
LATENT = 32
"""Dimensions of the shape latent f."""
T = 1000
"""Diffusion steps of the noise schedule."""


class ModelConfig(Record):
    """Shape of the denoising network."""

    width: int = 160
    layers: int = 6
    heads: int = 5
    mlp_ratio: int = 3
    encoder_layers: int = 2
    class_scale: float = Field(1.5, description="one-hot height; larger means classes settle earlier than places")
    latent_scale: float = Field(0.5, description="latents settle later than places")


class TrainConfig(Record):
    """One training run; everything that the weights depend on."""

    corpus: str = Field("corpus.npz", description="the rooms, a file of `apartgen train corpus`")
    start: str | None = Field(None, description="weights to start from; parts they lack start afresh")
    steps: int = Field(8_000, ge=1, description="steps of the optimizer, each on a batch")
    batch: int = Field(128, ge=1, description="rooms of a step, about: fewer where they are full")
    lr: float = Field(6e-4, gt=0, description="highest learning rate")
    warmup: int = Field(500, ge=0, description="steps until it is reached")
    ema: float = Field(0.999, ge=0, lt=1, description="decay of the average of weights, which is what is kept")
    seed: int = Field(0, ge=0, description="fixes everything drawn")
    slots_share: float = Field(0.2, ge=0, le=1, description="share of batches with all slots, empty ones included")
    drop_count: float = Field(0.1, ge=0, le=1, description="share of rooms that do not tell their number of objects")
    drop_wanted: float = Field(0.5, ge=0, le=1, description="share of rooms that do not tell what is wanted in them")
    anticipate: float = Field(0.0, ge=0, description="λ of Eq. 1; 0 is plain denoising")
    calibrate: int = Field(
        1000, ge=0, description="rooms of each round that fits a bias, so that classes come as often as in the corpus"
    )
    device: Literal["auto", "cpu", "cuda"] = Field("auto", description="auto is a GPU where torch finds one")
    threads: int = Field(0, ge=0, description="cores; 0 is one for the network, all for the class bias")
    bf16: bool = Field(True, description="network in bfloat16 where the processor has it, sums and weights in float32")
    save_every: int = Field(500, ge=1, description="steps between checkpoints")
    model: ModelConfig = Field(default_factory=ModelConfig)


RELATIONS = {"candidates", "constraints", "places", "keep", "room"}
"""What the relations model alone heeds."""
DIFFUSION = {
    "sampler", "steps", "guidance", "guidance_scale", "guidance_repeats", "scaling", "guide_below", "count",
    "projection", "batch",
}
"""What the diffusion model alone heeds."""


class LayoutConfig(Record):
    """One layout run."""

    model: Literal["relations", "diffusion"] = Field(
        "relations", description="objects one after another by their relations, or all at once out of noise"
    )
    candidates: int = Field(4, ge=1, le=64, description="samples of a room, of which the best is kept (relations)")
    constraints: bool = Field(True, description="draw nothing that breaks a requirement (relations)")
    places: Literal["model", "random"] = Field(
        "model", description="random: anywhere that breaks nothing, to tell what the model is worth (relations)"
    )
    keep: bool = Field(False, description="complete the rooms: objects that the input has stay (relations)")
    room: list[str] = Field(default_factory=list, description="redo these rooms alone, the others stay (relations)")
    sampler: Literal["ddpm", "ddim", "dpm++"] = Field("dpm++", description="how noise becomes rooms")
    steps: int = Field(20, ge=1, le=T, description="steps of the sampler")
    guidance: dict[str, Annotated[float, Field(ge=0)]] = Field(
        default_factory=lambda: {"articulation": 1.0, "inside": 1.0, "openings": 1.0},
        description="weight γ of articulation, inside, openings, walkway, or quantity with --count guided; 0 is off",
    )
    guidance_scale: float = Field(0.1, ge=0, description="λ of Eq. 2; thousands with Σ, which is so small")
    guidance_repeats: int = Field(
        0, ge=0, description="gradient steps a denoising step, without Σ; 0 is 8, or 4 where the projection follows"
    )
    scaling: Literal["sigma", "plain"] = Field(
        "plain",
        description="with Σ as in Eq. 2, which takes --sampler ddpm --steps 1000 --guide-below 0.01 "
        "--guidance-scale 2000 to show; or without it, as in PhyScene",
    )
    guide_below: float = Field(0.20, ge=0, le=1, description="share of the schedule where guidance acts")
    count: Literal["exact", "guided", "free"] = Field(
        "exact", description="exact by construction, the paper's late BCE (Eq. 3), or left to the model"
    )
    projection: bool = Field(
        True, description="place what was sampled anew, one object after another, where nothing is broken: about half "
                          "ends more than .5 m away; what finds no place is made smaller or left out (diffusion)")
    weights: str | None = Field(None, description="a weights file other than the shipped one")
    batch: int = Field(48, ge=1, description="rooms of a home denoised at once")
    threads: int = Field(0, ge=0, description="homes furnished at once; 0 is as many as there are cores")

    @property
    def gradient_steps(self) -> int:
        """How many at most in a denoising step without Σ: what they leave, the projection puts right as well."""
        return self.guidance_repeats or (4 if self.projection else 8)

    @classmethod
    def _plain(cls, name: str) -> object:
        return cls.model_fields[name].get_default(call_default_factory=True)

    @model_validator(mode="after")
    def _heeded(self) -> "LayoutConfig":
        """A setting that another one switches off is refused."""
        if self.count != "guided" and (gamma := self.guidance.get("quantity")):
            raise ValueError(f"--guidance quantity={gamma:g}: acts with --count guided only; give that, or go without")
        if self.scaling == "sigma" and self.guidance_repeats:
            raise ValueError(f"--guidance-repeats {self.guidance_repeats}: Eq. 2 with Σ takes one gradient step; "
                             "leave it out, or give --scaling plain")
        others = RELATIONS if self.model == "diffusion" else DIFFUSION
        changed = (name for name in self.model_fields_set & others if getattr(self, name) != self._plain(name))
        if unheeded := sorted(changed):
            option, other = unheeded[0].replace("_", "-"), ({"relations", "diffusion"} - {self.model}).pop()
            raise ValueError(f"--{option}: acts with --model {other} only; give that, or go without")
        return self
