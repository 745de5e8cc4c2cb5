"""Make room to walk: swap, nudge or drop furniture until a robot gets everywhere."""

from collections.abc import Callable
from typing import Any

import numpy as np
from pydantic import Field

from apartgen_cli.stage import Stage, each
from schemas.errors import Unmet
from schemas.retrieve import Retrieve
from schemas.walkable import Walkable
from stages.retrieve.matching.config import RetrieveConfig
from stages.walkable.config import WalkableConfig


class WalkableSettings(WalkableConfig):
    """The stage's settings, and where smaller assets are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries")


def clear(home: Retrieve, config: WalkableSettings, rng: np.random.Generator) -> Walkable:
    """One apartment."""
    from stages import retrieve, walkable

    libraries = retrieve.open_libraries(RetrieveConfig(libraries=config.libraries))
    return walkable.run(home, config, rng, libraries)


def missed(home: Walkable, config: WalkableSettings) -> Unmet | None:
    """What the best apartment falls short of, when it was asked for all the same."""
    if not config.write_anyway:
        return None
    from stages import retrieve, walkable

    short = walkable.unmet(home, config, retrieve.open_libraries(RetrieveConfig(libraries=config.libraries)))
    return Unmet(f"{short} (written as asked)") if short else None


STAGE = Stage("walkable", Retrieve, WalkableSettings, each(clear), {"libraries": "library"}, missed)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"walkable": STAGE.command()}
