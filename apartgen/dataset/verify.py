"""Whether a data set is what its manifest says: every byte, every digest, every home by the judge."""

import hashlib
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from apartgen.dataset import pool
from apartgen.dataset.rows import Row
from apartgen.dataset.store import HOMES, Store
from apartgen.schemas import artifact
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan
from apartgen.stages import check


def verify(store: Store, workers: int | None = None, report: Callable[[str], None] = lambda id: None) -> Iterator[str]:
    """Everything that is wrong, a sentence each; `report` gets the id of each home that was looked at."""
    seen: set[str] = set()
    ends: dict[str, int] = {}
    rows = store.rows()
    for row, wrong in pool.results(partial(_looked_at, store.folder), rows, pool.cores(workers), _lost):
        if row["id"] in seen:
            yield f"{row['id']}: is there twice"
        seen.add(row["id"])
        if "shard" in row:
            if row["start"] != ends.get(row["shard"], 0):
                yield f"{row['id']}: does not begin where the home before it ends, in {row['shard']}"
            ends[row["shard"]] = row["start"] + row["length"]
        yield from wrong
        report(row["id"])
    yield from _whole(store, len(seen), ends)


def _whole(store: Store, count: int, ends: dict[str, int]) -> Iterator[str]:
    wanted = store.about()["count"]
    if count != wanted:
        yield f"{store.folder}: has {count} of {wanted} homes; run the same `apartgen dataset build` again"
    for file in sorted((store.folder / HOMES).iterdir()):
        if file.stat().st_size != ends.get(file.name, 0):
            yield f"{file}: has {file.stat().st_size} bytes, {ends.get(file.name, 0)} of them in the manifest"


def _looked_at(folder: Path, row: Row) -> tuple[Row, list[str]]:
    if "shard" not in row:
        return row, [] if "error" in row else [f"{row['id']}: neither a home nor an error"]
    try:
        line = Store(folder).line(row)
        if hashlib.sha256(line).hexdigest() != row["sha256"]:
            return row, [f"{row['id']}: is not the home that was made (sha256)"]
        read = artifact.parse(line, row["id"], Plan, whole=True)
    except ApartgenError as error:
        return row, [str(error)]
    wrong = [] if read.digest == row["digests"][row["kind"]] else [f"{row['id']}: has another digest than its row"]
    if any(fault.refuses for fault in check.run(read.body)) == row["certified"]:
        wrong.append(f"{row['id']}: the judge does not say what its row says")
    return row, wrong


def _lost(row: Row) -> tuple[Row, list[str]]:
    return row, [f"{row['id']}: reading it ended the process"]
