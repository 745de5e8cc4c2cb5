"""What hangs on walls: what goes along with what stands below it, and how far it may be raised."""

from types import SimpleNamespace
from typing import Any

import handmade as h
import numpy as np
import pytest
from shapely.geometry import Polygon

from apartgen.stages.walkable.places import hung, places
from apartgen.stages.walkable.unblock import _raised

NORTH = -np.pi / 2


@pytest.mark.parametrize("yaw, x, along", [
    (NORTH, 2.0, True), (0.0, 2.0, False), (np.pi / 2, 2.0, False),  # on the same wall, and on others
    (NORTH, 4.0, False),  # too far off
])
def test_a_mirror_over_a_basin_goes_along_with_it(yaw: float, x: float, along: bool) -> None:
    basin = h.thing("vanity", 2.0, 2.7, NORTH, size=(0.5, 0.8, 0.85), id="basin")
    mirror = h.thing("mirror", x, 2.9, yaw, size=(0.04, 0.6, 0.8), id="mirror")
    mirror = mirror.model_copy(update={"center": (x, 2.9, 1.6)})
    assert [o.id for o in hung(basin, (basin, mirror))] == (["mirror"] if along else [])


def test_what_hangs_is_raised_and_lowered_within_the_room() -> None:
    """A shelf of 25 cm an eighth of a metre above the floor, in a room half a metre high."""
    shelf = h.thing("wall_shelf", 2.0, 2.9, NORTH, size=(0.25, 0.6, 0.25), id="shelf")
    shelf = shelf.model_copy(update={"center": (2.0, 2.9, 0.25)})
    site: Any = SimpleNamespace(world=SimpleNamespace(plan=SimpleNamespace(height=0.5)))
    for bottom, ways in ((0.125, {0.05, -0.05, 0.1, -0.1}), (0.0, {0.05, 0.1, 0.2})):
        there = shelf.model_copy(update={"center": (2.0, 2.9, bottom + 0.125)})
        moved = [changes["shelf"] for changes in _raised(site, (there,), there)]
        assert {round(o.center[2] - there.center[2], 3) for o in moved if o is not None} == ways


def test_to_the_floor_is_within_the_room() -> None:
    """Numbers that add up without rounding: down by .05 from a bottom at .05."""
    low = 0.05
    shelf = h.thing("wall_shelf", 2.0, 2.9, NORTH, size=(0.25, 0.6, 2 * low), id="shelf")
    shelf = shelf.model_copy(update={"center": (2.0, 2.9, 2 * low)})
    site: Any = SimpleNamespace(world=SimpleNamespace(plan=SimpleNamespace(height=2.5)))
    lowered = [changes["shelf"].center[2] for changes in _raised(site, (shelf,), shelf)]  # type: ignore[union-attr]
    assert min(lowered) == pytest.approx(low)


def test_a_unit_of_a_run_has_no_other_place() -> None:
    """Beside its neighbour it stays where it is; alone, or no unit, it may go elsewhere along the walls."""
    room = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    site: Any = SimpleNamespace(floors={"room": Polygon(room)}, doors=Polygon())
    sink, base = (h.thing(name, x, 2.7, NORTH, size=(0.6, 0.6, 0.9), id=name).model_copy(update={"room": "room"})
                  for name, x in (("kitchen_sink", 1.0), ("kitchen_base", 1.6)))
    far = base.model_copy(update={"center": (3.0, 2.7, 0.45)})
    assert not list(places(site, (sink, base), sink)) and not list(places(site, (sink, base), base))
    for scene in ((sink,), (sink, far)):
        assert list(places(site, scene, sink))


@pytest.mark.parametrize("others, stays", [
    (("kitchen_base",), True), (("washing_machine", "kitchen_base"), True), (("dryer",), False), ((), False)])
def test_a_fridge_stays_in_the_run_that_it_is_part_of(others: tuple[str, ...], stays: bool) -> None:
    """Also beside what is no unit itself, but not where there is no run."""
    room = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    site: Any = SimpleNamespace(floors={"room": Polygon(room)}, doors=Polygon())
    scene = [h.thing(name, 1.0 + 0.6 * k, 2.7, NORTH, size=(0.6, 0.6, 0.9), id=name).model_copy(update={"room": "room"})
             for k, name in enumerate(("fridge", *others))]
    assert bool(list(places(site, tuple(scene), scene[0]))) != stays
