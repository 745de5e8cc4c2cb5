"""One phrase of a prompt with its readings."""

from dataclasses import dataclass, field

from apartgen.stages.plan.reader.lexicon import Entry


@dataclass(frozen=True)
class Lexeme:
    """A phrase with its readings. `joined` says that a hyphen ties it to the lexeme before.

    Beyond the lexicon's kinds: `mark`, `unknown`, `area` (m² in `values`, metres in `sides`), `share`, `shorthand`.
    `bounds` are an area's limits, `slips` words misspelled, with those they were read as.
    """

    kind: str
    value: str
    text: str
    plural: bool = False
    joined: bool = False
    glued: bool = False
    values: tuple[float, ...] = ()
    others: tuple[Entry, ...] = ()
    parts: tuple[tuple[str, float], ...] = field(default=())
    sides: tuple[float, ...] = ()
    bounds: tuple[tuple[str, float], ...] = ()
    slips: tuple[tuple[str, str], ...] = ()

    @property
    def number(self) -> float:
        """The value of a number lexeme."""
        return self.values[0]

    def reading(self, kind: str) -> Entry | None:
        """Another reading of the same phrase."""
        return next((e for e in self.others if e.kind == kind), None)
