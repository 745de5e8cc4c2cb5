"""What a data set is made of: a list of requests, gone through as often as needed, or a grammar that draws them."""

import hashlib
from collections.abc import Iterator
from dataclasses import replace
from itertools import count as counted
from itertools import islice
from pathlib import Path
from typing import Any, Protocol

from apartgen.dataset.grammar import Grammar
from apartgen.requests import Request, file_name, listed
from apartgen.schemas import artifact
from apartgen.schemas.errors import ApartgenError, BadInput


class Source(Protocol):
    """Requests in an order that never changes."""

    @property
    def count(self) -> int:
        """How many."""

    def requests(self) -> Iterator[Request]:
        """Every request, each with a name of its own."""

    def about(self) -> dict[str, Any]:
        """What it is, so that another is told from it."""


class Listed:
    """A list of requests; with a `count` larger than the list, its prompts again under new ids."""

    def __init__(self, data: bytes, name: str, count: int | None = None) -> None:
        found = listed(data, name)
        wrong = [one for one in found if isinstance(one, ApartgenError)]
        if wrong:
            more = f" (and {len(wrong) - 1} more lines)" if wrong[1:] else ""
            raise BadInput(f"{wrong[0]}{more}; nothing is made before all can be")
        self._requests = [one for one in found if isinstance(one, Request)]
        self._name, self._digest = Path(name).name, hashlib.sha256(data).hexdigest()
        self.count = len(self._requests) if count is None else count
        self._check_names()

    def requests(self) -> Iterator[Request]:
        """The list, and again with a number behind the ids."""
        every = (one if k == 0 else replace(one, id=f"{one.name}+{k}", name=file_name(f"{one.name}+{k}"))
                 for k in counted() for one in self._requests)
        return islice(every, self.count)

    def about(self) -> dict[str, Any]:
        """The list's name and digest."""
        return {"prompts": self._name, "sha256": self._digest}

    def _check_names(self) -> None:
        names = {one.name for one in self._requests}
        again = [name for name in names if name.rpartition("+")[0] in names and name.rpartition("+")[2].isdigit()]
        if self.count > len(names) and again:
            raise BadInput(f"{self._name}: id {again[0]!r} is what another's next home would be called; give another")


class Drawn:
    """Requests that a grammar draws, each from the seed and its number."""

    def __init__(self, grammar: Grammar, seed: int, count: int) -> None:
        self._grammar, self._seed, self.count = grammar, seed, count

    def requests(self) -> Iterator[Request]:
        """A prompt for every number."""
        for i in range(self.count):
            name = f"{i:07d}"
            yield Request(self._grammar.sentence(self._seed, i), name, name=name)

    def about(self) -> dict[str, Any]:
        """The grammar's name and digest."""
        return {"grammar": self._grammar.name, "sha256": self._grammar.digest}


def source(prompts: str | None, grammar: str | None, count: int | None, seed: int) -> Source:
    """The source that is asked for: a list's file, or a grammar by its file or as `default`."""
    if (prompts is None) == (grammar is None):
        raise BadInput("give a file of prompts, or --prompts-from a grammar")
    if prompts is not None:
        return Listed(artifact.contents(prompts), prompts, count)
    if count is None:
        raise BadInput("--prompts-from: says how homes are asked for, not how many; give --count")
    return Drawn(Grammar.read(str(grammar)), seed, count)
