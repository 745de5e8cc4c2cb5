"""Take pictures of a home with labels: colour, depth, normals, albedo, instances, classes, boxes, points."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plan import Plan
from apartgen_cli.check import reader
from apartgen_cli.console import say
from apartgen_cli.options import CONFIG, INPUTS, SEED, TRUST, configured, tables, with_options
from apartgen_cli.stage import opened, settled
from apartgen_cli.streams import sources, targets

FOLDER = Annotated[str, typer.Option("--out", "-o", help="The folder to write; it is replaced whole or not at all.")]
NAMES = {"libraries": "library"}


def folders(word: str, names: list[str], out: str) -> list[Path]:
    """The folder itself for one apartment, one below it for each of several."""
    if out == STREAM:
        raise BadInput(f"-o -: {word} writes a folder of files; give -o FOLDER/")
    if len(names) == 1:
        return [Path(out)]
    return [Path(place).with_suffix("") for place in targets(word, names, out.rstrip("/") + "/")]


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    from apartgen.viewing import RenderSettings, rendered

    def run(out: FOLDER, inputs: INPUTS = None, seed: SEED = None, config: CONFIG = None, trust: TRUST = False, *,
            given: Any) -> int:
        settings = configured(RenderSettings, given, tables(config).get("render"), NAMES)
        names = sources(inputs)
        work, errors = opened(list(zip(names, folders("render", names, out))), Plan, True, reader(trust))
        for folder, read in work:
            try:
                found = rendered(read, settings, seed, folder)
            except ApartgenError as error:
                errors.append(error)
                continue
            say(f"wrote {folder / 'views.json'}: {len(found.views)} views of {len(found.instances)} things")
        return settled(errors, len(names))

    return {"render": with_options(run, RenderSettings, NAMES)}
