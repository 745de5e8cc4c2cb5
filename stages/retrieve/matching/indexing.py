"""Making a library of a folder of foreign assets: each one read, checked, measured, kept in this project's form."""

import logging
import shutil
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
from apartgen.stages.retrieve.matching import indexed, store, textures
from apartgen.stages.retrieve.matching.embedded import NAME
from apartgen.stages.retrieve.matching.indexed import TABLE_FILE, Entry, asset_file
from apartgen.stages.things.asset import Asset

LOG = logging.getLogger("apartgen")

PACKAGES = frozenset({"furniture", "matching", "preview", "reading", "shape"})
"""What is in the registry's folder without being a library."""
FAULTS = (BadInput, ValueError, ArithmeticError, LookupError, TypeError, RecursionError, MemoryError, OSError)
"""What a broken file can end in; anything else is a fault of this program and is not hidden."""


class Failure(NamedTuple):
    """An asset that can't be used, and why."""

    id: str
    reason: str


class Report(NamedTuple):
    """What became of a folder: assets indexed by category, and those that were broken."""

    name: str
    categories: dict[str, int]
    broken: list[Failure]

    @property
    def indexed(self) -> int:
        """How many assets were indexed."""
        return sum(self.categories.values())


def kinds() -> dict[str, str]:
    """Kinds of library that can be indexed, and their one-line help."""
    found = registry.members("apartgen.stages.retrieve")
    return {name: text for name, text in found.items() if name not in PACKAGES | {NAME}}


def read(root: Path, kind: str, **options: Any) -> Iterator[tuple[str, Asset | Failure]]:
    """Each asset of a folder by id, or why it is broken."""
    if kind not in kinds():
        raise BadInput(f"no kind of library {kind!r}; one of: {', '.join(kinds())}")
    if not root.exists():
        raise BadInput(f"{root}: no such file or folder")
    reader: Callable[..., Iterator[Any]] = registry.load("apartgen.stages.retrieve", kind).assets
    for source in reader(root, **options):
        try:
            yield source.id, source.load()
        except FAULTS as error:
            plain = isinstance(error, BadInput)
            yield source.id, Failure(source.id, str(error) if plain else f"{type(error).__name__}: {error}")


def check(root: Path, kind: str, **options: Any) -> Report:
    """Reads all of a folder and tells what could be indexed."""
    counts: Counter[str] = Counter()
    broken: list[Failure] = []
    for _, found in read(root, kind, **options):
        if isinstance(found, Failure):
            broken.append(found)
        else:
            counts[found.category] += 1
    return Report(root.stem, dict(sorted(counts.items())), broken)


def build(root: Path, kind: str, out: Path, name: str = "", **options: Any) -> Report:
    """Indexes a folder into `out`, which appears whole or stays as it was; Report says what was left out and why.

    `options` go to the reader: `scale` (metres per unit) and `front` where it has them.
    """
    if out.exists() and not (out / TABLE_FILE).exists() and any(out.iterdir()):
        raise BadInput(f"{out}: not empty and no asset library; give another folder")
    partial = out.with_name(f".{out.name}.partial")
    shutil.rmtree(partial, ignore_errors=True)
    try:
        report = _fill(partial, root, kind, name or root.stem, options)
        if out.exists():
            shutil.rmtree(out)
        partial.rename(out)
    finally:
        shutil.rmtree(partial, ignore_errors=True)
    return report


def _fill(folder: Path, root: Path, kind: str, name: str, options: dict[str, Any]) -> Report:
    from apartgen.stages.retrieve.shape.encoder import latents

    entries: list[Entry] = []
    rows: list[Any] = []
    broken: list[Failure] = []
    for id, found in read(root, kind, **options):
        if isinstance(found, Failure):
            LOG.warning("%s: %s", found.id, found.reason)
            broken.append(found)
            continue
        found = textures.kept(found, folder)
        latent = latents([found])[0]
        row = len(entries)
        store.write(replace(found, library=name, id=id, latent=latent), asset_file(folder, row))
        entries.append(Entry(id, found.category, found.style, len(found.joints), found.credit, found.size))
        rows.append(latent)
    indexed.write(folder, name, kind, entries, np.asarray(rows))
    counts = Counter(entry.category for entry in entries)
    return Report(name, dict(sorted(counts.items())), broken)
