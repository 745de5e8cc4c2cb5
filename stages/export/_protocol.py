"""What a format is: a file of this folder, or a module that another package brings as `apartgen.export`."""

from pathlib import Path
from typing import Protocol

from apartgen.stages.scene.scene import Scene


class Format(Protocol):
    """Writes an apartment.

    It may also have `read_back(files: list[Path]) -> None`, which reads what was written by a parser of the format and
    raises anything where that refuses it. One that shows boxes, as a drawing does, says `NEEDS_ASSETS = False`, written
    out, as it is read without an import: then no asset is loaded, and it is written beside those that need some.
    """

    def write(self, scene: Scene, out: Path) -> list[Path]:
        """Write files under the folder `out` and name them, the main one first."""
