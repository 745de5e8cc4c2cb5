"""What a kind of asset library is: a file of this folder, or a module of another package, `apartgen.retrieve`."""

from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

from apartgen.stages.retrieve.reading.source import Source


class Library(Protocol):
    """Reads a folder of 3D models. `assets` may take more options, such as `scale`."""

    def assets(self, root: Path) -> Iterator[Source]:
        """Every model below a folder: its id, and how it is loaded."""
