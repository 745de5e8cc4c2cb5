"""Episodes of an earlier run as data sets to learn from: each is run again, and kept where it succeeds."""

from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from apartgen.schemas.errors import BadInput

if TYPE_CHECKING:
    from apartgen.stages.embodied.lerobot import Episode, Half
    from apartgen.stages.embodied.outcome import Outcome
    from apartgen.stages.embodied.world import World


def demonstrated(runs: "Iterable[tuple[World, Half, list[Outcome]]]", folder: Path) -> list[Path]:
    """Write `folder`/navigation and `folder`/interaction, of apartments' episodes; BadInput where none succeeds."""
    from apartgen.stages.embodied import lerobot
    from apartgen.stages.scene.folder import CONTENTS, listed, replaced

    found: dict[lerobot.Half, list[Episode]] = {"navigation": [], "interaction": []}
    for apartment, half, outcomes in runs:
        found[half] += _succeeded(apartment, outcomes)
    found = {half: episodes for half, episodes in found.items() if episodes}
    if not found:
        raise BadInput("--lerobot: no episode of these apartments succeeds; there is nothing to write")
    with replaced(folder) as fresh:
        files = [file for half, episodes in found.items() for file in lerobot.write(half, episodes, fresh / half)]
        digests = [(file.relative_to(fresh).as_posix(), sha256(file.read_bytes()).hexdigest()) for file in files]
        (fresh / CONTENTS).write_text(listed(digests, "bench embodied --lerobot"), encoding="utf-8")
    return [folder / half for half in found]


def _succeeded(apartment: "World", outcomes: "list[Outcome]") -> "list[Episode]":
    """What succeeded, in words."""
    from apartgen.stages.embodied.instructions import task
    from apartgen.stages.embodied.lerobot import Episode

    return [Episode(task(apartment, o), o.id, o.course) for o in outcomes if o.success and o.course is not None]
