"""Give every object of a layout a real asset, by category, size and shape."""

from collections.abc import Callable
from typing import Any

import numpy as np

from apartgen_cli.stage import Stage, each
from schemas.layout import Layout
from schemas.retrieve import Retrieve
from stages.retrieve.matching.config import RetrieveConfig


def match(layout: Layout, config: RetrieveConfig, rng: np.random.Generator) -> Retrieve:
    """One apartment."""
    from stages import retrieve

    return retrieve.run(layout, config, rng)


STAGE = Stage("retrieve", Layout, RetrieveConfig, each(match), names={"libraries": "library"})


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"retrieve": STAGE.command()}
