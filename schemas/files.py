"""Files that appear whole or not at all, and of which a killed run leaves nothing behind."""

import contextlib
import hashlib
import os
import tempfile
from pathlib import Path

_LONGEST = 255
"""Bytes of a file's name."""


def replace(data: bytes, target: Path) -> None:
    """Put bytes in the place of a file; a pipe or a device is written to. OSError where that cannot be."""
    target = target.resolve()
    if target.exists() and not target.is_file():
        with open(target, "wb") as device:
            device.write(data)
        return
    mode = target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_mask()
    folder = os.open(target.parent, os.O_RDONLY)
    try:
        if not _without_name(data, target, mode, folder):
            _by_name(data, target, mode)
    finally:
        os.close(folder)


def _mask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _fill(handle: int, data: bytes, mode: int) -> None:
    view = memoryview(data)
    while view:
        view = view[os.write(handle, view):]
    os.fchmod(handle, mode)
    os.fsync(handle)


def _without_name(data: bytes, target: Path, mode: int, folder: int) -> bool:
    """Fill a file that has no name until it is whole; False where the system or the disk has no such files.

    On its way it has one name, which the next run would use again.
    """
    try:
        handle = os.open(target.parent, os.O_TMPFILE | os.O_WRONLY)
    except (AttributeError, OSError):
        return False
    with os.fdopen(handle, "wb", buffering=0) as file:
        _fill(file.fileno(), data, mode)
        part = part_of(target)
        with contextlib.suppress(FileNotFoundError):
            os.unlink(part)
        try:
            os.link(f"/proc/self/fd/{file.fileno()}", part, src_dir_fd=folder, follow_symlinks=True)
        except OSError:
            return False
    os.replace(part, target)
    return True


def _by_name(data: bytes, target: Path, mode: int) -> None:
    handle, part = tempfile.mkstemp(dir=target.parent, prefix=".")
    try:
        with os.fdopen(handle, "wb") as file:
            _fill(file.fileno(), data, mode)
        os.replace(part, target)
    except BaseException:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(part)
        raise


def part_of(target: Path) -> Path:
    """The name of a file on its way to `target`."""
    name = f".{target.name}.part"
    if len(os.fsencode(name)) > _LONGEST:
        name = f".{hashlib.sha256(os.fsencode(target.name)).hexdigest()}.part"
    return target.with_name(name)
