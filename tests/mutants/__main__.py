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
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from random import Random

from mutants import covered, running
from mutants.changes import Change, changes, sources
from mutants.trying import Bench, Fate, equivalent, key, ordered, quickly, tried

ROOT = Path(__file__).parent.parent.parent
Row = dict[str, str | int]
LEAST = 4
"""Changes a part of the code, at least."""


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


def judged(bench: Bench, part: str, change: Change, quick: tuple[Fate, str] | None) -> Row:
    """A change's fate with what tells of it; kept."""
    source = (bench.work / change.file).read_bytes()
    old, new = change.lines(source)
    tests = ordered(bench, change)
    fate, by = quick or (("equivalent", "") if equivalent(change, source) else tried(bench, change, tests))
    found: Row = {
        "key": key(change), "part": part, "file": change.file, "line": change.line, "kind": change.kind, "old": old,
        "new": new, "tests": len(tests), "fate": fate, "by": by}
    with bench.results.open("a", encoding="utf-8") as file:
        file.write(json.dumps(found, ensure_ascii=False) + "\n")
    print(f"{fate:10} {change.file}:{change.line} {change.kind} [{len(tests)}] {by[:90]}", flush=True)
    return found


def told(found: Sequence[Row]) -> Iterator[str]:
    """Killed and survived by part, then what survived."""
    yield f"{'part':12} killed survived equivalent"
    for part in [*sorted({str(one["part"]) for one in found}), "all"]:
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
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="processes")
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
    covered.measure(work, seen, kernels, watched, asked.tests or [""], asked.workers)
    bench = Bench(work, covered.Seen(work, seen), kernels, at / "results.jsonl", asked.budget)
    lines = bench.results.read_text(encoding="utf-8").splitlines() if bench.results.exists() else []
    known = {one["key"]: one for one in map(json.loads, lines)}
    chosen = [(part, change) for part, some in draw for change in some if not asked.stage or part in asked.stage]
    Random(asked.seed).shuffle(chosen)  # what is tried when the time is up is a fair sample
    print("\n".join(told(list(fates(bench, chosen, known, asked.workers)))))


def fates(bench: Bench, chosen: Sequence[tuple[str, Change]], known: Mapping[str, Row],
          workers: int) -> Iterator[Row]:
    """What became of changes: what is known, unless it survived fewer tests than there are now, or tried."""
    def again(change: Change) -> bool:
        was = known.get(key(change))
        return was is None or was["fate"] in ("survived", "not run") and was["tests"] < len(ordered(bench, change))

    new = [(part, change) for part, change in chosen if again(change)]
    same = {key(change) for _, change in new if equivalent(change, (bench.work / change.file).read_bytes())}
    quick = quickly(bench, [change for _, change in new if key(change) not in same], workers)
    for part, change in chosen:
        name = key(change)
        yield judged(bench, part, change, quick.get(name)) if (part, change) in new else known[name]


if __name__ == "__main__":
    main()
