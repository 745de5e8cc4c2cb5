"""What the rules of an activity are: a file of this folder, or a module of another package, `apartgen.rules`."""

from collections.abc import Iterator
from typing import Protocol

from apartgen.stages.use.fault import Fault
from apartgen.stages.use.room import Furnished


class Rules(Protocol):
    """What those who live there would mind about one activity."""

    def faults(self, room: Furnished) -> Iterator[Fault]:
        """Every fault of a furnished room."""
