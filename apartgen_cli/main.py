"""The `apartgen` program: finds the command, shows errors in one or two lines, sets the exit status.

A command is a public module beside this one with a function `command() -> Callable`; it is imported when it is called,
so that help and the light commands start without the heavy packages.
"""

import errno
import importlib
import os
import signal
import sys
from typing import Annotated, Any, Literal

import typer
from typer.core import TyperGroup

from apartgen import __version__, garbage
from apartgen.schemas import plugins
from apartgen.schemas.errors import ApartgenError
from apartgen.stages import registry
from apartgen_cli.console import fail, listen

WORDS = ("plan", "layout", "retrieve", "walkable", "populate", "export", "metrics", "view", "render", "qa", "check",
         "make", "dataset", "serve", "train", "assets", "bench", "schema")
"""The commands, in the order of use."""
INTERRUPTED, PIPE_CLOSED = 130, 141
MARKUP: Literal["markdown"] = "markdown"
_WIDTH = 100


class Lazily(TyperGroup):
    """A group that imports a command's module when that command is called."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if args and args[0] in WORDS:
            self.commands[args[0]] = _loaded(args[0], self.commands[args[0]].help)
        return super().resolve_command(ctx, args)


def _loaded(word: str, help: str | None) -> Any:
    module = importlib.import_module(f"apartgen_cli.{word}")
    alone = typer.Typer(add_completion=False, rich_markup_mode=MARKUP)
    for name, function in module.commands().items():
        alone.command(name)(function)
    command = typer.main.get_command(alone)
    command.name, command.help = word, help
    return command


def _shown(version: bool) -> None:
    if version:
        typer.echo("\nwith ".join([f"apartgen {__version__}", *plugins.installed()]))
        raise typer.Exit()


def _global(
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show errors only.")] = False,
    version: Annotated[bool, typer.Option(
        "--version", callback=_shown, is_eager=True, help="Show the version, and what packages add.")] = False,
) -> None:
    """From a sentence to a furnished, simulation-ready apartment.

    Every stage reads the JSON of the one before and writes its own: plan, layout, retrieve, walkable, populate; then
    export and metrics. `make` does all of it.
    """
    listen(quiet)


def application() -> Any:
    """The command group; help of every command is the first line of its module."""
    app = typer.Typer(cls=Lazily, no_args_is_help=True, rich_markup_mode=MARKUP, add_completion=True,
                      context_settings={"help_option_names": ["-h", "--help"], "max_content_width": _WIDTH})
    app.callback()(_global)
    helps = registry.members("apartgen_cli")
    for word in WORDS:
        app.command(word, help=helps[word])(_placeholder)
    return typer.main.get_command(app)


def _placeholder() -> None:
    raise AssertionError("a command is loaded before it is called")


def main() -> None:
    """Run the command line; never returns."""
    ended: list[int] = []

    def end(number: int, frame: Any) -> None:
        ended.append(number)
        raise KeyboardInterrupt  # what is half done is cleared away, as after Ctrl-C

    signal.signal(signal.SIGTERM, end)
    garbage.seldom()
    code = status(sys.argv[1:])
    garbage.no_more()
    sys.exit(128 + ended[0] if ended and code == INTERRUPTED else code)


def status(args: list[str]) -> int:
    """Run one command line and return its exit status."""
    listen(not {"-q", "--quiet"}.isdisjoint(args))  # what commands say while they are imported, too
    try:
        code = int(application()(args=args, prog_name="apartgen", standalone_mode=False) or 0)
        sys.stdout.flush()
    except ApartgenError as error:
        fail(str(error))
        return error.exit_code
    except (BrokenPipeError, SystemExit) as error:  # typer exits when a pipe is closed, and after a completion
        _forget_output()
        return 0 if isinstance(error, SystemExit) and not error.code else PIPE_CLOSED
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT, errno.EIO):
            raise
        fail(f"cannot write ({error.strerror}); make room, and run it again")
        _forget_output()
        return 2
    except Exception as error:
        return _usage(error)
    if code == INTERRUPTED:
        fail("interrupted; what was finished is kept")
    return code


def _forget_output() -> None:
    """Whoever read the output has gone, or it is full; leave nothing for the interpreter to flush."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _usage(error: Exception) -> int:
    """Status of a wrong command line, its fault shown; whatever else it is, is ours and goes on up."""
    message = getattr(error, "format_message", None)
    if message is None:
        raise error
    if text := message():
        context = getattr(error, "ctx", None)
        fail(f"{text} Try '{context.command_path if context else 'apartgen'} --help'.")
    return 2


if __name__ == "__main__":
    main()
