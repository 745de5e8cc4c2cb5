"""How the shape autoencoder is trained."""

from pydantic import Field

from apartgen.schemas.base import Record


class ShapeTraining(Record):
    """One training run; travels in the weights' header."""

    seed: int = Field(default=0, ge=0, description="fixes everything drawn")
    variants: int = Field(default=12, ge=1, description="pieces of every style to learn from")
    epochs: int = Field(default=40, ge=1, description="passes over all pieces")
    batch: int = Field(default=64, ge=2, description="pieces of a step")
    rate: float = Field(default=2e-3, gt=0, description="learning rate at the start")
    beta: float = Field(default=0.5, ge=0, description="weight of the divergence from the prior")
    color_weight: float = Field(default=20.0, ge=0, description="weight of a surface's colour")
    style_weight: float = Field(default=400.0, ge=0, description="weight of telling the styles of a category apart")
