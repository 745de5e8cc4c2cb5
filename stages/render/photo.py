"""Photographs of views by Blender's Cycles, in a process of its own: Blender's licence and ours do not mix."""

import json
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from apartgen.schemas.errors import BadInput
from apartgen.schemas.render import View
from apartgen.stages.scene.world import HomeWorld
from apartgen.stages.things.body import Body
from apartgen.stages.things.categories import TABLE, used_for

SCRIPT = Path(__file__).with_name("_cycles.py")
END = ".photo.png"
PLASTER, CLOTH = 0.6, 0.8
"""Roughness from which walls are of plaster and not of tiles, and what is patterned gives way and creases."""
LAST = 12
"""Lines of what Blender says that are told where it fails."""


def photographed(home: HomeWorld, glb: bytes, views: Sequence[View], program: str, samples: int, out: Path,
                 ) -> list[Path]:
    """Write NAME.photo.png into `out` for every view with a lens; BadInput where Blender cannot be run."""
    with tempfile.TemporaryDirectory() as folder:
        model, told = Path(folder) / "home.glb", Path(folder) / "job.json"
        model.write_bytes(glb)
        told.write_text(json.dumps(job(home, model, views, samples, Path(folder))), encoding="utf-8")
        _run(command(program, told))
        paths = []
        for view in (view for view in views if view.intrinsics):
            made = Path(folder) / (view.name + END)
            if not made.is_file():
                raise BadInput(f"--photo {program}: Blender ended without a picture of {view.name}")
            paths.append(out / made.name)
            paths[-1].write_bytes(made.read_bytes())
    return paths


def job(home: HomeWorld, glb: Path, views: Sequence[View], samples: int, out: Path) -> dict[str, object]:
    """What Blender is told: cameras, the way to the sun, and windows through which light comes."""
    cameras = [{"name": view.name, "pose": view.pose, "fx": view.intrinsics[0], "width": view.width,
                "height": view.height} for view in views if view.intrinsics]
    panes = [[side.tolist() for side in (pane.corner, pane.across, pane.up, pane.normal)] for pane in home.panes]
    return {"glb": str(glb), "out": str(out), "views": cameras, "sun": home.sun.tolist(), "panes": panes,
            "uneven": uneven(home.bodies), "lamps": lamps(home.bodies), "shades": shades(home.bodies),
            "samples": samples, "threads": 0}


def uneven(bodies: Sequence[Body]) -> dict[str, str]:
    """By name, what materials are of that are not quite flat: plaster of walls and ceilings, cloth that is rough, and
    what lies on beds."""
    found: dict[str, str] = {}
    for body in bodies:
        for material in (mesh.material for link in body.links for mesh in link.visuals):
            if body.kind in ("wall", "ceiling", "lining") and material.roughness >= PLASTER:
                found.setdefault(material.name, "plaster")
            elif body.kind == "object" and material.texture and material.roughness >= CLOTH:
                found.setdefault(material.name, "bedding" if body.category in used_for("sleep") else "cloth")
    return found


def lamps(bodies: Sequence[Body]) -> list[str]:
    """Names of bodies that give light."""
    return [body.name for body in bodies if body.category in TABLE and TABLE[body.category].lumens > 0]


def shades(bodies: Sequence[Body]) -> list[str]:
    """What lamps have that light goes through: paper and cloth."""
    lit = set(lamps(bodies))
    return sorted({mesh.material.name for body in bodies if body.name in lit for link in body.links
                   for mesh in link.visuals if mesh.material.roughness >= CLOTH})


def command(program: str, told: Path) -> list[str]:
    """The command line, of Blender itself or of a Python that has it as a package."""
    if Path(program).name.lower().startswith("blender"):
        return [program, "-b", "--factory-startup", "-P", str(SCRIPT), "--", str(told)]
    return [program, str(SCRIPT), str(told)]


def _run(line: list[str]) -> None:
    try:
        done = subprocess.run(line, capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise BadInput(f"--photo {line[0]}: cannot be run ({error.strerror or error}); give a Python that has the "
                       "package bpy, or the program blender") from None
    if done.returncode:
        last = "\n".join((done.stdout + done.stderr).strip().splitlines()[-LAST:])
        raise BadInput(f"--photo {line[0]}: Blender failed:\n{last}")
