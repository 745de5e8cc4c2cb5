"""The furnished apartment seen from above, its walls cut off at 1.5 m, as a picture, view.png."""

from pathlib import Path

from apartgen.stages.export._render import picture
from apartgen.stages.scene.scene import Scene


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, view.png; needs no graphics card."""
    from PIL import Image

    path = out / "view.png"
    Image.fromarray(picture(scene)).save(path, "PNG")
    return [path]
