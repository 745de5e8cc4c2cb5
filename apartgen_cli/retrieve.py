"""Give every object of a layout a real asset, by category, size and shape."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from apartgen.schemas.layout import Layout
from apartgen.schemas.retrieve import Retrieve
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen_cli.stage import Stage, each


def match(layout: Layout, config: RetrieveConfig, rng: np.random.Generator) -> Retrieve:
    """One apartment."""
    from apartgen.stages import retrieve

    return retrieve.run(layout, config, rng)


def libraries(config: RetrieveConfig) -> dict[str, Path]:
    """The index of the embedded library, and the table of every other."""
    from apartgen.stages.retrieve.matching.indexed import TABLE_FILE
    from apartgen.stages.things.latents import INDEX

    return {"parametric": INDEX} | {str(folder): Path(folder) / TABLE_FILE for folder in config.libraries}


STAGE = Stage("retrieve", Layout, RetrieveConfig, each(match), {"libraries": "library"}, data=libraries)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"retrieve": STAGE.command()}
