"""Scenes of any homes of a data set, made when they are wanted; files that are equal are stored once."""

import os
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path

from apartgen import outputs
from apartgen.dataset import pool
from apartgen.dataset.rows import Row
from apartgen.dataset.store import Store
from apartgen.schemas import artifact
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan

STORE = "store"
ENDED = "its process ended without an answer, again and again"


def export(store: Store, rows: Iterable[Row], out: Path, settings: outputs.ExportSettings,
           workers: int | None = None) -> Iterator[tuple[Row, str]]:
    """A folder for each home, and what prevented it, or nothing. Files of equal contents are links to one in `store/`,
    named by its digest.
    """
    (out / STORE).mkdir(parents=True, exist_ok=True)
    yield from pool.results(partial(_exported, store.folder, out, settings), rows, pool.cores(workers),
                            lambda row: (row, ENDED))


def _exported(folder: Path, out: Path, settings: outputs.ExportSettings, row: Row) -> tuple[Row, str]:
    try:
        read = artifact.parse(Store(folder).line(row), row["id"], Plan, whole=True)
        if outputs.intact(read, settings, out / row["id"]) is None:
            files = outputs.finished(read, settings, out / row["id"])
            for file in files.files:
                _share(out / row["id"] / file.path, out / STORE / file.sha256[:2] / file.sha256)
    except ApartgenError as error:
        return row, str(error)
    return row, ""


def _share(file: Path, stored: Path) -> None:
    """Make a file and the stored one of its contents the same; where the disk has no links, both stay."""
    stored.parent.mkdir(exist_ok=True)
    try:
        try:
            os.link(file, stored)
        except FileExistsError:
            fresh = file.with_name(f".{file.name}.part")
            fresh.unlink(missing_ok=True)
            os.link(stored, fresh)
            os.replace(fresh, file)
    except OSError:
        return
