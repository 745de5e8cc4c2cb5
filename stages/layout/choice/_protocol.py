"""What a term is: a file of this folder, or a module that another package brings as `apartgen.choice`."""

from typing import Protocol

from apartgen.stages.use import Furnished


class Term(Protocol):
    """A part of the energy by which the best of several furnishings is chosen."""

    def cost(self, room: Furnished) -> float:
        """At least 0; 0 where there is nothing to wish for."""
