"""A data set on the disk, written so that being killed at any moment costs nothing that was done.

A home is appended to its shard, then its row to the manifest, both in the order of the requests. What is behind the
last whole row was being written when a run ended, and is taken off by the next.
"""

import fcntl
import gzip
import hashlib
import json
import os
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import IO, Any

from apartgen.dataset import rows
from apartgen.dataset.home import Done
from apartgen.dataset.rows import Row
from apartgen.schemas import artifact, files
from apartgen.schemas.errors import BadInput

MANIFEST, ABOUT, HOMES, FAILURES = "manifest.jsonl", "dataset.json", "homes", "failures.jsonl"
PER_SHARD = 1000
"""Requests of a shard; a home is about 11 kB there."""


class Store:
    """The folder of a data set."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @property
    def manifest(self) -> Path:
        """The file of rows."""
        return self.folder / MANIFEST

    def about(self) -> dict[str, Any]:
        """What was asked for. BadInput where there is no data set."""
        if not (self.folder / ABOUT).is_file():
            raise BadInput(f"{self.folder}: no {ABOUT} in it; make a data set with `apartgen dataset build`")
        value = artifact.json_value(artifact.contents(self.folder / ABOUT), str(self.folder / ABOUT))
        if not isinstance(value, dict) or value.get("apartgen_dataset") != 1:
            raise BadInput(f"{self.folder / ABOUT}: not of a data set that this apartgen reads")
        return rows.about(value, str(self.folder / ABOUT))

    def describe(self, about: dict[str, Any]) -> None:
        """Write what was asked for."""
        self.write(ABOUT, json.dumps(about, ensure_ascii=False, indent=1) + "\n")

    def write(self, name: str, text: str) -> None:
        """Write a file of the data set, whole or not at all."""
        artifact.write(text, self.folder / name)

    def rows(self) -> Iterator[Row]:
        """The manifest, a row at a time. BadInput where one is damaged."""
        if not self.manifest.is_file():
            return
        with open(self.manifest, "rb") as lines:
            for i, line in enumerate(lines, 1):
                if line.endswith(b"\n"):
                    yield rows.row(line, f"{self.manifest}:{i}")

    def line(self, row: Row) -> bytes:
        """The artifact of a row, as a line. BadInput where the shard is damaged."""
        place = self.folder / HOMES / str(row.get("shard"))
        try:
            with open(place, "rb") as file:
                file.seek(row["start"])
                return gzip.decompress(file.read(row["length"]))
        except (OSError, EOFError, ValueError, KeyError, zlib.error) as error:
            raise BadInput(f"{row.get('id')}: cannot be read from {place} ({error})") from None

    def rewrite(self, others: Iterable[Row]) -> None:
        """Put other rows in the manifest's place."""
        fresh = files.part_of(self.manifest)
        with open(fresh, "wb") as file:
            for row in others:
                file.write(_as_line(row))
            file.flush()
            os.fsync(file.fileno())
        os.replace(fresh, self.manifest)


class Writer:
    """Appends homes, one after another."""

    def __init__(self, store: Store, per_shard: int = PER_SHARD) -> None:
        self._store, self._per_shard = store, per_shard
        (store.folder / HOMES).mkdir(parents=True, exist_ok=True)
        self._rows = open(store.manifest, "ab")
        _lock(self._rows, store.folder)
        self.count, ends = _mended(store)
        self._shard: IO[bytes] | None = None
        self._name = ""
        for place in sorted((store.folder / HOMES).glob("*.jsonl.gz")):
            _cut(place, ends.get(place.name, 0))

    def add(self, done: Done) -> Row:
        """One more home, or what prevented it."""
        row = done.row
        if done.line:
            row |= self._put(done.line)
        self._rows.write(_as_line(row))
        self._rows.flush()
        self.count += 1
        return row

    def _put(self, line: bytes) -> Row:
        name = f"{self.count // self._per_shard:05d}.jsonl.gz"
        if name != self._name or self._shard is None:
            self._close_shard()
            self._shard, self._name = open(self._store.folder / HOMES / name, "ab"), name
        data = gzip.compress(line, 6, mtime=0)
        start = self._shard.tell()
        self._shard.write(data)
        self._shard.flush()
        return {"shard": name, "start": start, "length": len(data), "sha256": hashlib.sha256(line).hexdigest()}

    def _close_shard(self) -> None:
        if self._shard is not None:
            os.fsync(self._shard.fileno())
            self._shard.close()

    def close(self) -> None:
        """Everything is on the disk."""
        self._close_shard()
        os.fsync(self._rows.fileno())
        self._rows.close()


def _lock(file: IO[bytes], folder: Path) -> None:
    """BadInput while another run has the file; the lock ends with the run, however that ends."""
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        raise BadInput(f"{folder}: another run writes to it; wait for it, or give another folder") from None


def _mended(store: Store) -> tuple[int, dict[str, int]]:
    """How many rows there are, a torn one taken off, and where every shard ends by them."""
    count, end, ends = 0, 0, dict[str, int]()
    if not store.manifest.is_file():
        return 0, {}
    with open(store.manifest, "rb") as lines:
        for line in lines:
            if not line.endswith(b"\n"):
                break
            row = rows.row(line, f"{store.manifest}:{count + 1}")
            count, end = count + 1, end + len(line)
            if "shard" in row:
                ends[row["shard"]] = row["start"] + row["length"]
    _cut(store.manifest, end)
    return count, ends


def _cut(file: Path, end: int) -> None:
    """Take off what is behind `end`; BadInput where something before it is missing."""
    size = file.stat().st_size
    if size < end:
        raise BadInput(f"{file}: {end - size} bytes are missing that {MANIFEST} tells of; take it from a copy")
    if size > end:
        os.truncate(file, end)


def _as_line(row: Row) -> bytes:
    return json.dumps(row, ensure_ascii=False, separators=(",", ":")).encode() + b"\n"
