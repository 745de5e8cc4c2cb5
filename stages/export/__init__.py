"""Writes an apartment in any of the formats that lie in this folder, one file each.

A format is a module with `write(scene, out) -> list[Path]`: it writes its files under the folder `out` and names
them; its `read_back(files)` reads them by the format's own parser before the export is called done. What a scene holds
is in `stages/scene.py`.
"""

import hashlib
from pathlib import Path
from typing import Any, Literal

from apartgen.schemas.errors import BadInput
from apartgen.schemas.export import Export, File
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.export._aside import aside
from apartgen.stages.export._primitive import primitive
from apartgen.stages.export._randomized import randomized, told
from apartgen.stages.scene.folder import CONTENTS, listed, replaced
from apartgen.stages.scene.scene import LoadAsset, Scene

PACKAGE = "apartgen.stages.export"
Colliders = Literal["exact", "primitive"]
BARE = ("svg", "png", "elevations", "dxf", "ifc")
"""Formats that show boxes, not assets."""


def formats() -> dict[str, str]:
    """Every format's name and what it is."""
    return registry.members(PACKAGE)


def run(
    home: Plan, formats: list[str], out: Path, load_asset: LoadAsset, randomize: int | None = None,
    colliders: Colliders = "exact", processes: int = 1,
) -> Export:  # fmt: skip
    """Write every format into the folder `out`, which appears, or is replaced, whole or not at all.

    `load_asset(library, id)` gives the assets; `randomize` is the seed by which physics are drawn, where they are;
    `primitive` colliders are boxes, cylinders and spheres, no hulls. With two `processes` all formats but the first
    are written beside it, which changes no byte.
    BadInput for an unknown format, a layout without assets where a format needs them, and an `out` that holds what no
    export put there, and files that their format's own reader refuses.
    """
    if not formats:
        raise BadInput(f"no format asked for; there are: {', '.join(registry.members(PACKAGE))}")
    writers = {name: registry.load(PACKAGE, name) for name in dict.fromkeys(formats)}
    scene = Scene(home, load_asset)
    scene = scene if colliders == "exact" else scene.of(primitive(scene.bodies), masked=True)
    scene = scene if randomize is None else scene.of(randomized(scene, randomize))
    with replaced(out) as folder:
        files = _all_written(list(writers.items()), scene, folder, processes)
        if randomize is not None:
            files.append(_file(told(scene.bodies, randomize, folder), "json", folder))
        credits = scene.credits if any(name not in BARE for name in writers) else []
        files.append(_credits(folder, credits))
        (folder / CONTENTS).write_text(listed([(file.path, file.sha256) for file in files], "export"))
    return Export(files=files, credits=credits)


def _all_written(writers: list[tuple[str, Any]], scene: Scene, folder: Path, processes: int) -> list[File]:
    def some(part: list[tuple[str, Any]]) -> list[File]:
        return [_file(path, name, folder) for name, writer in part for path in _written(name, writer, scene, folder)]

    if processes == 1 or len(writers) == 1:
        return some(writers)
    if any(name not in BARE for name, _ in writers):
        _ = scene.bodies  # both need them
    with aside(lambda: some(writers[1:])) as rest:
        return some(writers[:1]) + rest()


def _written(name: str, writer: Any, scene: Scene, folder: Path) -> list[Path]:
    """The files of a format, once its own reader takes them; BadInput where it does not."""
    files: list[Path] = writer.write(scene, folder)
    try:
        if hasattr(writer, "read_back"):
            writer.read_back(files)
    except Exception as error:  # parsers raise what they like
        fault = (str(error).splitlines() or [type(error).__name__])[0]
        raise BadInput(f"format {name}: its own reader refuses what was written ({fault.replace(str(folder), '')}); "
                       "leave the format out, or the library whose models it can't take") from error
    return files


def _credits(folder: Path, credits: list[str]) -> File:
    path = folder / "CREDITS.txt"
    path.write_text("\n".join(["Made with apartgen.", *credits]) + "\n", encoding="utf-8")
    return _file(path, "text", folder)


def _file(path: Path, format: str, folder: Path) -> File:
    return File(path=path.relative_to(folder).as_posix(), format=format, sha256=_sha256(path))


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
