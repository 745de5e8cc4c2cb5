"""Where objects may move: along walls with their company, off doors, windows and walls; against shapely and by hand."""

from typing import Any

import boxes_library as fake
import handmade as h
import numpy as np
import pytest
import shapely
from shapely.affinity import rotate, translate
from shapely.geometry import Polygon

from apartgen.stages.space import convex
from apartgen.stages.things.solids import slab
from apartgen.stages.walkable import WalkableConfig, places
from apartgen.stages.walkable.changes import applied, dropped, nudged
from apartgen.stages.walkable.leaves import INTO_WALL, building
from apartgen.stages.walkable.site import fits, survey

FLOOR = Polygon([(0, 0), (4, 0), (4, 2), (2.5, 2), (2.5, 3), (0, 3)])


def mark(o: Any) -> Polygon:
    d, w = o.size[0] / 2, o.size[1] / 2
    return translate(rotate(shapely.box(-d, -w, d, w), o.yaw, (0, 0), use_radians=True), *o.center[:2])


@pytest.mark.parametrize("yaw", [0.0, 0.4, -2.0])
@pytest.mark.parametrize("beside", [(), (0.9,), (0.9, -0.9), (-0.9,)])
def test_along_walls_the_group_has_its_back_to_one_from_end_to_end(yaw: float, beside: tuple[float, ...]) -> None:
    """A bed 1.2 m wide with stands of 0.4 at some of its sides: as deep in the room as the deepest, flush with a wall
    but for 2 mm, and from the wall's one end to its other."""
    bed = h.thing("double_bed", 2.0, 1.5, yaw, size=(1.6, 1.2, 0.9), id="bed")
    c, s = np.cos(yaw), np.sin(yaw)
    stands = [h.thing("nightstand", 2.0 - 0.6 * c - y * s, 1.5 - 0.6 * s + y * c, yaw, size=(0.4, 0.4, 0.5))
              for y in beside]
    group = [bed, *stands]
    spots = places._along_walls(FLOOR, bed, group)
    wide = 1.2 + 0.5 * len(beside)
    corners = shapely.get_coordinates(FLOOR.exterior)
    sides = [(a, b) for a, b in zip(corners, corners[1:]) if np.hypot(*(b - a)) >= wide + 2 * places._APART]
    found: dict[int, list[tuple[float, float]]] = {}
    for x, y, turned in spots:
        points = shapely.get_coordinates([mark(places._along(o, bed, (x, y, turned))) for o in group])
        ahead = np.array([np.cos(turned), np.sin(turned)])
        for k, (a, b) in enumerate(sides):
            length = np.hypot(*(b - a))
            along = (b - a) / length
            inward = np.array([-along[1], along[0]])
            at, off = (points - a) @ along, ((points - a) @ inward).min()
            if inward @ ahead > 0.999 and abs(off) < 0.01 and -0.1 < at.min() and at.max() < length + 0.1:
                assert off == pytest.approx(places._APART, abs=1e-6)
                found.setdefault(k, []).append((at.min(), length - at.max()))
    assert sum(map(len, found.values())) == len(spots) and len(found) == len(sides)
    for row in found.values():
        assert min(row)[0] == pytest.approx(places._APART, abs=1e-6)
        assert min(end for _, end in row) == pytest.approx(places._APART, abs=1e-6)
        assert np.diff(sorted(start for start, _ in row)).max() < 2 * places.STEP


def test_one_of_several_solids_in_a_wall_is_in_it() -> None:
    """Slabs of the living room's floor, some of which reach into its south wall; what passes a door is in none."""
    whole = building(h.plan())

    def within(*lows: float, x: float = 2.0) -> bool:
        return whole.in_wall(convex.of([slab((x, low, 0.2), (x + 0.2, low + 0.5, 0.6)) for low in lows]))

    assert not within(0.1) and not within(0.1, 1.0) and not within(-0.9 * INTO_WALL)
    assert within(-0.01) and within(0.1, -0.01) and within(-0.01, 0.1)
    assert not within(1.2, x=3.95) and within(0.4, x=3.95)


SITE = survey(h.plan(), WalkableConfig(), fake.Boxes())


def may(name: str, before: tuple[float, ...], after: tuple[float, ...], size: tuple[float, float, float],
        bottom: float = 0.0, room: str = h.LIVING) -> bool:
    old, new = (h.thing(name, *at, room=room, size=size, bottom=bottom, id="it") for at in (before, after))
    return fits(SITE, (old,), {"it": new})


def test_what_moves_stays_off_doors_unless_one_walks_over_or_under_it() -> None:
    """Before the door in the living room's east wall, from 1.0 to 1.9 m; a ceiling lamp's place is no question."""
    away, before = (2.0, 1.45), (3.8, 1.45)
    assert not may("chest", away, before, (0.4, 0.6, 0.8)) and may("chest", away, (2.2, 1.45), (0.4, 0.6, 0.8))
    assert may("rug", away, before, (0.4, 0.6, 0.01)) and may("ceiling_lamp", away, before, (0.4, 0.4, 0.3), 2.2)
    assert may("chest", before, before, (0.4, 0.6, 0.8)), "what stands there already may"
    assert may("chest", before, (3.75, 1.45), (0.4, 0.6, 0.8)) and not may("chest", (3.6, 2.2), before, (0.4, 0.6, 0.8))


@pytest.mark.parametrize("high, allowed", [(0.8, True), (0.94, True), (0.96, False), (2.0, False)])
def test_what_is_higher_than_the_sill_stays_off_windows(high: float, allowed: bool) -> None:
    """The bedroom's window is .9 m above the floor, 1 m wide from x = 5; five centimetres more do no harm."""
    size = (0.4, 0.8, high)
    assert may("chest", (5.5, 2.0), (5.5, 0.2, np.pi / 2), size, room=h.BEDROOM) is allowed
    assert may("chest", (5.5, 2.0), (6.6, 0.2, np.pi / 2), size, room=h.BEDROOM)


def test_nothing_moves_out_of_its_room() -> None:
    size = (0.4, 0.8, 0.8)
    assert may("chest", (2.0, 2.0), (0.2, 2.5), size) and not may("chest", (2.0, 2.0), (0.15, 2.5), size)
    assert may("chest", (0.1, 2.5), (0.15, 2.5), size) and not may("chest", (0.15, 2.5), (0.1, 2.5), size)


def test_a_change_is_recorded_with_all_that_it_takes_along() -> None:
    table, lamp, plant = (h.thing(name, x, 1.0, id=name)
                          for name, x in (("side_table", 1), ("table_lamp", 1), ("plant", 2)))
    moved = {o.id: o.model_copy(update={"center": (o.center[0] + 0.5, *o.center[1:])}) for o in (table, lamp)}
    scene, step = applied((table, lamp, plant), nudged(table, moved, "way"))
    assert scene == (moved["side_table"], moved["table_lamp"], plant)
    assert (step.object, step.before.center, step.after and step.after.center) == (
        "side_table", table.center, moved["side_table"].center)
    assert [(shift.object, shift.before.center, shift.after and shift.after.center) for shift in step.along] == [
        ("table_lamp", lamp.center, moved["table_lamp"].center)]
    scene, step = applied(scene, dropped(scene[0], scene, "way"))
    assert scene[-1:] == (plant,) and step.after is None and all(shift.after is None for shift in step.along)
