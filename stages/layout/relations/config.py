"""What can be set when the relations model is trained."""

from typing import Literal

from pydantic import Field

from apartgen.schemas.base import Record
from apartgen.stages.layout.relations.shape import Shape


class Training(Record):
    """One training run; everything that the weights depend on."""

    corpus: str = Field("corpus.npz", description="the rooms, a file of `apartgen train corpus`")
    start: str | None = Field(None, description="weights to start from")
    steps: int = Field(12_500, ge=1, description="steps of the optimizer, each on a batch")
    batch: int = Field(48, ge=1, description="rooms of a step")
    objects: int = Field(192, ge=1, description="objects of a step that are described, of these rooms")
    lr: float = Field(1.5e-3, gt=0, description="highest learning rate")
    warmup: int = Field(200, ge=0, description="steps until it is reached")
    ema: float = Field(0.998, ge=0, lt=1, description="decay of the average of weights, which is what is kept")
    held: int = Field(0, ge=0, description="last rooms of the corpus that are only looked at, beside the loss")
    seed: int = Field(0, ge=0, description="fixes everything drawn")
    threads: int = Field(1, ge=1, description="cores of the network")
    workers: int = Field(0, ge=0, description="processes that prepare what the network is asked")
    device: Literal["cpu", "cuda"] = Field("cpu", description="where the network computes")
    bf16: bool = Field(True, description="network in bfloat16 where the processor has it, sums and weights in float32")
    save_every: int = Field(250, ge=1, description="steps between checkpoints")
    shape: Shape = Field(default_factory=Shape)
