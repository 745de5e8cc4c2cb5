"""Several data sets as one."""

from collections.abc import Sequence
from pathlib import Path

from apartgen.dataset import finish
from apartgen.dataset.home import Done
from apartgen.dataset.store import Store, Writer
from apartgen.schemas.errors import BadInput
from apartgen.steps import BY

_PLACE = ("shard", "start", "length", "sha256", "split")


def merge(parts: Sequence[Store], folder: Path) -> Store:
    """All homes of the parts in a new folder, those there twice once; what failed in one and was made in another is
    made. BadInput for an id that is two homes', and for parts of other settings.
    """
    store, abouts = Store(folder), [part.about() for part in parts]
    for part, about in zip(parts, abouts):
        if any(about.get(name) != abouts[0].get(name) for name in ("settings", "stages", "by", "packages")):
            raise BadInput(f"{part.folder}: other settings, stages, version or packages than {parts[0].folder}; "
                           "homes could not be made again")
    if folder.exists() and any(folder.iterdir()):
        raise BadInput(f"{folder}: is not empty; give a new folder")
    digests = _digests(parts)
    folder.mkdir(parents=True, exist_ok=True)
    writer = Writer(store, abouts[0]["per_shard"])
    seen: set[str] = set()
    for part in parts:
        for row in part.rows():
            if row["id"] not in seen and ("shard" in row or row["id"] not in digests):
                seen.add(row["id"])
                kept = {name: value for name, value in row.items() if name not in _PLACE}
                writer.add(Done(part.line(row) if "shard" in row else b"", kept))
    writer.close()
    store.describe(abouts[0] | {"by": BY, "count": len(seen), "source": {"prompts": _names(parts)}})
    finish.finish(store)
    return store


def _digests(parts: Sequence[Store]) -> dict[str, str]:
    found: dict[str, str] = {}
    for part in parts:
        for row in part.rows():
            if "shard" in row and found.setdefault(row["id"], row["sha256"]) != row["sha256"]:
                raise BadInput(f"{part.folder}: {row['id']!r} is another home than in the part before; ids must differ")
    return found


def _names(parts: Sequence[Store]) -> str:
    return " and ".join(part.folder.resolve().name for part in parts)
