"""Results of earlier runs: one is as good as new where it came about just as it would now."""

import logging
from pathlib import Path
from typing import Any

from apartgen.schemas import artifact
from apartgen.schemas.artifact import BODIES, Artifact, Made
from apartgen.schemas.errors import BadInput

log = logging.getLogger("apartgen")


def kept(file: Path, kind: str, wanted: Made) -> Artifact[Any] | None:
    """The artifact of an earlier run, if it is of this kind and came about just as `wanted`."""
    if not file.exists():
        return None
    try:
        read = artifact.read(file, BODIES[kind])
    except BadInput as error:
        log.info("%s; making it again", error)
        return None
    return read if read.kind == kind and same(read.made, wanted) else None


def same(made: Made, wanted: Made) -> bool:
    """Whether two results are of the same inputs, settings, seed and version."""
    return made.model_copy(update={"seconds": wanted.seconds, "model": wanted.model}) == wanted
