"""Would a test notice? Small faults, drawn by seed over all stages, each tried against the tests that run it.

    python -m mutants [--many 120] [--seed 1] [--stage walkable] [--at build/mutants]

Runs in a clone of the last commit, outside the suite, for hours; started again it goes on where it stopped. Of tests
only those are run that run the changed line, the quickest first, until one fails or `--budget` seconds are spent.
With `--tests digests` the digests alone are asked; asked with more tests later, what survived is tried again.
`equivalent.toml` names changes that change nothing one could ask of the program, and why.
"""

import argparse
import json
import os
import shutil
import subprocess
import tempfile
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from random import Random
from typing import Literal

from mutants import covered, running
from mutants.changes import Change, changes, sources

ROOT = Path(__file__).parent.parent.parent
Fate = Literal["killed", "too long", "survived", "not run", "equivalent"]
GENEROUS = 5
"""A change may make its tests take this many times as long."""
COMPILING = 600
"""And this much longer where kernels are compiled anew, s."""
LEAST = 4
"""Changes a part of the code, at least."""


@dataclass(frozen=True)
class Bench:
    """A clone, what its tests run, and where results are kept."""

    work: Path
    seen: covered.Seen
    kernels: Path
    results: Path
    budget: float


def parts(root: Path) -> dict[str, list[str]]:
    """Files by stage and room of the shared floor."""
    found: dict[str, list[str]] = {}
    for file in sources(root, ("schemas", "stages")):
        found.setdefault(file.split("/")[1 if file.startswith("stages/") else 0], []).append(file)
    return {part: files for part, files in found.items() if not part.endswith(".py")}


def drawn(root: Path, many: int, seed: int) -> Iterator[tuple[str, list[Change]]]:
    """Changes of each part, more of larger ones; every kind of change is as likely as any other."""
    folders = parts(root)
    size = {part: sum((root / file).stat().st_size for file in files) ** 0.5 for part, files in folders.items()}
    for part, files in folders.items():
        rng = Random(f"{seed}/{part}")
        kinds: dict[str, list[Change]] = {}
        for file in files:
            for change in changes(file, (root / file).read_bytes()):
                kinds.setdefault(change.kind, []).append(change)
        chosen: list[Change] = []
        while kinds and len(chosen) < max(LEAST, round(many * size[part] / sum(size.values()))):
            kind = rng.choice(sorted(kinds))
            change = kinds[kind].pop(rng.randrange(len(kinds[kind])))
            kinds = {name: left for name, left in kinds.items() if left}
            taken = any((other.file, other.line) == (change.file, change.line) for other in chosen)
            if not taken and change.is_code((root / change.file).read_bytes()):
                chosen.append(change)
        yield part, chosen


def equivalent(change: Change, source: bytes) -> bool:
    """Whether it stands among those that change nothing."""
    table = tomllib.loads((Path(__file__).parent / "equivalent.toml").read_text(encoding="utf-8"))
    old, new = change.lines(source)
    return any((entry["file"], entry["old"], entry["new"]) == (change.file, old, new) for entry in table["change"])


def ordered(bench: Bench, change: Change) -> list[str]:
    """Tests for a change, files kept together, within the budget.

    First those of files named as its own, those of its stage, and quick ones.
    """
    own, path = f"tests/{change.file.split('/')[1]}", Path(change.file)
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
        words = ["-x", "-q", "-rfE", "-p", "no:cacheprovider", f"@{arguments}"]
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


def judged(bench: Bench, part: str, change: Change) -> dict[str, str | int]:
    """A change's fate with what tells of it; kept."""
    source = (bench.work / change.file).read_bytes()
    old, new = change.lines(source)
    tests = ordered(bench, change)
    fate, by = ("equivalent", "") if equivalent(change, source) else tried(bench, change, tests)
    found: dict[str, str | int] = {
        "part": part, "file": change.file, "line": change.line, "kind": change.kind, "old": old, "new": new,
        "start": change.start, "tests": len(tests), "fate": fate, "by": by}
    with bench.results.open("a", encoding="utf-8") as file:
        file.write(json.dumps(found, ensure_ascii=False) + "\n")
    print(f"{fate:10} {change.file}:{change.line} {change.kind} [{len(tests)}] {by[:90]}", flush=True)
    return found


def told(found: Sequence[dict[str, str | int]]) -> Iterator[str]:
    """Killed and survived by part, then what survived."""
    yield f"{'part':12} killed survived equivalent"
    for part in [*dict.fromkeys(str(one["part"]) for one in found), "all"]:
        fates = [one["fate"] for one in found if part in (one["part"], "all")]
        dead, same = sum(fate in ("killed", "too long") for fate in fates), fates.count("equivalent")
        rest = len(fates) - dead - same
        yield f"{part:12} {dead:6} {rest:8} {same:10}   {dead / max(dead + rest, 1):.0%}"
    for one in found:
        if one["fate"] in ("survived", "not run"):
            yield f"\n{one['file']}:{one['line']} {one['fate']} {one['tests']} tests\n- {one['old']}\n+ {one['new']}"


def main() -> None:
    """Draws, tries, tells."""
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__.splitlines()[0])
    parser.add_argument("--many", type=int, default=120)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--stage", action="append", help="only these parts of the code")
    parser.add_argument("--tests", action="append", help="only files of tests whose names so begin, and those before")
    parser.add_argument("--at", type=Path, default=ROOT / "build" / "mutants")
    parser.add_argument("--budget", type=float, default=120.0, help="seconds of tests that a change may cost")
    parser.add_argument("--commit", default="HEAD", help="whose code and tests")
    asked = parser.parse_args()
    git = ["git", "rev-parse", "--short=12", asked.commit]
    commit = subprocess.run(git, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()
    at = asked.at.resolve() / commit
    work = covered.clone(ROOT, at / "clone", commit)
    running.ready()
    draw = list(drawn(work, asked.many, asked.seed))
    seen, kernels = at / f"seen.{asked.many}.{asked.seed}", covered.kernels(ROOT, work, at / "kernels")
    telling = covered.Seen(work, seen).telling
    watched = sorted({file for _, some in draw for one in some for file in telling(one)})
    covered.measure(work, seen, kernels, watched, asked.tests or [""])
    bench = Bench(work, covered.Seen(work, seen), kernels, at / "results.jsonl", asked.budget)
    lines = bench.results.read_text(encoding="utf-8").splitlines() if bench.results.exists() else []
    known = {(one["file"], one["start"], one["new"]): one for one in map(json.loads, lines)}
    found = []
    for part, some in draw:
        for change in some if not asked.stage or part in asked.stage else []:
            was = known.get((change.file, change.start, change.lines((work / change.file).read_bytes())[1]))
            again = was is None or was["fate"] in ("survived", "not run") and was["tests"] < len(ordered(bench, change))
            found.append(judged(bench, part, change) if again or was is None else was)
    print("\n".join(told(found)))


if __name__ == "__main__":
    main()
