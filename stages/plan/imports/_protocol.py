"""What a format of floor plans is: a file of this folder, or another package's module, as `apartgen.imports`."""

from typing import Protocol

from apartgen.stages.plan.drawing import Drawing


class Format(Protocol):
    """Reads floor plans that other programs wrote."""

    def holds(self, name: str, data: bytes) -> bool:
        """Whether a file of this name and content is of the format; told without reading all of it."""

    def read(self, name: str, data: bytes) -> Drawing:
        """What the file shows. BadInput where it is broken, with the element and its place."""
