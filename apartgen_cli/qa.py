"""Ask questions about a home that pictures answer, for models that see, with answers computed from the artifact."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.layout import Layout
from apartgen_cli.check import reader
from apartgen_cli.console import say
from apartgen_cli.options import CONFIG, INPUTS, SEED, TRUST, configured, tables, with_options
from apartgen_cli.stage import opened, settled
from apartgen_cli.streams import sources, targets

FILE = Annotated[str, typer.Option(
    "--out", "-o", help="A file of JSON lines, pictures go into the folder beside it; with several inputs a folder.")]
NAMES = {"libraries": "library"}


def _files(names: list[str], out: str) -> list[Path]:
    if out == STREAM:
        raise BadInput("-o -: questions have pictures beside them; give -o FILE.jsonl")
    if len(names) == 1 and not out.endswith("/"):
        if not Path(out).suffix:
            raise BadInput(f"-o {out}: the pictures' folder would have this name; give -o {out}.jsonl")
        return [Path(out)]
    return [Path(place).with_suffix(".jsonl") for place in targets("qa", names, out.rstrip("/") + "/")]


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    from apartgen.viewing import QaSettings, questioned

    def run(out: FILE, inputs: INPUTS = None, seed: SEED = None, config: CONFIG = None, trust: TRUST = False, *,
            given: Any) -> int:
        settings = configured(QaSettings, given, tables(config).get("qa"), NAMES)
        names = sources(inputs)
        work, errors = opened(list(zip(names, _files(names, out))), Layout, True, reader(trust))
        for file, read in work:
            try:
                found = questioned(read, settings, seed, file)
            except ApartgenError as error:
                errors.append(error)
                continue
            say(f"wrote {file}: {len(found)} questions of {len({one.kind for one in found})} kinds")
        return settled(errors, len(names))

    return {"qa": with_options(run, QaSettings, NAMES)}
