"""What a kind of question is: a file of this folder, or a module of another package, `apartgen.kinds`."""

from typing import Protocol

import numpy as np

from apartgen.stages.qa.drafts import Draft
from apartgen.stages.qa.facts import Facts


class Kind(Protocol):
    """Asks one kind of question."""

    def ask(self, facts: Facts, rng: np.random.Generator, most: int) -> list[Draft]:
        """Up to about `most` questions, none that could be understood in two ways."""
