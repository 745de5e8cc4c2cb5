"""What comes of looking at an apartment: a page to walk about in, and questions about its pictures."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import Field

from apartgen.outputs import MetricsSettings, measure, opened_libraries
from apartgen.rendering import RenderSettings, rendered
from apartgen.schemas import artifact, files
from apartgen.schemas.artifact import Artifact
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Plan
from apartgen.schemas.qa import Question
from apartgen.stages import qa
from apartgen.stages.qa import card
from apartgen.stages.qa.config import QaConfig
from apartgen.steps import BY, lane

if TYPE_CHECKING:
    from apartgen.stages.things.asset import Asset

CARD = "README.md"
FILM, RATE = 480, 5
"""Films that are asked about: pixels from left to right, frames a second."""
WHOLE, OURS = "apartment", "ours"
"""What is compared side by side: figures of whole homes, by our own definitions."""


class QaSettings(QaConfig):
    """What is asked, of which views, and where assets are found."""

    views: int = Field(12, ge=1, le=200, description="views at the height of eyes")
    frames: int = Field(16, ge=2, le=2000, description="frames along the robot's way")
    video: bool = Field(False, description="film the robot's way, too, there or back, and ask about it")
    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries in use")


def questioned(read: Artifact[Any], settings: QaSettings, seed: int | None, out: Path) -> list[Question]:
    """Write questions about one apartment, a line each, and their pictures into the folder beside them."""
    folder, used = out.with_suffix(""), read.made.seed if seed is None else seed
    back = bool(lane(used, "qa-film", read.body).integers(2))
    looks = RenderSettings(views=settings.views, frames=settings.frames, points=0, libraries=settings.libraries,
                           video=settings.video, back=back, film=FILM, rate=RATE)
    seen = rendered(read, looks, used, folder)
    found = qa.run(read.body, seen, settings, lane(used, "qa", read.body))
    qa.numbered(found, folder)
    artifact.write(qa.lines(found, folder.name), out)
    return found


def carded(folder: Path) -> Path | None:
    """Write what the files of questions in a folder hold beside them; None where somebody else's page has its name."""
    page = folder / CARD
    if page.exists() and card.MARK not in page.read_text(encoding="utf-8", errors="replace"):
        return None
    files = {path.name: [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
             for path in sorted(folder.glob("*.jsonl"))}
    artifact.write(card.text(files, BY), page)
    return page


def viewed(homes: Sequence[Artifact[Plan]], out: Path, libraries: Sequence[str] = ()) -> None:
    """Write a page with one home, or with several side by side and a table of their figures."""
    from apartgen.stages.export import html
    from apartgen.stages.scene.scene import Scene

    def load_asset(library: str, id: str) -> "Asset":
        return opened_libraries(*libraries).load_asset(library, id)

    scenes = [Scene(home.body, load_asset) for home in homes]
    artifact.write(html.page(scenes[0]) if len(scenes) == 1 else html.pair(scenes, _figures(homes)), out)


def sheeted(homes: Sequence[Artifact[Plan]], out: Path) -> None:
    """Write a picture with the plans of many homes, to one scale, with what was asked for."""
    from io import BytesIO

    from apartgen.stages.export._contact import contact

    picture = BytesIO()
    contact([home.body for home in homes]).save(picture, "PNG")
    try:
        files.replace(picture.getvalue(), out)
    except OSError as error:
        raise BadInput(f"{out}: cannot be written ({error.strerror or error}); give another path with -o") from None


def _figures(homes: Sequence[Artifact[Plan]]) -> list[list[str]]:
    """What metrics say of each whole home by our own definitions, a row each."""
    found = [{f"{v.name} ({v.unit})": v.value for v in measure(home.body, MetricsSettings()).values
              if v.of == WHOLE and v.version == OURS} for home in homes]
    names = dict.fromkeys(name for values in found for name in values)
    return [[name, *("" if (v := values.get(name)) is None else f"{v:.3g}" for values in found)] for name in names]
