"""What a source of homes is: a file of this folder, or a module that another package brings as `apartgen.datasets`."""

from collections.abc import Iterator
from pathlib import Path
from typing import Protocol

from apartgen.schemas.layout import Layout


class DataSet(Protocol):
    """Furnished homes to train on or to compare with. `homes` may take more options, such as `seed` or `rooms`."""

    def homes(self, root: Path | None) -> Iterator[Layout]:
        """The homes below a folder, or made up where there is none."""
