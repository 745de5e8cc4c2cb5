"""Settings of the retrieve stage."""

from pydantic import Field

from apartgen.schemas.base import Record


class RetrieveConfig(Record):
    """Libraries to search, and how candidates are compared.

    The cost of a candidate is `size_weight` · Σ over sides (ln(side / wanted) / 0.2)², plus `latent_weight` · the mean
    square difference of the standardised latents (two unrelated designs are about 2 apart), plus `static_cost`
    when the category opens and the candidate has no moving part.
    """

    libraries: list[str] = Field(default_factory=list, description="folders made by `apartgen assets index`")
    overshoot: float = Field(default=0.25, ge=0, le=1, description="an owned asset's sides may exceed the box's by")
    tolerance: float = Field(default=0.4, ge=0, le=1, description="sides this share below the box's still fill it")
    size_weight: float = Field(default=1.0, ge=0)
    latent_weight: float = Field(default=4.0, ge=0)
    static_cost: float = Field(default=4.0, ge=0)
