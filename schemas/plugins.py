"""What other packages bring, found by their entry points without importing anything of theirs.

An entry point of a group `apartgen.…` names a module (`my_package.gltf2`), or a file of facts beside one
(`my_package:categories.toml`). Whatever is wrong with one is said in a warning that names its package.
"""

import importlib.util
import logging
import tomllib
from collections.abc import Iterator
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, NamedTuple

log = logging.getLogger("apartgen")


class Plugin(NamedTuple):
    """One entry point: its name, what it refers to, and the package that brings it."""

    name: str
    value: str
    package: str

    @property
    def place(self) -> Path | None:
        """The file of facts, or of the module's source; None where there is none."""
        module, _, file = self.value.partition(":")
        source = _source(module)
        return source.parent / file if source and file else source

    def told(self, fault: str) -> str:
        """The fault in words that say whose it is."""
        return f"{self.package}: {self.name} = {self.value!r}: {fault}; mend it or uninstall {self.package}"


@cache
def brought(group: str) -> dict[str, Plugin]:
    """The plugins of a group by name; of several of one name the first package's."""
    found: dict[str, Plugin] = {}
    for point in sorted(entry_points(group=group), key=lambda point: (point.name, _package(point))):
        plugin = Plugin(point.name, point.value.replace(" ", ""), _package(point))
        if found.setdefault(point.name, plugin) != plugin:
            log.warning("%s", plugin.told(f"the name is taken by {found[point.name].package} already; left out"))
    return found


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
            yield plugin, tomllib.loads(place.read_text(encoding="utf-8"))
        except (OSError, UnicodeError, tomllib.TOMLDecodeError) as error:
            log.warning("%s", plugin.told(f"{error}; left out"))
