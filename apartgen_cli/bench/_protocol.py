"""What an experiment is: a file of this folder."""

from pathlib import Path
from typing import Any, Protocol

import numpy as np


class Experiment(Protocol):
    """A table of the paper measured anew; the package's docstring says what else it may have."""

    PAPER: list[dict[str, Any]]
    NOTE: str
    SETTINGS: list[str]
    SCENES: int
    CHUNK: int

    def trial(self, setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
        """The records of one trial."""

    def rows(self, records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
        """The table made of all records."""
