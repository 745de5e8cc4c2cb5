"""The furnished plan as a vector drawing, plan.svg."""

import io
from pathlib import Path

import matplotlib

from apartgen.stages.export._drawing import sheet
from apartgen.stages.export._layers import grouped
from apartgen.stages.export._readback import read_xml
from apartgen.stages.scene.scene import Scene

NEEDS_ASSETS = False


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, plan.svg; text is text, and every layer and thing has a group of its name."""
    path, drawn = out / "plan.svg", io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "apartgen", "svg.fonttype": "none"}):
        sheet(scene).savefig(drawn, format="svg", metadata={"Date": None, "Creator": "apartgen"})
    path.write_text(grouped(drawn.getvalue()), encoding="utf-8")
    return [path]


def read_back(files: list[Path]) -> None:
    """By the parser of XML."""
    read_xml(files[0])
