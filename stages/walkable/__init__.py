"""Walkable area: smaller furniture until enough floor is free (Algorithm 2), then free space a robot can use."""

from stages.walkable.config import WalkableConfig
from stages.walkable.run import run, unmet

__all__ = ["WalkableConfig", "run", "unmet"]
