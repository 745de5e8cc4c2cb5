"""Homes as tars that WebDataset reads: a sample a home, its artifact, its row, and files of formats that are one file.

    train-00000.tar: 0000003.home.json  0000003.row.json  0000003.plan.svg  0000007.home.json  …
"""

import io
import json
import tarfile
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO, NamedTuple

from apartgen import outputs
from apartgen.dataset import pool
from apartgen.dataset.rows import Row
from apartgen.dataset.scenes import ENDED
from apartgen.dataset.store import Store
from apartgen.schemas import artifact, files
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan

FORMAT = "webdataset"
_BESIDE = ("export.json", "CREDITS.txt", "SHA256SUMS")


class Sample(NamedTuple):
    """The files of a home by what stands behind the first dot of their names; or why there is none."""

    row: Row
    files: dict[str, bytes]
    error: str = ""


def export(store: Store, rows: Iterable[Row], out: Path, settings: outputs.ExportSettings | None, per_tar: int,
           workers: int | None = None) -> Iterator[tuple[Row, str]]:
    """Every home, and what prevented it, or nothing. Tars are by part of the split, with `per_tar` homes each, the
    number of a home's row as key; they appear whole, and are the same bytes whenever they are made.
    """
    out.mkdir(parents=True, exist_ok=True)
    parts: dict[str, _Part] = {}
    made = pool.results(partial(_sample, store.folder, settings), _numbered(store, rows), pool.cores(workers), _lost)
    for number, sample in made:
        name = sample.row.get("split") or "homes"
        if not sample.error:
            parts.setdefault(name, _Part(out, name, per_tar)).add(number, sample.files)
        yield sample.row, sample.error
    for part in parts.values():
        part.close()


class _Part:
    """The tars of one part, one after another."""

    def __init__(self, out: Path, name: str, per_tar: int) -> None:
        self._out, self._name, self._per_tar, self._count = out, name, per_tar, 0
        self._open: tuple[Path, IO[bytes], tarfile.TarFile] | None = None

    def add(self, number: int, found: dict[str, bytes]) -> None:
        if self._count % self._per_tar == 0:
            self.close()
            place = self._out / f"{self._name}-{self._count // self._per_tar:05d}.tar"
            file = open(files.part_of(place), "wb")
            self._open = place, file, tarfile.open(fileobj=file, mode="w", format=tarfile.USTAR_FORMAT)
        self._count += 1
        assert self._open is not None
        for kind, data in found.items():
            member = tarfile.TarInfo(f"{number:07d}.{kind}")
            member.size = len(data)
            self._open[2].addfile(member, io.BytesIO(data))

    def close(self) -> None:
        if self._open is not None:
            place, file, tar = self._open
            tar.close()
            file.close()
            Path(file.name).replace(place)
            self._open = None


def _numbered(store: Store, rows: Iterable[Row]) -> Iterator[tuple[int, Row]]:
    """Rows with their numbers in the manifest."""
    numbers = {row["id"]: i for i, row in enumerate(store.rows())}
    return ((numbers[row["id"]], row) for row in rows)


def _lost(piece: tuple[int, Row]) -> tuple[int, Sample]:
    return piece[0], Sample(piece[1], {}, ENDED)


def _sample(folder: Path, settings: outputs.ExportSettings | None, piece: tuple[int, Row]) -> tuple[int, Sample]:
    number, row = piece
    try:
        line = Store(folder).line(row)
        found = {"home.json": line, "row.json": json.dumps(row, ensure_ascii=False).encode()}
        return number, Sample(row, found | (_scene(line, row["id"], settings) if settings else {}))
    except ApartgenError as error:
        return number, Sample(row, {}, str(error))


def _scene(line: bytes, id: str, settings: outputs.ExportSettings) -> dict[str, bytes]:
    read = artifact.parse(line, id, Plan, whole=True)
    with TemporaryDirectory() as folder:
        written = outputs.finished(read, settings, Path(folder) / "scene").files
        many = [file for file in written if "/" in file.path]
        if many:
            raise BadInput(f"--format {many[0].format}: is many files a home; leave out --format {FORMAT}")
        return {file.path: (Path(folder) / "scene" / file.path).read_bytes() for file in written
                if file.path not in _BESIDE}
