"""The card of a data set: what it is, how it was made, what it holds, how it is read."""

from apartgen.dataset import statistics, table
from apartgen.dataset.store import MANIFEST, Store

_TEXT = """---
license: cc0-1.0
pretty_name: {name}
size_categories: [{size}]
configs:
- config_name: manifest
  data_files: {manifest}
---
# {name}

Furnished apartments, drawn by {by} from {source} with seed {seed}. Nothing in it was measured in a real home, and no
person's data went into it. Every home is an artifact by itself: rooms, openings, objects with assets, joints and what
carries them; metres, z up.

## What it holds
{table}
## How it is read
    apartgen dataset export {folder} -o scenes/ --format glb --id {id}
    apartgen dataset rebuild {folder} {id} -o home.json

    import datasets, json
    rows = datasets.load_dataset("{folder}", "manifest", split="train")
    lines = datasets.load_dataset("text", data_files="{folder}homes/*.jsonl.gz", split="train")
    home = json.loads(lines[0]["text"])

Homes are read as text, for a reader that wants one table for all would find other rooms in every home.
`manifest.jsonl` has a row for every request, in order: `shard`, `start` and `length` say which bytes of which file hold
the home (a gzip member of its own), `sha256` is that of its line; `metrics`, `certified`, `signature`, `split`,
`seconds`, or `error`; `thrown_away` says why other draws of a home were not taken. Homes that are nearly the same are
in one part of the split.

## How it came about
Stages: {stages}. `dataset.json` has the settings; the same settings, seed and version on the same kind of machine give
the same bytes. Limits: homes are as the model and the rules of this version draw them, not as people live.
Embedded assets are made by the program and free of rights; of others, an export's CREDITS.txt tells.
"""


def card(store: Store) -> str:
    """The card as Markdown, with the head that hubs of data sets read."""
    about, found = store.about(), statistics.statistics(store)
    first = next((row["id"] for row in store.rows() if "shard" in row), "ID")
    source = about["source"]
    return _TEXT.format(
        name=store.folder.resolve().name, size=_size(found["homes"]), by=about["by"], seed=about["seed"],
        source=f"the grammar {source['grammar']}" if "grammar" in source else f"the prompts of {source.get('prompts')}",
        manifest=table.NAME if (store.folder / table.NAME).exists() else MANIFEST,
        table=statistics.table(found), folder=store.folder.resolve().name + "/", id=first,
        stages=", ".join(about["stages"]))


def _size(count: int) -> str:
    """The hub's word for so many."""
    bounds = [(10**3, "n<1K"), (10**4, "1K<n<10K"), (10**5, "10K<n<100K"), (10**6, "100K<n<1M")]
    return next((word for bound, word in bounds if count < bound), "1M<n<10M")
