"""What a file may ask for before it is refused: sizes are checked before anything is read or unpacked."""

import contextlib
import io
import json
import struct
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path, PurePosixPath
from typing import IO, Any
from xml.parsers import expat

from apartgen.schemas.errors import BadInput

FILE_BYTES = 256 * 2**20
TEXT_BYTES = 64 * 2**20
ARCHIVE_BYTES = 2 * 2**30
"""All members of an archive together, unpacked."""
MEMBERS = 20_000
RATIO = 200
"""No honest model compresses better than this."""
DIRECTORY_BYTES = 8 * 2**20
"""Of an archive's list of members."""
VALUES = 4_000_000
"""Values in a JSON file."""
ELEMENTS = 500_000
"""Elements in an XML file."""
NEST = 256
"""Elements in one another in an XML file."""
FACES = 2_000_000
VERTICES = 4_000_000


class Broken(BadInput):
    """One asset can't be used; the message is the reason alone, whoever reports it knows the asset."""


def inside(root: Path, path: Path) -> Path:
    """The path resolved; Broken when it leads out of `root`."""
    real = path.resolve()
    if not real.is_relative_to(root.resolve()):
        raise Broken(f"refers to {path.name!r} outside its library")
    return real


def read(path: Path, most: int = FILE_BYTES) -> bytes:
    """A file's bytes; Broken when it is missing, no file, or larger than `most`."""
    try:
        size = path.stat().st_size
        if not path.is_file():
            raise Broken(f"{path.name} is no file")
        if size > most:
            raise Broken(f"{path.name} holds {size / 2**20:.0f} MB, more than the {most / 2**20:.0f} MB accepted")
        return path.read_bytes()
    except OSError as error:
        raise Broken(f"{path.name}: {error.strerror or error}") from None


def text(path: Path) -> str:
    """A text file."""
    return read(path, TEXT_BYTES).decode("utf-8", errors="replace")


def values(data: bytes) -> Any:
    """What JSON text holds; Broken where it would fill memory, ValueError where it is none."""
    if sum(data.count(sign) for sign in (b",", b"[", b"{")) > VALUES:
        raise Broken(f"more than the {VALUES} values of JSON accepted")
    return json.loads(data)


def parsed(path: Path) -> Any:
    """A JSON file."""
    try:
        return values(read(path, TEXT_BYTES))
    except (ValueError, RecursionError) as error:
        raise Broken(f"{path.name} is not JSON ({error})") from None


def xml(data: bytes, name: str) -> ElementTree.Element:
    """The root of an XML document; Broken for anything with entities or a document type, which bombs need."""

    def refuse(*_: object) -> None:
        raise Broken(f"{name} declares a document type or entities, which models have no use for")

    if data.count(b"<") > 2 * ELEMENTS:
        raise Broken(f"{name} has more than the {ELEMENTS} elements accepted")
    depth = 0

    def enter(*_: object) -> None:
        nonlocal depth
        depth += 1
        if depth > NEST:
            raise Broken(f"{name} has more than {NEST} elements in one another")

    def leave(*_: object) -> None:
        nonlocal depth
        depth -= 1

    guard = expat.ParserCreate()
    guard.StartDoctypeDeclHandler = guard.EntityDeclHandler = refuse
    guard.StartElementHandler, guard.EndElementHandler = enter, leave
    try:
        guard.Parse(data, True)
        return ElementTree.fromstring(data)
    except (expat.ExpatError, ElementTree.ParseError, ValueError) as error:
        raise Broken(f"{name} is not well-formed XML ({error})") from None


def floats(words: str | None, count: int, default: str, name: str) -> list[float]:
    """`count` finite numbers of an attribute."""
    try:
        values = [float(word) for word in (words or default).replace(",", " ").split()]
    except ValueError:
        raise Broken(f"{name}: {words!r} are not numbers") from None
    if len(values) != count or not all(abs(v) < 1e9 for v in values):
        raise Broken(f"{name}: {words!r} are not {count} finite numbers")
    return values


class Archive:
    """A zip file whose members are checked before they are unpacked, one at a time, in memory."""

    def __init__(self, file: Path | IO[bytes], name: str = "") -> None:
        name = name or (file.name if isinstance(file, Path) else "")
        try:
            _listed(file, name)
            self._file = zipfile.ZipFile(file)
        except (OSError, zipfile.BadZipFile, struct.error) as error:
            raise Broken(f"{name} is not a readable archive ({error})") from None
        infos = self._file.infolist()
        if len(infos) > MEMBERS:
            raise Broken(f"{name} has {len(infos)} members, more than the {MEMBERS} accepted")
        if sum(info.file_size for info in infos) > ARCHIVE_BYTES:
            raise Broken(f"{name} unpacks to more than the {ARCHIVE_BYTES / 2**30:.0f} GB accepted")
        self._members = {_plain(info.filename): info for info in infos if not info.is_dir()}

    def __contains__(self, name: str) -> bool:
        return name in self._members

    @property
    def names(self) -> list[str]:
        """Members' paths in order."""
        return sorted(self._members)

    def read(self, name: str, most: int = FILE_BYTES) -> bytes:
        """A member's bytes; stops as soon as it outgrows what its header says or `most`."""
        info = self._members.get(name)
        if info is None:
            raise Broken(f"the archive has no {name!r}")
        if info.file_size > most or info.file_size > RATIO * max(info.compress_size, 1024):
            raise Broken(f"{name!r} unpacks from {info.compress_size} to {info.file_size} bytes; refused")
        try:
            with self._file.open(info) as stream:
                data = stream.read(info.file_size + 1)
        except (zipfile.BadZipFile, OSError, RuntimeError, NotImplementedError, EOFError) as error:
            raise Broken(f"{name!r} can't be unpacked ({error})") from None
        if len(data) > info.file_size:
            raise Broken(f"{name!r} is larger than its header says")
        return data


def _listed(file: Path | IO[bytes], name: str) -> None:
    """Broken when an archive's list of members is so long that reading it would fill memory."""
    with file.open("rb") if isinstance(file, Path) else contextlib.nullcontext(file) as stream:
        end = stream.seek(0, io.SEEK_END)
        # The end record, 22 bytes and a comment, names the list's length.
        stream.seek(max(0, end - 22 - 2**16))
        tail = stream.read()
        at = tail.rfind(b"PK\5\6")
        if at < 0:
            raise zipfile.BadZipFile("no list of members")
        if tail[max(0, at - 20) : at].startswith(b"PK\6\7"):
            raise Broken(f"{name} is a zip64 archive, which no library of models needs; pack it as plain zip")
        length = struct.unpack_from("<I", tail, at + 12)[0]
        stream.seek(0)
    if length > DIRECTORY_BYTES:
        raise Broken(f"{name} lists its members in {length} bytes, more than the {DIRECTORY_BYTES} accepted")


def _plain(name: str) -> str:
    path = PurePosixPath(name.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or ":" in path.parts[0]:
        raise Broken(f"an archive member leads out of the archive: {name!r}")
    return str(path)
