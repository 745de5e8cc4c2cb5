"""Where things can be put: hand-made furniture with known places, then all furniture that things are put on."""

from dataclasses import replace

import handmade
import numpy as np
import pytest
from shapely import Polygon, affinity, box

from apartgen.schemas.retrieve import Joint
from apartgen.stages.populate import boards, rules
from apartgen.stages.retrieve import furniture
from apartgen.stages.things import categories
from apartgen.stages.things.asset import Asset, Link, Material, Mesh
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.receptacles import EDGE, OPEN, SEAM, receptacles
from apartgen.stages.things.solids import corners, slab

INSET = EDGE - SEAM


def asset(*links):
    return Asset("test", "made", "table", "plain", (0.6, 1.0, 0.8), list(links))


def base(*boards):
    return Link("base", [], [slab(lo, hi) for lo, hi in boards], 10.0)


def moving(name, kind, axis, range_, *boards):
    joint = Joint(name=name, type=kind, axis=axis, origin=(0.3, 0.5, 0.0), range=range_, part="")
    return Link(name, [], [slab(lo, hi) for lo, hi in boards], 1.0, joint)


SIDES = (((-0.3, -0.5, -0.4), (0.28, -0.48, 0.38)), ((-0.3, 0.48, -0.4), (0.28, 0.5, 0.38)))
BOTTOM, TOP = ((-0.3, -0.48, -0.4), (0.28, 0.48, -0.38)), ((-0.3, -0.5, 0.38), (0.3, 0.5, 0.4))


def test_a_table_has_a_top_and_nothing_else():
    legs = [((x, y, -0.4), (x + 0.04, y + 0.04, 0.38)) for x in (-0.3, 0.26) for y in (-0.5, 0.46)]
    (top,) = receptacles(asset(base(TOP, *legs)))
    assert (top.kind, top.part, top.room) == ("top", "", OPEN)
    assert top.z == pytest.approx(0.4)
    assert np.allclose([top.lo, top.hi], [(-0.3 + INSET, -0.5 + INSET), (0.3 - INSET, 0.5 - INSET)], atol=1e-4)


def test_what_stands_on_a_top_divides_it():
    lump = ((-0.3, -0.1, 0.4), (0.3, 0.1, 0.6))
    tops = [place for place in receptacles(asset(base(TOP, lump))) if place.z < 0.5]
    sides = sorted((place.lo[1], place.hi[1]) for place in tops)
    assert np.allclose(sides, [(-0.5 + INSET, -0.1 - EDGE), (0.1 + EDGE, 0.5 - INSET)], atol=1e-4)


def test_the_bottom_of_a_sink_is_no_top():
    walls = [((-0.3, -0.5, 0.4), (-0.28, 0.5, 0.55)), ((0.28, -0.5, 0.4), (0.3, 0.5, 0.55)),
             ((-0.28, -0.5, 0.4), (0.28, -0.48, 0.55)), ((-0.28, 0.48, 0.4), (0.28, 0.5, 0.55))]
    assert [place.kind for place in receptacles(asset(base(TOP, *walls)))] == ["basin"]
    assert [place.kind for place in receptacles(asset(base(TOP, *walls[:2])))] == ["top"]


def test_a_shelf_is_open_and_a_cupboard_is_behind_its_door():
    shelf = receptacles(asset(base(*SIDES, BOTTOM, TOP)))
    assert [(place.kind, round(place.room, 3)) for place in shelf] == [("shelf", 0.76), ("top", OPEN)]
    door = moving("door_0", "hinge", (0, 0, 1), (0.0, 1.5), ((0.28, -0.5, -0.4), (0.3, 0.5, 0.38)))
    inside = receptacles(asset(base(*SIDES, BOTTOM, TOP), door))[0]
    assert (inside.kind, inside.part, inside.open) == ("inside", "door_0", False)


def test_what_is_behind_a_pair_of_doors_is_one_place_for_each_of_them():
    doors = [moving(f"door_{k}", "hinge", (0, 0, 1), (0.0, 1.5), ((0.28, y, -0.4), (0.3, y + 0.498, 0.38)))
             for k, y in enumerate((0.001, -0.499))]
    places = [place for place in receptacles(asset(base(*SIDES, BOTTOM, TOP), *doors)) if place.kind == "inside"]
    assert {place.part: (place.lo[1] < 0, place.hi[1] > 0) for place in places} == {
        "door_0": (False, True), "door_1": (True, False)}
    drawn = moving("door_0", "hinge", (0, 0, 1), (0.0, 1.5), ((0.28, -0.5, -0.4), (0.3, 0.5, 0.38)))
    assert len([p for p in receptacles(asset(base(*SIDES, BOTTOM, TOP), drawn)) if p.kind == "inside"]) == 1


def test_a_drawer_holds_what_passes_under_all_that_it_slides_under():
    tray = [((-0.28, -0.4, 0.0), (0.28, 0.4, 0.01)), ((-0.28, -0.4, 0.01), (-0.27, 0.4, 0.1)),
            ((0.27, -0.4, 0.01), (0.28, 0.4, 0.1))]
    drawer = moving("drawer_0", "slide", (1, 0, 0), (0.0, 0.4), *tray)
    rail = ((0.29, -0.4, 0.25), (0.3, 0.4, 0.27))
    places = receptacles(asset(base(*SIDES, BOTTOM, TOP, rail), drawer))
    (held,) = [place for place in places if place.kind == "drawer"]
    assert held.part == "drawer_0" and held.room == pytest.approx(0.25 - 0.01)
    assert held.lo[0] >= -0.27 + EDGE - 1e-6 and held.hi[0] <= 0.27 - EDGE + 1e-6


def solids(made, skip=""):
    points = [corners(c) for link in made.links for c in link.colliders if link.name != skip]
    return np.array([[p.min(0), p.max(0)] for p in points]).reshape(-1, 2, 3)


@pytest.mark.parametrize("category", sorted(rules.bearers()))
def test_places_are_free_and_lie_on_something(category):
    for k, style in enumerate(furniture.styles(category)[:2]):
        made = furniture.build(category, style, TABLE[category].size, k)
        every = solids(made)
        for place in receptacles(made):
            lo, hi = np.array([*place.lo, place.z + 2e-3]), np.array([*place.hi, place.z + min(place.room, 0.4) - 2e-3])
            into = (every[:, 0] < hi - 1e-3).all(1) & (every[:, 1] > lo + 1e-3).all(1)
            assert not into.any(), (made.id, place)
            x, y = (np.linspace(a, b, 7) for a, b in zip(place.lo, place.hi))
            for point in np.stack(np.meshgrid(x, y), -1).reshape(-1, 2):
                near = (every[:, 0, :2] < point + 2 * SEAM).all(1) & (every[:, 1, :2] > point - 2 * SEAM).all(1)
                assert (np.abs(every[near, 1, 2] - place.z) < 4e-3).any(), (made.id, place, point)


@pytest.mark.parametrize("category", sorted(name for name in rules.bearers() if TABLE[name].opens == "drawer"))
def test_what_is_as_high_as_a_drawer_allows_goes_in_and_out(category):
    made = furniture.build(category, furniture.styles(category)[0], TABLE[category].size, 1)
    travel = {joint.name: joint.range[1] for joint in made.joints}
    drawers = [place for place in receptacles(made) if place.kind == "drawer"]
    assert drawers
    for place in drawers:
        rest = solids(made, place.part)
        for out in np.linspace(0, travel[place.part], 5):
            lo = np.array([place.lo[0] + out, place.lo[1], place.z + 2e-3])
            hi = np.array([place.hi[0] + out, place.hi[1], place.z + min(place.room, 1.0) - 1e-3])
            assert not ((rest[:, 0] < hi - 1e-3).all(1) & (rest[:, 1] > lo + 1e-3).all(1)).any(), (made.id, place, out)


@pytest.mark.parametrize(("many", "whole"), [(0, True), (1, False), (80, False), (81, True)])
def test_what_has_no_pieces_or_very_many_is_taken_for_solid(many, whole):
    """Small things keep off each piece; of more than eighty, or none, off the whole box."""
    grid = [((0.01 * k - 0.3, 0.2, 0.1), (0.01 * k - 0.295, 0.3, 0.15)) for k in range(many)]
    found = boards._pieces(lambda library, id: asset(base(*grid)), "made", f"{many} pieces")
    assert found.solid == pytest.approx(np.array([((-0.3, -0.5, -0.4), (0.3, 0.5, 0.4))] if whole else grid))
    assert found.swept.shape == found.sideways.shape == (0, 2, 3)


def test_curtains_are_as_large_as_they_look_and_what_slides_aside_is_told_apart():
    seen = Mesh(np.array([(0, -0.5, -1), (0.1, 0.2, 1), (0.05, 0, 0)], float), np.array([[0, 1, 2]]), Material("cloth"))
    link = Link("base", [seen], [slab((0, 0, 0), (1, 1, 1))], 1.0)
    cloth = Asset("test", "made", "curtain", "plain", (0.2, 1.2, 2.2), [link])
    found = boards._pieces(lambda library, id: cloth, "made", "cloth")
    assert found.solid == pytest.approx(np.array([((0, -0.5, -1), (0.1, 0.2, 1))]))
    extent = (0.25, -0.4, -0.3), (0.3, 0.4, 0.3)
    parts = [Link(name, [], [slab(*extent)], 1.0, Joint(name=name, type=kind, axis=axis, origin=(0.3, 0.5, 0.0),
                                                        range=(0.0, 0.5), part="", extent=extent))
             for name, kind, axis in (("left", "slide", (0, 1, 0)), ("out", "slide", (1, 0, 0)),
                                      ("turns", "hinge", (0, 0, 1)))]
    found = boards._pieces(lambda library, id: asset(base(BOTTOM), *parts), "made", "robe")
    assert len(found.swept) == 3 and len(found.sideways) == 1
    assert found.sideways[0] == pytest.approx(np.array([(0.25, -0.4, -0.3), (0.3, 0.9, 0.3)]))


@pytest.mark.parametrize("yaw", [0.0, np.pi / 2, 2.0])
def test_floor_beside_furniture_lies_at_its_sides_along_its_back(yaw: float) -> None:
    """A sofa of .9 by 2 m in the middle of a room: .03 m beside it, from 1 cm before its back."""
    o = handmade.thing("sofa", 3.0, 2.0, yaw, size=(0.9, 2.0, 0.8), id="sofa")
    here = boards._here([o], lambda library, id: asset(base(TOP)))
    deep, wide = boards.BESIDE
    for side, (low, high) in ((1, (1.03, 1.03 + wide)), (-1, (-1.03 - wide, -1.03))):
        board = boards._beside(0, side, box(0, 0, 6, 4), Polygon(), here)
        assert np.allclose([board.place.lo, board.place.hi], [(-0.44, low), (-0.44 + deep, high)])
        turned = affinity.rotate(Polygon(board.place.polygon()), yaw, (0, 0), use_radians=True)
        turned = affinity.translate(turned, 3.0, 2.0)
        assert boards._beside(0, side, turned.buffer(0.01), Polygon(), here) is not None, "inside its room"
        assert boards._beside(0, side, turned.buffer(-0.01), Polygon(), here) is None, "outside"
        assert boards._beside(0, side, box(0, 0, 6, 4), turned.centroid.buffer(0.05), here) is None, "where one passes"


def test_what_is_like_a_piece_of_furniture_is_one_that_things_are_put_in(monkeypatch: pytest.MonkeyPatch) -> None:
    board = categories.TABLE["sideboard"]
    bar = replace(board, name="home_bar", like="sideboard", lineage=("home_bar", "sideboard"))
    monkeypatch.setattr(categories, "TABLE", {**categories.TABLE, "home_bar": bar})
    for at in ("sideboard top", "case inside"):
        assert rules.spots.__wrapped__(at).categories >= {"home_bar", "sideboard"}
    assert "home_bar" not in rules.spots.__wrapped__("nightstand top").categories
