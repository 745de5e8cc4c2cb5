"""The apartment to walk about in, one page for any browser, apartment.html: doors and drawers open at a click.

The page holds everything: the scene as GLB, what is known of it, and the viewer, which is `_viewer/src` with three.js,
bundled by `npm install && npm run build` in that folder. It works from a disk, without a network.
"""

import base64
import html
import io
import json
import re
from collections.abc import Sequence
from pathlib import Path
from string import Template

from apartgen.stages.export._gltf import packed
from apartgen.stages.export._readback import Refused, read_glb
from apartgen.stages.export._told import told
from apartgen.stages.scene.scene import Scene

VIEWER = Path(__file__).parent / "_viewer"
MARK = "/* the viewer */"
"""What stands for the program in pages that share one."""


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, apartment.html."""
    path = out / "apartment.html"
    path.write_text(page(scene), encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """What the page holds: the scene by trimesh, what is known of it by the parser of JSON."""
    scene, facts = (_held(files[0], id) for id in ("scene", "told"))
    read_glb([io.BytesIO(base64.b64decode(scene, validate=True))])
    json.loads(facts)


def _held(page: Path, id: str) -> str:
    found = re.search(rf'<script id="{id}"[^>]*>([^<]*)</script>.*</html>', page.read_text(encoding="utf-8"), re.DOTALL)
    if found is None:
        raise Refused(f"{page.name} has no {id}, or breaks off")
    return found[1]


def page(scene: Scene) -> str:
    """One home."""
    return _page(scene, _text("bundle.js"))


def pair(scenes: Sequence[Scene], rows: Sequence[Sequence[str]]) -> str:
    """Homes side by side, with a table of `rows`: what is measured, and a figure for each."""
    titles = [_title(scene) for scene in scenes]
    pages = [{"title": title, "page": _page(scene, MARK)} for title, scene in zip(titles, scenes)]
    return Template(_text("pair.html")).substitute(
        title=html.escape(" | ".join(titles)),
        heads="".join(f'<th scope="col">{html.escape(title)}</th>' for title in titles),
        rows="\n".join(map(_row, rows)), pages=_inside(pages), mark=MARK,
        program=base64.b64encode(_text("bundle.js").encode()).decode(),
        licence=_text("three-license.txt"),
    )


def _page(scene: Scene, program: str) -> str:
    return Template(_text("page.html")).substitute(
        title=html.escape(_title(scene)),
        scene=base64.b64encode(packed(scene.bodies, scene.lights, scene.credits)).decode(),
        facts=_inside(told(scene.home)), program=program, licence=_text("three-license.txt"),
    )


def _row(row: Sequence[str]) -> str:
    name, *values = (html.escape(cell) for cell in row)
    return f'<tr><th scope="row">{name}</th>{"".join(f"<td>{value}</td>" for value in values)}</tr>'


def _title(scene: Scene) -> str:
    return scene.home.prompt or "apartment"


def _inside(value: object) -> str:
    """JSON that can stand in a page."""
    return json.dumps(value, separators=(",", ":")).replace("<", "\\u003c")


def _text(name: str) -> str:
    return (VIEWER / name).read_text(encoding="utf-8")
