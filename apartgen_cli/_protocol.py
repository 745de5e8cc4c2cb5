"""What a command is: a file of this folder."""

from collections.abc import Callable
from typing import Any, Protocol


class Command(Protocol):
    """A word of the command line; the first line of the module's docstring is its help."""

    def commands(self) -> dict[str, Callable[..., Any]]:
        """The command under its word, or several below it."""
