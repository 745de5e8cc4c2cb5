"""Where compiled functions are kept: beside the source, in the user's cache, or where neither can be written, apart."""

import os
import stat
import tempfile
from pathlib import Path

VARIABLE = "NUMBA_CACHE_DIR"


def keep() -> None:
    """Name a folder for compiled functions where there is none that they could be kept in; without one, the compiler
    refuses to work.
    """
    if VARIABLE not in os.environ and not (_writable(Path(__file__).parent) or _made(_users())):
        os.environ[VARIABLE] = str(_apart())


def _users() -> Path:
    """The user's cache, as the compiler looks for it."""
    return Path(os.environ.get("XDG_CACHE_HOME", os.path.expanduser("~/.cache")))


def _made(folder: Path) -> bool:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return _writable(folder)


def _writable(folder: Path) -> bool:
    return os.access(folder, os.W_OK | os.X_OK)


def _apart() -> Path:
    """A folder of this user's alone, for what is in it is run: the same for later runs, if nobody else made it."""
    folder = Path(tempfile.gettempdir()) / f"apartgen-{os.getuid()}"
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.lstat()
    except OSError:
        return Path(tempfile.mkdtemp(prefix="apartgen-"))
    ours = stat.S_ISDIR(found.st_mode) and found.st_uid == os.getuid() and not found.st_mode & 0o077
    return folder if ours else Path(tempfile.mkdtemp(prefix="apartgen-"))
