"""A change is tried: the tests that run it, in a process of its own or in one that has collected them already."""

import functools
import json
import os
import shutil
import tempfile
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from typing import Literal

from mutants import covered, running
from mutants.changes import Change

Fate = Literal["killed", "too long", "survived", "not run", "equivalent"]
GENEROUS = 5
"""A change may make its tests take this many times as long."""
COMPILING = 600
"""And this much longer where kernels are compiled anew, s."""


@dataclass(frozen=True)
class Bench:
    """A clone, what its tests run, and where results are kept."""

    work: Path
    seen: covered.Seen
    kernels: Path
    results: Path
    budget: float


def equivalent(change: Change, source: bytes) -> bool:
    """Whether it stands among those that change nothing."""
    table = tomllib.loads((Path(__file__).parent / "equivalent.toml").read_text(encoding="utf-8"))
    old, new = change.lines(source)
    return any((entry["file"], entry["old"], entry["new"]) == (change.file, old, new) for entry in table["change"])


def ordered(bench: Bench, change: Change) -> list[str]:
    """Tests for a change, files kept together, within the budget.

    First those of files named as its own, those of its stage, and quick ones.
    """
    path = Path(change.file)
    own = tuple(f"tests/{before}{change.file.split('/')[1]}" for before in ("", "test_"))
    name = (path.parent.name if path.stem == "__init__" else path.stem).strip("_")

    def near(test: str) -> tuple[bool, bool, float, str]:
        named = name in test.partition("::")[0].rpartition("/")[2]
        return not named, not test.startswith(own), bench.seen.cost[test], test

    chosen: list[str] = []
    for group in bench.seen.tests(change):
        quick = sorted(group, key=near)
        files = list(dict.fromkeys(test.partition("::")[0] for test in quick))
        chosen += sorted(quick, key=lambda test: files.index(test.partition("::")[0]))
    spent = accumulate(bench.seen.cost[test] for test in chosen)
    return [test for k, (test, so_far) in enumerate(zip(chosen, spent)) if so_far <= bench.budget or k == 0]


def compiled_anew(bench: Bench, change: Change, source: bytes) -> set[str]:
    """Modules whose compiled functions a change may have a part in: its own, and those that import what is frozen."""
    own = [change.file] if covered.compiles(source) else []
    files = bench.seen.compiled_with(change.file) if change.compiled or not change.function else own
    return {(Path(file).parent.name if file.endswith("__init__.py") else Path(file).stem) for file in files}


def tried(bench: Bench, change: Change, tests: Sequence[str]) -> tuple[Fate, str]:
    """What becomes of a change, and the first test that failed."""
    if not tests:
        return "not run", ""
    path, source = bench.work / change.file, (bench.work / change.file).read_bytes()
    times = path.stat()
    anew = compiled_anew(bench, change, source)
    cache = Path(tempfile.mkdtemp()) if anew else bench.kernels
    if anew:
        left = shutil.ignore_patterns(*(f"{module}.*" for module in anew))
        shutil.copytree(bench.kernels, cache, dirs_exist_ok=True, ignore=left)
    arguments, said = bench.results.with_suffix(".tests"), bench.results.with_suffix(".txt")
    arguments.write_text("\n".join(tests), encoding="utf-8")
    limit = int(60 + GENEROUS * sum(bench.seen.cost[test] for test in tests) + COMPILING * bool(anew))
    try:
        path.write_bytes(change.applied(source))
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns + 10**9))  # what is compiled already is not taken
        words = ["-x", *running.ASKED, "-rfE", "-p", "no:cacheprovider", f"@{arguments}"]
        status = running.run(bench.work, cache, words, said, limit)
    finally:
        path.write_bytes(source)
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
        if anew:
            shutil.rmtree(cache)
    text = said.read_text(encoding="utf-8", errors="replace")
    if status < 0:
        return "too long", ""
    signs = ("FAILED tests/", "ERROR tests/", "ERROR: not found: ", "ERROR: found no collectors")
    failed = [line for line in text.splitlines() if line.startswith(signs)]
    if status > 2 and not failed:  # else tests could not be imported with it, or are no longer there
        raise RuntimeError(text[-2000:])
    return ("survived", "") if status == 0 else ("killed", failed[0] if failed else text[-200:])


def quickly(bench: Bench, some: Sequence[Change], workers: int = 1) -> dict[str, tuple[Fate, str]]:
    """What becomes of changes of functions in processes that have collected their tests, by their keys.

    Others, and what is run when modules are imported, are left to `tried`.
    """
    fates = bench.results.with_suffix(".fates")
    tests = {key(change): ordered(bench, change) for change in some
             if not change.function or not (change.compiled or bench.seen.imports(change))}
    told = [json.loads(line) for line in fates.read_text(encoding="utf-8").splitlines()] if fates.exists() else []
    known = {name: (fate, by) for name, many, fate, by in told
             if fate in ("killed", "too long") or len(tests.get(name, ())) <= many}
    left = [change for change in some if tests.get(key(change)) and key(change) not in known]
    if not left:
        return {name: found for name, found in known.items() if found[0] != "other"}
    lines = [json.dumps(task(bench, change, tests[key(change)])) for change in left]
    list(running.abreast(workers, functools.partial(_swiftly, bench.work, bench.kernels, bench.results), [
        (k, lines[k::workers]) for k in range(min(workers, len(lines)))]))
    return quickly(bench, some, workers)


def _swiftly(work: Path, kernels: Path, results: Path, share: tuple[int, Sequence[str]]) -> None:
    """Tries some tasks, the share of a worker of such a number."""
    number, lines = share
    tasks, said = results.with_suffix(f".tasks{number}"), results.with_suffix(f".{number}.txt")
    tasks.write_text("\n".join(lines), encoding="utf-8")
    files = sorted({test.partition("::")[0] for line in lines for test in json.loads(line)["tests"]})
    around = {"MUTANTS_TASKS": str(tasks), "MUTANTS_FATES": str(results.with_suffix(".fates"))}
    words = [*running.ASKED, "-p", "no:cacheprovider", "-p", "swift", *files]
    status = running.run(work, kernels, words, said, 3 * 3600, around=around)
    if status > 1:
        raise RuntimeError(said.read_text(encoding="utf-8", errors="replace")[-2000:])


def key(change: Change) -> str:
    """What a change is called among the results."""
    return f"{change.file}:{change.start}:{change.new}"


def task(bench: Bench, change: Change, tests: Sequence[str]) -> dict[str, object]:
    """A change as `swift` takes it."""
    seconds = int(30 + GENEROUS * sum(bench.seen.cost[test] for test in tests))
    return {"key": key(change), "module": covered.module(change.file), "path": str(bench.work / change.file),
            "start": change.start, "end": change.end, "new": change.new, "function": change.function,
            "tests": list(tests), "seconds": seconds}
