"""Copies of a data set in another place, such as an object store, that fsspec knows by its address."""

import json
import logging
from pathlib import Path
from typing import Any

from apartgen.dataset.store import ABOUT, HOMES
from apartgen.schemas.errors import BadInput, Unmet

log = logging.getLogger("apartgen")
GROWS = {"count", "parts"}
"""What of a data set's description changes in the course of time."""


class Place:
    """Where copies go: `s3://bucket/data`, `gs://…`, `file:///…`, as far as the package for it is installed."""

    def __init__(self, url: str) -> None:
        """BadInput for an address that nothing knows."""
        import fsspec

        try:
            self._system, root = fsspec.core.url_to_fs(url)
        except (ValueError, ImportError) as error:
            raise BadInput(f"--copy-to {url}: {error}") from None
        self._url, self._root = url, root.rstrip("/")

    def try_taking(self, folder: Path) -> None:
        """Copy what there is; where the place does not take it now, it may do so later."""
        try:
            self.take(folder)
        except Unmet as error:
            log.warning("%s", error)

    def take(self, folder: Path) -> list[str]:
        """Copy the files of a data set; names those that were copied. Shards of the same size are there already, for
        they only ever grow. Unmet where the place does not take them, BadInput where it has another data set.
        """
        try:
            self._refuse_another(folder)
            there = self._system.find(self._root, detail=True) if self._system.exists(self._root) else {}
            sizes = {str(name): found["size"] for name, found in there.items()}
            return [name for name in _names(folder) if self._put(folder, name, sizes)]
        except OSError as error:
            raise Unmet(f"{self._url}: cannot be written ({error.strerror or error}); what is made is in {folder}, and "
                        "the same command copies it") from None

    def _refuse_another(self, folder: Path) -> None:
        if self._system.exists(f"{self._root}/{ABOUT}"):
            theirs = self._system.cat_file(f"{self._root}/{ABOUT}")
            if _lasting(theirs) != _lasting((folder / ABOUT).read_bytes()):
                raise BadInput(f"--copy-to {self._url}: holds another data set; give another place")

    def _put(self, folder: Path, name: str, sizes: dict[str, int]) -> bool:
        target = f"{self._root}/{name}"
        if name.startswith(HOMES) and sizes.get(target) == (folder / name).stat().st_size:
            return False
        self._system.makedirs(target.rpartition("/")[0], exist_ok=True)
        self._system.put_file(str(folder / name), target)
        return True


def _lasting(about: bytes) -> dict[str, Any] | None:
    """A data set's description without what grows; None where there is none to be read."""
    try:
        return {name: value for name, value in json.loads(about).items() if name not in GROWS}
    except (ValueError, AttributeError):
        return None


def _names(folder: Path) -> list[str]:
    """Of whole files, homes before the manifest that tells of them."""
    found = [file.relative_to(folder) for file in sorted(folder.rglob("*")) if file.is_file()]
    kept = [path.as_posix() for path in found if not any(part.startswith(".") for part in path.parts)]
    return sorted(kept, key=lambda name: not name.startswith(HOMES))
