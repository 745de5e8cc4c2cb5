"""Make room to walk: swap, nudge or drop furniture until a robot gets everywhere."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import Field

from apartgen.schemas.errors import Unmet
from apartgen.schemas.retrieve import Retrieve
from apartgen.schemas.walkable import Walkable
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.walkable.config import WalkableConfig
from apartgen_cli import retrieve as retrieving
from apartgen_cli.stage import Stage, each

if TYPE_CHECKING:
    from apartgen.stages.retrieve import LibrarySet


class WalkableSettings(WalkableConfig):
    """The stage's settings, and where smaller assets are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries")


def clear(home: Retrieve, config: WalkableSettings, rng: np.random.Generator) -> Walkable:
    """One apartment; BadInput where a library of its assets is not open."""
    from apartgen.stages import walkable

    libraries = _opened(config)
    for library, id in {o.asset.library: o.asset.id for o in home.objects}.items():
        libraries.load(library, id)
    return walkable.run(home, config, rng, libraries)


def missed(home: Walkable, config: WalkableSettings) -> Unmet | None:
    """What the best apartment falls short of, when it was asked for all the same."""
    if not config.write_anyway:
        return None
    from apartgen.stages import walkable

    short = walkable.unmet(home, config, _opened(config))
    return Unmet(f"{short} (written as asked)") if short else None


def indices(config: WalkableSettings) -> dict[str, Path]:
    """The index of every library that smaller assets come from, as the retrieve stage names them."""
    return retrieving.libraries(_as_retrieved(config))


def _opened(config: WalkableSettings) -> "LibrarySet":
    from apartgen.stages import retrieve

    return retrieve.open_libraries(_as_retrieved(config))


def _as_retrieved(config: WalkableSettings) -> RetrieveConfig:
    return RetrieveConfig(libraries=config.libraries)


STAGE = Stage("walkable", Retrieve, WalkableSettings, each(clear), {"libraries": "library"}, missed, indices)


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"walkable": STAGE.command()}
