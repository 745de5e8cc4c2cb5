"""What stages gave for inputs that stay the same: compared by short digests. `make digests` writes them anew.

They say that something changed, not that it is wrong: what is right is asked by the other tests.
"""

import json
import os
import platform
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from digests.rounded import digest
from llvmlite.binding import get_host_cpu_name

from apartgen.outputs import opened_libraries
from apartgen.schemas import artifact
from apartgen.schemas.retrieve import Retrieve
from apartgen.stages import seeds

FOLDER = Path(__file__).parent
HOMES = ("studio", "flat", "house")
WRITE = "APARTGEN_WRITE_GOLDEN"
HERE = [platform.system(), get_host_cpu_name()]
PLACE = FOLDER / "machine.json"
"""Says where they were written; on another kind of machine a search may go another way."""


@cache
def home(name: str) -> Retrieve:
    """A furnished home in a file that is never written anew."""
    body: Retrieve = artifact.read(FOLDER / "homes" / f"{name}.json", Retrieve).body
    return body


def load(library: str, id: str) -> Any:
    """An asset of the embedded library."""
    return opened_libraries().load_asset(library, id)


def lane(*names: str) -> np.random.Generator:
    """Random numbers by name."""
    return seeds.drawn(5, *names)


def same(stage: str, case: str, found: Mapping[str, Any]) -> None:
    """Fails where parts of what was found are not what they were."""
    if os.environ.get(WRITE):
        PLACE.write_text(json.dumps(HERE) + "\n", encoding="utf-8")
    elif (there := json.loads(PLACE.read_text(encoding="utf-8"))) != HERE:
        pytest.skip(f"kept on {' '.join(there)}")
    file = FOLDER / f"{stage}.json"
    if not file.exists() and not os.environ.get(WRITE):
        pytest.skip(f"nothing is kept of {stage}: `make digests` writes it")
    known = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    told = {part: digest(value) for part, value in found.items()}
    if os.environ.get(WRITE):
        known[case] = told
        lines = [f'"{name}": {json.dumps(known[name])}' for name in sorted(known)]
        file.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
        return
    was = known.get(case, {})
    changed = [part for part in {**was, **told} if was.get(part) != told.get(part)]
    if changed:
        pytest.fail(f"{stage}, {case}: {', '.join(changed[:8])} not as kept; where that is meant, `make digests` "
                    "writes them anew", pytrace=False)
