"""What other packages bring, found by their entry points without importing anything of theirs.

An entry point of a group `apartgen.…` names a module (`my_package.gltf2`), or a file of facts beside one
(`my_package:categories.toml`). Whatever is wrong with one is said in a warning that names its package.
"""

import hashlib
import importlib.util
import logging
import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, NamedTuple

from apartgen.schemas.errors import near

log = logging.getLogger("apartgen")
PREFIX = "apartgen."
"""What the names of all groups begin with."""
KNOWN = ("categories", "choice", "datasets", "export", "furniture", "guidance", "imports", "kinds", "metrics",
         "retrieve", "rooms", "rules")
"""The groups that are looked into."""
_INIT = "__init__.py"


class Plugin(NamedTuple):
    """One entry point: its name, what it refers to, and the package that brings it."""

    name: str
    value: str
    package: str
    version: str = ""

    @property
    def place(self) -> Path | None:
        """The file of facts, or of the module's source; None where there is none."""
        module, _, file = self.value.partition(":")
        source = _source(module)
        return source.parent / file if source and file else source

    @property
    def top(self) -> Path | None:
        """The source of the whole package that it is in."""
        return _source(self.value.partition(":")[0].partition(".")[0])

    def told(self, fault: str) -> str:
        """The fault in words that say whose it is."""
        return f"{self.package}: {self.name} = {self.value!r}: {fault}; mend it or uninstall {self.package}"


@cache
def _points() -> dict[str, list[EntryPoint]]:
    """The entry points of every group of ours; looking for them takes longer than all else here."""
    every = entry_points()
    found = {group: list(every.select(group=group)) for group in sorted(every.groups) if group.startswith(PREFIX)}
    for group, points in found.items():
        if (name := group.removeprefix(PREFIX)) not in KNOWN:
            log.warning("%s: entry points %r: nothing is looked for there; after apartgen. %s",
                        _package(points[0]), group, near(name, KNOWN))
    return found


@cache
def brought(group: str) -> dict[str, Plugin]:
    """The plugins of a group by name; of several of one name the first package's."""
    found: dict[str, Plugin] = {}
    for point in sorted(_points().get(group, []), key=lambda point: (point.name, _package(point))):
        version = point.dist.version if point.dist is not None else ""
        plugin = Plugin(point.name, point.value.replace(" ", ""), _package(point), version)
        if found.setdefault(point.name, plugin) != plugin:
            log.warning("%s", plugin.told(f"the name is taken by {found[point.name].package} already; left out"))
    return found


def bringer(group: str, module: str) -> Plugin | None:
    """The plugin of a group by which a module comes: its own, else the first of the same package."""
    own = brought(group).values()
    return next((plugin for plugin in own if f"{module}.".startswith(f"{plugin.value}.")), None) or next(
        (plugin for plugin in own if plugin.value.partition(".")[0] == module.partition(".")[0]), None)


def _package(point: EntryPoint) -> str:
    return point.dist.name if point.dist is not None else point.module


def _source(module: str) -> Path | None:
    """The file a module would be imported from, of a folder without one where it would lie; nothing is imported."""
    top, *below = module.split(".")
    try:
        spec = importlib.util.find_spec(top)
    except (ImportError, ValueError):
        return None
    if spec is None:
        return None
    if not below:
        if spec.origin and spec.has_location:
            return Path(spec.origin)
        return next((Path(folder, "__init__.py") for folder in spec.submodule_search_locations or ()), None)
    for folder in spec.submodule_search_locations or ():
        stem = Path(folder, *below)
        for file in (stem.with_suffix(".py"), stem / "__init__.py"):
            if file.is_file():
                return file
    return None


def facts(group: str) -> Iterator[tuple[Plugin, dict[str, Any]]]:
    """The tables of facts that packages bring; one that cannot be read is left out with a warning."""
    for plugin in brought(group).values():
        place = plugin.place
        try:
            if place is None:
                raise OSError("there is no such module")
            if not place.is_file():
                raise OSError(f"there is no file {place.name} beside {place.parent.name}/{_INIT}")
            yield plugin, tomllib.loads(place.read_text(encoding="utf-8"))
        except (OSError, UnicodeError, tomllib.TOMLDecodeError) as error:
            log.warning("%s", plugin.told(f"{error}; left out"))


@cache
def digest(*groups: str) -> str:
    """Of all that packages bring to these groups: their versions, the files that are named, and the rest of their code
    but for what they bring to other groups alone; empty where they bring nothing.
    """
    used = [plugin for group in groups for plugin in brought(group).values()]
    named = {plugin.place for plugin in used}
    others = {plugin.place for group in _points() for plugin in brought(group).values()} - named
    found = hashlib.sha256(repr([tuple(plugin) for plugin in used]).encode())
    for root in sorted({place for place in (*named, *(plugin.top for plugin in used)) if place}):
        for file in _code(root):
            if others.isdisjoint((file, *(folder / _INIT for folder in file.parents if folder != root.parent))):
                found.update(f"\n{file.name}\n".encode() + file.read_bytes())
    return f"sha256:{found.hexdigest()}" if used else ""


def installed() -> list[str]:
    """Every package that brings anything, its version and the groups that it adds to, in words."""
    found: dict[str, list[str]] = {}
    for group in (PREFIX + name for name in KNOWN):
        for whole in sorted({f"{plugin.package} {plugin.version}" for plugin in brought(group).values()}):
            found.setdefault(whole, []).append(group.removeprefix(PREFIX))
    return [f"{whole}: {', '.join(groups)}" for whole, groups in sorted(found.items())]


def _code(root: Path) -> list[Path]:
    """The file of a module, or all of a package's that are code or facts."""
    if root.name != _INIT:
        return [root] if root.is_file() else []
    return sorted(file for file in root.parent.rglob("*") if file.suffix in (".py", ".toml") and file.is_file())
