"""Writes an apartment in any of the formats that lie in this folder, one file each.

A format is a module with `write(scene, out) -> list[Path]`: it writes its files under the folder `out` and names
them; its `read_back(files)` reads them by the format's own parser before the export is called done. What a scene holds
is in `stages/scene/scene.py`.
"""

import hashlib
from collections.abc import Callable
from contextlib import AbstractContextManager, ExitStack
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from apartgen.schemas.errors import BadInput
from apartgen.schemas.export import Export, File
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.aside import aside, at_once
from apartgen.stages.export._primitive import primitive
from apartgen.stages.export._randomized import randomized, told
from apartgen.stages.registry import contract
from apartgen.stages.scene.folder import CONTENTS, listed, replaced
from apartgen.stages.scene.scene import LoadAsset, Scene

PACKAGE = "apartgen.stages.export"
Colliders = Literal["exact", "primitive"]
Begun = Callable[[Callable[[], Any]], AbstractContextManager[Callable[[], Any]]]
"""How a job is begun that is waited for later."""


def formats() -> dict[str, str]:
    """Every format's name and what it is."""
    return registry.members(PACKAGE)


def needs_assets(format: str) -> bool:
    """Whether a format shows assets, not boxes; BadInput for an unknown one. None is imported to know it."""
    return registry.stated(PACKAGE, format, "NEEDS_ASSETS", usual=True)


def run(
    home: Plan, formats: list[str], out: Path, load_asset: LoadAsset, randomize: int | None = None,
    colliders: Colliders = "exact", processes: int = 1,
) -> Export:  # fmt: skip
    """Write every format into the folder `out`, which appears, or is replaced, whole or not at all.

    `load_asset(library, id)` gives the assets; `randomize` is the seed by which physics are drawn, where they are;
    `primitive` colliders are boxes, cylinders and spheres, no hulls. With two `processes` formats that show boxes are
    written beside the others, and most are read back beside the next, which changes no byte.
    BadInput for an unknown format, a layout without assets where a format needs them, and an `out` that holds what no
    export put there, and files that their format's own reader refuses.
    """
    if not formats:
        raise BadInput(f"no format asked for; there are: {', '.join(registry.members(PACKAGE))}")
    writers = {name: registry.load(PACKAGE, name) for name in dict.fromkeys(formats) if needs_assets(name)}
    scene = Scene(home, load_asset)
    scene = scene if colliders == "exact" else scene.of(primitive(scene.bodies), masked=True)
    scene = scene if randomize is None else scene.of(randomized(scene, randomize))
    with replaced(out) as folder:
        found = _all_written(list(dict.fromkeys(formats)), writers, scene, folder, aside if processes > 1 else at_once)
        files = [_file(path, name, folder) for name, paths in found.items() for path in paths]
        if randomize is not None:
            files.append(_file(told(scene.bodies, randomize, folder), "json", folder))
        credits = scene.credits if writers else []
        files.append(_credits(folder, credits))
        (folder / CONTENTS).write_text(listed([(file.path, file.sha256) for file in files], "export"))
    return Export(files=files, credits=credits)


def _all_written(
    formats: list[str], writers: dict[str, ModuleType], scene: Scene, folder: Path, begun: Begun
) -> dict[str, list[Path]]:
    """The files of every format, in order. Formats share what is shaded and drawn for them, so they are written one
    after another, the first at the end: it is read back here while others are read elsewhere.
    """
    bare = [name for name in formats if name not in writers]
    found: dict[str, list[Path]] = {}
    with ExitStack() as ended:
        flat = ended.enter_context((begun if bare and writers else at_once)(lambda: _bare(bare, scene, folder)))
        taken: list[Callable[[], None]] = []
        for name in [*list(writers)[1:], *list(writers)[:1]]:
            found[name] = _written(name, writers[name], scene, folder)
            check = partial(_read_back, name, writers[name], found[name], folder)
            taken.append(ended.enter_context((begun if len(found) < len(writers) else at_once)(check)))
        for wait in taken:
            wait()
        found |= flat()
    return {name: found[name] for name in formats}


def _bare(formats: list[str], scene: Scene, folder: Path) -> dict[str, list[Path]]:
    """The files of formats that show boxes, which are imported here, in the process that draws."""
    found: dict[str, list[Path]] = {}
    for name in formats:
        writer = registry.load(PACKAGE, name)
        found[name] = _written(name, writer, scene, folder)
        _read_back(name, writer, found[name], folder)
    return found


def _written(name: str, writer: ModuleType, scene: Scene, folder: Path) -> list[Path]:
    """The files of a format; BadInput where it gives none, or names one that is not there or not below the folder."""
    paths: list[Path] = writer.write(scene, folder)
    fault = contract.unfit(paths, list[Path]) or ("" if paths else "gave an empty list")
    if fault:
        fault += "; it is to give the paths of the files that it wrote, the main one first"
    elif strange := [path for path in paths if not (path.is_relative_to(folder) and path.is_file())]:
        fault = f"names {strange[0].name}, which is no file that it wrote below the folder it was given"
    if fault:
        raise BadInput(registry.told(PACKAGE, name, f"write {fault}", "format"))
    return paths


def _read_back(name: str, writer: ModuleType, files: list[Path], folder: Path) -> None:
    """BadInput where a format's own reader does not take its files."""
    try:
        if hasattr(writer, "read_back"):
            writer.read_back(files)
    except Exception as error:  # parsers raise what they like
        fault = (str(error).splitlines() or [type(error).__name__])[0]
        raise BadInput(f"format {name}: its own reader refuses what was written ({fault.replace(str(folder), '')}); "
                       "leave the format out, or the library whose models it can't take") from error


def _credits(folder: Path, credits: list[str]) -> File:
    path = folder / "CREDITS.txt"
    path.write_text("\n".join(["Made with apartgen.", *credits]) + "\n", encoding="utf-8")
    return _file(path, "text", folder)


def _file(path: Path, format: str, folder: Path) -> File:
    return File(path=path.relative_to(folder).as_posix(), format=format, sha256=_sha256(path))


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
