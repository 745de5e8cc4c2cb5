"""Every piece of furniture in every style, and what is chosen for boxes, as they were."""

import numpy as np
import pytest
from digests import kept

from apartgen.stages import retrieve
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.things import categories

pytestmark = pytest.mark.wide

FAMILIES = sorted({name[0] for name in categories.TABLE})


@pytest.mark.parametrize("letter", FAMILIES)
def test_furniture(letter):
    """Two sizes of every style, of all categories that begin with a letter."""
    found = {}
    for name in [name for name in categories.TABLE if name[0] == letter]:
        kind, rng = categories.TABLE[name], np.random.default_rng(len(name))
        for style in furniture.styles(name):
            drawn = tuple(float(side) for side in rng.uniform(kind.min, kind.max).round(3))
            found[f"{name}/{style}"] = [furniture.build(name, style, size, seed)
                                        for seed, size in enumerate((kind.size, drawn))]
    kept.same("retrieve", f"furniture {letter}", found)


@pytest.mark.parametrize("name", kept.HOMES)
def test_choice(name):
    home = kept.home(name)
    rng = kept.lane("sizes", name)
    other = home.model_copy(update={"objects": [
        o.model_copy(update={"size": tuple(np.multiply(o.size, rng.uniform(0.8, 1.2, 3)).round(3).tolist())})
        for o in home.objects]})
    for case, body in (("same", home), ("other", other)):
        found = retrieve.run(body, RetrieveConfig(), kept.lane("retrieve", name))
        kept.same("retrieve", f"{name} {case}", {
            one.id: [o for o in found.objects if o.room == one.id] for one in found.rooms})
