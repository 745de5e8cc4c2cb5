"""Walkable area: smaller furniture until enough floor is free (Algorithm 2), then free space a robot can use."""

from typing import TYPE_CHECKING

from apartgen.stages.walkable.config import WalkableConfig

if TYPE_CHECKING:
    from numpy.random import Generator

    from apartgen.schemas.retrieve import Retrieve
    from apartgen.schemas.walkable import Walkable
    from apartgen.stages.walkable.site import Candidates

__all__ = ["WalkableConfig", "run", "unmet"]


def run(previous: "Retrieve", config: WalkableConfig, rng: "Generator", library: "Candidates") -> "Walkable":
    """Algorithm 2, connectivity for a robot, then free ways for all that opens; pure, and nothing is drawn from `rng`.

    Raises Unmet (unless `write_anyway`), naming the rooms, when the target can't be met, and when the robot does not
    get somewhere for what a room can't do without.
    """
    from apartgen.stages.walkable.stage import cleared

    return cleared(previous, config, library)


def unmet(home: "Walkable", config: WalkableConfig, library: "Candidates") -> str:
    """What a home written by `write_anyway` falls short of, empty if nothing."""
    from apartgen.stages.walkable.stage import lacking

    return lacking(home, config, library)
