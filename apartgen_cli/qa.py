"""Ask questions about a home that pictures answer, for models that see, with answers computed from the artifact."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import STREAM, Artifact
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen_cli.console import say
from apartgen_cli.folders import into_folders
from apartgen_cli.inputs import inputs_of
from apartgen_cli.options import CONFIG, FAILURES, INPUTS, RETRY, SEED, TRUST, configured, tables, with_options

FILE = Annotated[str, typer.Option(
    "--out", "-o", help="A file of JSON lines, pictures go into the folder beside it; with several inputs a folder.")]
NAMES = {"libraries": "library"}


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    from apartgen.viewing import QaSettings, carded, questioned

    def run(out: FILE, inputs: INPUTS = None, seed: SEED = None, config: CONFIG = None, trust: TRUST = False,
            failures: FAILURES = None, retry: RETRY = None, *, given: Any) -> int:
        settings, homes = configured(QaSettings, given, tables(config).get("qa"), NAMES), inputs_of(inputs, retry)
        below = homes.many or out.endswith("/")
        if not below and out != STREAM and not Path(out).suffix:
            raise BadInput(f"-o {out}: the pictures' folder would have this name; give -o {out}.jsonl")

        def write(read: Artifact[Any], place: Path) -> None:
            file = place.with_name(f"{place.name}.jsonl") if below else place
            found = questioned(read, settings, seed, file)
            say(f"wrote {file}: {len(found)} questions of {len({one.kind for one in found})} kinds")

        status = into_folders("qa", Layout, homes, out, write, trust=trust, failures=failures or retry, below=below)
        if below and Path(out).is_dir():
            card = carded(Path(out))
            say(f"wrote {card}" if card else f"{out}: its README.md is not ours and was left as it is")
        return status

    return {"qa": with_options(run, QaSettings, NAMES)}
