"""Files, figures, pictures and questions of homes, as they were."""

import numpy as np
import pytest
from digests import kept
from export import sample

from apartgen.outputs import opened_libraries
from apartgen.schemas.populate import Populate
from apartgen.stages import export, metrics, qa, render, seeds
from apartgen.stages import populate as small
from apartgen.stages.export import view
from apartgen.stages.metrics import _distances
from apartgen.stages.populate.config import PopulateConfig
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.render.config import RenderConfig

pytestmark = pytest.mark.wide


@pytest.fixture(scope="module")
def studio() -> Populate:
    return small.run(kept.home("studio"), PopulateConfig(), kept.lane("populate", "studio"), opened_libraries())


def written(home, formats, folder, load):
    """What lies in the folder, by format."""
    made = export.run(home, formats, folder, load)
    return {file.path: folder / file.path for file in made.files}


@pytest.mark.parametrize("format", [name for name in export.formats() if name != "dxf"])  # has dates and ids
def test_files_of_the_sample(format, tmp_path, monkeypatch):
    monkeypatch.setattr(view, "PIXELS", 20_000)
    kept.same("export", f"sample {format}", written(sample.home(), [format], tmp_path / "out", sample.load))


@pytest.mark.parametrize("format", [name for name in export.formats() if name not in ("view", "dxf")])
def test_files_of_some_of_a_home(format, tmp_path):
    """A seventh of what stands in a house, so that much opens and little is written."""
    home = kept.home("house")
    some = [o for k, o in enumerate(home.objects) if k % 7 == 3 or o.category in ("hob", "bath", "round_table")]
    few = home.model_copy(update={"objects": [o.model_copy(update={"on": None}) for o in some]})
    kept.same("export", f"house {format}", {"all": list(written(few, [format], tmp_path / "out", kept.load).items())})


@pytest.mark.parametrize("name", kept.HOMES)
def test_figures(name):
    found = metrics.run(kept.home(name)).values
    names = dict.fromkeys(v.name for v in found)
    kept.same("metrics", name, {one: [v for v in found if v.name == one] for one in names})


def test_figures_of_sets():
    homes = [kept.home(name) for name in kept.HOMES]
    names = [name for name in metrics.names() if name not in ("fid", "kid", "sca")]
    found = metrics.compare(homes[:2], homes[1:], [
        name for name in names if metrics._of_rooms(name) or name in metrics._able("compare")])
    kept.same("metrics", "sets", {one: [v for v in found.values if v.name == one]
                                  for one in dict.fromkeys(v.name for v in found.values)})


def test_distances():
    rng = np.random.default_rng(1)
    a, b = rng.normal(size=(30, 6)), rng.normal(0.4, 1.2, size=(25, 6))
    kept.same("metrics", "distances", {"frechet": _distances.frechet(a, b, np.random.default_rng(0))})


@pytest.fixture(scope="module")
def views(tmp_path_factory, studio):
    out = tmp_path_factory.mktemp("views") / "views"
    config = RenderConfig(width=128, height=96, views=4, frames=5, points=300)
    return out, render.run(studio, config, seeds.drawn(1, "views"), out, kept.load)


def test_pictures(views):
    out, found = views
    kept.same("render", "studio", {file.path: out / file.path for file in found.files} | {"list": found.views})


def test_questions(studio, views):
    found = qa.run(studio, views[1], QaConfig(), kept.lane("qa"))
    kept.same("qa", "studio", {kind: [one for one in found if one.kind == kind] for kind in qa.every_kind()})
