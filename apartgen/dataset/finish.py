"""What a finished data set has beside its homes: parts of the split, failures as a list, a table, a card, metadata."""

import json

from apartgen.dataset import card, croissant, splits, table
from apartgen.dataset.store import FAILURES, Store

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
    table.write(store)
    store.write(METADATA, json.dumps(croissant.metadata(store), ensure_ascii=False, indent=1) + "\n")
    store.write(CARD, card.card(store))


def _write_failures(store: Store) -> None:
    """A list of prompts: `dataset build` takes it, and so does `plan --retry`."""
    rows = [{name: row[name] for name in ("prompt", "seed", "settings", "error", "status") if name in row}
            | ({"id": row["request"]} if "request" in row else {}) for row in store.rows() if "error" in row]
    store.write(FAILURES, "".join(json.dumps(row, ensure_ascii=False) + "\n" for row in rows))
