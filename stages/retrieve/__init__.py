"""Retrieve: every box of a layout becomes a real asset, nearest in category, size and shape latent.

Each public file here is one kind of asset library, found by its name (`parametric`, `gapartnet`, `future3d`,
`folder`, `simobjects`, `sweethome3d`); `matching/` finds and places, `reading/` opens foreign files safely,
`shape/` learns the latent, `furniture/` is the embedded library.
"""

from stages.retrieve.matching.config import RetrieveConfig
from stages.retrieve.matching.indexing import Failure, Report, build, check, kinds
from stages.retrieve.matching.libraries import LibrarySet, open_libraries
from stages.retrieve.matching.run import run

__all__ = ["Failure", "LibrarySet", "Report", "RetrieveConfig", "build", "check", "kinds", "open_libraries", "run"]
