"""The furnished plan as a vector drawing, plan.svg."""

from pathlib import Path

import matplotlib

from apartgen.stages.export._drawing import figure
from apartgen.stages.scene.scene import Scene


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, plan.svg; text is outlines, so that it looks the same everywhere."""
    path = out / "plan.svg"
    with matplotlib.rc_context({"svg.hashsalt": "apartgen", "svg.fonttype": "path"}):
        figure(scene.home).savefig(path, format="svg", metadata={"Date": None, "Creator": "apartgen"})
    return [path]
