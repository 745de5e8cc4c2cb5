"""What may be wrong with an apartment, and how it is told."""

import tomllib
from pathlib import Path
from typing import NamedTuple

WHAT: dict[str, str] = tomllib.loads((Path(__file__).parent / "codes.toml").read_text(encoding="utf-8"))
"""Every code, and what its number, or the fault itself, means."""


class Fault(NamedTuple):
    """One fault: a code, ids of what it is about, a witness point (x, y or x, y, z), a number, and what
    else is to be said. What does not refuse an apartment is a note.
    """

    code: str
    of: tuple[str, ...]
    at: tuple[float, ...] = ()
    value: float | None = None
    refuses: bool = True
    more: str = ""

    def __str__(self) -> str:
        where = f" at ({', '.join(f'{c:.2f}' for c in self.at)})" if self.at else ""
        number = "" if self.value is None else f"{self.value:.3f}".rstrip("0").rstrip(".") + " "
        return f"{' '.join([self.code, *self.of])}{where}: {number}{self.more or WHAT[self.code]}"
