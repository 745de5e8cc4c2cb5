"""A folder is a registry: each public module in it is one interchangeable member, found by its name.

Names are read from the file system and help from the source text, so that listing a registry imports none of its
members. A member is a module or a package whose name does not begin with an underscore.
"""

import ast
import difflib
import importlib
import importlib.util
import pkgutil
from functools import cache
from pathlib import Path
from types import ModuleType

from apartgen.schemas.errors import BadInput


@cache
def _folders(package: str) -> tuple[Path, ...]:
    spec = importlib.util.find_spec(package)
    if spec is None or spec.submodule_search_locations is None:
        raise ModuleNotFoundError(f"{package} is not a package")
    return tuple(Path(folder) for folder in spec.submodule_search_locations)


def _help(folder: Path, name: str) -> str:
    file = folder / f"{name}.py"
    source = file if file.exists() else folder / name / "__init__.py"
    text = ast.get_docstring(ast.parse(source.read_text(encoding="utf-8"))) or ""
    return text.partition("\n")[0]


def members(package: str) -> dict[str, str]:
    """Each member's name and the first line of its docstring, by name; no member is imported."""
    found = {
        module.name: folder
        for folder in _folders(package)
        for module in pkgutil.iter_modules([str(folder)])
        if not module.name.startswith("_")
    }
    return {name: _help(found[name], name) for name in sorted(found)}


def load(package: str, name: str) -> ModuleType:
    """Import one member; BadInput, naming the members there are, when there is none of that name."""
    names = list(members(package))
    if name not in names:
        close = difflib.get_close_matches(name, names, n=1)
        hint = f"did you mean {close[0]!r}? " if close else ""
        raise BadInput(f"no {package.rpartition('.')[2]} {name!r}; {hint}there are: {', '.join(names)}")
    return importlib.import_module(f"{package}.{name}")
