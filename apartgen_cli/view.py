"""Look at a home in the browser, at two side by side with their figures, or at the plans of many on one picture."""

import tempfile
import webbrowser
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Plan
from apartgen_cli.check import reader
from apartgen_cli.console import say
from apartgen_cli.options import INPUTS, TRUST
from apartgen_cli.streams import sources

PAGE = Annotated[Path | None, typer.Option(
    "--out", "-o", metavar="PAGE",
    help="The page to write, or a picture .png of all plans; without it, a page that is opened in the browser.")]
LIBRARY = Annotated[list[str] | None, typer.Option("--library", help="Folder of an indexed asset library in use.")]
MOST = 2


def _run(inputs: INPUTS = None, out: PAGE = None, library: LIBRARY = None, trust: TRUST = False) -> int:
    """One page that needs no network: walls are cut away where they hide, parts open, one walks about; of two homes
    with a table of their figures. With -o homes.png the plans of any number of homes, to one scale.
    """
    from apartgen.viewing import sheeted, viewed

    names = sources(inputs)
    if out is not None and out.suffix == ".png":
        sheeted([reader(trust)(name, Plan, True) for name in names], out)
        say(f"wrote {out}")
        return 0
    if len(names) > MOST:
        raise BadInput(f"{len(names)} homes: a page shows one, or two side by side; -o homes.png shows all plans")
    if out is not None and (str(out) == STREAM or out.is_dir()):
        raise BadInput(f"-o {out}: a page is one file; give -o home.html")
    homes = [reader(trust)(name, Plan, True) for name in names]
    page = out or Path(tempfile.mkdtemp(prefix="apartgen-")) / "apartment.html"
    viewed(homes, page, library or [])
    say(f"wrote {page}")
    if out is None and not webbrowser.open(page.absolute().as_uri()):
        say("no browser could be opened; open it by hand")
    return 0


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"view": _run}
