"""Build, verify, divide, export and rebuild data sets of homes."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from apartgen.schemas import artifact
from apartgen.schemas.artifact import STREAM
from apartgen.schemas.errors import BadInput, Unmet
from apartgen_cli.console import fail, say, watched
from apartgen_cli.options import CONFIG, tables
from apartgen_cli.streams import is_folder

if TYPE_CHECKING:
    from apartgen.dataset.store import Store

PROMPTS = Annotated[str | None, typer.Argument(
    metavar="PROMPTS", help="A file of prompts, one a line, or JSON with id, prompt, seed, settings; - is a pipe.")]
DATA = Annotated[Path, typer.Argument(metavar="DATA", help="The folder of a data set.")]
FOLDER = Annotated[Path, typer.Option("--out", "-o", help="The folder to write.")]
COUNT = Annotated[int | None, typer.Option(
    "--count", min=1, help="Homes; more than there are prompts takes these again. All prompts once by default.")]
GRAMMAR = Annotated[str | None, typer.Option(
    "--prompts-from", metavar="GRAMMAR", help="A TOML file of texts to draw prompts from, or `default`.")]
SEED = Annotated[int, typer.Option("--seed", min=0, max=2**63 - 1, help="Fixes everything drawn.")]
WORKERS = Annotated[int | None, typer.Option(
    "--workers", min=1, help="Processes, or jobs at a time; as many as there are cores by default.")]
SHARD = Annotated[int, typer.Option("--shard", min=1, help="Requests of a file of homes.")]
IDS = Annotated[list[str] | None, typer.Option("--id", help="A home by its id, any number of times.")]
SPLIT = Annotated[str | None, typer.Option("--split", help="The homes of this part.")]
FORMAT = Annotated[list[str], typer.Option("--format", help="What to write, any number of times, as of `export`.")]
POPULATE = Annotated[bool, typer.Option("--populate/--no-populate", help="Put small things into the homes.")]
ENGINE = Annotated[str, typer.Option("--engine", help="Who makes the homes: local, ray or submitit.")]
COPY = Annotated[str | None, typer.Option(
    "--copy-to", metavar="URL", help="Copy full shards and, at the end, all files there: any address of fsspec.")]
AS_JSON = Annotated[bool, typer.Option("--json", help="Write JSON.")]
PARTS = Annotated[str, typer.Option("--parts", metavar="NAME=SHARE,…", help="The parts and their shares.")]


def _build(out: FOLDER, prompts: PROMPTS = None, count: COUNT = None, grammar: GRAMMAR = None, seed: SEED = 0,
           config: CONFIG = None, workers: WORKERS = None, shard: SHARD = 1000, populate: POPULATE = True,
           engine: ENGINE = "local", copy: COPY = None) -> int:
    """Make a home for every prompt; a run that ended, however it did, goes on where it was."""
    from apartgen.dataset.build import build
    from apartgen.dataset.copies import Place
    from apartgen.dataset.source import source
    from apartgen.dataset.store import Store

    copies = None if copy is None else Place(copy)
    asked = source(prompts, grammar, count, seed)
    there = sum(1 for _ in Store(out).rows())
    failed = 0
    with watched("homes", asked.count) as report:
        done = there

        def told(row: dict[str, Any]) -> None:
            nonlocal done, failed
            done += 1
            report(done)
            if "error" in row:
                failed += 1
                fail(f"{row['id']}: {row['error']}")

        build(asked, out, seed=seed, given=tables(config), workers=workers, per_shard=shard, populate=populate,
              engine=engine, report=told, copies=copies)
    listed = f"; {out}/failures.jsonl has them" if failed else ""
    say(f"{done - there - failed} homes made, {there} were there, {failed} failed{listed}")
    return 1 if failed else 0


def _verify(data: DATA, workers: WORKERS = None) -> int:
    """Compare every byte and digest with the manifest, and have every home judged; exit status 1 for any fault."""
    from apartgen.dataset.verify import verify

    store = _store(data)
    wrong, seen = 0, 0
    with watched("verify", store.about()["count"]) as report:

        def looked(_: str) -> None:
            nonlocal seen
            seen += 1
            report(seen)

        for fault in verify(store, workers, looked):
            wrong += 1
            typer.echo(fault)
    say(f"{seen} homes looked at, {wrong} faults")
    return 1 if wrong else 0


def _stats(data: DATA, as_json: AS_JSON = False) -> None:
    """Show what a data set holds: spread of every figure, rooms, objects, failures, twins, time."""
    from apartgen.dataset import statistics

    found = statistics.statistics(_store(data))
    typer.echo(json.dumps(found, ensure_ascii=False) if as_json else statistics.table(found), nl=as_json)


def _split(data: DATA, parts: PARTS = "train=0.8,val=0.1,test=0.1") -> None:
    """Divide a data set anew; homes that are nearly the same go to one part."""
    from apartgen.dataset import finish, splits

    store = _store(data)
    finish.finish(store, splits.parts_of(parts))
    counts: dict[str, int] = {}
    for row in store.rows():
        if "split" in row:
            counts[row["split"]] = counts.get(row["split"], 0) + 1
    say(", ".join(f"{name} {n}" for name, n in counts.items()))


def _merge(data: Annotated[list[Path], typer.Argument(metavar="DATA", help="Folders of data sets.")],
           out: FOLDER) -> None:
    """Put data sets of the same settings together in a new folder."""
    from apartgen.dataset.merge import merge

    store = merge([_store(folder) for folder in data], out)
    say(f"{store.about()['count']} homes in {out}")


def _export(data: DATA, out: FOLDER, format: FORMAT, id: IDS = None, split: SPLIT = None,
            workers: WORKERS = None, shard: SHARD = 1000) -> int:
    """Write scenes of homes, a folder each; files that are equal are stored once. `--format webdataset` writes tars
    instead, of `--shard` homes each, with the files of other formats in them.
    """
    from apartgen.dataset import scenes, tars
    from apartgen.dataset.build import selected
    from apartgen.outputs import ExportSettings

    store = _store(data)
    libraries = store.about()["settings"].get("retrieve", {}).get("libraries", [])
    rows = list(selected(store, id or [], split))
    if not rows:
        raise BadInput(f"{data}: no home of that split; `apartgen dataset stats` tells which there are")
    failed, packed, formats = 0, tars.FORMAT in format, [name for name in format if name != tars.FORMAT]
    settings = ExportSettings(format=formats, libraries=libraries) if formats else None
    with watched("export", len(rows)) as report:
        if packed or settings is None:
            work = tars.export(store, rows, out, settings, shard, workers)
        else:
            work = scenes.export(store, rows, out, settings, workers)
        for done, (row, error) in enumerate(work, 1):
            report(done)
            if error:
                failed += 1
                fail(f"{row['id']}: {error}")
    say(f"wrote {len(rows) - failed} scenes to {out}")
    return 1 if failed else 0


def _rebuild(data: DATA, id: Annotated[str, typer.Argument(metavar="ID", help="The home's id.")],
             out: Annotated[str, typer.Option("--out", "-o", help="The file to write.")] = STREAM) -> None:
    """Make one home of a data set anew; it is the same, byte for byte, or exit status 1 says how it differs."""
    import hashlib

    from apartgen.dataset.build import again, selected

    store = _store(data)
    [row] = selected(store, [id])
    done = again(row, store.about())
    if not done.line:
        raise Unmet(f"{id}: {done.row['error']}")
    artifact.write(done.line.decode(), Path(out) / f"{id}.json" if is_folder(out) else out)
    if hashlib.sha256(done.line).hexdigest() != row["sha256"]:
        other = [name for name, digest in row["digests"].items() if done.row["digests"].get(name) != digest]
        raise Unmet(f"{id}: comes out differently from {other[0]} on: made by {row['by']}, now {done.row['by']}; other "
                    "versions, weights or machines give other homes")


def _store(folder: Path) -> "Store":
    from apartgen.dataset.store import Store

    store = Store(folder)
    store.about()
    return store


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"build": _build, "verify": _verify, "stats": _stats, "split": _split, "merge": _merge, "export": _export,
            "rebuild": _rebuild}
