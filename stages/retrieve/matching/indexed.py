"""A library a user owns, as `apartgen assets index` left it: one table file and one file per asset."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, ValidationError
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from apartgen.schemas.artifact import first_fault
from apartgen.schemas.base import Record
from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.matching import store
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.table import Table
from apartgen.stages.retrieve.matching.textures import FOLDER
from apartgen.stages.things.asset import Asset

TABLE_FILE = "library.safetensors"
VERSION = 1
LATENT = 32
"""Numbers of a shape."""


class Entry(NamedTuple):
    """What a table holds of an asset."""

    id: str
    category: str
    style: str
    moving: int
    credit: str
    size: tuple[float, float, float]


def asset_file(folder: Path, row: int) -> Path:
    """Where the asset of a row lies."""
    return folder / "assets" / f"{row:06d}.safetensors"


class IndexedLibrary:
    """Assets of one folder."""

    def __init__(self, folder: Path, config: RetrieveConfig | None = None) -> None:
        """BadInput when the folder holds no readable index."""
        self.folder = folder
        self.config = config or RetrieveConfig()
        header, size, latent = _read(folder / TABLE_FILE)
        self.name, self.kind = header.name, header.kind
        self.entries = [Entry(*row, (d, w, h)) for row, (d, w, h) in zip(header.assets, size.tolist(), strict=True)]
        self._row = {entry.id: i for i, entry in enumerate(self.entries)}
        self._table = Table([e.category for e in self.entries], size, latent, [e.moving > 0 for e in self.entries])

    def nearest(
        self, category: str, size: ArrayLike, latent: ArrayLike, limit: ArrayLike | None = None
    ) -> tuple[int, float] | None:
        """Row and cost of the best asset that fits."""
        return self._table.nearest(category, size, latent, limit, self.config)

    def at(self, row: int) -> Asset:
        """The asset of a row."""
        entry = self.entries[row]
        return store.read(asset_file(self.folder, row), self.folder.resolve() / FOLDER).named(self.name, entry.id)

    def load_asset(self, id: str) -> Asset:
        """The asset of that id; BadInput when there is none."""
        if id not in self._row:
            raise BadInput(f"library {self.name!r} ({self.folder}) has no asset {id!r}; see `apartgen assets list`")
        return self.at(self._row[id])


class Header(Record):
    """What a table says of its library: rows of assets are id, category, style, moving parts, credit."""

    version: int
    name: str
    kind: str = Field(alias="as")
    assets: list[tuple[str, str, str, int, str]]


def _read(path: Path) -> tuple[Header, np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    if not path.exists():
        raise BadInput(f"{path.parent}: no indexed library; make one with `apartgen assets index DIR -o {path.parent}`")
    try:
        with safe_open(path, framework="np") as file:
            raw = json.loads(file.metadata()["apartgen"])
            _check_version(raw, path)
            header = Header.model_validate_json(json.dumps(raw), strict=True)
            size, latent = file.get_tensor("size"), file.get_tensor("latent")
            _check_tables(len(header.assets), size, latent)
    except (SafetensorError, KeyError, ValueError, TypeError, RecursionError) as error:
        told = first_fault(error) if isinstance(error, ValidationError) else error
        raise BadInput(f"{path}: not a readable library index ({told}); index it again") from None
    return header, size, latent


def _check_version(raw: Any, path: Path) -> None:
    version = raw.get("version") if isinstance(raw, dict) else None
    if isinstance(version, int) and version > VERSION:
        raise BadInput(f"{path}: index version {version}, this program reads {VERSION}; upgrade apartgen")


def _check_tables(count: int, size: np.ndarray[Any, Any], latent: np.ndarray[Any, Any]) -> None:
    """ValueError for tables of other shapes than the assets have, or with numbers that are none."""
    for name, table, width in (("size", size, 3), ("latent", latent, LATENT)):
        if table.shape != (count, width) or table.dtype != np.float32 or not np.isfinite(table).all():
            raise ValueError(f"{name} is not {count} rows of {width} finite numbers")
    if not (size > 0).all():
        raise ValueError("a size is not above zero")


def write(folder: Path, name: str, kind: str, entries: Sequence[Entry], latent: ArrayLike) -> None:
    """Writes a library's table."""
    header = {"version": VERSION, "name": name, "as": kind, "assets": [entry[:5] for entry in entries]}
    tensors = {
        "size": np.asarray([entry.size for entry in entries], np.float32).reshape(-1, 3),
        "latent": np.asarray(latent, np.float32).reshape(-1, LATENT),
    }
    folder.mkdir(parents=True, exist_ok=True)
    save_file(tensors, folder / TABLE_FILE, metadata={"apartgen": json.dumps(header, sort_keys=True)})
