"""Take pictures of a home with labels: colour, depth, normals, albedo, instances, classes, boxes, points."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import Artifact
from apartgen.schemas.plan import Plan
from apartgen_cli.console import say
from apartgen_cli.folders import into_folders
from apartgen_cli.inputs import inputs_of
from apartgen_cli.options import CONFIG, FAILURES, INPUTS, RETRY, SEED, TRUST, configured, tables, with_options

FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]
NAMES = {"libraries": "library"}


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    from apartgen.rendering import RenderSettings, rendered

    def run(out: FOLDER, inputs: INPUTS = None, seed: SEED = None, config: CONFIG = None, trust: TRUST = False,
            failures: FAILURES = None, retry: RETRY = None, *, given: Any) -> int:
        settings = configured(RenderSettings, given, tables(config).get("render"), NAMES)

        def write(read: Artifact[Any], folder: Path) -> None:
            found = rendered(read, settings, seed, folder)
            say(f"wrote {folder / 'views.json'}: {len(found.views)} views of {len(found.instances)} things")

        homes = inputs_of(inputs, retry)
        return into_folders("render", Plan, homes, out, write, trust=trust, failures=failures or retry)

    return {"render": with_options(run, RenderSettings, NAMES)}
