"""What hangs: curtains clear of what stands before their windows, lamps on balconies on the house's wall."""

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.plan import Opening, Plan, Room
from apartgen.schemas.retrieve import AssetKey
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching import cloth, outdoors
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.embedded import Embedded

MADE = Embedded(RetrieveConfig())
UP = np.pi / 2


def piece(category, x, y, size, yaw=UP, bottom=0.0, style=None):
    """A real piece of the bedroom, whose window (5 to 6 m, sill .9, head 2.1) is in the wall at y = 0."""
    asset = furniture.build(category, style or furniture.styles(category)[0], size)
    o = h.thing(category, x, y, yaw, h.BEDROOM, size=asset.size, bottom=bottom)
    asset_of = AssetKey(library="parametric", id=asset.id)
    return o.model_copy(update={"asset": asset_of, "on": "wall" if bottom else "floor"})


def curtain(width=1.4, bottom=0.05, x=5.5, style="rod"):
    return piece("curtain", x, 0.05, (0.1, width, 2.37 - bottom), bottom=bottom, style=style)


def cleared(*objects, plan=None):
    assets = {o.id: furniture.load_asset(o.asset.id) for o in objects}
    return cloth.clear(objects, plan or h.plan(), assets, MADE)


def hem(o):
    return o.center[2] - o.size[2] / 2


def met(one, o):
    """How deep the cloth's folds are in the boxes that another piece is solid with, m; both stand square."""
    at = np.concatenate([mesh.vertices for mesh in furniture.load_asset(one.asset.id).links[0].visuals
                         if np.ptp(mesh.vertices[:, 2]) > one.size[2] / 2])
    turn = one.yaw - o.yaw
    c, s = np.cos(turn), np.sin(turn)
    local = at @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T
    ax, ay, az = np.subtract(one.center, o.center)
    local = local + [np.cos(o.yaw) * ax + np.sin(o.yaw) * ay, np.cos(o.yaw) * ay - np.sin(o.yaw) * ax, az]
    columns = np.concatenate([local + [0, 0, dz] for dz in np.linspace(0, -one.size[2] * 0.98, 60)])
    columns = columns[columns[:, 2] > local[:, 2].min() - 1e-9]
    return max(float((k.size / 2 - np.abs(columns - k.center)).min(1).max())
               for link in furniture.load_asset(o.asset.id).links for k in link.colliders if k.kind == "box")


@pytest.mark.parametrize("style", furniture.styles("curtain"))
def test_a_curtain_over_a_low_cabinet_ends_below_the_sill(style):
    chest, own = piece("chest", 4.9, 0.26, (0.5, 1.0, 0.7)), curtain(style=style)
    assert met(own, chest) > 0.02
    anew = cleared(chest, own)[1]
    assert hem(anew) == pytest.approx(0.8, abs=2e-3) and met(anew, chest) < cloth.MET
    assert anew.center[2] + anew.size[2] / 2 == pytest.approx(2.37, abs=2e-3), "its rail is where it was"
    assert anew.asset.id.split("/")[1] == style and furniture.load_asset(anew.asset.id).size == anew.size


def test_it_ends_above_what_is_higher_than_the_sill():
    chest = piece("chest", 5.5, 0.26, (0.5, 1.3, 1.1))
    anew = cleared(chest, curtain())[1]
    assert 1.0 < hem(anew) < 1.15 and met(anew, chest) < cloth.MET


def test_it_is_narrower_beside_what_is_tall():
    wardrobe = piece("wardrobe", 6.6, 0.31, (0.6, 1.0, 2.1))
    anew = cleared(wardrobe, curtain(1.5))[1]
    assert hem(anew) == pytest.approx(0.05, abs=2e-3) and met(anew, wardrobe) < cloth.MET
    assert anew.center[0] + anew.size[1] / 2 == pytest.approx(6.1, abs=0.025)
    assert anew.center[0] - anew.size[1] / 2 == pytest.approx(4.75, abs=2e-3), "the other end stays"


def test_what_meets_nothing_stays_and_so_does_what_can_not_be_helped():
    away, wardrobe = piece("chest", 6.5, 2.5, (0.5, 1.0, 0.7)), piece("wardrobe", 5.5, 0.31, (0.6, 1.6, 2.1))
    for other in (away, wardrobe):
        assert cleared(other, curtain()) == [other, curtain()]


def test_curtains_of_one_length_stay_of_one_length():
    window = h.openings()[2]
    two = [window.model_copy(update={"id": f"window_{k}", "segment": ((x, -0.15), (x + 1, -0.15))})
           for k, x in enumerate((4.3, 5.8))]
    plan = h.plan().model_copy(update={"openings": [*h.openings()[:2], *two]})
    chest, pair = piece("chest", 4.6, 0.26, (0.5, 1.0, 0.7)), [curtain(1.2, x=x) for x in (4.8, 6.3)]
    assert [round(hem(o), 2) for o in cleared(chest, *pair, plan=plan)[1:]] == [0.8, 0.8]


def test_no_curtain_leaves_the_lower_end_of_its_window_bare():
    assert hem(cleared(curtain(bottom=1.1))[0]) == pytest.approx(0.8, abs=2e-3)
    at_sill = curtain(bottom=0.9)
    assert cleared(at_sill) == [at_sill]


def balcony(*openings) -> Plan:
    """The flat of two rooms with a balcony of 3 x 1.2 m before the bedroom, its door at 4.5 to 5.4 m."""
    rooms = [*h.plan().rooms, Room(id="balcony_1", type="balcony", polygon=h.rectangle(4.1, 3.3, 3, 1.2))]
    door = Opening.model_validate({"id": "door_2", "kind": "door", "rooms": ["balcony_1", h.BEDROOM], "into": h.BEDROOM,
                                   "segment": [[4.5, 3.15], [5.4, 3.15]], "sill": 0, "head": 2.1})
    return h.plan().model_copy(update={"rooms": rooms, "openings": [*h.openings(), door, *openings]})


def lamp(x, y, yaw):
    o = h.thing("wall_lamp", x, y, yaw, "balcony_1", size=(0.12, 0.12, 0.24), bottom=1.65, id="lamp")
    return o.model_copy(update={"on": "wall"})


@pytest.mark.parametrize("at", [(5.6, 4.44, -UP), (7.04, 3.9, np.pi), (4.16, 3.9, 0.0)])
def test_a_lamp_over_the_railing_comes_to_the_wall_beside_the_door(at):
    (anew,) = outdoors.hung([lamp(*at)], balcony())
    assert anew.center[1] == pytest.approx(3.36) and anew.yaw == pytest.approx(UP) and anew.center[2] == 1.77
    off = [abs(anew.center[0] - x) for x in (4.5 - outdoors.BESIDE, 5.4 + outdoors.BESIDE)]
    assert min(off) < 0.03


def test_not_before_a_window():
    window = h.openings()[2].model_copy(update={"id": "window_2", "segment": ((5.5, 3.15), (6.5, 3.15))})
    (anew,) = outdoors.hung([lamp(5.6, 4.44, -UP)], balcony(window))
    x = anew.center[0]
    assert anew.center[1] == pytest.approx(3.36) and (x + 0.06 < 4.5 or x - 0.06 > 6.5)


def test_what_hangs_on_the_house_stays_and_so_does_what_finds_no_place():
    there, full = lamp(6.5, 3.36, UP), h.thing("wardrobe", 5.6, 3.6, UP, "balcony_1", size=(0.6, 3.0, 2.1))
    assert outdoors.hung([there], balcony()) == [there]
    assert outdoors.hung([full, lamp(5.6, 4.44, -UP)], balcony()) == [full, lamp(5.6, 4.44, -UP)]


@pytest.mark.parametrize(("kind", "room"), [("window", h.LIVING), ("door", h.BEDROOM)])
def test_a_curtain_hangs_before_a_window_of_its_room(kind, room):
    chest, own, plan = piece("chest", 4.9, 0.26, (0.5, 1.0, 0.7)), curtain(), h.plan()
    # right where it hangs, and lower than its own window
    other = Opening(id="other", kind=kind, rooms=[room], segment=((5.2, 0.04), (5.8, 0.04)), sill=0.2, head=2.0)
    beside = plan.model_copy(update={"openings": [*plan.openings, other]})
    assert cleared(chest, own, plan=beside) == cleared(chest, own)


@pytest.mark.parametrize(("x", "left", "right"), [(5.5, -0.5, 0.5), (5.2, -0.8, 0.2), (5.9, -0.1, 0.9)])
def test_a_window_is_seen_from_its_curtain(x, left, right):
    """It looks into the room, to +y, and its own left is at smaller x; the window is from x 5 to 6, its sill at .9."""
    found = cloth._window(curtain(x=x), h.plan())
    assert found[1:] == pytest.approx((left, right))
    assert found.sill == pytest.approx(0.9 - curtain(x=x).center[2])
