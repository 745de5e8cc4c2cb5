"""From a sentence to a furnished, simulation-ready apartment.

    >>> import apartgen
    >>> home = apartgen.plan("studio", seed=7)
    >>> [room.type for room in home.body.rooms][:1]
    ['living_room']

Every function takes an apartment as what an earlier one gave, or as the path of its file, and gives the next artifact:
its `body`, how it was `made`, its `digest`; `save(path)` writes it. Settings are keywords, named as in a settings file.
What a user can get wrong raises `BadInput`, what cannot be met `Unmet`, both an `ApartgenError`.
"""

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from apartgen import compiled
from apartgen.version import __version__ as __version__

if TYPE_CHECKING:
    from apartgen.schemas.artifact import Artifact
    from apartgen.schemas.export import Export
    from apartgen.schemas.layout import Layout
    from apartgen.schemas.metrics import Metrics
    from apartgen.schemas.plan import Plan
    from apartgen.schemas.populate import Populate
    from apartgen.schemas.qa import Question
    from apartgen.schemas.render import Render
    from apartgen.schemas.retrieve import Retrieve
    from apartgen.schemas.walkable import Walkable
    from apartgen.settings import Home
    from apartgen.stages.check import Fault
    from apartgen.steps import Step

__all__ = ["check", "export", "layout", "load", "make", "metrics", "plan", "populate", "qa", "render", "retrieve",
           "view", "walkable"]

compiled.keep()



def load(path: str | PathLike[str]) -> "Artifact[Any]":
    """The artifact in a file, of whatever kind; older versions are migrated. BadInput where there is none."""
    from apartgen.settings import opened

    return opened(path)


def plan(text: str, *, seed: int = 0, **settings: Any) -> "Artifact[Plan]":
    """A floor plan for a sentence. Unmet where what is asked for contradicts itself."""
    from apartgen.settings import planned

    return planned(text, seed, settings)


def layout(home: "Home", *, seed: int | None = None, **settings: Any) -> "Artifact[Layout]":
    """The plan with furniture: an oriented box and a shape latent for every object."""
    from apartgen.steps import LAYOUT

    return _advanced(LAYOUT, home, seed, settings)


def retrieve(home: "Home", *, seed: int | None = None, **settings: Any) -> "Artifact[Retrieve]":
    """The layout with a real asset, its joints and its size for every object."""
    from apartgen.steps import RETRIEVE

    return _advanced(RETRIEVE, home, seed, settings)


def walkable(home: "Home", *, seed: int | None = None, **settings: Any) -> "Artifact[Walkable]":
    """The home with room to walk. Unmet, naming the rooms, where a robot does not get everywhere."""
    from apartgen.steps import WALKABLE

    return _advanced(WALKABLE, home, seed, settings)


def populate(home: "Home", *, seed: int | None = None, **settings: Any) -> "Artifact[Populate]":
    """The home with the small things that people keep on and in their furniture, and what hangs on their walls."""
    from apartgen.steps import POPULATE

    return _advanced(POPULATE, home, seed, settings)


def metrics(home: "Home", *, metric: Sequence[str] = ()) -> "Metrics":
    """The figures of one apartment; those of these names only, where some are named."""
    from apartgen.outputs import MetricsSettings, measure
    from apartgen.settings import opened

    return measure(opened(home).body, MetricsSettings(metric=list(metric)))


def check(home: "Home", *, strict: bool = False) -> "list[Fault]":
    """What is wrong with a home, each fault with a witness; it is right where none `refuses`."""
    from apartgen.checking import judged

    return judged(home, strict)


def export(home: "Home", out: str | PathLike[str], formats: Sequence[str], *,
           libraries: Sequence[str] = (), colliders: str = "exact", randomize: bool = False,
           seed: int | None = None) -> "Export":
    """Write a home's files for simulators, viewers and people into the folder `out`, whole or not at all; with
    `primitive` colliders hulls are boxes; with `randomize` masses, friction and damping are drawn by the seed within
    the ranges of their kinds.
    """
    from apartgen.outputs import ExportSettings, finished
    from apartgen.settings import configured, opened

    given = {"format": list(formats), "libraries": list(libraries), "randomize": randomize, "colliders": colliders}
    return finished(opened(home), configured(ExportSettings, given), Path(out), seed)


def view(homes: "Home | Sequence[Home]", out: str | PathLike[str], *, libraries: Sequence[str] = ()) -> None:
    """Write a page to walk about in a home, or one with two homes side by side and their figures."""
    from apartgen.schemas.artifact import Artifact
    from apartgen.settings import opened
    from apartgen.viewing import viewed

    several = [homes] if isinstance(homes, str | PathLike | Artifact) else homes
    viewed([opened(home) for home in several], Path(out), libraries)


def render(home: "Home", out: str | PathLike[str], *, seed: int | None = None, **settings: Any) -> "Render":
    """Write pictures of a home with labels into the folder `out`, whole or not at all."""
    from apartgen.rendering import RenderSettings, rendered
    from apartgen.settings import configured, opened

    return rendered(opened(home), configured(RenderSettings, settings), seed, Path(out))


def qa(home: "Home", out: str | PathLike[str], *, seed: int | None = None, **settings: Any) -> "list[Question]":
    """Write questions about a home, a line of JSON each, and the pictures that answer them into the folder beside."""
    from apartgen.settings import configured, opened
    from apartgen.viewing import QaSettings, questioned

    return questioned(opened(home), configured(QaSettings, settings), seed, Path(out))


def make(text: str, out: str | PathLike[str], *, seed: int = 0, formats: Sequence[str] | None = None,
         populate: bool = True, settings: "dict[str, dict[str, Any]] | None" = None) -> "Artifact[Walkable | Populate]":
    """All of it, into the folder `out`, going on where an earlier run was stopped; `settings` by stage. With `populate`
    small things are put into the home.
    """
    from apartgen import whole
    from apartgen.planning import checked
    from apartgen.settings import by_stage

    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    chosen = by_stage(settings or {}, list(formats or whole.DEFAULT_FORMATS))
    if not populate:
        del chosen["populate"]
    for _ in whole.make(checked(text), folder, seed, chosen):
        pass
    return load(folder / ("populate.json" if populate else "walkable.json"))


def _advanced(step: "Step", home: Any, seed: int | None, settings: dict[str, Any]) -> "Artifact[Any]":
    from apartgen.settings import advanced

    return advanced(step, home, seed, settings)
