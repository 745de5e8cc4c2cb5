"""Retrieval: every box of a layout becomes a real asset, nearest in category, size and shape latent.

Each public file here is one kind of asset library, found by its name (`folder`, `future3d`, `gapartnet`, `parametric`,
`simobjects`, `sweethome3d`); `matching/` finds and places, `reading/` opens foreign files safely, `shape/` learns the
latent, `furniture/` is the embedded library. Names are loaded when asked for, since command lines only need few.
"""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from apartgen.stages.retrieve.matching.config import RetrieveConfig as RetrieveConfig
    from apartgen.stages.retrieve.matching.indexing import Failure as Failure
    from apartgen.stages.retrieve.matching.indexing import Report as Report
    from apartgen.stages.retrieve.matching.indexing import build as build
    from apartgen.stages.retrieve.matching.indexing import check as check
    from apartgen.stages.retrieve.matching.indexing import kinds as kinds
    from apartgen.stages.retrieve.matching.libraries import LibrarySet as LibrarySet
    from apartgen.stages.retrieve.matching.libraries import open_libraries as open_libraries
    from apartgen.stages.retrieve.matching.libraries import shared_libraries as shared_libraries
    from apartgen.stages.retrieve.matching.stage import run as run

_HOME = {
    "RetrieveConfig": "config", "Failure": "indexing", "Report": "indexing", "build": "indexing", "check": "indexing",
    "kinds": "indexing", "LibrarySet": "libraries", "open_libraries": "libraries", "shared_libraries": "libraries",
    "run": "stage",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"apartgen.stages.retrieve.matching.{_HOME[name]}"), name)
