"""Which tests run which lines: the suite under coverage once a commit, file by file, so that it may be interrupted.

Only files that are going to be changed are watched: what is not watched costs next to nothing.
"""

import ast
import functools
import hashlib
import json
import shutil
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import coverage
from mutants import running
from mutants.changes import Change, sources

PARTS = ("apartgen", "schemas", "stages")
ELSEWHERE = ("test_house.py", "test_docs.py", "test_acceptance.py")
"""About the text of the code, or slow."""
LONGEST = 3600
"""Of one file of tests, s; what takes longer is left out."""


def clone(root: Path, to: Path, commit: str) -> Path:
    """The commit in a folder of its own, where its modules have their installed names."""
    if not to.exists():
        to.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["git", "clone", "--quiet", str(root), str(to)], check=True)
        subprocess.run(["git", "checkout", "--quiet", commit], cwd=to, check=True)
        for name in ("schemas", "stages"):
            (to / "apartgen" / name).symlink_to(Path("..") / name)
    subprocess.run(["git", "checkout", "--quiet", "--", "."], cwd=to, check=True)  # what an interrupted run left
    return to


def kernels(root: Path, work: Path, to: Path) -> Path:
    """What is compiled in the checkout, as if it were the clone's: it is read only where the source is the same."""
    for folder in (root / "stages").rglob("__pycache__"):
        kept = to / place_of_kernels(work, str(folder.parent.relative_to(root)))
        for file in folder.glob("*.nb[ic]"):
            kept.mkdir(parents=True, exist_ok=True)
            if not (kept / file.name).exists():
                shutil.copy(file, kept)
    return to


def place_of_kernels(work: Path, folder: str) -> str:
    """What numba calls the place of kernels of a folder of the clone."""
    path = work / "apartgen" / folder
    return f"{path.name}_{hashlib.sha1(str(path).encode()).hexdigest()}"


def measure(work: Path, to: Path, cache: Path, only: Sequence[str], below: Sequence[str] = ("",),
            workers: int = 1) -> None:
    """Runs each file of tests that was not run yet, of those whose names so begin, so many at a time.

    It leaves `<name>.cover` and `<name>.json` in `to`.
    """
    to.mkdir(parents=True, exist_ok=True)
    names = (str(test.relative_to(work / "tests")) for test in sorted((work / "tests").rglob("test_*.py")))
    wanted = [name for name in names if name not in ELSEWHERE and name.startswith(tuple(below))]
    left = [name for name in wanted if not _cost(to, name).exists()]
    one = functools.partial(_measured, work, to, cache, only)
    for name, tests in running.abreast(workers, one, left):
        print(f"{name}: {tests} tests", flush=True)


def _cost(to: Path, name: str) -> Path:
    return to / (name.replace("/", ".") + ".json")


def _measured(work: Path, to: Path, cache: Path, only: Sequence[str], name: str) -> tuple[str, int]:
    """A file of tests and how many it has."""
    cost = _cost(to, name)
    unfinished, said = cost.with_suffix(".unfinished"), cost.with_suffix(".txt")
    words, cover = [*running.ASKED, f"tests/{name}"], cost.with_suffix(".cover")
    status = running.run(work, cache, words, said, LONGEST, cover, only, {"MUTANTS_COST": str(unfinished)})
    if status < 0:
        unfinished.write_text("{}")
    elif not unfinished.exists():
        raise RuntimeError(f"{name}: {said.read_text()[-2000:]}")
    unfinished.rename(cost)
    return name, len(json.loads(cost.read_text()))


class Seen:
    """What `measure` left of a clone's tests."""

    def __init__(self, work: Path, folder: Path) -> None:
        self.work = work
        costs = {path: json.loads(path.read_text()) for path in sorted(folder.glob("*.json"))}
        self.cost: dict[str, float] = {test: cost for some in costs.values() for test, cost in some.items()}
        self.data = [self._read(path.with_suffix(".cover")) for path in costs if path.with_suffix(".cover").exists()]

    def _read(self, path: Path) -> coverage.CoverageData:
        data = coverage.CoverageData(str(path))
        data.read()
        return data

    @functools.cached_property
    def _trees(self) -> dict[str, ast.Module]:
        return {file: ast.parse((self.work / file).read_bytes()) for file in sources(self.work, PARTS)}

    @functools.cached_property
    def _files(self) -> dict[str, list[str]]:
        files: dict[str, list[str]] = {}
        for test in self.cost:
            files.setdefault(test.partition("::")[0], []).append(test)
        return files

    @functools.lru_cache(maxsize=4096)  # noqa: B019
    def _by_line(self, file: str) -> dict[int, set[str]]:
        """Tests by the line that they run; a file of tests stands for all in it."""
        lines: dict[int, set[str]] = {}
        for data in self.data:
            for line, tests in data.contexts_by_lineno(str(self.work / file)).items():
                lines.setdefault(line, set()).update(tests)
        return lines

    def tests(self, change: Change) -> tuple[set[str], set[str]]:
        """Tests that run a change, and others of the same files, which may have what these made.

        What is compiled or read when a module is imported is run by those that run what mentions it.
        """
        lines = range(change.first, change.last + 1)
        direct = self._running((change.file, line) for line in lines)
        imported = not direct and any(self._by_line(change.file).get(line) for line in lines)
        if change.compiled or not change.function or imported:
            names = set() if change.compiled else _named(self._trees[change.file], change)
            direct = self._running(self._mentions(change.file, names))
            direct = direct or self._running(self._mentions(change.file, set()))
        files = {test.partition("::")[0] for test in direct}
        return direct, {test for file in files for test in self._files[file]} - direct

    def imports(self, change: Change) -> bool:
        """Whether a change is run when its module is imported."""
        return any("" in self._by_line(change.file).get(line, ()) for line in range(change.first, change.last + 1))

    def telling(self, change: Change) -> set[str]:
        """Files to watch, so that one may tell who runs a change: what is compiled or imported tells by its callers."""
        if change.function and not change.compiled:
            return {change.file}
        names = set() if change.compiled else _named(self._trees[change.file], change)
        return {change.file, *(file for file, _ in self._mentions(change.file, names))}

    def compiled_with(self, file: str) -> Iterator[str]:
        """Files with compiled functions that import a file, or what imports it."""
        found, open_ = {file}, [file]
        while open_:
            name = module(open_.pop())
            more = {other for other, tree in self._trees.items() if other not in found
                    and any(_imported(tree, name, set()))}
            found |= more
            open_ += sorted(more)
        return (other for other in sorted(found) if compiles((self.work / other).read_bytes()))

    def _running(self, lines: Iterable[tuple[str, int]]) -> set[str]:
        """Tests that run any of some lines of files."""
        found = {test for file, line in lines for test in self._by_line(file).get(line, ())}
        return {test for name in found for test in self._files.get(name, [name])} & self.cost.keys()

    def _mentions(self, file: str, names: set[str], before: frozenset[str] = frozenset()) -> Iterator[tuple[str, int]]:
        """Lines in functions that mention some names of a file (all without), in it or where it is imported."""
        name = module(file)
        yield from ((file, line) for line in _lines(self._trees[file], names))
        for other, tree in self._trees.items():
            known = set(_imported(tree, name, names))
            if known and other not in before | {file}:
                yield from ((other, line) for line in _lines(tree, known))
                if "compiling" in ast.dump(tree) or "kernels" in other:
                    yield from self._mentions(other, set(), before | {file})


def compiles(source: bytes) -> bool:
    """Whether a file has compiled functions."""
    return b"stages.compiling import" in source or b"import inner" in source or b"    inner,\n" in source


def module(file: str) -> str:
    """The name under which a file is imported."""
    name = file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
    return name if name.startswith("apartgen") else f"apartgen.{name}"


def _named(tree: ast.Module, change: Change) -> set[str]:
    """What the statement of a change gives a name at the top of its file."""
    if change.function:
        return {change.function.partition(".")[0]}
    (statement,) = (node for node in tree.body if node.lineno <= change.line <= (node.end_lineno or 0))
    names = _targets(statement)
    for node in tree.body:  # and what else is made of that
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None and names & _names(node.value):
            names |= _targets(node)
    return names


def _targets(node: ast.stmt) -> set[str]:
    return _names(*(target for target in getattr(node, "targets", [getattr(node, "target", None)]) if target))


def _names(*nodes: ast.AST) -> set[str]:
    return {inner.id for node in nodes for inner in ast.walk(node) if isinstance(inner, ast.Name)}


def _imported(tree: ast.Module, module: str, names: set[str]) -> Iterator[str]:
    """How a file calls a module or some of its names, all if there are none."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            for alias in node.names:
                one = node.module == module and (not names or alias.name in names)
                if one or f"{node.module}.{alias.name}" == module:
                    yield alias.asname or alias.name
        elif isinstance(node, ast.Import):
            yield from (alias.asname or alias.name for alias in node.names if alias.name == module)


def _lines(tree: ast.Module, names: set[str]) -> set[int]:
    """Lines in functions that mention any of some names; all if there are none."""
    found: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            inside = [inner for statement in node.body for inner in ast.walk(statement) if hasattr(inner, "lineno")]
            whole = not names or names & _names(node.args)
            found |= {inner.lineno for inner in inside if whole or isinstance(inner, ast.Name) and inner.id in names}
    return found
