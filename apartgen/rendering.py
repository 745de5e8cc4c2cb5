"""Pictures with labels of an apartment, and photographs where they are asked for."""

from pathlib import Path
from time import perf_counter
from typing import Any

from pydantic import Field

from apartgen.outputs import opened_libraries
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.export import File
from apartgen.schemas.plan import Plan
from apartgen.schemas.render import Render
from apartgen.stages import render
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.render.photo import photographed
from apartgen.stages.scene.folder import add
from apartgen.steps import lane, made

VIEWS = "views.json"


class RenderSettings(RenderConfig):
    """What is rendered, and where assets are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries in use")
    photo: str = Field("", description="photographs of views at the height of eyes, too, by path tracing: a Python "
                                       "that has the package bpy, or the program blender")
    samples: int = Field(32, ge=1, le=4096, description="paths a pixel of photographs")


def rendered(read: Artifact[Any], settings: RenderSettings, seed: int | None, folder: Path) -> Render:
    """Write the pictures of one apartment and the list of them, views.json."""
    began, used = perf_counter(), read.made.seed if seed is None else seed
    rng = lane(used, "render", read.body)
    found = render.run(read.body, settings, rng, folder, opened_libraries(*settings.libraries).load_asset)
    if settings.photo:
        found = found.model_copy(update={"files": [*found.files, *_photographs(read.body, settings, found, folder)]})
    text, _ = artifact.finish(found, made("render", used, settings, read, perf_counter() - began))
    artifact.write(text, folder / VIEWS)
    return found


def _photographs(home: Plan, settings: RenderSettings, found: Render, folder: Path) -> list[File]:
    from apartgen.stages.export._gltf import packed
    from apartgen.stages.scene.scene import Scene
    from apartgen.stages.scene.world import world

    scene = Scene(home, opened_libraries(*settings.libraries).load_asset)
    around = world(scene)
    glb = packed(around.bodies, scene.lights, scene.credits)
    eyes = [view for view in found.views if view.kind == "eye"]
    paths = photographed(around, glb, eyes, settings.photo, settings.samples, folder)
    return [File(path=name, format="photo", sha256=digest) for name, digest in add(folder, paths).items()]
