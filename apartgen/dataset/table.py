"""The manifest as a Parquet table, where pyarrow is installed: a column a figure, with rows a batch at a time."""

import json
from collections.abc import Iterator
from itertools import islice
from typing import Any

from apartgen.dataset.rows import Row
from apartgen.dataset.store import Store
from apartgen.schemas import files

NAME = "manifest.parquet"
BATCH = 5000
"""Rows that are held at once."""
_OPENED = ("metrics", "seconds", "digests")
"""Tables in a row whose entries become columns: `metrics.Col_obj` and so on."""


def write(store: Store) -> None:
    """Write it anew, whole or not at all; without pyarrow, nothing."""
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        return
    kinds = _kinds(store)
    types = {str: pyarrow.string(), bool: pyarrow.bool_(), int: pyarrow.int64(), float: pyarrow.float64()}
    schema = pyarrow.schema([(name, types[kind]) for name, kind in kinds.items()])
    fresh = files.part_of(store.folder / NAME)
    with parquet.ParquetWriter(fresh, schema) as writer:
        rows = ({name: None if value is None else kinds[name](value) for name, value in flat(row).items()}
                for row in store.rows())
        while batch := list(islice(rows, BATCH)):
            writer.write_table(pyarrow.Table.from_pylist(batch, schema))
    fresh.replace(store.folder / NAME)


def _kinds(store: Store) -> dict[str, type]:
    """Every column that any row has, in the order of first sight, and what is in it; words where rows disagree."""
    found: dict[str, type] = {}
    for name, value in (entry for row in store.rows() for entry in flat(row).items()):
        if value is not None:
            kind = type(value)
            old = found.setdefault(name, kind)
            if old is not kind:
                found[name] = float if {old, kind} == {int, float} else str
    return found


def flat(row: Row) -> dict[str, Any]:
    """A row without tables in it; lists and counts as JSON."""
    return dict(_entries(row))


def _entries(row: Row) -> Iterator[tuple[str, Any]]:
    for name, value in row.items():
        if name in _OPENED:
            yield from ((f"{name}.{inner}", one) for inner, one in value.items())
        else:
            yield name, json.dumps(value, ensure_ascii=False) if isinstance(value, dict | list) else value
