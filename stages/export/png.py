"""The furnished plan as a picture, plan.png."""

from pathlib import Path

from apartgen.stages.export._drawing import sheet
from apartgen.stages.export._readback import read_images
from apartgen.stages.scene.scene import Scene

NEEDS_ASSETS = False

DPI = 160


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, plan.png."""
    path = out / "plan.png"
    sheet(scene).savefig(path, format="png", dpi=DPI, metadata={"Software": "apartgen"})
    return [path]


def read_back(files: list[Path]) -> None:
    """By Pillow."""
    read_images(files)
