"""Small shifts of what stands free: as far to one side as to the other, short ones first."""

from types import SimpleNamespace

import handmade as h
import numpy as np

from apartgen.stages.space import polygons
from apartgen.stages.walkable.nudge import nudges


def test_shifts_go_as_far_to_one_side_as_to_the_other() -> None:
    table = h.thing("coffee_table", 2.0, 1.5, 0.3, size=(0.6, 0.8, 0.4))
    home = h.home(table)
    site = SimpleNamespace(floors={room.id: polygons.floor(room) for room in home.rooms})
    moved = np.array([changes[table.id].center for changes in nudges(site, home.objects, table)]) - table.center
    ways = {tuple(way) for way in np.round(moved[:, :2], 6).tolist()}
    assert ways == {(-x, -y) for x, y in ways} and len(ways) == len(moved) > 20
    far = np.hypot(moved[:, 0], moved[:, 1])
    assert (np.diff(far) > -1e-9).all() and far[0] > 0
