"""Sources of furnished homes to train on; each public file is one, with `homes(root, ...)` yielding layouts.

`names()` lists them, `source(name)` finds one, `_arrays.write_corpus` turns homes into what training reads.
"""

import inspect
from types import ModuleType

from apartgen.stages import registry


def names() -> list[str]:
    """Every data source by name."""
    return list(registry.members(__name__))


def source(name: str) -> ModuleType:
    """The data source of that name; BadInput when there is none."""
    return registry.load(__name__, name)


def options(name: str) -> frozenset[str]:
    """What `homes` of a data source takes beside its root."""
    return frozenset(inspect.signature(source(name).homes).parameters) - {"root"}
