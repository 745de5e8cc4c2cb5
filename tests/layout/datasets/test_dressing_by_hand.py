"""What the furnisher keeps free before what it hangs."""

from types import SimpleNamespace

import numpy as np
import pytest

from apartgen.stages.layout.datasets._furnish import dressing


@pytest.mark.parametrize("name", ["wall_shelf", "mirror"])
def test_before_what_hangs_as_much_is_free_as_it_is_wide(name, monkeypatch) -> None:
    asked = []
    monkeypatch.setattr(dressing.anchors, "walls", lambda space, group, turns: asked.append(group) or ())
    space = SimpleNamespace(rng=np.random.default_rng(3), shape=SimpleNamespace(height=2.6))
    assert not dressing.on_wall(space, name)
    (group,) = asked
    (part,), (zone,) = group.parts, group.zones
    assert (zone.y0, zone.y1) == pytest.approx((-part.size[1] / 2, part.size[1] / 2))
    assert zone.x1 == pytest.approx(part.size[0] + 0.4) and zone.x0 < part.size[0]
