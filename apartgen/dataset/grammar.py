"""Prompts out of a grammar: symbols that stand for one of several texts, which name further symbols."""

import hashlib
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

import numpy as np

from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput
from apartgen.stages import seeds

START, DEFAULT = "home", "default"
_SYMBOL = re.compile(r"\{(\w+)\}")
_NUMBER = re.compile(r"\{(\d{1,9})-(\d{1,9})(?:/(\d{1,9}))?\}")
_DEEPEST, _MOST, _HEAVIEST = 40, 1000, 1e9


@dataclass(frozen=True)
class Grammar:
    """Texts by symbol. `{word}` stands for one of the texts of `word`, `{40-90/5}` for 40, 45, …, 90.

    A text that is given as `[weight, text]` is drawn so much more often than one by itself.
    """

    name: str
    digest: str
    texts: dict[str, list[str]]
    weights: dict[str, list[float]]

    @classmethod
    def read(cls, name: str) -> "Grammar":
        """The grammar in a file, or the one that comes along. BadInput, naming the symbol, for a wrong one."""
        shipped = files("apartgen.dataset") / "programmes.toml"
        data = shipped.read_bytes() if name == DEFAULT else artifact.contents(name)
        try:
            table = tomllib.loads(data.decode())
        except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
            raise BadInput(f"{name}: not TOML: {error}") from None
        rows = {symbol: _rows(name, symbol, value) for symbol, value in table.items()}
        grammar = cls(Path(name).name, hashlib.sha256(data).hexdigest(),
                      {symbol: [text for _, text in row] for symbol, row in rows.items()},
                      {symbol: [weight for weight, _ in row] for symbol, row in rows.items()})
        grammar.check()
        return grammar

    def sentence(self, seed: int, number: int) -> str:
        """The prompt of one home."""
        rng = seeds.drawn(seed, "programme", str(number))
        return " ".join(self._drawn(START, rng, 0, iter(range(_MOST))).split())

    def _drawn(self, symbol: str, rng: np.random.Generator, depth: int, left: Iterator[int]) -> str:
        if depth > _DEEPEST or next(left, None) is None:
            raise BadInput(f"{self.name}: {symbol} stands for itself without end; give it a text that ends")
        chances = np.array(self.weights[symbol])
        text = self.texts[symbol][int(rng.choice(len(chances), p=chances / chances.sum()))]
        text = _SYMBOL.sub(lambda found: self._drawn(found[1], rng, depth + 1, left)
                           if not found[1].isdigit() else found[0], text)
        return _NUMBER.sub(lambda found: _number(rng, *found.groups()), text)

    def check(self) -> None:
        """BadInput for a symbol that there is none of."""
        if START not in self.texts:
            raise BadInput(f"{self.name}: no {START!r} in it, which is what a prompt begins as")
        for symbol, text in ((symbol, text) for symbol, texts in self.texts.items() for text in texts):
            for word in _SYMBOL.findall(text):
                if word not in self.texts:
                    raise BadInput(f"{self.name}: {symbol}: {{{word}}} is unknown; give its texts")
            for low, high, step in _NUMBER.findall(text):
                if int(low) > int(high) or step and not int(step):
                    raise BadInput(f"{self.name}: {symbol}: no number is from {low} to {high} by {step or 1}")


def _number(rng: np.random.Generator, low: str, high: str, step: str | None) -> str:
    choices = range(int(low), int(high) + 1, int(step or 1))
    return str(choices[int(rng.integers(len(choices)))])


def _rows(name: str, symbol: str, value: object) -> list[tuple[float, str]]:
    rows = value if isinstance(value, list) else [value]
    found = [_row(row) for row in rows]
    good = [row for row in found if row is not None]
    if not good or len(good) != len(rows):
        raise BadInput(f"{name}: {symbol}: give a list of texts, or of [weight, text], the weight above zero")
    return good


def _row(row: object) -> tuple[float, str] | None:
    if isinstance(row, str):
        return 1.0, row
    if isinstance(row, list) and len(row) == 2 and isinstance(row[0], int | float) and isinstance(row[1], str):
        return (float(row[0]), row[1]) if 0 < row[0] <= _HEAVIEST else None
    return None
