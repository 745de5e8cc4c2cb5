"""Makes a data set: every request in turn on all cores, going on where an earlier run ended."""

from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from apartgen import settings
from apartgen.dataset import engines, finish
from apartgen.dataset.copies import Place
from apartgen.dataset.home import Asked, Done, Settings, home, row_of, steps_of
from apartgen.dataset.rows import Row
from apartgen.dataset.source import Source
from apartgen.dataset.store import PER_SHARD, Store, Writer
from apartgen.requests import Request
from apartgen.schemas.errors import BadInput
from apartgen.steps import BY, POPULATE, STEPS, brought

Report = Callable[[Row], None]


def build(source: Source, folder: Path, *, seed: int = 0, given: Settings | None = None, workers: int | None = None,
          per_shard: int = PER_SHARD, populate: bool = True, engine: str = engines.LOCAL,
          report: Report = lambda row: None, copies: Place | None = None) -> Store:
    """The data set of all requests of the source, with small things in the homes or without, made by an engine of
    `engines.ENGINES`; `report` gets the row of every home that is made, `copies` every shard when it is full.

    BadInput where the folder, or the place of the copies, holds another data set; Unmet where that can't be written.
    """
    settings.by_stage(given or {}, ["svg"])
    maker = engines.engine(engine)
    store = Store(folder)
    _begun(store, source, {"apartgen_dataset": 1, "by": BY, "seed": seed, "per_shard": per_shard,
                           "stages": ["plan", *(step.word for step in steps_of(populate))],
                           "settings": {word: dict(table) for word, table in (given or {}).items()}} | _packages())
    if copies is not None:
        copies.take(store.folder)
    writer = Writer(store, per_shard)
    try:
        before = writer.count
        work = (Asked(one, seed if one.seed is None else one.seed, given or {}, populate)
                for one in islice(source.requests(), before, None))
        for done in maker.results(home, work, workers, _lost, store.folder):
            report(writer.add(done))
            if copies is not None and writer.count % per_shard == 0:
                copies.try_taking(store.folder)
    finally:
        writer.close()
    if writer.count != before or not finish.is_finished(store):
        finish.finish(store)
    if copies is not None:
        copies.take(store.folder)
    return store


def _lost(asked: Asked) -> Done:
    """The row of a home whose worker was killed, again and again."""
    why = "its process ended without an answer, again and again: killed, or out of memory"
    return Done(b"", row_of(asked) | {"error": why, "status": 1, "seconds": {}})


def _packages() -> dict[str, dict[str, str]]:
    """What other packages bring to the stages and the figures, where there are any."""
    found = {word: digest for word in (*(step.word for step in STEPS), "metrics") if (digest := brought(word))}
    return {"packages": found} if found else {}


def _begun(store: Store, source: Source, about: dict[str, Any]) -> None:
    about |= {"source": source.about(), "count": source.count}
    store.folder.mkdir(parents=True, exist_ok=True)
    if not (store.folder / "dataset.json").exists():
        if any(store.folder.iterdir()):
            raise BadInput(f"{store.folder}: holds files that are no data set's; give an empty or a new folder")
        store.describe(about)
        return
    old = store.about()
    if old.get("packages") != about.get("packages"):
        raise BadInput(f"{store.folder}: the packages that add to apartgen are others than those that its homes were "
                       "made with, or have changed; give another folder")
    for name in about:
        if name != "count" and old.get(name) != about[name]:
            raise BadInput(f"{store.folder}: is a data set of another {name}; give another folder, or ask for the same")
    if old["count"] > about["count"]:
        raise BadInput(f"{store.folder}: is to have {old['count']} homes already; ask for as many or more")
    store.describe(old | {"count": about["count"]})


def again(row: Row, about: dict[str, Any]) -> Done:
    """One home of a data set, made anew from its row."""
    request = Request(row["prompt"], row.get("request", ""), None, row.get("settings", {}), row["id"])
    return home(Asked(request, row["seed"], about["settings"], POPULATE.word in about["stages"]))


def selected(store: Store, ids: list[str], split: str | None = None) -> Iterator[Row]:
    """The rows of homes by id, or of a part of the split; of all that were made, where neither is named."""
    left = set(ids)
    for row in store.rows():
        if "shard" in row and (row["id"] in left if ids else True) and split in (None, row.get("split")):
            left.discard(row["id"])
            yield row
    if left:
        more = f", nor {len(left) - 1} more of those named" if len(left) > 1 else ""
        raise BadInput(f"{store.folder}: has no home {min(left)!r}{more}")
