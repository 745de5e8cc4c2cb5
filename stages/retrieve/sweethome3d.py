"""Sweet Home 3D furniture libraries (`.sh3f`): real dimensions, licence and author per model."""

import io
import re
import zipfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path, PurePosixPath

import numpy as np

from apartgen.stages.retrieve.reading import gltf, images, limits, obj
from apartgen.stages.retrieve.reading.limits import Archive, Broken, floats
from apartgen.stages.retrieve.reading.model import Y_UP, Model, Part, asset
from apartgen.stages.retrieve.reading.pieces import Array, Piece
from apartgen.stages.retrieve.reading.source import Source, files
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.words import category

CATALOGUE = "PluginFurnitureCatalog.properties"
ENTRY = re.compile(r"^(\w+)#(\d+)$")


def assets(root: Path) -> Iterator[Source]:
    """Every model of every `.sh3f` below `root`, or of `root` itself when it is one."""
    for path in [root] if root.is_file() else files(root, (".sh3f",)):
        try:
            archive = Archive(path)
            told = properties(archive.read(CATALOGUE, limits.TEXT_BYTES))
        except Broken as error:
            yield Source(path.stem, partial(_refuse, error))
            continue
        shared = {key: value for key, value in told.items() if "#" not in key}
        for entry in _entries(told).values():
            id = entry.get("id") or entry.get("name") or "unnamed"
            yield Source(f"{path.stem}/{id}", partial(_load, archive, path.stem, entry, shared))


def _refuse(error: Broken) -> Asset:
    raise error


def properties(data: bytes) -> dict[str, str]:
    """A Java properties file: Latin-1, `\\uXXXX`, lines continued by a backslash, `=`, `:` or a space between."""
    found: dict[str, str] = {}
    # A line goes on when it ends in an odd number of backslashes.
    text = re.sub(r"(?<!\\)((?:\\\\)*)\\(?:\r\n|\r|\n)[ \t\f]*", r"\1", data.decode("latin-1"))
    for line in text.splitlines():
        line = line.lstrip()
        if not line or line[0] in "#!":
            continue
        split = re.match(r"((?:\\.|[^\\=:\s])+)\s*[=:]?\s*(.*)", line)
        if split:
            found[_plain(split[1])] = _plain(split[2])
    return found


def _plain(text: str) -> str:
    short = {"t": "\t", "n": "\n", "r": "\r", "f": "\f"}
    return re.sub(r"\\(?:u([0-9A-Fa-f]{4})|(.))", lambda m: chr(int(m[1], 16)) if m[1] else short.get(m[2], m[2]), text)


def _entries(told: dict[str, str]) -> dict[int, dict[str, str]]:
    entries: dict[int, dict[str, str]] = {}
    for key, value in told.items():
        match = ENTRY.match(key)
        if match:
            entries.setdefault(int(match[2]), {})[match[1]] = value
    return dict(sorted(entries.items()))


def _load(archive: Archive, library: str, entry: dict[str, str], shared: dict[str, str]) -> Asset:
    name, model = entry.get("name", "unnamed"), entry.get("model", "").lstrip("/")
    if not model:
        raise Broken("names no model")
    pieces = _pieces(archive, model, entry.get("multiPartModel", "false") == "true")
    wanted = np.array([floats(entry.get(key), 1, "", key)[0] for key in ("depth", "width", "height")]) / 100
    if (wanted <= 0).any():
        raise Broken(f"dimensions of {(wanted * 100).tolist()} cm")
    pieces = [_sized(p, matrix) for matrix in [_to_size(pieces, wanted, entry.get("modelRotation"))] for p in pieces]
    license_, author = (
        entry.get("license") or shared.get("license", ""),
        entry.get("creator") or shared.get("provider", ""),
    )
    credit = " · ".join(
        part for part in (name, author, license_ or "licence not stated", f"Sweet Home 3D library {library}") if part
    )
    id = f"{library}/{entry.get('id') or name}"
    return asset(
        Model(
            id, category(name), [Part("base", pieces)], style=entry.get("category", ""), credit=credit, turn=np.eye(3)
        ),
        "",
    )


def _to_size(pieces: list[Piece], wanted: Array, rotation: str | None) -> Array:
    """4 × 4 from the model's frame (y up, front +z) to metres of this project's, stretched to the catalogue's size."""
    turn = np.asarray(floats(rotation, 9, "1 0 0 0 1 0 0 0 1", "modelRotation")).reshape(3, 3)
    matrix = np.eye(4)
    matrix[:3, :3] = Y_UP @ turn
    used = [p.vertices[np.unique(p.faces)] for p in pieces if len(p.faces)]
    if not used:
        raise Broken("has no faces")
    points = np.concatenate(used) @ matrix[:3, :3].T
    if not np.isfinite(points).all():
        raise Broken("vertices that are not finite numbers")
    scale = wanted / np.maximum(np.ptp(points, axis=0), 1e-6)
    matrix[:3, :3] = scale[:, None] * matrix[:3, :3]
    return matrix


def _sized(piece: Piece, matrix: Array) -> Piece:
    return piece.moved(matrix)


def _pieces(archive: Archive, model: str, packed: bool) -> list[Piece]:
    """A model is a mesh in the archive, or a zip of one with its materials and images."""
    data = archive.read(model)
    folder = PurePosixPath(model).parent
    beside: Callable[[str], bytes | None] = lambda name: _maybe(archive, str(folder / name))  # noqa: E731
    if model.lower().endswith(".zip") or (packed and data[:2] == b"PK"):
        inner = _inner(data, model)
        model = next((n for n in inner.names if n.lower().endswith((".obj", ".glb", ".gltf"))), "")
        if not model:
            raise Broken("its archive holds no OBJ or glTF model")
        data, folder = inner.read(model), PurePosixPath(model).parent
        beside = lambda name: _maybe(inner, str(folder / name))  # noqa: E731
    if model.lower().endswith(".obj"):
        return obj.parse(data, model, beside, lambda name: _address(beside(name)))
    if model.lower().endswith((".glb", ".gltf")):
        return [p for root in gltf.parse(data, model, beside) for p in root.all()]
    raise Broken(f"{model}: only OBJ and glTF models are understood; convert it in Sweet Home 3D")


def _inner(data: bytes, name: str) -> Archive:
    if not zipfile.is_zipfile(io.BytesIO(data)):
        raise Broken(f"{name} is not a readable archive")
    return Archive(io.BytesIO(data), name)


def _address(image: bytes | None) -> str | None:
    return None if image is None else images.address(image)


def _maybe(archive: Archive, name: str) -> bytes | None:
    return archive.read(name) if name in archive else None
