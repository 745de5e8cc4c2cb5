"""Give every object of a layout a real asset, by category, size and shape."""

from collections.abc import Callable
from pathlib import Path
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


def libraries(config: RetrieveConfig) -> dict[str, Path]:
    """The index of the embedded library, and the table of every other."""
    from stages.latents import INDEX
    from stages.retrieve.matching.indexed import TABLE_FILE

    return {"parametric": INDEX} | {str(folder): Path(folder) / TABLE_FILE for folder in config.libraries}


STAGE = Stage("retrieve", Layout, RetrieveConfig, each(match), {"libraries": "library"}, data=libraries)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"retrieve": STAGE.command()}
