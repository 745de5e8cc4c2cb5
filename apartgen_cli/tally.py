"""How a run over many inputs goes: what could not be done is said, counted and listed."""

import json
from pathlib import Path
from typing import Any, Protocol

from apartgen.schemas import artifact
from apartgen.schemas.errors import ApartgenError, Unknown
from apartgen_cli.console import fail


class Tried(Protocol):
    """What was to be done: `label` is for people, `row()` for a list that can be tried again."""

    @property
    def label(self) -> str:
        """What messages call it."""

    def row(self) -> dict[str, Any] | None:
        """Its line of the list; None where another try is of no use."""


class Tally:
    """Counts; a single input's error is raised as it is, those of many are told as they come.

    `file` takes the failures, each with its `error` and exit `status`, also of a run that is interrupted.
    """

    def __init__(self, many: bool, file: Path | None = None) -> None:
        self.many, self._file = many, file
        self._total, self._failed, self.status = 0, 0, 0
        self._rows: list[dict[str, Any]] = []

    def done(self) -> None:
        """One more is done, or was already."""
        self._total += 1

    def failed(self, tried: Tried, error: ApartgenError) -> None:
        """One more could not be done."""
        self._total += 1
        self._failed += 1
        self.status = max(self.status, error.exit_code)
        if row := tried.row():
            self._rows.append(row | {"error": str(error), "status": error.exit_code})
        told = str(error) if str(error).startswith(tried.label) else f"{tried.label}: {error}"
        if not self.many:
            raise Unknown(told) if isinstance(error, Unknown) else error
        fail(told)

    def __enter__(self) -> "Tally":
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if self._file is not None:
            artifact.write("".join(json.dumps(row, ensure_ascii=False) + "\n" for row in self._rows), self._file)
        if kind is None and self._failed:
            fail(f"{self._failed} of {self._total} could not be done")
