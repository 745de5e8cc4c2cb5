"""Who may import what, how long things may get, and where chance and clocks may come in."""

import ast
import functools
from collections.abc import Iterator
from pathlib import Path

import networkx
from syntax import tree_of

ROOT = Path(__file__).parent.parent
ARROWS = ("schemas", "stages", "apartgen", "apartgen_cli")
"""Each may import itself and those before it."""
INSTALLED = {"schemas": "apartgen.schemas", "stages": "apartgen.stages"}
"""Folders that are installed under another name than their own."""
SHARED = ("aside", "compiling", "registry", "robot", "scene", "seeds", "space", "things", "use")
"""The floor below the stages, which every one of them may import."""
HEAVY = {
    "torch": ("stages/layout/", "stages/retrieve/shape/", "stages/metrics/_networks"),
    "litellm": ("stages/plan/llm/",),
    "pxr": ("stages/export/usd", "stages/export/_usd"),
    "ezdxf": ("stages/export/dxf", "stages/plan/imports/dxf"),
    "ifcopenshell": ("stages/export/ifc", "stages/plan/imports/ifc"),
    "mujoco": ("stages/export/mjcf", "stages/export/_mjcf", "stages/embodied/", "stages/metrics/_physics"),
}
"""Where a heavy package may be imported at all, at the top or inside a function."""
LONGEST_FILE, LONGEST_FUNCTION = 300, 60
TIMED = ("train.py", "study.py", "llm/model.py")
"""Training and studies time themselves for their records; a language model is waited for."""

FILES = sorted(file for part in ARROWS for file in (ROOT / part).rglob("*.py"))
RELATIVE = [str(file.relative_to(ROOT)) for file in FILES]


@functools.cache
def tree(file: str) -> ast.Module:
    return tree_of((ROOT / file).read_text(encoding="utf-8"))


def module(file: str) -> str:
    name = file.removesuffix(".py").replace("/", ".").removesuffix(".__init__")
    top, dot, rest = name.partition(".")
    return INSTALLED.get(top, top) + dot + rest


MODULES = {module(file): file for file in RELATIVE}


def imported(file: str, top: bool = False) -> Iterator[tuple[int, str]]:
    """Line and full name of everything a file imports; with `top`, only when the file itself is imported."""
    nodes = tree(file).body if top else ast.walk(tree(file))
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            assert node.level == 0, f"{file}:{node.lineno}: import by the full name, not relatively"
            yield node.lineno, node.module
            for alias in node.names:
                if (full := f"{node.module}.{alias.name}") in MODULES:
                    yield node.lineno, full


def folder(name: str) -> str:
    """The folder at the top level in which a module stands that is imported by this name."""
    parts = name.split(".")
    return parts[1] if ".".join(parts[:2]) in INSTALLED.values() else parts[0]


def faults(check, files=RELATIVE) -> str:
    """What `check(file)` has to say, a line each."""
    return "\n".join(fault for file in files for fault in check(file))


def against_the_arrows(file: str) -> Iterator[str]:
    own = ARROWS.index(file.split("/")[0])
    for line, name in imported(file):
        part = folder(name)
        if part in ARROWS and ARROWS.index(part) > own:
            yield f"{file}:{line} imports {name}: {' <- '.join(ARROWS)}"


def test_arrows_point_one_way():
    assert not faults(against_the_arrows)


def across_stages(file: str) -> Iterator[str]:
    for line, name in imported(file):
        parts = name.split(".")
        if folder(name) == "stages" and len(parts) > 2 and parts[2] not in (file.split("/")[1], *SHARED):
            yield f"{file}:{line} imports {name}: what two stages need stands on the floor below them"


def test_no_stage_imports_another():
    assert not faults(across_stages, [file for file in RELATIVE if file.startswith("stages/") and file.count("/") > 1])


def test_no_module_lies_loose_between_the_stages():
    assert not [file for file in RELATIVE if file.startswith("stages/") and file.count("/") == 1
                and not file.endswith("__init__.py")]


def out_of_place(file: str) -> Iterator[str]:
    for line, name in imported(file):
        package = name.split(".")[0]
        if package in HEAVY and not file.startswith(HEAVY[package]):
            yield f"{file}:{line} imports {package}; only {' and '.join(HEAVY[package])} may"


def test_heavy_packages_stay_where_they_belong():
    assert not faults(out_of_place)


def test_one_file_asks_language_models():
    asking = {file for file in RELATIVE for _, name in imported(file) if name.split(".")[0] == "litellm"}
    assert len(asking) <= 1


def test_there_is_no_import_cycle():
    graph = networkx.DiGraph((module(file), name) for file in RELATIVE for _, name in imported(file, top=True)
                             if name in MODULES and name != module(file))
    cycles = [" -> ".join(cycle) for cycle in networkx.simple_cycles(graph)]
    assert not cycles


def needed(file: str) -> Iterator[str]:
    """Modules that a file imports anywhere, a function included, but nothing for types only.

    The package that holds all counts wherever something is imported from it, one below it not for its modules.
    """
    typed = {line for node in ast.walk(tree(file)) if isinstance(node, ast.If) and dotted(node.test) == "TYPE_CHECKING"
             for line in range(node.lineno, (node.end_lineno or 0) + 1)}
    found = [(line, name) for line, name in imported(file) if line not in typed and name in MODULES]
    for line, name in found:
        if name == "apartgen" or not any(at == line and other.startswith(f"{name}.") for at, other in found):
            yield name


def test_no_module_needs_one_that_needs_it():
    graph = networkx.DiGraph((module(file), name) for file in RELATIVE for name in needed(file))
    assert [sorted(some) for some in networkx.strongly_connected_components(graph) if len(some) > 1] == []


def too_long(file: str) -> Iterator[str]:
    lines = (ROOT / file).read_text(encoding="utf-8").count("\n")
    if lines > LONGEST_FILE:
        yield f"{file} has {lines} lines; divide it by what it is about"
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            length = (node.end_lineno or node.lineno) - node.lineno + 1
            if length > LONGEST_FUNCTION:
                yield f"{file}:{node.lineno} {node.name} has {length} lines"


def test_files_and_functions_can_be_read_at_a_glance():
    assert not faults(too_long)


def test_every_module_says_what_it_is():
    assert not [file for file in RELATIVE if tree(file).body and not ast.get_docstring(tree(file))]


def dotted(node: ast.expr) -> str:
    return f"{dotted(node.value)}.{node.attr}" if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def by_chance(file: str) -> Iterator[str]:
    for line, name in imported(file):
        package = name.split(".")[0]
        if package in ("uuid", "random", "secrets") or (package == "time" and not file.endswith(TIMED)):
            yield f"{file}:{line} imports {package}; what is made hangs on its input and rng only"
    initial = {id(inner) for node in ast.walk(tree(file)) if isinstance(node, ast.Call)
               and dotted(node.func).endswith("Parameter") for inner in ast.walk(node)}
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.Call) and id(node) not in initial and _by_chance(node):
            yield f"{file}:{node.lineno} calls {dotted(node.func)}; randomness enters as rng"


def _by_chance(call: ast.Call) -> bool:
    name = dotted(call.func)
    if name.endswith("default_rng"):
        return not call.args
    if name.startswith(("np.random.", "numpy.random.")):
        return name.split(".")[2] not in ("Generator", "SeedSequence", "PCG64", "Philox")
    if name in ("torch.rand", "torch.randn", "torch.randint", "torch.randperm"):
        return all(keyword.arg != "generator" for keyword in call.keywords)
    return name.endswith(("datetime.now", "date.today", "os.urandom"))


def test_nothing_hangs_on_clock_or_global_chance():
    assert not faults(by_chance, [file for file in RELATIVE if not file.startswith(("apartgen/", "apartgen_cli/"))])
