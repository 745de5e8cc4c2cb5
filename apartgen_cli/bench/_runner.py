"""Runs the trials of an experiment on several cores, keeps every finished one, writes table and figure."""

import hashlib
import json
import os
import platform
import subprocess
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path
from time import perf_counter, process_time
from types import ModuleType
from typing import Any, TextIO

import numpy as np

from apartgen import __version__
from apartgen.schemas import artifact
from apartgen.schemas.errors import BadInput
from apartgen_cli.console import watched

SEEDS = 1_000_003
"""By which the seeds of runs lie apart; what is left over is the first scene of a trial."""
Record = dict[str, Any]
Job = tuple[Any, ...]
Files = dict[str, Any]


def jobs(experiment: ModuleType, scenes: int, seed: int, files: Files | None = None) -> list[Job]:
    """(setting, seed, scenes) of every trial; a trial's seed is the same in every setting, so that scenes pair up.

    Where a setting uses files, their digest comes fourth, so that other files are other trials.
    """
    chunk = min(experiment.CHUNK, scenes)
    starts = range(0, scenes, chunk)
    settings = experiment.settings(**files or {}) if hasattr(experiment, "settings") else experiment.SETTINGS
    used = {s: _used(experiment, s, files) for s in settings}
    last = {s: [_digests(given)] if given else [] for s, given in used.items()}
    return [(s, seed * SEEDS + start, min(chunk, scenes - start), *last[s]) for s in settings for start in starts]


def _used(experiment: ModuleType, setting: str, files: Files | None) -> Files:
    """The files that a setting's trials depend on; all that are given, where the experiment does not say."""
    chosen: Files = experiment.used(setting, **files or {}) if hasattr(experiment, "used") else files or {}
    return chosen


def _digests(files: Files) -> str:
    """Of names and contents; of a folder, of the names and sizes in it."""
    whole = hashlib.sha256()
    for option, value in sorted(files.items()):
        for text in value if isinstance(value, list) else [value]:
            path = Path(text.partition("=")[2] if option == "real" else text)
            whole.update(f"{option} {text}".encode())
            if path.is_file():
                whole.update(path.read_bytes())
            else:
                whole.update(str(sorted((f.name, f.stat().st_size) for f in path.rglob("*"))).encode())
    return whole.hexdigest()[:16]


def run(
    experiment: ModuleType, name: str, out: Path, scenes: int | None, seed: int, processes: int | None,
    files: Files | None = None,
) -> Iterator[Path]:
    """All trials not yet in `out`, then its results.json, table.md and figure.png, yielded as written."""
    n, commit = scenes or experiment.SCENES, _commit()
    wanted = jobs(experiment, n, seed, files)
    with _log(out) as log, watched(name, len(wanted)) as report:
        done = _finished(out / "trials.jsonl")
        todo = [job for job in wanted if _key(job) not in done]
        report(len(wanted) - len(todo))
        for count, (job, found) in enumerate(_worked(name, todo, out, processes, files), 1):
            row = {"job": job, **found, "commit": commit}
            done[_key(job)] = row
            log.write(json.dumps(row) + "\n")
            log.flush()
            report(len(wanted) - len(todo) + count)
    trials = [done[_key(job)] for job in wanted]
    yield from _written(experiment, name, out, trials, n, seed, files)


def _key(job: Job | list[Any]) -> str:
    return json.dumps(list(job))


def _log(out: Path) -> TextIO:
    """`out`/trials.jsonl to go on in, its last line ended where a kill cut it short; BadInput if it can't be had."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        log = (out / "trials.jsonl").open("a+")
        log.seek(0)
        if not ("\n" + log.read()).endswith("\n"):
            log.write("\n")
    except OSError as error:
        raise BadInput(f"-o {out}: nothing can be written there ({error.strerror}); give another folder") from None
    except UnicodeError:
        raise BadInput(f"{out / 'trials.jsonl'}: no trials of an earlier run; give another folder with -o") from None
    return log


def _finished(path: Path) -> dict[str, Record]:
    """Trials of an earlier run; what is no whole one, as a line cut short by a kill, is done again."""
    out: dict[str, Record] = {}
    for line in path.read_text().splitlines():
        try:
            row = json.loads(line)
        except json.JSONDecodeError:
            continue
        if _whole(row):
            out[_key(row["job"])] = row
    return out


def _whole(row: Any) -> bool:
    return isinstance(row, dict) and {"seconds", "cpu"} <= row.keys() and all(
        isinstance(row.get(key), list) for key in ("job", "records"))


def _worked(
    name: str, todo: list[Job], out: Path, processes: int | None, files: Files | None
) -> Iterator[tuple[Job, Record]]:
    workers = min(processes or os.cpu_count() or 1, max(1, len(todo)))
    if workers == 1:
        for job in todo:
            yield job, _trial(name, job, out, files)
        return
    with ProcessPoolExecutor(workers, get_context("spawn"), initializer=_quiet) as pool:
        futures = {pool.submit(_trial, name, job, out, files): job for job in todo}
        for future in as_completed(futures):
            yield futures[future], future.result()


def _quiet() -> None:
    """One core a worker."""
    os.environ["OMP_NUM_THREADS"] = "1"


def _trial(name: str, job: Job, out: Path, files: Files | None) -> Record:
    """What a trial found, with the seconds that passed and those the processor worked on it."""
    from apartgen.stages import registry

    experiment = registry.load("apartgen_cli.bench", name)
    setting, seed, scenes = job[:3]
    began, worked = perf_counter(), process_time()
    found = experiment.trial(setting, seed, scenes, out, **_used(experiment, setting, files))
    return {"records": [{"setting": setting, **record} for record in found],
            "seconds": round(perf_counter() - began, 3), "cpu": round(process_time() - worked, 3)}


def _written(
    experiment: ModuleType, name: str, out: Path, trials: list[Record], scenes: int, seed: int, files: Files | None
) -> Iterator[Path]:
    records = [record for trial in trials for record in trial["records"]]
    if not records:
        raise BadInput(f"{name}: no scene gave anything to measure; ask for more with --n")
    rows = experiment.rows(records, np.random.default_rng(seed))
    facts = {
        "experiment": name,
        "made_by": f"apartgen {__version__}",
        "commit": ", ".join(dict.fromkeys(str(trial.get("commit") or "unknown") for trial in trials)),
        "seed": seed,
        "scenes": scenes,
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}",
        "seconds": round(sum(trial["seconds"] for trial in trials), 1),
        "cpu_seconds": round(sum(trial["cpu"] for trial in trials), 1),
    }
    facts |= {option: _named(value) for option, value in (files or {}).items()}
    body = {**facts, "note": experiment.NOTE, "paper": experiment.PAPER, "rows": rows}
    artifact.write(json.dumps(body, indent=1) + "\n", out / "results.json")
    yield out / "results.json"
    artifact.write(_markdown(experiment, facts, rows), out / "table.md")
    yield out / "table.md"
    if hasattr(experiment, "draw"):
        yield _figure(experiment, rows, out / "figure.png")


def _named(value: str | list[str]) -> str:
    """Files by name alone: where they lie on this machine says nothing to others."""
    return ", ".join(Path(text).name for text in (value if isinstance(value, list) else [value]))


def _commit() -> str | None:
    """The program's commit, marked where its files differ from it; None outside a repository."""
    asked = subprocess.run(["git", "describe", "--always", "--dirty", "--exclude=*"], cwd=Path(__file__).parent,
                           capture_output=True, text=True, check=False)
    return asked.stdout.strip() or None


def _markdown(experiment: ModuleType, facts: Record, rows: list[Record]) -> str:
    about = ", ".join(f"{key.replace('_', ' ')} {value}" for key, value in facts.items() if key != "experiment")
    parts = [f"# {facts['experiment']}", experiment.NOTE]
    for title, columns in getattr(experiment, "TABLES", {"Measured": []}).items():
        parts += [f"## {title}", _table(rows, columns)]
    if experiment.PAPER:
        parts += ["## The paper", _table(experiment.PAPER)]
    return "\n\n".join([*parts, f"{about}."]) + "\n"


def _table(rows: list[Record], wanted: Sequence[str] = ()) -> str:
    """The wanted columns that there are, by default all; without rows that hold nothing but their names."""
    there = list(dict.fromkeys(key for row in rows for key in row))
    columns = [c for c in wanted if c in there] if wanted else there
    rows = [row for row in rows if any(not isinstance(row.get(c), str | None) for c in columns)]
    lines = [columns, ["---"] * len(columns), *([_cell(row.get(c)) for c in columns] for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _cell(value: Any) -> str:
    if isinstance(value, list) and len(value) == 3:
        return f"{value[0]:.4g} [{value[1]:.4g}, {value[2]:.4g}]"
    if isinstance(value, list) and len(value) == 2:
        return f"{value[0]:.4g} ± {value[1]:.2g}"
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def _figure(experiment: ModuleType, rows: list[Record], path: Path) -> Path:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.2, 4.2), dpi=130, layout="constrained")
    experiment.draw(rows, figure.subplots())
    part = path.with_suffix(".part")
    figure.savefig(part, format="png", metadata={"Software": None})
    part.replace(path)
    return path
