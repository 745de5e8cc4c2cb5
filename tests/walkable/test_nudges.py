"""Small shifts of what stands free, short ones first, and of seats under their tables."""

from types import SimpleNamespace

import boxes_library as fake
import handmade as h
import numpy as np
import pytest

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.space import polygons
from apartgen.stages.walkable import WalkableConfig
from apartgen.stages.walkable.nudge import nudges
from apartgen.stages.walkable.site import fits, survey


def test_shifts_go_as_far_to_one_side_as_to_the_other() -> None:
    table = h.thing("coffee_table", 2.0, 1.5, 0.3, size=(0.6, 0.8, 0.4))
    home = h.home(table)
    site = SimpleNamespace(floors={room.id: polygons.floor(room) for room in home.rooms})
    moved = np.array([changes[table.id].center for changes in nudges(site, home.objects, table)]) - table.center
    ways = {tuple(way) for way in np.round(moved[:, :2], 6).tolist()}
    assert ways == {(-x, -y) for x, y in ways} and len(ways) == len(moved) > 20
    far = np.hypot(moved[:, 0], moved[:, 1])
    assert (np.diff(far) > -1e-9).all() and far[0] > 0


@pytest.mark.parametrize("yaw", [0.0, 0.7])
def test_a_seat_goes_under_its_table_and_its_back_stays_out(yaw: float) -> None:
    """A chair .5 m deep, its back as deep as .15 of that, before a table 0.8 m deep: .425 m of it may go under."""
    c, s = np.cos(yaw), np.sin(yaw)
    table = h.thing("dining_table", 3.0, 2.0, yaw, size=(0.8, 1.2, 0.75))

    def chair(under: float, tall: float = 0.9) -> Furnishing:
        away = 0.65 - under
        return h.thing("chair", 3.0 - away * c, 2.0 - away * s, yaw, size=(0.5, 0.45, tall), id="chair")

    home = h.home(table, chair(0.0))
    site = survey(home, WalkableConfig(), fake.Boxes())
    for under, tall, ok in ((0.2, 0.9, True), (0.42, 0.9, True), (0.44, 0.9, False), (0.44, 0.7, True)):
        now = chair(0.0, tall)
        assert fits(site, (table, now), {"chair": chair(under, tall)}) == ok, under
    # Nor is the table drawn over it; what stood too deep before may stay.
    near = h.thing("dining_table", 3.0 - 0.44 * c, 2.0 - 0.44 * s, yaw, size=(0.8, 1.2, 0.75), id=table.id)
    assert not fits(site, (table, chair(0.0)), {table.id: near})
    assert fits(site, (table, chair(0.5)), {"chair": chair(0.48)})
