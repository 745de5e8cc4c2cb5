"""The furnished plan as a picture, plan.png."""

from pathlib import Path

from apartgen.stages.export._drawing import sheet
from apartgen.stages.scene.scene import Scene

DPI = 160


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, plan.png."""
    path = out / "plan.png"
    sheet(scene).savefig(path, format="png", dpi=DPI, metadata={"Software": "apartgen"})
    return [path]
