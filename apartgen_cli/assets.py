"""Index, check and look into asset libraries."""

import inspect
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from apartgen.schemas.errors import BadInput
from apartgen.stages.retrieve.matching.indexing import kinds
from apartgen_cli.console import fail, say

if TYPE_CHECKING:
    from apartgen.stages.retrieve.matching.indexing import Report
    from apartgen.stages.things.asset import Asset

EMBEDDED = "parametric"
"""Name of the library that comes with the program."""
FOLDER = Annotated[Path, typer.Argument(metavar="FOLDER", help="The folder, or archive, of the models.")]
KIND = Annotated[str, typer.Option("--as", help=f"What it is: {', '.join(kinds())}.")]
SCALE = Annotated[float | None, typer.Option("--scale", min=1e-6, help="Metres per unit of the models.")]
FRONT = Annotated[str | None, typer.Option(
    "--front", help="Axis the models face, e.g. +x, where their format leaves it open.")]
LIBRARIES = Annotated[list[Path] | None, typer.Option(
    "--library", help="Folder of an indexed library, any number of times; the embedded one by default.")]


def index(
    folder: FOLDER, kind: KIND, out: Annotated[Path, typer.Option("--out", "-o", help="The library's folder.")],
    name: Annotated[str, typer.Option("--name", help="The library's name; the folder's by default.")] = "",
    scale: SCALE = None, front: FRONT = None,
) -> None:
    """Make a library of the models in a folder; what is broken is named and left out."""
    from apartgen.stages.retrieve.matching import indexing

    report = indexing.build(folder, kind, out, name, **_options(kind, scale, front))
    say(f"wrote {out}: {report.indexed} assets, {len(report.broken)} broken ones left out")


def check(folder: FOLDER, kind: KIND, scale: SCALE = None, front: FRONT = None) -> int:
    """Read every model of a folder and name the broken ones; status 1 when there are any."""
    from apartgen.stages.retrieve.matching import indexing

    report: Report = indexing.check(folder, kind, **_options(kind, scale, front))
    for broken in report.broken:
        fail(f"{broken.id}: {broken.reason}")
    say(f"{report.indexed} assets can be indexed, {len(report.broken)} are broken")
    return 1 if report.broken else 0


def list_(library: LIBRARIES = None) -> None:
    """List the assets of libraries: one line each, category, size in metres, name."""
    if not library:
        from apartgen.stages.things.latents import index as embedded

        table = embedded()
        rows = [(c, s, EMBEDDED, f"{c}/{style}/{'x'.join(f'{1000 * side:.0f}' for side in s)}/{seed}")
                for c, s, style, seed in zip(table.category, table.size.tolist(), table.style, table.seed.tolist())]
    else:
        from apartgen.stages.retrieve.matching.indexed import IndexedLibrary

        opened = [IndexedLibrary(folder) for folder in library]
        rows = [(entry.category, entry.size, one.name, entry.id) for one in opened for entry in one.entries]
    for category, size, name, id in sorted(rows, key=lambda row: (row[0], row[2], row[3])):
        typer.echo(f"{category}\t{' '.join(f'{side:.2f}' for side in size)}\t{name}\t{id}")


def show(library: Annotated[Path, typer.Argument(
             metavar="LIBRARY", help=f"Folder of an indexed library, or {EMBEDDED} for the embedded one.")],
         id: Annotated[str, typer.Argument(metavar="ID", help="An asset's id, see `apartgen assets list`.")]) -> None:
    """Show one asset's links, joints and credit as JSON."""
    from apartgen.stages import retrieve

    own = str(library) == EMBEDDED
    opened = retrieve.open_libraries(retrieve.RetrieveConfig(libraries=[] if own else [str(library)]))
    found = opened.load_asset(EMBEDDED if own else next(iter(opened.others)), id)
    json.dump(_told(found), sys.stdout, indent=2, ensure_ascii=False)
    sys.stdout.write("\n")


def preview(
    out: Annotated[Path, typer.Option("--out", "-o", help="The PNG file to write.")],
    ids: Annotated[list[str] | None, typer.Argument(
        metavar="ID", help="Assets to show, see `apartgen assets list`; all there are by default.")] = None,
    library: LIBRARIES = None,
    category: Annotated[str, typer.Option("--category", help="Show only this category, in all its styles.")] = "",
    size: Annotated[int, typer.Option("--size", min=32, max=2048, help="Pixels along a side of each picture.")] = 136,
    columns: Annotated[int, typer.Option("--columns", min=1, max=100, help="Pictures in a row.")] = 14,
) -> None:
    """Draw assets closed and open as a PNG: one, a category, or a contact sheet of a whole library."""
    from apartgen.stages.retrieve.preview import choice, sheet

    image = sheet.drawn(choice.cells(library or [], ids or [], category, size), columns)
    part = out.with_name(f".{out.name}.partial")
    try:
        image.save(part, "PNG", optimize=True)
        part.replace(out)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise BadInput(f"{out}: cannot be written ({error.strerror or error}); give another path with -o") from None
    say(f"wrote {out}: {image.width} x {image.height} pixels")


def _told(asset: "Asset") -> dict[str, Any]:
    links = [
        {"name": link.name, "mass": link.mass, "triangles": sum(len(mesh.faces) for mesh in link.visuals),
         "colliders": len(link.colliders), "materials": sorted({mesh.material.name for mesh in link.visuals}),
         "joint": link.joint.model_dump(mode="json") if link.joint else None}
        for link in asset.links
    ]
    return {"library": asset.library, "id": asset.id, "category": asset.category, "style": asset.style,
            "size": list(asset.size), "credit": asset.credit, "links": links}


def _options(kind: str, scale: float | None, front: str | None) -> dict[str, Any]:
    """What the reader of that kind is told beyond the folder; BadInput for what it does not take."""
    from apartgen.stages import registry

    given = {name: value for name, value in (("scale", scale), ("front", front)) if value is not None}
    if given and kind in kinds():
        taken = inspect.signature(registry.load("apartgen.stages.retrieve", kind).assets).parameters
        if strange := sorted(set(given) - set(taken)):
            raise BadInput(f"--{strange[0]}: libraries of kind {kind!r} say that themselves; leave it out")
    return given


def commands() -> dict[str, Callable[..., Any]]:
    """The commands of this module."""
    return {"index": index, "check": check, "list": list_, "show": show, "preview": preview}
