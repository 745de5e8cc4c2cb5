"""A folder that appears whole or not at all, and replaces only what such a one held."""

import hashlib
import os
import shutil
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from apartgen.schemas.errors import BadInput

CONTENTS = "SHA256SUMS"
"""Lists an export's files (`sha256sum -c` reads it), and marks the folder as one that may be replaced."""
_OURS = {CONTENTS, "export.json", "views.json"}


@contextmanager
def replaced(out: Path) -> Iterator[Path]:
    """A new folder to fill; it takes the place of `out` when the block ends well, and leaves no trace otherwise.

    BadInput where `out` holds what is no export's, and where the disk refuses.
    """
    try:
        _check(out)
        with _beside(out.absolute()) as fresh:
            yield fresh
    except OSError as error:
        raise BadInput(f"{out}: cannot be written ({error.strerror or error}); give another folder with -o") from error


@contextmanager
def _beside(out: Path) -> Iterator[Path]:
    out.parent.mkdir(parents=True, exist_ok=True)
    work = out.with_name(f".{out.name}.part")
    _clear(work, out)
    try:
        work.mkdir(mode=0o700)
        fresh, old = work / "new", work / "old"
        fresh.mkdir()
        yield fresh
        try:
            if out.exists():
                os.rename(out, old)
            os.rename(fresh, out)
        except BaseException:  # an interrupt too must not cost the earlier export
            if old.exists() and not out.exists():
                os.rename(old, out)
            raise
    finally:
        shutil.rmtree(work, ignore_errors=True)


def listed(paths: Iterable[tuple[str, str]], by: str) -> str:
    """The text of `CONTENTS` for files (path, digest)."""
    lines = [f"{digest}  {path}\n" for path, digest in sorted(paths)]
    return f"# written by apartgen {by}, which replaces this folder\n" + "".join(lines)


def add(folder: Path, paths: Iterable[Path]) -> dict[str, str]:
    """List files that were put into a folder after it was written; their digests by name."""
    digests = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in paths}
    with (folder / CONTENTS).open("a", encoding="utf-8") as contents:
        contents.writelines(f"{digest}  {name}\n" for name, digest in digests.items())
    return digests


def _clear(work: Path, out: Path) -> None:
    """Take away what a killed run left; the earlier export that it was about to replace gets its place back."""
    if (work / "old").exists() and not out.exists():
        os.rename(work / "old", out)
    shutil.rmtree(work, ignore_errors=True)


def _check(out: Path) -> None:
    """BadInput unless `out` is free, empty, or holds an export and nothing else."""
    if out.is_symlink() or (out.exists() and not out.is_dir()):
        raise BadInput(f"{out}: is not a folder; give another with -o")
    found = {p.relative_to(out).as_posix() for p in out.rglob("*") if not p.is_dir()} if out.exists() else set()
    strange = sorted(found - _listed(out) - _OURS)
    if strange:
        more = f" and {len(strange) - 1} more" if len(strange) > 1 else ""
        raise BadInput(f"{out}: holds {strange[0]}{more}, which no export wrote; give another folder with -o")


def _listed(out: Path) -> set[str]:
    contents = out / CONTENTS
    if not contents.is_file():
        return set()
    lines = contents.read_text(encoding="utf-8").splitlines()
    return {line.split("  ", 1)[1] for line in lines if "  " in line and not line.startswith("#")}
