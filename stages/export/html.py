"""The apartment to walk about in, one page for any browser, apartment.html: doors and drawers open at a click.

The page holds everything: the scene as GLB, and the viewer, which is `_viewer/main.js` with three.js, bundled by
`npm install && npm run build` in that folder. It works from a disk, without a network.
"""

import base64
import html
from pathlib import Path
from string import Template

from apartgen.stages.export._gltf import packed
from apartgen.stages.scene.scene import Scene

VIEWER = Path(__file__).parent / "_viewer"


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, apartment.html."""
    path = out / "apartment.html"
    page = Template((VIEWER / "page.html").read_text(encoding="utf-8"))
    text = page.substitute(
        title=html.escape(scene.home.prompt or "apartment"),
        scene=base64.b64encode(packed(scene.bodies, scene.lights, scene.credits)).decode(),
        program=(VIEWER / "bundle.js").read_text(encoding="utf-8"),
        licence=(VIEWER / "three-license.txt").read_text(encoding="utf-8"),
    )
    path.write_text(text, encoding="utf-8")
    return [path]
