"""Episodes of an earlier run as data sets to learn from: each is run again, and kept where it succeeds."""

from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from apartgen.schemas.errors import BadInput
from apartgen_cli.bench import embodied

if TYPE_CHECKING:
    from apartgen.stages.embodied.lerobot import Episode
    from apartgen.stages.embodied.outcome import Outcome
    from apartgen.stages.embodied.world import World


def demonstrated(out: Path, folder: Path) -> list[Path]:
    """Write `folder`/navigation and `folder`/interaction, of all apartments in `out`/homes; BadInput without any."""
    from apartgen.stages.embodied import lerobot
    from apartgen.stages.scene.folder import CONTENTS, listed, replaced

    files = sorted((out / embodied.HOMES).glob("*.json"))
    if not files:
        raise BadInput(f"--lerobot: no apartments in {out / embodied.HOMES}; run `apartgen bench embodied -o {out}`")
    found: dict[lerobot.Half, list[Episode]] = {"navigation": [], "interaction": []}
    for file in files:
        with embodied._exported(embodied._read(file), bare=True) as (scene, mjcf):
            apartment = embodied.simulated(scene, mjcf, file.stem)
            found["navigation"] += _succeeded(apartment, embodied._navigation(apartment, None))
            found["interaction"] += _succeeded(apartment, embodied._interaction(apartment, None))
    found = {half: episodes for half, episodes in found.items() if episodes}
    if not found:
        raise BadInput(f"--lerobot: no episode of {out / embodied.HOMES} succeeds; there is nothing to write")
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
