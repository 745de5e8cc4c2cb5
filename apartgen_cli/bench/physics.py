"""Physical soundness: how many things stay where they stand, how far doors and drawers can be driven."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from apartgen.schemas.retrieve import Retrieve
from apartgen.stages.metrics import _physics
from apartgen_cli.bench import _scenes

PAPER: list[dict[str, Any]] = []
NOTE = (
    "The exported MJCF in MuJoCo. Stays: loose things that drift less than 5 cm in 2 s. Travel: the share of its range "
    "over which each hinge and slide can be driven, with no more than 15 N or N m, nothing within 4 m driven with it, "
    "all else free to move; opened: at least 95 % of it. The paper does not measure this; SAGE reports 99.8 % stable, "
    "SceneSmith 96 %."
)
SETTINGS = ["no guidance", "all guidance + projection", "+ walkable"]
SCENES, CHUNK = 100, 5
FIGURES = ["stays", "drift, m", "travel", "opened"]


def trial(setting: str, seed: int, scenes: int, work: Path) -> list[dict[str, Any]]:
    """A record an apartment."""
    from apartgen.stages import retrieve, walkable
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.walkable.config import WalkableConfig

    homes = _scenes.plans(seed, scenes, work)
    method = setting if setting in _scenes.METHODS else "all guidance + projection"
    library = retrieve.open_libraries(RetrieveConfig())
    found = []
    for i, made in enumerate(_scenes.furnished(homes, _scenes.config(method), seed)):
        home = _scenes.retrieved(made, seed)
        if setting == "+ walkable":
            home = walkable.run(home, WalkableConfig(write_anyway=True), np.random.default_rng([seed, i]), library)
        found.append(_measured(home))
    return found


def _measured(home: Retrieve) -> dict[str, Any]:
    """Shares over the things of an apartment; what it has none of is left out."""
    from apartgen.stages import registry, retrieve
    from apartgen.stages.retrieve.matching.config import RetrieveConfig
    from apartgen.stages.scene.scene import Scene

    scene = Scene(home, retrieve.open_libraries(RetrieveConfig()).load_asset)
    with TemporaryDirectory() as folder:
        registry.load("apartgen.stages.export", "mjcf").write(scene, Path(folder))
        model = _physics.mjcf_model(Path(folder) / "mjcf" / "apartment.xml")
    drift = np.array(list(_physics.drift(model).values()))
    share = np.array([travel.share for travel in _physics.travels(model)])
    found: dict[str, Any] = {"loose": len(drift), "joints": len(share)}
    if len(drift):
        found |= {"stays": float((drift <= _physics.DRIFT).mean()), "drift, m": float(drift.mean())}
    if len(share):
        found |= {"travel": float(share.mean()), "opened": float((share >= _physics.REACHED).mean())}
    return found


def rows(records: list[dict[str, Any]], rng: np.random.Generator) -> list[dict[str, Any]]:
    """Means over apartments."""
    return _scenes.intervals(records, SETTINGS, FIGURES, rng)


def draw(rows: list[dict[str, Any]], axes: Any) -> None:
    """What stays and what opens, with intervals."""
    _scenes.bars(rows, ["stays", "travel", "opened"], axes)
    axes.set_ylim(0, 1.03)
