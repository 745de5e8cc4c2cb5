"""More homes in the formats that are quickly written, more rooms furnished by rule, and other choices of furniture."""

import numpy as np
import pytest
from crowded import crowded
from digests import kept
from digests.test_layout_kept import single

from apartgen.schemas.base import ROOM_TYPES
from apartgen.stages import export, retrieve
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.space import boxes, convex
from apartgen.stages.things.asset import Collider

pytestmark = pytest.mark.wide

QUICK = ("elevations", "svg", "nav2", "procthor", "ifc", "glb", "usd")
CHOICES = {"sizes": {"latent_weight": 0.0, "tolerance": 0.1}, "looks": {"size_weight": 0.05, "static_cost": 0.0},
           "moving": {"static_cost": 40.0, "overshoot": 0.0, "tolerance": 0.9}}


@pytest.mark.parametrize("format", QUICK)
def test_files(format, tmp_path):
    """Of other pieces of two homes, doors among them; some stand in the way."""
    found = {}
    for name, k in (("flat", 1), ("studio", 0)):
        home = kept.home(name)
        few = home.model_copy(update={"objects": [o.model_copy(update={"on": None})
                                                  for o in home.objects[k::5 - 2 * (format in QUICK[:4])]]})
        made = export.run(few, [format], tmp_path / name, kept.load)
        found |= {f"{name} {file.path}": tmp_path / name / file.path for file in made.files}
    kept.same("export", f"wider {format}", {"all": list(found.items())})


@pytest.mark.parametrize("type", ROOM_TYPES)
def test_furnished_by_rule(type):
    kept.same("layout", f"furnished {type} otherwise", {str(seed): single(type, seed).objects for seed in range(3, 8)})


@pytest.mark.parametrize("case", CHOICES)
def test_choices(case):
    found = {}
    for name in ("studio", "kitchen", "bedroom", "study"):
        home = kept.home(name) if name == "studio" else crowded(30, name)
        found[name] = retrieve.run(home, RetrieveConfig(**CHOICES[case]), kept.lane("choices", name)).objects
    kept.same("retrieve", f"choices {case}", found)


def test_shapes_by_chance():
    """Boxes in rows and by themselves, flat and tall; hulls that meet or just do not."""
    found = {}
    for seed in range(4):
        rng = np.random.default_rng(seed)
        a, b = (boxes.Boxes(rng.uniform(-1, 1, (15, 3)), rng.uniform(0.02, 1.2, (15, 3)),
                            rng.choice([0, np.pi / 2, 0.3], 15)) for _ in range(2))
        points = rng.uniform(-2, 2, (20, 2))
        solids = [Collider(kind, rng.uniform(-0.4, 0.4, 3), rng.uniform(0.1, 0.6, 3), np.eye(3))
                  for kind in ("box", "cylinder", "sphere") for _ in range(3)]
        found[str(seed)] = [
            boxes.penetration(a, b), boxes.overlap_area(a, b), boxes.iou(a), boxes.gap(a, b), list(boxes.meeting(a)),
            boxes.distance(points, a), boxes.local(points, b), boxes.corners(a), [
                convex.meet(convex.of([one]), convex.of([other]), clear)
                for one in solids for other in solids for clear in (0.0, 0.05)]]
    kept.same("floor", "shapes by chance", found)
