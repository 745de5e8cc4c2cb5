"""A folder is a registry: each public module in it is one interchangeable member, found by its name.

Other packages add members by entry points of the group `apartgen.` and the folder's name. Names are read from the file
system and help from the source text, so that listing a registry imports none of its members. A member is a module or a
package whose name does not begin with an underscore; it keeps the folder's contract, see `contract`.
"""

import ast
import difflib
import importlib
import importlib.util
import inspect
import logging
import pkgutil
import tokenize
from functools import cache
from pathlib import Path
from types import ModuleType

from apartgen.schemas import plugins
from apartgen.schemas.errors import ApartgenError, BadInput
from apartgen.schemas.plugins import Plugin
from apartgen.stages.registry import contract

log = logging.getLogger("apartgen")
_BLANK = (tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE)


def group(package: str) -> str:
    """The group of entry points by which other packages add members: `apartgen.export` of `apartgen.stages.export`."""
    return f"apartgen.{package.rpartition('.')[2]}"


@cache
def _folders(package: str) -> tuple[Path, ...]:
    spec = importlib.util.find_spec(package)
    if spec is None or spec.submodule_search_locations is None:
        raise ModuleNotFoundError(f"{package} is not a package")
    return tuple(Path(folder) for folder in spec.submodule_search_locations)


def _help(source: Path) -> str:
    text = ast.get_docstring(ast.parse(source.read_text(encoding="utf-8"), str(source))) or ""
    return text.partition("\n")[0]


def _own_help(source: Path) -> str:
    """As `_help`, read no further than the docstring, which our own modules begin with."""
    with tokenize.open(source) as lines:
        first = next(one for one in tokenize.generate_tokens(lines.readline) if one.type not in _BLANK)
    return inspect.cleandoc(ast.literal_eval(first.string)).partition("\n")[0] if first.type == tokenize.STRING else ""


def _own(package: str) -> dict[str, Path]:
    """The source of each of the folder's own members, by name."""
    return {
        module.name: folder / module.name / "__init__.py" if module.ispkg else folder / f"{module.name}.py"
        for folder in _folders(package)
        for module in pkgutil.iter_modules([str(folder)])
        if not module.name.startswith("_")
    }


@cache
def _brought(package: str) -> dict[str, tuple[Plugin, str]]:
    """Members of other packages with their help; what has no source, or a name that is taken, is left out."""
    if not package.startswith("apartgen.stages."):
        return {}
    found, taken = {}, _own(package)
    for name, plugin in plugins.brought(group(package)).items():
        place = plugin.place
        try:
            if name in taken:
                raise ValueError(f"there is a member {name!r} already")
            if place is None:
                raise ValueError("there is no such module")
            found[name] = plugin, _help(place)
        except (OSError, ValueError, SyntaxError) as error:
            log.warning("%s", plugin.told(f"{error}; left out"))
    return found


def members(package: str) -> dict[str, str]:
    """Each member's name and the first line of its docstring, by name; no member is imported."""
    helps = {name: _own_help(source) for name, source in _own(package).items()}
    helps |= {name: help for name, (_, help) in _brought(package).items()}
    return dict(sorted(helps.items()))


def bringer(package: str, name: str) -> Plugin | None:
    """Which other package brings a member; None for the folder's own."""
    return _brought(package)[name][0] if name in _brought(package) else None


def told(package: str, name: str, fault: str, kind: str = "") -> str:
    """A fault of a member in words that say whose it is: another package's, or the folder's own, a `kind` of thing."""
    plugin = bringer(package, name)
    return plugin.told(fault) if plugin else f"{kind or package.rpartition('.')[2]} {name}: {fault}"


def _source(package: str, name: str) -> Path:
    """Where a member is written; BadInput, naming the members there are, when there is none of that name."""
    plugin, own = bringer(package, name), _own(package)
    if plugin and plugin.place:
        return plugin.place
    if name in own:
        return own[name]
    names = list(members(package))
    close = difflib.get_close_matches(name, names, n=1)
    hint = f"did you mean {close[0]!r}? " if close else ""
    raise BadInput(f"no {package.rpartition('.')[2]} {name!r}; {hint}there are: {', '.join(names)}")


def stated(package: str, name: str, fact: str, usual: bool) -> bool:
    """A fact that a member's file gives as `FACT = False`, read from its text; `usual` where it says nothing.

    BadInput for one that is not written out.
    """
    for line in ast.parse(_source(package, name).read_bytes()).body:
        targets = line.targets if isinstance(line, ast.Assign) else [getattr(line, "target", None)]
        if isinstance(line, ast.Assign | ast.AnnAssign) and fact in [getattr(one, "id", "") for one in targets]:
            if not isinstance(value := getattr(line.value, "value", None), bool):
                given = ast.unparse(line.value) if line.value else "nothing"
                raise BadInput(told(package, name, f"{fact} = {given} is no bool; write it as True or False"))
            return value
    return usual


def load(package: str, name: str) -> ModuleType:
    """Import one member.

    BadInput, naming the members there are, when there is none of that name; and for one that is broken, or that does
    not keep the folder's contract.
    """
    _source(package, name)
    protocols = contract.protocols(package)
    if plugin := bringer(package, name):
        return _brought_in(plugin, protocols)
    member = importlib.import_module(f"{package}.{name}")
    if fault := contract.fault(member, protocols):
        needed = f"{fault}; docs/extending.md says what is needed ({member.__file__})"
        raise BadInput(f"{package.rpartition('.')[2]} {name!r} {needed}")
    return member


@cache
def _brought_in(plugin: Plugin, protocols: tuple[type, ...]) -> ModuleType:
    try:
        member = importlib.import_module(plugin.value)
    except ApartgenError as error:
        raise BadInput(plugin.told(str(error))) from error
    except contract.ANYTHING as error:  # whatever a stranger's module does when it is imported
        raise BadInput(plugin.told(f"cannot be imported, {contract.told(error)}")) from error
    if fault := contract.fault(member, protocols):
        raise BadInput(plugin.told(fault))
    return contract.guarded(member, protocols, plugin.told)


def sound(package: str) -> dict[str, ModuleType]:
    """Every member by name; broken ones of other packages are left out with a warning."""
    found = {}
    for name in sorted({*_own(package), *_brought(package)}):
        try:
            found[name] = load(package, name)
        except BadInput as error:
            if name not in _brought(package):
                raise
            log.warning("%s", error)
    return found
