"""Which assets a preview shows, and where they come from."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from apartgen.schemas.errors import BadInput, near
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching.indexed import IndexedLibrary
from apartgen.stages.retrieve.preview import sheet
from apartgen.stages.retrieve.preview.sheet import Cell
from apartgen.stages.things import categories

MOST = 600
"""Assets on one sheet."""


def cells(folders: Sequence[Path], ids: Sequence[str], category: str, size: int) -> Iterable[Cell]:
    """Pictures of the assets of these ids, or of a category, or of all there is; BadInput when there are none.

    Without folders the library is the embedded one.
    """
    known = [*categories.TABLE, *furniture.BUILDING]
    if category and category not in known:
        raise BadInput(f"no category {category!r}; {near(category, known)}")
    if ids and category:
        raise BadInput("--category and ids: give one or the other")
    if folders:
        return _owned([IndexedLibrary(folder) for folder in folders], ids, category, size)
    if ids:
        return [sheet.of_asset(furniture.load_asset(id), id, size) for id in ids]
    return sheet.of_category(category, size) if category else sheet.of_library(size)


def _owned(libraries: Sequence[IndexedLibrary], ids: Sequence[str], category: str, size: int) -> Iterator[Cell]:
    entries = [(one, entry) for one in libraries for entry in one.entries if not category or entry.category == category]
    chosen = [_found(libraries, id) for id in ids] or [(one, entry.id) for one, entry in entries]
    names = ", ".join(one.name for one in libraries)
    if not chosen:
        raise BadInput(f"{names}: no asset of category {category!r}; `apartgen assets list` tells what there is")
    if len(chosen) > MOST:
        raise BadInput(f"{names}: {len(chosen)} assets, more than the {MOST} of one sheet; choose by --category or ids")
    return (sheet.of_asset(one.load_asset(id), id, size) for one, id in chosen)


def _found(libraries: Sequence[IndexedLibrary], id: str) -> tuple[IndexedLibrary, str]:
    for library in libraries:
        if any(entry.id == id for entry in library.entries):
            return library, id
    raise BadInput(f"{', '.join(one.name for one in libraries)}: no asset {id!r}; see `apartgen assets list`")
