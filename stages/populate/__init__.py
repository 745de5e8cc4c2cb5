"""Small things put where people keep them: on tops and shelves, in drawers and cupboards, on walls and floors."""

from typing import TYPE_CHECKING

from apartgen.stages.populate.config import PopulateConfig

if TYPE_CHECKING:
    from numpy.random import Generator

    from apartgen.schemas.populate import Populate
    from apartgen.schemas.retrieve import Retrieve
    from apartgen.stages.populate.stage import Library

__all__ = ["PopulateConfig", "run"]


def run(previous: "Retrieve", config: PopulateConfig, rng: "Generator", library: "Library") -> "Populate":
    """The home with its small things; each room draws from a lane of its own, and nothing that stands is moved."""
    from apartgen.stages.populate.stage import populated

    return populated(previous, config, rng, library)
