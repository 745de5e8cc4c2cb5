"""What a metric is: a file of this folder, or a module that another package brings as `apartgen.metrics`."""

from collections.abc import Sequence
from typing import Annotated, Protocol

from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Value
from apartgen.schemas.plan import Plan, Program


class OfOne(Protocol):
    """Measures one apartment."""

    NEEDS: Annotated[type[Plan], "write `NEEDS = Layout`; Plan, Layout, Retrieve or Walkable"]
    """The artifact that it needs at least: Plan, Layout, Retrieve or Walkable."""

    def measure(self, home: Plan, against: Plan | Program | None = None) -> list[Value]:
        """The figures of an apartment; `against` is a reference other than its own programme."""


class OfMany(Protocol):
    """Compares a set of apartments with real ones; one of pictures takes a `network`, too."""

    def compare(self, homes: Sequence[Layout], real: Sequence[Layout]) -> list[Value]:
        """The figures of the set."""
