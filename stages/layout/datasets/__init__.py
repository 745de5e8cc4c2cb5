"""Sources of furnished homes to train on; each public file is one, with `homes(root, ...)` yielding layouts.

`names()` lists them, `source(name)` finds one, `arrays.write_corpus` turns homes into what training reads.
"""

from importlib import import_module
from pathlib import Path
from types import ModuleType

from schemas.errors import BadInput


def names() -> list[str]:
    """Every data source by name."""
    return sorted(p.stem for p in Path(__file__).parent.glob("*.py") if not p.stem.startswith("_"))


def source(name: str) -> ModuleType:
    """The data source of that name; BadInput when there is none."""
    if name not in names():
        raise BadInput(f"no data source {name!r}; there are {', '.join(names())}")
    return import_module(f"{__name__}.{name}")
