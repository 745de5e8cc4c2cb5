"""The stages that advance an apartment, as programs run them: what each takes, how it is set, what it hangs on."""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import Field

from apartgen.schemas import plugins
from apartgen.schemas.artifact import Artifact, Made, kind_of
from apartgen.schemas.base import Record
from apartgen.schemas.errors import ApartgenError, BadInput, Unmet
from apartgen.schemas.layout import Layout
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Populate, without_things
from apartgen.schemas.retrieve import Retrieve
from apartgen.schemas.walkable import Walkable
from apartgen.stages import layout, seeds
from apartgen.stages.layout.config import LayoutConfig
from apartgen.stages.populate.config import PopulateConfig
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.walkable.config import WalkableConfig
from apartgen.version import __version__

if TYPE_CHECKING:
    from apartgen.stages.retrieve import LibrarySet

BY = f"apartgen {__version__}"
Outcome = Record | ApartgenError
Advance = Callable[[list[Any], Any, list[np.random.Generator]], Iterable[Outcome]]


@dataclass(frozen=True)
class Step:
    """One stage.

    `advance(bodies, config, rngs)` gives, for each body and in order, the next body or the error that prevents it.
    `missed(body, config)` says what a result that is written all the same falls short of. `data(config)` names the
    files, beside the input, that a result hangs on. Of a file that is a `rather` already, this is what is taken; one
    of a kind that it `refuses` is not taken at all.
    """

    word: str
    takes: type[Record]
    config: type[Record]
    advance: Advance
    missed: Callable[[Any, Any], Unmet | None] = lambda body, config: None
    data: Callable[[Any], Mapping[str, Path]] = lambda config: {}
    rather: type[Record] | None = None
    refuses: str = ""

    def taken(self, read: Artifact[Any]) -> Artifact[Any]:
        """What the stage takes of an artifact that was read whole; BadInput for one that it refuses."""
        if fault := self.refused(read.kind):
            raise fault
        home = without_things(read.body)
        read = replace(read, body=home, kind=kind_of(home))
        later = self.rather is not None and isinstance(home, self.rather)
        return read.taken_as(self.rather if later and self.rather else self.takes)

    def refused(self, kind: str) -> BadInput | None:
        """Why the stage does not take a file of that kind, where it does not."""
        if kind != self.refuses:
            return None
        return BadInput(f"a {kind} artifact: what stands in it would be left in the air; run `apartgen {self.word}` on "
                        f"the artifact that it was made from, then `apartgen {kind}`")


def each(step: Callable[[Any, Any, np.random.Generator], Record]) -> Advance:
    """An `Advance` out of a function of one body; an error of one leaves the others be."""

    def advance(bodies: list[Any], config: Any, rngs: list[np.random.Generator]) -> Iterator[Outcome]:
        for body, rng in zip(bodies, rngs):
            try:
                yield step(body, config, rng)
            except ApartgenError as error:
                yield error

    return advance


def lane(seed: int, word: str, home: Plan) -> np.random.Generator:
    """The random numbers of one stage for one apartment: the same alone or in a batch, under whatever name."""
    return seeds.drawn(seed, word, seeds.plan_digest(home))


_EVERYWHERE = ("categories", "rooms", "rules")
_BROUGHT = {"plan": ("imports",), "layout": ("guidance", "choice"), "retrieve": ("furniture",),
            "walkable": ("furniture",), "populate": ("furniture",), "export": ("furniture", "export"),
            "metrics": ("furniture", "metrics", "datasets"), "render": ("furniture",)}
"""What of other packages the result of a command hangs on, by the groups of their entry points."""


def brought(word: str) -> str:
    """Digest of what other packages bring that a command's result hangs on; empty where there are none."""
    return plugins.digest(*(plugins.PREFIX + group for group in (*_EVERYWHERE, *_BROUGHT.get(word, ()))))


def made(word: str, seed: int, config: Record, previous: Artifact[Any] | None = None, seconds: float = 0.0,
         data: Mapping[str, Path] | None = None) -> Made:
    """How a result of the command `word` came about."""
    inputs = {previous.kind: previous.digest} if previous else {}
    inputs |= {name: _digest(file) for name, file in (data or {}).items() if file.is_file()}
    inputs |= {"packages": packages} if (packages := brought(word)) else {}
    id = previous.made.id if previous else ""
    return Made(by=BY, id=id, seed=seed, config=config.model_dump(mode="json"), inputs=inputs,
                seconds=round(seconds, 2))


def _digest(file: Path) -> str:
    there = file.stat()
    return _digest_of(file, there.st_mtime_ns, there.st_size)


@cache
def _digest_of(file: Path, changed: int, size: int) -> str:
    return "sha256:" + hashlib.sha256(file.read_bytes()).hexdigest()


def furnish(plans: list[Plan], config: LayoutConfig, rngs: list[np.random.Generator]) -> Iterator[Outcome]:
    """The apartments, but those that ask for what no layout can have."""
    wrong = [_fault(plan) for plan in plans]
    good = [i for i, fault in enumerate(wrong) if fault is None]
    done = layout.run_many([plans[i] for i in good], config, [rngs[i] for i in good])
    for fault in wrong:
        yield fault or next(done)


def _fault(plan: Plan) -> ApartgenError | None:
    try:
        layout.check(plan)
    except ApartgenError as error:
        return error
    return None


def weights(config: LayoutConfig) -> dict[str, Path]:
    """The weights file; named without loading any, so that a finished layout is known again in no time."""
    folder = Path(layout.__file__).parent / ("relations" if config.model == "relations" else "")
    return {"weights": Path(config.weights) if config.weights else folder / "weights.safetensors"}


def match(home: Layout, config: RetrieveConfig, rng: np.random.Generator) -> Retrieve:
    """One apartment with an asset for every object."""
    from apartgen.stages import retrieve

    return retrieve.run(home, config, rng)


def libraries(config: RetrieveConfig) -> dict[str, Path]:
    """The index of the embedded library, and the table of every other."""
    from apartgen.stages.retrieve.matching.indexed import TABLE_FILE
    from apartgen.stages.things.latents import INDEX

    return {"parametric": INDEX} | {str(folder): Path(folder) / TABLE_FILE for folder in config.libraries}


class WalkableSettings(WalkableConfig):
    """The stage's settings, and where smaller assets are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries")


def clear(home: Retrieve, config: WalkableSettings, rng: np.random.Generator) -> Walkable:
    """One apartment with room to walk; BadInput where a library of its assets is not open."""
    from apartgen.stages import walkable

    found = _opened(config)
    for library, id in {o.asset.library: o.asset.id for o in home.objects}.items():
        found.load_asset(library, id)
    return walkable.run(home, config, rng, found)


def missed(home: Walkable, config: WalkableSettings) -> Unmet | None:
    """What the best apartment falls short of, when it was asked for all the same."""
    if not config.write_anyway:
        return None
    from apartgen.stages import walkable

    short = walkable.unmet(home, config, _opened(config))
    return Unmet(f"{short} (written as asked)") if short else None


def _opened(config: WalkableSettings) -> "LibrarySet":
    from apartgen.stages import retrieve

    return retrieve.shared_libraries(_as_retrieved(config))


def _as_retrieved(config: WalkableSettings) -> RetrieveConfig:
    return RetrieveConfig(libraries=config.libraries)


class PopulateSettings(PopulateConfig):
    """The stage's settings, and where the furniture's models are found."""

    libraries: list[str] = Field(default_factory=list, description="folders of indexed asset libraries")


def fill(home: Retrieve, config: PopulateSettings, rng: np.random.Generator) -> Populate:
    """One apartment with its small things; BadInput where a library of its assets is not open."""
    from apartgen.stages import populate, retrieve

    return populate.run(home, config, rng, retrieve.shared_libraries(RetrieveConfig(libraries=config.libraries)))


def tables(config: PopulateSettings) -> dict[str, Path]:
    """The table of every library that furniture is from."""
    every = libraries(RetrieveConfig(libraries=config.libraries))
    return {folder: every[folder] for folder in config.libraries}


LAYOUT = Step("layout", Plan, LayoutConfig, furnish, data=weights, rather=Layout)
RETRIEVE = Step("retrieve", Layout, RetrieveConfig, each(match), data=libraries)
WALKABLE = Step("walkable", Retrieve, WalkableSettings, each(clear), missed,
                lambda config: libraries(_as_retrieved(config)), refuses="populate")
POPULATE = Step("populate", Retrieve, PopulateSettings, each(fill), data=tables, rather=Walkable)
STEPS = (LAYOUT, RETRIEVE, WALKABLE, POPULATE)
"""The stages after the plan, in order."""
