"""Where a command reads and where it writes: files, folders, pipes."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from apartgen.schemas.artifact import BODIES, STREAM
from apartgen.schemas.errors import BadInput

Target = str | Path


def sources(inputs: Sequence[str] | None) -> list[str]:
    """What to read: the inputs given, else standard input when something is piped into it."""
    if inputs:
        return list(inputs)
    if sys.stdin is None or sys.stdin.isatty():
        raise BadInput("nothing to read; give a file, or pipe an artifact in")
    return [STREAM]


def targets(word: str, names: Sequence[str], out: str | None) -> list[Target]:
    """Where to write each result of the stage `word`; `names` are the inputs' names.

    A result keeps its input's name, with the word of its stage: plan.json → layout.json, flat-3.json → flat-3.json.
    """
    if out is None or out == STREAM:
        return _to_stream(names, out)
    if not is_folder(out):
        if len(names) > 1:
            raise BadInput(f"-o {out}: {len(names)} results need a folder; give -o {out}/")
        if any(_same_file(name, Path(out)) for name in names):
            raise BadInput(f"-o {out}: is the input and would be lost; give another file")
        return [Path(out)]
    places = [Path(out) / name for name in _distinct([_renamed(word, name) for name in names], names)]
    taken = {Path(name).resolve() for name in names if name != STREAM}
    for place in places:
        if place.resolve() in taken:
            raise BadInput(f"-o {out}: {place} is an input and would be lost; give another folder")
        made_folder(str(place.parent))
    return list(places)


def whole_set(option: str, paths: Sequence[str]) -> list[str]:
    """The files meant by an option that takes files and folders; of a folder, every .json file in it, by name."""
    names: list[str] = []
    for path in paths:
        found = sorted(str(file) for file in Path(path).glob("*.json")) if Path(path).is_dir() else [path]
        if not found:
            raise BadInput(f"{option} {path}: no .json file in it; give a folder of artifacts")
        names += found
    return names


def is_folder(out: str) -> bool:
    """Whether `-o` names a folder: one that exists, or a name that ends in a slash."""
    return out.endswith(("/", os.sep)) or Path(out).is_dir()


def made_folder(out: str) -> Path:
    """The folder, made if need be."""
    folder = Path(out)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInput(f"-o {out}: no such folder can be made ({error.strerror}); give another one") from None
    return folder


def _to_stream(names: Sequence[str], out: str | None) -> list[Target]:
    if len(names) > 1:
        raise BadInput(f"{len(names)} inputs need a folder for their results; give -o FOLDER/")
    not_to_terminal(out)
    return [STREAM]


def not_to_terminal(out: str | None) -> None:
    """BadInput where nobody said where to write, and JSON would go to a person's screen."""
    if out is None and sys.stdout.isatty():
        raise BadInput("nowhere to write; give -o FILE, or pipe the output on")


def _same_file(name: str, place: Path) -> bool:
    """Whether an input is the file to be written, be it by a pipe's name."""
    if name != STREAM:
        return place.resolve() == Path(name).resolve()
    try:
        return place.is_file() and os.path.samestat(os.fstat(sys.stdin.fileno()), place.stat())
    except (OSError, ValueError, AttributeError):
        return False


def _renamed(word: str, name: str) -> str:
    path = Path(name if name != STREAM else f"{word}.json")
    parts = path.name.removesuffix(".json").split(".")
    if parts[-1] in BODIES:
        parts[-1] = word
    return ".".join(parts) + ".json"


def _distinct(results: list[str], names: Sequence[str]) -> list[str]:
    """The results' names; where two are equal, all below the folders that tell their inputs apart."""
    if len(set(results)) == len(results):
        return results
    if STREAM in names:
        raise BadInput("standard input and a file would get the same name; give files only")
    parents = [Path(name).resolve().parent for name in names]
    common = Path(os.path.commonpath(parents))
    apart = [str(parent.relative_to(common) / result) for parent, result in zip(parents, results)]
    if double := [name for name, result in zip(names, apart) if apart.count(result) > 1]:
        raise BadInput(f"{double[0]} and {double[1]} would get the same name, {apart[names.index(double[0])]}; "
                       "give one of them")
    return apart
