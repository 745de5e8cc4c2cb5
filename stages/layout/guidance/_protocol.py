"""What a guidance energy is: a file of this folder, or a module that another package brings as `apartgen.guidance`."""

from typing import Protocol

from torch import Tensor

from apartgen.stages.layout.geometry import Boxes, Floor


class Guidance(Protocol):
    """An energy φ that layouts are led down."""

    def energy(self, boxes: Boxes, room: Floor) -> Tensor:
        """φ of every room of a batch, (B,): at least 0, 0 when satisfied, with a gradient where it is not."""
