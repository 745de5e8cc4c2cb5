"""What comes of looking at an apartment: pictures with labels, and questions about them."""

from pathlib import Path
from time import perf_counter

from pydantic import Field

from apartgen.outputs import opened_libraries
from apartgen.schemas import artifact
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.plan import Plan
from apartgen.schemas.render import Render
from apartgen.stages import render
from apartgen.stages.render.config import RenderConfig
from apartgen.steps import lane, made

VIEWS = "views.json"


class RenderSettings(RenderConfig):
    """What is rendered, and where assets are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries in use")


def rendered(read: Artifact[Plan], settings: RenderSettings, seed: int | None, folder: Path) -> Render:
    """Write the pictures of one apartment and the list of them, views.json."""
    began, used = perf_counter(), read.made.seed if seed is None else seed
    rng = lane(used, "render", read.body)
    found = render.run(read.body, settings, rng, folder, opened_libraries(*settings.libraries).load_asset)
    text, _ = artifact.finish(found, made(used, settings, read, perf_counter() - began))
    artifact.write(text, folder / VIEWS)
    return found
