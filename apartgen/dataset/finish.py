"""What a finished data set has beside its homes: parts of the split, failures as a list, a table, a card, metadata."""

import json
from typing import Any

from apartgen.dataset import card, croissant, splits
from apartgen.dataset.store import FAILURES, Row, Store

CARD, METADATA = "README.md", "croissant.json"


def is_finished(store: Store) -> bool:
    """Whether all that comes at the end is there."""
    return (store.folder / CARD).exists()


def finish(store: Store, parts: dict[str, float] | None = None) -> None:
    """Write it, whatever was there before."""
    about = store.about()
    parts = parts or about.get("parts") or splits.PARTS
    part_of = splits.assigned(store.rows(), parts, about["seed"])
    store.rewrite(row | ({"split": part_of[row["id"]]} if row["id"] in part_of else {}) for row in store.rows())
    store.describe(about | {"parts": parts})
    _write_failures(store)
    _write_table(store)
    store.write(METADATA, json.dumps(croissant.metadata(store), ensure_ascii=False, indent=1) + "\n")
    store.write(CARD, card.card(store))


def _write_failures(store: Store) -> None:
    """A list of prompts: `dataset build` takes it, and so does `plan --retry`."""
    rows = [{name: row[name] for name in ("prompt", "seed", "settings", "error", "status") if name in row}
            | ({"id": row["request"]} if "request" in row else {}) for row in store.rows() if "error" in row]
    store.write(FAILURES, "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows))


def _write_table(store: Store) -> None:
    """The manifest as a Parquet table, where pyarrow is installed."""
    try:
        import pyarrow
        from pyarrow import parquet
    except ImportError:
        return
    table = pyarrow.Table.from_pylist([_flat(row) for row in store.rows()])
    parquet.write_table(table, store.folder / "manifest.parquet")


def _flat(row: Row) -> dict[str, Any]:
    """A row without tables in it: `metrics.Col_obj` and so on; lists and counts as JSON."""
    flat: dict[str, Any] = {}
    for name, value in row.items():
        if name in ("metrics", "seconds", "digests"):
            flat |= {f"{name}.{inner}": one for inner, one in value.items()}
        else:
            flat[name] = json.dumps(value, ensure_ascii=False) if isinstance(value, dict | list) else value
    return flat
