"""Answer requests as lines of JSON, with all models loaded: on standard input, or a socket of the user's own."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

import typer

from apartgen_cli.console import say

SOCKET = Annotated[Path | None, typer.Option(
    "--socket", metavar="PATH", help="Listen here, for the owner only, instead of reading standard input.")]
WARM = Annotated[bool, typer.Option("--warm/--cold", help="Load everything before the first request.")]


def _run(socket: SOCKET = None, warm: WARM = True) -> None:
    """Every line of input is a request, as {"do": "plan", "prompt": "studio"}, and has a line of output."""
    from apartgen import serving

    if warm:
        serving.warm()
    if socket is not None:
        serving.listen(socket, lambda: say(f"ready at {socket}"))
        return
    say("ready")
    for text in serving.answers(serving.read_lines(sys.stdin.buffer)):
        sys.stdout.write(text)
        sys.stdout.flush()


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"serve": _run}
